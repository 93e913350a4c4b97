// SPDX-License-Identifier: Apache-2.0
// expect: dynamic_body
#include "plugins.hpp"

class Touch final : public swage::Coupling<>, public Said {
 public:
  static constexpr std::array needs_a{SWAGE_TRAIT_SOLID}, needs_b{SWAGE_TRAIT_SOLID};
  static constexpr bool detects = true;
  void build(const Params&, Builder& b) override { b.dynamic_body("mine", {1, {1, 1, 1}}); }
};
SWAGE_EXPORT(Touch)
