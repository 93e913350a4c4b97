// SPDX-License-Identifier: Apache-2.0
//
// A thread of 100 nodes, 10-0 nylon, in the host's own step: held between two flat jaws, or lying flat on a plate.
#pragma once

#include <memory>

#include "../unit/dynamics/rod_body.hpp"
#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"

namespace swage::bench {

inline constexpr double kPiece = 0.3e-3, kWire = 11e-6;  // m
inline constexpr double kPressed = 1e-7;                 // m, each jaw into the thread: some 10 mN
inline const toolkit::Vec3 kJaw(0.25e-3, 0.5e-3, 0.2e-3);  // m, half of a jaw along the thread, across it and away from it

inline toolkit::RodSection nylon() { return toolkit::RodSection::round(2 * kWire, 2.5e9, 0.39, 1140); }

inline scene::World with_thread(uint32_t nodes) {
  scene::World w;
  std::vector<toolkit::Vec3> p;
  for (uint32_t i = 0; i < nodes; ++i) p.emplace_back(kPiece * i, 0, 0);
  w.gravity = {0, 0, -9.80665};
  w.capacity.contacts = 512;
  dynamics::add_chain(w, p, kWire, 0);
  return w;
}

/// On a plate, or between two flat jaws, which stand or go across the thread; at a vertex in its middle. Not between two balls of radius R:
/// there a rod tilts by itself and gets loose, as the overlap at each of them falls by R angle^2 / 2 and free ends resist by inertia only.
enum class Held { kLying, kJaws };
struct HeldThread {
  HeldThread(Held how, double speed, uint32_t nodes = 100, double friction = 0.2)
      : world(make(how, nodes)), lies(how == Held::kLying), v(0, speed, 0), rod(world, 0, 0, nylon(), true) {
    contact::Law law{friction, 1e5, 0};
    detector = std::make_unique<contact::Detector>(world, std::vector<contact::Pair>{{0, 1, law}}, options());
    solve = std::make_unique<dynamics::Dynamics>(world, dynamics::Options());
    detector->reserve(contacts);
  }
  static contact::Options options() {
    contact::Options o;
    o.capacity = 512;
    return o;
  }
  static scene::World make(Held how, uint32_t nodes) {
    scene::World w = with_thread(nodes);
    const double middle = 0.5 * kPiece * nodes;
    if (how == Held::kLying) add_box(w, SWAGE_MOTION_FIXED, {middle, 0, -1e-3 - kWire}, {40e-3, 40e-3, 1e-3});
    for (const double side : {1.0, -1.0})
      if (how == Held::kJaws) add_box(w, SWAGE_MOTION_FOLLOWS, {middle, 0, side * (kJaw.z() + kWire - kPressed)}, kJaw);
    scene::reset(w);
    return w;
  }
  static void add_box(scene::World& w, int32_t motion, const toolkit::Vec3& p, const toolkit::Vec3& half) {
    const uint32_t body = dynamics::add_body(w, motion, 1, p);
    scene::Shape shape = dynamics::shape_on(body, 1, SWAGE_SHAPE_CONVEX, half.z());
    std::vector<toolkit::Vec3> corner;
    for (int i = 0; i < 8; ++i)
      corner.emplace_back((i & 1) ? half.x() : -half.x(), (i & 2) ? half.y() : -half.y(), (i & 4) ? half.z() : -half.z());
    const uint32_t start[7] = {0, 4, 8, 12, 16, 20, 24};
    const uint32_t face[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    shape.convex = static_cast<uint32_t>(w.convex.size());
    w.convex.emplace_back();
    toolkit::build_convex(corner, start, face, w.convex.back());
    w.shape.push_back(shape);
  }
  void step() {
    for (uint32_t jaw = 1; !lies && jaw < 3; ++jaw) {
      world.X_WB[jaw].p = toolkit::raw(toolkit::Vec3(toolkit::vec(world.X_WB[jaw].p) + world.dt * v));
      world.V_WB[jaw].v = toolkit::raw(v);
    }
    solve->free_motion(world);
    rod.advance();
    detector->detect(world, contacts);
    dynamics::FlexibleBody* const self[] = {&rod};
    solve->solve(world, contacts, self);
    solve->finish(world);
  }
  scene::World world;
  bool lies;
  toolkit::Vec3 v;
  dynamics::RodBody rod;
  std::unique_ptr<contact::Detector> detector;
  std::unique_ptr<dynamics::Dynamics> solve;
  contact::ContactSet contacts;
};

}  // namespace swage::bench
