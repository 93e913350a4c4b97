// SPDX-License-Identifier: Apache-2.0
//
// Threads solved as bands move like threads solved by the mobility of their points: alone, in contact with each other and with
// bodies, and one of each kind.
#include <gtest/gtest.h>
#include <swage/abi/band.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "contact/detector.hpp"
#include "dynamics/banded_body.hpp"
#include "dynamics/dynamics.hpp"
#include "rod_body.hpp"

namespace swage::dynamics {
namespace banded_body_test {

using toolkit::Vec3;

constexpr double kRadius = 11e-6, kPiece = 0.3e-3;  // m
constexpr double kApart = 0.12e-3, kBall = 0.2e-3, kPost = 3e-3;  // m
constexpr int kPieces = 16;

std::vector<Vec3> line(const Vec3& middle, const Vec3& along, double bow) {
  std::vector<Vec3> p;
  for (int i = 0; i <= kPieces; ++i) {
    const double x = (i - 0.5 * kPieces) / (0.5 * kPieces);
    p.push_back(middle + 0.5 * kPieces * kPiece * x * along + bow * x * x * Vec3::UnitZ());
  }
  return p;
}

/// A ball of 40 ug lies on two threads that are held at their ends; two round posts rise below and move along them.
struct Heap {
  Heap(bool first_as_band, bool second_as_band) : world(make()) {
    const auto section = toolkit::RodSection::round(2 * kRadius, 2.5e9, 0.39, 1140);
    a = std::make_unique<RodBody>(world, 0, 0, section, first_as_band);
    b = std::make_unique<RodBody>(world, 1, 1, section, second_as_band);
    for (const int end : {0, kPieces}) a->hold(end), b->hold(end);
    std::vector<contact::Pair> pairs;
    for (const auto& [x, y] : {std::pair{0u, 1u}, {0u, 2u}, {1u, 2u}}) pairs.push_back({x, y, {0.2, 1e4, 0}});
    detector = std::make_unique<contact::Detector>(world, pairs, contact::Options{});
    dynamics = std::make_unique<Dynamics>(world, Options());
    dynamics->solve_sparse_beyond(0);
    detector->reserve(contacts);
  }
  static scene::World make() {
    scene::World w;
    w.gravity = {0, 0, -9.80665};
    for (const uint32_t k : {0u, 1u})
      add_chain(w, line({0, k == 0 ? -kApart : kApart, 0}, Vec3::UnitX(), 0), kRadius, k);
    for (const double x : {-1e-3, 1.2e-3}) {
      const uint32_t post = add_body(w, SWAGE_MOTION_FOLLOWS, 2, {x, 0, -kRadius - kPost - 1e-6});
      w.shape.push_back(shape_on(post, 2, SWAGE_SHAPE_SPHERE, kPost));
    }
    const uint32_t ball = add_body(w, SWAGE_MOTION_DYNAMIC, 2, {0.1e-3, 0, 1.0001 * std::sqrt((kBall + kRadius) * (kBall + kRadius) - kApart * kApart)});
    w.body[ball].mass = 4e-8;
    for (double& I : w.body[ball].inertia) I = 6.4e-16;
    w.shape.push_back(shape_on(ball, 2, SWAGE_SHAPE_SPHERE, kBall));
    scene::reset(w);
    return w;
  }
  void step() {
    const Vec3 v = world.step < 60 ? Vec3(0, 0, 0.5e-3) : Vec3(0.4e-3, 0.1e-3, 0);  // m/s
    for (const uint32_t post : {2u, 3u}) {
      world.X_WB[post].p = toolkit::raw(Vec3(toolkit::vec(world.X_WB[post].p) + world.dt * v));
      world.V_WB[post].v = toolkit::raw(v);
    }
    ++world.step;
    dynamics->free_motion(world);
    a->advance(), b->advance();
    detector->detect(world, contacts);
    FlexibleBody* const self[] = {a.get(), b.get()};
    dynamics->solve(world, contacts, self);
    dynamics->finish(world);
  }
  /// Copies the state of another heap.
  void take(Heap& other) {
    world = other.world;
    contacts = other.contacts;
    a->take(*other.a), b->take(*other.b);
  }
  double most_force() const {
    double most = 0;
    for (const contact::Contact& c : contacts.contact) most = std::max(most, c.f_a_W.norm());
    return most;
  }

