// SPDX-License-Identifier: Apache-2.0
//
// What a query may not lose or invent: the deepest of many contacts, ends that are tangent, edges that are exactly aligned.
#include <gtest/gtest.h>

#include "base/rng.hpp"
#include "contact/narrow_phase.hpp"
#include "least.hpp"
#include "solids.hpp"

namespace swage::contact {
namespace kept_test {

using toolkit::Quat;

Solid box(const Vec3& half) {
  bench::Jaw j;
  for (const double z : {-1.0, 1.0})
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      j.vertex.push_back(Vec3(x, y, z).cwiseProduct(half));
  j.face = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return bench::contact_solid(j);
}

Solid arc(double arc_radius, double sweep) {
  scene::Shape s;
  s.kind = SWAGE_SHAPE_ARC;
  s.X_BS = Pose().abi();
  s.radius = 50e-6, s.arc_radius = arc_radius, s.sweep = sweep;
  return make_solid(s, {});
}

// an arch whose start is its highest place, and tangent to the face: it is lowest at its other end alone
TEST(Kept, AnEndThatIsTangentIsNoMinimumWhereTheWireSinks) {
  const Solid plate = box({1e-3, 1e-3, 0.5e-3}), a = arc(100e-6, std::numbers::pi / 3);
  // the arc's x up, its y along x: exact turns
  toolkit::Mat3 R;
  R.col(0) = Vec3::UnitZ(), R.col(1) = Vec3::UnitX(), R.col(2) = Vec3::UnitY();
  const double end = 100e-6 * std::cos(std::numbers::pi / 3);
  Query query;
  query.margin = 100e-6, query.flatness = 0;
  for (const double overlap : {-20e-6, 0.0, 5e-6}) {
    Manifold m;
    Separation none;
    const Frame X(Vec3(0, 0, 0.5e-3 + a.radius - end - overlap), R);
    collide(a, X, plate, Frame(), query, none, m);
    ASSERT_EQ(m.count, 1) << overlap;
    EXPECT_NEAR(m.candidate[0].touch.gap, -overlap, 1e-12);
  }
}

// a wire round a cylinder, pressed towards one side: more minima than there is room for
TEST(Kept, TheDeepestOfManyStay) {
  scene::Shape s;
  s.kind = SWAGE_SHAPE_CYLINDER;
  s.X_BS = Pose().abi();
  s.radius = 1e-3, s.half_length = 1e-3;
  const Solid cylinder = make_solid(s, {});
  const double out = cylinder.convex.vertex[0].head<2>().norm();
  for (const double sweep : {2.4, 4.0, 5.5}) {
    const Solid a = arc(out + 50e-6, sweep);
    for (const double along : {0.1, 0.5, 0.9}) {
      // the place of the wire that is pressed in
      const double at = along * sweep;
      const Vec3 pressed = -8e-6 * Vec3(std::cos(at), std::sin(at), 0);
      double exact = 1;
      for (int i = 0; i <= 40000; ++i) {
        const double angle = sweep * i / 40000;
        const Vec3 p = pressed + a.arc.radius * Vec3(std::cos(angle), std::sin(angle), 0);
        double d = 1;
        for (const auto& e : cylinder.convex.edge) {
          const Vec3& v = cylinder.convex.vertex[e.v0];
          if (std::abs(e.u.z()) < 0.5) continue;  // corners of the polygon
          d = std::min(d, (p - v).head<2>().norm());
        }
        exact = std::min(exact, d - a.radius);
      }
      Query query;
      query.flatness = 0;
      Manifold m;
      Separation none;
      collide(a, Frame(pressed, toolkit::Mat3::Identity()), cylinder, Frame(), query, none, m);
      EXPECT_NEAR(least(m), exact, 1e-9) << sweep << " " << along;
      EXPECT_GT(m.count, 10);
    }
  }
}

// boxes turned by right angles: which edges cross is a matter of rounding, how far the boxes are apart is not
TEST(Kept, AlignedBoxesAreAsFarApartAsTheyAre) {
  base::Xoshiro256 random(3);
  const auto draw = [&](double low, double high) { return random.uniform(low, high); };
  Query query;
  query.margin = 0.2e-3, query.flatness = 0;
  int near = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto grid = [&] { return 0.25e-3 * (1 + std::floor(draw(0, 4))); };
    const Vec3 half_a(grid(), grid(), grid()), half_b(grid(), grid(), grid());
    Quat q = Quat::Identity();
    Vec3 turned = half_a;
    for (int i = 0; i < 3; ++i)
      if (draw(0, 1) < 0.5) {
        q = toolkit::exp_rotation(0.5 * std::numbers::pi * Vec3::Unit(i)) * q;
        std::swap(turned[(i + 1) % 3], turned[(i + 2) % 3]);
      }
    // aligned sides or not, and apart along one axis, or not at all
    const int axis = static_cast<int>(draw(0, 3));
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      const double flush = turned[i] - half_b[i];
      p[i] = i == axis ? (turned[i] + half_b[i] + draw(-0.1e-3, 0.15e-3)) : draw(0, 1) < 0.5 ? flush : -flush;
    }
    const double exact = p[axis] - turned[axis] - half_b[axis];
    bool deepest_elsewhere = false;
    for (int i = 0; i < 3; ++i) deepest_elsewhere |= i != axis && std::abs(p[i]) - turned[i] - half_b[i] > exact;
    if (deepest_elsewhere) continue;
    ++near;
    const Pose X_W(Vec3(1e-3, 2e-3, -1e-3), toolkit::exp_rotation({draw(-3, 3), draw(-3, 3), draw(-3, 3)}));
    Manifold m;
    Separation none;
    collide(box(half_a), Frame(X_W * Pose(p, q)), box(half_b), Frame(X_W), query, none, m);
    ASSERT_GT(m.count, 0) << k;
    for (int i = 0; i < m.count; ++i)
      ASSERT_NEAR(m.candidate[static_cast<size_t>(i)].touch.gap, exact, 1e-9) << k;
  }
  EXPECT_GT(near, 1000);
}

}  // namespace kept_test
}  // namespace swage::contact
