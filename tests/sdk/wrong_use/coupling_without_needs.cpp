// SPDX-License-Identifier: Apache-2.0
// expect: a coupling lists the traits it needs
#include "plugins.hpp"

class Touch final : public swage::Coupling<>, public Said {
 public:
  static constexpr bool detects = true;
};
SWAGE_EXPORT(Touch)
