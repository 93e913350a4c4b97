// SPDX-License-Identifier: Apache-2.0
#include "assembly/reader.hpp"

#include <algorithm>
#include <cmath>

#include "assembly/sentences.hpp"
#include "assembly/source_map.hpp"
#include "base/text.hpp"
#include "host/nearest.hpp"
#include "host/units.hpp"
#include "toolkit/math.hpp"

namespace swage::assembly {

namespace {

constexpr std::size_t kMostUnknown = 20;  // keys reported one by one

const Json& empty_object() {
  static const Json empty = Json::object();
  return empty;
}

bool is_instance_name(const std::string& name) {
  const auto good = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && name[0] >= 'a' && name[0] <= 'z' && std::all_of(name.begin(), name.end(), good);
}

}  // namespace

std::string short_dump(const Json& json) {
  return base::shortened(json.dump(-1, ' ', false, Json::error_handler_t::replace), 57);
}

ObjectReader::ObjectReader(const Json& json, std::string pointer, std::string what, const Teller& teller)
    : json_(&json), pointer_(std::move(pointer)), what_(std::move(what)), teller_(teller) {
  if (json.is_object()) return;
  teller_.error(pointer_,
                say::kNoObject(what_, short_dump(json)));
  json_ = &empty_object();
}

std::string ObjectReader::at(const std::string& key) const { return pointer_ + "/" + pointer_step(key); }

const Json* ObjectReader::find(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  const auto found = json_->find(key);
  return found == json_->end() ? nullptr : &*found;
}

const Json* ObjectReader::need(const std::string& key) {
  const Json* value = find(key);
  // a value that is not an object was reported already
  if (value == nullptr && json_ != &empty_object()) teller_.error(pointer_, say::kMissing(key));
  return value;
}

std::string ObjectReader::text(const std::string& key, bool required) {
  const Json* value = required ? need(key) : find(key);
  if (value == nullptr) return "";
  if (!value->is_string()) {
    teller_.error(at(key), say::kNoText(key, short_dump(*value)));
    return "";
  }
  if (required && value->get_ref<const std::string&>().empty())
    teller_.error(at(key), say::kEmptyText(key));
  return value->get<std::string>();
}

std::string ObjectReader::filled(const std::string& key) { return text(key, find(key) != nullptr); }

bool ObjectReader::flag(const std::string& key, bool fallback) {
  const Json* value = find(key);
  if (value == nullptr) return fallback;
  if (value->is_boolean()) return value->get<bool>();
  teller_.error(at(key), say::kNoFlag(key, short_dump(*value)));
  return fallback;
}

std::string ObjectReader::choice(const std::string& key, std::span<const char* const> words) {
  const std::string word = text(key, false);
  if (std::find(words.begin(), words.end(), word) != words.end()) return word;
  const std::vector<std::string> all(words.begin(), words.end());
  teller_.error(at(key), say::kNoChoice(word, key, host::did_you_mean(word, all), host::join(all)));
  return words.front();
}

std::string ObjectReader::name(const std::string& key, bool required) {
  const std::string name = text(key, required);
  if (!name.empty() && !is_instance_name(name)) {
    teller_.error(at(key),
                  say::kNoName(name));
  }
  return name;
}

bool ObjectReader::number(const Json& json, const std::string& pointer, const std::string& label,
                          const char* unit, double& out) {
  std::string sentence;
  if (json.is_number()) {
    out = json.get<double>();
    return true;
  }
  if (json.is_string()) {
    if (host::parse_quantity(json.get<std::string>(), unit, label, out, sentence)) return true;
  } else {
    const host::Unit* u = host::find_unit(unit);
    const bool pure = std::string(unit) == "1";
    sentence = say::kNoQuantity(label, u->dimension + (pure ? "" : say::kUnits(host::units_like(unit))), short_dump(json));
  }
  teller_.error(pointer, sentence);
  return false;
}

double ObjectReader::quantity(const std::string& key, const char* unit, double fallback, double min,
                              double max) {
  const Json* value = find(key);
  double out = fallback;
  if (value == nullptr || !number(*value, at(key), key, unit, out)) return fallback;
  if (out >= min && out <= max) return out;
  teller_.error(at(key), say::kOutOfRange(short_dump(*value), key, host::format_quantity(min, unit), host::format_quantity(max, unit)));
  return fallback;
}

uint64_t ObjectReader::whole(const std::string& key, uint64_t fallback) {
  const Json* value = find(key);
  if (value == nullptr) return fallback;
  if (value->is_number_unsigned()) return value->get<uint64_t>();
  teller_.error(at(key), say::kNoWhole(key, short_dump(*value)));
  return fallback;
}

swage_vec3 ObjectReader::vector(const std::string& key, const char* unit, swage_vec3 fallback) {
  const Json* value = find(key);
  if (value == nullptr) return fallback;
  if (!value->is_array() || value->size() != 3) {
    teller_.error(at(key), say::kNoVector(key, short_dump(*value)));
    return fallback;
  }
  double v[3] = {0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!number((*value)[i], at(key) + "/" + std::to_string(i), key, unit, v[i])) return fallback;
    // 1 km: everything in a scene is smaller, and numbers like 1e300 are mistakes
    if (!(std::abs(v[i]) <= 1e3)) {
      teller_.error(at(key) + "/" + std::to_string(i), say::kTooLargeNumber(short_dump((*value)[i])));
      return fallback;
    }
  }
  return {v[0], v[1], v[2]};
}

