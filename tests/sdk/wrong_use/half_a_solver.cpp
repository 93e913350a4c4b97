// SPDX-License-Identifier: Apache-2.0
// expect: abstract
#include "plugins.hpp"

class Ball final : public BallBase, public swage::Solver {
 public:
  void advance(const swage::Step&) override {}
  void mobility(const swage::Step&, std::span<const swage_contact_point>, double*, double*) override {}
};
SWAGE_EXPORT(Ball)
