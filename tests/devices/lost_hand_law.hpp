// SPDX-License-Identifier: Apache-2.0
//
// The law of lost hands, read from a record: the hand goes as it was led, the tool goes as its samples go, and neither leaps where a
// hand is met again (step/hands.cpp). No clock of this machine enters, so that a test that was held up finds nothing that is not there.
#pragma once

#include <swage/abi/device.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace swage::test {

/// Where the person's hand was, from `wall_s` on.
struct LedPoint {
  double wall_s = 0, x = 0, closure = 0;  // s, m of the tool, 0..1
};

/// Where the tool was seen: the picture was there at `wall_s`.
struct ToolLook {
  uint64_t step = 0;   // number of steps that had been made: the last one is step - 1
  double wall_s = 0;
  swage_vec3 p{};  // m
};

/// What the step saw of one device, one sample per step from `first` on.
struct HeardHand {
  uint64_t first = 0;
  double dt = 1e-3, scale = 1;  // s; hand over tool
  std::vector<swage_sample> sample;
};

constexpr double kLostS = 0.1;   // s without a valid sample after which a hand is met anew
constexpr double kMetWithin = 0.02;  // closure at which a returning hand has met the one that is held
constexpr int kSettling = 100;   // steps in which closing jaws have followed their handle

inline double way(const swage_vec3& a, const swage_vec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// For each step, the sum of what the hand moved the tool until then, m: a hand that comes back after it was lost moves nothing at once.
inline std::vector<double> led_way(const HeardHand& hand) {
  std::vector<double> sum;
  const swage_sample* last = nullptr;
  double total = 0;
  uint64_t gone = 0;
  for (const swage_sample& s : hand.sample) {
    if (!(s.valid & SWAGE_VALID_POSE)) {
      ++gone;
    } else {
      if (last != nullptr && static_cast<double>(gone) * hand.dt < kLostS - 1e-9) total += way(s.pose.p, last->pose.p) / hand.scale;
      last = &s;
      gone = 0;
    }
    sum.push_back(total);
  }
  return sum;
}

/// Longest way of the tool between two looks that its samples do not explain, m. `lag`: steps that it may follow behind.
inline double tool_leap(const HeardHand& hand, const std::vector<ToolLook>& looks, uint64_t lag = 5) {
  const std::vector<double> sum = led_way(hand);
  double most = 0;
  for (std::size_t i = 1; i < looks.size(); ++i) {
    const uint64_t begin = looks[i - 1].step - std::min(lag + 1, looks[i - 1].step), end = looks[i].step - 1;
    if (looks[i].step <= hand.first || end - hand.first >= sum.size()) continue;
    const uint64_t from = std::max(hand.first, begin) - hand.first, to = end - hand.first;
    most = std::max(most, way(looks[i].p, looks[i - 1].p) - (sum[to] - sum[from]));
  }
  return most;
}

/// For each step, the sum of the changes of closure that the hand asked for until then.
inline std::vector<double> closed_way(const HeardHand& hand) {
  std::vector<double> sum;
  const swage_sample* last = nullptr;
  double total = 0;
  uint64_t gone = 0;
  bool meeting = false;
  for (const swage_sample& s : hand.sample) {
    if (!(s.valid & SWAGE_VALID_CLOSURE)) {
      ++gone;
    } else {
      const bool lost = static_cast<double>(gone) * hand.dt >= kLostS - 1e-9;
      if (last != nullptr && !lost) total += std::abs(s.closure - last->closure);
      // once after each return, wherever the two meet
      if (lost && !meeting) total += kMetWithin;
      meeting = lost;
      last = &s;
      gone = 0;
    }
    sum.push_back(total);
  }
  return sum;
}

/// Greatest change of the grip's force within 20 steps that the hand's closures do not explain, N. `gain`: N per unit of closure; a
/// spring that settles overshoots by at most as much again. `came`: steps before the jaws have come to the hand.
inline double grip_leap(const HeardHand& hand, const std::vector<double>& grip, double gain, std::size_t came = 0) {
  const std::vector<double> sum = closed_way(hand);
  double most = 0;
  for (std::size_t to = came + 20; to < grip.size() && to < sum.size(); ++to) {
    const std::size_t from = to < kSettling ? 0 : to - kSettling;
    most = std::max(most, std::abs(grip[to] - grip[to - 20]) - 2 * gain * (sum[to] - sum[from]));
  }
  return most;
}

/// Number of new samples of a hand led by speeds that went further than `top` [m/s of the tool] goes between their stamps, where one
/// exchange after a pause counts as 50 ms at most (rate/rate_hand.hpp).
inline int faster_than_led(const HeardHand& hand, double top) {
  const swage_sample* last = nullptr;
  int leaps = 0;
  for (const swage_sample& s : hand.sample) {
    if (!(s.valid & SWAGE_VALID_POSE) || (last != nullptr && s.sequence == last->sequence)) continue;
    if (last != nullptr) {
      const double time = std::min(s.time_s - last->time_s, 0.05 * static_cast<double>(s.sequence - last->sequence));
      leaps += way(s.pose.p, last->pose.p) / hand.scale > top * time * (1 + 1e-9) + 1e-9;
    }
    last = &s;
  }
  return leaps;
}

/// Greatest change of closure per new sample.
inline double closure_step(const HeardHand& hand) {
  const swage_sample* last = nullptr;
  double most = 0;
  for (const swage_sample& s : hand.sample) {
    if (!(s.valid & SWAGE_VALID_CLOSURE) || (last != nullptr && s.sequence == last->sequence)) continue;
    if (last != nullptr) most = std::max(most, std::abs(s.closure - last->closure) / static_cast<double>(s.sequence - last->sequence));
    last = &s;
  }
  return most;
}

/// Number of samples that are no point of the way on which the person led the hand, in its order and not before its time.
/// `value`: of a sample; `led`: of a point of the way; `looks`: when a step was over at the latest.
template <class Value, class Led>
int beside_the_way(const HeardHand& hand, uint32_t bit, const std::vector<LedPoint>& path, const std::vector<ToolLook>& looks, double tolerance,
                   Value value, Led led) {
  std::size_t at = 0, look = 0;
  uint64_t sequence = 0;
  int beside = 0;
  for (std::size_t i = 0; i < hand.sample.size(); ++i) {
    const swage_sample& s = hand.sample[i];
    if (!(s.valid & bit) || s.sequence == sequence) continue;
    sequence = s.sequence;
    while (look < looks.size() && looks[look].step <= hand.first + i) ++look;
    if (look == looks.size()) break;
    const double x = value(s);
    const auto between = [&](std::size_t j) {
      const double a = led(path[j]), b = led(path[std::min(j + 1, path.size() - 1)]);
      return x >= std::min(a, b) - tolerance && x <= std::max(a, b) + tolerance;
    };
    std::size_t j = at;
    while (j < path.size() && path[j].wall_s <= looks[look].wall_s && !between(j)) ++j;
    if (j < path.size() && path[j].wall_s <= looks[look].wall_s)
      at = j;
    else
      ++beside;
  }
  return beside;
}

}  // namespace swage::test
