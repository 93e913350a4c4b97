// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.grasp: grasp a needle at the right place with the right force, and hold it. See grasp.md.
#pragma once

#include <swage/lesson.hpp>

#include <string>

#include "card.hpp"
#include "common/watching.hpp"
#include "judge.hpp"

namespace swage::lesson_grasp {

struct GraspParams {
  std::string gripper = "holder";
  std::string needle = "needle";
  Interval region = {Rules{}.region_low, Rules{}.region_high};
  Interval tip_zone = {Rules{}.tip_low, Rules{}.tip_high};  // m
  bool tips_needed = false;
  double max_tilt = 0;                                      // rad
  Interval force = {Rules{}.force_low, Rules{}.force_high};  // N
  double lift = 0;                                           // m
  double hold_time = 3;                                      // s
  double par_time = 20;                                      // s
  double max_time = 120;                                     // s
  double max_over_time = 2;                                  // s
  int max_drops = 2;
  double drop_distance = 2e-3;   // m
  double max_wrong_time = 20;    // s
  double lost_distance = 30e-3;  // m
  bool carry = false;
  swage_vec3 target_centre = {0, 0, 6e-3};        // m, in W
  swage_vec3 target_spread = {2e-3, 2e-3, 1e-3};  // m
  double target_radius = 0.5e-3;                  // m
  Leave leave = Leave::kRestart;
};

class GraspLesson final : public Lesson<GraspParams> {
 public:
  static constexpr auto id = "swage.lesson.grasp";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Grasp a needle";
  static constexpr auto summary =
      "Grasp the needle in a given region with steady force, with the tips where asked, and hold it for a "
      "while.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const auto& metrics = kMetrics;
  static constexpr const auto& cues = kCues;
  static constexpr const auto& labels = kLabels;
  static constexpr const auto& criteria = kCriteria;

  static constexpr const char* kLeaves[] = {"restart", "pause", "fail", nullptr};
  static constexpr std::array fields = {
      text<&GraspParams::gripper>("gripper", "Gripper", "Name of the object that grips."),
      text<&GraspParams::needle>("needle", "Needle", "Name of the object to be taken."),
      interval<&GraspParams::region>(
          "region", "Region", "1", "%", 0, 1,
          "Where it is to be taken, from 0 at the point to 1 at the swage. Half to three "
          "quarters is taught."),
      boolean<&GraspParams::tips_needed>("tips_needed", "Tips needed",
                                         "A hold counts only with the tips of the jaws."),
      interval<&GraspParams::tip_zone>(
          "tip_zone", "Tip zone", "m", "mm", -0.1, 0.1,
          "How far the tips may reach past the needle and still count as grasping with them."),
      real<&GraspParams::max_tilt>("max_tilt", "Perpendicular to", "rad", "deg", 0, 1.5707963267948966,
                                   "A hold counts only while needle and jaws are perpendicular both ways to within "
                                   "this; 0: any tilt counts."),
      interval<&GraspParams::force>(
          "force", "Force", "N", "N", 0, 100,
          "Grip force within which a hold counts; above it the jaws show too much force."),
      real<&GraspParams::lift>("lift", "Lift", "m", "mm", 0, 1,
                               "The needle must have been moved so far from its start before a hold counts."),
      real<&GraspParams::hold_time>("hold_time", "Hold", "s", "s", 0.01, 600,
                                    "How long it is to be held without a break."),
      real<&GraspParams::par_time>(
          "par_time", "Par time", "s", "s", 0.1, 3600,
          "Up to here no points are lost for time; twice this costs all that time can cost.")
          .group("Limits"),
      real<&GraspParams::max_time>("max_time", "Time limit", "s", "s", 1, 36000,
                                   "The attempt fails when it is over.")
          .group("Limits"),
      real<&GraspParams::max_over_time>(
          "max_over_time", "Too hard for", "s", "s", 0, 600,
          "The attempt fails when the needle was held too hard for longer than this.")
          .group("Limits"),
      integer<&GraspParams::max_drops>("max_drops", "Drops", 0, 100,
                                       "The attempt fails with one drop more than this.")
          .group("Limits"),
      real<&GraspParams::drop_distance>(
          "drop_distance", "Drop distance", "m", "mm", 1e-5, 1,
          "The needle has dropped when it is further than this from where it was left.")
          .group("Limits")
          .hidden(),
      real<&GraspParams::max_wrong_time>("max_wrong_time", "Wrong for", "s", "s", 0, 3600,
                                         "The attempt fails when the needle was held outside the region for "
                                         "longer than this without a break; "
                                         "0: never.")
          .group("Limits"),
      real<&GraspParams::lost_distance>("lost_distance", "Lost distance", "m", "mm", 1e-4, 1,
                                        "The attempt fails when the needle lies free and further than this "
                                        "from its start: nobody can reach it.")
          .group("Limits")
          .hidden(),
      boolean<&GraspParams::carry>(
          "carry", "Carry to a target",
          "The hold is to take place at a target, drawn anew from the seed of the attempt.")
          .group("Target"),
      vector<&GraspParams::target_centre>("target_centre", "Target region", "m", "mm", -1, 1,
                                          "Middle of the box in which the target is drawn, in the world.")
          .group("Target"),
      vector<&GraspParams::target_spread>("target_spread", "Half size", "m", "mm", 0, 1,
                                          "Half the edges of that box; 0: always its middle.")
          .group("Target"),
      real<&GraspParams::target_radius>("target_radius", "Radius", "m", "mm", 1e-5, 0.1,
                                        "The needle is at the target when its nearest place is within this.")
          .group("Target"),
      choice<&GraspParams::leave>("leave", "On leaving", kLeaves,
                                  "What leaving the target during the hold does: it starts again, it goes on "
                                  "at the next entry, or the "
                                  "attempt fails.")
          .group("Target"),
  };

  void build(const GraspParams& params, LessonBuilder& builder) override;
  void bind(const Scene& scene, Binder& binder) override;
  void activate(double dt_s) override;
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override { as<Memory>(state) = {}; }

 private:
  void declare(LessonBuilder& builder);
  bool read(const View& view, Look& look, TargetState& target);
  void draw(TargetState& target);
  void say(const Finding& finding, const TargetState& target, const Verdict& verdict) const;
  void report(const Memory& memory, double time_s, const Verdict& verdict) const;
  void report_grasps(const Memory& memory, const Verdict& verdict) const;
  void report_hold(const Memory& memory, const Verdict& verdict) const;
  void report_points(const Points& lost, const Verdict& verdict) const;

  GraspParams params_;
  Judge judge_;
  lessons::GraspSignals grasp_;
  Peer gripper_, needle_;
  uint32_t gripper_object_ = kNone, needle_object_ = kNone, needle_body_ = kNone;
  Signal bending_;
  Event put_back_;
  Mark region_, target_;
  Cue cue_[static_cast<size_t>(Sign::kCount)];           // by Sign
  Phase phase_[7];                                       // by Stage
  Event dropped_, hold_began_, hold_broke_, failed_[8];  // by End
  Metric metric_[static_cast<size_t>(Measure::kCount)];  // by Measure
};

}  // namespace swage::lesson_grasp
