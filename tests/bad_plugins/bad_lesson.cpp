// SPDX-License-Identifier: Apache-2.0
//
// A lesson with one fault, FAULT: one of those in `Fault`. ID names the plugin.
#include <swage/lesson.hpp>

#include <cstdlib>
#include <ctime>
#include <limits>

namespace bad_lesson {

enum class Fault { kRemembers, kKeeps, kShares, kAllocates, kEndless, kBoasts, kSleeps };
constexpr Fault kFault = Fault::FAULT;
// faults that the step itself punishes begin after the first steps of a scene
constexpr double kGood = 0.1;  // s

class Bad final : public swage::Lesson<> {
 public:
  static constexpr auto id = ID, version = "1.0.0", name = "Bad lesson", summary = "Has one fault.",
                        author = "Swage", licence = "Apache-2.0";

  Bad() : serial_(++count_) {}

  void build(const swage::NoParams&, swage::LessonBuilder& builder) override {
    metric_ = builder.metric("number", "1", "Whatever.");
    phase_ = builder.phase("look", "Looks.");
  }
  void observe(const swage::View& view, const swage::Verdict& verdict, std::span<double>) override {
    ++looks_;
    verdict.phase(phase_);
    const bool now = view.time() >= kGood;
    if (kFault == Fault::kRemembers || kFault == Fault::kKeeps) verdict.metric(metric_, looks_);
    if (kFault == Fault::kShares) verdict.metric(metric_, serial_);
    if (kFault == Fault::kAllocates) {
      void* volatile block = std::malloc(8);
      std::free(block);
    }
    if (kFault == Fault::kSleeps) {
      const timespec two_ms{0, 2'000'000};
      nanosleep(&two_ms, nullptr);
    }
    if (kFault == Fault::kEndless && now) verdict.metric(metric_, std::numeric_limits<double>::infinity());
    if (kFault == Fault::kBoasts && now) verdict.pass(101);
  }
  void reset(std::span<double>) override {
    if (kFault == Fault::kRemembers) looks_ = 0;
  }

 private:
  static inline int count_ = 0;
  swage::Metric metric_;
  swage::Phase phase_;
  int serial_, looks_ = 0;
};

}  // namespace bad_lesson

SWAGE_EXPORT(bad_lesson::Bad)
