// SPDX-License-Identifier: Apache-2.0
// expect: static constexpr auto summary
#include "plugins.hpp"

class Ball final : public swage::Object<> {
 public:
  static constexpr auto id = "org.example.ball", version = "1.0.0", name = "Ball", author = "Somebody",
                        licence = "Apache-2.0";
  void build(const Params&, Builder& b) override { b.fixed_body("ball"); }
};
SWAGE_EXPORT(Ball)
