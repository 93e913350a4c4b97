// SPDX-License-Identifier: Apache-2.0
#include "haply.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace swage::inverse3 {
namespace {

using Json = nlohmann::json;

constexpr double kFarthest = 1;  // m; the arm reaches 0.3 m. A position farther away is no measurement
constexpr double kFastest = 20;  // m/s; hands reach 3 m/s

const Json* member(const Json& in, const char* key) {
  if (!in.is_object()) return nullptr;
  const auto it = in.find(key);
  return it == in.end() ? nullptr : &*it;
}

std::string text_of(const Json& in, const char* key) {
  const Json* found = member(in, key);
  return found != nullptr && found->is_string() ? found->get<std::string>() : "";
}

bool number(const Json& in, const char* key, double& out) {
  const Json* found = member(in, key);
  if (found == nullptr || !found->is_number()) return false;
  out = found->get<double>();
  return std::isfinite(out);
}

// Haply's axes are x right, y forward, z up
Vec3 to_device(const Vec3& h) { return {h.x(), h.z(), -h.y()}; }
Vec3 to_haply(const Vec3& d) { return {d.x(), -d.z(), d.y()}; }
// the same as a rotation: by -90 degrees about x
const Quat& turn() {
  static const Quat q(std::sqrt(0.5), -std::sqrt(0.5), 0, 0);
  return q;
}

bool vector(const Json* in, Vec3& out) {
  Vec3 h;
  if (in == nullptr || !number(*in, "x", h.x()) || !number(*in, "y", h.y()) || !number(*in, "z", h.z())) return false;
  out = to_device(h);
  return true;
}

std::optional<Arm> read_arm(const Json& in) {
  const Json* state = member(in, "state");
  if (state == nullptr) return std::nullopt;
  Arm arm;
  arm.id = text_of(in, "device_id");
  if (!vector(member(*state, "cursor_position"), arm.p_D) || arm.p_D.norm() > kFarthest) return std::nullopt;
  if (!vector(member(*state, "cursor_velocity"), arm.v_D) || arm.v_D.norm() > kFastest) arm.v_D = Vec3::Zero();
  if (const Json* config = member(in, "config")) {
    arm.handedness = text_of(*config, "handedness");
    arm.newer = config->is_object() && config->contains("preset");  // the first message of 3.5 has it, that of 3.1 does not
  }
  return arm;
}

std::optional<Grip> read_grip(const Json& in) {
  const Json* state = member(in, "state");
  const Json* orientation = state != nullptr ? member(*state, "orientation") : nullptr;
  if (orientation == nullptr) return std::nullopt;
  double w = 0, x = 0, y = 0, z = 0;
  for (const auto& [key, out] : {std::pair{"w", &w}, {"x", &x}, {"y", &y}, {"z", &z}})
    if (!number(*orientation, key, *out)) return std::nullopt;
  Quat q(w, x, y, z);
  if (!(std::abs(q.norm() - 1) < 0.1)) return std::nullopt;
  Grip grip;
  grip.q_DG = (turn() * q.normalized()).normalized();
  if (const Json* buttons = member(*state, "buttons")) {
    const char* const names[] = {"a", "b", "c"};
    for (uint32_t i = 0; i < 3; ++i)
      if (const Json* down = member(*buttons, names[i]); down != nullptr && down->is_boolean() && down->get<bool>()) grip.buttons |= 1u << i;
  }
  double battery = 0;
  if (number(*state, "battery_level", battery)) grip.battery = battery;
  return grip;
}

}  // namespace

Message read_message(std::string_view text, const std::string& wanted_arm, const std::string& wanted_grip) {
  Message out;
  const Json in = Json::parse(text.begin(), text.end(), nullptr, false);
  if (!in.is_object()) return out;
  out.readable = true;
  if (const Json* arms = member(in, "inverse3"); arms != nullptr && arms->is_array())
    for (const Json& one : *arms) {
      const std::string id = text_of(one, "device_id");
      const bool meant = !out.arm && (wanted_arm.empty() || id == wanted_arm);
      if (meant)
        out.arm = read_arm(one);
      else
        out.others += (out.others.empty() ? "" : ", ") + id;
    }
  for (const char* kind : {"wireless_verse_grip", "verse_grip"})
    if (const Json* grips = member(in, kind); grips != nullptr && grips->is_array())
      for (const Json& one : *grips)
        if (!out.grip && (wanted_grip.empty() || text_of(one, "device_id") == wanted_grip)) out.grip = read_grip(one);
  return out;
}

std::string force_message(const std::string& arm, bool newer, const Vec3& force_D) {
  const Vec3 f = to_haply(force_D);
  const Json values = {{"x", f.x()}, {"y", f.y()}, {"z", f.z()}};
  const Json command = {{"set_cursor_force", {{newer ? "vector" : "values", values}}}};
  const Json one = {{"device_id", arm}, {"commands", command}};
  return Json{{"inverse3", Json::array({one})}}.dump();
}

std::string asking_message() { return R"({"session":{"force_render_full_state":{}}})"; }

}  // namespace swage::inverse3
