// SPDX-License-Identifier: Apache-2.0
//
// The parameter table of a plugin, as a plain model: read by the checker, the schema, the form and the
// fuzzer. Threads: [main]. Values checked here reach the plugin unchanged; it never parses.
#pragma once

#include <swage/abi/params.h>

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/problem.hpp"

namespace swage::host {

/// One parameter; an owned copy of swage_param, so that it outlives the library and can come from a sidecar.
struct Param {
  int32_t type = SWAGE_PARAM_REAL;
  uint32_t flags = 0;
  uint32_t dimension = 1;
  std::string id, label, group, unit, display_unit, doc;
  std::vector<std::string> choices, aliases;
  std::string default_text;
  double min = 0, max = 0;  // SI, inclusive
  std::array<double, 4> default_number{};

  bool live() const { return (flags & SWAGE_PARAM_LIVE) != 0; }
  bool required() const { return (flags & SWAGE_PARAM_REQUIRED) != 0; }
  bool hidden() const { return (flags & SWAGE_PARAM_HIDDEN) != 0; }
};

using ParamTable = std::vector<Param>;

/// A file that a lesson names in a parameter of type FILE.
struct GivenFile {
  std::string written;  // as in the lesson
  std::string path;     // the resolved path
};

/// Checked values, value i for parameter i. Texts are stored beside the values that point to them.
struct ParamValues {
  std::vector<swage_value> value;
  std::vector<std::string> text;
  std::vector<GivenFile> files;  // without default files, which belong to the plugin

  /// Makes value[i].text point to text[i]; after every copy or move.
  void point_to_texts();
};

/// Source of values, for messages and relative paths.
struct ParamSource {
  std::string plugin_id;
  std::string folder;         // relative FILE values are resolved against it
  std::string bundle_folder;  // relative FILE defaults are resolved against it
  /// Problem::where for the value at "/id" below the params object; "" is the object itself.
  std::function<std::string(const std::string& pointer)> where;
  /// Files to use instead of those that the lesson names, path by name; nullptr for none.
  const std::map<std::string, std::string>* files = nullptr;
};

ParamTable copy_table(const swage_param* table, uint32_t count);

/// Faults of a table itself (ids, units, ranges, choices, docs), one sentence each.
std::vector<std::string> table_faults(const ParamTable& table);

ParamValues default_values(const ParamTable& table, const std::string& bundle_folder = "");

/// Checks the text of a JSON object against the table and fills every value. Reports all problems at once:
/// unknown key (nearest name, list), type, unit, range, choice, missing file, REQUIRED and absent; former ids
/// warn with the line to paste. False when one of them is an error. "" is the empty object.
bool check_params(std::string_view json_object, const ParamTable& table, const ParamSource& source,
                  ParamValues& out, base::Problems& problems);

/// The value as a lesson file would have it, in the display unit: "2.6 mm", "3/8", true, ["0.5", "0.75"] ...
/// [JSON text]
std::string value_text(const Param& param, const swage_value& value);

}  // namespace swage::host
