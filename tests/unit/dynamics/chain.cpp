// SPDX-License-Identifier: Apache-2.0
//
// Friction of a chain belongs to its material: between two rollers that carry it along, loaded with less than Coulomb's limit, it
// does not creep when the contact goes from piece to piece. Separate capsules, as wires were made of before, do. And nothing
// passes through a chain.
#include <gtest/gtest.h>

#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "sliding_chain.hpp"

namespace swage::dynamics {
namespace chain_test {

using toolkit::Quat;
using toolkit::Vec3;

constexpr double kWire = 25e-6, kBall = 0.5e-3;      // m, radii
constexpr double kPiece = 100e-6;                    // m
constexpr double kMass = 1e-6;                       // kg
constexpr double kStiffness = 1e6, kOverlap = 1e-7;  // N/m, m: each roller presses with 0.1 N
constexpr double kFriction = 0.3, kLoad = 0.03;      // N, half of what friction bears
constexpr double kSpeed = 10e-3;                     // m/s, of the rollers' surfaces: a piece in 10 ms
constexpr int kPieces = 60;

/// Vertices on a wave of the given height along z [m].
std::vector<Vec3> wire(double wave) {
  std::vector<Vec3> p;
  for (int i = 0; i <= kPieces; ++i) p.emplace_back((i - kPieces + 10) * kPiece, 0, wave * std::sin(1.1 * i));
  return p;
}

/// The same wire as separate capsules on one body.
void add_capsules(scene::World& w, const std::vector<Vec3>& p) {
  const uint32_t body = add_body(w, SWAGE_MOTION_FLEXIBLE, 0, Vec3::Zero());
  for (size_t i = 0; i + 1 < p.size(); ++i) {
    const Vec3 u = p[i + 1] - p[i];
    scene::Shape shape = shape_on(body, 0, SWAGE_SHAPE_CAPSULE, kWire);
    shape.half_length = 0.5 * u.norm();
    shape.X_BS = toolkit::Pose(0.5 * (p[i] + p[i + 1]), Quat::FromTwoVectors(Vec3::UnitZ(), u)).abi();
    w.shape.push_back(shape);
  }
}

scene::World between_rollers(double wave, bool chain) {
  scene::World w;
  w.gravity = {0, 0, 0};
  if (chain)
    add_chain(w, wire(wave), kWire, 0);
  else
    add_capsules(w, wire(wave));
  for (const double side : {1.0, -1.0}) {
    const uint32_t body = add_body(w, SWAGE_MOTION_FOLLOWS, 1, {0, 0, side * (kBall + kWire - kOverlap)});
    w.shape.push_back(shape_on(body, 1, SWAGE_SHAPE_SPHERE, kBall));
  }
  scene::reset(w);
  return w;
}

/// Displacement of the wire per piece that passes, once it carries the load [m].
double way_per_piece(double wave, bool chain, double load) {
  scene::World w = between_rollers(wave, chain);
  SlidingChain slider(w, 0, 0, chain ? 0 : scene::kNone, kMass, {kSpeed, 0, 0}, {-load, 0, 0});
  contact::Detector detector(w, {contact::Pair{0, 1, {kFriction, kStiffness, 0}}}, {});
  contact::ContactSet contacts;
  detector.reserve(contacts);
  Dynamics dynamics(w, {});
  FlexibleBody* const self[] = {&slider};
  double x_loaded = 0;
  const int settle = 100, steps = 400;
  for (int i = 0; i < settle + steps; ++i) {
    for (const uint32_t k : {1u, 2u}) {
      // surfaces meet half an overlap inside each of them
      const double rate = (k == 1 ? -1 : 1) * kSpeed / (kBall - 0.5 * kOverlap);
      w.V_WB[k].w = {0, rate, 0};
      w.X_WB[k].q = toolkit::raw(Quat(Eigen::AngleAxisd(rate * w.dt * (i + 1), Vec3::UnitY())));
    }
    dynamics.free_motion(w);
    slider.advance();
    detector.detect(w, contacts);
    dynamics.solve(w, contacts, self);
    dynamics.finish(w);
    if (i + 1 == settle) x_loaded = slider.x().x();
  }
  if (chain) {
    EXPECT_GE(slider.furthest, 45u) << "the rollers have come along the wire";
  }
  return (slider.x().x() - x_loaded) / (steps * w.dt * kSpeed / kPiece);
}

/// Lag caused by the load [m]. Without load the wire lags, too, by 6.7 nm per piece, as the rollers turn by 0.02 rad per step.
double creep_per_piece(double wave, bool chain) {
  return std::abs(way_per_piece(wave, chain, kLoad) - way_per_piece(wave, chain, 0));
}

TEST(Chain, DoesNotCreepWhereAContactGoesFromPieceToPiece) {
  EXPECT_LT(creep_per_piece(0, true), 1e-9);
  EXPECT_LT(creep_per_piece(20e-9, true), 1e-9) << "a wave that rocks it between the rollers";
  EXPECT_GT(creep_per_piece(0, false), 5e-9) << "separate capsules forget at each joint";
}

/// A bent wire across y [m], at height z.
std::vector<Vec3> across(double z, double phase) {
  std::vector<Vec3> p;
  for (int i = -10; i <= 10; ++i) p.emplace_back(30e-6 * std::sin(0.7 * i + phase), i * 0.1e-3 + 1e-5 * phase, z);
  return p;
}
/// The same along x.
std::vector<Vec3> along(double z, double phase) {
  std::vector<Vec3> p;
  for (int i = -10; i <= 10; ++i) p.emplace_back(i * 0.1e-3 + 1e-5 * phase, 30e-6 * std::cos(0.9 * i + phase), z);
  return p;
}

/// Shoots a wire upwards, and the obstacle of `add` downwards or not at all; true when the wire has passed through.
struct Shot {
  double speed = 0, share = 0.5, phase = 0;  // m/s relative; share of the wire's own
};

bool thread_passes_thread(const Shot& shot) {
  scene::World w;
  w.gravity = {0, 0, 0};
  constexpr double kThread = 11e-6, apart = 1.3e-3;
  add_chain(w, across(0, shot.phase), kThread, 0);
  add_chain(w, along(apart, shot.phase), kThread, 1);
  scene::reset(w);
  SlidingChain a(w, 0, 0, 0, 1e-8, {0, 0, shot.share * shot.speed}),
      b(w, 1, 1, 1, 1e-8, {0, 0, (shot.share - 1) * shot.speed});
  contact::Detector detector(w, {contact::Pair{0, 1, {0.2, 1e4, 0}}}, {});
  contact::ContactSet contacts;
  detector.reserve(contacts);
  Dynamics dynamics(w, {});
  FlexibleBody* const self[] = {&a, &b};
  const int steps = 4 + static_cast<int>(3 * apart / (shot.speed * w.dt));
  for (int i = 0; i < steps; ++i) {
    dynamics.free_motion(w);
    a.advance(), b.advance();
    detector.detect(w, contacts);
    dynamics.solve(w, contacts, self);
    dynamics.finish(w);
  }
  return !(apart + b.x().z() - a.x().z() > 0);
}

TEST(Chain, NoThreadPassesThroughAThread) {
  for (const double speed : {0.3, 0.7, 1.7, 5.0})
    for (const double share : {0.0, 0.5, 0.8})
      for (int k = 0; k < 8; ++k)
        EXPECT_FALSE(thread_passes_thread({speed, share, 0.37 * k})) << speed << " m/s, share " << share << ", " << k;
}

/// Against a plate 0.1 mm thick or a needle's arc, which may move as well.
bool thread_passes(int kind, const Shot& shot) {
  scene::World w;
  w.gravity = {0, 0, 0};
  constexpr double kThread = 11e-6, apart = 1.3e-3;
  add_chain(w, across(0, shot.phase), kThread, 0);
  const uint32_t body = add_body(w, SWAGE_MOTION_FOLLOWS, 1, {0, 0, apart});
  scene::Shape shape = shape_on(body, 1, kind, 0.05e-3);
  if (kind == SWAGE_SHAPE_CONVEX) {
    std::vector<Vec3> corner;
    for (int i = 0; i < 8; ++i)
      corner.emplace_back((i & 1) ? 0.3e-3 : -0.3e-3, (i & 2) ? 0.3e-3 : -0.3e-3, (i & 4) ? 0.05e-3 : -0.05e-3);
    const uint32_t start[7] = {0, 4, 8, 12, 16, 20, 24};
    const uint32_t face[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    w.convex.emplace_back();
    EXPECT_EQ(toolkit::build_convex(corner, start, face, w.convex.back()), "");
    shape.convex = 0;
  }
  if (kind == SWAGE_SHAPE_ARC) {
    // the arc lies along x, its top at the body's origin
    shape.arc_radius = 2e-3, shape.sweep = 1;
    shape.X_BS = toolkit::Pose({0, 0, -2e-3}, Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX())) *
                                                  Quat(Eigen::AngleAxisd(M_PI / 2 - 0.5, Vec3::UnitZ()))).abi();
  }
  w.shape.push_back(shape);
  scene::reset(w);
  const double own = shot.share * shot.speed, other = (shot.share - 1) * shot.speed;
  SlidingChain a(w, 0, 0, 0, 1e-8, {0, 0, own});
  contact::Detector detector(w, {contact::Pair{0, 1, {0.2, 1e5, 0}}}, {});
  contact::ContactSet contacts;
  detector.reserve(contacts);
  Dynamics dynamics(w, {});
  FlexibleBody* const self[] = {&a};
  double z = apart;
  const int steps = 4 + static_cast<int>(2 * apart / (shot.speed * w.dt));
  for (int i = 0; i < steps; ++i) {
    z += w.dt * other;
    w.X_WB[body].p.z = z;
    w.V_WB[body].v = {0, 0, other};
    dynamics.free_motion(w);
    a.advance();
    detector.detect(w, contacts);
    dynamics.solve(w, contacts, self);
    dynamics.finish(w);
  }
  return !(z - a.x().z() > 0);
}

TEST(Chain, NoThreadPassesThroughAPlateOrANeedle) {
  for (const int kind : {SWAGE_SHAPE_CONVEX, SWAGE_SHAPE_ARC})
    for (const double speed : {0.3, 0.7, 1.7, 5.0})
      for (const double share : {0.0, 0.5, 1.0})
        for (int k = 0; k < 8; ++k)
          EXPECT_FALSE(thread_passes(kind, {speed, share, 0.37 * k}))
              << "kind " << kind << ", " << speed << " m/s, share " << share << ", " << k;
}

}  // namespace chain_test
}  // namespace swage::dynamics
