// SPDX-License-Identifier: Apache-2.0
#include "@FILE@.hpp"

#include <swage/eigen.hpp>

// [main] Declares everything that the object uses while the scene runs.
void @NAME@::build(const @NAME@Params& params, Builder& builder) {
  const double inertia = 0.4 * params.mass * params.radius * params.radius;  // solid sphere, kg m2
  ball_ = builder.dynamic_body("ball", {params.mass, {inertia, inertia, inertia}});
  builder.sphere(ball_, {0, 0, 0}, params.radius);
  builder.state<State>();
  stretch_ = builder.signal("spring.stretch", "m", "Distance from the rest place.");
}

// [rt] Adds the force of the spring; the host adds gravity and contacts. The force is implicit, taken at the end of the step:
// f = -k (x + h v') - c v' with v' = v + h f / m. It is stable for any stiffness and any mass.
void @NAME@::forces(const swage::Step& step) {
  const double h = step.dt(), c = params().damping + h * params().stiffness;
  const Eigen::Vector3d x = swage::vec(step.pose(ball_).p) - swage::vec(step.state<State>().rest);
  const Eigen::Vector3d v = swage::vec(step.twist(ball_).v);
  const Eigen::Vector3d f = -(params().stiffness * x + c * v) / (1 + h * c / params().mass);
  step.add_force(ball_, swage::abi(f));
}

// [rt] Called after the host has moved the ball.
void @NAME@::finish(const swage::Step& step) {
  step.signal(stretch_, (swage::vec(step.pose(ball_).p) - swage::vec(step.state<State>().rest)).norm());
}

// [rt] Called before the first step and at each restart of the attempt; the ball is at its start.
void @NAME@::reset(const swage::Step& step) { step.state<State>().rest = step.pose(ball_).p; }

// [rt] What is to be seen beside the shapes: the spring, as a thin line.
void @NAME@::draw(const swage::Step& step, swage::Visuals& out) {
  out.line(step.state<State>().rest, step.pose(ball_).p, 0.1 * params().radius);
}

SWAGE_EXPORT(@NAME@)
