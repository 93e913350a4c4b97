// SPDX-License-Identifier: Apache-2.0
#include "jaws.hpp"

#include <swage/plugin.hpp>

#include "toolkit/math.hpp"

namespace swage::jaws {

using toolkit::Pose;
using toolkit::Vec3;

void Jaws::build(const JawsParams& params, ObjectBuilder& builder) {
  check(params, builder);
  if (builder.failed()) return;
  law_ = {params.reach, 0.5 * params.opening, params.squeeze, params.max_grip, params.handle_mass};
  handle_ratio_ = params.handle_ratio;
  rest_closure_ = params.rest_closure;
  blades_ = params.blades, shear_ = params.shear;

  // the tool's frame is the hand's: O = T. The shaft behind the hinge is drawn only and touches nothing
  tool_ = builder.following_body("tool");
  const double shaft = 0.5 * params.base_width;
  builder.cylinder(tool_, {-4 * params.reach, 0, 0}, {-params.reach, 0, 0}, shaft, SWAGE_SHAPE_DRAWN);
  build_jaw(params, builder, true);
  build_jaw(params, builder, false);

  opening_ = builder.signal("jaws.opening", "rad", "Angle between the jaws.");
  command_ =
      builder.signal("grip.command", "N", "Force that the handle puts on each jaw, as felt at the tip.");
}

void Jaws::check(const JawsParams& params, ObjectBuilder& builder) const {
  if (params.length >= params.reach) {
    builder.error("length", "the gripping faces must end before the hinge: length is below reach");
  }
  if (params.tip_width > params.base_width)
    builder.error("tip_width", "the tip must not be wider than the base");
}

void Jaws::build_jaw(const JawsParams& params, ObjectBuilder& builder, bool left) {
  const int i = left ? 0 : 1;
  const double side = left ? 1 : -1;
  jaw_[i] = builder.hinged_body(left ? "jaw_left" : "jaw_right", at(-params.reach, 0, 0));

  const JawMesh mesh =
      jaw_mesh(params.shape,
               {params.reach, params.length, params.base_width, params.tip_width, params.thickness}, left);
  builder.convex(jaw_[i], mesh.vertex, mesh.face_start, mesh.face_vertex);

  // the arm from the hinge to the gripping face is drawn only
  const double arm = 0.5 * params.thickness;
  builder.capsule(jaw_[i], {0, 0, side * arm}, {params.reach - params.length, 0, side * arm}, arm,
                  SWAGE_SHAPE_DRAWN);

  // a growing angle opens: the left tip moves to +z, the right one to -z. Closed jaws stop at 0
  hinge_[i] = builder.hinge(
      {tool_, jaw_[i], {-params.reach, 0, 0}, {0, -side, 0}, law_.inertia(), 0, law_.half_opening});
}

double Jaws::closure(const Step& step) const {
  const swage_input* input = step.input();
  return input != nullptr && (input->valid & SWAGE_VALID_CLOSURE) != 0 ? input->closure : rest_closure_;
}

double Jaws::target(const Step& step) const {
  const double mean = 0.5 * (step.hinge_angle(hinge_[0]) + step.hinge_angle(hinge_[1]));
  const swage_input* input = step.input();

  // a measured grip force is used unchanged
  const bool measured = input != nullptr && (input->valid & SWAGE_VALID_GRIP) != 0 && input->grip_force > 0;
  if (measured) return mean + law_.target_of_force(handle_ratio_ * input->grip_force);

  // the limit acts on the mean of both jaws: an object between them stays centred even at the greatest grip force
  return std::clamp(law_.target(closure(step)), mean - law_.squeeze, mean + law_.squeeze);
}

void Jaws::forces(const Step& step) {
  // one jaw alone may take up to twice the limit, as when the other is pushed away from it
  const swage_drive drive{target(step), law_.stiffness(), law_.damping(), 2 * law_.max_torque()};
  for (const Hinge hinge : hinge_) step.drive(hinge) = drive;
}

void Jaws::finish(const Step& step) {
  const double left = step.hinge_angle(hinge_[0]), right = step.hinge_angle(hinge_[1]);
  step.signal(opening_, left + right);
  step.signal(command_, law_.force(0.5 * (left + right), target(step)));
}

const void* Jaws::extension(std::string_view wanted) {
  return wanted == SWAGE_TRAIT_BLADES ? blades_table<Jaws>() : nullptr;
}

void Jaws::describe(const Step& step, swage_gripper_state& out) {
  const Pose X_WT(step.pose(tool_));
  const Vec3 tip_J(law_.reach, 0, 0);
  const Vec3 left_W = Pose(step.pose(jaw_[0])) * tip_J;
  const Vec3 right_W = Pose(step.pose(jaw_[1])) * tip_J;
  out.left_body = jaw_[0];
  out.right_body = jaw_[1];
  out.tip_W = toolkit::raw(Vec3(0.5 * (left_W + right_W)));
  out.axis_W = toolkit::raw(X_WT.q * Vec3::UnitX());
  out.closing_W = toolkit::raw(X_WT.q * Vec3::UnitZ());
  out.opening = step.hinge_angle(hinge_[0]) + step.hinge_angle(hinge_[1]);
  out.closure = closure(step);
}

}  // namespace swage::jaws

SWAGE_EXPORT(swage::jaws::Jaws)
