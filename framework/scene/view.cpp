// SPDX-License-Identifier: Apache-2.0
#include "scene/view.hpp"

namespace swage::scene {

swage_object_step view(World& world, const Slices& s, const swage_input* input) noexcept {
  swage_object_step out{};
  out.struct_size = sizeof(out);
  out.step = world.step;
  out.time_s = world.time();
  out.dt_s = world.dt;
  out.scene_length = world.length;
  out.gravity = world.gravity;
  out.input = input;
  out.X_WB = world.X_WB.data() + s.body.first;
  out.V_WB = world.V_WB.data() + s.body.first;
  out.F_B_W = world.F_B_W.data() + s.body.first;
  out.particle_p_W = world.particle_p_W.data() + 3 * s.particle.first;
  out.particle_v_W = world.particle_v_W.data() + 3 * s.particle.first;
  out.particle_f_W = world.particle_f_W.data() + 3 * s.particle.first;
  out.hinge_angle = world.hinge_angle.data() + s.hinge.first;
  out.hinge_rate = world.hinge_rate.data() + s.hinge.first;
  out.hinge_torque = world.hinge_torque.data() + s.hinge.first;
  out.drive = world.drive.data() + s.hinge.first;
  out.state = world.plugin_state.data() + s.state.first;
  out.signal = world.signal.data() + s.signal.first;
  out.n_body = s.body.count;
  out.n_particle = s.particle.count;
  out.n_hinge = s.hinge.count;
  out.n_state = s.state.count;
  out.n_signal = s.signal.count;
  return out;
}

swage_view view(const World& world, std::span<const swage_object_step> object,
                std::span<const swage_view_event> event) noexcept {
  swage_view out{};
  out.struct_size = sizeof(out);
  out.n_body = static_cast<uint32_t>(world.X_WB.size());
  out.n_particle = static_cast<uint32_t>(world.particle_mass.size());
  out.n_signal = static_cast<uint32_t>(world.signal.size());
  out.step = world.step;
  out.time_s = world.time();
  out.dt_s = world.dt;
  out.X_WB = world.X_WB.data();
  out.V_WB = world.V_WB.data();
  out.particle_p_W = world.particle_p_W.data();
  out.signal = world.signal.data();
  out.event = event.data();
  out.object_step = object.data();
  out.n_event = static_cast<uint32_t>(event.size());
  out.n_object = static_cast<uint32_t>(object.size());
  return out;
}

}  // namespace swage::scene
