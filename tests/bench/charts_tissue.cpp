// SPDX-License-Identifier: Apache-2.0
//
// The ladder of the tissue: how right each level is about the dent under a needle, and what a step of an insertion
// with it costs.
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "../plugins/run_lesson.hpp"
#include "charts.hpp"
#include "plugins/tissue/tissue.hpp"
#include "timing.hpp"
#include "test_places.hpp"

namespace swage::bench {
namespace {

struct TissueLevel {
  const char* name;   // of the chart
  const char* level;  // of the tissue
  int cells, refinement;
};
constexpr TissueLevel kTissueLevels[] = {{"plane", "plane", 0, 0},
                             {"compliant", "compliant", 0, 0},
                             {"mesh, 16 cells, halved 3 to 6 times", "mesh", 16, 3},
                             {"mesh, 16 cells, halved 3 to 6 times", "mesh", 16, 4},
                             {"mesh, 16 cells, halved 3 to 6 times", "mesh", 16, 5},
                             {"mesh, 16 cells, halved 3 to 6 times", "mesh", 16, 6},
                             {"mesh, 24 cells, halved 6 times", "mesh", 24, 6}};

/// Processor time of the steps in which the expert has the needle in the tissue: median [ns].
double step_with(const TissueLevel& l) {
  stage::LessonRun run(SWAGE_SOURCE_DIR "/lessons/series/110_insertion.json", {"expert", ""},
                       [&](assembly::LessonFile& file) {
                         for (assembly::LessonObject& o : file.objects) {
                           if (o.name != "tissue") continue;
                           auto params = nlohmann::json::parse(o.params);
                           params["level"] = l.level;
                           if (l.cells > 0) params["cells"] = l.cells, params["refinement"] = l.refinement;
                           o.params = params.dump();
                         }
                       });
  if (!run.ready()) throw std::runtime_error(run.problems());
  std::vector<double> ns;
  while (run.verdict().outcome == judge::Outcome::kRunning && run.world().time() < 60) {
    const double begin = cpu_ns();
    run.step();
    const double took = cpu_ns() - begin;
    if (run.signal("pierce", "pierce.state") >= 2) ns.push_back(took);
  }
  if (ns.empty()) throw std::runtime_error(std::string("nothing was pierced, level ") + l.level);
  return times(ns).median;
}

constexpr double kForce = 5e-3;  // N

tissue::MeshSpec wall(int cells, int refinement) {
  tissue::MeshSpec s;  // 12 x 10 x 1 mm, its rim clamped, its underside free
  s.cells = cells, s.refinement = refinement;
  return s;
}
/// How deep the surface is under the needle, and 0.25, 0.5 and 1 mm beside it [m].
using Dent = std::array<double, 4>;
constexpr Dent kBeside = {0, 0.25e-3, 0.5e-3, 1e-3};  // m

Dent dent_of_mesh(int cells, int refinement) {
  const tissue::Mesh mesh(wall(cells, refinement));
  Dent u;
  for (size_t i = 0; i < u.size(); ++i)
    u[i] = kForce * mesh.between(mesh.place(0.3e-3 + kBeside[i], 0.2e-3), mesh.place(0.3e-3, 0.2e-3))(0, 0);
  return u;
}
/// In the half space; and in the plane, where force = (stiffness + stiffening x) x, and nothing moves beside it.
Dent dent(const TissueLevel& l) {
  const tissue::TissueParams p;
  if (l.level == std::string("plane"))
    return {2 * kForce / (p.stiffness + std::sqrt(p.stiffness * p.stiffness + 4 * p.stiffening * kForce)), 0,
            0, 0};
  if (l.level != std::string("compliant")) return dent_of_mesh(l.cells, l.refinement);
  const tissue::Compliance half({p.young / 3, p.spread, 0, 0});
  Dent u;
  for (size_t i = 0; i < u.size(); ++i) u[i] = kForce * half.normal(kBeside[i]);
  return u;
}

double worst_error(const Dent& u, const Dent& reference) {
  double worst = 0;
  for (size_t i = 0; i < u.size(); ++i) worst = std::max(worst, std::abs(u[i] / reference[i] - 1));
  return worst;
}

}  // namespace

Scatter chart_dent(bool quick) {
  Scatter c;
  c.title = "The tissue's levels: dent under 5 mN in a wall of 12 x 10 x 1 mm";
  c.x = {"worst error of the dent up to 1 mm beside, against a mesh of 32 cells halved 6 times",
         1e-3,
         2,
         true,
         "",
         "rigid"};
  c.y = {"median processor time of a step of the insertion, ns", 3e3, 3e5, true, "", ""};
  std::vector<std::vector<double>> medians(std::size(kTissueLevels));
  for (int round = 0; round < (quick ? 1 : 5); ++round)
    for (size_t i = 0; i < std::size(kTissueLevels); ++i) medians[i].push_back(step_with(kTissueLevels[i]));
  const Dent reference = dent_of_mesh(32, 6);
  for (size_t i = 0; i < std::size(kTissueLevels); ++i) {
    const TissueLevel& l = kTissueLevels[i];
    c.marks.push_back({"swage", l.name, worst_error(dent(l), reference), times(medians[i]).median,
                       l.cells == 16 ? std::to_string(l.refinement) : ""});
  }
  return c;
}

}  // namespace swage::bench
