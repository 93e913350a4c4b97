// SPDX-License-Identifier: Apache-2.0
#include "sticky.hpp"

namespace swage::test {

// the table is static, and its functions find the object behind the instance that they are given
const void* Pad::extension(std::string_view wanted) {
  static constexpr sticky_table table{[] (swage_instance* raw, const swage_object_step*, double temperature, double* out) {
    *out = self<Pad>(raw).strength(temperature);
    return swage_result{SWAGE_OK};
  }};
  return wanted == STICKY_TRAIT ? &table : nullptr;
}

// [rt] in the frame of the pad, so that it goes with it
void Pad::draw(const Step&, Visuals& out) {
  out.on(pad_);
  out.disc({0, 0, kRadius}, {0, 0, 1}, 0.2 * kRadius);  // where to hold it
  out.line({0, 0, kRadius}, {0, 0, 2 * kRadius}, 0);    // radius 0: as thin as can be seen
}

// the other side knows the trait and not the class
void Peel::bind(const Peer&, const Peer& b) {
  pad_ = b;
  table_ = b.trait<sticky_table>(STICKY_TRAIT);
  if (table_ == nullptr) refuse("the pad has no table of " STICKY_TRAIT);
}

void Peel::finish(const CouplingStep& step) {
  double strength = 0;
  table_->strength(pad_.raw(), step.b().raw(), 310, &strength);
  step.signal(strength_, strength);
}

}  // namespace swage::test

SWAGE_EXPORT(swage::test::Pad, swage::test::Peel)
