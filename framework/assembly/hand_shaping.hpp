// SPDX-License-Identifier: Apache-2.0
//
// Reads "filters", "reaction" and "coupling" of a device in a lesson file. [main]
#pragma once

#include "assembly/lesson_file.hpp"
#include "assembly/reader.hpp"
#include "host/hand_shaping.hpp"

namespace swage::assembly {

void read_filters(const Json& json, const std::string& pointer, const Teller& teller, LessonDevice& device);
void read_reaction(const Json& json, const std::string& pointer, const Teller& teller, host::Reaction& out);
void read_hand_coupling(const Json& json, const std::string& pointer, const Teller& teller, host::HandCoupling& out);

}  // namespace swage::assembly
