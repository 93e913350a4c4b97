// SPDX-License-Identifier: Apache-2.0
//
// A thread handled at random: one pair of jaws holds its end and goes about, another goes through where it lies, turns, opens and closes.
// Nothing may go through itself: a thread that bears tens of millinewtons springs by many of its diameters in a sixty-fourth of a step
// (step/substeps.cpp). SWAGE_SOAK_STEPS: how many steps (10^6 in the soak).
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "base/rng.hpp"
#include "run_lesson.hpp"
#include "test_places.hpp"

namespace swage::stage {
namespace {

using toolkit::Vec3;

class RandomHand {
 public:
  /// `turns`: by how much it turns from where it points along y and closes as the expert of 050 does.
  RandomHand(uint64_t seed, Vec3 middle, Vec3 reach, double turns)
      : random_(seed), middle_(std::move(middle)), reach_(std::move(reach)), turns_(turns) {}

  std::string key(double t, const char* more) {
    const Vec3 p = middle_ + reach_.cwiseProduct(Vec3(in(), in(), in()));
    const Vec3 axis = Vec3(turns_ * in(), 1, turns_ * in()).normalized();
    const Vec3 about(0.567 + turns_ * in(), 0, 0.824 + turns_ * in()), closing = (about - about.dot(axis) * axis).normalized();
    char text[400];
    std::snprintf(text, sizeof text,
                  ",\n { \"t\": \"%.3f s\", \"p\": [\"%.4f mm\", \"%.4f mm\", \"%.4f mm\"], \"axis\": [%.6f, %.6f, %.6f], \"closing\": [%.6f, %.6f, %.6f]%s }",
                  t, p.x(), p.y(), p.z(), axis.x(), axis.y(), axis.z(), closing.x(), closing.y(), closing.z(), more);
    return text;
  }
  /// -1 to 1.
  double in() { return 2 * random_.uniform() - 1; }

 private:
  base::Xoshiro256 random_;
  Vec3 middle_, reach_;  // mm
  double turns_;
};

/// Takes the end as the expert of 050 does, then goes anywhere with it: 1 to 40 mm/s.
std::string holder(uint64_t seed, double seconds) {
  RandomHand hand(seed, {2, -1, 7.5}, {4, 2, 2.5}, 0.2);
  std::ostringstream file;
  file << R"({ "format": "swage-hand/1", "title": "Holder", "keys": [
 { "t": "0 s", "p": ["5.99 mm", "-5 mm", "6.38 mm"], "axis": [0, 1, 0], "closing": [0.567, 0, 0.824], "closure": 0.15 },
 { "t": "0.3 s" }, { "t": "1 s", "p": ["5.99 mm", "0.8 mm", "6.38 mm"] }, { "t": "1.4 s", "closure": 0.59 },
 { "t": "1.8 s", "closure": 0.65 }, { "t": "2 s", "p": ["5.99 mm", "0.8 mm", "6.38 mm"] })";
  for (double t = 2.2; t < seconds; t += 0.55 + 0.35 * hand.in()) file << hand.key(t, "");
  file << " ] }";
  return file.str();
}

/// Goes where the thread is, closed, open, or closing on it, well above the holder: tools go through tools, and nothing has room in both.
std::string poker(uint64_t seed, double seconds) {
  RandomHand hand(seed, {0.5, 0, 14.5}, {3, 2.5, 2}, 0.25);
  std::ostringstream file;
  file << R"({ "format": "swage-hand/1", "title": "Poker", "keys": [
 { "t": "0 s", "p": ["5.99 mm", "-9 mm", "12 mm"], "axis": [0, 1, 0], "closing": [0.567, 0, 0.824], "closure": 0.15 }, { "t": "2 s" })";
  for (double t = 2.5; t < seconds; t += 0.5 + 0.3 * hand.in())
    file << hand.key(t, hand.in() < -0.3 ? ", \"closure\": 0.2" : hand.in() < 0.5 ? ", \"closure\": 0.62" : "");
  file << " ] }";
  return file.str();
}

std::string written(const std::string& name, const std::string& text) {
  const std::string path = ::testing::TempDir() + name;
  std::ofstream(path) << text;
  return path;
}

LessonRun handled(uint64_t seed, double seconds) {
  const std::string one = written("swage_handling_holder.json", holder(2 * seed, seconds)),
                    two = written("swage_handling_poker.json", poker(2 * seed + 1, seconds));
  return LessonRun(SWAGE_SOURCE_DIR "/tests/plugins/handling/handling.json", assembly::Overrides{}, [&](auto& file) {
    file.devices[0].choices[0].params = "{\"file\": \"" + one + "\"}";
    file.devices[1].choices[0].params = "{\"file\": \"" + two + "\"}";
  });
}

TEST(ThreadHandling, NothingGoesThroughItself) {
  const char* wanted = std::getenv("SWAGE_SOAK_STEPS");
  const uint64_t steps = wanted ? std::strtoull(wanted, nullptr, 10) : 20'000;
  constexpr uint64_t kEach = 20'000;  // steps of one seed: a thread that has got out of the jaws is handled no more
  uint64_t done = 0, divided = 0, held = 0, shorts = 0, passages = 0;
  for (uint64_t seed = 1; done < steps; ++seed) {
    const uint64_t n = std::min(kEach, steps - done);
    LessonRun attempt = handled(seed, 1e-3 * static_cast<double>(n));
    ASSERT_EQ(attempt.problems(), "");
    for (uint64_t i = 0; i < n; ++i) {
      attempt.step();
      held += attempt.signal("grasp", "grasp.force") > 0.01;
      if (attempt.signal("suture", "thread.passed") > 0) {
        std::printf("seed %llu: through itself at %.3f s\n", static_cast<unsigned long long>(seed), attempt.world().time());
        ++passages;
        break;
      }
    }
    EXPECT_EQ(attempt.engine().quarantined(), 0u) << seed;
    done += n, divided += attempt.engine().divided(), shorts += attempt.engine().stats().health.steps;
  }
  std::printf("%llu steps, held in %llu, %llu divided, %llu fell short\n", static_cast<unsigned long long>(done),
              static_cast<unsigned long long>(held), static_cast<unsigned long long>(divided), static_cast<unsigned long long>(shorts));
  EXPECT_EQ(passages, 0u);
  EXPECT_GT(held, done / 2) << "the thread is in the jaws";
}

}  // namespace
}  // namespace swage::stage
