// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.fault: which knot is it, and does it hold? See fault.md.
#pragma once

#include <swage/lesson.hpp>
#include <swage/strand.hpp>

#include <string>
#include <vector>

#include "card.hpp"
#include "common/watching.hpp"
#include "judge.hpp"

namespace swage::lesson_fault {

struct FaultParams {
  std::string gripper = "holder", assistant = "assistant";
  std::string threads = "knot";
  swage_vec3 answer_place = {-6e-3, 3e-3, 1e-3};  // m, W
  swage_vec3 answer_step = {0, -2e-3, 0};         // m, W
  double answer_reach = 1e-3;                     // m
  int least_right = 1;
  double show_time = Rules{}.show_time, tell_time = Rules{}.tell_time;              // s
  double load = Rules{}.load;                                                       // N
  double hold_time = Rules{}.hold_time, pull_time = Rules{}.pull_time;              // s
  double most_opening = Rules{}.most_opening;                                       // m
  double par_time = Rules{}.par_time, max_time = Rules{}.max_time;                  // s
};

class FaultLesson final : public Lesson<FaultParams> {
 public:
  using P = FaultParams;
  static constexpr auto id = "swage.lesson.fault";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Find the fault";
  static constexpr auto summary = "Knots are shown one after another: say whether each is square, a granny, slides or has a loose first throw; then it is pulled.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr const auto& metrics = kMetrics;
  static constexpr const auto& cues = kCues;
  static constexpr const auto& labels = kLabels;
  static constexpr const auto& criteria = kCriteria;

  static constexpr std::array fields = {
      text<&P::gripper>("gripper", "Gripper", "Name of the object that answers."),
      text<&P::assistant>("assistant", "Assistant", "Name of the gripper that pulls."),
      text<&P::threads>("threads", "Threads", "Names of the threads in which the knots are tied, in the order of the questions; each tells its thread.shape: 1 square, 2 granny, 3 sliding, 4 loose."),
      vector<&P::answer_place>("answer_place", "Answers", "m", "mm", -1, 1, "Where \"square\" is answered."),
      vector<&P::answer_step>("answer_step", "Next answer", "m", "mm", -1, 1, "From there to where \"granny\" is answered, on to \"sliding\" and to \"loose\"."),
      real<&P::answer_reach>("answer_reach", "Reach", "m", "mm", 1e-4, 0.1, "How near the tips must be to one of these places."),
      integer<&P::least_right>("least_right", "Right answers", 1, 16, "The attempt is passed with so many."),
      real<&P::show_time>("show_time", "Viewing time", "s", "s", 0.05, 60, "From the mark on a knot to the question."),
      real<&P::tell_time>("tell_time", "Feedback time", "s", "s", 0.05, 60, "For which the cue says whether the answer was right."),
      real<&P::load>("load", "Load", "N", "mN", 1e-3, 10, "Tension that a knot is to bear."),
      real<&P::hold_time>("hold_time", "Hold", "s", "s", 0.01, 60, "How long it is to bear that."),
      real<&P::pull_time>("pull_time", "Pull", "s", "s", 0.1, 600, "A knot that does not bear the load within this time has given way."),
      real<&P::most_opening>("most_opening", "Opening", "m", "mm", 1e-4, 0.1, "A knot whose loop opens by more than this has given way."),
      real<&P::par_time>("par_time", "Par time", "s", "s", 0.1, 3600, "Up to here no points are lost for time; twice this costs all that time can cost.").group("Limits"),
      real<&P::max_time>("max_time", "Time limit", "s", "s", 1, 36000, "The attempt fails when it is over.").group("Limits"),
  };

  void build(const P& params, LessonBuilder& builder) override;
  void bind(const Scene& scene, Binder& binder) override;
  void activate(double dt_s) override;
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override { as<Memory>(state) = {}; }

 private:
  /// A thread with a knot.
  struct Specimen {
    uint32_t object = kNone;
    StrandPeer strand;
    Signal tension, shape;
  };
  bool read(const View& view, const Memory& memory, Look& look) const;
  Vec3 answer_W(size_t i) const;
  void show(const View& view, const Memory& memory, const Look& look, const Finding& finding, const Verdict& verdict) const;
  void say(const Memory& memory, const Look& look, const Finding& finding, const Verdict& verdict) const;
  void report(const Memory& memory, const Finding& finding, double time_s, const Verdict& verdict) const;
  void tell(const Verdict& verdict, Measure measure, double value) const { verdict.metric(metric_[lessons::index(measure)], value); }

  Judge judge_;
  std::vector<std::string> names_;
  std::vector<Specimen> specimen_;
  Peer gripper_, assistant_;
  uint32_t gripper_object_ = kNone, assistant_object_ = kNone;
  Mark shown_, pull_, answer_[kKnots];
  Metric metric_[static_cast<size_t>(Measure::kCount)];
  Cue cue_[static_cast<size_t>(Sign::kCount)];
  Phase phase_[5];         // by Stage, but for kPull
  Phase pulled_[kKnots];   // by Knot: kPull, once a knot was named
  Event failed_[4];        // by End
  Event answered_, held_, gave_way_;
};

}  // namespace swage::lesson_fault
