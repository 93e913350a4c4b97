// SPDX-License-Identifier: Apache-2.0
//
// Chains in the detector: against all pairs of pieces in long double; where contacts are told of once; which are left out; and what
// is remembered where a contact goes from piece to piece.
#include <gtest/gtest.h>

#include "chain_scene.hpp"
#include "solids.hpp"

namespace swage::contact {
namespace chain_test {

constexpr double kRadius = 11e-6, kBend = 30e-6;  // m

Pair joins(uint32_t a, uint32_t b) {
  Pair p;
  p.object_a = a, p.object_b = b;
  return p;
}

/// Detects once.
ContactSet detect(const scene::World& world, std::vector<Pair> pairs, const Options& options = {}) {
  Detector detector(world, std::move(pairs), options);
  ContactSet set;
  detector.reserve(set);
  detector.detect(world, set);
  EXPECT_EQ(set.dropped, 0u);
  return set;
}

Options points_only() {
  Options o;
  o.flatness = 0, o.capacity = 20000;
  return o;
}

/// All pairs of pieces of two chains, or of one with itself.
class AllPairs {
 public:
  AllPairs(const scene::World& w, uint32_t a, uint32_t b) : a_(w, w.chain[a]), b_(w, w.chain[b]), self_(a == b) {}

  /// Whether a contact with the next piece, and not this one, is nearer: the distance falls on beyond an end.
  static bool goes_on(const scene::ChainView& c, uint32_t i, long double share, const Vec3& away) {
    const bool start = share <= 0, end = share >= 1;
    if (start && i > 0 && away.dot(c.p(i - 1) - c.p(i)) < 0) return true;
    return end && i + 2 < c.vertices() && away.dot(c.p(i + 2) - c.p(i + 1)) < 0;
  }
  /// Calls f(i, j, nearest, whether it is a lowest place of both chains) for all pairs.
  template <class F>
  void each(double exclusion, const F& f) const {
    for (uint32_t i = 0; i + 1 < a_.vertices(); ++i)
      for (uint32_t j = self_ ? i + 2 : 0; j + 1 < b_.vertices(); ++j) {
        const Nearest at = nearest(a_.p(i), a_.p(i + 1), b_.p(j), b_.p(j + 1));
        const auto s = static_cast<double>(at.s), t = static_cast<double>(at.t);
        const double along = b_.s(j) + t * (b_.s(j + 1) - b_.s(j)) - a_.s(i) - s * (a_.s(i + 1) - a_.s(i));
        if (self_ && along < exclusion) continue;
        const Vec3 n = a_.p(i) + s * (a_.p(i + 1) - a_.p(i)) - b_.p(j) - t * (b_.p(j + 1) - b_.p(j));
        f(i, j, at, !goes_on(a_, i, at.s, n) && !goes_on(b_, j, at.t, -n));
      }
  }