swage_pose ObjectReader::pose(const std::string& key) {
  swage_pose out{{0, 0, 0}, {1, 0, 0, 0}};
  const Json* value = find(key);
  if (value == nullptr) return out;
  ObjectReader reader(*value, at(key), "a pose", teller_);
  out.p = reader.vector("p", "m", out.p);
  const Json* q = reader.find("q");
  const bool has_rpy = reader.find("rpy") != nullptr;
  if (q != nullptr && has_rpy) teller_.error(at(key), say::kTwoRotations());

  // roll, pitch, yaw about the fixed axes x, y, z
  const swage_vec3 rpy = reader.vector("rpy", "rad", {0, 0, 0});
  using toolkit::Quat, toolkit::Vec3;
  const Quat turn = Quat(Eigen::AngleAxisd(rpy.z, Vec3::UnitZ())) *
                    Quat(Eigen::AngleAxisd(rpy.y, Vec3::UnitY())) *
                    Quat(Eigen::AngleAxisd(rpy.x, Vec3::UnitX()));
  out.q = toolkit::raw(turn.normalized());
  reader.finish();
  if (q == nullptr) return out;

  const bool four = q->is_array() && q->size() == 4 &&
                    std::all_of(q->begin(), q->end(), [](const Json& n) { return n.is_number(); });
  Quat given = Quat::Identity();
  if (four)
    given = Quat((*q)[0].get<double>(), (*q)[1].get<double>(), (*q)[2].get<double>(), (*q)[3].get<double>());
  // 1e-3: rounding by a person; a larger deviation means another rotation
  if (!four || !(std::abs(given.norm() - 1) < 1e-3)) {
    teller_.error(at(key) + "/q", say::kNoQuaternion(short_dump(*q)));
    return out;
  }
  out.q = toolkit::raw(given.normalized());
  return out;
}

void ObjectReader::each(const std::string& key, std::size_t most,
                        const std::function<void(const Json&, const std::string&)>& f) {
  const Json* value = find(key);
  if (value == nullptr) return;
  if (!value->is_array()) {
    teller_.error(at(key), say::kNoList(key, short_dump(*value)));
    return;
  }
  if (value->size() > most)
    return teller_.error(at(key), say::kTooMany(key, most, value->size()));
  for (std::size_t i = 0; i < value->size(); ++i) f((*value)[i], at(key) + "/" + std::to_string(i));
}

void ObjectReader::finish() {
  std::size_t unknown = 0;
  for (const auto& [key, value] : json_->items()) {
    if (key.starts_with("x-") || std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    if (++unknown > kMostUnknown) continue;
    teller_.error(at(key), say::kUnknownKey(key, what_, host::did_you_mean(key, known_), host::join(known_)));
  }
  if (unknown > kMostUnknown)
    teller_.error(pointer_, say::kMoreKeys(unknown - kMostUnknown));
}

}  // namespace swage::assembly
