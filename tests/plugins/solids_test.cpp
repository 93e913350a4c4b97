// SPDX-License-Identifier: Apache-2.0
//
// Solids: masses against their closed forms, frames, where they may be taken.
#include <numbers>

#include "plugins/solids/course.hpp"
#include "stage.hpp"

namespace swage::solids {
namespace {

using stage::Stage;
constexpr double kPi = std::numbers::pi;

// numbers of the forms
constexpr double kSphere = 0, kCylinder = 1, kBox = 2, kSlot = 3, kNest = 4, kRing = 6, kWire = 7;

TEST(Solids, Sphere) {
  Stage stage("swage.object.solids");
  ASSERT_EQ(stage.configure({{"form", kSphere}, {"diameter", 0.8e-3}, {"density", 1200}}), SWAGE_OK);
  const swage_mass& m = stage.bodies.at(0).mass;
  const double mass = 1200 * kPi / 6 * 0.8e-3 * 0.8e-3 * 0.8e-3;
  EXPECT_NEAR(m.mass, mass, 1e-12 * mass);
  EXPECT_NEAR(m.inertia.x, 0.4 * mass * 0.4e-3 * 0.4e-3, 1e-12 * mass * 1e-6);
  EXPECT_EQ(stage.shapes.at(0).kind, SWAGE_SHAPE_SPHERE);
}

TEST(Solids, CylinderWithRoundEnds) {
  Stage rod("swage.object.solids");
  ASSERT_EQ(rod.configure({{"form", kCylinder}, {"diameter", 1e-3}, {"length", 4e-3}}), SWAGE_OK);
  // by slices along the axis
  double mass = 0, along = 0, across = 0;
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double z = -2e-3 + (i + 0.5) * 4e-3 / n, out = std::max(0.0, std::abs(z) - 1.5e-3);
    const double r2 = 0.25e-6 - out * out, dm = 1000 * kPi * r2 * 4e-3 / n;
    mass += dm;
    along += 0.5 * dm * r2;
    across += dm * (0.25 * r2 + z * z);
  }
  const swage_mass& m = rod.bodies.at(0).mass;
  EXPECT_NEAR(m.mass, mass, 1e-6 * mass);
  EXPECT_NEAR(m.inertia.z, along, 1e-6 * along);
  EXPECT_NEAR(m.inertia.x, across, 1e-6 * across);
  const stage::DeclaredShape& s = rod.shapes.at(0);
  EXPECT_EQ(s.kind, SWAGE_SHAPE_CAPSULE);
  EXPECT_NEAR(s.b.z - s.a.z + 2 * s.radius, 4e-3, 1e-15);
}

TEST(Solids, ARingHasTheMassOfATorus) {
  Stage ring("swage.object.solids");
  const double R = 1e-3, r = 0.1e-3;
  ASSERT_EQ(ring.configure({{"form", kRing}, {"diameter", 2 * R}, {"wire_diameter", 2 * r}, {"density", 7800}}), SWAGE_OK);
  // by rings of the section, each of the length of its own circle
  double mass = 0, along = 0, across = 0;
  const int n = 1000;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double x = r * (2 * (i + 0.5) / n - 1), z = r * (2 * (k + 0.5) / n - 1);
      if (x * x + z * z > r * r) continue;
      const double dm = 7800 * 2 * kPi * (R + x) * (2 * r / n) * (2 * r / n);
      mass += dm;
      along += dm * (R + x) * (R + x);
      across += dm * (0.5 * (R + x) * (R + x) + z * z);
    }
  const swage_mass& m = ring.bodies.at(0).mass;
  EXPECT_NEAR(m.mass, mass, 1e-4 * mass);
  EXPECT_NEAR(m.inertia.z, along, 1e-4 * along);
  EXPECT_NEAR(m.inertia.x, across, 1e-4 * across);
  EXPECT_EQ(ring.shapes.at(0).kind, SWAGE_SHAPE_ARC);
  Stage thick("swage.object.solids");
  EXPECT_LT(thick.configure({{"form", kRing}, {"diameter", 1e-3}, {"wire_diameter", 0.5e-3}}), 0);
}

