// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.insertion: grasp a needle, put its point to a mark on a tissue and drive it in along its own curve. See
// insertion.md.
#pragma once

#include <swage/lesson.hpp>
#include <swage/strand.hpp>

#include <array>
#include <string>
#include <vector>

#include "card.hpp"
#include "common/watching.hpp"
#include "judge.hpp"

namespace swage::lesson_insertion {

/// Names of Task, in its order.
inline constexpr const char* kTasks[] = {"insert", "stitch", nullptr};

struct InsertionParams {
  std::string gripper = "holder", needle = "needle", tissue = "tissue";
  Task task = Task::kInsert;
  Interval target_x = {-1e-3, 1e-3}, target_y = {-1e-3, 1e-3};  // m, of the tissue's frame
  double tolerance = Rules{}.tolerance;                         // m
  double in_angle = Rules{}.in_angle;                           // rad
  double least_in_angle = Rules{}.least_in_angle;
  double drive = Rules{}.drive;
  Interval region = {Rules{}.region_low, Rules{}.region_high};
  Interval tip_zone = {Rules{}.tip_low, Rules{}.tip_high};  // m
  Interval force = {0.1, Rules{}.force_high};               // N
  double par_time = Rules{}.par_time;          // s
  double max_time = Rules{}.max_time;          // s
  double max_wound = Rules{}.max_wound;
  int max_drops = Rules{}.max_drops;
  int max_deflections = Rules{}.max_deflections;
  double drop_distance = Rules{}.drop_distance;  // m
  double lost_distance = Rules{}.lost_distance;  // m
  int stitches = 1;
  double spacing = 1e-3;                   // m
  std::array<double, 3> exit = {0, 0, 0};  // m, from the mark, in the tissue's frame; 0: no such mark
  std::string suture;                      // "": none
  double swage_zone = SutureRules{}.swage_zone, tail = 0, tail_tolerance = SutureRules{}.tail_tolerance;  // m
  double loop = 0, loop_tolerance = SutureRules{}.loop_tolerance;  // m
  double tension = 0;                                              // N
  std::string cut;                                                 // "": stitches are not cut off the thread
  std::string far, far_pierce = "far_pierce";  // "": one edge
  double step = FarRules{}.step;               // m
};

class InsertionLesson final : public Lesson<InsertionParams> {
 public:
  static constexpr auto id = "swage.lesson.insertion";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Insert a needle";
  static constexpr auto summary =
      "Take the needle, put its point to a mark on the tissue and drive it in perpendicular to it and along its own "
      "curve; as a stitch also "
      "out again, let go, taken on the other side and pulled through.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::span<const swage_metric_info> metrics{kMetrics};
  static constexpr std::span<const swage_cue_info> cues{kCues};
  static constexpr std::span<const swage_metric_label> labels{kLabels};
  static constexpr std::span<const swage_criterion> criteria{kCriteria};

