// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.pull: the loop of a knot is drawn until it bears a load or gives way. See pull.md.
#include <swage/lesson.hpp>
#include <swage/strand.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "card.hpp"
#include "common/declare.hpp"
#include "common/watching.hpp"
#include "loop.hpp"
#include "toolkit/math.hpp"

namespace swage::lesson_pull {

using lessons::index;
using toolkit::vec;

struct PullParams {
  std::string thread = "knot", gripper = "pin";
  double from = 0, to = 10e-3;  // m, arc length from the first end: where the loop leaves the knot on either side
  double load = 0.1;            // N
  double preload = 5e-3;        // N
  double most_opening = 3e-3;   // m
  double most_slip = 0.5e-3;    // m
  double rest_time = 0.5;       // s
  double max_time = 12;         // s
};

/// What the pull test remembers from step to step.
struct Memory {
  double begun = 0;      // 0 or 1: the loop has borne the preload
  double loop = 0;       // m, thread of the loop then
  double pin_W[3] = {};  // m, the pin that goes away then
  double bears = 0;      // N
  double slip = 0;       // m
  double opens = 0;      // m
  double turn = 0;       // number of the place at which the loop turns about that pin; 0: not known yet
};

/// The loop at this step.
struct Loop {
  double tension = 0;   // N, mean of both strands
  double length = 0;    // m, of thread; not looked for before the preload
  bool parted = false;
};

class PullLesson final : public Lesson<PullParams> {
 public:
  using P = PullParams;
  static constexpr auto id = "swage.lesson.pull";
  static constexpr auto version = "1.1.0";
  static constexpr auto name = "Pull test";
  static constexpr auto summary = "The loop of a knot is drawn apart until it bears the load, slips or breaks.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr const auto& metrics = kMetrics;
  static constexpr const auto& cues = kCues;
  static constexpr const auto& labels = kLabels;
  static constexpr const auto& criteria = kCriteria;

  static constexpr std::array fields = {
      text<&P::thread>("thread", "Thread", "Name of the thread that has the knot."),
      text<&P::gripper>("gripper", "Pin", "Name of the gripper whose closed tips are the pin that goes away."),
      real<&P::from>("from", "Loop from", "m", "mm", 0, 0.3, "Where the loop leaves the knot, from the thread's first end."),
      real<&P::to>("to", "Loop to", "m", "mm", 0, 0.3, "Where it comes back to the knot."),
      real<&P::load>("load", "Load", "N", "mN", 1e-3, 10, "Tension that the knot is to bear."),
      real<&P::preload>("preload", "Preload", "N", "mN", 0, 10, "Slip counts from this tension on: a knot settles first."),
      real<&P::most_slip>("most_slip", "Slip", "m", "mm", 1e-4, 0.1, "A knot that slips by more than this has given way."),
      real<&P::most_opening>("most_opening", "Opening", "m", "mm", 1e-4, 0.1, "A knot whose loop opens by more than this, its stretch included, has given way."),
      real<&P::rest_time>("rest_time", "Rest", "s", "s", 0, 60, "The thread comes to rest for so long before anything counts."),
      real<&P::max_time>("max_time", "Time limit", "s", "s", 1, 36000, "The attempt fails when it is over.").group("Limits"),
  };

  void build(const P& params, LessonBuilder& builder) override {
    if (!(params.from < params.to)) builder.error("to", "the loop is to end beyond where it begins");
    if (!(params.preload < params.load)) builder.error("preload", "it is to be below the load");
    builder.state<Memory>();
    lessons::declare_card(builder, kCues, cue_, kMetrics, metric_);
    rest_ = builder.phase("rest", "The thread comes to rest.");
    pull_ = builder.phase("pull", "The loop is drawn apart.");
    done_ = builder.phase("done", "The attempt is over.");
    slipped_ = builder.event("failed.slipped", "The knot has slipped; value: most that it has borne, N.");
    broke_ = builder.event("failed.broke", "The thread has parted; value: most that it has borne, N.");
    out_of_time_ = builder.event("failed.out_of_time", "The knot did not bear the load in time.");
  }

  void bind(const Scene& scene, Binder& binder) override {
    object_ = lessons::find_object(scene, binder, params().thread);
    if (object_ == kNone) return;
    strand_ = StrandPeer(Peer(scene->object[object_].instance));
    if (!strand_.valid()) binder.error(lessons::say::kNoThread(params().thread));
    pin_ = lessons::find_gripper(scene, binder, params().gripper, pin_object_);
  }

