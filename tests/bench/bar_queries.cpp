// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "bar.hpp"
#include "queries.hpp"

namespace swage::bench {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const QueryFigures* find(const std::vector<QueryFigures>& all, const std::string& family) {
  for (const QueryFigures& f : all)
    if (f.family == family) return &f;
  return nullptr;
}

Line ratio(const char* name, double ours, double theirs, double bound) {
  Line line{"G1", name, "x", ours / theirs, -kInfinity, bound, true, ""};
  line.note =
      std::to_string(std::lround(ours)) + " ns against " + std::to_string(std::lround(theirs)) + " ns";
  return line;
}

}  // namespace

std::vector<Line> bar_queries(const Effort& effort) {
  std::vector<Line> lines;
  const auto figures = measure_queries(Needle{}, effort.passes);
  const QueryFigures& ours = *find(figures, "swage");
  constexpr auto kGrasped = static_cast<size_t>(Phase::kGrasped);
  if (const QueryFigures* ode = find(figures, "ODE")) {
    lines.push_back(ratio("query, grasped phase, over ODE trimesh", ours.phase[kGrasped].mean,
                          ode->phase[kGrasped].mean, 0.10));
    lines.push_back(
        ratio("query, mean of 10,000 poses, over ODE trimesh", ours.all.mean, ode->all.mean, 0.25));
  } else {
    lines.push_back({"G1", "query over ODE trimesh", "x", 0, -kInfinity, 0.1, false,
                     "peer not installed: scripts/setup.sh peer"});
  }
  lines.push_back({"G1", "contacts missed against the exact arc", "1", static_cast<double>(ours.missed), 0, 0,
                   true, "of " + std::to_string(ours.overlapping)});
  lines.push_back({"G1", "contacts invented against the exact arc", "1", static_cast<double>(ours.invented),
                   0, 0, true, "of " + std::to_string(ours.apart)});
  lines.push_back({"G1", "worst error of a depth", "um", ours.worst_error * 1e6, 0, 0.01, true, ""});

  // other needles must behave alike
  for (double arc : {90.0, 180.0, 225.0})
    for (double wire : {50e-6, 150e-6}) {
      Needle n;
      n.arc = arc / 180 * std::numbers::pi, n.wire_diameter = wire;
      if (arc > 180) n.chord = 4e-3;
      const auto other = measure_queries(n, 1, 2000);
      const QueryFigures& f = *find(other, "swage");
      const std::string name = std::to_string(static_cast<int>(arc)) + " deg, " +
                               std::to_string(std::lround(wire * 1e6)) + " um wire: ";
      lines.push_back({"G1", name + "missed and invented", "1", static_cast<double>(f.missed + f.invented), 0,
                       0, true, ""});
      lines.push_back({"G1", name + "worst error of a depth", "um", f.worst_error * 1e6, 0, 0.01, true, ""});
    }
  return lines;
}

}  // namespace swage::bench
