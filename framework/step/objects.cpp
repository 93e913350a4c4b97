// SPDX-License-Identifier: Apache-2.0
#include "step/objects.hpp"

#include <algorithm>

#include "host/guard.hpp"
#include "scene/chain.hpp"
#include "scene/kinematics.hpp"
#include "scene/room.hpp"
#include "scene/view.hpp"
#include "step/limits.hpp"

namespace swage::step {

namespace {

scene::Slices slices(const host::ObjectSlot& slot) {
  return {slot.body, slot.particle, slot.shape, slot.hinge, slot.state, slot.signal};
}

template <class T>
const double* numbers(const T* first) {
  return reinterpret_cast<const double*>(first);
}

// copies the part of an array that belongs to a range; `width` entries per index
template <class T>
void copy(std::vector<T>& to, const std::vector<T>& from, const scene::Range& range,
          uint32_t width = 1) noexcept {
  const std::size_t first = std::size_t{width} * range.first, count = std::size_t{width} * range.count;
  std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(first), count,
              to.begin() + static_cast<std::ptrdiff_t>(first));
}
template <class T>
void clear(std::vector<T>& array, const scene::Range& range, uint32_t width = 1) noexcept {
  const std::size_t first = std::size_t{width} * range.first, count = std::size_t{width} * range.count;
  std::fill_n(array.begin() + static_cast<std::ptrdiff_t>(first), count, T{});
}

// whether one of these bodies is moved by its object; an object without any is no flexible body
bool moves_itself(const scene::World& world, const scene::Range& body) {
  for (uint32_t b = body.first; b < body.first + body.count; ++b)
    if (world.body[b].motion == SWAGE_MOTION_FLEXIBLE) return true;
  return false;
}

}  // namespace

template <class F>
void Objects::for_chains(const host::ObjectSlot& slot, const F& each) noexcept {
  for (uint32_t i = slot.shape.first; i < slot.shape.first + slot.shape.count; ++i)
    if (rig_.world.shape[i].kind == SWAGE_SHAPE_CHAIN) each(rig_.world.shape[i]);
}

/// Checks the private doubles of chains: places, velocities, arc lengths and radii, one after the other (scene/chain.hpp).
template <class Accept>
bool Objects::sound_chains(uint32_t object, const Accept& accept) noexcept {
  bool all = true;
  for_chains(rig_.objects[object], [&](const scene::Shape& shape) {
    const scene::ChainInfo& info = rig_.world.chain[shape.chain];
    const std::size_t n = info.start.size();
    const double* at = rig_.world.plugin_state.data() + info.state;
    all = all && accept(at, 3 * n, kMaxPosition) && accept(at + 3 * n, 3 * n, kAnyNumber) &&
          accept(at + 6 * n, 2 * n, kMaxPosition);
  });
  return all;
}

Objects::Objects(host::Rig& rig, const Hands& hands, WriteGuard& writes)
    : rig_(rig), hands_(hands), writes_(writes) {
  scene::World& world = rig.world;
  particle_start_ = world.particle_p_W;
  random_start_ = world.random;
  scene::reset(world);
  X_WB_before_ = world.X_WB;
  particle_before_ = world.particle_p_W;
  hinge_before_ = world.hinge_angle;
  for (const scene::ChainInfo& chain : world.chain)
    chain_before_.emplace_back(scene::chain_doubles(static_cast<uint32_t>(chain.start.size())));
  keep_chains();
  view_.resize(rig.objects.size());
  gone_.resize(rig.objects.size());
  for (uint32_t i = 0; i < rig.objects.size(); ++i) {
    host::ObjectSlot& slot = rig.objects[i];
    view_[i] = scene::view(world, slices(slot), hands.input(i));
    if (slot.moves_itself() && moves_itself(world, slot.body))
      self_.push_back(std::make_unique<FlexibleBodyAdapter>(slot, i, view_[i], world));
  }
  self_now_.reserve(self_.size());
}

void Objects::reset() noexcept {
  scene::World& world = rig_.world;
  scene::reset(world);
  world.particle_p_W = particle_start_;
  world.random = random_start_;
  begin();
  for (uint32_t i = 0; i < view_.size(); ++i) {
    const host::ObjectSlot& slot = rig_.objects[i];
    host::guarded(*slot.instance, host::Call::kReset, 0,
                  [&] { slot.object->reset(slot.instance->raw, &view_[i]); });
  }
  begin();
}

