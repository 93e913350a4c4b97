// SPDX-License-Identifier: Apache-2.0
//
// A knot that two hands have tied, cut free of its wound and pulled: its thread as it lies at the end of an attempt, its loop about a fixed
// post and the closed tips of an instrument, which goes away from the post. Nothing is prescribed: friction holds it or does not.
#pragma once

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

#include "run_lesson.hpp"
#include "thread_scene.hpp"

namespace swage::stage {

struct PulledKnot {
  double bears = 0;   // N, most tension of the loop before it had opened by `kMostOpening`, or the load
  double opens = 0;   // m, by how much the loop was open then; its stretch is in that
  std::string trouble;
};

/// Of the thread, as points of a path in the plane of the loop: x along the wound, y out of it, from the middle of the tissue between the holes.
inline std::string nodes_of(const LessonRun& run) {
  const scene::ChainView chain(run.world(), run.world().chain[0]);
  constexpr double kMiddle = 1.0e-3;  // m, above the tray: of the tissue in which the thread lies in half a circle of 1 mm
  std::string text;
  for (uint32_t i = 0; i < chain.vertices(); ++i) {
    char point[96];
    const toolkit::Vec3 p = 1e3 * chain.p(i);
    std::snprintf(point, sizeof point, "%s%.7f %.7f %.7f", i == 0 ? "" : ", ", p.x(), p.z() - 1e3 * kMiddle, -p.y());
    text += point;
  }
  return text + " mm";
}

/// N, of the loop beside its vertex `i`. What a knot was drawn down with stays in its turns: the greatest tension of the thread may be there.
inline double tension_beside(const scene::ChainView& chain, uint32_t i) {
  constexpr double kEA = 2.5e9 * 1.5553e-9;  // N: nylon 8-0, 44.5 um thick
  double stretch = 0;
  for (const uint32_t k : {i - 1, i}) stretch += 0.5 * ((chain.p(k + 1) - chain.p(k)).norm() / (chain.s(k + 1) - chain.s(k)) - 1);
  return kEA * stretch;
}

/// The lowest vertex of the loop: what lay deepest in the tissue.
inline uint32_t lowest(const scene::ChainView& chain) {
  uint32_t found = 1;
  for (uint32_t i = 1; i + 1 < chain.vertices(); ++i)
    if (chain.p(i).y() < chain.p(found).y()) found = i;
  return found;
}

/// `thread`: its parameters but for the start. Pulled at 0.5 mm/s up to `load` [N]; in glycerine, as in lesson 134, in which a light thread comes to rest.
inline PulledKnot pull_apart(const LessonRun& run, const std::string& thread, double friction, double load) {
  constexpr double kSpeed = 0.5e-3, kMostOpening = 3e-3, kTaut = 1e-3;  // m/s; m; N, from where on it is taut
  constexpr double kLongest = 8;                                        // s
  const std::string hand = ::testing::TempDir() + "swage_pulled_knot.json";
  std::ofstream(hand) << R"({"format": "swage-hand/1", "title": "Pulls", "keys": [
    {"t": "0 s", "p": ["0.4 mm", 0, "3 mm"], "axis": [0, 0, 1], "closing": [1, 0, 0], "closure": 0.75},
    {"t": "8 s", "p": ["4.4 mm", 0, "3 mm"], "axis": [0, 0, 1], "closing": [1, 0, 0], "closure": 0.75}]})";
  const std::string mu = std::to_string(friction);
  test::ThreadScene scene(
      R"({"name": "knot", "plugin": "swage.object.thread", "params": {)" + thread + R"(, "start": "nodes", "path": ")" + nodes_of(run) + R"("}},
      {"name": "post", "plugin": "swage.object.solids", "pose": {"p": ["-0.4 mm", 0, 0]}, "params": {"form": "cylinder", "fixed": true, "diameter": "0.3 mm", "length": "6 mm"}},
      {"name": "assistant", "plugin": "swage.object.jaws", "follows": {"pose": "hand", "closure": "hand"}, "pose": {"p": ["0.4 mm", 0, "3 mm"], "rpy": [0, "-90 deg", 0]},
       "params": {"tip_width": "0.3 mm", "base_width": "0.3 mm", "thickness": "0.15 mm"}})",
      R"({"plugin": "swage.coupling.contact", "between": ["knot", "knot"], "params": {"friction": )" + mu + R"(, "stiffness": "2e4 N/m"}},
      {"plugin": "swage.coupling.contact", "between": ["post", "knot"], "params": {"friction": 0.1, "stiffness": "1e5 N/m"}},
      {"plugin": "swage.coupling.contact", "between": ["assistant", "knot"], "params": {"friction": 0.1, "stiffness": "1e5 N/m"}})",
      R"({"name": "hand", "plugin": "swage.device.scripted", "params": {"file": ")" + hand + R"("}})",
      R"("gravity": [0, 0, 0], "environment": {"medium": "water", "viscosity": "1 Pa*s", "density": "1260 kg/m3"}, )");
  PulledKnot out;
  if (!scene.engine) return out;
  double slack = -1;  // s, when it became taut
  const uint32_t middle = lowest(scene.chain());
  while (scene.engine->world().time() < kLongest && out.opens < kMostOpening && out.bears < load) {
    scene.run(1);
    const double tension = tension_beside(scene.chain(), middle), now = scene.engine->world().time();
    // the first moments are those of a thread that was under tension where it was tied
    if (slack < 0 && now > 0.5 && tension > kTaut) slack = now;
    if (slack < 0) continue;
    out.bears = std::max(out.bears, tension), out.opens = 2 * kSpeed * (now - slack);
  }
  out.trouble = scene.troubles();
  return out;
}

}  // namespace swage::stage
