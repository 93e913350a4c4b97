// SPDX-License-Identifier: Apache-2.0
//
// Conversion of text with a unit to SI. The table is fixed and small: at this scale a bare 0.0001 easily is a
// mistake by a factor of a thousand. Threads: [any], no state.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace swage::host {

/// A unit of the table. Two units measure the same quantity when their dimensions are equal.
struct Unit {
  const char* symbol;
  double scale;           // SI value = scale * number
  const char* si;         // symbol of the SI unit of its dimension; equal for all units of one dimension
  const char* dimension;  // "a length"
};

/// The unit with this symbol, or nullptr.
const Unit* find_unit(std::string_view symbol);

/// All symbols, comma-separated, in the order of the table.
std::string unit_list();

/// Symbols of one dimension: "m, mm, um". `si` is the SI symbol.
std::string units_like(std::string_view si);

/// Description of the quantity of an SI symbol of the table: "a length (m, mm, um)".
std::string measure_of(std::string_view si);

/// Reads "2.6 mm" as `si` (an SI symbol of the table). `label` names the value in `error`.
/// False: `error` has one sentence such as  "0.1 N" is a force; "Wire diameter" is a length (m, mm,
/// um).
bool parse_quantity(std::string_view text, std::string_view si, std::string_view label, double& value,
                    std::string& error);

/// An SI value in a unit of the table, at most 9 significant digits: "2.6 mm"; pure numbers have no unit.
std::string format_quantity(double value, std::string_view unit);

/// A number in its shortest form, at most 9 significant digits, independent of the locale.
std::string format_number(double value);

}  // namespace swage::host
