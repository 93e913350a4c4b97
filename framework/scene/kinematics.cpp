// SPDX-License-Identifier: Apache-2.0
#include "scene/kinematics.hpp"

#include "scene/chain.hpp"

#include <algorithm>

namespace swage::scene {

void reset(World& world) {
  const size_t bodies = world.body.size(), particles = world.particle_mass.size(),
               hinges = world.hinge.size();
  world.step = 0;
  world.X_WB.resize(bodies);
  for (size_t i = 0; i < bodies; ++i) world.X_WB[i] = world.body[i].start;
  world.V_WB.assign(bodies, swage_twist{});
  world.F_B_W.assign(bodies, swage_wrench{});
  world.particle_p_W.resize(3 * particles);
  world.particle_v_W.assign(3 * particles, 0.0);
  world.particle_f_W.assign(3 * particles, 0.0);
  world.hinge_angle.assign(hinges, 0.0);
  world.hinge_rate.assign(hinges, 0.0);
  world.hinge_torque.assign(hinges, 0.0);
  world.drive.assign(hinges, swage_drive{});
  std::fill(world.plugin_state.begin(), world.plugin_state.end(), 0.0);
  std::fill(world.signal.begin(), world.signal.end(), 0.0);

  // angle 0 is the declared start pose: a hinge's child follows its parent from the first step on
  for (size_t i = 0; i < hinges; ++i) {
    const HingeInfo& hinge = world.hinge[i];
    world.X_WB[hinge.child] = hinged(hinge, toolkit::Pose(world.X_WB[hinge.parent]), 0.0).abi();
  }
  for (const Shape& shape : world.shape)
    if (shape.kind == SWAGE_SHAPE_CHAIN) place_chain(world, shape);
}

}  // namespace swage::scene
