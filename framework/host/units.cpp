// SPDX-License-Identifier: Apache-2.0
#include "host/sentences.hpp"
#include "host/units.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <numbers>

#include "base/text.hpp"

namespace swage::host {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

// the first unit of a dimension is its SI unit
constexpr std::array kUnits = {
    Unit{"m", 1, "m", "a length"},
    Unit{"mm", 1e-3, "m", "a length"},
    Unit{"um", 1e-6, "m", "a length"},
    Unit{"m2", 1, "m2", "an area"},
    Unit{"mm2", 1e-6, "m2", "an area"},
    Unit{"s", 1, "s", "a time"},
    Unit{"ms", 1e-3, "s", "a time"},
    Unit{"N", 1, "N", "a force"},
    Unit{"mN", 1e-3, "N", "a force"},
    Unit{"rad", 1, "rad", "an angle"},
    Unit{"deg", kDegree, "rad", "an angle"},
    Unit{"kg", 1, "kg", "a mass"},
    Unit{"g", 1e-3, "kg", "a mass"},
    Unit{"mg", 1e-6, "kg", "a mass"},
    Unit{"Pa", 1, "Pa", "a pressure"},
    Unit{"kPa", 1e3, "Pa", "a pressure"},
    Unit{"MPa", 1e6, "Pa", "a pressure"},
    Unit{"GPa", 1e9, "Pa", "a pressure"},
    Unit{"Pa*s", 1, "Pa*s", "a viscosity"},
    Unit{"mPa*s", 1e-3, "Pa*s", "a viscosity"},
    Unit{"C/m", 1, "C/m", "a charge per length"},
    Unit{"nC/m", 1e-9, "C/m", "a charge per length"},
    Unit{"Hz", 1, "Hz", "a frequency"},
    Unit{"m/s", 1, "m/s", "a speed"},
    Unit{"mm/s", 1e-3, "m/s", "a speed"},
    Unit{"rad/s", 1, "rad/s", "an angular speed"},
    Unit{"deg/s", kDegree, "rad/s", "an angular speed"},
    Unit{"m/s2", 1, "m/s2", "an acceleration"},
    Unit{"N/m", 1, "N/m", "a stiffness"},
    Unit{"mN/m", 1e-3, "N/m", "a stiffness"},
    Unit{"N*s", 1, "N*s", "an impulse"},
    Unit{"mN*s", 1e-3, "N*s", "an impulse"},
    Unit{"N*s/m", 1, "N*s/m", "a damping"},
    Unit{"uN*s/m", 1e-6, "N*s/m", "a damping"},
    Unit{"N*m", 1, "N*m", "a torque"},
    Unit{"mN*mm", 1e-6, "N*m", "a torque"},
    Unit{"N*m/rad", 1, "N*m/rad", "a rotational stiffness"},
    Unit{"N*m*s/rad", 1, "N*m*s/rad", "a rotational damping"},
    Unit{"nN*m*s/rad", 1e-9, "N*m*s/rad", "a rotational damping"},
    Unit{"N*m2", 1, "N*m2", "a bending stiffness"},
    Unit{"kg*m2", 1, "kg*m2", "a moment of inertia"},
    Unit{"kg/m3", 1, "kg/m3", "a density"},
    Unit{"1/m", 1, "1/m", "a curvature"},
    Unit{"1", 1, "1", "a pure number"},
    Unit{"%", 1e-2, "1", "a pure number"},
};

std::string brief(std::string_view text) { return base::shortened(text, 60); }

std::string expected(const Unit& unit) { return measure_of(unit.si); }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

const Unit* find_unit(std::string_view symbol) {
  for (const Unit& unit : kUnits)
    if (symbol == unit.symbol) return &unit;
  return nullptr;
}

std::string measure_of(std::string_view si) { return std::string(find_unit(si)->dimension) + " (" + units_like(si) + ")"; }

std::string unit_list() {
  std::string list;
  for (const Unit& unit : kUnits) list += (list.empty() ? "" : ", ") + std::string(unit.symbol);
  return list;
}

std::string units_like(std::string_view si) {
  std::string list;
  for (const Unit& unit : kUnits)
    if (si == unit.si) list += (list.empty() ? "" : ", ") + std::string(unit.symbol);
  return list;
}

bool parse_quantity(std::string_view text, std::string_view si, std::string_view label, double& value,
                    std::string& error) {
  const Unit* wanted = find_unit(si);
  if (wanted == nullptr) {
    error = say::kNotAUnit(brief(si), unit_list());
    return false;
  }
  const std::string_view body = trimmed(text);
  const char* end = body.data() + body.size();
  double number = 0;
  // from_chars does not accept a plus sign, people write one
  const char* begin = body.data() + (body.size() > 1 && body[0] == '+' && body[1] != '-' ? 1 : 0);
  const auto [rest, status] = std::from_chars(begin, end, number);
  if (status != std::errc{} || !std::isfinite(number)) {
    error = say::kNotANumber(brief(text), brief(label), expected(*wanted));
    return false;
  }
  const std::string_view symbol = trimmed({rest, static_cast<std::size_t>(end - rest)});
  if (symbol.empty() && std::strcmp(wanted->si, "1") != 0) {
    error = say::kHasNoUnit(brief(text), brief(label), expected(*wanted));
    return false;
  }
  const Unit* unit = symbol.empty() ? wanted : find_unit(symbol);
  if (unit == nullptr) {
    error = say::kUnknownUnit(brief(text), brief(symbol), brief(label), expected(*wanted));
    return false;
  }
  if (std::strcmp(unit->si, wanted->si) != 0) {
    error = say::kOtherDimension(brief(text), unit->dimension, brief(label), expected(*wanted));
    return false;
  }
  const double si_value = number * unit->scale;
  if (!std::isfinite(si_value)) {
    error = say::kTooLargeNumber(brief(text));
    return false;
  }
  value = si_value;
  return true;
}

std::string format_number(double value) {
  std::array<char, 64> buffer{};
  // 9 digits hide the rounding of unit conversion (2.6 mm, not 2.6000000000000001 mm)
  const auto [end, status] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 9);
  return status == std::errc{} ? std::string(buffer.data(), end) : std::string("?");
}

std::string format_quantity(double si_value, std::string_view unit) {
  const Unit* found = find_unit(unit);
  if (found == nullptr) return format_number(si_value) + " " + std::string(unit);
  const std::string number = format_number(si_value / found->scale);
  return std::strcmp(found->symbol, "1") == 0 ? number : number + " " + found->symbol;
}

}  // namespace swage::host
