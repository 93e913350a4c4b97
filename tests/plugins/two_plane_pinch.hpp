// SPDX-License-Identifier: Apache-2.0
//
// The stock needle between the stock jaws, with the stock couplings and the real solver: a pinch between two planes that can be
// solved by hand. Tool frame = world; the needle crosses the jaws along y at a distance d behind the tips.
#pragma once

#include <fstream>
#include <string>

#include "run_lesson.hpp"

namespace swage::stage {

struct PinchSetup {
  double behind = 0.5e-3;  // m, d
  double grip = 0.6;       // N at the tips; given to the jaws as a force measured at the handle
  double friction = 0.3;
  double off_flat = 0;  // rad, of the needle's plane from the faces, about the wire
  /// Further parameters of the needle, as they stand in a lesson file: `"level": "bending"`.
  std::string needle = {};
};

// sizes that the jaws have by default (plugins/jaws/jaws.md) and of the needle below, m
inline constexpr double kReach = 10e-3, kTipWidth = 0.3e-3, kBaseWidth = 1.5e-3, kLength = 6e-3;
inline constexpr double kHandleRatio = 0.2, kWire = 100e-6;

inline constexpr double kRadius =
    5e-3 / 2 / 0.92387953251128674;  // 3/8 of a circle: chord / (2 sin 67.5 deg)

/// Width of the jaws where the needle lies, m: the gripping face is a trapezium.
inline double jaw_width(double behind) { return kTipWidth + (kBaseWidth - kTipWidth) * behind / kLength; }

class Pinch {
 public:
  explicit Pinch(const PinchSetup& setup) : run_(write(setup), "") {
    needle_ = run_.body("needle");
    for (int i = 0; i < 1400 && ready(); ++i) run_.step();  // gripped after 1.1 s
    start_ = pose();
    find_grip();
  }
  bool ready() const { return run_.ready(); }
  LessonRun& run() { return run_; }
  toolkit::Pose pose() const { return toolkit::Pose(run_.world().X_WB[needle_]); }

  /// One step under a force [N] through the middle of the grip and a couple [N m], in W.
  void load(const toolkit::Vec3& f_W, const toolkit::Vec3& t_W) {
    run_.push(needle_, f_W, t_W + (grip_W_ - pose().p).cross(f_W));
    run_.step();
  }
  /// How far the needle has come since it was gripped.
  double moved() const { return (pose().p - start_.p).norm(); }                                    // m
  double turned() const { return toolkit::log_rotation(pose().q * start_.q.conjugate()).norm(); }  // rad
  double behind() const { return -grip_W_.x(); }                                                   // m
  double force() const { return run_.signal("grasp", "grasp.force"); }                             // N

 private:
  static std::string write(const PinchSetup& s) {
    const std::string folder =
        ::testing::TempDir() + "/pinch_" + ::testing::UnitTest::GetInstance()->current_test_info()->name();
    const auto text = [](double x) {
      char out[32];
      std::snprintf(out, sizeof out, "%.17g", x);
      return std::string(out);
    };
    const std::string handle = text(s.grip / kHandleRatio);
    // the open jaws come over the needle from behind: they are closed at the start of a scene
    std::ofstream(folder + ".hand") << R"({"format": "swage-hand/1", "title": "Pinch", "keys": [
      {"t": 0, "p": ["-12 mm", 0, 0], "axis": [1, 0, 0], "closing": [0, 0, 1], "closure": 0.2, "grip": 0},
      {"t": 0.1}, {"t": 0.5, "p": [0, 0, 0]}, {"t": 0.7, "closure": 0.55}, {"t": 0.9, "closure": 0.6, "grip": 0.05},
      {"t": 1.1, "grip": )" << handle
                                    << R"(}, {"t": 100}]})";
    // its plane is turned about the wire at the grip; both faces touch it at the same moment
    const toolkit::Quat q = toolkit::exp_rotation({0, s.off_flat, 0});
    const double b = jaw_width(s.behind), z = -0.5 * b * b / (8 * kRadius) * std::sin(s.off_flat);
    std::ofstream(folder + ".json")
        << R"({"format": "swage-lesson/1", "id": "test.pinch", "title": "Pinch", "gravity": [0, 0, 0],
      "devices": [{"name": "hand", "plugin": "swage.device.scripted", "params": {"file": ")"
        << folder << R"(.hand"}}],
      "objects": [{"name": "holder", "plugin": "swage.object.jaws", "pose": {"p": [-0.012, 0, 0]}, "follows": {"pose": "hand", "closure": "hand"}},
        {"name": "needle", "plugin": "swage.object.needle",
         "pose": {"p": [)"
        << text(-s.behind) << ", 0, " << text(z) << "], \"q\": [" << text(q.w()) << ", 0, " << text(q.y())
        << R"(, 0]},
         "params": {"arc": "3/8", "size_of": "chord", "size": "5 mm", "wire_diameter": "100 um")"
        << (s.needle.empty() ? "" : ", ") << s.needle << R"(}}],
      "couplings": [{"name": "touch", "plugin": "swage.coupling.contact", "between": ["holder", "needle"],
                     "params": {"friction": )"
        << text(s.friction) << R"(}},
        {"name": "grasp", "plugin": "swage.coupling.grasp", "between": ["holder", "needle"]}],
      "lesson": {"plugin": "swage.lesson.grasp", "params": {"max_time": 1000, "max_wrong_time": 0, "force": [0, 100]}}})";
    return folder + ".json";
  }

  // where the forces of the faces act in the mean, and how far behind the tips that is
  void find_grip() {
    double all = 0;
    for (const contact::Contact& c : run_.engine().contacts().contact) {
      grip_W_ += c.f_a_W.norm() * c.p_W;
      all += c.f_a_W.norm();
    }
    if (all > 0) grip_W_ /= all;
  }

  LessonRun run_;
  toolkit::Vec3 grip_W_ = toolkit::Vec3::Zero();
  uint32_t needle_ = 0;
  toolkit::Pose start_;
};

}  // namespace swage::stage
