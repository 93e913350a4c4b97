// SPDX-License-Identifier: Apache-2.0
//
// The needle: closed forms of mass and inertia against numerical integration, frames, and where a point lies along it.
#include "plugins/needle/arc.hpp"

#include <fstream>

#include "plugins/needle/form.hpp"

#include "stage.hpp"
#include "test_places.hpp"

namespace swage::needle {
namespace {

constexpr double kPi = std::numbers::pi;

/// Mass, first and second moments about the circle's centre by the midpoint rule in torus coordinates.
struct Moments {
  double mass = 0;
  Vec3 first = Vec3::Zero();
  toolkit::Mat3 second = toolkit::Mat3::Zero();
};

Moments integrate(const Arc& arc, double density, int n_angle, int n_radius, int n_round) {
  Moments m;
  const double da = arc.sweep / n_angle, dr = arc.wire_radius / n_radius, dp = 2 * kPi / n_round;
  for (int i = 0; i < n_angle; ++i) {
    const double a = -0.5 * arc.sweep + (i + 0.5) * da;
    for (int j = 0; j < n_radius; ++j) {
      const double r = (j + 0.5) * dr;
      for (int k = 0; k < n_round; ++k) {
        const double psi = (k + 0.5) * dp, rho = arc.radius + r * std::cos(psi);
        const Vec3 p(rho * std::cos(a), rho * std::sin(a), r * std::sin(psi));
        const double dm = density * rho * r * da * dr * dp;
        m.mass += dm;
        m.first += dm * p;
        m.second += dm * p * p.transpose();
      }
    }
  }
  return m;
}

void expect_close(const Arc& arc) {
  const double density = 7900;
  const ArcMass exact = mass_of(arc, density);
  const Moments sum = integrate(arc, density, 400, 60, 32);
  const Vec3 centre = sum.first / sum.mass;
  // inertia about the centre of mass
  const toolkit::Mat3 c = sum.second - sum.mass * centre * centre.transpose();
  const toolkit::Mat3 inertia = c.trace() * toolkit::Mat3::Identity() - c;

  // the midpoint rule with 60 rings and 400 slices is good to 1e-4
  EXPECT_NEAR(exact.mass, sum.mass, 2e-4 * sum.mass);
  EXPECT_NEAR(exact.centre, centre.x(), 2e-5 * arc.radius);
  EXPECT_NEAR(centre.y(), 0, 1e-12 * arc.radius);
  const double scale = inertia.diagonal().maxCoeff();
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(exact.inertia[k], inertia(k, k), 3e-4 * scale) << "axis " << k;
  EXPECT_NEAR(inertia(0, 1), 0, 1e-9 * scale);
  EXPECT_NEAR(inertia(0, 2), 0, 1e-9 * scale);
}

TEST(Arc, MassAndInertiaAgreeWithIntegration) {
  for (const double share : {0.25, 0.375, 0.5, 0.625})
    expect_close(arc_of_chord(2 * kPi * share, 5e-3, 0.05e-3));
}

// a wire as thick as the formulas allow: the terms in r^2 are a few per cent here and cannot hide
TEST(Arc, MassAndInertiaOfAThickWire) { expect_close({1e-3, 2.0, 0.25e-3}); }

TEST(Arc, InertiaWouldNoticeAMissingTerm) {
  const Arc arc{1e-3, 2.0, 0.25e-3};
  const Moments sum = integrate(arc, 7900, 400, 60, 32);
  const double thin =
      7900 * kPi * 0.25e-3 * 0.25e-3 * 1e-3 * 2.0 * 1e-3 * std::sin(1.0);  // first moment, r^2/4R left out
  EXPECT_GT(std::abs(sum.first.x() - thin), 1e-2 * thin);
}

// the figures of the reference scene: 3/8 circle, chord 5 mm, 0.1 mm wire, 7900 kg/m3
TEST(Arc, ReferenceNeedle) {
  const Arc arc = arc_of_chord(0.75 * kPi, 5e-3, 0.05e-3);
  EXPECT_NEAR(arc.radius, 2.7060e-3, 1e-7);
  EXPECT_NEAR(arc.length(), 6.3758e-3, 1e-7);
  const ArcMass m = mass_of(arc, 7900);
  EXPECT_NEAR(m.mass, 3.956e-7, 1e-10);
  EXPECT_NEAR(m.centre, 2.1221e-3, 3e-7);
  EXPECT_NEAR(m.inertia.z(), 1.1160e-12, 1e-15);
  EXPECT_NEAR(m.inertia.x(), 1.0143e-12, 3e-16);  // about the radial axis
  EXPECT_NEAR(m.inertia.y(), 1.0218e-13, 3e-16);  // about the tangent of the middle
}

TEST(Arc, LengthAndChordAgree) {
  const Arc arc = arc_of_length(0.75 * kPi, 6e-3, 0.05e-3);
  EXPECT_DOUBLE_EQ(arc.length(), 6e-3);
  const Arc same = arc_of_chord(0.75 * kPi, arc.chord(), 0.05e-3);
  EXPECT_NEAR(same.radius, arc.radius, 1e-15);
}

/// Where the instance's needle lies when its object frame is O = W.
struct OnStage {
  explicit OnStage(const stage::Params& params) : stage("swage.object.needle") {
    EXPECT_EQ(stage.configure(params), SWAGE_OK);
    EXPECT_EQ(stage.activate(), SWAGE_OK);
    stage.on_rt();
  }
  stage::Stage stage;
};

// numbers of the choices
constexpr double kHalf = 3, kFourEighths = 6, kStraight = 7, kLength = 2, kBending = 1;

TEST(Needle, DeclaresOneArcAboutItsCentreOfMass) {
  OnStage on({{"arc", kHalf}, {"size_of", kLength}, {"size", 4e-3}, {"wire_diameter", 70e-6}});
  ASSERT_EQ(on.stage.bodies.size(), 1u);
  ASSERT_EQ(on.stage.arcs.size(), 1u);
  const swage_arc& arc = on.stage.arcs[0];
  EXPECT_EQ(on.stage.bodies[0].motion, SWAGE_MOTION_DYNAMIC);
  EXPECT_NEAR(arc.sweep, kPi, 1e-12);
  EXPECT_NEAR(arc.radius, 4e-3 / kPi, 1e-12);
  EXPECT_DOUBLE_EQ(arc.wire_radius, 35e-6);

  // the wire, seen from O: its middle is at the origin, its tangent there +y, the circle's centre on -x
  const toolkit::Pose X_OA = toolkit::Pose(on.stage.bodies[0].X_OB) * toolkit::Pose(arc.X_BA);
  const auto at = [&](double s) {
    const double a = s * arc.sweep;
    return Vec3(X_OA * Vec3(arc.radius * std::cos(a), arc.radius * std::sin(a), 0));
  };
  EXPECT_NEAR(at(0.5).norm(), 0, 1e-15);
  EXPECT_GT(at(0.51).y(), 0);
  EXPECT_NEAR(at(0).y(), -arc.radius, 1e-12);  // half a circle
  EXPECT_NEAR(X_OA.p.x(), -arc.radius, 1e-12);
}

TEST(Needle, NamesOfTheThesisAreTheSameCircles) {
  OnStage a({{"arc", kHalf}}), b({{"arc", kFourEighths}});
  EXPECT_EQ(a.stage.arcs[0].sweep, b.stage.arcs[0].sweep);
}

// thesis 6.2.2: the simplified needle is a straight rod
TEST(Needle, AStraightOneHasTheMassOfARod) {
  OnStage on({{"arc", kStraight}, {"size_of", kLength}, {"size", 5e-3}, {"wire_diameter", 100e-6}, {"density", 7900}});
  const swage_mass& m = on.stage.bodies.at(0).mass;
  const double r = 50e-6, L = 5e-3, mass = 7900 * kPi * r * r * L;
  EXPECT_NEAR(m.mass, mass, 1e-12 * mass);
  const double along = 0.5 * mass * r * r, across = mass * (L * L / 12 + 0.25 * r * r);
  EXPECT_NEAR(m.inertia.y, along, 1e-3 * along);
  EXPECT_NEAR(m.inertia.x, across, 1e-6 * across);
  EXPECT_NEAR(m.inertia.z, across, 1e-6 * across);
  // no place of it is further from the chord than a micrometre, and it is as long as its chord
  const swage_arc& arc = on.stage.arcs.at(0);
  const toolkit::Pose X_OA = toolkit::Pose(on.stage.bodies[0].X_OB) * toolkit::Pose(arc.X_BA);
  for (const double s : {0.0, 0.25, 0.5, 1.0}) {
    const double a = s * arc.sweep;
    const Vec3 p = X_OA * Vec3(arc.radius * std::cos(a), arc.radius * std::sin(a), 0);
    EXPECT_LT(std::hypot(p.x(), p.z()), 1e-6);
    EXPECT_NEAR(p.y(), (s - 0.5) * L, 1e-9);
  }
}

TEST(Needle, LocateIsTheInverseOfWhereItIs) {
  OnStage on({});
  stage::ObjectArrays arrays(on.stage);
  // somewhere, turned somehow
  const toolkit::Pose X_WO(Vec3(1e-3, -2e-3, 5e-3), toolkit::exp_rotation({0.4, -1.1, 2.0}));
  arrays.X_WB[0] = (X_WO * toolkit::Pose(on.stage.bodies[0].X_OB)).abi();
  const swage_object_step step = arrays.step();
  const swage_arc& arc = on.stage.arcs[0];
  const toolkit::Pose X_WA = toolkit::Pose(arrays.X_WB[0]) * toolkit::Pose(arc.X_BA);
  const auto& graspable = on.stage.table<swage_graspable>(SWAGE_TRAIT_GRASPABLE);

  for (const double s : {0.0, 0.1, 0.5, 0.73, 1.0}) {
    const double a = s * arc.sweep;
    const Vec3 radial = X_WA.q * Vec3(std::cos(a), std::sin(a), 0);
    const Vec3 tangent = X_WA.q * Vec3(-std::sin(a), std::cos(a), 0);
    const Vec3 on_line = X_WA.p + arc.radius * radial;
    // a place on the surface, off the plane of the needle
    const Vec3 p = on_line + 50e-6 * (0.6 * radial + 0.8 * (X_WA.q * Vec3::UnitZ()));
    swage_graspable_place place{};
    ASSERT_EQ(graspable.locate(on.stage.raw(), &step, toolkit::raw(p), &place), SWAGE_OK);
    EXPECT_NEAR(place.s, s, 1e-12);
    EXPECT_NEAR(place.length, arc.radius * arc.sweep, 1e-15);
    EXPECT_LT((toolkit::vec(place.p_W) - on_line).norm(), 1e-15);
    EXPECT_LT((toolkit::vec(place.tangent_W) - tangent).norm(), 1e-12);
    EXPECT_NEAR(toolkit::vec(place.normal_W).dot(tangent), 0, 1e-12);
  }
}

TEST(Needle, BeyondTheEndsTheEndsAreNearest) {
  OnStage on({});
  stage::ObjectArrays arrays(on.stage);
  const swage_object_step step = arrays.step();
  const auto& graspable = on.stage.table<swage_graspable>(SWAGE_TRAIT_GRASPABLE);
  swage_graspable_place place{};
  graspable.locate(on.stage.raw(), &step, {-4e-3, -8e-3, 1e-3}, &place);
  EXPECT_DOUBLE_EQ(place.s, 0);
  graspable.locate(on.stage.raw(), &step, {-4e-3, 8e-3, 1e-3}, &place);
  EXPECT_DOUBLE_EQ(place.s, 1);
}

// a taper and a drilled swage: slices against integration, and axes that are principal ones
TEST(Form, MassOfATaperedNeedle) {
  Form form;
  form.taper_length = 1.5e-3;
  form.swage_length = 0.5e-3;
  const ArcMass m = mass_of(form);
  const Arc arc = form.arc();
  double mass = 0, x = 0, y = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) / n, length = arc.length();
    double d = form.wire_diameter;
    if (s * length < 1.5e-3) d = 20e-6 + 80e-6 * s * length / 1.5e-3;
    const double hole = (1 - s) * length < 0.5e-3 ? 0.5 : 0;
    const double dm = 7900 * 0.25 * kPi * d * d * (1 - hole * hole) * length / n;
    mass += dm;
    x += dm * (arc.radius + d * d / 16 / arc.radius) * std::cos(arc.angle(s));
    y += dm * arc.radius * std::sin(arc.angle(s));
  }
  EXPECT_NEAR(m.mass, mass, 2e-3 * mass);
  EXPECT_NEAR(m.centre, x / mass, 2e-3 * arc.radius);
  EXPECT_NEAR(m.along, y / mass, 2e-3 * arc.radius);
  EXPECT_GT(m.along, 1e-4 * arc.radius) << "towards the swage";

