// SPDX-License-Identifier: Apache-2.0
#include "host/builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <swage/abi/spheres.h>

#include <cmath>

#include "host/sentences.hpp"
#include "host/units.hpp"
#include "scene/chain.hpp"
#include "snapshot/snapshot.hpp"

using namespace swage::host;
using swage::scene::kNone;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

constexpr swage_pose kIdentity{{0, 0, 0}, {1, 0, 0, 0}};
constexpr swage_mass kMass{4e-7, {1e-12, 1e-12, 2e-12}};

// one configure call of one instance
struct Bench {
  swage::scene::World world;
  swage::judge::Script script;
  swage::base::Problems problems;
  Builder builder;
  swage_builder* raw;

  explicit Bench(int32_t kind = SWAGE_KIND_OBJECT, swage_pose X_WO = kIdentity)
      : builder({kind, "thing", 0, X_WO, {}}, world, script, problems), raw(builder.abi()) {}

  uint32_t body(int32_t motion = SWAGE_MOTION_FIXED, const swage_mass* mass = nullptr,
                const char* name = "b") {
    return raw->body(raw, motion, &kIdentity, mass, name);
  }
  std::vector<std::string> said() const {
    std::vector<std::string> out;
    for (const auto& p : problems) out.push_back(p.message);
    return out;
  }
};

// a cube of edge 2, its faces counter-clockwise from outside
struct Cube {
  double vertex[24];
  uint32_t start[7] = {0, 4, 8, 12, 16, 20, 24};
  uint32_t face[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  Cube() {
    for (int i = 0; i < 8; ++i) {
      vertex[3 * i] = (i & 1) != 0 ? 3 : 1;  // centre at x = 2
      vertex[3 * i + 1] = (i & 2) != 0 ? 1 : -1;
      vertex[3 * i + 2] = (i & 4) != 0 ? 1 : -1;
    }
  }
  swage_convex abi() const { return {8, 6, vertex, start, face}; }
};

}  // namespace

TEST(Builder, PlacesBodiesInTheWorld) {
  const double h = std::sqrt(0.5);
  Bench b(SWAGE_KIND_OBJECT, {{1, 0, 0}, {h, 0, 0, h}});  // a quarter turn about z
  const swage_pose X_OB{{0, 1, 0}, {1, 0, 0, 0}};
  EXPECT_EQ(b.raw->body(b.raw, SWAGE_MOTION_DYNAMIC, &X_OB, &kMass, "tip"), 0u);
  EXPECT_THAT(b.said(), IsEmpty());
  const auto& info = b.world.body.at(0);
  EXPECT_NEAR(info.start.p.x, 0, 1e-15);
  EXPECT_NEAR(info.start.p.y, 0, 1e-15);
  EXPECT_NEAR(info.start.q.z, h, 1e-15);
  EXPECT_EQ(info.mass, 4e-7);
  EXPECT_EQ(b.world.X_WB.size(), 1u);
  EXPECT_EQ(b.world.V_WB.size(), 1u);
  EXPECT_EQ(b.world.F_B_W.size(), 1u);
}

TEST(Builder, HeightFieldsKeepTheirHeightsInTheWorldOrInPrivateDoubles) {
  Bench b;
  const double height[6] = {0, 1, 2, 3, 4, 5};
  const auto declare = height_field_table().declare;
  swage_height_field field{{{0, 0, 0}, {1, 0, 0, 0}}, 3, 2, 0.5, 0.25, 1, height, SWAGE_NONE, 0};
  EXPECT_EQ(declare(b.raw, 0, &field, SWAGE_SHAPE_USUAL), kNone) << "no such body";
  const swage_pose X_OB{{0, 0, 0}, {1, 0, 0, 0}};
  b.raw->body(b.raw, SWAGE_MOTION_FIXED, &X_OB, nullptr, "ground");
  EXPECT_EQ(declare(b.raw, 0, &field, SWAGE_SHAPE_USUAL), 0u);
  EXPECT_EQ(b.world.field.at(0).height, std::vector<double>(height, height + 6));
  EXPECT_EQ(b.world.field.at(0).state, kNone);
  EXPECT_EQ(b.world.shape.at(0).kind, SWAGE_SHAPE_HEIGHT_FIELD);

  field.state = 2;
  EXPECT_EQ(declare(b.raw, 0, &field, SWAGE_SHAPE_USUAL), kNone) << "not declared";
  b.raw->state(b.raw, 8);
  EXPECT_EQ(declare(b.raw, 0, &field, SWAGE_SHAPE_USUAL), 1u);
  EXPECT_EQ(b.world.field.at(1).state, 2u);

  field.nx = 130;
  EXPECT_EQ(declare(b.raw, 0, &field, SWAGE_SHAPE_USUAL), kNone);
  field.nx = 3, field.below = 0;
  EXPECT_EQ(declare(b.raw, 0, &field, SWAGE_SHAPE_USUAL), kNone);
  field.below = 1, field.height = nullptr;
  EXPECT_EQ(declare(b.raw, 0, &field, SWAGE_SHAPE_USUAL), kNone);
  EXPECT_EQ(b.world.shape.size(), 2u);
}

