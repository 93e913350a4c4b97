// SPDX-License-Identifier: Apache-2.0
#include "@FILE@.hpp"

#include <swage/eigen.hpp>

// [main] everything the object will ever own
void @NAME@::build(const @NAME@Params& params, Builder& builder) {
  const double inertia = 0.4 * params.mass * params.radius * params.radius;  // solid sphere, kg m2
  ball_ = builder.dynamic_body("ball", {params.mass, {inertia, inertia, inertia}});
  builder.sphere(ball_, {0, 0, 0}, params.radius);
  builder.state<State>();
  stretch_ = builder.signal("spring.stretch", "m", "Distance from the rest place.");
}

// [rt] the host adds gravity and contacts itself. The spring counts where the step ends, f = -k (x + h v') - c v' with
// v' = v + h f / m: so it stays calm however stiff it is and however light the ball
void @NAME@::forces(const swage::Step& step) {
  const double h = step.dt(), c = params().damping + h * params().stiffness;
  const Eigen::Vector3d x = swage::vec(step.pose(ball_).p) - swage::vec(step.state<State>().rest);
  const Eigen::Vector3d v = swage::vec(step.twist(ball_).v);
  const Eigen::Vector3d f = -(params().stiffness * x + c * v) / (1 + h * c / params().mass);
  step.add_force(ball_, swage::abi(f));
}

// [rt] after the host has moved the ball
void @NAME@::finish(const swage::Step& step) {
  step.signal(stretch_, (swage::vec(step.pose(ball_).p) - swage::vec(step.state<State>().rest)).norm());
}

// [rt] before the first step and whenever the trainee starts again; the ball is back at its start
void @NAME@::reset(const swage::Step& step) { step.state<State>().rest = step.pose(ball_).p; }

SWAGE_EXPORT(@NAME@)
