// SPDX-License-Identifier: Apache-2.0
#include "contact/detector.hpp"

#include <gtest/gtest.h>

#include "reference.hpp"
#include "scene/kinematics.hpp"
#include "solids.hpp"

namespace swage::contact {
namespace detector_test {

using bench::Needle;

/// Needle (body 0, object 0) between two jaws (bodies 1 and 2, object 1), gripped with 1 um overlap.
struct Grasp {
  explicit Grasp(const Needle& n = {}, Options options = {})
      : needle(n), world(make(n)), detector(world, pairs(), options) {
    detector.reserve(set);
    for (int side : {1, -1}) {
      const double angle = bench::closing_angle(n, side, 1e-6, true);
      world.X_WB[side > 0 ? 1 : 2] = bench::jaw_pose(Pose(), side * angle).abi();
    }
    world.X_WB[0] = bench::grip_pose(n).abi();
  }
  static std::vector<Pair> pairs() {
    Pair p;
    p.object_a = 0, p.object_b = 1;
    return {p};
  }
  static scene::World make(const Needle& n) {
    scene::World w;
    w.body.resize(3);
    w.shape = {bench::needle_shape(n), bench::convex_shape(), bench::convex_shape()};
    w.convex = {bench::convex(bench::jaw(1)), bench::convex(bench::jaw(-1))};
    for (uint32_t i = 0; i < 3; ++i) {
      w.body[i].start = Pose().abi();
      w.shape[i].body = i, w.shape[i].object = i == 0 ? 0 : 1;
      w.shape[i].convex = i == 0 ? scene::kNone : i - 1;
    }
    scene::reset(w);
    return w;
  }
  void detect() { detector.detect(world, set); }