  static constexpr std::array fields = {
      text<&InsertionParams::gripper>("gripper", "Gripper", "Name of the object that grips."),
      text<&InsertionParams::needle>("needle", "Needle", "Name of the needle."),
      text<&InsertionParams::tissue>("tissue", "Tissue", "Name of what it goes into."),
      choice<&InsertionParams::task>(
          "task", "Task", kTasks,
          "Insert: in until enough of it is inside. Stitch: also out, let go, taken on the other "
          "side, pulled through."),
      interval<&InsertionParams::target_x>(
          "target_x", "Mark, x", "m", "mm", -0.1, 0.1,
          "The mark is drawn evenly between these two, along x of the tissue."),
      interval<&InsertionParams::target_y>("target_y", "Mark, y", "m", "mm", -0.1, 0.1,
                                           "The same along its y."),
      real<&InsertionParams::tolerance>("tolerance", "Tolerance", "m", "mm", 1e-6, 0.1,
                                        "The point must go in within this distance from the mark."),
      real<&InsertionParams::in_angle>(
          "in_angle", "Angle", "rad", "deg", 0.5 * kDegree, 85 * kDegree,
          "Up to this angle to the tissue's normal a needle counts as perpendicular to it."),
      real<&InsertionParams::least_in_angle>(
          "least_in_angle", "Path within angle tolerance", "1", "%", 0, 1,
          "Least share of the needle's path through the surface that must be within that angle; 0: the angle costs points only."),
      real<&InsertionParams::drive>("drive", "Drive", "1", "%", 0.02, 0.95,
                                    "Share of the needle that is to be inside at the end."),
      interval<&InsertionParams::region>("region", "Region", "1", "%", 0, 1,
                                         "Where the needle is to be held, counted from its point, which is marked on it; until it goes in "
                                         "the needle shows how it is held. 0 % to 0 %: anywhere."),
      interval<&InsertionParams::tip_zone>("tip_zone", "Tip zone", "m", "mm", -0.1, 0.1,
                                           "How far the tips may reach past the needle and still count as grasping with them."),
      interval<&InsertionParams::force>(
          "force", "Force", "N", "N", 0, 100,
          "Grip force of careful hands; above it the jaws show too much force."),
      real<&InsertionParams::par_time>(
          "par_time", "Par time", "s", "s", 0.1, 3600,
          "Up to here no points are lost for time; twice this costs all that time can cost.")
          .group("Limits"),
      real<&InsertionParams::max_time>("max_time", "Time limit", "s", "s", 1, 36000,
                                       "The attempt fails when it is over.")
          .group("Limits"),
      real<&InsertionParams::max_wound>(
          "max_wound", "Wound", "1", "%", 1, 1000,
          "The attempt fails when the wound size exceeds this; 100 % is perfect.")
          .group("Limits"),
      integer<&InsertionParams::max_drops>("max_drops", "Drops", 0, 100,
                                           "The attempt fails with one drop more than this.")
          .group("Limits"),
      integer<&InsertionParams::max_deflections>("max_deflections", "Deflections", 0, 1000,
                                                 "The attempt fails with one failed puncture more than this.")
          .group("Limits"),
      real<&InsertionParams::drop_distance>(
          "drop_distance", "Drop distance", "m", "mm", 1e-5, 1,
          "The needle has dropped when it is further than this from where it was left.")
          .group("Limits")
          .hidden(),
      real<&InsertionParams::lost_distance>("lost_distance", "Lost distance", "m", "mm", 1e-3, 1,
                                            "The attempt fails when the needle lies free and further than this "
                                            "from the mark: nobody can reach it.")
          .group("Limits")
          .hidden(),
      integer<&InsertionParams::stitches>("stitches", "Stitches", 1, 8,
                                          "How many are asked for, one beside the other along the edge.")
          .group("Stitch"),
      real<&InsertionParams::spacing>("spacing", "Spacing", "m", "mm", -0.1, 0.1,
                                      "From one stitch to the next, along the edge.")
          .group("Stitch"),
      vector<&InsertionParams::exit>("exit", "Exit", "m", "mm", -0.1, 0.1,
                                     "From the mark to one where the point should come out, along x, y and z "
                                     "of the tissue; 0 0 0: there is none.")
          .group("Stitch"),
      text<&InsertionParams::suture>("suture", "Suture", "Name of the thread that is swaged to the needle; without one: none.")
          .group("Suture"),
      real<&InsertionParams::swage_zone>("swage_zone", "Swage", "m", "mm", 1e-6, 0.1,
                                         "Grasped nearer to its blunt end than this the needle is held at the swage.")
          .group("Suture"),
      real<&InsertionParams::tail>("tail", "Tail", "m", "mm", 0, 0.3,
                                   "Length of thread that is to be left before the entry; 0: it need not be drawn through.")
          .group("Suture"),
      real<&InsertionParams::tail_tolerance>("tail_tolerance", "Tail tolerance", "m", "mm", 1e-5, 0.1,
                                             "By so much the tail may be longer or shorter.")
          .group("Suture"),
      real<&InsertionParams::loop>("loop", "Loop", "m", "mm", 0, 0.3,
                                   "Thread that is to be left between a bite and the one before it, or where the thread is fixed; 0: not asked.")
          .group("Suture"),
      real<&InsertionParams::loop_tolerance>("loop_tolerance", "Loop tolerance", "m", "mm", 1e-5, 0.1,
                                             "By so much a loop may be longer or shorter.")
          .group("Suture"),
      real<&InsertionParams::tension>("tension", "Tension", "N", "mN", 0, 10,
                                      "Of the thread at the swage: above it a stitch is drawn too hard; 0: not asked.")
          .group("Suture"),
      text<&InsertionParams::cut>("cut", "Coupling of the blades", "Name of the cut coupling by which each stitch is cut off the thread, with a tail on both sides; without one: none.")
          .group("Suture"),
      text<&InsertionParams::far>("far", "Far edge", "Name of the other edge of a wound, which the same bite goes through; without one: none.")
          .group("Two edges"),
      text<&InsertionParams::far_pierce>("far_pierce", "Coupling of the far edge", "Name of the coupling by which the needle pierces the far edge.")
          .group("Two edges")
          .hidden(),
      real<&InsertionParams::step>("step", "Step", "m", "mm", 0, 0.1,
                                   "By so much the depths may differ at which the point leaves the near edge and goes into the far one; 0: not asked.")
          .group("Two edges"),
  };

