// SPDX-License-Identifier: Apache-2.0
//
// What a needle is made to do in tissue, each with one dangerous parameter, and what its energy did meanwhile. One code for the test of
// the balance (pierce_energy_test) and for the stability catalogue (S40 to S45, S48).
//
// [main]
#pragma once

#include <algorithm>

#include "pierce_energy.hpp"
#include "test_places.hpp"

namespace swage::test {

/// How it is computed: the engine's options, the tissue's level, and whether ties are explicit, as penalties of the last step.
struct FeatMethod {
  step::Options options;
  tissue::Level level = tissue::Level::kCompliant;
  double rate_hz = 1000;
  bool explicit_ties = false;
};

struct Feat {
  bool done = false;                             // the needle did what it was to do
  bool sound = true;                             // finite, and every step converged
  double made = 0;                               // J, by the step that made most
  double made_in_all = 0;                        // J, the most that was ever owed
  double most_stored = 0, put_in = 0, rest = 0;  // J; rest: of motion, at the end
  double jump = 0;                               // N, largest change of what the hand feels in a millisecond

  /// Energy made over the most that was stored; infinite when it was not done or came to nothing.
  double error() const {
    if (!done || !sound || !(most_stored > 0)) return HUGE_VAL;
    return std::max(made, made_in_all) / most_stored;
  }
};

class FeatScene {
 public:
  explicit FeatScene(const FeatMethod& method) : method_(method) {
    rig.options = method.options;
    rig.rate_hz = method.rate_hz;
  }

  PierceRig rig;
  tissue::TissueParams tissue;       // of the tissue called so
  std::vector<Ledger::Wall> others;  // and of those in extra_objects
  double start_s = 0;                // from when on the hand's force is looked at

  /// False when there is no such scene.
  bool begin(const Path& path, const std::string& file) {
    tissue.level = method_.level;
    rig.tissue = text(tissue);
    if (!rig.build(path, file).empty()) return false;
    std::vector<Ledger::Wall> walls{{2, tissue}};
    walls.insert(walls.end(), others.begin(), others.end());
    ledger_ = std::make_unique<Ledger>(rig, walls);
    return true;
  }
  void run_until(double t) {
    while (rig.time() < t - 1e-9 && feat.sound) {
      if (method_.explicit_ties) push();
      rig.step();
      ledger_->look();
      feat.sound = rig.needle_pose().p.allFinite() && rig.engine->quarantined() == 0;
      feel();
    }
  }
  Feat end() {
    feat.sound = feat.sound && std::isfinite(ledger_->lost) && rig.engine->stats().health.not_converged == 0;
    feat.made = -ledger_->worst, feat.made_in_all = -ledger_->deepest;
    feat.most_stored = ledger_->most_stored, feat.put_in = ledger_->put_in;
    feat.rest = rig.needle_energy();
    return feat;
  }
  Feat feat;

  /// Parameters of a tissue in a lesson file.
  static std::string text(const tissue::TissueParams& t) {
    char out[600];
    std::snprintf(
        out, sizeof out,
        R"("level": "%s", "size": [%.9g, %.9g], "thickness": %.9g, "backing": %.9g, "stiffness": %.9g,
      "stiffening": %.9g, "young": %.9g, "friction": %.9g, "puncture_force": %.9g, "cutting_force": %.9g, "drag": %.9g,
      "side_stiffness": %.9g, "failure_stress": %.9g, "relaxed": %.17g)",
        tissue::Tissue::kLevels[static_cast<int>(t.level)], t.size[0], t.size[1], t.thickness, t.backing,
        t.stiffness, t.stiffening, t.young, t.friction, t.puncture_force, t.cutting_force, t.drag,
        t.side_stiffness, t.failure_stress, t.relaxed);
    return out;
  }

 private:
  /// What ties would do if their forces were those of the last step: a penalty method.
  void push() {
    const uint32_t needle = rig.body("needle");
    swage_wrench& F = rig.rig->world.F_B_W[needle];
    const Vec3 centre = rig.needle_pose().p;
    for (const dynamics::Tie& tie : rig.engine->ties()) {
      const double along = tie.axis_W.dot(tie.offset_W);
      const Vec3 across = tie.offset_W - along * tie.axis_W;
      const double s = across.norm();
      const dynamics::Force f = dynamics::tie_force(tie.law, {along, s, 0});
      Vec3 f_W = f.fn * tie.axis_W + (s > 0 ? Vec3(f.f1 / s * across) : Vec3::Zero());
      if (tie.body_b == needle) f_W = -f_W;
      F.f = toolkit::raw(Vec3(toolkit::vec(F.f) + f_W));
      F.t = toolkit::raw(Vec3(toolkit::vec(F.t) + (tie.p_W - centre).cross(f_W)));
    }
  }
  void feel() {
    Vec3 f = Vec3::Zero();
    bool holds = false;
    for (const dynamics::Tie& tie : rig.engine->ties())
      if (tie.body_a == rig.rig->objects[0].body.first) f += tie.f_a_W, holds = true;
    if (holds && held_ && rig.time() > start_s)
      feat.jump = std::max(feat.jump, (f - felt_).norm() * 1e-3 * method_.rate_hz);
    felt_ = f, held_ = holds;
  }