  toolkit::Mat3 I = m.inertia.asDiagonal();
  I(0, 1) = I(1, 0) = -m.product;
  const toolkit::Mat3 R = toolkit::exp_rotation({0, 0, -m.principal()}).toRotationMatrix();
  const toolkit::Mat3 P = R * I * R.transpose();
  EXPECT_NEAR(P(0, 1), 0, 1e-12 * P(2, 2));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(P(k, k), m.principal_inertia()[k], 1e-12 * P(2, 2));
}

// the sum over the pieces of a uniform needle is the whole
TEST(Form, PiecesWeighTogetherWhatTheWholeWeighs) {
  const Form form;
  const ArcMass whole = mass_of(form);
  double mass = 0, x = 0;
  for (int i = 0; i < 7; ++i) {
    const ArcMass m = mass_of(form, i / 7.0, (i + 1) / 7.0);
    mass += m.mass, x += m.mass * m.centre;
  }
  EXPECT_NEAR(mass, whole.mass, 1e-12 * whole.mass);
  EXPECT_NEAR(x / mass, whole.centre, 1e-12 * whole.centre);
}

std::string library(const std::string& name) {
  return SWAGE_SOURCE_DIR "/resources/needles/" + name + ".json";
}

TEST(Library, EveryModelIsANeedle) {
  for (const char* model : {"micro_70", "micro_100", "micro_100_half", "micro_130", "micro_130_flat",
                            "micro_150", "thesis_2_8", "thesis_3_8", "thesis_4_8"}) {
    Form form;
    EXPECT_EQ(read_model(library(model), form), "");
    EXPECT_EQ(fault(form), "") << model;
    stage::Stage stage("swage.object.needle");
    EXPECT_EQ(stage.configure({{"model", library(model)}}), SWAGE_OK) << model;
    EXPECT_NEAR(stage.arcs.at(0).wire_radius, 0.5 * form.wire_diameter, 1e-15);
  }
}