  void build(const InsertionParams& params, LessonBuilder& builder) override;
  void bind(const Scene& scene, Binder& binder) override;
  void activate(double dt_s) override;
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override { as<Kept>(state) = {}; }

 private:
  /// Private numbers: the state of the judge, and the marks.
  struct Kept {
    Memory memory;
    double drawn = 0;                                     // 0 or 1
    double target[3] = {0, 0, 0}, normal[3] = {0, 0, 1};  // m, unit; W
    double exit[3] = {0, 0, 0};                           // m, W: mark of the exit
  };
  /// Signals and events of the coupling that pierces.
  struct Pierce {
    Signal state, angle, cosine, s, entry[3], wound, area_ratio, swept, below, pull, depth, exit[3];
    Signal wound_wide, exit_wound;  // not offered by every coupling
    Event entered, exited, passed, deflected;
  };

  /// Signals and events of the couplings that tie the thread to the needle and draw it through the tissue.
  struct Suture {
    Signal tension, state, tail, cut, back, pull, loop, loop_least, loop_most;
    Signal entry, exit;  // where stitches are cut off: thread from the needle to the last entry and to the last exit
    Event pulled_off, through, parted;
  };

  Pierce find_pierce(const Scene& scene, Binder& binder, const std::string& owner) const;
  void find_far(const Scene& scene, Binder& binder);
  void read_far(const View& view, const Kept& kept, const swage_gripper_state& jaws, Look& look) const;
  void report_far(const Look& look, const Memory& memory, const Verdict& verdict) const;
  bool has_far() const { return !params_.far.empty(); }
  void find_suture(const Scene& scene, Binder& binder);
  void find_cut(const Scene& scene, Binder& binder, const std::vector<std::string>& pulls);
  void read_cut(const View& view, Look& look) const;
  bool has_cut() const { return !params_.cut.empty(); }
  void read_suture(const View& view, Look& look) const;
  void show_tail(const View& view, const Kept& kept, const Verdict& verdict) const;
  void report_suture(const Memory& memory, const Verdict& verdict) const;
  void report_tails(const Memory& memory, const Verdict& verdict) const;
  void report_running(const Points& lost, const Verdict& verdict) const;
  void say_suture(const Finding& finding, const Verdict& verdict) const;
  bool draw(const View& view, Kept& kept);
  void next_mark(const View& view, Kept& kept) const;
  static Vec3 place(const View& view, const Signal (&signal)[3]);
  static Hole hole(const Peer& peer, const Step& tissue, const Vec3& p_W);
  static double exit_angle(const View& view, const Pierce& pierce);
  bool read(const View& view, const Kept& kept, Look& look) const;
  void read_pierce(const View& view, Look& look) const;
  void read_stray(const View& view, const swage_gripper_state& jaws, Look& look) const;
  void say(const Finding& finding, const Kept& kept, double time_s, const Verdict& verdict) const;
  void report(const Look& look, const Finding& finding, const Memory& memory, const Verdict& verdict) const;
  void report_points(const Points& lost, const Verdict& verdict) const;
  void report_stitches(const Look& look, const Memory& memory, const Verdict& verdict) const;
  bool has_region() const { return params_.region.high > params_.region.low; }
  bool has_exit() const { return params_.exit != std::array<double, 3>{0, 0, 0}; }
  Cue sign(Sign sign) const { return cue_[static_cast<size_t>(sign)]; }

  InsertionParams params_;
  Judge judge_;
  lessons::GraspSignals grasp_;
  Pierce pierce_, far_pierce_;
  Suture suture_;
  StrandPeer thread_;
  uint32_t thread_object_ = kNone;
  Peer gripper_, needle_, tissue_, far_;
  uint32_t gripper_object_ = kNone, gripper_body_ = kNone, needle_object_ = kNone, needle_body_ = kNone,
           tissue_object_ = kNone, tissue_body_ = kNone, far_object_ = kNone;
  Mark target_, exit_, tail_, region_;
  Metric metric_[static_cast<size_t>(Measure::kCount)];
  Cue cue_[static_cast<size_t>(Sign::kCount)];
  Phase phase_[11];                     // by Stage
  Signal bending_;
  Event dropped_, missed_, damaged_, far_first_, cut_off_, failed_[static_cast<size_t>(End::kCount)];  // by End
};

}  // namespace swage::lesson_insertion