void Objects::reset(uint32_t object) noexcept {
  const host::ObjectSlot& slot = rig_.objects[object];
  scene::World& world = rig_.world;
  for (uint32_t b = slot.body.first; b < slot.body.first + slot.body.count; ++b) {
    world.X_WB[b] = world.body[b].start;
    world.V_WB[b] = {};
  }
  for (uint32_t h = slot.hinge.first; h < slot.hinge.first + slot.hinge.count; ++h) {
    const scene::HingeInfo& hinge = world.hinge[h];
    world.X_WB[hinge.child] = scene::hinged(hinge, toolkit::Pose(world.X_WB[hinge.parent]), 0.0).abi();
  }
  copy(world.particle_p_W, particle_start_, slot.particle, 3);
  clear(world.particle_v_W, slot.particle, 3);
  clear(world.hinge_angle, slot.hinge);
  clear(world.hinge_rate, slot.hinge);
  clear(world.hinge_torque, slot.hinge);
  clear(world.plugin_state, slot.state);
  clear(world.signal, slot.signal);
  for_chains(slot, [&](const scene::Shape& shape) { scene::place_chain(world, shape); });
  host::guarded(*slot.instance, host::Call::kReset, world.step,
                [&] { slot.object->reset(slot.instance->raw, &view_[object]); });
  begin();
}

void Objects::begin() noexcept {
  scene::World& world = rig_.world;
  for (uint32_t i = 0; i < view_.size(); ++i) {
    view_[i] = scene::view(world, slices(rig_.objects[i]), hands_.input(i));
    view_[i].time_s = static_cast<double>(world.step) * dt_;  // also in a part of a step
    gone_[i] = left_room(i) ? 1 : 0;
  }
  X_WB_before_ = world.X_WB;
  particle_before_ = world.particle_p_W;
  hinge_before_ = world.hinge_angle;
  keep_chains();
}

void Objects::keep_chains() noexcept {
  for (std::size_t i = 0; i < chain_before_.size(); ++i)
    std::copy_n(rig_.world.plugin_state.data() + rig_.world.chain[i].state, chain_before_[i].size(),
                chain_before_[i].begin());
}

void Objects::forces() noexcept {
  scene::World& world = rig_.world;
  for (uint32_t i = 0; i < view_.size(); ++i) {
    const host::ObjectSlot& slot = rig_.objects[i];
    const swage_object_step& view = view_[i];
    host::Instance& instance = *slot.instance;
    const auto accept = [&](const double* data, std::size_t n, double limit) {
      return host::accept(instance, host::Call::kForces, world.step, data, n, limit);
    };
    const bool given = host::guarded(instance, host::Call::kForces, world.step,
                                     [&] { return slot.object->forces(instance.raw, &view); });
    writes_.check(instance, host::Call::kForces);
    const bool good = given && accept(numbers(view.F_B_W), 6 * view.n_body, kMaxForce) &&
                      accept(view.particle_f_W, 3 * view.n_particle, kMaxForce) &&
                      accept(numbers(view.drive), 4 * view.n_hinge, kAnyNumber);
    if (good) continue;
    clear(world.F_B_W, slot.body);
    clear(world.particle_f_W, slot.particle, 3);
    clear(world.drive, slot.hinge);
  }
}

void Objects::advance() noexcept {
  for (uint32_t i = 0; i < view_.size(); ++i) {
    const host::ObjectSlot& slot = rig_.objects[i];
    if (!slot.moves_itself() || frozen(i)) continue;
    host::Instance& instance = *slot.instance;
    host::guarded(instance, host::Call::kAdvance, rig_.world.step, [&] {
      return slot.solver_2 != nullptr ? slot.solver_2->advance(instance.raw, &view_[i])
                                      : slot.solver->advance(instance.raw, &view_[i]);
    });
    if (!sound(i, host::Call::kAdvance)) put_back(i);
  }
}

