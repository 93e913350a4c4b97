// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.look: looks on for a while and judges nothing. For trying an object, a coupling or a device.
#include <swage/lesson.hpp>

namespace swage::lesson_look {

struct LookParams {
  double duration = 2;  // s
};

class Look final : public Lesson<LookParams> {
 public:
  static constexpr auto id = "swage.lesson.look", version = "1.0.0", name = "Look",
                        summary = "Looks on for a while and judges nothing; always passes.", author = "Swage",
                        licence = "Apache-2.0";
  static constexpr std::array fields = {
      real<&LookParams::duration>("duration", "Duration", "s", "s", 1e-3, 36000,
                                  "Simulated time to the end."),
  };

  void build(const LookParams&, Builder& builder) override {
    time_ = builder.metric("time.task", "s", "Simulated time that was looked at.");
    looking_ = builder.phase("look", "Watch what happens.");
  }

  void observe(const View& view, const Verdict& verdict, std::span<double>) override {
    verdict.phase(looking_);
    verdict.metric(time_, view.time());
    if (view.time() >= params().duration) verdict.pass(100);
  }

 private:
  Metric time_;
  Phase looking_;
};

}  // namespace swage::lesson_look

SWAGE_EXPORT(swage::lesson_look::Look)
