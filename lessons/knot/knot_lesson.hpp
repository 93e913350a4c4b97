// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.knot: tie throws on the two edges of a wound. See knot.md.
#pragma once

#include <swage/lesson.hpp>
#include <swage/strand.hpp>

#include <string>

#include "card.hpp"
#include "common/watching.hpp"
#include "judge.hpp"
#include "work.hpp"

namespace swage::lesson_knot {

struct KnotLessonParams {
  std::string holder = "holder", winder = "forceps";
  std::string grasp = "grasp", tail_grasp = "tail_grasp", winding = "winding", knot = "knot";
  std::string thread = "suture", left = "left_edge", right = "right_edge";
  std::string left_stitch = "left_stitch", right_stitch = "right_stitch";
  std::string word = "1";
  double gap = 0.4e-3;                                       // m
  double most_gap = Rules{}.most_gap;                        // m
  double most_loop = Rules{}.most_loop;                      // m
  double most_throw = Rules{}.most_throw;                    // m
  int most_sliding = Rules{}.most_sliding;
  double tension = Rules{}.tension;                          // N
  double most_cut = Rules{}.most_cut;                        // m
  Interval force = {Rules{}.force_low, Rules{}.force_high};  // N
  double hold_time = Rules{}.hold_time;                      // s
  std::string cut;
  double tail = Rules{}.tail;                                // m
  double tail_tolerance = Rules{}.tail_tolerance;            // m
  double par_time = Rules{}.par_time;                        // s
  double max_time = Rules{}.max_time;                        // s
  double max_over_time = Rules{}.max_over_time;              // s
  double wrong_time = Rules{}.wrong_time;                    // s
  double slack = Rules{}.slack;                              // N
  double retake_time = Rules{}.retake_time;                  // s
  int max_drops = Rules{}.max_drops;
};

class KnotLesson final : public Lesson<KnotLessonParams> {
 public:
  using P = KnotLessonParams;
  static constexpr auto id = "swage.lesson.knot";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Tie a knot";
  static constexpr auto summary =
      "Tie the throws of a knot on the two edges of a wound with two instruments, flat and drawn down until the edges come together.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const auto& metrics = kMetrics;
  static constexpr const auto& cues = kCues;
  static constexpr const auto& labels = kLabels;
  static constexpr const auto& criteria = kCriteria;

  static constexpr std::array fields = {
      text<&P::holder>("holder", "Holder", "Name of the gripper about which the thread is wound and that takes the tail."),
      text<&P::winder>("winder", "Winder", "Name of the gripper that winds the thread."),
      text<&P::grasp>("grasp", "Grasp", "Name of the grasp coupling between the winder and the thread."),
      text<&P::tail_grasp>("tail_grasp", "Grasp of the tail", "Name of the grasp coupling between the holder and the thread."),
      text<&P::winding>("winding", "Winding", "Name of the winding coupling between the holder and the thread."),
      text<&P::knot>("knot", "Knot", "Name of the knot coupling of the thread."),
      text<&P::thread>("thread", "Thread", "Name of the thread."),
      text<&P::left>("left", "Left edge", "Name of the tissue on one side of the wound, on a mount."),
      text<&P::right>("right", "Right edge", "Name of the tissue on the other side, on a mount."),
      text<&P::left_stitch>("left_stitch", "Stitch on the left", "Name of the pull-through coupling between the thread and the left edge, where the tail is."),
      text<&P::right_stitch>("right_stitch", "Stitch on the right", "Name of the pull-through coupling between the thread and the right edge."),
      text<&P::word>("word", "Word", "Throws that are asked for, in their order: turns of each with their sign, \"1\" a half knot, \"1 -1\" a square knot, \"2 -1 1\" a surgeon's."),
      real<&P::gap>("gap", "Gap", "m", "mm", 0, 5e-3, "Between the edges at rest."),
      real<&P::most_gap>("most_gap", "Edges together", "m", "mm", 0, 5e-3, "Distance of the edges that counts as together."),
      real<&P::most_loop>("most_loop", "Drawn down", "m", "mm", 0.1e-3, 0.1, "Length of the loop around the tissue that counts as drawn down."),
      real<&P::most_throw>("most_throw", "Throw drawn down", "m", "mm", 0.1e-3, 0.1, "Thread that one strand takes in a throw, from the throw before it on, that counts as drawn down."),
      integer<&P::most_sliding>("most_sliding", "Sliding throws", 0, 12, "So many throws may have a strand that runs straight through."),
      real<&P::tension>("tension", "Limit of the tension", "N", "mN", 0.1e-3, 10, "Above this the stitch is too tight: tissue blanches and is cut."),
      real<&P::most_cut>("most_cut", "Limit of the cut", "m", "mm", 1e-6, 10e-3, "The attempt fails when the thread has cut the tissue farther than this."),
      interval<&P::force>("force", "Force", "N", "N", 0, 100, "Grip force that holds the thread without crushing it."),
      real<&P::hold_time>("hold_time", "Hold", "s", "s", 0.01, 600, "How long the knot is to be kept as it is asked for."),
      text<&P::cut>("cut", "Cut", "Name of the cut coupling by which both ends are cut off, as long as a tail is to be; without one: they are not."),
      real<&P::tail>("tail", "Tail", "m", "mm", 0.1e-3, 0.1, "Thread that is to be left of each end at the knot."),
      real<&P::tail_tolerance>("tail_tolerance", "Tolerance of the tail", "m", "mm", 0.01e-3, 0.1, "By so much an end may be longer or shorter."),
      real<&P::par_time>("par_time", "Par time", "s", "s", 0.1, 3600, "Up to here no points are lost for time; twice this costs all that time can cost.").group("Limits"),
      real<&P::max_time>("max_time", "Time limit", "s", "s", 1, 36000, "The attempt fails when it is over.").group("Limits"),
      real<&P::max_over_time>("max_over_time", "Too hard for", "s", "s", 0, 600, "The attempt fails when the thread was gripped too hard for longer than this.").group("Limits"),
      real<&P::wrong_time>("wrong_time", "Wrong for", "s", "s", 0.1, 600, "The attempt fails when another knot with all its throws has been there for this long.").group("Limits"),
      real<&P::slack>("slack", "Laid down below", "N", "mN", 0, 10, "A long end that the hand lets go of between two throws, with nothing wound, is laid down and not dropped when its tension is below this: one that is drawn springs out of the jaws.").group("Limits"),
      real<&P::retake_time>("retake_time", "Taken anew within", "s", "s", 0, 600, "A long end that was laid down and is not held again after this time is dropped.").group("Limits"),
      integer<&P::max_drops>("max_drops", "Drops", 0, 100, "The attempt fails when the thread got out of the jaws more often than this.").group("Limits"),
  };