TEST(Builder, RefusesBodiesThatCannotBe) {
  Bench b;
  const swage_pose skewed{{0, 0, 0}, {1, 1, 0, 0}}, far{{INFINITY, 0, 0}, {1, 0, 0, 0}};
  const swage_mass none{0, {1, 1, 1}}, flat{1, {1, 1, 2.1}}, hollow{1, {0, 1, 1}};
  EXPECT_EQ(b.raw->body(b.raw, SWAGE_MOTION_FIXED, &skewed, nullptr, "b"), kNone);
  EXPECT_EQ(b.raw->body(b.raw, SWAGE_MOTION_FIXED, &far, nullptr, "c"), kNone);
  EXPECT_EQ(b.body(9), kNone);
  EXPECT_EQ(b.body(SWAGE_MOTION_FIXED, &kMass), kNone);
  EXPECT_EQ(b.body(SWAGE_MOTION_DYNAMIC), kNone);
  EXPECT_EQ(b.body(SWAGE_MOTION_DYNAMIC, &none), kNone);
  EXPECT_EQ(b.body(SWAGE_MOTION_DYNAMIC, &flat), kNone);
  EXPECT_EQ(b.body(SWAGE_MOTION_DYNAMIC, &hollow), kNone);
  EXPECT_TRUE(b.builder.failed());
  EXPECT_THAT(
      b.said(),
      ElementsAre(say::kOfBody("b", say::kStartPose()),
                  say::kOfBody("c", say::kStartPose()),
                  say::kOfBody("b", say::kMotion(9)), say::kOfBody("b", say::kNoMassHere()),
                  say::kOfBody("b", say::kNeedsMass()),  // twice in a row, told once
                  say::kOfBody("b", say::kNoSuchInertia()),
                  say::kOfBody("b", say::kNeedsInertia())));
}

TEST(Builder, CapacitiesAreThoseOfTheSnapshot) {
  Bench b;
  for (uint32_t i = 0; i < swage::snapshot::kMaxBodies; ++i) EXPECT_EQ(b.body(), i);
  EXPECT_EQ(b.body(), kNone);
  std::vector<double> p(3 * 1025, 0), m(1025, 1e-9);
  EXPECT_EQ(b.raw->particles(b.raw, 1025, p.data(), m.data(), 0), kNone);
  EXPECT_EQ(b.raw->particles(b.raw, 1024, p.data(), m.data(), 0), 0u);
  EXPECT_THAT(b.said(), ElementsAre(say::kNoRoom(257, "bodies", 256),
                                    say::kNoRoom(1025, "particles", 1024)));
}

TEST(Builder, RoomForContactPointsIsAskedFor) {
  Bench b;
  swage_capacities room = capacities_of(b.world);
  EXPECT_EQ(room.points, 96u);
  EXPECT_EQ(room.bodies, swage::snapshot::kMaxBodies);
  EXPECT_EQ(reserve_points(b.raw, 20), 96u);
  EXPECT_EQ(capacities_of(b.world).rows, 128u) << "there was room";
  EXPECT_EQ(reserve_points(b.raw, 200), 200u);
  room = capacities_of(b.world);
  EXPECT_EQ(room.rows, 400u);
  EXPECT_EQ(room.contacts, 656u);
  EXPECT_EQ(reserve_points(b.raw, 256), 256u);
  EXPECT_EQ(capacities_of(b.world).rows, 512u);
  EXPECT_THAT(b.said(), IsEmpty());
  EXPECT_EQ(reserve_points(b.raw, 257), 0u);
  EXPECT_THAT(b.said(), ElementsAre(say::kManyPoints(256, 257)));
}

