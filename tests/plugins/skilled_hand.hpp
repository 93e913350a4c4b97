// SPDX-License-Identifier: Apache-2.0
//
// The hand with eyes before a needle that moves as the jaws hold it.
#pragma once

#include <swage/abi/sight.h>

#include <cstdio>
#include <deque>
#include <fstream>

#include "devices/skilled/plan.hpp"
#include "devices/skilled/wire.hpp"
#include "stage.hpp"

namespace swage::skilled {

using stage::Stage;
using toolkit::raw;
using toolkit::vec;

inline constexpr double kPi = 3.14159265358979323846;

/// A half circle of radius 2 mm in the plane z = 0, centre in the origin; s runs from the point at +x over +y to -x.
struct Half {
  static constexpr double kRadius = 2e-3;
  static Place at(double s) {
    const double a = kPi * s;
    return {s, kPi * kRadius, kRadius * Vec3(std::cos(a), std::sin(a), 0), Vec3(-std::sin(a), std::cos(a), 0),
            Vec3::UnitZ()};
  }
};

/// The device in front of a half circle that moves as the jaws hold it: rigidly with the hand once it is held.
class SkilledHand : public ::testing::Test {
 protected:
  void make(const std::string& acts, stage::Params params = {}) {
    path_ = ::testing::TempDir() + "swage_plan_" +
            ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".json";
    std::ofstream(path_)
        << R"({"format": "swage-plan/1", "start": {"p": ["8 mm", 0, "5 mm"], "axis": [0, 0, -1], "closing": [0, 1, 0]}, "acts": [)"
        << acts << "]}";
    params.insert_or_assign("file", path_);
    stage_ = std::make_unique<Stage>("swage.device.skilled");
    ASSERT_EQ(stage_->configure(params), SWAGE_OK);
    needle_.self = this;
    needle_.get_extension = [](swage_instance*, const char* id) -> const void* {
      static const swage_graspable table{locate};
      static const swage_piercing point{place, nullptr};
      if (std::strcmp(id, SWAGE_TRAIT_PIERCING) == 0) return &point;
      return std::strcmp(id, SWAGE_TRAIT_GRASPABLE) == 0 ? &table : nullptr;
    };
    objects_ = {{text("holder"), text("x"), 0, 0, 0, 0, &gripper_},
                {text("needle"), text("x"), 0, 0, 0, 0, &needle_}};
    gripper_.get_extension = [](swage_instance*, const char*) -> const void* { return nullptr; };
  }
  void TearDown() override { std::remove(path_.c_str()); }

  swage_result bind(bool with_force = true) {
    std::vector<swage_scene_signal> signals;
    if (with_force) signals.push_back({text("grasp"), text("grasp.force"), text("N")});
    if (pierces_) {
      signals.push_back({text("pierce"), text("pierce.s"), text("1")});
      for (const char* id : {"pierce.entry_x", "pierce.entry_y", "pierce.entry_z", "pierce.at_x",
                             "pierce.at_y", "pierce.at_z"})
        signals.push_back({text("pierce"), text(id), text("m")});
    }
    const swage_scene_card scene{sizeof(swage_scene_card),
                                 2,
                                 static_cast<uint32_t>(signals.size()),
                                 0,
                                 objects_.data(),
                                 signals.data(),
                                 nullptr,
                                 1e-3};
    const swage_scene_mark marks[] = {{SWAGE_MARK_POINT, SWAGE_NONE, text("target.point"), {1e-4, 0}},
                                      {SWAGE_MARK_POINT, SWAGE_NONE, text("other.point"), {1e-4, 0}}};
    const swage_sight_card card{sizeof(swage_sight_card), two_marks_ ? 2u : 1u, &scene, marks};
    const swage_result result = stage_->table<swage_device_sight>(SWAGE_EXT_SIGHT).bind(stage_->raw(), &card);
    EXPECT_EQ(stage_->activate(), SWAGE_OK);
    stage_->on_rt();
    return result;
  }

