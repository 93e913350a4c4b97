// SPDX-License-Identifier: Apache-2.0
//
// A needle in front of a tissue, welded by test.coupling.leash to a tool that goes where a path says. The needle's circle lies in
// the x-z plane of the world; turned by `turn` about its centre its point comes down into z = 0. For tests and benches: no test
// framework in here.
//
// [main]
#pragma once

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../catalogue.hpp"
#include "assembly/assemble.hpp"
#include "judge/verdict.hpp"
#include "step/step.hpp"
#include "test_places.hpp"

namespace swage::test {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

inline const host::Catalogue& catalogue() {
  static const host::Catalogue& found =
      test::make_catalogue(SWAGE_BINARY_DIR "/plugins", {SWAGE_BINARY_DIR "/test_plugins"});
  return found;
}

/// Where the needle is to be at a time.
using Path = std::function<Pose(double t)>;

struct PierceRig {
  std::string tissue = R"("level": "plane", "stiffening": 0)", pierce, leash, extra_objects, extra_couplings;
  std::string tissue_pose = R"("p": [0, 0, 0])";
  std::string needle = R"("arc": "4/8", "size": "5 mm")";
  double duration = 1;    // s, of the path
  double rate_hz = 1000;  // steps in a second
  step::Options options;

  // needle of half a circle: R = 2.5 mm; its frame O is in the middle of the wire, x away from the centre
  static constexpr double kRadius = 2.5e-3, kWire = 0.05e-3;

  /// The needle turned by `angle` about its circle's centre c, its plane x-z: at 0 its point is at c + (R, 0, 0) and looks down -z.
  static Pose turned(const Vec3& c, double angle) {
    // O's x axis (from the centre to the middle of the wire), y towards the swage, z the plane's normal
    Eigen::Matrix3d R;
    const double middle = 0.5 * M_PI - angle;  // of the wire, from +x towards +z
    const Vec3 x(std::cos(middle), 0, std::sin(middle)), y(-std::sin(middle), 0, std::cos(middle));
    R.col(0) = x, R.col(1) = y, R.col(2) = x.cross(y);
    return Pose(c + kRadius * x, Quat(R));
  }

  /// Makes the scene; the path is written to `file`. Returns what was wrong, "" when nothing was.
  std::string build(const Path& path, const std::string& file) {
    write_hand(path, file);
    base::Problems problems;
    assembly::LessonFile lesson;
    assembly::parse_lesson(text(path(0).abi(), file), "test.json", lesson, problems);
    rig = assembly::assemble(lesson, catalogue(), {}, problems);
    std::string wrong;
    for (const auto& p : problems)
      if (p.severity == base::Severity::kError) wrong += p.where + ": " + p.message + "\n";
    if (!rig) return wrong + "no scene";
    engine = std::make_unique<step::Engine>(*rig, options);
    engine->reset();
    return wrong;
  }

  /// One step; hears its events.
  void step() {
    engine->step();
    for (const judge::Event& e : engine->events()) heard.push_back({rig->script.events[e.event].id, e.value});
  }
  double time() const { return engine->world().time(); }

  /// The hand lets go, or takes hold again where the needle is when the leash was slack, from the next step on [N/m].
  bool hold(double stiffness) {
    step::Command command;
    command.kind = step::CommandKind::kLiveParameter;
    command.object = static_cast<uint32_t>(rig->objects.size());  // the first coupling: the leash
    command.parameter = 0;                                        // its stiffness
    command.number[0] = stiffness;
    return engine->push(command);
  }