TEST(Library, WhatALessonGivesOverridesTheModel) {
  stage::Stage stage("swage.object.needle");
  ASSERT_EQ(stage.configure({{"model", library("micro_70")}, {"wire_diameter", 90e-6}}), SWAGE_OK);
  EXPECT_DOUBLE_EQ(stage.arcs.at(0).wire_radius, 45e-6);
  EXPECT_NEAR(stage.arcs.at(0).radius * stage.arcs.at(0).sweep, 3e-3, 1e-12) << "the rest is the model's";
}

TEST(Library, SaysWhatIsWrongWithAFile) {
  const std::string path = SWAGE_BINARY_DIR "/needle_model.json";
  const auto said = [&](const std::string& values) {
    std::ofstream(path) << R"({"format": "swage-needle/1", "values": {)" << values << "}}";
    Form form;
    return read_model(path, form);
  };
  const std::string rest = R"(, "status": "assumed", "source": "a test"})";
  EXPECT_EQ(said(R"("wire_diameter": {"value": 80, "unit": "um")" + rest), "");
  EXPECT_EQ(said(R"("wire_diameter": {"value": 80, "unit": "mm")" + rest),
            path + ": \"wire_diameter\" is in um, not mm");
  EXPECT_EQ(said(R"("colour": {"value": 80, "unit": "um")" + rest),
            path + ": \"colour\" is not a property of a needle");
  EXPECT_EQ(said(R"("wire_diameter": {"value": 80, "unit": "um"})"),
            path + ": \"wire_diameter\" needs a status (sourced or assumed) and a source");
  EXPECT_EQ(said(R"("wire_diameter": 80)"), path + ": \"wire_diameter\" needs a value and a unit");
  stage::Stage stage("swage.object.needle");
  EXPECT_LT(stage.configure({{"model", path}}), 0);
  EXPECT_EQ(stage.errors.at(0).substr(0, 6), "model:");
}