  Needle needle;
  scene::World world;
  Detector detector;
  ContactSet set;
};

bool same(const ContactSet& a, const ContactSet& b) {
  if (a.contact.size() != b.contact.size()) return false;
  for (size_t i = 0; i < a.contact.size(); ++i) {
    const Contact &x = a.contact[i], &y = b.contact[i];
    if (x.feature != y.feature || x.shape_b != y.shape_b || x.gap != y.gap || x.p_W != y.p_W ||
        x.n_W != y.n_W || x.bristle_W != y.bristle_W || x.weight != y.weight)
      return false;
  }
  return true;
}

TEST(Detector, FindsBothJawsInAFixedOrder) {
  Grasp g;
  g.detect();
  ASSERT_GE(g.set.contact.size(), 3u);
  ASSERT_EQ(g.set.of_pair.size(), 1u);
  EXPECT_EQ(g.set.of_pair[0].count, g.set.contact.size());
  EXPECT_EQ(g.set.contact.size(), g.set.candidate.size());
  double deepest[2] = {1, 1};
  for (size_t i = 0; i < g.set.contact.size(); ++i) {
    const Contact& c = g.set.contact[i];
    EXPECT_EQ(c.body_a, 0u);
    EXPECT_EQ(c.body_b, c.shape_b);
    if (i > 0) {
      EXPECT_GE(c.shape_b, g.set.contact[i - 1].shape_b);
    }
    deepest[c.shape_b - 1] = std::min(deepest[c.shape_b - 1], c.gap);
    EXPECT_GT((c.shape_b == 1 ? -1 : 1) * c.n_W.z(), 0.5) << "from the jaw into the needle";
  }
  EXPECT_NEAR(deepest[0], -1e-6, 1e-11);
  EXPECT_NEAR(deepest[1], -1e-6, 1e-11);
}

TEST(Detector, ContactsCarryTheirBristleWhileTheTouchLasts) {
  Grasp g;
  g.detect();
  for (size_t i = 0; i < g.set.contact.size(); ++i)
    g.set.contact[i].bristle_W = Vec3(1e-9 * static_cast<double>(i + 1), 0, 0);
  const std::vector<Contact> before = g.set.contact;
  g.world.X_WB[0].p.y += 2e-6;
  g.detect();
  ASSERT_EQ(g.set.contact.size(), before.size());
  for (size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(g.set.contact[i].feature, before[i].feature);
    EXPECT_EQ(g.set.contact[i].bristle_W, before[i].bristle_W);
  }

  // opened and closed again: forgotten
  const swage_pose closed = g.world.X_WB[1];
  g.world.X_WB[1] = bench::jaw_pose(Pose(), 0.2).abi();
  g.detect();
  g.world.X_WB[1] = closed;
  g.detect();
  for (const Contact& c : g.set.contact) EXPECT_EQ(c.bristle_W.isZero(), c.shape_b == 1);
}

TEST(Detector, BristlePassesFromFaceToEdge) {
  // a straight wire tilted more and more: its touch moves from a line on the face to the edge
  Needle n;
  n.straight = true;
  Grasp g(n);
  const Vec3 bristle(0, 3e-9, 0);
  g.detect();
  for (Contact& c : g.set.contact) c.bristle_W = bristle;
  for (int i = 1; i <= 40; ++i) {
    g.world.X_WB[0].q = toolkit::raw(toolkit::exp_rotation({1e-3 * i, 0, 0}));
    g.detect();
    ASSERT_FALSE(g.set.contact.empty());
    for (const Contact& c : g.set.contact)
      if (c.gap < 0) {
        EXPECT_EQ(c.bristle_W, bristle) << "tilt " << i << " mrad";
      }
  }
}

TEST(Detector, SavedAndRestoredItGoesOnBitForBit) {
  Grasp g, h;
  for (int i = 0; i < 5; ++i) {
    g.world.X_WB[0].p.y += 3e-6;
    g.detect();
    for (Contact& c : g.set.contact) c.bristle_W += Vec3(1e-9, 2e-9, 0);
  }
  std::vector<std::byte> image(g.detector.image_size());
  scene::Writer out{std::span(image)};
  g.detector.save(g.set, out);
  ASSERT_TRUE(out.ok());
  scene::Reader in{std::span<const std::byte>(image).first(out.size())};
  ASSERT_TRUE(h.detector.restore(h.set, in));
  h.world = g.world;
  for (int i = 0; i < 5; ++i) {
    g.world.X_WB[0].p.y = h.world.X_WB[0].p.y += 3e-6;
    g.detect(), h.detect();
    EXPECT_TRUE(same(g.set, h.set));
  }

  // an image that ends early is refused
  scene::Reader shortened{std::span<const std::byte>(image).first(out.size() / 2)};
  EXPECT_FALSE(h.detector.restore(h.set, shortened));
}

TEST(Detector, ContactsBeyondTheCapacityAreCounted) {
  Options few;
  few.capacity = 2;
  Grasp g({}, few), all;
  g.detect(), all.detect();
  EXPECT_EQ(g.set.contact.size(), 2u);
  EXPECT_EQ(g.set.dropped, all.set.contact.size() - 2);
}

TEST(Detector, ChainOfTheThesisTouchesWithItsSpheres) {
  Options chain;
  chain.level = Level::kThesis;
  Grasp g({}, chain);
  // closed to where the exact arc overlaps by 1 um, the chain does not touch everywhere; 10 um closer it does
  g.world.X_WB[0].p.z -= 10e-6;
  g.detect();
  const bench::Solid lower(bench::jaw(-1));
  const Pose X_JN = Pose(g.world.X_WB[2]).inverse() * Pose(g.world.X_WB[0]);
  size_t touching = 0, expected = 0;
  for (const Contact& c : g.set.contact) touching += c.shape_b == 2 && c.gap < 0;
  for (const Vec3& p : g.needle.chain(100)) expected += lower.distance(X_JN * p) < g.needle.wire_radius();
  EXPECT_GT(expected, 0u);
  EXPECT_EQ(touching, expected);
}

TEST(Detector, RefusesOptionsOutOfRange) {
  Options o;
  o.line_points = 3;
  EXPECT_THROW(Grasp({}, o), std::invalid_argument);
}

/// Contacts of a wire of two arcs of 0.6 mm, as good as straight, across the lower jaw, which is 0.5 mm wide there, with 1 um overlap. The
/// wire is tilted by `tilt` [rad] about its joint, which is `aside` [m] of the middle.
ContactSet two_arcs_on_a_jaw(double tilt, double aside) {
  constexpr double kRadius = 30, kSweep = 0.6e-3 / kRadius;
  const Needle n;
  scene::World w;
  w.body.resize(3);
  w.shape = {bench::needle_shape(n), bench::needle_shape(n), bench::convex_shape()};
  w.convex = {bench::convex(bench::jaw(-1))};
  for (uint32_t i = 0; i < 3; ++i) {
    w.body[i].motion = i < 2 ? SWAGE_MOTION_FLEXIBLE : SWAGE_MOTION_FIXED;
    w.body[i].start = Pose().abi();
    w.shape[i].body = i, w.body[i].object = w.shape[i].object = i < 2 ? 0 : 1;
  }
  w.shape[2].convex = 0;
  const toolkit::Quat rise = toolkit::exp_rotation({tilt, 0, 0});
  const Vec3 joint(bench::Jaw::kGrip, aside, n.wire_radius() - 1e-6);
  for (int i = 0; i < 2; ++i) {
    scene::Shape& s = w.shape[static_cast<size_t>(i)];
    s.kind = SWAGE_SHAPE_ARC, s.arc_radius = kRadius, s.sweep = kSweep;
    s.bounding_radius = 2 * kRadius;
    // its arc starts on its own +x axis, at the joint or one sweep before it
    const Pose X_WA(joint - rise * Vec3(kRadius, 0, 0), rise * toolkit::exp_rotation({0, 0, (i - 1) * kSweep}));
    s.X_BS = X_WA.abi();
  }
  scene::reset(w);
  Detector detector(w, Grasp::pairs(), {});
  ContactSet set;
  detector.reserve(set);
  detector.detect(w, set);
  return set;
}

/// Sum of the weights of the contacts of one of the arcs.
double weight_of(const ContactSet& set, uint32_t arc) {
  double sum = 0;
  for (const Contact& c : set.contact)
    if (std::min(c.shape_a, c.shape_b) == arc) sum += c.weight;
  return sum;
}

// Where the wire rises by less than the thickness of an atom over one of its arcs, the minimum at the joint belongs to the other; both lie
// on the face all the same and share its weight.
TEST(Detector, EveryArcOfAWireThatLiesOnAFaceTouchesIt) {
  for (const double tilt : {-1e-5, -1e-6, 0.0, 1e-6, 1e-5}) {
    const ContactSet set = two_arcs_on_a_jaw(tilt, 0);
    EXPECT_NEAR(weight_of(set, 0), 0.5, 1e-3) << tilt;
    EXPECT_NEAR(weight_of(set, 1), 0.5, 1e-3) << tilt;
  }
}

// Cut 10 to 50 um inside the edge of the jaw, the wire touches along the same line. A point beside it, at the cut or at the edge by the
// sign of the tilt, would make the wire rock from step to step.
TEST(Detector, AWireCutBesideAnEdgeTouchesAlongOneLine) {
  constexpr double kHalf = 0.25e-3;  // m, half the width of the jaw
  for (const double from_edge : {10e-6, 20e-6, 33e-6, 50e-6})
    for (const double side : {-1.0, 1.0})
      for (const double tilt : {-2e-3, -1e-5, 1e-5, 2e-3}) {
        const ContactSet set = two_arcs_on_a_jaw(tilt, side * (kHalf - from_edge));
        for (const Contact& c : set.contact) EXPECT_NE(c.feature & 0xF, 0u) << from_edge << ", " << side << ", " << tilt;
        EXPECT_NEAR(weight_of(set, side > 0 ? 1 : 0), from_edge / (2 * kHalf), 1e-3);
        EXPECT_NEAR(weight_of(set, side > 0 ? 0 : 1), 1 - from_edge / (2 * kHalf), 1e-3);
      }
}

}  // namespace detector_test
}  // namespace swage::contact
