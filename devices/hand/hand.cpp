// SPDX-License-Identifier: Apache-2.0
#include "hand.hpp"

#include <algorithm>

#include "hand/reader.hpp"

namespace swage::hand {
namespace {

Quat unit_quat(const Reader& reader, const Quat& q, const std::string& where) {
  const double norm = q.norm();
  if (norm < 0.5 || norm > 2) reader.fail(where, say::kNoUnit());
  return Quat(q.coeffs() / norm);
}

Quat read_quat(const Reader& reader, const Json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 4) reader.fail(where, say::kQuaternion());
  std::array<double, 4> q{};
  for (size_t i = 0; i < 4; ++i) {
    q[i] = reader.number(value[i], Measure::kNumber, where + "/" + std::to_string(i));
  }
  return unit_quat(reader, Quat(q[0], q[1], q[2], q[3]), where);
}

Quat read_orientation(const Reader& reader, const Json& key, const Quat& before, const std::string& where) {
  const bool frame = key.contains("axis") || key.contains("closing");
  const int ways = (key.contains("q") ? 1 : 0) + (key.contains("rpy") ? 1 : 0) + (frame ? 1 : 0);
  if (ways == 0) return before;
  if (ways > 1) reader.fail(where, say::kOneAttitude());
  if (key.contains("q")) return read_quat(reader, key["q"], where + "/q");
  if (key.contains("rpy")) {
    const Vec3 a = reader.vec3(key["rpy"], Measure::kAngle, where + "/rpy");
    return toolkit::exp_rotation({0, 0, a.z()}) * toolkit::exp_rotation({0, a.y(), 0}) *
           toolkit::exp_rotation({a.x(), 0, 0});
  }
  return read_attitude(reader, key, where);
}

/// Reads a rotation of the previous pose about a line in the world.
void read_turn(const Reader& reader, const Json& turn, Key& key, const std::string& where) {
  if (!turn.is_object() || turn.size() != 3 || !turn.contains("about") || !turn.contains("axis") ||
      !turn.contains("angle")) {
    reader.fail(where, say::kTurn());
  }
  const Vec3 axis = reader.vec3(turn["axis"], Measure::kNumber, where + "/axis");
  if (!(axis.norm() > 0)) reader.fail(where + "/axis", say::kNoAxis());
  key.turns = true;
  key.about_W = reader.vec3(turn["about"], Measure::kLength, where + "/about");
  key.turn_W = reader.number(turn["angle"], Measure::kAngle, where + "/angle") * axis.normalized();
  const Quat q = toolkit::exp_rotation(key.turn_W);
  key.X_WT = {key.about_W + q * (key.X_WT.p - key.about_W), (q * key.X_WT.q).normalized()};
}

Key read_key(const Reader& reader, const Json& value, const Key& before, bool first,
             const std::string& where) {
  constexpr std::array kKnown = {"t", "p", "q", "rpy", "axis", "closing", "turn", "closure", "grip", "doc"};
  if (!value.is_object()) reader.fail(where, say::kKey());
  for (const auto& item : value.items()) {
    if (std::find(kKnown.begin(), kKnown.end(), item.key()) == kKnown.end()) {
      reader.fail(where + "/" + item.key(), say::kKeyHas());
    }
  }
  if (!value.contains("t")) reader.fail(where, say::kNoTime());
  if (first && !value.contains("p")) reader.fail(where, say::kNoPlace());

  Key key = before;
  key.turns = false;
  key.t = reader.number(value["t"], Measure::kTime, where + "/t");
  if (value.contains("p")) key.X_WT.p = reader.vec3(value["p"], Measure::kLength, where + "/p");
  key.X_WT.q = read_orientation(reader, value, before.X_WT.q, where);
  if (value.contains("turn")) {
    if (first) reader.fail(where + "/turn", say::kFirstTurns());
    for (const char* pose : {"p", "q", "rpy", "axis", "closing"})
      if (value.contains(pose)) reader.fail(where, say::kTurnOr(pose));
    read_turn(reader, value["turn"], key, where + "/turn");
  }
  if (value.contains("closure")) {
    key.closure = reader.number(value["closure"], Measure::kNumber, where + "/closure");
  }
  if (value.contains("grip")) key.grip = reader.number(value["grip"], Measure::kForce, where + "/grip");
  return key;
}

Key read_sample(const Reader& reader, const Json& value, const std::string& where) {
  if (!value.is_array() || (value.size() != 9 && value.size() != 10)) {
    reader.fail(where, say::kSample());
  }
  std::array<double, 10> n{};
  for (size_t i = 0; i < value.size(); ++i) {
    n[i] = reader.number(value[i], Measure::kNumber, where + "/" + std::to_string(i));
  }
  Key key;
  key.t = n[0];
  key.X_WT.p = Vec3(n[1], n[2], n[3]);
  // a recorded quaternion keeps its bits when it is already of unit length
  const Quat q(n[4], n[5], n[6], n[7]);
  key.X_WT.q = std::abs(q.squaredNorm() - 1) < 1e-12 ? q : unit_quat(reader, q, where);
  key.closure = n[8];
  key.grip = n[9];
  return key;
}

void check_key(const Reader& reader, const Hand& hand, const std::string& where) {
  const Key& key = hand.keys.back();
  if (hand.keys.size() > 1 && !(key.t > hand.keys[hand.keys.size() - 2].t)) {
    reader.fail(where, say::kTimesRise());
  }
  if (key.closure < 0 || key.closure > 1) reader.fail(where, say::kClosure());
}

}  // namespace