TEST(Builder, ShapesGetTheirFrames) {
  Bench b;
  b.body();
  EXPECT_EQ(b.raw->sphere(b.raw, 0, {1, 2, 3}, 0.5, SWAGE_SHAPE_USUAL), 0u);
  EXPECT_EQ(b.raw->capsule(b.raw, 0, {0, 0, 0}, {4, 0, 0}, 1, SWAGE_SHAPE_USUAL), 1u);
  EXPECT_EQ(b.raw->cylinder(b.raw, 0, {0, 0, -2}, {0, 0, 2}, 1, SWAGE_SHAPE_DRAWN), 2u);
  const swage_arc arc{kIdentity, 2.6e-3, 2.4, 5e-5};
  EXPECT_EQ(b.raw->arc(b.raw, 0, &arc, SWAGE_SHAPE_USUAL), 3u);
  ASSERT_THAT(b.said(), IsEmpty());
  const auto& capsule = b.world.shape[1];
  EXPECT_EQ(capsule.half_length, 2);
  EXPECT_EQ(capsule.X_BS.p.x, 2);
  EXPECT_NEAR(capsule.X_BS.q.y, std::sqrt(0.5), 1e-15) << "the z axis of S points from a to b";
  EXPECT_EQ(capsule.bounding_radius, 3);
  EXPECT_DOUBLE_EQ(b.world.shape[2].bounding_radius, std::sqrt(5.0));
  EXPECT_EQ(b.world.shape[3].arc_radius, 2.6e-3);
  EXPECT_EQ(b.world.shape[3].radius, 5e-5);
}

TEST(Builder, RefusesShapesThatCannotBe) {
  Bench b;
  b.body();
  const swage_arc fat{kIdentity, 1e-3, 1, 1e-3}, round{kIdentity, 1e-3, 6.3, 1e-5};
  EXPECT_EQ(b.raw->sphere(b.raw, 1, {0, 0, 0}, 1, 3), kNone);
  EXPECT_EQ(b.raw->sphere(b.raw, kNone, {0, 0, 0}, 1, 3), kNone);
  EXPECT_EQ(b.raw->sphere(b.raw, 0, {0, 0, 0}, -1, 3), kNone);
  EXPECT_EQ(b.raw->capsule(b.raw, 0, {1, 1, 1}, {1, 1, 1}, 1, 3), kNone);
  EXPECT_EQ(b.raw->arc(b.raw, 0, &fat, 3), kNone);
  EXPECT_EQ(b.raw->arc(b.raw, 0, &round, 3), kNone);
  EXPECT_EQ(b.raw->sphere(b.raw, 0, {0, 0, 0}, 1, 8), kNone);
  EXPECT_THAT(b.said(),
              ElementsAre(say::kNotDeclared("A sphere", 1),
                          say::kNotDeclared("A sphere", "NONE"),
                          say::kSphere(),
                          say::kTube("A capsule"),
                          say::kArcRadius(),
                          say::kArcSweep(), say::kUnknownFlags(8)));
}

TEST(Builder, ConvexesAreCentredAndChecked) {
  Bench b;
  b.body();
  Cube cube;
  swage_convex convex = cube.abi();
  ASSERT_EQ(b.raw->convex(b.raw, 0, &convex, SWAGE_SHAPE_USUAL), 0u) << b.problems[0].message;
  const auto& shape = b.world.shape[0];
  EXPECT_EQ(shape.X_BS.p.x, 2);
  EXPECT_DOUBLE_EQ(shape.bounding_radius, std::sqrt(3.0));
  EXPECT_EQ(b.world.convex[shape.convex].edge.size(), 12u);
  EXPECT_EQ(b.world.convex[shape.convex].face.size(), 6u);

  const auto refused = [&](Cube bad) {
    const swage_convex c = bad.abi();
    const std::size_t shapes = b.world.shape.size(), convexes = b.world.convex.size(),
                      said = b.problems.size();
    EXPECT_EQ(b.raw->convex(b.raw, 0, &c, SWAGE_SHAPE_USUAL), kNone);
    EXPECT_EQ(b.world.shape.size(), shapes);
    EXPECT_EQ(b.world.convex.size(), convexes);
    EXPECT_EQ(b.problems.size(), said + 1);
  };
  Cube inward = cube, dented = cube, open = cube, wild = cube, backwards = cube;
  std::swap(inward.face[0], inward.face[2]);
  dented.vertex[0] = 2;
  open.start[6] = 20;
  wild.face[0] = 8;
  backwards.start[3] = 4;
  for (const Cube& bad : {inward, dented, open, wild, backwards}) refused(bad);
  const swage_convex nothing{};
  EXPECT_EQ(b.raw->convex(b.raw, 0, &nothing, SWAGE_SHAPE_USUAL), kNone);
  EXPECT_EQ(b.said().back(), say::kConvexNothing());
}