void Objects::finish() noexcept {
  scene::World& world = rig_.world;
  for (uint32_t i = 0; i < view_.size(); ++i) {
    const host::ObjectSlot& slot = rig_.objects[i];
    host::Instance& instance = *slot.instance;
    host::guarded(instance, host::Call::kFinish, world.step,
                  [&] { return slot.object->finish(instance.raw, &view_[i]); });
    writes_.check(instance, host::Call::kFinish);
    const bool whole = host::accept(instance, host::Call::kFinish, world.step, view_[i].signal,
                                    slot.signal.count, kAnyNumber);
    if (!whole) clear(world.signal, slot.signal);
    // the state is saved, hashed and given back to the object: a NaN would stay for ever
    if (!host::accept(instance, host::Call::kFinish, world.step, view_[i].state, slot.state.count, kAnyNumber))
      clear(world.plugin_state, slot.state), put_back_chains(slot);
  }
}

std::span<dynamics::FlexibleBody* const> Objects::self() noexcept {
  self_now_.clear();
  for (const auto& port : self_)
    if (!frozen(port->object())) self_now_.push_back(port.get());
  return self_now_;
}

void Objects::guard() noexcept {
  for (uint32_t i = 0; i < view_.size(); ++i) {
    if (!frozen(i)) sound(i, rig_.objects[i].moves_itself() ? host::Call::kApplyImpulses : host::Call::kForces);
    if (frozen(i)) freeze(i);
  }
}

void Objects::freeze() noexcept {
  for (uint32_t i = 0; i < view_.size(); ++i)
    if (frozen(i)) freeze(i);
}

bool Objects::left_room(uint32_t object) const noexcept {
  const scene::World& world = rig_.world;
  const host::ObjectSlot& slot = rig_.objects[object];
  const double room = scene::room(world);
  for (uint32_t b = slot.body.first; b < slot.body.first + slot.body.count; ++b) {
    const int32_t motion = world.body[b].motion;
    if (motion != SWAGE_MOTION_DYNAMIC && motion != SWAGE_MOTION_FLEXIBLE) continue;
    if (toolkit::vec(world.X_WB[b].p).squaredNorm() > room * room) return true;
  }
  for (uint32_t p = slot.particle.first; p < slot.particle.first + slot.particle.count; ++p)
    if (Eigen::Map<const toolkit::Vec3>(&world.particle_p_W[3 * std::size_t{p}]).squaredNorm() > room * room)
      return true;
  return false;
}

// whether an object's state is finite and near; it is quarantined otherwise
bool Objects::sound(uint32_t object, host::Call call) noexcept {
  host::Instance& instance = *rig_.objects[object].instance;
  const swage_object_step& view = view_[object];
  const auto accept = [&](const double* data, std::size_t n, double limit) {
    return host::accept(instance, call, view.step, data, n, limit);
  };
  return accept(numbers(view.X_WB), 7 * view.n_body, kMaxPosition) &&
         accept(numbers(view.V_WB), 6 * view.n_body, kAnyNumber) &&
         accept(view.particle_p_W, 3 * view.n_particle, kMaxPosition) &&
         accept(view.particle_v_W, 3 * view.n_particle, kAnyNumber) &&
         accept(view.hinge_angle, view.n_hinge, kAnyNumber) &&
         accept(view.hinge_rate, view.n_hinge, kAnyNumber) && sound_chains(object, accept);
}

void Objects::put_back(uint32_t object) noexcept {
  const host::ObjectSlot& slot = rig_.objects[object];
  copy(rig_.world.X_WB, X_WB_before_, slot.body);
  copy(rig_.world.particle_p_W, particle_before_, slot.particle, 3);
  copy(rig_.world.hinge_angle, hinge_before_, slot.hinge);
  put_back_chains(slot);
}

void Objects::put_back_chains(const host::ObjectSlot& slot) noexcept {
  for_chains(slot, [&](const scene::Shape& shape) {
    const scene::ChainInfo& info = rig_.world.chain[shape.chain];
    const std::size_t n = info.start.size();
    double* at = rig_.world.plugin_state.data() + info.state;
    std::copy(chain_before_[shape.chain].begin(), chain_before_[shape.chain].end(), at);
    std::fill_n(at + 3 * n, 3 * n, 0.0);
  });
}

void Objects::freeze(uint32_t object) noexcept {
  const host::ObjectSlot& slot = rig_.objects[object];
  scene::World& world = rig_.world;
  put_back(object);
  clear(world.V_WB, slot.body);
  clear(world.particle_v_W, slot.particle, 3);
  clear(world.hinge_rate, slot.hinge);
  clear(world.hinge_torque, slot.hinge);
}

}  // namespace swage::step
