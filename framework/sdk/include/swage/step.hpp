// SPDX-License-Identifier: Apache-2.0
//
// View of one object in a step: the host's arrays with names and checked indices. [rt]
#pragma once

#include <swage/abi/object.h>
#include <swage/common.hpp>

#include <cassert>
#include <span>

namespace swage {

/// The shape of a chain of n vertices (swage_chain) among the private doubles, for its object to write.
struct ChainState {
  std::span<double> p_W, v_W;  // 3 n, m and m/s
  std::span<double> s;         // n, m, arc lengths
  std::span<double> radius;    // n, m, of the piece that begins at each vertex; 0: none
  static constexpr uint32_t doubles(uint32_t n_vertex) { return 8 * n_vertex; }
};

/// View of a swage_object_step; `step->time_s` reaches the plain struct, the functions below its arrays.
class Step {
 public:
  explicit Step(const swage_object_step* raw) : raw_(raw) {}
  const swage_object_step* operator->() const { return raw_; }
  const swage_object_step* raw() const { return raw_; }

  double time() const { return raw_->time_s; }                // s
  double dt() const { return raw_->dt_s; }                    // s
  double scene_length() const { return raw_->scene_length; }  // m, tolerances are relative to it
  swage_vec3 gravity() const { return raw_->gravity; }        // m/s2
  /// Values of the bound device, or nullptr.
  const swage_input* input() const { return raw_->input; }

  /// X_WB. Writable for flexible bodies, in the calls of Solver only.
  swage_pose& pose(Body body) const { return raw_->X_WB[checked(body, raw_->n_body)]; }
  swage_twist& twist(Body body) const { return raw_->V_WB[checked(body, raw_->n_body)]; }
  swage_wrench& wrench(Body body) const { return raw_->F_B_W[checked(body, raw_->n_body)]; }

  /// Adds a force [N, in W] through the origin of a body. In forces().
  void add_force(Body body, swage_vec3 f_W) const { add(wrench(body).f, f_W); }
  /// Adds a torque [N m, in W]. In forces().
  void add_torque(Body body, swage_vec3 t_W) const { add(wrench(body).t, t_W); }

  /// Particle i of a run, 3 doubles.
  double* particle_position(Particles first, uint32_t i) const {
    return raw_->particle_p_W + particle(first, i);
  }
  double* particle_velocity(Particles first, uint32_t i) const {
    return raw_->particle_v_W + particle(first, i);
  }
  double* particle_force(Particles first, uint32_t i) const {
    return raw_->particle_f_W + particle(first, i);
  }

  double hinge_angle(Hinge hinge) const { return raw_->hinge_angle[checked(hinge, raw_->n_hinge)]; }  // rad
  double hinge_rate(Hinge hinge) const { return raw_->hinge_rate[checked(hinge, raw_->n_hinge)]; }    // rad/s
  double hinge_torque(Hinge hinge) const { return raw_->hinge_torque[checked(hinge, raw_->n_hinge)]; }  // N m
  /// Drive of a hinge, written in forces().
  swage_drive& drive(Hinge hinge) const { return raw_->drive[checked(hinge, raw_->n_hinge)]; }

  /// Writes a signal; in finish().
  void signal(Signal signal, double value) const { raw_->signal[checked(signal, raw_->n_signal)] = value; }

  /// The private numbers, as declared with builder.state<T>().
  template <class T>
  T& state() const {
    assert(sizeof(T) <= raw_->n_state * sizeof(double));
    return *static_cast<T*>(static_cast<void*>(raw_->state));
  }
  std::span<double> state() const { return {raw_->state, raw_->n_state}; }
  /// The chain whose declaration named `first` among the private doubles.
  ChainState chain(uint32_t first, uint32_t n_vertex) const {
    assert(first + ChainState::doubles(n_vertex) <= raw_->n_state);
    const size_t n = n_vertex;
    double* at = raw_->state + first;
    return {{at, 3 * n}, {at + 3 * n, 3 * n}, {at + 6 * n, n}, {at + 7 * n, n}};
  }

 private:
  static uint32_t checked(uint32_t index, [[maybe_unused]] uint32_t count) {
    assert(index < count);
    return index;
  }
  size_t particle(Particles first, uint32_t i) const {
    return 3 * size_t{checked(first + i, raw_->n_particle)};
  }
  static void add(swage_vec3& sum, swage_vec3 a) {
    sum.x += a.x;
    sum.y += a.y;
    sum.z += a.z;
  }

  const swage_object_step* raw_;
};

}  // namespace swage