TEST(BendingNeedle, IsAChainOfArcsWhoseEndsMeet) {
  OnStage on({{"level", kBending}});
  ASSERT_EQ(on.stage.bodies.size(), 12u);
  ASSERT_EQ(on.stage.arcs.size(), 12u);
  EXPECT_EQ(on.stage.bodies[0].motion, SWAGE_MOTION_FLEXIBLE);
  OnStage rigid({});
  EXPECT_LT((toolkit::vec(on.stage.bodies[0].X_OB.p) - toolkit::vec(rigid.stage.bodies[0].X_OB.p)).norm(),
            1e-15)
      << "the first body has the frame of the rigid needle";

  // body 0 carries piece 6, the others follow in order; arcs are declared from the point to the swage
  const auto end = [&](size_t piece, bool far) {
    const size_t b = piece == 6 ? 0 : piece < 6 ? piece + 1 : piece;
    const swage_arc& arc = on.stage.arcs[piece];
    const toolkit::Pose X_OA = toolkit::Pose(on.stage.bodies[b].X_OB) * toolkit::Pose(arc.X_BA);
    const double a = far ? arc.sweep : 0;
    return Vec3(X_OA * Vec3(arc.radius * std::cos(a), arc.radius * std::sin(a), 0));
  };
  for (size_t i = 0; i + 1 < 12; ++i) EXPECT_LT((end(i, true) - end(i + 1, false)).norm(), 1e-15) << i;
  const Arc arc = arc_of_chord(0.75 * kPi, 5e-3, 0.05e-3);
  EXPECT_NEAR((end(0, false) - end(11, true)).norm(), arc.chord(), 1e-12);
}