  void build(const P& params, LessonBuilder& builder) override;
  void bind(const Scene& scene, Binder& binder) override;
  void activate(double dt_s) override;
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override { as<Kept>(state) = {}; }

 private:
  /// Objects and signals of one side of the wound.
  struct Side {
    uint32_t tissue = kNone;
    uint32_t body = kNone;
    Signal shift, state, tail, tension, cut, out;
  };
  /// Private numbers: what the judge remembers, and what is told beside.
  struct Kept {
    Memory memory;
    WorkState work;
  };
  void find_knot(const Scene& scene, Binder& binder);
  double long_tension(const View& view) const;
  void read_knot(const View& view, Look& look) const;
  bool has_cut() const { return !params().cut.empty(); }
  void show_ends(const View& view, const Look& look, const Memory& memory, const Verdict& verdict) const;
  bool read(const View& view, Look& look) const;
  void follow_work(const View& view, const Look& look, Kept& kept) const;
  double air_gap(const View& view, double loop) const;
  void say(const Finding& finding, const Verdict& verdict) const;
  void tell_end(const Finding& finding, const Verdict& verdict) const;
  void report(const Memory& memory, const Look& look, const Verdict& verdict) const;
  void report_work(const WorkState& work, const Verdict& verdict) const;
  void report_held(const Memory& memory, const Verdict& verdict) const;
  void report_points(const Points& lost, const Verdict& verdict) const;
  void tell(const Verdict& verdict, Measure measure, double value) const { verdict.metric(metric_[lessons::index(measure)], value); }

  Judge judge_;
  Word asked_;
  uint32_t gripper_object_[2] = {kNone, kNone}, thread_object_ = kNone;  // winder, holder
  Peer gripper_[2];
  StrandPeer strand_;
  lessons::GraspSignals grasp_[2];
  Side side_[2];  // left, right
  Signal turns_, through_, through_itself_, throws_, throw_[kThrows], kind_, sliding_, loop_, from_, to_, loosest_, parted_, squeeze_;
  Cue cue_[static_cast<size_t>(Sign::kCount)];
  Phase phase_[8];
  Event dropped_, undone_, cut_off_, cut_, failed_[12];
  Mark end_[2];  // where the long end and the tail are to be cut
  Metric metric_[static_cast<size_t>(Measure::kCount)];
};

}  // namespace swage::lesson_knot
