// SPDX-License-Identifier: Apache-2.0
// expect: read-only|returns a const value
#include "plugins.hpp"

class Pusher final : public Watch {
  void observe(const swage::View& view, const swage::Verdict&, std::span<double>) override {
    view.pose(0).p.z = 1;
  }
};
SWAGE_EXPORT(Pusher)
