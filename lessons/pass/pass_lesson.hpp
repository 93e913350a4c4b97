// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.pass: pass a needle from one gripper to the other. See pass.md.
#pragma once

#include <swage/lesson.hpp>

#include <string>

#include "card.hpp"
#include "common/watching.hpp"
#include "judge.hpp"

namespace swage::lesson_pass {

struct PassParams {
  std::string first = "first", second = "second";
  std::string first_grasp = "grasp_first", second_grasp = "grasp_second";
  std::string needle = "needle";
  swage_vec3 place = {0, 0, 6e-3};                           // m, in W
  double place_radius = Rules{}.place_radius;                // m
  double share_time = Rules{}.share_time;                    // s
  int passes = Rules{}.passes;
  Interval force = {Rules{}.force_low, Rules{}.force_high};  // N
  double hold_time = Rules{}.hold_time;                      // s
  double par_time = Rules{}.par_time;                        // s
  double max_time = Rules{}.max_time;                        // s
  double max_over_time = Rules{}.max_over_time;              // s
  int max_drops = Rules{}.max_drops;
  double drop_distance = Rules{}.drop_distance;  // m
  double lost_distance = Rules{}.lost_distance;  // m
};

class PassLesson final : public Lesson<PassParams> {
 public:
  using P = PassParams;
  static constexpr auto id = "swage.lesson.pass";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Pass a needle";
  static constexpr auto summary = "Pass a needle from one gripper to the other at a place, without a moment in which nobody holds it.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const auto& metrics = kMetrics;
  static constexpr const auto& cues = kCues;
  static constexpr const auto& labels = kLabels;
  static constexpr const auto& criteria = kCriteria;

  static constexpr std::array fields = {
      text<&P::first>("first", "First gripper", "Name of one object that grips."),
      text<&P::second>("second", "Second gripper", "Name of the other object that grips."),
      text<&P::first_grasp>("first_grasp", "First grasp", "Name of the grasp coupling between the first gripper and the needle."),
      text<&P::second_grasp>("second_grasp", "Second grasp", "Name of the grasp coupling between the second gripper and the needle."),
      text<&P::needle>("needle", "Needle", "Name of the object to be passed."),
      vector<&P::place>("place", "Place", "m", "mm", -1, 1, "Where it is to be passed, in the world."),
      real<&P::place_radius>("place_radius", "Radius", "m", "mm", 1e-5, 1, "The needle is at the place when its nearest point is within this."),
      real<&P::share_time>("share_time", "Held by both", "s", "s", 0, 60, "For how long both must hold it there before one lets go."),
      integer<&P::passes>("passes", "Passes", 1, 20, "How many passes are asked for, to and fro."),
      interval<&P::force>("force", "Force", "N", "N", 0, 100, "Grip force within which the last hold counts; above it a gripper shows too much force."),
      real<&P::hold_time>("hold_time", "Hold", "s", "s", 0.01, 600, "How long the last one is to hold it alone."),
      real<&P::par_time>("par_time", "Par time", "s", "s", 0.1, 3600, "Up to here no points are lost for time; twice this costs all that time can cost.").group("Limits"),
      real<&P::max_time>("max_time", "Time limit", "s", "s", 1, 36000, "The attempt fails when it is over.").group("Limits"),
      real<&P::max_over_time>("max_over_time", "Too hard for", "s", "s", 0, 600, "The attempt fails when the needle was held too hard for longer than this.").group("Limits"),
      integer<&P::max_drops>("max_drops", "Drops", 0, 100, "The attempt fails with one drop more than this.").group("Limits"),
      real<&P::drop_distance>("drop_distance", "Drop distance", "m", "mm", 1e-5, 1, "The needle has dropped when it is further than this from where it was left.").group("Limits").hidden(),
      real<&P::lost_distance>("lost_distance", "Lost distance", "m", "mm", 1e-4, 1, "The attempt fails when the needle lies free and further than this from its start: nobody can reach it.").group("Limits").hidden(),
  };

  void build(const P& params, LessonBuilder& builder) override;
  void bind(const Scene& scene, Binder& binder) override;
  void activate(double dt_s) override;
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override { as<Memory>(state) = {}; }

 private:
  struct Hand {
    uint32_t object = kNone;
    Peer gripper;
    lessons::GraspSignals grasp;
  };
  bool read(const View& view, Look& look) const;
  void say(const Finding& finding, const Verdict& verdict) const;
  void report(const Memory& memory, double time_s, const Verdict& verdict) const;
  void report_points(const Points& lost, const Verdict& verdict) const;
  void tell(const Verdict& verdict, Measure measure, double value) const { verdict.metric(metric_[lessons::index(measure)], value); }

  Judge judge_;
  Hand hand_[kHands];
  Peer needle_;
  uint32_t needle_object_ = kNone, needle_body_ = kNone;
  Signal bending_;
  Event put_back_;
  Mark place_;
  Cue cue_[static_cast<size_t>(Sign::kCount)];
  Phase phase_[5];
  Event passed_on_, snatched_, dropped_, failed_[6];
  Metric metric_[static_cast<size_t>(Measure::kCount)];
};

}  // namespace swage::lesson_pass
