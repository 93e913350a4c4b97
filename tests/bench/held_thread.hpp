// SPDX-License-Identifier: Apache-2.0
//
// A thread of 100 nodes, 10-0 nylon, in the host's own step: held between two round jaws, or lying flat on a plate.
#pragma once

#include <memory>

#include "../unit/dynamics/rod_body.hpp"
#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"

namespace swage::bench {

inline constexpr double kPiece = 0.3e-3, kWire = 11e-6;  // m

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

/// Between two balls of 0.5 mm, which stand or go across the thread.
struct HeldThread {
  HeldThread(bool lying, double speed, uint32_t nodes = 100)
      : world(make(lying, nodes)), lies(lying), v(0, speed, 0), rod(world, 0, 0, nylon(), true) {
    contact::Law law{0.2, 1e5, 0};
    detector = std::make_unique<contact::Detector>(world, std::vector<contact::Pair>{{0, 1, law}}, options());
    solve = std::make_unique<dynamics::Dynamics>(world, dynamics::Options());
    detector->reserve(contacts);
  }
  static contact::Options options() {
    contact::Options o;
    o.capacity = 512;
    return o;
  }
  static scene::World make(bool lying, uint32_t nodes) {
    scene::World w = with_thread(nodes);
    if (lying) {
      const uint32_t plate = dynamics::add_body(w, SWAGE_MOTION_FIXED, 1, {0.5 * kPiece * (nodes - 1), 0, -1e-3 - kWire});
      scene::Shape shape = dynamics::shape_on(plate, 1, SWAGE_SHAPE_CONVEX, 1e-3);
      std::vector<toolkit::Vec3> corner;
      for (int i = 0; i < 8; ++i) corner.emplace_back((i & 1) ? 40e-3 : -40e-3, (i & 2) ? 40e-3 : -40e-3, (i & 4) ? 1e-3 : -1e-3);
      const uint32_t start[7] = {0, 4, 8, 12, 16, 20, 24};
      const uint32_t face[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
      w.convex.emplace_back();
      toolkit::build_convex(corner, start, face, w.convex.back());
      shape.convex = 0;
      w.shape.push_back(shape);
    } else {
      for (const double side : {1.0, -1.0}) {
        const uint32_t jaw = dynamics::add_body(w, SWAGE_MOTION_FOLLOWS, 1, {0.5 * kPiece * nodes, 0, side * (0.5e-3 + kWire - 1e-7)});
        w.shape.push_back(dynamics::shape_on(jaw, 1, SWAGE_SHAPE_SPHERE, 0.5e-3));
      }
    }
    scene::reset(w);
    return w;
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