TEST(Builder, HingesJoinParentAndChild) {
  Bench b;
  const swage_pose X_OC{{0, 0, 5e-3}, {1, 0, 0, 0}};
  b.body();
  b.raw->body(b.raw, SWAGE_MOTION_HINGED, &X_OC, nullptr, "jaw");
  const swage_hinge good{0, 1, {0, 0, 0}, {0, 1, 0}, 1e-9, -0.1, 0.3};
  EXPECT_EQ(b.raw->hinge(b.raw, &good), 0u);
  b.builder.finish();
  EXPECT_THAT(b.said(), IsEmpty());
  EXPECT_EQ(b.world.hinge[0].X_PC0.p.z, 5e-3);
  EXPECT_EQ(b.world.body[1].hinge, 0u);
  EXPECT_EQ(b.world.drive.size(), 1u);
  EXPECT_EQ(b.raw->hinge(b.raw, &good), kNone);
  EXPECT_EQ(b.said().back(), say::kOfHinge("jaw", say::kHingeTwice()));
}

TEST(Builder, RefusesHingesThatCannotBe) {
  Bench b;
  b.body(SWAGE_MOTION_HINGED, nullptr, "early");
  b.body();
  b.body(SWAGE_MOTION_HINGED, nullptr, "jaw");
  const swage_hinge to_fixed{0, 1, {0, 0, 0}, {0, 1, 0}, 1e-9, 0, 1},
      backwards{1, 0, {0, 0, 0}, {0, 1, 0}, 1e-9, 0, 1}, long_axis{1, 2, {0, 0, 0}, {0, 2, 0}, 1e-9, 0, 1},
      light{1, 2, {0, 0, 0}, {0, 1, 0}, 0, 0, 1}, off{1, 2, {0, 0, 0}, {0, 1, 0}, 1e-9, 0.1, 1},
      nowhere{7, 2, {0, 0, 0}, {0, 1, 0}, 1e-9, 0, 1};
  for (const swage_hinge& h : {to_fixed, backwards, long_axis, light, off, nowhere})
    EXPECT_EQ(b.raw->hinge(b.raw, &h), kNone);
  b.builder.finish();
  EXPECT_THAT(
      b.said(),
      ElementsAre(say::kOfHinge("b", say::kChildNotHinged()),
                  say::kOfHinge("early", say::kChildBeforeParent()),
                  say::kOfHinge("jaw", say::kHingeAxis()),
                  say::kOfHinge("jaw", say::kHingeInertia()),
                  say::kOfHinge("jaw", say::kHingeAngles()),
                  say::kNotDeclared("A hinge", 7),
                  say::kNoHinge("early"),
                  say::kNoHinge("jaw")));
}

TEST(Builder, EachKindDeclaresItsOwn) {
  Bench lesson(SWAGE_KIND_LESSON), coupling(SWAGE_KIND_COUPLING), device(SWAGE_KIND_DEVICE), object;
  const auto declare = [](Bench& b, int32_t what) { return b.raw->declare(b.raw, what, "a.b", "1", "Doc."); };
  for (const int32_t what :
       {SWAGE_DECLARE_METRIC, SWAGE_DECLARE_CUE, SWAGE_DECLARE_EVENT, SWAGE_DECLARE_PHASE})
    EXPECT_EQ(declare(lesson, what), 0u);
  EXPECT_EQ(declare(lesson, SWAGE_DECLARE_SIGNAL), kNone);
  EXPECT_EQ(declare(coupling, SWAGE_DECLARE_SIGNAL), 0u);
  EXPECT_EQ(declare(coupling, SWAGE_DECLARE_EVENT), 0u);
  EXPECT_EQ(declare(coupling, SWAGE_DECLARE_METRIC), kNone);
  EXPECT_EQ(declare(object, SWAGE_DECLARE_SIGNAL), 0u);
  EXPECT_EQ(declare(object, SWAGE_DECLARE_EVENT), kNone);
  EXPECT_EQ(declare(device, SWAGE_DECLARE_SIGNAL), kNone);
  EXPECT_EQ(device.raw->state(device.raw, 1), kNone);
  EXPECT_EQ(lesson.body(), kNone);
  EXPECT_EQ(coupling.world.signal.size(), 1u);
  EXPECT_EQ(lesson.said().back(), say::kHasNo("A lesson", "bodies"));
  EXPECT_EQ(object.said().back(), say::kHasNo("An object", "events"));
}

