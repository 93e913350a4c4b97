// SPDX-License-Identifier: Apache-2.0
//
// Tables 6-1 and 6-2 of the thesis again: its needle of 100 spheres against two tetrahedra (8 planes, 12 edges), with no
// tree and with trees of 3, 4 and 5 levels; and its whole loop. The bounds are the thesis's own figures (Pentium 4, 2.6 GHz);
// what a tree gains over none is the part that does not age.
#include <span>

#include "bar.hpp"
#include "contact/detector.hpp"
#include "scene/kinematics.hpp"
#include "solids.hpp"
#include "swage_world.hpp"
#include "thesis_contact.hpp"
#include "thesis_tables.hpp"
#include "trajectory.hpp"

namespace swage::bench {
namespace {

namespace thesis = contact::thesis;

/// One jaw as the thesis sees it: planar surfaces bounded by edges.
struct Surfaces {
  std::vector<std::vector<Vec3>> vertex;
  std::vector<thesis::Polygon> polygon;

  explicit Surfaces(const Jaw& j) {
    const Solid solid(j);
    for (const auto& f : j.face) {
      vertex.emplace_back();
      for (uint32_t i : f) vertex.back().push_back(j.vertex[i]);
    }
    for (size_t i = 0; i < vertex.size(); ++i)
      polygon.push_back({vertex[i], solid.normal[i], solid.offset[i]});
  }
  Surfaces(const Surfaces&) = delete;  // polygons look at the vertices here
  bool touches(const Vec3& p, double r) const {
    return std::any_of(polygon.begin(), polygon.end(),
                       [&](const thesis::Polygon& f) { return thesis::sphere_polygon(p, r, f).has_value(); });
  }
};

const Surfaces& surfaces(uint32_t k) {
  static const Surfaces all[2] = {Surfaces(tetra_jaw(1)), Surfaces(tetra_jaw(-1))};
  return all[k];
}

/// Which spheres touch which surface, as sphere + 100 (surface + 4 jaw), in ascending order.
using Touching = std::vector<uint32_t>;

/// The needle of the thesis; `levels` 0: every sphere against every surface.
class ThesisQuery {
 public:
  explicit ThesisQuery(int levels) : levels_(levels) {
    if (levels > 0) tree_ = contact::build_sphere_tree(chain_, radius_, {levels, 1});
  }
  void run(const TrajectoryPose& p, Touching& out) const {
    out.clear();
    for (uint32_t k = 0; k < 2; ++k) {
      const contact::Frame X_JN(p.X_WJ[k].inverse() * p.X_WN);
      if (levels_ == 0)
        for (uint32_t i = 0; i < chain_.size(); ++i) test(k, i, X_JN * chain_[i], out);
      else
        tree_.visit([&](const Vec3& c, double r) { return surfaces(k).touches(X_JN * c, r); },
                    [&](uint32_t i) { test(k, tree_.number[i], X_JN * tree_.centre[i], out); });
    }
  }
  double build_ns() const {
    const double start = now_ns();
    keep(contact::build_sphere_tree(chain_, radius_, {levels_, 1}).node.size());
    return now_ns() - start;
  }

 private:
  void test(uint32_t k, uint32_t i, const Vec3& p, Touching& out) const {
    const std::vector<thesis::Polygon>& polygon = surfaces(k).polygon;
    for (uint32_t f = 0; f < polygon.size(); ++f)
      if (thesis::sphere_polygon(p, radius_, polygon[f])) out.push_back(i + 100 * (f + 4 * k));
  }

