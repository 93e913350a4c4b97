// SPDX-License-Identifier: Apache-2.0
//
// The contract of swage.visual/1 (abi/visual.h), asked of an object by the test `drawing` and of a coupling by that with wild values.
#pragma once

#include <functional>
#include <string>

#include "host/instance.hpp"
#include "scene/world.hpp"
#include <swage/abi/visual.h>

namespace swage::tools {

/// draw() of a plugin with its own view of the scene; false where the guard stopped it.
using Draw = std::function<bool(uint32_t capacity, swage_visual* out, uint32_t* n)>;

/// What is wrong with what it draws, asked with no room, with little and with enough: "" where nothing is. `bodies`: of the object on
/// which it draws; `world`: whose numbers must stay as they are. `note`: where it is not wrong, what of it will not be seen, or "";
/// `pierceable`: whether the object has that trait, without which dents, tears and wounds are not seen.
std::string visuals(const Draw& draw, uint32_t bodies, const scene::World& world, std::string* note = nullptr, bool pierceable = true);

}  // namespace swage::tools