TEST(Builder, NamesAreCheckedAndUnitsAreSi) {
  Bench b;
  const auto signal = [&](const char* id, const char* unit, const char* doc) {
    return b.raw->declare(b.raw, SWAGE_DECLARE_SIGNAL, id, unit, doc);
  };
  EXPECT_EQ(signal("grip.force", "N", "Force."), 0u);
  EXPECT_EQ(signal("grip.force", "N", "Force."), kNone);
  EXPECT_EQ(signal("Grip", "N", "Force."), kNone);
  EXPECT_EQ(signal("grip.length", "mm", "Length."), kNone);
  EXPECT_EQ(signal("grip.length", "m", ""), kNone);
  EXPECT_EQ(signal(nullptr, nullptr, nullptr), kNone);
  EXPECT_THAT(
      b.said(),
      ElementsAre(say::kDeclaredTwice("grip.force"), say::kNotDotted("Grip"),
                  say::kNameNoUnit("grip.length", "mm", unit_list()),
                  say::kNameNoDoc("grip.length"), say::kNotDotted("")));
}

TEST(Builder, StateAndErrorsOfTheAuthor) {
  Bench b;
  EXPECT_EQ(b.raw->state(b.raw, 3), 0u);
  EXPECT_EQ(b.raw->state(b.raw, 2), 3u);
  EXPECT_EQ(b.world.plugin_state.size(), 5u);
  EXPECT_FALSE(b.builder.failed());
  b.raw->error(b.raw, "arc", "too thin");
  EXPECT_TRUE(b.builder.failed());
  EXPECT_EQ(b.problems[0].where, "thing");
  EXPECT_EQ(b.problems[0].message, "too thin");
}

TEST(Builder, TakesAChainThatItsObjectMoves) {
  Bench b;
  b.raw->state(b.raw, 3);
  const double p_B[] = {0, 0, 0, 3, 0, 0, 3, 4, 0}, radius[] = {0.5, 0.25};
  swage_chain chain{SWAGE_CHAIN_SEGMENTS, 3, p_B, nullptr, radius, 1, 3, 0};
  const auto declare = chain_table().declare;
  EXPECT_EQ(declare(b.raw, 0, &chain, SWAGE_SHAPE_USUAL), kNone) << "no such body";
  b.body();
  EXPECT_EQ(declare(b.raw, 0, &chain, SWAGE_SHAPE_USUAL), kNone) << "a body that does not move itself";
  b.body(SWAGE_MOTION_FLEXIBLE);
  EXPECT_EQ(declare(b.raw, 1, &chain, SWAGE_SHAPE_USUAL), kNone) << "no doubles for it";
  b.raw->state(b.raw, 24);
  EXPECT_EQ(declare(b.raw, 1, &chain, SWAGE_SHAPE_USUAL), 0u);
  const auto& info = b.world.chain.at(0);
  EXPECT_THAT(info.s, ElementsAre(0, 3, 7));
  EXPECT_THAT(info.radius, ElementsAre(0.5, 0.25, 0));
  EXPECT_EQ(info.state, 3u);
  EXPECT_EQ(b.world.shape.at(0).radius, 0.5);
  EXPECT_EQ(b.world.shape.at(0).flags, SWAGE_SHAPE_USUAL);
  swage_chain spheres = chain;
  spheres.kind = SWAGE_CHAIN_SPHERES;
  EXPECT_EQ(declare(b.raw, 1, &spheres, SWAGE_SHAPE_USUAL), 1u);
  EXPECT_EQ(b.world.shape.at(1).flags, SWAGE_SHAPE_USUAL | swage::scene::kChainOfSpheres);

  const double falls[] = {0, 2, 1}, same[] = {0, 0, 0, 0, 0, 0, 3, 4, 0}, negative[] = {0.5, -1};
  const auto refused = [&](auto&& change) {
    swage_chain bad = chain;
    change(bad);
    return declare(b.raw, 1, &bad, SWAGE_SHAPE_USUAL) == kNone;
  };
  EXPECT_TRUE(refused([](swage_chain& c) { c.kind = 3; }));
  EXPECT_TRUE(refused([](swage_chain& c) { c.n_vertex = 1; }));
  EXPECT_TRUE(refused([&](swage_chain& c) { c.s = falls; }));
  EXPECT_TRUE(refused([&](swage_chain& c) { c.p_B = same; }));
  EXPECT_TRUE(refused([&](swage_chain& c) { c.radius = negative; }));
  EXPECT_TRUE(refused([](swage_chain& c) { c.bend_radius = 0; }));
  EXPECT_TRUE(refused([](swage_chain& c) { c.state = 4; }));
  EXPECT_THAT(b.said(),
              ElementsAre(say::kNotDeclared("A chain", 0),
                          say::kChainBody(),
                          say::kChainState(24),
                          say::kChainKind(),
                          say::kChainCount(513, 1),
                          say::kOfVertex(2, say::kVertexArc()),
                          say::kOfVertex(1, say::kVertexTwice()),
                          say::kPieceRadius(1),
                          say::kChainBend(),
                          say::kChainState(24)));
}
