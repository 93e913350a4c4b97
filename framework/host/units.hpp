// SPDX-License-Identifier: Apache-2.0
//
// Text with a unit to SI. The table is fixed and small: at this scale a bare 0.0001 is how thousand-fold
// mistakes happen. Threads: [any], no state.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace swage::host {

/// A unit of the table. Two units measure the same thing when their dimensions are equal.
struct Unit {
  const char* symbol;
  double scale;           // SI value = scale * number
  const char* si;         // symbol of the SI unit of its dimension; equal for all units of one dimension
  const char* dimension;  // "a length"
};

/// nullptr when the table has no such symbol.
const Unit* find_unit(std::string_view symbol);

/// All symbols, comma-separated, in the order of the table.
std::string unit_list();

/// Symbols of one dimension: "m, mm, um". `si` is the SI symbol.
std::string units_like(std::string_view si);

/// What a quantity of this SI symbol of the table is: "a length (m, mm, um)".
std::string measure_of(std::string_view si);

/// Reads "2.6 mm" as `si` (an SI symbol of the table). `label` is what the sentence in `error` calls the
/// value. False: `error` has one sentence such as  "0.1 N" is a force; "Wire diameter" is a length (m, mm,
/// um).
bool parse_quantity(std::string_view text, std::string_view si, std::string_view label, double& value,
                    std::string& error);

/// An SI value in a unit of the table, at most 9 significant digits: "2.6 mm"; pure numbers stand alone.
std::string format_quantity(double value, std::string_view unit);

/// A number as short as possible, at most 9 significant digits, without locale.
std::string format_number(double value);

}  // namespace swage::host
