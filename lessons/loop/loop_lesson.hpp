// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.loop: wind a thread about the tips of an instrument. See loop.md.
#pragma once

#include <swage/lesson.hpp>

#include <string>

#include "card.hpp"
#include "common/watching.hpp"
#include "judge.hpp"

namespace swage::lesson_loop {

enum class Sense : int { kEither, kRight, kLeft };

struct LoopParams {
  std::string holder = "holder", winder = "forceps";
  std::string grasp = "grasp", touch = "round", winding = "winding", knot = "knot";
  std::string thread = "suture";
  int turns = Rules{}.turns;
  Sense sense = Sense::kEither;
  double least_draw = Rules{}.least_draw;                    // N
  double tension = Rules{}.tension;                          // N
  Interval force = {Rules{}.force_low, Rules{}.force_high};  // N
  double hold_time = Rules{}.hold_time;                      // s
  double par_time = Rules{}.par_time;                        // s
  double max_time = Rules{}.max_time;                        // s
  double max_over_time = Rules{}.max_over_time;              // s
  int max_drops = Rules{}.max_drops;
};

class LoopLesson final : public Lesson<LoopParams> {
 public:
  using P = LoopParams;
  static constexpr auto id = "swage.lesson.loop";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Wind a loop";
  static constexpr auto summary = "Wind a thread about the tips of an instrument with another one, and keep it drawn: the first half of each throw.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const auto& metrics = kMetrics;
  static constexpr const auto& cues = kCues;
  static constexpr const auto& labels = kLabels;
  static constexpr const auto& criteria = kCriteria;

  static constexpr const char* kSenses[] = {"either", "right", "left", nullptr};
  static constexpr std::array fields = {
      text<&P::holder>("holder", "Holder", "Name of the gripper about which the thread is wound."),
      text<&P::winder>("winder", "Winder", "Name of the gripper that holds the thread."),
      text<&P::grasp>("grasp", "Grasp", "Name of the grasp coupling between the winder and the thread."),
      text<&P::touch>("touch", "Touch", "Name of the contact coupling between the holder and the thread."),
      text<&P::winding>("winding", "Winding", "Name of the winding coupling between the holder and the thread."),
      text<&P::knot>("knot", "Knot", "Name of the knot coupling of the thread, which notices when it goes through itself."),
      text<&P::thread>("thread", "Thread", "Name of the thread."),
      integer<&P::turns>("turns", "Turns", 1, 4, "Whole turns that are asked for."),
      choice<&P::sense>("sense", "Direction", kSenses,
                        "Right: as a right-handed screw about the holder's way from hinge to tips, from the thread's first end on."),
      real<&P::least_draw>("least_draw", "Least draw", "N", "mN", 0, 1, "The thread is drawn when it lies on the holder with this force."),
      real<&P::tension>("tension", "Limit of the pull", "N", "mN", 0.1e-3, 10, "Above this the thread pulls too hard and cuts the tissue."),
      interval<&P::force>("force", "Force", "N", "N", 0, 100, "Grip force that holds the thread without crushing it."),
      real<&P::hold_time>("hold_time", "Hold", "s", "s", 0.01, 600, "How long the turns are to be kept drawn."),
      real<&P::par_time>("par_time", "Par time", "s", "s", 0.1, 3600, "Up to here no points are lost for time; twice this costs all that time can cost.").group("Limits"),
      real<&P::max_time>("max_time", "Time limit", "s", "s", 1, 36000, "The attempt fails when it is over.").group("Limits"),
      real<&P::max_over_time>("max_over_time", "Too hard for", "s", "s", 0, 600, "The attempt fails when the thread was gripped too hard for longer than this.").group("Limits"),
      integer<&P::max_drops>("max_drops", "Drops", 0, 100, "The attempt fails when the thread got out of the jaws more often than this.").group("Limits"),
  };

  void build(const P& params, LessonBuilder& builder) override;
  void bind(const Scene& scene, Binder& binder) override;
  void activate(double dt_s) override;
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override { as<Memory>(state) = {}; }

 private:
  bool read(const View& view, Look& look) const;
  void say(const Finding& finding, const Verdict& verdict) const;
  void report(const Memory& memory, const Look& look, const Verdict& verdict) const;
  void report_held(const Memory& memory, const Verdict& verdict) const;
  void report_points(const Points& lost, const Verdict& verdict) const;
  void tell(const Verdict& verdict, Measure measure, double value) const { verdict.metric(metric_[lessons::index(measure)], value); }

  Judge judge_;
  uint32_t holder_object_ = kNone, winder_object_ = kNone, thread_object_ = kNone;
  Peer holder_, winder_;
  lessons::GraspSignals grasp_;
  Signal turns_, whole_, behind_, through_, draw_, tension_, parted_, through_itself_;
  Cue cue_[static_cast<size_t>(Sign::kCount)];
  Phase phase_[4];
  Event slipped_, dropped_, failed_[7];
  Metric metric_[static_cast<size_t>(Measure::kCount)];
};

}  // namespace swage::lesson_loop
