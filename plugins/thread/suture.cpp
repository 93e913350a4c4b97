// SPDX-License-Identifier: Apache-2.0
#include "suture.hpp"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "toolkit/read_file.hpp"

namespace swage::thread {
namespace {

using Json = nlohmann::json;

struct Key {
  const char* unit;  // as the file must write it
  double si;
  double Suture::*of = nullptr;  // nullptr: read by people; friction is the coupling's
};

const std::map<std::string, Key>& keys() {
  static const std::map<std::string, Key> all = {{"diameter", {"um", 1e-6, &Suture::diameter}},
                                                 {"diameter_least", {"um", 1e-6}},
                                                 {"diameter_most", {"um", 1e-6}},
                                                 {"young", {"GPa", 1e9, &Suture::young}},
                                                 {"poisson", {"1", 1, &Suture::poisson}},
                                                 {"density", {"kg/m3", 1, &Suture::density}},
                                                 {"friction", {"1", 1}},
                                                 {"strength", {"mN", 1e-3, &Suture::strength}},
                                                 {"memory", {"1/m", 1, &Suture::memory}}};
  return all;
}

std::string take(const std::string& name, const Json& entry, Suture& suture) {
  const auto key = keys().find(name);
  if (key == keys().end()) return "\"" + name + "\" is not a property of a suture";
  const bool whole = entry.is_object() && entry.contains("value") && entry["value"].is_number() &&
                     entry.contains("unit") && entry["unit"].is_string();
  if (!whole) return "\"" + name + "\" needs a value and a unit";
  if (entry["unit"] != key->second.unit)
    return "\"" + name + "\" is in " + key->second.unit + ", not " + entry["unit"].get<std::string>();
  const bool told = entry.contains("status") &&
                    (entry["status"] == "sourced" || entry["status"] == "assumed") &&
                    entry.contains("source") && entry["source"].is_string();
  if (!told) return "\"" + name + "\" needs a status (sourced or assumed) and a source";
  const double x = entry["value"].get<double>() * key->second.si;
  if (!std::isfinite(x) || x < 0) return "\"" + name + "\" must be a number of 0 or above";
  if (key->second.of != nullptr) suture.*key->second.of = x;
  return "";
}

}  // namespace

std::string read_suture(const std::string& path, Suture& suture) {
  std::string text, why;
  if (!toolkit::read_file(path, toolkit::kMostFileBytes, text, why)) return path + ": " + why;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("format") || json["format"] != "swage-thread/1")
    return path + " is not a suture of format swage-thread/1";
  if (!json.contains("values") || !json["values"].is_object()) return path + " has no \"values\"";
  for (const auto& [name, entry] : json["values"].items()) {
    const std::string wrong = take(name, entry, suture);
    if (!wrong.empty()) return path + ": " + wrong;
  }
  return "";
}

std::string fault(const Suture& s) {
  const bool sound = s.diameter >= 5e-6 && s.diameter <= 1e-3 && s.young >= 1e6 && s.young <= 1e12 &&
                     s.poisson >= 0 && s.poisson <= 0.5 && s.density >= 100 && s.density <= 25e3 &&
                     s.memory >= 0 && s.memory <= 1000 && s.strength >= 1e-4;
  return sound ? ""
               : "the material is none: diameter 5 to 1000 um, 1 MPa to 1000 GPa, Poisson's ratio 0 to 0.5, 100 to "
                 "25000 kg/m3, memory 0 to 1000 1/m, strength 0.1 mN or more";
}

}  // namespace swage::thread
