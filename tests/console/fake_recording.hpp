// SPDX-License-Identifier: Apache-2.0
//
// A recorded attempt without physics, and a player for it. For tests of the console only.
#pragma once

#include <algorithm>
#include <limits>

#include "console/link/player.hpp"
#include "fake_session.hpp"
#include "record/store.hpp"

namespace swage::test {

/// `n` steps with four signals: a force that grows to 0.7 N, a tilt of 0.2 rad, the arc, and a constant one.
inline record::Recording fake_recording(size_t n) {
  record::Recording r;
  r.info.dt = 1e-3;
  r.info.person = "Arun P.";
  auto& s = r.info.script;
  s.signals = {{"needle", "needle.arc", "1", "Where along the arc"},
               {"grasp", "grasp.tilt_axis", "rad", "Angle away from a right-angled grasp"},
               {"grasp", "grasp.force", "N", "Force of the jaws on the needle"},
               {"grasp", "grasp.zero", "N", "Always nothing"}};
  // in a scene's order; in the file the force comes first
  std::swap(s.signals[0], s.signals[2]);
  s.metrics = {{"lesson", "force.peak", "N", "Largest force on the needle"},
               {"lesson", "odd.number", "1", "Odd"}};
  s.events = {{"grasp", "grasp.taken", "N", "The jaws hold the needle; value: the force"}};
  for (size_t i = 0; i < n; ++i) {
    r.step.push_back(i);
    r.hash.push_back(i);
    const double u = static_cast<double>(i) / static_cast<double>(std::max<size_t>(n, 2) - 1);
    r.signal.push_back(static_cast<float>(0.7 * u));
    r.signal.push_back(0.2F);
    r.signal.push_back(static_cast<float>(0.5 * u));
    r.signal.push_back(0);
  }
  if (n > 1) r.signal[1] = 0;  // the tilt starts at zero
  return r;
}

inline record::AttemptRow fake_attempt() {
  record::AttemptRow a;
  a.id = "a13";
  a.person_name = "Arun P.";
  a.lesson_id = "swage.series.grasp";
  a.lesson_title = "Grasp the needle";
  a.mode = "practice";
  a.started_utc = "2026-11-19T09:23:00Z";
  a.outcome = "passed";
  a.score = 87;
  a.simulated_s = 2;
  a.metrics = {{"force.peak", "N", 0.83}, {"odd.number", "1", 3}};
  return a;
}

inline std::vector<record::EventRow> fake_events() {
  return {{500, 0.5, "grasp", "grasp.taken", 0.4},
          {900, 0.9, "note", "Wrist not turning", 0},
          {1200, 1.2, "swage", "host.gap", 4}};
}

/// A pull, in which the tension grows to `bears_N`; before the first step it has none, as in the scene.
class FakePuller final : public console::KnotPuller {
 public:
  struct Script {
    double bears_N = 0.1, slip_m = 0.06e-3;
    bool broke = false;
    std::string no_knot;  // non-empty: why nothing can be pulled
    uint64_t steps = 10;
    double loop_m = 4.6e-3;
  };
  FakePuller(snapshot::SceneCard card, const Script& script, const console::PullWish& wish) : card_(std::move(card)), script_(script), wish_(wish) {}
  const snapshot::SceneCard& card() const override { return card_; }
  console::PulledKnot knot() const override { return {QStringLiteral("2 -1 1"), script_.loop_m, wish_.friction > 0 ? wish_.friction : 0.3}; }
  bool step(uint64_t most) override {
    at_ = std::min(at_ + most, script_.steps);
    return at_ < script_.steps;
  }
  console::PullState state() const override {
    const double share = at_ == 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(at_) / static_cast<double>(script_.steps);
    const bool over = at_ == script_.steps;
    return {over, over && script_.bears_N >= wish_.load_N, script_.broke, share * script_.bears_N, share * script_.slip_m, {}};
  }
  void fill(snapshot::Snapshot& out) const override { fake_state({}, 1e-3 * static_cast<double>(at_), out); }

 private:
  snapshot::SceneCard card_;
  const Script script_;
  const console::PullWish wish_;
  uint64_t at_ = 0;
};

/// Moves step by step like the real player; its scene is the fake session's.
class FakePlayer final : public console::Player {
 public:
  FakePlayer(snapshot::SceneCard card, uint64_t count) : card_(std::move(card)), count_(count) {}
  const snapshot::SceneCard& card() const override { return card_; }
  uint64_t at() const override { return at_; }
  uint64_t count() const override { return count_; }
  bool toward(uint64_t target, uint64_t most) override {
    target = std::min(target, count_);
    at_ = target < at_ ? target : std::min(target, at_ + most);
    return at_ == target;
  }
  void fill(snapshot::Snapshot& out) const override {
    out = {};
    out.step = at_;
    out.time_s = static_cast<double>(at_) * 1e-3;
    out.n_body = static_cast<uint32_t>(card_.start.size());
    std::copy(card_.start.begin(), card_.start.end(), out.X_WB);
    out.phase = SWAGE_NONE;
  }
  uint64_t first_difference() const override { return differs; }
  std::unique_ptr<console::KnotPuller> pull_knot(const console::PullWish& wish, base::Problems& problems) override {
    if (pull.no_knot.empty()) return std::make_unique<FakePuller>(card_, pull, wish);
    problems.push_back({base::Severity::kError, "lesson.json", pull.no_knot});
    return nullptr;
  }
  uint64_t differs = ~uint64_t{0};
  FakePuller::Script pull;

 private:
  snapshot::SceneCard card_;
  uint64_t at_ = 0, count_;
};

/// Plays the fake session's scene without a clock.
class FakeExpert final : public console::Player {
 public:
  FakeExpert(snapshot::SceneCard card, bool passes) : card_(std::move(card)), passes_(passes) {}
  const snapshot::SceneCard& card() const override { return card_; }
  uint64_t at() const override { return at_; }
  uint64_t count() const override { return 12000; }
  bool toward(uint64_t target, uint64_t most) override {
    at_ = std::min({target, at_ + most, count()});
    return at_ == target && at_ < count();
  }
  void fill(snapshot::Snapshot& out) const override {
    fake_state({}, 1e-3 * static_cast<double>(at_), out);
    if (at_ == count()) out.outcome = static_cast<uint32_t>(passes_ ? judge::Outcome::kPassed : judge::Outcome::kFailed);
  }
  uint64_t first_difference() const override { return count(); }

 private:
  snapshot::SceneCard card_;
  bool passes_;
  uint64_t at_ = 0;
};

}  // namespace swage::test
