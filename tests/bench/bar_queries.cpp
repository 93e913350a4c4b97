// SPDX-License-Identifier: Apache-2.0
#include "bar.hpp"
#include "both_jaws.hpp"
#include "queries.hpp"

namespace swage::bench {
namespace {

const QueryFigures* find(const std::vector<QueryFigures>& all, const std::string& family) {
  for (const QueryFigures& f : all)
    if (f.family == family) return &f;
  return nullptr;
}

void accuracy(std::vector<Line>& lines, const QueryFigures& f, const std::string& needle) {
  lines.push_back(none("G1", needle + "contacts missed", f.missed, "of " + std::to_string(f.overlapping)));
  lines.push_back(none("G1", needle + "contacts invented", f.invented, "of " + std::to_string(f.apart)));
  lines.push_back(at_most("G1", needle + "worst error of a depth", "um", f.worst_error * 1e6, 0.01));
}

}  // namespace

std::vector<Line> bar_queries(const Effort& effort) {
  std::vector<Line> lines;
  const auto figures = measure_queries(Needle{}, effort.passes);
  const QueryFigures& ours = *find(figures, "swage");
  const char *grasped = "query, grasped phase, over ODE trimesh",
             *mean = "query, mean of 10,000 poses, over ODE trimesh";
  if (const QueryFigures* ode = find(figures, "ODE")) {
    constexpr auto kGrasped = static_cast<size_t>(Phase::kGrasped);
    const double clock = clock_ns();  // each figure contains one reading of it, some 4 % of ours
    lines.push_back(ratio("G1", grasped, ours.phase[kGrasped].mean - clock, ode->phase[kGrasped].mean - clock, 0.10));
    lines.push_back(ratio("G1", mean, ours.all.mean - clock, ode->all.mean - clock, 0.25));
  } else {
    lines.push_back(unmeasured("G1", grasped, 0.10));
    lines.push_back(unmeasured("G1", mean, 0.25));
  }
  accuracy(lines, ours, "");

  // other needles must behave alike
  for (double arc : {90.0, 180.0, 225.0})
    for (double wire : {50e-6, 150e-6}) {
      Needle n;
      n.arc = arc / 180 * std::numbers::pi, n.wire_diameter = wire;
      if (arc > 180) n.chord = 4e-3;
      const auto other = measure_queries(n, 1, 2000);
      accuracy(lines, *find(other, "swage"),
               std::to_string(static_cast<int>(arc)) + " deg, " + std::to_string(std::lround(wire * 1e6)) +
                   " um wire: ");
    }
  return lines;
}

namespace {

/// Time of asking both jaws [ns].
template <class Query>
double both_ns(Query&& query) {
  const double start = now_ns();
  for (size_t k = 0; k < 2; ++k) keep(query(k));
  return now_ns() - start;
}

struct SweptFigures {
  double discrete = 0, swept = 0;  // ns, means of per-pose medians
};

SweptFigures measure_swept(const std::vector<TrajectoryPose>& poses, const Vec3& way, const Vec3& turn,
                           int passes) {
  BothJaws discrete, swept;
  std::vector<std::vector<double>> a(poses.size()), b(poses.size());
  constexpr size_t kBlock = 500;
  for (int pass = 0; pass < passes; ++pass)
    for (size_t first = 0; first < poses.size(); first += kBlock) {
      const size_t last = std::min(first + kBlock, poses.size());
      for (size_t i = first; i < last; ++i)
        a[i].push_back(both_ns([&](size_t k) { return discrete.collide(poses[i], k); }));
      for (size_t i = first; i < last; ++i)
        b[i].push_back(both_ns([&](size_t k) { return swept.first_touch(poses[i], way, turn, k); }));
    }
  SweptFigures f;
  const auto count = static_cast<double>(poses.size());
  for (size_t i = 0; i < poses.size(); ++i)
    f.discrete += times(a[i]).median / count, f.swept += times(b[i]).median / count;
  return f;
}

}  // namespace

std::vector<Line> bar_swept(const Effort& effort) {
  const auto poses = trajectory(Needle{}, jaw(1), jaw(-1), effort.hold_seconds < 10 ? 2000 : 10000);
  std::vector<Line> lines;
  for (const auto& [name, way, turn] : {std::tuple{"0.1 m/s", Vec3(0, 0, -1e-4), Vec3(0, 0, 0)},
                                        {"2 m/s", Vec3(0, 0, -2e-3), Vec3(0, 0, 0)},
                                        {"2 m/s spinning 100 rad/s", Vec3(0, 0, -2e-3), Vec3(0.1, 0, 0)}}) {
    const SweptFigures f = measure_swept(poses, way, turn, effort.passes);
    lines.push_back(ratio("G7", std::string("swept query over discrete, ") + name, f.swept, f.discrete, 2.0));
  }
  return lines;
}

namespace {

std::vector<uint64_t> features(BothJaws& both, const TrajectoryPose& p) {
  std::vector<uint64_t> all;
  for (size_t k = 0; k < 2; ++k) {
    both.collide(p, k);
    for (int i = 0; i < both.found.count; ++i)
      all.push_back(both.found.candidate[static_cast<size_t>(i)].feature);
    all.push_back(k);
  }
  return all;
}

/// Poses at which the contact sets of the queries, made in metres and in other units, differ.
int sets_that_differ(const std::vector<TrajectoryPose>& poses, double unit) {
  BothJaws metres, other({}, unit);
  metres.query.margin = 20e-6, other.query.margin = 20e-6 * unit;
  int differ = 0;
  for (const TrajectoryPose& p : poses) differ += features(metres, p) != features(other, p);
  return differ;
}

}  // namespace

std::vector<Line> bar_units(const Effort&) {
  const auto poses = trajectory(Needle{}, jaw(1), jaw(-1));
  const Method ours = swage_methods().front();
  std::vector<Line> lines;
  for (const auto& [name, unit] : {std::pair{"mm", 1e3}, {"0.1 mm", 1e4}, {"10 m", 0.1}}) {
    const std::string in = std::string(name) + " against m: ";
    lines.push_back(none("S01", in + "contact sets of a query that differ", sets_that_differ(poses, unit),
                         "of 10000 poses"));
    lines.push_back(at_most("S01", in + "poses of a grasp, same contacts at every step", "1",
                            unit_error(ours, unit), 1e-9));
  }
  return lines;
}

}  // namespace swage::bench
