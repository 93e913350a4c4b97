// SPDX-License-Identifier: Apache-2.0
//
// A chain that is touched at its vertices only: against (4.17) of the thesis over all pairs, and what passes between them.
#include <gtest/gtest.h>

#include <map>

#include "chain_scene.hpp"
#include "solids.hpp"

namespace swage::contact {
namespace chain_spheres_test {

constexpr double kRadius = 11e-6, kBend = 30e-6;  // m

/// Detects once between two objects, or of one with itself.
ContactSet detect(const scene::World& world, uint32_t a, uint32_t b, const Options& options = {}) {
  Pair pair;
  pair.object_a = a, pair.object_b = b;
  Detector detector(world, {pair}, options);
  ContactSet set;
  detector.reserve(set);
  detector.detect(world, set);
  EXPECT_EQ(set.dropped, 0u);
  return set;
}

uint32_t add_spheres(scene::World& w, const std::vector<Vec3>& p, uint32_t object) {
  const uint32_t chain = add_chain(w, p, kRadius, kBend, object);
  w.shape.back().flags |= scene::kChainOfSpheres;
  return chain;
}

uint32_t vertex_of(const ChainPlace& place) { return place.segment + (place.share > 0.5 ? 1 : 0); }

/// Vertices of a chain and another, or the same, whose spheres overlap or nearly do: gamma of (4.17), the other way round.
std::map<std::pair<uint32_t, uint32_t>, double> all_pairs(const scene::World& w, uint32_t a, uint32_t b, double margin) {
  const scene::ChainView one(w, w.chain[a]), other(w, w.chain[b]);
  std::map<std::pair<uint32_t, uint32_t>, double> out;
  for (uint32_t i = 0; i < one.vertices(); ++i)
    for (uint32_t j = a == b ? i + 1 : 0; j < other.vertices(); ++j) {
      if (a == b && other.s(j) - one.s(i) < M_PI * kBend) continue;
      const double gap = (one.p(i) - other.p(j)).norm() - 2 * kRadius;
      if (gap <= margin) out[{i, j}] = gap;
    }
  return out;
}

size_t expect_all_pairs(const scene::World& w, uint32_t a, uint32_t b) {
  Options options;
  options.capacity = 20000;
  const ContactSet set = detect(w, a, b, options);
  auto all = all_pairs(w, a, b, options.margin * w.length);
  const size_t found = all.size();
  for (const Contact& c : set.contact) {
    const std::pair key{vertex_of(c.place_a), vertex_of(c.place_b)};
    if (all.count(key) == 0) {
      ADD_FAILURE() << key.first << " " << key.second << " " << c.gap;
      continue;
    }
    EXPECT_NEAR(c.gap, all[key], 1e-12);
    all.erase(key);
  }
  EXPECT_EQ(all.size(), 0u) << "not found";
  return found;
}

TEST(ChainOfSpheres, TouchesOthersAndItselfWhereAllPairsSay) {
  size_t pairs = 0;
  for (uint32_t seed = 1; seed <= 60; ++seed) {
    scene::World w;
    const double length = seed % 3 == 0 ? 20e-6 : 60e-6;
    add_spheres(w, wander(90, length, 0.4, 0.3e-3, seed), 0);
    add_spheres(w, wander(70, length, 0.4, 0.3e-3, seed + 1000), 1);
    pairs += expect_all_pairs(w, 0, 1);
    pairs += expect_all_pairs(w, 0, 0);
  }
  EXPECT_GT(pairs, 400u);
}

/// Against each kind of shape: the sphere of the vertex as a ball on a body of its own says it.
TEST(ChainOfSpheres, MeetsEveryKindOfShapeAsBallsDo) {
  scene::Shape capsule = ball(60e-6), cylinder = ball(60e-6), arc = ball(50e-6);
  capsule.kind = SWAGE_SHAPE_CAPSULE, capsule.half_length = 0.3e-3;
  cylinder.kind = SWAGE_SHAPE_CYLINDER, cylinder.half_length = 0.3e-3;
  arc.kind = SWAGE_SHAPE_ARC, arc.arc_radius = 0.4e-3, arc.sweep = 2;
  scene::Shape jaw = bench::convex_shape();
  jaw.convex = 0;
  Options points;
  points.flatness = 0;
  size_t touches = 0;
  for (const scene::Shape& other : {ball(80e-6), capsule, cylinder, arc, jaw})
    for (const bool chain_first : {true, false})
      for (uint32_t seed = 1; seed <= 6; ++seed) {
        scene::World w, rigid;
        w.convex = rigid.convex = {bench::convex(bench::jaw(1))};
        add_spheres(w, wander(60, 40e-6, 0.4, 0.4e-3, seed), 0);
        const scene::ChainView chain(w, w.chain[0]);
        for (uint32_t i = 0; i < chain.vertices(); ++i)
          add_shape(rigid, ball(kRadius), 0, {chain.p(i), toolkit::Quat::Identity()}, SWAGE_MOTION_FLEXIBLE);
        add_shape(w, other, 1), add_shape(rigid, other, 1);
        const ContactSet set = detect(w, chain_first ? 0 : 1, chain_first ? 1 : 0, points);
        const ContactSet said = detect(rigid, chain_first ? 0 : 1, chain_first ? 1 : 0, points);
        ASSERT_EQ(set.contact.size(), said.contact.size()) << "kind " << other.kind << " seed " << seed;
        for (size_t i = 0; i < set.contact.size(); ++i) EXPECT_NEAR(set.contact[i].gap, said.contact[i].gap, 1e-12);
        touches += set.contact.size();
        // found again at the same poses
        for (size_t i = 0; i < set.contact.size(); ++i) {
          const Contact& c = set.contact[i];
          const Touch again = reevaluate(set.candidate[i], Frame(w.X_WB[c.body_a]), Frame(w.X_WB[c.body_b]));
          EXPECT_NEAR(again.gap, c.gap, 1e-13);
        }
      }
  EXPECT_GT(touches, 60u);
}

// What the exact chain meets between two vertices, this one does not; at a vertex it meets it; where both pieces are cut out, not.
TEST(ChainOfSpheres, HasNothingBetweenItsVertices) {
  const std::vector<Vec3> line{{-0.3e-3, 0, 0}, {-0.1e-3, 0, 0}, {0.1e-3, 0, 0}, {0.3e-3, 0, 0}};
  for (const double x : {0.0, 0.1e-3, 0.3e-3}) {
    scene::World spheres, exact;
    add_spheres(spheres, line, 0);
    add_chain(exact, line, kRadius, kBend, 0);
    for (scene::World* w : {&spheres, &exact}) add_shape(*w, ball(20e-6), 1, {Vec3(x, 0, 30e-6), toolkit::Quat::Identity()});
    EXPECT_EQ(detect(exact, 0, 1).contact.size(), 1u);
    EXPECT_EQ(detect(spheres, 0, 1).contact.size(), x > 0 ? 1u : 0u) << x;
    // the piece before it, then the one after
    spheres.plugin_state[spheres.chain[0].state + 7 * 4 + 1] = 0;
    EXPECT_EQ(detect(spheres, 0, 1).contact.size(), x > 0 ? 1u : 0u) << x;
    spheres.plugin_state[spheres.chain[0].state + 7 * 4 + 2] = 0;
    EXPECT_EQ(detect(spheres, 0, 1).contact.size(), 0u) << x;
  }
}

}  // namespace chain_spheres_test
}  // namespace swage::contact