TEST(Solids, ACourseGoesOnWhereThePieceBeforeItEnds) {
  std::vector<Piece> pieces;
  ASSERT_EQ(read_course("2 mm, 60 deg at 2 mm, -120 deg at 2mm,60 deg at 2 mm, 1.5 mm", pieces), "");
  ASSERT_EQ(pieces.size(), 5u);
  const double s = 2e-3 * std::sin(kPi / 3);
  EXPECT_NEAR((pieces[4].start - Vec3(2e-3 + 4 * s, 0, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR(pieces[4].forward(0).x(), 1, 1e-15);
  EXPECT_NEAR(pieces[2].at(0.5 * pieces[2].length).y(), 2e-3, 1e-15);  // the top
  // every place of it is its own nearest place, also seen from beside it
  for (const Piece& piece : pieces)
    for (const double u : {0.0, 0.3, 1.0})
      for (const double aside : {-0.5e-3, 0.0, 0.5e-3}) {
        const Vec3 t = piece.forward(u * piece.length);
        const Vec3 p = piece.at(u * piece.length) + aside * Vec3(-t.y(), t.x(), 0);
        EXPECT_NEAR(piece.nearest(p), u * piece.length, 1e-15);
      }
  for (const char* wrong : {"", "2", "2 cm", "60 deg", "60 deg at 2", "400 deg at 2 mm", "2 mm 3 mm", "0 mm"})
    EXPECT_NE(read_course(wrong, pieces), "") << wrong;
}

TEST(Solids, AWireIsTakenAlongItsCourse) {
  Stage stage("swage.object.solids");
  ASSERT_EQ(stage.configure({{"form", kWire}, {"fixed", 1}, {"course", std::string("1 mm, -90 deg at 1 mm, 2 mm")}}), SWAGE_OK);
  ASSERT_EQ(stage.shapes.size(), 3u);
  ASSERT_EQ(stage.activate(), SWAGE_OK);
  stage.on_rt();
  stage::ObjectArrays arrays(stage);
  const swage_object_step step = arrays.step();
  swage_graspable_place place{};
  stage.table<swage_graspable>(SWAGE_TRAIT_GRASPABLE).locate(stage.raw(), &step, {2.5e-3, -2e-3, 1e-3}, &place);
  const double length = 3e-3 + 0.5e-3 * kPi;
  EXPECT_NEAR(place.length, length, 1e-15);
  EXPECT_NEAR(place.s, (2e-3 + 0.5e-3 * kPi) / length, 1e-12);
  EXPECT_NEAR(place.p_W.x, 2e-3, 1e-15);
  EXPECT_NEAR(place.tangent_W.y, -1, 1e-12);
}

TEST(Solids, FacesOfABoxLookOutwards) {
  Stage stage("swage.object.solids");
  ASSERT_EQ(stage.configure({{"form", kBox}, {"fixed", 1}, {"size", std::vector<double>{1e-3, 2e-3, 3e-3}}}),
            SWAGE_OK);
  const stage::DeclaredConvex& c = stage.convexes.at(0);
  const auto p = [&](uint32_t i) {
    return stage::Vec3(c.vertex[3 * i], c.vertex[3 * i + 1], c.vertex[3 * i + 2]);
  };
  double volume = 0;
  for (size_t f = 0; f + 1 < c.face_start.size(); ++f) {
    const uint32_t* v = &c.face_vertex[c.face_start[f]];
    for (int k = 1; k < 3; ++k) volume += p(v[0]).dot(p(v[k]).cross(p(v[k + 1]))) / 6;
  }
  EXPECT_NEAR(volume, 6e-9, 1e-20);
}

TEST(Solids, SlotLeavesItsGapAndNestItsRing) {
  Stage slot("swage.object.solids"), nest("swage.object.solids");
  ASSERT_EQ(slot.configure({{"form", kSlot}, {"fixed", 1}, {"gap", 80e-6}}), SWAGE_OK);
  ASSERT_EQ(slot.convexes.size(), 2u);
  EXPECT_EQ(slot.bodies.at(0).motion, SWAGE_MOTION_FIXED);
  double below = -1, above = 1;
  for (const stage::DeclaredConvex& c : slot.convexes) {
    for (size_t i = 1; i < c.vertex.size(); i += 3) {
      if (c.vertex[i] < 0)
        below = std::max(below, c.vertex[i]);
      else
        above = std::min(above, c.vertex[i]);
    }
  }
  EXPECT_NEAR(below, -40e-6, 1e-15);
  EXPECT_NEAR(above, 40e-6, 1e-15);

  ASSERT_EQ(nest.configure({{"form", kNest}, {"fixed", 1}, {"diameter", 1e-3}, {"bead", 0.4e-3}}), SWAGE_OK);
  ASSERT_EQ(nest.shapes.size(), 3u);
  for (const stage::DeclaredShape& s : nest.shapes) {
    EXPECT_NEAR(std::hypot(s.a.x, s.a.y), 0.5e-3, 1e-15);
    EXPECT_DOUBLE_EQ(s.radius, 0.2e-3);
  }
}

TEST(Solids, TrayHasItsFloorAtZeroAndARim) {
  Stage tray("swage.object.solids");
  ASSERT_EQ(tray.configure({{"form", 5}, {"fixed", 1}, {"size", std::vector<double>{20e-3, 10e-3, 2e-3}}}),
            SWAGE_OK);
  ASSERT_EQ(tray.convexes.size(), 5u);
  // no wall reaches into the inside, and each bounds it
  const auto inside = [](double x, double y, double z) {
    return std::abs(x) < 9.999e-3 && std::abs(y) < 4.999e-3 && z > 1e-6;
  };
  double top = 0;
  for (const stage::DeclaredConvex& c : tray.convexes) {
    for (size_t i = 0; i < c.vertex.size(); i += 3) {
      EXPECT_FALSE(inside(c.vertex[i], c.vertex[i + 1], c.vertex[i + 2]));
      top = std::max(top, c.vertex[i + 2]);
    }
  }
  EXPECT_DOUBLE_EQ(top, 2e-3);
  for (size_t i = 2; i < tray.convexes[0].vertex.size(); i += 3) EXPECT_LE(tray.convexes[0].vertex[i], 0);
}

TEST(Solids, OnlyRoundThingsMove) {
  for (const double form : {kBox, kSlot, kNest, 5.0, kWire}) {
    Stage stage("swage.object.solids");
    EXPECT_LT(stage.configure({{"form", form}}), 0);
    EXPECT_EQ(stage.errors.size(), 1u);
  }
  Stage stub("swage.object.solids");
  EXPECT_LT(stub.configure({{"form", kCylinder}, {"length", 1e-3}, {"diameter", 1e-3}}), 0);
}

TEST(Solids, ACylinderIsTakenSomewhereAlongItsAxis) {
  Stage stage("swage.object.solids");
  ASSERT_EQ(stage.configure({{"form", kCylinder}, {"length", 4e-3}}), SWAGE_OK);
  ASSERT_EQ(stage.activate(), SWAGE_OK);
  stage.on_rt();
  stage::ObjectArrays arrays(stage);
  const stage::Pose X_WB(stage::Vec3(1e-3, 0, 0), toolkit::exp_rotation({0, 0.5 * kPi, 0}));  // axis along +x
  arrays.X_WB[0] = X_WB.abi();
  const swage_object_step step = arrays.step();
  swage_graspable_place place{};
  const auto& graspable = stage.table<swage_graspable>(SWAGE_TRAIT_GRASPABLE);
  graspable.locate(stage.raw(), &step, {2e-3, 0, 0.5e-3}, &place);
  EXPECT_NEAR(place.s, 0.75, 1e-12);
  EXPECT_NEAR(place.p_W.x, 2e-3, 1e-15);
  EXPECT_NEAR(place.tangent_W.x, 1, 1e-12);
  graspable.locate(stage.raw(), &step, {9e-3, 0, 0}, &place);
  EXPECT_DOUBLE_EQ(place.s, 1);
}

}  // namespace
}  // namespace swage::solids
