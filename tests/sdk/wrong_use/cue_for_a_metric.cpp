// SPDX-License-Identifier: Apache-2.0
// expect: cannot convert|no viable conversion
#include "plugins.hpp"

class Mixed final : public Watch {
  void observe(const swage::View&, const swage::Verdict& verdict, std::span<double>) override {
    verdict.metric(cue_, 1);
  }
};
SWAGE_EXPORT(Mixed)
