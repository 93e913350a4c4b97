// SPDX-License-Identifier: Apache-2.0
//
// Parts of a lesson, its objects, couplings and devices, that a variant adds and leaves out. [main]
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "assembly/places.hpp"
#include "base/problem.hpp"

namespace swage::assembly {

/// The lists of a lesson that hold parts, in the order of evaluation.
inline constexpr const char* kPartLists[] = {"objects", "couplings", "devices"};

/// What a variant says: `says` is the value of its key "remove" or "add", `places` and `pointer` where that is written.
struct PartsSaid {
  const nlohmann::ordered_json& says;
  const Places& places;
  std::string pointer;
};

/// Takes the parts of these names, ["floor", "tray"], out of `lesson`, and moves the places of those behind them. Couplings
/// without a name have that of coupling_names(). False and problems where the value is no list of names, or no part has a name;
/// the other parts of the list are removed all the same.
bool remove_parts(const PartsSaid& remove, nlohmann::ordered_json& lesson, Places& lesson_places, base::Problems& problems);

/// Puts parts, { "objects": [...], "couplings": [...], "devices": [...] }, behind those of `lesson`. Their form is not checked
/// here: the lesson is checked later as a whole, and each problem then has the place where the value is written.
bool add_parts(const PartsSaid& add, nlohmann::ordered_json& lesson, Places& lesson_places, base::Problems& problems);

}  // namespace swage::assembly