  /// One millisecond: it looks, answers, and the world follows.
  void step() {
    swage_object_step objects[2] = {};
    swage_view view{};
    view.n_signal = 8;
    signal_[0] = force_;
    view.signal = signal_.data();
    view.n_object = 2;
    view.object_step = objects;
    const swage_vec3 marks[] = {mark_, other_};
    const swage_sight sight{sizeof(swage_sight), two_marks_ ? 2u : 1u, &view, marks};
    ASSERT_EQ(stage_->table<swage_device_sight>(SWAGE_EXT_SIGHT).look(stage_->raw(), &sight), SWAGE_OK);
    swage_command command{};
    command.time_s = 1e-3 * n_++;
    ASSERT_EQ(stage_->table<swage_device>(SWAGE_EXT_DEVICE).exchange(stage_->raw(), &command, &sample_),
              SWAGE_OK);
    const Pose X_WT(sample_.pose);
    if (held_) X_WN_ = X_WT * X_TN_;
    X_WT_ = X_WT;
    // the jaws begin to bear the wire at closure 0.5, and have 0.6 N at 0.7
    force_ = held_ ? std::max(0.0, (sample_.closure - 0.5) * 3) : 0;
    if (!held_ && sample_.closure > 0.5) X_TN_ = X_WT.inverse() * X_WN_, held_ = true;
  }
  void run() {
    for (sample_.valid = 0; (sample_.valid & SWAGE_VALID_DONE) == 0 && n_ < 60000;) step();
  }
  Place needle_at(double s) const {
    Place p = Half::at(s);
    if (s < kKinkAt) {
      const Vec3 kink = Half::at(kKinkAt).p_W;
      const Quat q = toolkit::exp_rotation({0, 0, kink_});
      p.p_W = kink + q * (p.p_W - kink);
      p.tangent_W = q * p.tangent_W;
    }
    p.p_W = X_WN_ * p.p_W;
    p.tangent_W = X_WN_.q * p.tangent_W;
    p.normal_W = X_WN_.q * p.normal_W;
    return p;
  }

  static swage_result locate(swage_instance* i, const swage_object_step*, swage_vec3 p,
                             swage_graspable_place* out) {
    const auto& self = *static_cast<SkilledHand*>(i->self);
    const Vec3 p_N = self.X_WN_.inverse() * vec(p), kink = Half::at(kKinkAt).p_W;
    const Vec3 unbent = kink + toolkit::exp_rotation({0, 0, -self.kink_}) * (p_N - kink);
    const auto along = [](const Vec3& q, double low, double high) {
      return std::clamp(std::atan2(q.y(), q.x()) / kPi, low, high);
    };
    const Place front = self.needle_at(along(unbent, 0, kKinkAt - 1e-9)),
                rest = self.needle_at(along(p_N, kKinkAt, 1));
    const Place& at = (front.p_W - vec(p)).norm() < (rest.p_W - vec(p)).norm() ? front : rest;
    *out = {at.s, at.length, raw(at.p_W), raw(at.tangent_W), raw(at.normal_W)};
    return SWAGE_OK;
  }
  static swage_result place(swage_instance* i, const swage_object_step*, double s,
                            swage_piercing_place* out) {
    const Place at = static_cast<SkilledHand*>(i->self)->needle_at(s);
    *out = {s, at.length, 50e-6, raw(at.p_W), raw(at.tangent_W), 0, 0};
    return SWAGE_OK;
  }
  static swage_str text(const char* t) { return {t, std::strlen(t)}; }

  std::string path_;
  std::unique_ptr<Stage> stage_;
  swage_instance needle_{}, gripper_{};
  std::vector<swage_scene_object> objects_;
  Pose X_WN_{Vec3(1e-3, 0, 0), toolkit::exp_rotation({0.3, -0.2, 0.5})}, X_TN_, X_WT_;
  swage_vec3 mark_{-4e-3, 1e-3, 2e-3}, other_{};
  bool two_marks_ = false;
  static constexpr double kKinkAt = 0.3;
  double kink_ = 0;  // rad, by which what is before kKinkAt is bent
  bool pierces_ = false;
  std::array<double, 8> signal_{};  // grip force, where it is pierced, its entry, where it passes now
  double force_ = 0;
  bool held_ = false;
  int n_ = 0;
  swage_sample sample_{};
};

}  // namespace swage::skilled