  FeatMethod method_;
  std::unique_ptr<Ledger> ledger_;
  Vec3 felt_ = Vec3::Zero();
  bool held_ = false;
};

/// Where scene files are written.
inline std::string feat_file(const char* name) {
  return std::string(SWAGE_BINARY_DIR "/feat_") + name + ".json";
}

/// The hand turns the needle about its circle's centre, which lies in the surface: angle over time.
inline Pose about(double angle) { return PierceRig::turned({-PierceRig::kRadius, 0, 0}, angle); }

/// In, then on at `speed` [m/s] and back, then let go. S40
inline Feat drive(const FeatMethod& method, double speed) {
  constexpr double R = PierceRig::kRadius, in = 0.3, way = 0.5, slow = 2;  // rad, rad/s
  FeatScene s(method);
  s.tissue.size = {8e-3, 8e-3}, s.tissue.thickness = 4e-3;
  const double t0 = (in + 0.12) / slow, t1 = speed > 0 ? std::min(way * R / speed, 0.4) : 0.4;
  s.rig.duration = t0 + 2 * t1 + 0.05;
  const auto angle = [=](double t) {
    if (t < t0) return -0.12 + slow * t;
    const double u = t - t0;
    return in + speed / R * (u < t1 ? u : std::max(0.0, 2 * t1 - u));
  };
  if (!s.begin([&](double t) { return about(angle(t)); }, feat_file("drive"))) return {};
  s.run_until(t0 + 2 * t1);
  s.feat.done = s.rig.count("pierce.entered") == 1 && s.rig.signal("pierce.state") == 2;
  s.rig.hold(0);
  s.run_until(t0 + 2 * t1 + 0.3);
  return s.end();
}

/// In to 3.6 mm about a centre that is a little off, so that the track bears it sideways as well, and let go. `look`: after each step on the way in.
template <class Look>
Feat deep(const FeatMethod& method, double friction, const Look& look) {
  FeatScene s(method);
  s.tissue.size = {8e-3, 8e-3}, s.tissue.thickness = 6e-3, s.tissue.friction = friction;
  s.rig.duration = 2.2;
  const auto path = [](double t) {
    return PierceRig::turned({-PierceRig::kRadius + 40e-6 * t, 40e-6 * t, 0}, std::min(-0.12 + t, 2.0));
  };
  if (!s.begin(path, feat_file("deep"))) return {};
  for (double t = 0; t < 2.1; t += 1e-3) {
    s.run_until(t);
    look(s);
  }
  s.feat.done = s.rig.signal("pierce.state") == 2 && s.rig.signal("pierce.depth") > 3e-3;
  s.rig.hold(0);
  s.run_until(2.3);
  return s.end();
}

/// Comes straight along its point at `angle` [rad] to the inward normal with 5 mm/s, until it is in or has slid 3 mm. S41
inline Feat graze(const FeatMethod& method, double angle, bool let_go = true) {
  FeatScene s(method);
  s.tissue.size = {8e-3, 8e-3}, s.tissue.thickness = 4e-3;
  s.rig.duration = 0.7;
  const Vec3 way(-std::sin(angle), 0, -std::cos(angle));
  const Vec3 point = Vec3(2e-3, 0, 0.06e-3) - 0.1e-3 * way;
  const auto path = [&](double t) {
    return PierceRig::turned(point + std::min(5e-3 * t, 3e-3) * way -
                                 PierceRig::kRadius * Vec3(std::cos(angle), 0, -std::sin(angle)),
                             angle);
  };
  if (!s.begin(path, feat_file("graze"))) return {};
  s.run_until(0.65);
  s.feat.done = s.rig.count("pierce.touched") > 0;
  if (!let_go) return s.end();
  s.rig.hold(0);
  s.run_until(0.8);
  return s.end();
}

/// Through a wall of 0.8 mm into a second one `gap` [m] behind it, and let go in both. S42
inline Feat two_tissues(const FeatMethod& method, double gap) {
  FeatScene s(method);
  s.tissue.size = {8e-3, 8e-3}, s.tissue.thickness = 0.8e-3, s.tissue.backing = 0;
  tissue::TissueParams second = s.tissue;
  second.level = method.level, second.thickness = 3e-3;
  char pose[80];
  std::snprintf(pose, sizeof pose, R"("p": [0, 0, %.9g])", -0.8e-3 - gap);
  s.rig.extra_objects = std::string(R"(, {"name": "second", "plugin": "swage.object.tissue", "pose": {)") +
                        pose + R"(}, "params": {)" + FeatScene::text(second) + "}}";
  s.rig.extra_couplings =
      R"(, {"name": "pierce2", "plugin": "swage.coupling.pierce", "between": ["needle", "second"]})";
  s.others.push_back({3, second});
  s.rig.duration = 1.3;
  if (!s.begin([](double t) { return about(std::min(-0.12 + t, 1.0)); }, feat_file("two"))) return {};
  s.run_until(1.2);
  s.feat.done = s.rig.signal("pierce.depth", "pierce") > 0 && s.rig.signal("pierce.depth", "pierce2") > 0;
  s.rig.hold(0);
  s.run_until(1.5);
  return s.end();
}

