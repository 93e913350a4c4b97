// SPDX-License-Identifier: Apache-2.0
//
// The needleholder: closed outlines, the tool frame, and how force grows with closure.
#include "plugins/jaws/jaw_shape.hpp"

#include "stage.hpp"

namespace swage::jaws {
namespace {

using toolkit::Pose;
using toolkit::Vec3;

Vec3 vertex(const JawMesh& mesh, uint32_t i) {
  return {mesh.vertex[3 * i], mesh.vertex[3 * i + 1], mesh.vertex[3 * i + 2]};
}

Vec3 face_normal(const JawMesh& mesh, uint32_t face) {
  const uint32_t* f = &mesh.face_vertex[mesh.face_start[face]];
  const Vec3 a = vertex(mesh, f[0]), b = vertex(mesh, f[1]), c = vertex(mesh, f[2]);
  return (b - a).cross(c - b).normalized();
}

/// Closed, convex and facing outwards; volume by the divergence theorem.
double check_solid(const JawMesh& mesh) {
  Vec3 middle = Vec3::Zero();
  for (uint32_t i = 0; i < mesh.n_vertex(); ++i) middle += vertex(mesh, i) / mesh.n_vertex();
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  double volume = 0;
  for (uint32_t f = 0; f < mesh.n_face(); ++f) {
    const Vec3 n = face_normal(mesh, f);
    const uint32_t first = mesh.face_start[f], count = mesh.face_start[f + 1] - first;
    const Vec3 p0 = vertex(mesh, mesh.face_vertex[first]);
    EXPECT_LT(n.dot(middle - p0), 0) << "face " << f << " looks inwards";
    for (uint32_t i = 0; i < mesh.n_vertex(); ++i)
      EXPECT_LT(n.dot(vertex(mesh, i) - p0), 1e-15) << "not convex";
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t a = mesh.face_vertex[first + i], b = mesh.face_vertex[first + (i + 1) % count];
      edges[{a, b}] += 1;
      const Vec3 pa = vertex(mesh, a) - p0, pb = vertex(mesh, b) - p0;
      volume += (p0 - middle).dot(pa.cross(pb)) / 6;
    }
  }
  for (const auto& [edge, times] : edges) {
    EXPECT_EQ(times, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << "an edge with one face only";
  }
  return volume;
}

TEST(JawMesh, AllAreClosedAndFaceOutwards) {
  JawSize sharp;
  sharp.tip_width = 0;
  for (const bool left : {true, false}) {
    EXPECT_NEAR(check_solid(prism(JawSize{}, left)), 6e-3 * 0.9e-3 * 0.3e-3, 1e-15);
    EXPECT_NEAR(check_solid(prism(sharp, left)), 6e-3 * 0.75e-3 * 0.3e-3, 1e-15);
    EXPECT_NEAR(check_solid(tetrahedron(sharp, left)), 6e-3 * 0.75e-3 * 0.3e-3 / 3, 1e-15);
  }
}

// thesis 4.2.9: the pair has 8 planes and 12 edges
TEST(JawMesh, ThePairOfTheThesisHasEightPlanesAndTwelveEdges) {
  const JawMesh mesh = tetrahedron(JawSize{}, true);
  EXPECT_EQ(2 * mesh.n_face(), 8u);
  EXPECT_EQ(2 * mesh.face_vertex.size() / 2, 12u);
}

TEST(JawMesh, GrippingFacesMeetInThePlaneOfClosing) {
  for (const JawShape shape : {JawShape::kPrism, JawShape::kTetrahedron}) {
    for (const bool left : {true, false}) {
      const JawMesh mesh = jaw_mesh(shape, JawSize{}, left);
      EXPECT_LT((face_normal(mesh, 0) - Vec3(0, 0, left ? -1 : 1)).norm(), 1e-12);
      for (uint32_t i = 0; i < mesh.n_vertex(); ++i) EXPECT_GE((left ? 1 : -1) * vertex(mesh, i).z(), 0);
    }
  }
}

TEST(GripLaw, ForceStartsWhereTheJawsMeetAndEndsAtTheLimit) {
  const GripLaw law;
  EXPECT_DOUBLE_EQ(law.target(0), law.half_opening);
  EXPECT_NEAR(law.target(law.closed_at()), 0, 1e-15);
  EXPECT_NEAR(law.force(0, law.target(law.closed_at())), 0, 1e-12);
  EXPECT_NEAR(law.force(0, law.target(1)), law.max_grip, 1e-12);
  // halfway between touch and fully squeezed: half the force
  EXPECT_NEAR(law.force(0, law.target(0.5 * (1 + law.closed_at()))), 0.5 * law.max_grip, 1e-12);
  EXPECT_DOUBLE_EQ(law.force(0.5, law.target(1)), law.max_grip);
}

TEST(GripLaw, ForceGrowsWithClosureOnAWire) {
  const GripLaw law;
  const double angle = 50e-6 / 8e-3;  // half a 0.1 mm wire, 2 mm behind the tips
  double last = -1;
  for (double closure = law.closed_at(); closure <= 1.0; closure += 0.01) {
    const double force = law.force(angle, law.target(closure));
    EXPECT_GE(force, last);
    last = force;
  }
  EXPECT_DOUBLE_EQ(last, law.max_grip);
}

/// Both jaws at rest at an angle, tool at X_WT.
struct OnStage {
  explicit OnStage(const stage::Params& params = {}) : stage("swage.object.jaws") {
    EXPECT_EQ(stage.configure(params), SWAGE_OK);
    EXPECT_EQ(stage.activate(), SWAGE_OK);
    stage.on_rt();
  }
  /// Arrays with both jaws turned as a host would: about the hinge, by its angle.
  stage::ObjectArrays pose(const Pose& X_WT, double left, double right) {
    stage::ObjectArrays arrays(stage);
    arrays.X_WB[0] = X_WT.abi();
    arrays.angle = {left, right};
    for (size_t i = 0; i < 2; ++i) {
      const swage_hinge& hinge = stage.hinges[i];
      const Vec3 anchor = toolkit::vec(hinge.anchor), axis = toolkit::vec(hinge.axis);
      const Pose turn(anchor, toolkit::exp_rotation(arrays.angle[i] * axis));
      const Pose X_TJ0 = Pose(stage.bodies[hinge.child].X_OB);
      arrays.X_WB[hinge.child] = (X_WT * turn * Pose(-anchor, toolkit::Quat::Identity()) * X_TJ0).abi();
    }
    return arrays;
  }
  swage_drive drive(stage::ObjectArrays& arrays) {
    const swage_object_step step = arrays.step();
    EXPECT_EQ(stage.table<swage_object>(SWAGE_EXT_OBJECT).forces(stage.raw(), &step), SWAGE_OK);
    EXPECT_EQ(arrays.drive[0].target, arrays.drive[1].target);
    return arrays.drive[0];
  }
  double signal(stage::ObjectArrays& arrays, const char* id) {
    const swage_object_step step = arrays.step();
    EXPECT_EQ(stage.table<swage_object>(SWAGE_EXT_OBJECT).finish(stage.raw(), &step), SWAGE_OK);
    return arrays.signal[stage.index_of(SWAGE_DECLARE_SIGNAL, id)];
  }
  stage::Stage stage;
};

swage_input closing(double closure) {
  swage_input input{};
  input.X_WD.q.w = 1;
  input.closure = closure;
  input.valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;
  return input;
}

TEST(Jaws, OneBodyFollowsAndTwoAreHingedToIt) {
  OnStage on;
  ASSERT_EQ(on.stage.bodies.size(), 3u);
  EXPECT_EQ(on.stage.bodies[0].motion, SWAGE_MOTION_FOLLOWS);
  ASSERT_EQ(on.stage.hinges.size(), 2u);
  for (const swage_hinge& hinge : on.stage.hinges) {
    EXPECT_EQ(hinge.parent, 0u);
    EXPECT_EQ(on.stage.bodies[hinge.child].motion, SWAGE_MOTION_HINGED);
    EXPECT_EQ(hinge.min, 0);
  }
}

TEST(Jaws, ToolFrame) {
  OnStage on;
  const Pose X_WT(Vec3(3e-3, 1e-3, -2e-3), toolkit::exp_rotation({0.3, 1.0, -0.7}));
  stage::ObjectArrays arrays = on.pose(X_WT, 0.1, 0.05);
  const swage_object_step step = arrays.step();
  swage_gripper_state jaws{};
  ASSERT_EQ(on.stage.table<swage_gripper>(SWAGE_TRAIT_GRIPPER).describe(on.stage.raw(), &step, &jaws),
            SWAGE_OK);
  EXPECT_LT((toolkit::vec(jaws.axis_W) - X_WT.q * Vec3::UnitX()).norm(), 1e-12);
  EXPECT_LT((toolkit::vec(jaws.closing_W) - X_WT.q * Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(jaws.opening, 0.15, 1e-15);

  // the left jaw opens towards +z of T, the right one towards -z, each on a circle about the hinge
  const auto tip = [&](uint32_t body) {
    return Vec3(X_WT.inverse() * (Pose(arrays.X_WB[body]) * Vec3(10e-3, 0, 0)));
  };
  EXPECT_LT((tip(jaws.left_body) - Vec3(10e-3 * (std::cos(0.1) - 1), 0, 10e-3 * std::sin(0.1))).norm(),
            1e-15);
  EXPECT_LT((tip(jaws.right_body) - Vec3(10e-3 * (std::cos(0.05) - 1), 0, -10e-3 * std::sin(0.05))).norm(),
            1e-15);

  // closed, the tips are at T's origin
  stage::ObjectArrays closed = on.pose(X_WT, 0, 0);
  const swage_object_step shut = closed.step();
  on.stage.table<swage_gripper>(SWAGE_TRAIT_GRIPPER).describe(on.stage.raw(), &shut, &jaws);
  EXPECT_LT((toolkit::vec(jaws.tip_W) - X_WT.p).norm(), 1e-15);
}

TEST(Jaws, DriveFollowsTheHandAndIsLimited) {
  OnStage on;
  stage::ObjectArrays arrays = on.pose(Pose(), 0.0, 0.0);
  swage_input input = closing(0.6);  // closed_at for 18 deg of opening and 6 deg of squeeze
  arrays.input = &input;
  EXPECT_NEAR(on.drive(arrays).target, 0, 1e-15);
  EXPECT_NEAR(on.signal(arrays, "grip.command"), 0, 1e-12);
  input.closure = 0.8;
  EXPECT_NEAR(on.drive(arrays).target, -3 * kDegree, 1e-15);
  EXPECT_NEAR(on.signal(arrays, "grip.command"), 1.0, 1e-12);

  // with a thick thing between them the mean force stays at the limit, yet a shift to one side is resisted
  arrays = on.pose(Pose(), 0.06, 0.04);
  arrays.input = &input;
  input.closure = 1;
  const swage_drive drive = on.drive(arrays);
  const double left = drive.stiffness * (0.06 - drive.target) / 10e-3;
  const double right = drive.stiffness * (0.04 - drive.target) / 10e-3;
  EXPECT_NEAR(0.5 * (left + right), 2.0, 1e-12);
  EXPECT_GT(left - right, 0.3);
  EXPECT_LT(left, drive.max_torque / 10e-3);
  EXPECT_NEAR(on.signal(arrays, "grip.command"), 2.0, 1e-12);
}

TEST(Jaws, WithoutAHandTheRestClosureHolds) {
  OnStage on({{"rest_closure", 0.8}});
  stage::ObjectArrays arrays = on.pose(Pose(), 0.0, 0.0);
  EXPECT_NEAR(on.drive(arrays).target, -3 * kDegree, 1e-15);
  swage_input input = closing(0.2);
  arrays.input = &input;
  EXPECT_GT(on.drive(arrays).target, 0.05);
  input.valid = SWAGE_VALID_POSE;  // a device that measures no closure
  EXPECT_NEAR(on.drive(arrays).target, -3 * kDegree, 1e-15);
}

TEST(Jaws, AMeasuredForceIsTheForce) {
  OnStage on;
  stage::ObjectArrays arrays = on.pose(Pose(), 0.01, 0.01);
  swage_input input = closing(0.6);
  input.valid |= SWAGE_VALID_GRIP;
  input.grip_force = 3;  // N at the handle, 0.6 N at the tips
  arrays.input = &input;
  EXPECT_NEAR(on.signal(arrays, "grip.command"), 0.6, 1e-12);
  const swage_drive drive = on.drive(arrays);
  EXPECT_NEAR(drive.stiffness * (0.01 - drive.target) / 10e-3, 0.6, 1e-12);
  input.grip_force = 30;
  EXPECT_NEAR(on.signal(arrays, "grip.command"), 2.0, 1e-12);
}

TEST(Jaws, RefusesImpossibleSizes) {
  stage::Stage stage("swage.object.jaws");
  EXPECT_LT(stage.configure({{"length", 20e-3}, {"tip_width", 2e-3}}), 0);
  EXPECT_EQ(stage.errors.size(), 2u);
}

}  // namespace
}  // namespace swage::jaws