Quat orientation(const Vec3& axis, const Vec3& closing) {
  const Vec3 x = axis.normalized();
  const Vec3 square = closing - closing.dot(x) * x;
  if (!(axis.norm() > 0) || !(square.norm() > 1e-6 * closing.norm())) {
    throw std::invalid_argument(say::kSameDirection());
  }
  toolkit::Mat3 R;
  R.col(0) = x;
  R.col(2) = square.normalized();
  R.col(1) = R.col(2).cross(R.col(0));
  return Quat(R).normalized();
}

Quat read_attitude(const Reader& reader, const Json& value, const std::string& where) {
  if (!value.contains("axis") || !value.contains("closing")) reader.fail(where, say::kTogether());
  try {
    return orientation(reader.vec3(value["axis"], Measure::kNumber, where + "/axis"),
                       reader.vec3(value["closing"], Measure::kNumber, where + "/closing"));
  } catch (const std::invalid_argument& problem) {
    reader.fail(where, problem.what());
  }
}

Hand parse_hand(const std::string& text, const std::string& name) {
  const Reader reader(name);
  const Json file = object_of(reader, text, "swage-hand/1", {"format", "title", "doc", "keys", "samples"}, say::kHandHas());
  if (file.contains("keys") == file.contains("samples")) reader.fail("", say::kKeysOrSamples());

  Hand hand;
  hand.title = reader.text(file, "title");
  hand.sampled = file.contains("samples");
  const std::string list = hand.sampled ? "samples" : "keys";
  const Json& lines = file[list];
  if (!lines.is_array() || lines.empty()) reader.fail("/" + list, say::kEmpty());
  for (size_t i = 0; i < lines.size(); ++i) {
    const std::string where = "/" + list + "/" + std::to_string(i);
    const Key before = i == 0 ? Key{} : hand.keys.back();
    hand.keys.push_back(hand.sampled ? read_sample(reader, lines[i], where)
                                     : read_key(reader, lines[i], before, i == 0, where));
    hand.has_grip = hand.has_grip || (hand.sampled ? lines[i].size() == 10 : lines[i].contains("grip"));
    check_key(reader, hand, where);
  }
  return hand;
}

Hand load_hand(const std::string& path) { return parse_hand(text_of(path), path); }

Moment Hand::at(double t, Between between) const noexcept {
  // the keys before and after t; at the ends twice the same one
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), t, [](double x, const Key& k) { return x < k.t; });
  const Key& k0 = after == keys.begin() ? keys.front() : *(after - 1);
  const Key& k1 = after == keys.begin() || after == keys.end() ? k0 : *after;

  Moment m{k0.X_WT, Vec3::Zero(), Vec3::Zero(), k0.closure, k0.grip};
  const double span = k1.t - k0.t;
  if (!(span > 0) || between == Between::kHold) return m;

  // share u of the path and its rate: 10 x^3 - 15 x^4 + 6 x^5 is the minimum-jerk path between two rests
  const double x = (t - k0.t) / span;
  const bool smooth = between == Between::kMinimumJerk;
  const double u = smooth ? x * x * x * (10 + x * (-15 + 6 * x)) : x;
  const double rate = (smooth ? 30 * x * x * (1 - x) * (1 - x) : 1.0) / span;

  m.closure = k0.closure + u * (k1.closure - k0.closure);
  m.grip = k0.grip + u * (k1.grip - k0.grip);
  if (k1.turns) {
    const Quat q = toolkit::exp_rotation(u * k1.turn_W);
    const Vec3 arm = q * (k0.X_WT.p - k1.about_W);
    m.X_WT = {k1.about_W + arm, q * k0.X_WT.q};
    m.w_W = rate * k1.turn_W;
    m.v_W = m.w_W.cross(arm);
    return m;
  }
  const Vec3 way = k1.X_WT.p - k0.X_WT.p;
  const Vec3 turn = toolkit::log_rotation(k0.X_WT.q.conjugate() * k1.X_WT.q);
  m.X_WT.p = k0.X_WT.p + u * way;
  m.X_WT.q = k0.X_WT.q * toolkit::exp_rotation(u * turn);
  m.v_W = rate * way;
  m.w_W = rate * (k0.X_WT.q * turn);
  return m;
}

}  // namespace swage::hand