/// In beside the rim, then sideways at `speed` [m/s] until the tear has come to it and the needle is free. S43
inline Feat tear_to_rim(const FeatMethod& method, double speed) {
  FeatScene s(method);
  s.tissue.size = {8e-3, 1.6e-3}, s.tissue.thickness = 4e-3;
  const double t0 = 0.31, t1 = 1.6e-3 / speed;
  s.rig.duration = t0 + t1 + 0.05;
  s.rig.leash = R"("stiffness": "20000 N/m")";
  const auto path = [&](double t) {
    Pose X = about(std::min(-0.12 + 2 * t, 0.5));
    X.p.y() += speed * std::clamp(t - t0, 0.0, t1);
    return X;
  };
  if (!s.begin(path, feat_file("rim"))) return {};
  s.run_until(t0 + t1 + 0.05);
  s.feat.done = s.rig.count("pierce.torn") > 0 && s.rig.count("pierce.cut_out") == 1;
  return s.end();
}

/// Let go in the middle, and taken again by a hand that moves on at `speed` [m/s]; `by_point`: on the other side, the point being out. S44
inline Feat regrasp(const FeatMethod& method, double speed, bool by_point) {
  FeatScene s(method);
  s.tissue.size = {8e-3, 8e-3}, s.tissue.thickness = by_point ? 0.8e-3 : 4e-3,
  s.tissue.backing = by_point ? 0 : 1e-3;
  const double in = by_point ? 1.0 : 0.5, t0 = (in + 0.12) / 2, again = t0 + 0.2, upto = again + 0.1;
  s.rig.duration = upto + 0.01;
  const auto path = [&](double t) {
    return about(std::min(-0.12 + 2 * t, in) + speed / PierceRig::kRadius * std::max(0.0, t - again + 0.01));
  };
  if (!s.begin(path, feat_file("regrasp"))) return {};
  s.run_until(t0 + 0.05);
  const bool was_in = s.rig.signal("pierce.state") == (by_point ? 3 : 2);
  s.rig.hold(0);
  s.run_until(again);
  s.rig.hold(2000);
  s.run_until(upto);
  s.feat.done = was_in && s.rig.signal("pierce.state") >= 2;
  s.rig.hold(0);
  s.run_until(upto + 0.3);
  return s.end();
}

/// In and let go in tissue of `young` [Pa]; softer tissue is as much weaker. S45
inline Feat stiffness(const FeatMethod& method, double young) {
  const double strength = std::min(1.0, young / 1e6);
  FeatScene s(method);
  tissue::TissueParams& t = s.tissue;
  t.size = {8e-3, 8e-3}, t.thickness = 4e-3, t.young = t.side_stiffness = young;
  t.stiffness *= young / 1e6, t.stiffening *= young / 1e6;
  t.puncture_force *= strength, t.cutting_force *= strength, t.drag *= strength, t.failure_stress *= strength;
  s.rig.duration = 0.7;
  if (!s.begin([](double at) { return about(std::min(-0.12 + 2 * at, 1.0)); }, feat_file("stiffness")))
    return {};
  s.run_until(0.7);
  s.feat.done = s.rig.signal("pierce.state") == 2;
  s.rig.hold(0);
  s.run_until(1);
  return s.end();
}

/// Held still 20 um below the surface of tissue that yields but for the share `creeps` of itself: dent and force are those of an elastic
/// solid, and do not grow. S48
inline Feat elastic(const FeatMethod& method, double creeps) {
  constexpr double depth = 20e-6, down = 0.12, end = 0.32;  // m, s, s
  FeatScene s(method);
  s.tissue.relaxed = 1 - creeps;
  s.rig.leash = R"("stiffness": "50000 N/m")";
  s.rig.duration = 0.4;
  const auto path = [](double t) {
    Pose X = about(0);
    X.p.z() += PierceRig::kWire + 5e-6 - (5e-6 + depth) * std::min(t / down, 1.0);
    return X;
  };
  if (!s.begin(path, feat_file("elastic"))) return {};
  s.run_until(down + 0.08);
  const double settled = s.rig.signal("tissue.force");
  s.run_until(end);
  // a plane shows no dent and bears what its depth says
  const bool dents = method.level != tissue::Level::kPlane;
  s.feat.done = !dents || (settled > 0 && s.rig.signal("tissue.force") <= 1.001 * settled &&
                           s.rig.signal("tissue.dimple") <= 1.05 * depth);
  return s.end();
}

}  // namespace swage::test
