// SPDX-License-Identifier: Apache-2.0
//
// Tissue of finite elements against closed forms (tissue_mesh_test has the derivations), and what it takes to build
// and to keep.
#include <cmath>

#include "bar.hpp"
#include "plugins/tissue/brick.hpp"
#include "plugins/tissue/compliance.hpp"
#include "plugins/tissue/mesh.hpp"
#include "timing.hpp"

namespace swage::bench {
namespace {

using tissue::Mesh;
using tissue::MeshSpec;

/// Boussinesq: under the load, and how it falls off, in the middle of a block whose rim is far.
std::vector<Line> half_space() {
  MeshSpec s;
  s.size = {24e-3, 24e-3}, s.thickness = 12e-3, s.underside = tissue::Underside::kHeld;
  s.cells = 24, s.refinement = 6;
  const Mesh mesh(s);
  const tissue::Compliance half({s.young / 3, s.spread, 0, 0});
  const auto at = [&](double r) {
    return mesh.between(mesh.place(0.3e-3 + r, 0), mesh.place(0.3e-3, 0))(0, 0);
  };
  double worst = 0;
  for (const double r : {0.1e-3, 0.3e-3, 1e-3}) {
    const double exact = half.normal(r) - half.normal(3e-3);
    worst = std::max(worst, std::abs((at(r) - at(3e-3)) / exact - 1));
  }
  return {at_most("tissue", "mesh, block: dent under a touch off a half space's", "%",
                  100 * std::abs(at(0) / half.normal(0) - 1), 3),
          at_most("tissue", "mesh, block: how it falls off from 0.1 to 3 mm, off Boussinesq", "%",
                  100 * worst, 2.5)};
}

/// A clamped square plate 20 times as wide as thick, bent and sheared.
Line pressed_plate() {
  MeshSpec s;
  s.size = {12e-3, 12e-3}, s.thickness = 0.6e-3, s.cells = 24, s.refinement = 4;
  const double a = 12e-3, t = s.thickness, nu = tissue::kPoisson, r = 0.5e-3, pi = 3.14159265358979323846;
  const double D = s.young * t * t * t / 12 / (1 - nu * nu), G = s.young / 2 / (1 + nu);
  const double w = 0.00560 * a * a / D - r * r * std::log(a / r) / (8 * pi * D) +
                   std::log(0.539 * a / r) / (2 * pi * 5 / 6 * G * t);
  const Mesh mesh(s);
  const double u = mesh.between(mesh.place(0, 0), mesh.place(r, 0))(0, 0);
  return at_most("tissue", "mesh, thin wall: off a clamped plate that bends and shears", "%",
                 100 * std::abs(u / w - 1), 7);
}

}  // namespace

std::vector<Line> bar_tissue(const Effort&) {
  std::vector<Line> lines = half_space();
  lines.push_back(pressed_plate());
  const double begin = cpu_ns();
  const Mesh mesh{MeshSpec{}};
  lines.push_back(at_most("tissue", "mesh as it ships: built in", "s", 1e-9 * (cpu_ns() - begin), 1));
  MeshSpec most;
  most.size = {12e-3, 12e-3}, most.cells = 24, most.slit = 0.4e-3;
  lines.push_back(at_most("tissue", "mesh of most cells: memory", "MB",
                          1e-6 * static_cast<double>(Mesh(most).bytes()), 100));
  return lines;
}

}  // namespace swage::bench
