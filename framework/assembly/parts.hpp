// SPDX-License-Identifier: Apache-2.0
//
// Parts of a lesson (objects, couplings and devices) that a variant adds and removes. [main]
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "assembly/places.hpp"
#include "base/problem.hpp"

namespace swage::assembly {

/// The lists of a lesson with parts, in the order of evaluation.
inline constexpr const char* kPartLists[] = {"objects", "couplings", "devices"};

/// Changes by a variant: `says` is the value of its key "remove" or "add", `places` and `pointer` its place.
struct PartsSaid {
  const nlohmann::ordered_json& says;
  const Places& places;
  std::string pointer;
};

/// Removes the parts of these names, ["floor", "tray"], from `lesson`, and updates the places of those after them. Couplings
/// without a name have that of coupling_names(). False and problems where the value is not a list of names, or no part has a name;
/// the other parts of the list are removed nevertheless.
bool remove_parts(const PartsSaid& remove, nlohmann::ordered_json& lesson, Places& lesson_places, base::Problems& problems);

/// Appends parts, { "objects": [...], "couplings": [...], "devices": [...] }, to those of `lesson`. Their form is not checked
/// here: the lesson is checked later as a whole, and each problem then has the place of the value.
bool add_parts(const PartsSaid& add, nlohmann::ordered_json& lesson, Places& lesson_places, base::Problems& problems);

}  // namespace swage::assembly
