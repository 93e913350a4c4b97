// SPDX-License-Identifier: Apache-2.0
//
// A coupling with one fault, FAULT: one of those in `Fault`. ID names the plugin.
#include <swage/coupling.hpp>

#include <cmath>
#include <cstdlib>
#include <ctime>

namespace bad_coupling {

enum class Fault { kNegative, kPoisoned, kSleeps, kTakes, kTies, kTiePlace, kTieBody, kTieStrength, kTieForce, kVisuals, kVisualKind, kVisualBody, kVisualNumber,
                   kVisualTone, kVisualNormal, kVisualSize, kVisualStrength, kVisualMeddles, kVisualOther };
constexpr Fault kFault = Fault::FAULT;
// a fault that the step itself punishes begins after the first steps of a scene
constexpr double kGood = 0.1;  // s

class Bad final : public swage::Coupling<>, public swage::Ties {
 public:
  static constexpr auto id = ID, version = "1.0.0", name = "Bad coupling", summary = "Has one fault.",
                        author = "Swage", licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_SOLID}, needs_b{SWAGE_TRAIT_SOLID};
  static constexpr bool detects = true;

  void build(const swage::NoParams&, swage::CouplingBuilder& builder) override {
    gap_ = builder.signal("gap", "m", "Whatever.");
  }
  void resolve(const swage::CouplingStep& step) override {
    for (swage_contact& c : step.contacts()) {
      if (kFault == Fault::kNegative && step.time() >= kGood) c.friction = -1;
      if (kFault == Fault::kPoisoned) sum_ += c.gap;
    }
    if (kFault == Fault::kSleeps) {
      const timespec two_ms{0, 2'000'000};
      nanosleep(&two_ms, nullptr);
    }
    if (kFault == Fault::kTakes) {
      void* volatile block = std::malloc(8);
      std::free(block);
    }
    step.signal(gap_, 0);
    late_ = step.time() >= kGood;
  }

  uint32_t ties(const swage::CouplingStep& step, std::span<swage_tie> out) override {
    if (!is(Fault::kTies, Fault::kTieForce)) return 0;
    if (kFault == Fault::kTies) return static_cast<uint32_t>(out.size()) + 1;
    out[0] = {};
    out[0].axis_W = {0, 0, kFault == Fault::kTiePlace ? 2.0 : 1.0};
    out[0].body_a = kFault == Fault::kTieBody ? step.a()->n_body : 0;
    out[0].strength = kFault == Fault::kTieStrength ? -1 : 1;
    if (kFault == Fault::kTieForce) out[0].f_a_W.y = std::nan("");
    return 1;
  }
  void on_solved(const swage::CouplingStep&, std::span<const swage_tie>) override {}
  // by the table itself: the wrapper's list keeps within its room
  const void* extension(std::string_view wanted) override {
    static constexpr swage_visuals visuals{[](swage_instance* raw, const swage_object_step*, const swage_coupling_step* step, uint32_t capacity,
                                              swage_visual* out, uint32_t* n) -> swage_result {
      *n = swage::self<Bad>(raw).draw(*step, capacity, *out);
      return SWAGE_OK;
    }};
    return wanted == SWAGE_EXT_VISUAL ? &visuals : nullptr;
  }
  uint32_t draw(const swage_coupling_step& step, uint32_t capacity, swage_visual& out) {
    if (!is(Fault::kVisuals, Fault::kVisualOther)) return 0;
    if (kFault == Fault::kVisuals) return capacity + 1;
    if (capacity == 0) return 0;
    out = {SWAGE_VISUAL_LINE, SWAGE_NONE, 0, SWAGE_TONE_INK, {0, 0, 0}, {1e-3, 0, 0}, {0, 0, 0}, 1e-4, 1};
    if (kFault == Fault::kVisualKind) out.kind = 99;
    if (kFault == Fault::kVisualTone) out.tone = 77;
    if (kFault == Fault::kVisualNormal) out.kind = SWAGE_VISUAL_DISC;
    if (kFault == Fault::kVisualBody) out.body = step.b->n_body;
    if (kFault == Fault::kVisualNumber) out.b.y = std::nan("");
    if (kFault == Fault::kVisualSize) out.radius = -1e-4;
    if (kFault == Fault::kVisualStrength) out.strength = 1.5;
    if (kFault == Fault::kVisualMeddles) step.signal[0] += 1;
    if (kFault == Fault::kVisualOther) out.a.x = 1e-6 * ++drawn_;
    return 1;
  }
  void finish(const swage::CouplingStep& step) override {
    // what was once not finite is for ever
    if (!std::isfinite(sum_)) step.signal(gap_, 1);
  }

 private:
  bool is(Fault first, Fault last) const { return late_ && kFault >= first && kFault <= last; }

  swage::Signal gap_;
  bool late_ = false;
  double sum_ = 0, drawn_ = 0;
};

}  // namespace bad_coupling

SWAGE_EXPORT(bad_coupling::Bad)
