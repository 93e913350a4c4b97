// SPDX-License-Identifier: Apache-2.0
//
// A coupling with one fault, FAULT: one of those in `Fault`. ID names the plugin.
#include <swage/coupling.hpp>

#include <cmath>

namespace bad_coupling {

enum class Fault { kNegative, kPoisoned };
constexpr Fault kFault = Fault::FAULT;
// a fault that the step itself punishes begins after the first steps of a scene
constexpr double kGood = 0.1;  // s

class Bad final : public swage::Coupling<> {
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
    step.signal(gap_, 0);
  }
  void finish(const swage::CouplingStep& step) override {
    // what was once not finite is for ever
    if (!std::isfinite(sum_)) step.signal(gap_, 1);
  }

 private:
  swage::Signal gap_;
  double sum_ = 0;
};

}  // namespace bad_coupling

SWAGE_EXPORT(bad_coupling::Bad)
