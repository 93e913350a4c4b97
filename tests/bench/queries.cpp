// SPDX-License-Identifier: Apache-2.0
#include "queries.hpp"

#include "base/rng.hpp"
#include "reference.hpp"

namespace swage::bench {
namespace {

/// Smooth noise in [-1, 1]: three incommensurate sines with random phases.
class Wobble {
 public:
  explicit Wobble(base::Xoshiro256& rng) {
    for (double& p : phase_) p = rng.uniform(0, 2 * std::numbers::pi);
  }
  double operator()(double t) const {
    const double w = 2 * std::numbers::pi * t;
    return 0.5 * std::sin(3.1 * w + phase_[0]) + 0.3 * std::sin(7.7 * w + phase_[1]) +
           0.2 * std::sin(17.3 * w + phase_[2]);
  }

 private:
  double phase_[3];
};

/// Opening of one jaw [rad, signed as jaw_pose wants it] at which its exact gap to the needle is `gap`.
double opening_for_gap(const Needle& n, const Solid& s, int side, const Pose& X_WN, const Pose& X_WT,
                       double gap) {
  // closed no farther than half the thickness of a jaw: beyond that the wire is out on the other side
  double closed = -0.5 * Jaw::kThickness / Jaw::kGrip, open = 0.3;
  for (int k = 0; k < 48; ++k) {
    const double middle = 0.5 * (closed + open);
    (arc_gap(n, s, X_WN, jaw_pose(X_WT, side * middle)) < gap ? closed : open) = middle;
  }
  return side * 0.5 * (closed + open);
}

}  // namespace

std::vector<Frame> trajectory(const Needle& n, int poses) {
  base::Xoshiro256 rng(20260817);
  std::vector<Wobble> wobble;
  for (int i = 0; i < 8; ++i) wobble.emplace_back(rng);
  const Solid upper(jaw(1)), lower(jaw(-1));
  std::vector<Frame> frames;
  frames.reserve(static_cast<size_t>(poses));
  for (int i = 0; i < poses; ++i) {
    const double t = static_cast<double>(i) / poses;
    Frame f;
    f.phase = t < 0.3 ? Phase::kFar : t < 0.6 ? Phase::kNear : t < 0.8 ? Phase::kTouching : Phase::kGrasped;

    // the needle near the grip, turned a little in all axes, gripped at a varying place of its arc
    const double amount = f.phase == Phase::kGrasped ? 0.35 : 1.0;
    const double theta = 0.25 * n.arc * amount * wobble[3](t);
    f.needle.q = toolkit::exp_rotation({0.25 * amount * wobble[0](t), 0, 0}) *
                 toolkit::exp_rotation({0, 0.4 * amount * wobble[1](t), 0}) *
                 toolkit::exp_rotation({0, 0, 0.5 * amount * wobble[2](t)}) *
                 toolkit::exp_rotation({theta, 0, 0});
    const Vec3 place{Jaw::kGrip + 0.8e-3 * amount * wobble[4](t), 0.1e-3 * amount * wobble[5](t), 0};
    f.needle.p = place - f.needle.q * n.point(theta);

    // the tool comes from 30 mm away, then closes
    Pose tool;
    double open_up = 0.13, open_low = -0.13;
    if (f.phase == Phase::kFar) tool.p.x() = -(30e-3 - 22e-3 * t / 0.3);
    if (f.phase == Phase::kNear) {
      const double u = (t - 0.3) / 0.3;
      tool.p.x() = -8e-3 * (1 - u);
      open_up = 0.13 - 0.07 * u, open_low = -open_up;
    }
    if (f.phase == Phase::kTouching)
      open_up = opening_for_gap(n, upper, 1, f.needle, tool, 8e-6 + 12e-6 * wobble[6](t));
    if (f.phase == Phase::kGrasped) {
      open_up = opening_for_gap(n, upper, 1, f.needle, tool, -1.95e-6 + 1.45e-6 * wobble[6](t));
      open_low = opening_for_gap(n, lower, -1, f.needle, tool, -1.95e-6 + 1.45e-6 * wobble[7](t));
    }
    f.upper = jaw_pose(tool, open_up), f.lower = jaw_pose(tool, open_low);
    f.arc_gap[0] = arc_gap(n, upper, f.needle, f.upper);
    f.arc_gap[1] = arc_gap(n, lower, f.needle, f.lower);
    frames.push_back(f);
  }
  return frames;
}

std::vector<QueryFigures> measure_queries(const Needle& n, int passes, int poses) {
  std::vector<Query> queries;
  for (auto&& list : {swage_queries(n), ode_queries(n), mujoco_queries(n), bullet_queries(n), fcl_queries(n)})
    queries.insert(queries.end(), list.begin(), list.end());
  const std::vector<Frame> frames = trajectory(n, poses);

  std::vector<QueryFigures> figures;
  std::vector<std::vector<std::vector<double>>> ns(queries.size(),
                                                   std::vector<std::vector<double>>(frames.size()));
  std::vector<std::vector<Gaps>> found(queries.size(), std::vector<Gaps>(frames.size()));
  // a block of poses per query in turn: interleaved, yet each works with a warm cache
  constexpr size_t kBlock = 500;
  for (int pass = 0; pass < passes; ++pass)
    for (size_t first = 0; first < frames.size(); first += kBlock)
      for (size_t q = 0; q < queries.size(); ++q)
        for (size_t i = first; i < std::min(first + kBlock, frames.size()); ++i) {
          const double start = now_ns();
          found[q][i] = queries[q].run(frames[i].needle, frames[i].upper, frames[i].lower);
          ns[q][i].push_back(now_ns() - start);
        }

  constexpr double kSeen = 0.1e-6;  // m: contacts shallower than this may be judged either way
  for (size_t q = 0; q < queries.size(); ++q) {
    QueryFigures f;
    f.family = queries[q].family, f.name = queries[q].name;
    std::vector<double> all, per_phase[kPhases];
    for (size_t i = 0; i < frames.size(); ++i) {
      const double median = times(ns[q][i]).median;
      all.push_back(median);
      per_phase[static_cast<size_t>(frames[i].phase)].push_back(median);
      for (int k = 0; k < 2; ++k) {
        const double exact = frames[i].arc_gap[k], gap = found[q][i].gap[k];
        if (exact < -kSeen) {
          ++f.overlapping;
          f.missed += gap >= 0;
          f.worst_error = std::max(f.worst_error, gap >= 0 ? -exact : std::abs(gap - exact));
        } else if (exact > kSeen) {
          ++f.apart;
          f.invented += gap < -kSeen;
        }
      }
    }
    f.all = times(all);
    for (int p = 0; p < kPhases; ++p) f.phase[p] = times(per_phase[p]);
    figures.push_back(std::move(f));
  }
  return figures;
}

}  // namespace swage::bench