  int levels_;
  double radius_ = Needle{}.wire_radius();
  std::vector<Vec3> chain_ = Needle{}.chain(100);
  contact::SphereTree tree_;
};

/// A row while it is measured.
struct Measured {
  ThesisQuery query;
  std::vector<std::vector<double>> ns = {};
  std::vector<Touching> found = {};
};

std::string range_us(double low, double high) {
  char text[80];
  std::snprintf(text, sizeof text, "%.3g to %.3g us, n = 10000", low, high);
  return text;
}

/// Medians per pose, the trees in turn, block by block.
void measure(std::vector<Measured>& all, const std::vector<TrajectoryPose>& poses, int passes) {
  for (Measured& f : all) f.ns.resize(poses.size()), f.found.resize(poses.size());
  constexpr size_t kBlock = 500;
  for (int pass = 0; pass < passes; ++pass)
    for (size_t first = 0; first < poses.size(); first += kBlock)
      for (Measured& f : all)
        for (size_t i = first; i < std::min(first + kBlock, poses.size()); ++i) {
          const double start = now_ns();
          f.query.run(poses[i], f.found[i]);
          f.ns[i].push_back(now_ns() - start);
        }
  for (Measured& f : all)
    for (Touching& t : f.found) std::sort(t.begin(), t.end());
}

/// Spheres of the detector's chain that touch at poses, against the search over all of them; poses that differ.
int chain_differs(const std::vector<TrajectoryPose>& poses) {
  scene::World world = make_world({});
  contact::Options options;
  options.level = contact::Level::kThesis;
  contact::Detector detector(world, {contact::Pair{kNeedleObject, kJawsObject, {}}}, options);
  contact::ContactSet set;
  detector.reserve(set);
  const Solid solid[2] = {Solid(jaw(1)), Solid(jaw(-1))};
  const std::vector<Vec3> chain = Needle{}.chain(100);
  int differ = 0;
  for (const TrajectoryPose& p : poses) {
    world.X_WB[kNeedle] = p.X_WN.abi();
    for (uint32_t k = 0; k < 2; ++k) world.X_WB[kUpper + k] = p.X_WJ[k].abi();
    detector.detect(world, set);
    std::vector<uint32_t> found, wanted;
    for (const contact::Contact& c : set.contact)
      if (c.gap < 0) found.push_back(static_cast<uint32_t>(c.feature >> 44) - 1 + 100 * (c.shape_b - 1));
    for (uint32_t k = 0; k < 2; ++k)
      for (uint32_t i = 0; i < chain.size(); ++i)
        if (solid[k].distance(p.X_WJ[k].inverse() * (p.X_WN * chain[i])) < Needle{}.wire_radius())
          wanted.push_back(i + 100 * k);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    differ += found != wanted;
  }
  return differ;
}

}  // namespace

std::vector<TreeRow> table_61(int passes) {
  const auto poses = trajectory(Needle{}, tetra_jaw(1), tetra_jaw(-1));
  std::vector<TreeRow> rows = {{0, {927.13, 730, 1100, 0}},
                               {3, {388.67, 150, 930, 0.18609}},
                               {4, {490.25, 160, 940, 0.27188}},
                               {5, {291.38, 150, 630, 0.29920}}};
  std::vector<Measured> all;
  for (const TreeRow& row : rows) all.push_back({ThesisQuery(row.levels)});
  measure(all, poses, passes);
  for (size_t k = 0; k < rows.size(); ++k) {
    std::vector<double> ns, build;
    for (const auto& pose : all[k].ns) ns.push_back(times(pose).median);
    const Times t = times(ns);
    rows[k].ours = {t.mean * 1e-3, *std::min_element(ns.begin(), ns.end()) * 1e-3, t.max * 1e-3, 0};
    for (size_t i = 0; i < poses.size(); ++i) rows[k].differ += all[k].found[i] != all[0].found[i];
    if (rows[k].levels == 0) continue;
    for (int i = 0; i < 200; ++i) build.push_back(all[k].query.build_ns());
    rows[k].ours.build_ms = times(build).median * 1e-6;
  }
  return rows;
}

std::vector<LoopRow> table_62() {
  constexpr int kLoops = 10000;
  std::vector<LoopRow> rows;
  for (const Method& m : swage_methods())
    if (m.name == "swage" || m.name == "swage, whole loop of the thesis") rows.push_back({m.name, m.family, loops(m, kLoops)});
  return rows;
}

std::vector<Line> bar_table_61(const Effort& effort) {
  const std::vector<TreeRow> rows = table_61(effort.passes);
  std::vector<Line> lines;
  for (const TreeRow& r : rows) {
    const std::string name = r.levels == 0 ? "no tree" : std::to_string(r.levels) + " levels";
    lines.push_back(at_most("6-1", name + ": mean of a query", "us", r.ours.mean_us, r.thesis.mean_us,
                            range_us(r.ours.low_us, r.ours.high_us)));
    if (r.levels == 0) continue;
    lines.push_back(at_most("6-1", name + ": mean over no tree", "x", r.ours.mean_us / rows[0].ours.mean_us, 1,
                            "thesis " + std::to_string(r.thesis.mean_us / rows[0].thesis.mean_us).substr(0, 4)));
    lines.push_back(none("6-1", name + ": poses whose contacts differ from brute force", r.differ, "of 10000"));
    lines.push_back(at_most("6-1", name + ": time to build", "ms", r.ours.build_ms, r.thesis.build_ms));
  }
  lines.push_back(none("6-1", "detector's chain: poses whose contacts differ from brute force",
                       chain_differs(trajectory(Needle{}, jaw(1), jaw(-1))), "of 10000"));
  return lines;
}

std::vector<Line> bar_table_62(const Effort&) {
  std::vector<Line> lines;
  for (const LoopRow& r : table_62()) {
    const Times t = times(r.ns);
    lines.push_back(at_most("6-2", r.name + ": mean of a loop, approach, grasp, carry", "us", t.mean * 1e-3, kThesisLoop_us,
                            range_us(*std::min_element(r.ns.begin(), r.ns.end()) * 1e-3, t.max * 1e-3)));
  }
  return lines;
}

}  // namespace swage::bench