TEST(BendingNeedle, LocateRunsFromPointToSwageWithoutAJump) {
  OnStage on({{"level", kBending}}), rigid({});
  stage::ObjectArrays arrays(on.stage), rigid_arrays(rigid.stage);
  for (size_t b = 0; b < on.stage.bodies.size(); ++b) arrays.X_WB[b] = on.stage.bodies[b].X_OB;
  rigid_arrays.X_WB[0] = rigid.stage.bodies[0].X_OB;
  const swage_object_step step = arrays.step(), rigid_step = rigid_arrays.step();
  const auto& bending = on.stage.table<swage_graspable>(SWAGE_TRAIT_GRASPABLE);
  const auto& straight = rigid.stage.table<swage_graspable>(SWAGE_TRAIT_GRASPABLE);
  const Arc arc = arc_of_chord(0.75 * kPi, 5e-3, 0.05e-3);
  for (double s = 0; s <= 1; s += 0.01) {
    const Vec3 p = place_at(arc, s).p - Vec3(arc.radius, 0, 0) + Vec3(10e-6, 20e-6, 30e-6);
    swage_graspable_place a{}, b{};
    bending.locate(on.stage.raw(), &step, toolkit::raw(p), &a);
    straight.locate(rigid.stage.raw(), &rigid_step, toolkit::raw(p), &b);
    EXPECT_NEAR(a.s, b.s, 1e-12);
    EXPECT_LT((toolkit::vec(a.p_W) - toolkit::vec(b.p_W)).norm(), 1e-14);
    EXPECT_LT((toolkit::vec(a.tangent_W) - toolkit::vec(b.tangent_W)).norm(), 1e-11);
    EXPECT_EQ(a.length, b.length);
  }
}

TEST(Needle, RefusesAWireThatCannotBeBentSoFar) {
  stage::Stage stage("swage.object.needle");
  EXPECT_LT(stage.configure({{"size", 0.6e-3}, {"wire_diameter", 0.5e-3}}), 0);
  ASSERT_EQ(stage.errors.size(), 1u);
  EXPECT_EQ(stage.errors[0].substr(0, 5), "size:");
}

}  // namespace
}  // namespace swage::needle
