// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.pull: the loop of a knot is drawn until it bears a load or gives way. See pull.md.
#include <swage/lesson.hpp>
#include <swage/strand.hpp>

#include <algorithm>
#include <string>

#include "card.hpp"
#include "common/declare.hpp"
#include "common/watching.hpp"
#include "toolkit/math.hpp"

namespace swage::lesson_pull {

using lessons::index;
using toolkit::vec;
using toolkit::Vec3;

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
  double begun = 0;    // 0 or 1: the loop has borne the preload
  double apart = 0;    // m, distance of the material at both ends of the loop then
  double pin_W[3] = {};  // m, the pin that goes away then
  double bears = 0;    // N
  double slip = 0;     // m
  double opens = 0;    // m
};

class PullLesson final : public Lesson<PullParams> {
 public:
  using P = PullParams;
  static constexpr auto id = "swage.lesson.pull";
  static constexpr auto version = "1.0.0";
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
      real<&P::to>("to", "Loop to", "m", "mm", 0, 0.3, "Where it comes back to the knot. Its tension is read in the middle between these two."),
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
    const Step step = view.object(object_);
    const auto from = strand_.place(step, p.from), to = strand_.place(step, p.to), middle = strand_.place(step, 0.5 * (p.from + p.to));
    const auto pin = pin_.describe(view.object(pin_object_));
    if (!from || !to || !middle || !pin) return discard();
    verdict.phase(view.time() < p.rest_time ? rest_ : pull_);
    // a thread that was under tension where it was tied springs back in its first moments
    if (view.time() < p.rest_time) return;
    look(memory, (vec(from->p_W) - vec(to->p_W)).norm(), middle->tension, vec(pin->tip_W));
    tell(verdict, Measure::kBears, memory.bears);
    tell(verdict, Measure::kSlip, memory.slip);
    tell(verdict, Measure::kOpens, memory.opens);
    const bool parted = from->parted != 0 || to->parted != 0 || middle->parted != 0;
    if (memory.bears >= p.load) end(verdict, memory, nullptr);
    else if (parted) end(verdict, memory, &broke_);
    else if (memory.slip > p.most_slip || memory.opens > p.most_opening) end(verdict, memory, &slipped_);
    else if (view.time() >= p.max_time) end(verdict, memory, &out_of_time_);
  }

  void reset(std::span<double> state) override { as<Memory>(state) = {}; }

 private:
  /// `apart`: distance of the material at both ends of the loop [m]. Both strands of the loop follow the pin.
  void look(Memory& memory, double apart, double tension, const Vec3& pin_W) const {
    Eigen::Map<Vec3> from_W(memory.pin_W);
    if (memory.begun == 0 && tension >= params().preload) memory.begun = 1, memory.apart = apart, from_W = pin_W;
    memory.bears = std::max(memory.bears, tension);
    if (memory.begun == 0) return;
    memory.slip = std::max(memory.slip, apart - memory.apart);
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

  static constexpr double kMostFailed = 40;  // points, of a knot that gave way just below the load, as in other lessons

  uint32_t object_ = kNone, pin_object_ = kNone;
  StrandPeer strand_;
  Peer pin_;
  Metric metric_[static_cast<size_t>(Measure::kCount)];
  Cue cue_[static_cast<size_t>(Sign::kCount)];
  Phase rest_, pull_, done_;
  Event slipped_, broke_, out_of_time_;
};

}  // namespace swage::lesson_pull

SWAGE_EXPORT(swage::lesson_pull::PullLesson)