  void observe(const View& view, const Verdict& verdict, std::span<double> state) override {
    auto& memory = as<Memory>(state);
    const P& p = params();
    const auto pin = pin_.describe(view.object(pin_object_));
    if (!pin) return discard();
    verdict.phase(view.time() < p.rest_time ? rest_ : pull_);
    // a thread that was under tension where it was tied springs back in its first moments
    if (view.time() < p.rest_time) return;
    const auto loop = find_loop(view.object(object_), *pin, memory);
    if (!loop) return discard();
    look(memory, *loop, vec(pin->tip_W));
    tell(verdict, Measure::kBears, memory.bears);
    tell(verdict, Measure::kSlip, memory.slip);
    tell(verdict, Measure::kOpens, memory.opens);
    if (memory.bears >= p.load) end(verdict, memory, nullptr);
    else if (loop->parted) end(verdict, memory, &broke_);
    else if (memory.slip > p.most_slip || memory.opens > p.most_opening) end(verdict, memory, &slipped_);
    else if (view.time() >= p.max_time) end(verdict, memory, &out_of_time_);
  }

  void reset(std::span<double> state) override { as<Memory>(state) = {}; }

 private:
  /// nullopt: the thread does not answer.
  std::optional<Loop> find_loop(const Step& step, const swage_gripper_state& pin, Memory& memory) {
    const auto law = strand_.law(step);
    const int n = strand_.places(step, kLeast, kMost);
    const std::span<double> p_W(p_W_.data(), size_t{3} * static_cast<size_t>(n));
    if (!law || !strand_.line(step, p_W, {parted_.data(), static_cast<size_t>(n)})) return std::nullopt;
    const Places thread{p_W, law->length / (n - 1)};
    const auto place = [&](double s) { return std::clamp(static_cast<int>(s / thread.apart), 1, n - 2); };
    // in the loop at first, then near the place of the step before: a knot that runs brings other material to the pin
    const int last = static_cast<int>(memory.turn);
    const int turn = turn_about(thread, vec(pin.tip_W), vec(pin.axis_W), last > 0 ? std::max(1, last - kAlong) : place(params().from),
                                last > 0 ? std::min(n - 2, last + kAlong) : place(params().to));
    memory.turn = turn;
    const double at = turn * thread.apart, beside = std::max(kBeside * (params().to - params().from), kPieces * thread.apart);
    const auto before = strand_.place(step, at - beside), after = strand_.place(step, at + beside);
    if (!before || !after) return std::nullopt;
    Loop loop{0.5 * (before->tension + after->tension), 0, before->parted != 0 || after->parted != 0};
    if (memory.begun != 0 || loop.tension >= params().preload) loop.length = std::min(loop_length(thread, turn, kThroat * 2 * law->radius), law->length);
    return loop;
  }
  void look(Memory& memory, const Loop& loop, const Vec3& pin_W) const {
    Eigen::Map<Vec3> from_W(memory.pin_W);
    if (memory.begun == 0 && loop.tension >= params().preload) memory.begun = 1, memory.loop = loop.length, from_W = pin_W;
    memory.bears = std::max(memory.bears, loop.tension);
    if (memory.begun == 0) return;
    memory.slip = std::max(memory.slip, loop.length - memory.loop);
    memory.opens = std::max(memory.opens, 2 * (pin_W - from_W).norm());
  }
  void tell(const Verdict& verdict, Measure measure, double value) const { verdict.metric(metric_[index(measure)], value); }

  /// `reason`: why it failed, nullptr where the knot holds.
  void end(const Verdict& verdict, const Memory& memory, const Event* reason) const {
    verdict.phase(done_);
    verdict.cue(object_, cue_[index(reason == nullptr ? Sign::kHolds : Sign::kGivesWay)]);
    tell(verdict, Measure::kSuccess, reason == nullptr ? 1 : 0);
    if (reason == nullptr) return verdict.pass(100);
    verdict.event(*reason, memory.bears);
    verdict.fail(*reason, kMostFailed * std::clamp(memory.bears / params().load, 0.0, 1.0));
  }

  // Tension is read in both strands beside the pin, this share of the loop from where it turns, or so many of its straight pieces. Nearer: the
  // piece that lies across the pin bears next to nothing. Farther: the place is in the knot.
  static constexpr double kBeside = 0.125, kPieces = 2;
  // Distance of two strands in a knot, centre to centre, in diameters of the thread: normal 0.8 to 1.1. Larger: the loop ends where strands only
  // pass each other. Smaller: it ends inside the knot.
  static constexpr double kThroat = 1.3;
  static constexpr int kLeast = 100, kMost = 600;  // places at which the thread is looked at
  static constexpr int kAlong = 2;                 // places by which that of the turn moves in a step, at most; normal: none

  static constexpr double kMostFailed = 40;  // points, of a knot that gave way just below the load, as in other lessons

  uint32_t object_ = kNone, pin_object_ = kNone;
  StrandPeer strand_;
  Peer pin_;
  std::array<double, size_t{3} * kMost> p_W_{};  // m, places of the thread
  std::array<uint32_t, kMost> parted_{};
  Metric metric_[static_cast<size_t>(Measure::kCount)];
  Cue cue_[static_cast<size_t>(Sign::kCount)];
  Phase rest_, pull_, done_;
  Event slipped_, broke_, out_of_time_;
};

}  // namespace swage::lesson_pull

SWAGE_EXPORT(swage::lesson_pull::PullLesson)
