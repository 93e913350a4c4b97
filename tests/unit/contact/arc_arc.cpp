// SPDX-License-Identifier: Apache-2.0
//
// Needle against needle, judged by samples of one and projections on the other.
#include <gtest/gtest.h>

#include "base/rng.hpp"
#include "contact/narrow_phase.hpp"
#include "solids.hpp"

namespace swage::contact {
namespace arc_arc_test {

using bench::Needle;
using toolkit::Quat;

/// Distance of p to the arc of a needle in its frame, by its angle.
double distance(const Needle& n, const Vec3& p) {
  const double theta = std::clamp(std::atan2(p.y(), p.z() + n.offset()), -0.5 * n.arc, 0.5 * n.arc);
  return std::min(
      {(p - n.point(theta)).norm(), (p - n.point(-0.5 * n.arc)).norm(), (p - n.point(0.5 * n.arc)).norm()});
}

double searched_gap(const Needle& n, const Pose& X_BA) {
  constexpr int kSamples = 600;
  const auto d = [&](double s) { return distance(n, X_BA * n.point(n.arc * (s - 0.5))); };
  double best = 1, at = 0;
  for (int i = 0; i <= kSamples; ++i)
    if (d(i / double{kSamples}) < best) best = d(i / double{kSamples}), at = i / double{kSamples};
  double a = std::max(0.0, at - 1.0 / kSamples), b = std::min(1.0, at + 1.0 / kSamples);
  for (int k = 0; k < 60; ++k) {
    const double c = b - 0.6180339887498949 * (b - a), e = a + 0.6180339887498949 * (b - a);
    (d(c) < d(e) ? b : a) = d(c) < d(e) ? e : c;
  }
  return std::min(best, d(0.5 * (a + b))) - 2 * n.wire_radius();
}

TEST(ArcArc, LeastGapAgreesWithASearch) {
  const Needle n;
  const Solid a = bench::contact_solid(n);
  base::Xoshiro256 random(9);
  Query query;
  query.margin = 100e-6;
  int near = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto draw = [&](double size) { return random.uniform(-size, size); };
    // a place of each comes near the other
    const Quat q = toolkit::exp_rotation({draw(3), draw(3), draw(3)});
    const Vec3 offset(draw(120e-6), draw(120e-6), draw(120e-6));
    const Pose X_WB(Vec3(1e-3, 0, 0), toolkit::exp_rotation({draw(3), draw(3), draw(3)}));
    const Pose X_BA(n.point(n.arc * draw(0.5)) + offset - q * n.point(n.arc * draw(0.5)), q);
    const double exact = searched_gap(n, X_BA);
    Manifold m;
    Separation none;
    const Pose X_WA = X_WB * X_BA;
    collide(a, Frame(X_WA), a, Frame(X_WB), query, none, m);
    if (exact > 100e-6 - 1e-9 || exact < -90e-6) continue;
    ++near;
    double least = 1;
    for (int i = 0; i < m.count; ++i) {
      const Candidate& c = m.candidate[static_cast<size_t>(i)];
      least = std::min(least, c.touch.gap);
      ASSERT_NEAR(reevaluate(c, Frame(X_WA), Frame(X_WB)).gap, c.touch.gap, 1e-12);
    }
    ASSERT_NEAR(least, exact, 1e-9) << "pose " << k;
  }
  EXPECT_GT(near, 2000);
}

TEST(ArcArc, TwoCrossingsAreTwoContacts) {
  // two half circles in one plane, moved apart by less than their size, lifted by a wire
  Needle n;
  n.arc = 0.9 * 2 * std::numbers::pi, n.chord = 2 * 1e-3 * std::sin(0.5 * n.arc);
  const Solid a = bench::contact_solid(n);
  Manifold m;
  Separation none;
  Query query;
  collide(a, Frame(Pose(Vec3(n.wire_diameter - 1e-6, 1e-3, 0), Quat::Identity())), a, Frame(), query, none,
          m);
  ASSERT_EQ(m.count, 2);
  for (size_t i = 0; i < 2; ++i) EXPECT_NEAR(m.candidate[i].touch.gap, -1e-6, 1e-9);
}

}  // namespace arc_arc_test
}  // namespace swage::contact
