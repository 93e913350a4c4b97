// SPDX-License-Identifier: Apache-2.0
//
// Reads numbers with units from the file of a hand or a plan; messages name file and key. [main]
#pragma once

#include <swage/units.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "hand/sentences.hpp"
#include "toolkit/math.hpp"
#include "toolkit/read_file.hpp"

namespace swage::hand {

using Json = nlohmann::json;
using toolkit::Vec3;

// quantity of a number in the file
enum class Measure { kNumber, kLength, kTime, kAngle, kForce };

struct Unit {
  const char* name;
  Measure measure;
  double si;
};
inline constexpr Unit kUnits[] = {
    {"m", Measure::kLength, 1},        {"mm", Measure::kLength, 1e-3}, {"um", Measure::kLength, 1e-6},
    {"s", Measure::kTime, 1},          {"ms", Measure::kTime, 1e-3},   {"rad", Measure::kAngle, 1},
    {"deg", Measure::kAngle, kDegree}, {"N", Measure::kForce, 1},      {"mN", Measure::kForce, 1e-3}};

/// The file that is read, for messages.
class Reader {
 public:
  explicit Reader(std::string name) : name_(std::move(name)) {}

  [[noreturn]] void fail(const std::string& where, const std::string& what) const {
    throw std::runtime_error(name_ + " #" + where + ": " + what);
  }

  double number(const Json& value, Measure measure, const std::string& where) const {
    if (value.is_number()) return finite(value.get<double>(), where);
    if (!value.is_string()) fail(where, say::kNumberNeeded());
    const std::string text = value.get<std::string>();
    // from_chars reads a decimal point in every locale
    double amount = 0;
    const auto [rest, status] = std::from_chars(text.data(), text.data() + text.size(), amount);
    std::string_view unit(rest, static_cast<std::size_t>(text.data() + text.size() - rest));
    while (unit.starts_with(' ')) unit.remove_prefix(1);
    for (const Unit& u : kUnits) {
      if (status == std::errc{} && unit == u.name && u.measure == measure)
        return finite(amount * u.si, where);
    }
    fail(where, say::kOtherMeasure(text.substr(0, 60), expected(measure)));
  }

  /// The text at a key, "" where it is absent.
  std::string text(const Json& object, const char* key) const {
    if (!object.contains(key)) return "";
    if (!object[key].is_string()) fail(std::string("/") + key, say::kTextNeeded());
    return object[key].get<std::string>();
  }

  Vec3 vec3(const Json& value, Measure measure, const std::string& where) const {
    if (!value.is_array() || value.size() != 3) fail(where, say::kThreeNeeded());
    Vec3 out;
    for (int i = 0; i < 3; ++i) {
      out[i] = number(value[static_cast<size_t>(i)], measure, where + "/" + std::to_string(i));
    }
    return out;
  }

 private:
  double finite(double value, const std::string& where) const {
    if (!std::isfinite(value)) fail(where, say::kNotFinite());
    return value;
  }
  static std::string expected(Measure measure) {
    switch (measure) {
      case Measure::kLength:
        return say::kLength();
      case Measure::kTime:
        return say::kTime();
      case Measure::kAngle:
        return say::kAngle();
      case Measure::kForce:
        return say::kForce();
      case Measure::kNumber:
        break;
    }
    return say::kPure();
  }
  std::string name_;
};

/// The text of a file. Throws.
inline std::string text_of(const std::string& path) {
  std::string text, why;
  if (!toolkit::read_file(path, toolkit::kMostFileBytes, text, why)) throw std::runtime_error(path + ": " + why);
  return text;
}

/// Reads a JSON object of this format with no keys but `known`; `has` is the message for any other key.
inline Json object_of(const Reader& reader, const std::string& text, const std::string& format,
                      std::initializer_list<const char*> known, const std::string& has) {
  Json file;
  try {
    file = Json::parse(text);
  } catch (const Json::parse_error& problem) {
    reader.fail("", say::kNoJson(problem.what()));
  }
  if (!file.is_object() || !file.contains("format") || file["format"] != format)
    reader.fail("/format", say::kFormat(format));
  for (const auto& item : file.items())
    if (std::find(known.begin(), known.end(), item.key()) == known.end())
      reader.fail("/" + item.key(), say::kUnknownKey(has));
  return file;
}

}  // namespace swage::hand