 private:
  scene::ChainView a_, b_;
  bool self_;
};

/// Returns how many lowest places there are.
size_t expect_all_pairs(const scene::World& w, uint32_t a, uint32_t b, const ContactSet& set, double margin) {
  const AllPairs all(w, a, b);
  const double exclusion = a == b ? M_PI * kBend : 0;
  size_t lowest = 0;
  all.each(exclusion, [&](uint32_t i, uint32_t j, const Nearest& at, bool is_lowest) {
    const auto gap = static_cast<double>(at.distance) - 2 * kRadius;
    if (!is_lowest || gap > margin - 1e-12) return;
    ++lowest;
    double best = 1;
    for (const Contact& c : set.contact) {
      // the neighbour may tell of what lies in a vertex of both, which it finds there to some roundings
      const auto in_vertex = [](double share) { return std::abs(share - 0.5) > 0.5 - 1e-12; };
      const bool here = (c.place_a.segment == i || in_vertex(c.place_a.share)) &&
                        (c.place_b.segment == j || in_vertex(c.place_b.share));
      if (here) best = std::min(best, std::abs(c.gap - gap));
    }
    EXPECT_LT(best, 1e-13) << "pieces " << i << " and " << j << ", gap " << gap;
  });
  // and nothing else
  for (const Contact& c : set.contact) {
    bool found = false;
    all.each(exclusion, [&](uint32_t i, uint32_t j, const Nearest& at, bool) {
      found = found || (i == c.place_a.segment && j == c.place_b.segment &&
                        std::abs(static_cast<double>(at.distance) - 2 * kRadius - c.gap) < 1e-13);
    });
    EXPECT_TRUE(found) << "no such contact: pieces " << c.place_a.segment << " and " << c.place_b.segment;
  }
  // lowest vertices are shared by up to four pairs of pieces, and told of once
  EXPECT_LE(set.contact.size(), lowest);
  return lowest;
}

TEST(Chain, TwoThreadsTouchWhereAllPairsSay) {
  size_t lowest = 0;
  for (uint32_t seed = 1; seed <= 100; ++seed) {
    scene::World w;
    const double length = seed % 3 == 0 ? 20e-6 : 120e-6;
    add_chain(w, wander(90, length, 0.4, 0.5e-3, seed), kRadius, kBend, 0);
    add_chain(w, wander(70, length, 0.4, 0.5e-3, seed + 1000), kRadius, kBend, 1);
    const ContactSet set = detect(w, {joins(0, 1)}, points_only());
    lowest += expect_all_pairs(w, 0, 1, set, 0.02 * w.length);
  }
  EXPECT_GT(lowest, 40u);
}

TEST(Chain, AThreadTouchesItselfWhereAllPairsSay) {
  size_t lowest = 0;
  for (uint32_t seed = 1; seed <= 100; ++seed) {
    scene::World w;
    add_chain(w, wander(150, seed % 3 == 0 ? 25e-6 : 90e-6, 0.4, 0.4e-3, seed), kRadius, kBend, 0);
    const ContactSet set = detect(w, {joins(0, 0)}, points_only());
    lowest += expect_all_pairs(w, 0, 0, set, 0.02 * w.length);
  }
  EXPECT_GT(lowest, 80u);
}

/// Pieces as capsules on bodies of their own: what the detector has always said of them.
double least_gap_of_capsules(const scene::World& w, const scene::Shape& other) {
  scene::World rigid;
  rigid.convex = w.convex;
  const scene::ChainView chain(w, w.chain[0]);
  std::vector<Pair> pairs;
  for (uint32_t i = 0; i + 1 < chain.vertices(); ++i) {
    const Vec3 u = chain.p(i + 1) - chain.p(i);
    scene::Shape capsule = ball(kRadius);
    capsule.kind = SWAGE_SHAPE_CAPSULE, capsule.half_length = 0.5 * u.norm();
    add_shape(rigid, capsule, 0,
              {0.5 * (chain.p(i) + chain.p(i + 1)), toolkit::Quat::FromTwoVectors(Vec3::UnitZ(), u)},
              SWAGE_MOTION_FLEXIBLE);
  }
  add_shape(rigid, other, 1);
  double least = 1;
  for (const Contact& c : detect(rigid, {joins(0, 1)}, points_only()).contact) least = std::min(least, c.gap);
  return least;
}

TEST(Chain, MeetsEveryKindOfShapeAsItsPiecesDo) {
  scene::Shape capsule = ball(60e-6), cylinder = ball(60e-6), arc = ball(50e-6);
  capsule.kind = SWAGE_SHAPE_CAPSULE, capsule.half_length = 0.3e-3;
  cylinder.kind = SWAGE_SHAPE_CYLINDER, cylinder.half_length = 0.3e-3;
  arc.kind = SWAGE_SHAPE_ARC, arc.arc_radius = 0.4e-3, arc.sweep = 2;
  scene::Shape jaw = bench::convex_shape();
  jaw.convex = 0;
  for (const scene::Shape& other : {ball(80e-6), capsule, cylinder, arc, jaw})
    for (const bool chain_first : {true, false})
      for (uint32_t seed = 1; seed <= 6; ++seed) {
        scene::World w;
        w.convex = {bench::convex(bench::jaw(1))};
        add_chain(w, wander(60, 120e-6, 0.4, 0.4e-3, seed), kRadius, kBend, 0);
        add_shape(w, other, 1);
        const ContactSet set = detect(w, {chain_first ? joins(0, 1) : joins(1, 0)}, points_only());
        double least = 1;
        for (const Contact& c : set.contact) {
          least = std::min(least, c.gap);
          const ChainPlace& place = chain_first ? c.place_a : c.place_b;
          const scene::ChainView chain(w, w.chain[0]);
          const Vec3 on_line = (1 - place.share) * chain.p(place.segment) + place.share * chain.p(place.segment + 1);
          EXPECT_NEAR((on_line - c.p_W).norm(), std::abs(kRadius + 0.5 * c.gap), 1e-12);
          EXPECT_EQ((chain_first ? c.place_b : c.place_a).segment, scene::kNone);
          // and found again at the same poses
          const size_t i = static_cast<size_t>(&c - set.contact.data());
          const Touch again = reevaluate(set.candidate[i], Frame(w.X_WB[c.body_a]), Frame(w.X_WB[c.body_b]));
          EXPECT_NEAR(again.gap, c.gap, 1e-13);
          EXPECT_LT((again.n_W - c.n_W).norm(), 1e-6);
        }
        EXPECT_NEAR(least, least_gap_of_capsules(w, other), 1e-13) << "kind " << other.kind << " seed " << seed;
      }
}

TEST(Chain, LiesOnASurfaceThatIsAGrid) {
  scene::World w;
  add_chain(w, {{-0.5e-3, 0, 9e-6}, {0, 1e-6, 10e-6}, {0.5e-3, 0, 9e-6}}, kRadius, kBend, 0);
  scene::HeightFieldInfo field{9, 9, 0.25e-3, 0.25e-3, 1e-3, std::vector<double>(81, 0.0), scene::kNone};
  w.field.push_back(field);
  scene::Shape surface;
  surface.kind = SWAGE_SHAPE_HEIGHT_FIELD, surface.field = 0;
  surface.X_BS = Pose(Vec3(-1e-3, -1e-3, 0), toolkit::Quat::Identity()).abi();
  add_shape(w, surface, 1);
  const ContactSet set = detect(w, {joins(0, 1)}, points_only());
  double least = 1;
  for (const Contact& c : set.contact) least = std::min(least, c.gap);
  EXPECT_NEAR(least, -2e-6, 1e-15);
}

// the radius of the piece is 0 where it is cut
TEST(Chain, WhatIsCutAwayTouchesNothing) {
  scene::World w;
  add_chain(w, {{-1e-3, 0, 0}, {-0.1e-3, 0, 0}, {0.1e-3, 0, 0}, {1e-3, 0, 0}}, kRadius, kBend, 0);
  add_shape(w, ball(50e-6), 1, {Vec3(0, 0, 60e-6), toolkit::Quat::Identity()});
  EXPECT_EQ(detect(w, {joins(0, 1)}).contact.size(), 1u);
  w.plugin_state[w.chain[0].state + 7 * 4 + 1] = 0;
  EXPECT_EQ(detect(w, {joins(0, 1)}).contact.size(), 0u);
}

// a hairpin of the least radius does not touch itself; legs that come together do
TEST(Chain, NeighboursAlongTheThreadDoNotTouch) {
  const auto hairpin = [](double legs) {
    std::vector<Vec3> p;
    for (int i = 0; i < 10; ++i) p.emplace_back((10 - i) * 50e-6, legs, 0);
    for (int i = 0; i <= 12; ++i) p.emplace_back(-kBend * std::sin(M_PI * i / 12), kBend * std::cos(M_PI * i / 12), 0);
    for (int i = 1; i <= 10; ++i) p.emplace_back(i * 50e-6, -legs, 0);
    return p;
  };
  scene::World w;
  add_chain(w, hairpin(kBend), kRadius, kBend, 0);
  for (const Contact& c : detect(w, {joins(0, 0)}).contact) EXPECT_GT(c.gap, 0);
  scene::World closed;
  add_chain(closed, hairpin(0.99 * kRadius), kRadius, kBend, 0);
  double least = 1;
  for (const Contact& c : detect(closed, {joins(0, 0)}).contact) least = std::min(least, c.gap);
  EXPECT_NEAR(least, -0.02 * kRadius, 1e-9);
}

/// A ball that is moved along a bent thread, its lowest place told of once, without a jump.
TEST(Chain, AContactGoesOverAVertexWithoutAJump) {
  scene::World w;
  std::vector<Vec3> p;
  for (int i = 0; i <= 20; ++i) p.emplace_back(i * 50e-6, 0, 0.02e-3 * std::sin(0.4 * i));
  add_chain(w, p, kRadius, kBend, 0);
  const uint32_t body = add_shape(w, ball(200e-6), 1, {}, SWAGE_MOTION_FOLLOWS);
  Detector detector(w, {joins(0, 1)}, points_only());
  ContactSet set;
  detector.reserve(set);
  constexpr double kPressed = 0.1e-6;  // m
  double s_before = -1, before = 0, worst = 0;
  for (int k = 0; k <= 16000; ++k) {
    const double x = 0.1e-3 + 0.05e-6 * k;
    w.X_WB[body].p = {x, 0, 0.205e-3};
    detector.detect(w, set);
    double best = 1, s = 0;
    for (const Contact& c : set.contact)
      if (c.gap < best) best = c.gap, s = c.place_a.s;
    // what a touch bears that is pressed in by 0.1 um: no piece takes over with a jump, nor does a joint bear like two
    double pressed = 0;
    for (const Contact& c : set.contact) pressed += c.weight * std::max(0.0, best + kPressed - c.gap);
    EXPECT_GT(pressed, 0.7 * kPressed) << "x " << x;
    if (before > 0) worst = std::max(worst, std::abs(pressed - before) / kPressed);
    before = pressed;
    if (s_before >= 0) {
      EXPECT_LT(std::abs(s - s_before), 60e-6) << "x " << x;
    }
    s_before = s;
  }
  EXPECT_LT(worst, 0.15) << "of the force; without shares it doubles";
}

/// Sum of the weights of the contacts that the first piece of a thread has with the lower jaw, which is 0.5 mm wide there. The thread lies across it with 1 um
/// overlap; its first vertex but one is `inside` [m] of the jaw's edge, and the piece before that is tilted by `tilt` [rad].
double weight_beside_edge(double inside, double tilt) {
  constexpr double kHalf = 0.25e-3, kThick = 22e-6, kLength = 0.4e-3;  // m
  scene::World w;
  w.convex = {bench::convex(bench::jaw(-1))};
  scene::Shape jaw = bench::convex_shape();
  jaw.convex = 0;
  add_shape(w, jaw, 0);
  const Vec3 inner(bench::Jaw::kGrip, -kHalf + inside, kThick - 1e-6);
  add_chain(w, {inner + kLength * Vec3(0, -std::cos(tilt), std::sin(tilt)), inner, inner + Vec3(0, kLength, 0), inner + Vec3(0, 2 * kLength, 0)},
            kThick, kBend, 1);
  double sum = 0;
  for (const Contact& c : detect(w, {joins(0, 1)}).contact) {
    const ChainPlace& place = c.place_a.segment != scene::kNone ? c.place_a : c.place_b;
    sum += place.segment == 0 ? c.weight : 0;
  }
  return sum;
}

// The piece that leaves the jaws is over the pad by a few micrometres only. A point there, with the weight of a whole touch, would come and go with the
// sign of its tilt: a thread pinched by two jaws turned from one to the other and back, step by step.
TEST(Chain, APieceThatLeavesTheJawsTouchesAlongItsShareOfTheLine) {
  for (const double inside : {7e-6, 12e-6, 20e-6, 40e-6})
    for (const double tilt : {-0.05, -1e-3, 1e-3, 0.05}) EXPECT_LT(weight_beside_edge(inside, tilt), 0.1) << inside << ", " << tilt;
}

/// A ball that rolls into the bend of a thread: where it touched one piece and touches both, the force goes on in one of the two contacts, and the
/// bristle in both. A solve that took both to bear it would begin with twice the force.
TEST(Chain, AForceGoesOnInOneContact) {
  constexpr double kSlope = 0.2, kBall = 200e-6;  // rad, m
  scene::World w;
  const Vec3 left(-std::cos(kSlope), 0, std::sin(kSlope)), right(std::cos(kSlope), 0, std::sin(kSlope));
  add_chain(w, {0.4e-3 * left, Vec3::Zero(), 0.4e-3 * right}, kRadius, kBend, 0);
  const uint32_t body = add_shape(w, ball(kBall), 1, {}, SWAGE_MOTION_FOLLOWS);
  Detector detector(w, {joins(0, 1)}, points_only());
  ContactSet set;
  detector.reserve(set);
  // 0.1 um into the left piece, and along it to where it is 0.1 um into the other one as well
  const Vec3 up(std::sin(kSlope), 0, std::cos(kSlope));
  const auto touch = [&](double along) { w.X_WB[body].p = toolkit::raw(Vec3(along * left + (kBall + kRadius - 0.1e-6) * up)), detector.detect(w, set); };
  touch(150e-6);
  ASSERT_EQ(set.contact.size(), 1u);
  set.contact[0].f_a_W = 1e-3 * set.contact[0].n_W, set.contact[0].bristle_W = {0, 1e-9, 0};
  touch((kBall + kRadius - 0.1e-6) * std::tan(kSlope));
  ASSERT_EQ(set.contact.size(), 2u);
  int bears = 0;
  for (const Contact& c : set.contact) {
    EXPECT_FALSE(c.bristle_W.isZero(0));
    bears += !c.f_a_W.isZero(0);
  }
  EXPECT_EQ(bears, 1);
}

/// Weights of the contacts that a thread has with the lower jaw across which it lies; its second piece is tilted by `tilt` [rad] about the edge.
/// Before that it may have lain flat, and borne.
std::vector<double> weights_of_tilted(double tilt, bool lay_flat) {
  constexpr double kHalf = 0.25e-3, kThick = 22e-6;  // m
  scene::World w;
  w.convex = {bench::convex(bench::jaw(-1))};
  scene::Shape jaw = bench::convex_shape();
  jaw.convex = 0;
  add_shape(w, jaw, 0);
  const auto p = [&](double angle) { return Vec3(bench::Jaw::kGrip, 0.2e-3 * std::cos(angle), kThick - 1e-6 + 0.2e-3 * std::sin(angle)); };
  const Vec3 start(bench::Jaw::kGrip, -kHalf, kThick - 1e-6), joint(bench::Jaw::kGrip, 0, kThick - 1e-6);
  add_chain(w, {start, joint, p(0)}, kThick, kBend, 1);
  Detector detector(w, {joins(0, 1)}, {});
  ContactSet set;
  detector.reserve(set);
  if (lay_flat) {
    detector.detect(w, set);
    for (Contact& c : set.contact) c.f_a_W = 1e-3 * c.n_W;
  }
  const Vec3 end = p(tilt);
  std::copy_n(end.data(), 3, w.plugin_state.data() + w.chain[0].state + 6);
  detector.detect(w, set);
  std::vector<double> out;
  for (const Contact& c : set.contact) {
    const ChainPlace& place = c.place_a.segment != scene::kNone ? c.place_a : c.place_b;
    if (place.segment == 1 && (c.feature & 0xF) != 0) out.push_back(c.weight);
  }
  return out;
}

TEST(Chain, WeightsFollowATiltGradually) {
  constexpr double kTilt = 0.06, kKept = 1.0 / 3;  // rad: the end is 12 um higher, between what is level and what is steep
  const std::vector<double> flat = weights_of_tilted(0, false), tilted = weights_of_tilted(kTilt, false), then = weights_of_tilted(kTilt, true);
  ASSERT_FALSE(flat.empty());
  ASSERT_EQ(tilted.size(), flat.size());
  ASSERT_EQ(then.size(), flat.size());
  for (size_t i = 0; i < flat.size(); ++i) {
    EXPECT_LT(tilted[i], 0.95 * flat[i]);
    EXPECT_NEAR(then[i], tilted[i] + kKept * (flat[i] - tilted[i]), 1e-12);
  }
}

TEST(Chain, SavesWhereItsContactsAre) {
  scene::World w;
  add_chain(w, {{-1e-3, 0, 0}, {0, 0, 0}, {1e-3, 0, 0}}, kRadius, kBend, 0);
  add_shape(w, ball(50e-6), 1, {Vec3(0.2e-3, 0, 60e-6), toolkit::Quat::Identity()});
  Detector detector(w, {joins(0, 1)}, {});
  ContactSet set;
  detector.reserve(set);
  detector.detect(w, set);
  ASSERT_EQ(set.contact.size(), 1u);
  std::vector<std::byte> image(detector.image_size());
  scene::Writer out(image);
  detector.save(set, out);
  ASSERT_TRUE(out.ok());
  ContactSet back;
  detector.reserve(back);
  scene::Reader in(std::span<const std::byte>(image).first(out.size()));
  ASSERT_TRUE(detector.restore(back, in));
  EXPECT_EQ(back.contact.at(0).place_a.segment, 1u);
  EXPECT_EQ(back.contact.at(0).place_a.s, set.contact[0].place_a.s);
  EXPECT_EQ(back.contact.at(0).place_a.share, set.contact[0].place_a.share);
}

}  // namespace chain_test
}  // namespace swage::contact