  /// NaN when there is none; of the first owner that has it.
  double signal(const std::string& id, const std::string& owner = "") const {
    for (size_t i = 0; i < rig->script.signals.size(); ++i)
      if (rig->script.signals[i].id == id && (owner.empty() || rig->script.signals[i].owner == owner))
        return engine->world().signal[i];
    return std::nan("");
  }
  int count(const std::string& id) const {
    int n = 0;
    for (const auto& [name, value] : heard) n += name == id ? 1 : 0;
    return n;
  }
  /// Of the first such event; NaN when it was not heard.
  double value(const std::string& id) const {
    for (const auto& [name, v] : heard)
      if (name == id) return v;
    return std::nan("");
  }
  uint32_t body(const std::string& name) const {
    for (uint32_t i = 0; i < rig->world.body.size(); ++i)
      if (rig->world.body[i].name == name) return i;
    return scene::kNone;
  }
  Pose pose(const std::string& name) const { return Pose(engine->world().X_WB[body(name)]); }
  Pose needle_pose() const { return pose("needle"); }
  /// The point: the needle's body has its origin at the centre of mass, 2 R / pi from that of the circle (plus 0.01 %).
  Vec3 tip() const { return needle_pose() * Vec3(-2 / M_PI * kRadius, -kRadius, 0); }
  Vec3 end() const { return needle_pose() * Vec3(-2 / M_PI * kRadius, kRadius, 0); }
  double needle_energy() const {  // J, kinetic
    const uint32_t i = body("needle");
    const swage_twist& V = engine->world().V_WB[i];
    const scene::BodyInfo& info = rig->world.body[i];
    const Vec3 w = needle_pose().q.conjugate() * toolkit::vec(V.w);
    double e = 0.5 * info.mass * toolkit::vec(V.v).squaredNorm();
    for (int k = 0; k < 3; ++k) e += 0.5 * info.inertia[k] * w[k] * w[k];
    return e;
  }

  std::unique_ptr<host::Rig> rig;
  std::unique_ptr<step::Engine> engine;
  std::vector<std::pair<std::string, double>> heard;

 private:
  std::string text(const swage_pose& start, const std::string& file) const {
    char pose[256], rate[32];
    std::snprintf(pose, sizeof pose, R"("p": [%.12g, %.12g, %.12g], "q": [%.15g, %.15g, %.15g, %.15g])",
                  start.p.x, start.p.y, start.p.z, start.q.w, start.q.x, start.q.y, start.q.z);
    std::snprintf(rate, sizeof rate, "%.12g", rate_hz);
    return R"({"format": "swage-lesson/1", "id": "test.pierce", "title": "T",
      "gravity": [0, 0, 0], "scene_length": "1 mm", "rate_hz": )" +
           std::string(rate) + R"(,
      "devices": [{"name": "hand", "plugin": "swage.device.scripted", "params": {"file": ")" +
           file + R"("}}],
      "objects": [{"name": "holder", "plugin": "swage.object.jaws", "follows": {"pose": "hand"}, "pose": {)" +
           pose + R"(}},
        {"name": "needle", "plugin": "swage.object.needle", "pose": {)" +
           pose + R"(}, "params": {)" + needle + R"(}},
        {"name": "tissue", "plugin": "swage.object.tissue", "pose": {)" +
           tissue_pose + R"(}, "params": {)" + tissue + "}}" + extra_objects + R"(],
      "couplings": [{"name": "leash", "plugin": "test.coupling.leash", "between": ["holder", "needle"], "params": {)" +
           leash + R"(}},
        {"name": "pierce", "plugin": "swage.coupling.pierce", "between": ["needle", "tissue"], "params": {)" +
           pierce + "}}" + extra_couplings + R"(],
      "lesson": {"plugin": "swage.lesson.look", "params": {"duration": "1000 s"}}})";
  }
  void write_hand(const Path& path, const std::string& file) const {
    std::ofstream out(file);
    out.precision(15);
    out << R"({"format": "swage-hand/1", "title": "T", "samples": [)";
    const int n = static_cast<int>(std::lround(duration / 1e-3));
    for (int i = 0; i <= n; ++i) {
      const swage_pose X = path(1e-3 * i).abi();
      out << (i ? "," : "") << "[" << 1e-3 * i << "," << X.p.x << "," << X.p.y << "," << X.p.z << "," << X.q.w
          << "," << X.q.x << "," << X.q.y << "," << X.q.z << ",0]\n";
    }
    out << "]}";
  }
};

}  // namespace swage::test