  scene::World world;
  std::unique_ptr<RodBody> a, b;
  std::unique_ptr<contact::Detector> detector;
  std::unique_ptr<Dynamics> dynamics;
  contact::ContactSet contacts;
};

/// Distance between the states of two heaps [m].
double apart(Heap& x, Heap& y) {
  double most = (toolkit::vec(x.world.X_WB.back().p) - toolkit::vec(y.world.X_WB.back().p)).norm();
  for (int i = 0; i <= kPieces; ++i) {
    most = std::max(most, (x.a->state().node(i) - y.a->state().node(i)).norm());
    most = std::max(most, (x.b->state().node(i) - y.b->state().node(i)).norm());
  }
  return most;
}

/// Compared step by step from the same state. Where Newton stalls there may be several solutions: a few steps may differ more.
TEST(BandedBody, GoesAsItsComplianceDoes) {
  Heap dense(false, false), bands(true, true), mixed(true, false);
  uint32_t alike = 0, same = 0, slid = 0;
  for (int i = 0; i < 200; ++i) {
    for (Heap* h : {&bands, &mixed}) h->take(dense);
    for (Heap* h : {&dense, &bands, &mixed}) h->step();
    const double off = std::max(apart(dense, bands), apart(dense, mixed));
    EXPECT_LT(off, 1e-7) << i;
    alike += off < 1e-8, same += off < 1e-12;
    for (const contact::Contact& c : bands.contacts.contact) slid += c.slip > 0;
    EXPECT_GT(bands.most_force(), 1e-8);
  }
  EXPECT_GT(alike, 190u);
  EXPECT_GT(same, 120u);
  EXPECT_GT(slid, 400u);
  for (Heap* h : {&dense, &bands, &mixed}) {
    EXPECT_EQ(h->dynamics->stats().health.unanswered, 0u);
    EXPECT_LE(h->dynamics->stats().health.not_converged, 3u) << "of 200, where the ball has just come down";
  }
}

/// A body of 0.5 mg with the first segment of a bent thread of 7 mg/m (as in a needle's hole: two places, and that it does not turn) flies.
struct Towed {
  Towed(bool as_band, uint32_t sparse_beyond) : world(make()) {
    rod = std::make_unique<RodBody>(world, 0, 0, toolkit::RodSection::round(2 * kRadius, 2.5e9, 0.39, 18000), as_band);
    dynamics = std::make_unique<Dynamics>(world, Options());
    dynamics->solve_sparse_beyond(sparse_beyond);
    const toolkit::RodState s = rod->state();
    const Vec3 out = s.edge(0).normalized(), p = s.node(0);
    p_BH = toolkit::Pose(world.X_WB[1]).inverse() * p;
    out_B = out, up_B = s.material(0);
  }
  static constexpr int kNodes = 49;
  static constexpr double kEdge = 0.5e-3, kMass = 4.84e-7;  // m, kg
  static scene::World make() {
    scene::World w;
    w.gravity = {0, 0, -9.80665};
    std::vector<Vec3> p{Vec3::Zero()};
    for (int i = 0; i + 1 < kNodes; ++i) p.push_back(p.back() + kEdge * Vec3(1, 0.03, -0.02 - 1e-3 * i).normalized());
    add_chain(w, p, kRadius, 0);
    const uint32_t body = add_body(w, SWAGE_MOTION_DYNAMIC, 1, {-2.5e-3, 0.9e-3, 0});
    w.body[body].mass = kMass;
    w.body[body].inertia[0] = 3e-12, w.body[body].inertia[1] = 1e-12, w.body[body].inertia[2] = 3.5e-12;
    scene::reset(w);
    return w;
  }
  void step() {
    ++world.step;
    dynamics->free_motion(world);
    rod->advance();
    const toolkit::RodState s = rod->state();
    const toolkit::Pose X(world.X_WB[1]);
    const Vec3 out = X.q * out_B, up = X.q * up_B, side = out.cross(up);
    const Vec3 end = X * p_BH, mouth = end + 0.5 * kEdge * out, place = s.node(0) + 0.5 * s.edge(0);
    Tie all[3];
    for (Tie& tie : all) tie.body_a = 1, tie.body_b = 0, tie.axis_W = out, tie.law.k_across = 1e5;
    all[0].p_W = mouth, all[0].offset_W = mouth - place, all[0].law.k_along = 1e5;
    all[1].p_W = end, all[1].offset_W = end - s.node(0);
    all[2].p_W = mouth + kRadius * up, all[2].axis_W = side;
    all[2].offset_W = kRadius * side.dot(up - s.material(0)) * side;
    all[2].law.k_across = 0, all[2].law.k_along = 1e5;
    FlexibleBody* const self[] = {rod.get()};
    dynamics->solve(world, contacts, self, all);
    dynamics->finish(world);
  }
  Vec3 momentum() {
    Vec3 sum = kMass * toolkit::vec(world.V_WB[1].v);
    const double piece = 18000 * M_PI * kRadius * kRadius * kEdge;
    for (int i = 0; i < kNodes; ++i) sum += piece * (i == 0 || i == kNodes - 1 ? 0.5 : 1) * rod->state().velocity(i);
    return sum;
  }
  scene::World world;
  std::unique_ptr<RodBody> rod;
  std::unique_ptr<Dynamics> dynamics;
  contact::ContactSet contacts;
  Vec3 p_BH, out_B, up_B;
};

/// It falls, swings and bends, solved by points, by forces and by displacements.
TEST(BandedBody, TiedToABodyLosesNoMomentum) {
  Towed points(false, 32), forces(true, 32), sparse(true, 0);
  const double mass = Towed::kMass + 18000 * M_PI * kRadius * kRadius * Towed::kEdge * (Towed::kNodes - 1);
  for (int i = 0; i < 60; ++i) {
    for (Towed* t : {&points, &forces, &sparse}) {
      t->step();
      const double whole = mass * 9.80665 * 1e-3 * (i + 1);
      EXPECT_LT((t->momentum() + whole * Vec3::UnitZ()).norm(), 1e-5 * whole) << i << (t == &points ? " points" : t == &sparse ? " sparse" : " forces");
    }
    EXPECT_LT((toolkit::vec(sparse.world.X_WB[1].p) - toolkit::vec(forces.world.X_WB[1].p)).norm(), 1e-9) << i;
    for (int k = 0; k < Towed::kNodes; ++k)
      EXPECT_LT((sparse.rod->state().node(k) - forces.rod->state().node(k)).norm(), 1e-8) << i << " " << k;
  }
  for (Towed* t : {&points, &forces, &sparse}) EXPECT_EQ(t->dynamics->stats().health.not_converged, 0u);
}

// Elimination from either end gives the same columns, for any requested range, and the same motion without contacts.
TEST(BandedBody, IsTheSameFromEitherEnd) {
  scene::World w;
  w.gravity = {0, 0, -9.80665};
  add_chain(w, line(Vec3::Zero(), Vec3::UnitX(), 0.2e-3), kRadius, 0);
  scene::reset(w);
  RodBody rod(w, 0, 0, toolkit::RodSection::round(2 * kRadius, 2.5e9, 0.39, 1140), true);
  rod.hold(0);
  rod.advance();
  BandedBody from_first(0, kPieces + 1), from_last(0, kPieces + 1);
  from_first.begin(), from_last.begin();
  uint64_t stiffer[2] = {0, 0};
  ASSERT_TRUE(from_first.linearise(rod, false, stiffer[0]));
  ASSERT_TRUE(from_last.linearise(rod, true, stiffer[1]));
  std::vector<double> a(from_first.unknowns()), b(a.size());
  from_first.to_free(a.data()), from_last.to_free(b.data());
  double largest = 0;
  for (const double x : a) largest = std::max(largest, std::abs(x));
  for (size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9 * largest) << i;
  // a wider range later extends the known part of a column
  for (const auto& [least, most] : {std::pair{2u, 3u}, {1u, 9u}, {0u, uint32_t{kPieces}}})
    for (const uint32_t vertex : {least, most}) {
      const double *p = from_first.column(vertex, least, most), *q = from_last.column(vertex, least, most);
      double size = 0;
      for (uint32_t k = 16 * least; k < 16 * (most + 1); ++k) size = std::max(size, std::abs(p[k]));
      EXPECT_GT(size, 0);
      for (uint32_t k = 16 * least; k < 16 * (most + 1); ++k) EXPECT_NEAR(p[k], q[k], 1e-9 * size) << vertex << ' ' << k;
    }
}

/// A chain of two vertices whose matrix can be factored from one level of stiffness on.
struct Soft : FlexibleBody {
  uint32_t object() const noexcept override { return 0; }
  bool mobility(std::span<const swage_contact_point>, double*, double*) noexcept override { return false; }
  void apply_impulses(std::span<const swage_contact_point>, const double*) noexcept override {}
  bool linearise(uint32_t stiffer, double* stiffness, double*) noexcept override {
    asked.push_back(stiffer);
    for (int j = 0; j < 8; ++j) stiffness[SWAGE_BAND_COLUMN * j] = stiffer >= needs ? 1 + stiffer : -1.0;
    return true;
  }
  uint32_t needs = 0;
  std::vector<uint32_t> asked;
};

// A step mostly needs the level of the one before. The level found is the one that a search from the softest finds.
TEST(BandedBody, BeginsOneBelowTheLevelOfTheLastStep) {
  Soft soft;
  BandedBody band(0, 2);
  uint64_t stiffer = 0;
  const auto asked = [&](uint32_t needs) {
    soft.needs = needs, soft.asked.clear();
    band.begin();
    EXPECT_TRUE(band.linearise(soft, false, stiffer)) << needs;
    EXPECT_EQ(stiffer, needs);
    return soft.asked;
  };
  using Levels = std::vector<uint32_t>;
  EXPECT_EQ(asked(0), Levels({0}));
  EXPECT_EQ(asked(5), Levels({0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(asked(5), Levels({4, 5}));
  EXPECT_EQ(asked(3), Levels({4, 3, 2, 3}));
  EXPECT_EQ(asked(4), Levels({2, 3, 4}));
  EXPECT_EQ(asked(0), Levels({3, 2, 1, 0}));
  EXPECT_EQ(asked(0), Levels({0}));
  soft.needs = SWAGE_BAND_STIFFER + 1;
  EXPECT_FALSE(band.linearise(soft, false, stiffer)) << "never soft enough";
  EXPECT_EQ(asked(0).back(), 0u);
}

}  // namespace banded_body_test
}  // namespace swage::dynamics
