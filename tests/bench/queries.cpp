// SPDX-License-Identifier: Apache-2.0
#include "queries.hpp"

namespace swage::bench {

namespace {

constexpr double kSeen = 0.1e-6;  // m: contacts shallower than this may be judged either way

/// What one query found at all poses, and how long it took: per pose, one entry a pass.
struct Record {
  std::vector<std::vector<double>> ns;
  std::vector<Gaps> found;
};

/// A block of poses per query in turn: interleaved, yet each works with a warm cache.
std::vector<Record> run_all(const std::vector<Query>& queries, const std::vector<TrajectoryPose>& poses,
                            int passes) {
  std::vector<Record> records(queries.size());
  for (Record& r : records) r.ns.resize(poses.size()), r.found.resize(poses.size());
  constexpr size_t kBlock = 500;
  for (int pass = 0; pass < passes; ++pass)
    for (size_t first = 0; first < poses.size(); first += kBlock)
      for (size_t q = 0; q < queries.size(); ++q)
        for (size_t i = first; i < std::min(first + kBlock, poses.size()); ++i) {
          const double start = now_ns();
          records[q].found[i] = queries[q].run(poses[i].X_WN, poses[i].X_WJ[0], poses[i].X_WJ[1]);
          records[q].ns[i].push_back(now_ns() - start);
        }
  return records;
}

/// Counts one pair of needle and jaw.
void judge(QueryFigures& f, double exact, double gap) {
  if (exact < -kSeen) {
    ++f.overlapping;
    f.missed += gap >= 0;
    f.worst_error = std::max(f.worst_error, gap >= 0 ? -exact : std::abs(gap - exact));
  } else if (exact > kSeen) {
    ++f.apart;
    f.invented += gap < -kSeen;
  }
}

}  // namespace

std::vector<QueryFigures> measure_queries(const Needle& n, int passes, int count) {
  const std::vector<Query> queries = all_queries(n);
  const Jaw jaws[2] = {jaw(1), jaw(-1)};
  const Solid solid[2] = {Solid(jaws[0]), Solid(jaws[1])};
  const std::vector<TrajectoryPose> poses = trajectory(n, jaws[0], jaws[1], count);
  const std::vector<Record> records = run_all(queries, poses, passes);

  std::vector<QueryFigures> figures(queries.size());
  for (size_t i = 0; i < poses.size(); ++i)
    for (size_t k = 0; k < 2; ++k) {
      const double exact = exact_gap(n, solid[k], poses[i].X_WJ[k].inverse() * poses[i].X_WN);
      for (size_t q = 0; q < queries.size(); ++q) judge(figures[q], exact, records[q].found[i].gap[k]);
    }
  for (size_t q = 0; q < queries.size(); ++q) {
    QueryFigures& f = figures[q];
    f.family = queries[q].family, f.name = queries[q].name;
    std::vector<double> all, per_phase[kPhases];
    for (size_t i = 0; i < poses.size(); ++i) {
      all.push_back(times(records[q].ns[i]).median);
      per_phase[static_cast<size_t>(poses[i].phase)].push_back(all.back());
    }
    f.all = times(all);
    for (int p = 0; p < kPhases; ++p) f.phase[p] = times(per_phase[p]);
  }
  return figures;
}

namespace {

/// A place on a jaw and the direction out of it: the middle of each face, edge and corner.
struct Place {
  Vec3 p, out;
};
std::vector<Place> places(const Jaw& j) {
  const Solid solid(j);
  std::vector<Place> all;
  std::vector<Vec3> at_vertex(j.vertex.size(), Vec3::Zero());
  for (size_t f = 0; f < j.face.size(); ++f) {
    Vec3 middle = Vec3::Zero();
    for (uint32_t v : j.face[f]) {
      middle += j.vertex[v] / static_cast<double>(j.face[f].size());
      at_vertex[v] += solid.normal[f];
    }
    all.push_back({middle, solid.normal[f]});
    for (size_t g = f + 1; g < j.face.size(); ++g) {
      std::vector<uint32_t> shared;
      for (uint32_t v : j.face[f])
        if (std::count(j.face[g].begin(), j.face[g].end(), v)) shared.push_back(v);
      if (shared.size() == 2)
        all.push_back({0.5 * (j.vertex[shared[0]] + j.vertex[shared[1]]),
                       (solid.normal[f] + solid.normal[g]).normalized()});
    }
  }
  for (size_t v = 0; v < j.vertex.size(); ++v) all.push_back({j.vertex[v], at_vertex[v].normalized()});
  return all;
}

/// The needle with its mid-arc over a place, so deep that the wire overlaps it by `overlap`, bulging towards it and turned
/// about the way out so that it lies along nothing.
Pose pressed_in(const Needle& n, const Place& place, double overlap) {
  const Quat outwards = Quat::FromTwoVectors(Vec3::UnitZ(), -place.out);
  const Pose X{Vec3::Zero(), toolkit::exp_rotation(0.4 * place.out) * outwards};
  return {place.p + (n.wire_radius() - overlap) * place.out - X.q * n.point(0), X.q};
}

}  // namespace

std::vector<double> overlap_errors(double overlap) {
  const Needle n;
  const Jaw upper = jaw(1);
  const Solid solid(upper);
  const Pose here, away(Vec3(0, 0, -0.1), Quat::Identity());
  std::vector<double> worst;
  for (const Query& q : all_queries(n)) {
    worst.push_back(0);
    for (const Place& place : places(upper)) {
      const Pose X = pressed_in(n, place, overlap), less = pressed_in(n, place, 0.9 * overlap);
      const double gap = q.run(X, here, away).gap[0], gap_less = q.run(less, here, away).gap[0];
      // deeper must read deeper
      const bool known = gap < 0 && gap < gap_less;
      const double error = std::abs(gap - exact_gap(n, solid, X));
      worst.back() = std::max(worst.back(), known ? error : std::numeric_limits<double>::infinity());
    }
  }
  return worst;
}

}  // namespace swage::bench
