// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.ring: carry a ring along a bent wire and over posts without touching them. See ring.md.
#pragma once

#include <swage/lesson.hpp>

#include <string>
#include <vector>

#include "card.hpp"
#include "common/watching.hpp"
#include "judge.hpp"

namespace swage::lesson_ring {

struct RingParams {
  std::string gripper = "holder", ring = "ring", wire = "wire";
  std::string posts;    // names with commas between them
  std::string touches;  // names of couplings, likewise
  Interval course = {0, 1};
  Interval force = {0.05, 1};  // N
  double par_time = 40;        // s
  double max_time = 180;       // s
  double max_over_time = 2;    // s
  int max_touches = 10;
  int max_drops = 2;
  double drop_distance = 2e-3;   // m
  double lost_distance = 30e-3;  // m
};

class RingLesson final : public Lesson<RingParams> {
 public:
  static constexpr auto id = "swage.lesson.ring";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Ring on a wire";
  static constexpr auto summary =
      "Carry a ring along a bent wire and over posts without touching them.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const auto& metrics = kMetrics;
  static constexpr const auto& cues = kCues;
  static constexpr const auto& labels = kLabels;
  static constexpr const auto& criteria = kCriteria;

  static constexpr std::array fields = {
      text<&RingParams::gripper>("gripper", "Gripper", "Name of the object that grips."),
      text<&RingParams::ring>("ring", "Ring", "Name of the ring: anything graspable that is round."),
      text<&RingParams::wire>("wire", "Wire", "Name of the wire that goes through the ring."),
      text<&RingParams::posts>(
          "posts", "Posts",
          "Names of up to four posts, with commas between them, over which the ring is to be lowered in this "
          "order. None: the wire is all."),
      text<&RingParams::touches>("touches", "Touches",
                                 "Names of the contact couplings whose touches count, with commas between them."),
      interval<&RingParams::course>("course", "Course", "1", "%", 0, 1,
                                    "The part of the wire along which the ring is to go, from its start to its free end."),
      interval<&RingParams::force>("force", "Force", "N", "N", 0, 100,
                                   "Grip force of careful hands; above it the jaws show too much force."),
      real<&RingParams::par_time>("par_time", "Par time", "s", "s", 0.1, 3600,
                                  "Up to here no points are lost for time; twice this costs all that time can cost.")
          .group("Limits"),
      real<&RingParams::max_time>("max_time", "Time limit", "s", "s", 1, 36000,
                                  "The attempt fails when it is over.")
          .group("Limits"),
      real<&RingParams::max_over_time>("max_over_time", "Too hard for", "s", "s", 0, 600,
                                       "The attempt fails when the ring was held too hard for longer than this.")
          .group("Limits"),
      integer<&RingParams::max_touches>("max_touches", "Touches allowed", 0, 1000,
                                        "The attempt fails with one touch more than this.")
          .group("Limits"),
      integer<&RingParams::max_drops>("max_drops", "Drops", 0, 100,
                                      "The attempt fails with one drop more than this.")
          .group("Limits"),
      real<&RingParams::drop_distance>("drop_distance", "Drop distance", "m", "mm", 1e-5, 1,
                                       "The ring has dropped when it is further than this from where it was left.")
          .group("Limits")
          .hidden(),
      real<&RingParams::lost_distance>("lost_distance", "Lost distance", "m", "mm", 1e-4, 1,
                                       "The attempt fails when the ring lies free and further than this from its "
                                       "start: nobody can reach it.")
          .group("Limits")
          .hidden(),
  };

  void build(const RingParams& params, LessonBuilder& builder) override;
  void bind(const Scene& scene, Binder& binder) override;
  void activate(double dt_s) override;
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override { as<Memory>(state) = {}; }

 private:
  /// The wire, a post or the ring itself.
  struct Thing {
    uint32_t object = kNone;
    Peer peer;
  };
  Thing find_thing(const Scene& scene, Binder& binder, const std::string& name) const;
  void find_touches(const Scene& scene, Binder& binder);
  bool read(const View& view, const Memory& memory, Look& look) const;
  bool see(const View& view, const Thing& thing, const Vec3& axis_W, Look& look, Line& line) const;
  bool next_place(const View& view, const Memory& memory, swage_vec3& p_W) const;
  Vec3 end_of_wire(const View& view, const Vec3& from_W) const;
  void say(const View& view, const Memory& memory, const Finding& finding, const Verdict& verdict) const;
  void report(const Memory& memory, double time_s, const Verdict& verdict) const;
  void report_points(const Points& lost, const Verdict& verdict) const;

  RingParams params_;
  Judge judge_;
  lessons::GraspSignals grasp_;
  Peer gripper_;
  uint32_t gripper_object_ = kNone, ring_body_ = kNone;
  Thing ring_, wire_;
  std::vector<Thing> posts_;
  std::vector<Signal> touch_;
  Mark target_;
  Cue cue_[static_cast<size_t>(Sign::kCount)];           // by Sign
  Phase phase_[4];                                       // by Stage
  Event dropped_, touched_, post_done_, failed_[7];      // by End
  Metric metric_[static_cast<size_t>(Measure::kCount)];  // by Measure
};

}  // namespace swage::lesson_ring
