// SPDX-License-Identifier: Apache-2.0
#include "queries.hpp"

namespace swage::bench {

std::vector<QueryFigures> measure_queries(const Needle& n, int passes, int poses) {
  std::vector<Query> queries;
  for (auto&& list : {swage_queries(n), ode_queries(n), mujoco_queries(n), bullet_queries(n), fcl_queries(n)})
    queries.insert(queries.end(), list.begin(), list.end());
  const Jaw jaws[2] = {jaw(1), jaw(-1)};
  const Solid solid[2] = {Solid(jaws[0]), Solid(jaws[1])};
  const std::vector<TrajectoryPose> frames = trajectory(n, jaws[0], jaws[1], poses);

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
          found[q][i] = queries[q].run(frames[i].X_WN, frames[i].X_WJ[0], frames[i].X_WJ[1]);
          ns[q][i].push_back(now_ns() - start);
        }

  std::vector<std::array<double, 2>> exact(frames.size());
  for (size_t i = 0; i < frames.size(); ++i)
    for (size_t k = 0; k < 2; ++k)
      exact[i][k] = exact_gap(n, solid[k], frames[i].X_WJ[k].inverse() * frames[i].X_WN);

  constexpr double kSeen = 0.1e-6;  // m: contacts shallower than this may be judged either way
  for (size_t q = 0; q < queries.size(); ++q) {
    QueryFigures f;
    f.family = queries[q].family, f.name = queries[q].name;
    std::vector<double> all, per_phase[kPhases];
    for (size_t i = 0; i < frames.size(); ++i) {
      const double median = times(ns[q][i]).median;
      all.push_back(median);
      per_phase[static_cast<size_t>(frames[i].phase)].push_back(median);
      for (size_t k = 0; k < 2; ++k) {
        const double gap_exact = exact[i][k], gap = found[q][i].gap[k];
        if (gap_exact < -kSeen) {
          ++f.overlapping;
          f.missed += gap >= 0;
          f.worst_error = std::max(f.worst_error, gap >= 0 ? -gap_exact : std::abs(gap - gap_exact));
        } else if (gap_exact > kSeen) {
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
