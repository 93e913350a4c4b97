// SPDX-License-Identifier: Apache-2.0
// expect: state is a plain struct of doubles
#include "plugins.hpp"

class Ball final : public BallBase {
 public:
  struct State {
    std::string words;
  };
  void build(const BallParams&, Builder& b) override { b.state<State>(); }
};
SWAGE_EXPORT(Ball)
