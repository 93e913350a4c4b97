// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.grasp: take a needle at the right place with the right force, and hold it. See grasp.md.
#pragma once

#include <swage/lesson.hpp>

#include <string>

#include "common/watching.hpp"
#include "judge.hpp"

namespace swage::lesson_grasp {

struct GraspParams {
  std::string gripper = "holder";
  std::string needle = "needle";
  Interval region = {Rules{}.region_low, Rules{}.region_high};
  Interval tip_zone = {Rules{}.tip_low, Rules{}.tip_high};  // m
  bool tips_needed = false;
  Interval force = {Rules{}.force_low, Rules{}.force_high};  // N
  double lift = 0;                                           // m
  double hold_time = 3;                                      // s
  double par_time = 20;                                      // s
  double max_time = 120;                                     // s
  double max_over_time = 2;                                  // s
  int max_drops = 2;
  double drop_distance = 2e-3;  // m
};

class GraspLesson final : public Lesson<GraspParams> {
 public:
  static constexpr auto id = "swage.lesson.grasp";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Grasp a needle";
  static constexpr auto summary =
      "Take the needle in a given region with measured force, with the tips where asked, and hold it for a "
      "while.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

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
  };

  void build(const GraspParams& params, LessonBuilder& builder) override;
  void bind(const Scene& scene, Binder& binder) override;
  void activate(double dt_s) override;
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override { as<Memory>(state) = {}; }

 private:
  void declare_cues(LessonBuilder& builder);
  void declare_metrics(LessonBuilder& builder);
  bool read(const View& view, Look& look) const;
  void say(const Finding& finding, const Verdict& verdict) const;
  void report(const Memory& memory, double time_s, const Verdict& verdict) const;

  GraspParams params_;
  Judge judge_;
  lessons::GraspSignals grasp_;
  Peer gripper_;
  uint32_t gripper_object_ = kNone, needle_object_ = kNone, needle_body_ = kNone;
  Mark region_;
  Cue cue_[5], too_hard_;                                // by Grade; the first is none
  Phase phase_[4];                                       // by Stage
  Event dropped_, hold_began_, hold_broke_, failed_[5];  // by End
  struct {
    Metric time, tries, drops, regrasps, spot_error, in_zone, tip_reach, tilt_axis, tilt_plane, balance, snap;
    Metric force, peak, over_time, over_dose, path, hold;
  } metric_;
};

}  // namespace swage::lesson_grasp
