// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/environment_params.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "host/environment.hpp"
#include "host/units.hpp"

namespace swage::console {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kEnvironment = "environment";  // instance name in settings
constexpr const char* kMedium = "medium";
constexpr const char* kPlane = "earthed_plane";

// Upper limits of the form for a lesson of this size; a file may exceed them. SI units of the key.
double most_offered(const host::EnvironmentKey& k) {
  const std::string key = k.key;
  if (key == kPlane) return 0.1;
  if (key == "linear_damping") return 1e-3;
  if (key == "angular_damping") return 1e-6;
  return k.max;
}

LiveParam medium_row(const std::string& word) {
  LiveParam out{kEnvironment, {}, {}};
  out.param.type = SWAGE_PARAM_CHOICE;
  out.param.id = kMedium;
  out.param.label = host::kMediumLabel;
  out.param.doc = host::kMediumDoc;
  const auto found = std::find(std::begin(host::kMedia), std::end(host::kMedia), word);
  // a set medium cannot be unset in a derived lesson
  if (found == std::end(host::kMedia)) out.param.choices.push_back("not set");
  out.param.choices.insert(out.param.choices.end(), std::begin(host::kMedia), std::end(host::kMedia));
  out.start[0] = found == std::end(host::kMedia) ? 0 : static_cast<double>(found - std::begin(host::kMedia));
  return out;
}

// SI; NaN where the section has no value
double said_value(const Json& section, const host::EnvironmentKey& k) {
  const auto it = section.find(k.key);
  double value = std::nan("");
  std::string ignored;  // these problems are reported when the lesson is opened
  if (it == section.end()) return value;
  if (it->is_number()) return it->get<double>();
  if (it->is_string()) host::parse_quantity(it->get<std::string>(), k.unit, k.key, value, ignored);
  return value;
}

LiveParam quantity_row(const host::EnvironmentKey& k, const Json& section, std::size_t choices) {
  LiveParam out{kEnvironment, {}, {}};
  host::Param& p = out.param;
  p.type = SWAGE_PARAM_REAL;
  p.id = k.key, p.label = k.label, p.doc = k.doc, p.unit = k.unit, p.display_unit = k.display_unit;
  const double said = said_value(section, k), most = most_offered(k);
  p.min = std::max(k.min, -most);
  p.max = most;
  if (std::isfinite(said)) {
    p.min = std::min(p.min, said);
    p.max = std::max(p.max, said);
    out.start[0] = said;
    return out;
  }
  const bool plane = p.id == kPlane;
  if (plane) out.least_words = "none";
  out.follows = kMedium;
  const std::size_t media = std::size(host::kMedia);
  for (std::size_t i = 0; i < choices; ++i) {
    const std::size_t unset = choices - media, at = i - unset;
    const bool means = i >= unset && (k.media >> at & 1) != 0;
    const double own = host::medium(static_cast<uint32_t>(SWAGE_MEDIUM_DRY + at)).*k.member;
    out.start_of.push_back(!means ? std::nan("") : plane ? p.min : own);
  }
  const auto first = std::find_if(out.start_of.begin(), out.start_of.end(), [](double v) { return std::isfinite(v); });
  out.start[0] = *first;  // every key has a value in at least one medium
  return out;
}

}  // namespace

QVector<LiveParam> environment_params(const std::string& section) {
  Json json = Json::parse(section, nullptr, false);
  if (!json.is_object()) json = Json::object();
  const auto word = json.find(kMedium);
  QVector<LiveParam> out{medium_row(word != json.end() && word->is_string() ? word->get<std::string>() : "")};
  for (const host::EnvironmentKey& k : host::kEnvironmentKeys) out += quantity_row(k, json, out[0].param.choices.size());
  return out;
}

}  // namespace swage::console
