// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.free_practice: pick up objects and put them down, to get used to the instrument. See free_practice.md.
#pragma once

#include <swage/lesson.hpp>

#include <string>
#include <vector>

#include "common/card.hpp"
#include "common/watches.hpp"
#include "common/watching.hpp"

namespace swage::lesson_free_practice {

inline constexpr size_t kMostThings = 8;

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    {"practice.touches", "1", "How often a thing was touched or pushed away.", "count of grasp.touched, and of drops of what had not been touched since it last dropped", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"practice.grasps", "1", "How often a thing was taken by both jaws.", "count", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"practice.drops", "1", "How often a thing fell or was pushed away.", "count of: free and further than drop_distance from where it was left", "M07", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"practice.different", "1", "How many different things have been held.", "count", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
    lessons::kPath,
};
inline constexpr swage_metric_label kLabels[] = {
    lessons::label("time.task", "Active time", SWAGE_SHOW_QUANTITY, 1),
    lessons::label("practice.touches", "Touches", SWAGE_SHOW_COUNT),
    lessons::label("practice.grasps", "Grasps", SWAGE_SHOW_COUNT, 3),
    lessons::label("practice.drops", "Drops", SWAGE_SHOW_COUNT, 4),
    lessons::label("practice.different", "Objects held", SWAGE_SHOW_COUNT, 2, "goal", nullptr),
    lessons::kPathLabel,
};
inline constexpr swage_criterion kCriteria[] = {
    {"Hold {goal} of these for {hold_time} each: {things}.", "goal", SWAGE_CRITERION_PASS, 0},
    {"Practise until the time is over.", "!goal", SWAGE_CRITERION_PASS, 0},
    lessons::kMaxTime,
    {"Drops cost points.", nullptr, SWAGE_CRITERION_POINTS, 0},
};
inline constexpr swage_cue_info kCues[] = {
    {"thing.held", "Held by both jaws.", lessons::kHeard, 0},
};
// clang-format on

struct PracticeParams {
  std::string gripper = "holder";
  std::string things = "ball_small, ball_large, rod";
  int goal = 3;
  double hold_time = 0.5;       // s
  double max_time = 180;        // s
  double drop_distance = 2e-3;  // m
};

/// State of one object: doubles only.
struct ThingMemory {
  lessons::DropState drop;
  double start[3] = {0, 0, 0};  // m
  double held_s = 0;
  double grasped = 0;  // 0 or 1
  double touched = 0;  // 0 or 1, since it last dropped
};

struct PracticeMemory {
  lessons::PathState path;
  double begun = 0;
  double touches = 0, grasps = 0, drops = 0;
  ThingMemory thing[kMostThings];
};

class FreePractice final : public Lesson<PracticeParams> {
 public:
  static constexpr auto id = "swage.lesson.free_practice";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Free practice";
  static constexpr auto summary =
      "Touch, take and put down a few things; counts, and ends after so many different ones.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const auto& metrics = kMetrics;
  static constexpr const auto& cues = kCues;
  static constexpr const auto& labels = kLabels;
  static constexpr const auto& criteria = kCriteria;

  static constexpr std::array fields = {
      text<&PracticeParams::gripper>("gripper", "Gripper", "Name of the object that grips."),
      text<&PracticeParams::things>(
          "things", "Things",
          "Names of up to eight objects, with commas between them, in the order of their "
          "grasp couplings."),
      integer<&PracticeParams::goal>(
          "goal", "Goal", 0, 8,
          "The lesson is passed when so many different things have been held; 0: when the "
          "time is over."),
      real<&PracticeParams::hold_time>("hold_time", "Hold", "s", "s", 0, 60,
                                       "For how long a thing must be held to count."),
      real<&PracticeParams::max_time>("max_time", "Time limit", "s", "s", 1, 36000,
                                      "The attempt ends when it is over."),
      real<&PracticeParams::drop_distance>(
          "drop_distance", "Drop distance", "m", "mm", 1e-5, 1,
          "A thing has dropped when it is further than this from where it was let go.")
          .hidden(),
  };

  void build(const PracticeParams& params, LessonBuilder& builder) override;
  void bind(const Scene& scene, Binder& binder) override;
  void activate(double dt_s) override { path_ = lessons::PathWatch(dt_s); }
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override { as<PracticeMemory>(state) = {}; }

 private:
  struct Thing {
    uint32_t object = kNone, body = kNone;
    lessons::GraspSignals grasp;
  };
  void look_at(const Thing& thing, ThingMemory& memory, PracticeMemory& all, const View& view,
               const Verdict& verdict) const;
  void report(const PracticeMemory& memory, double different, double time_s, const Verdict& verdict) const;

  PracticeParams params_;
  lessons::PathWatch path_;
  lessons::DropWatch drop_;
  Peer gripper_;
  uint32_t gripper_object_ = kNone;
  std::vector<Thing> things_;
  Cue held_;
  Phase practice_, done_;
  Event dropped_, grasped_, out_of_time_;
  struct {
    Metric time, touches, grasps, drops, different, path;
  } metric_;
};

}  // namespace swage::lesson_free_practice
