// SPDX-License-Identifier: Apache-2.0
#include "step/couplings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/guard.hpp"
#include "scene/view.hpp"
#include "step/limits.hpp"
#include "toolkit/math.hpp"

namespace swage::step {

namespace {

// swaps the two sides
void turn(swage_contact& c) {
  std::swap(c.body_a, c.body_b);
  std::swap(c.shape_a, c.shape_b);
  c.n_W = {-c.n_W.x, -c.n_W.y, -c.n_W.z};
  c.f_a_W = {-c.f_a_W.x, -c.f_a_W.y, -c.f_a_W.z};
}

bool sensible(const swage_contact& c) {
  return std::isfinite(c.friction) && c.friction >= 0 && std::isfinite(c.stiffness) && c.stiffness >= 0 &&
         c.restitution >= 0 && c.restitution <= 1;
}

}  // namespace

Couplings::Couplings(host::Rig& rig, const Objects& objects, Events& events, WriteGuard& writes)
    : rig_(rig), objects_(objects), events_(events), writes_(writes) {
  const uint32_t max_contacts = rig.world.capacity.contacts, max_ties = rig.world.capacity.ties;
  const auto count = static_cast<uint32_t>(rig.couplings.size());
  step_.resize(count);
  context_.resize(count);
  shown_.resize(max_contacts);
  mine_.resize(max_contacts);
  shown_tie_.resize(max_ties);
  ties_of_.resize(count);
  tie_.reserve(max_ties);
  for (uint32_t i = 0; i < count; ++i) {
    const host::CouplingSlot& slot = rig.couplings[i];
    context_[i] = {this, i};
    swage_coupling_step& s = step_[i];
    s.struct_size = sizeof s;
    s.dt_s = rig.world.dt;
    s.a = &objects.view(slot.object_a);
    s.b = &objects.view(slot.object_b);
    s.state = rig.world.plugin_state.data() + slot.state.first;
    s.signal = rig.world.signal.data() + slot.signal.first;
    s.n_state = slot.state.count;
    s.n_signal = slot.signal.count;
    s.host_data = &context_[i];
    s.event = on_event;
  }
}

void Couplings::on_event(const swage_coupling_step* step, uint32_t event, double value) {
  const Context& context = *static_cast<const Context*>(step->host_data);
  const host::CouplingSlot& slot = context.self->rig_.couplings[context.coupling];
  if (event < slot.event.count) context.self->events_.emit(slot.event.first + event, value);
}

// a coupling is released when it is in quarantine, or one of its objects is frozen
bool Couplings::released(uint32_t coupling) const noexcept {
  const host::CouplingSlot& slot = rig_.couplings[coupling];
  return slot.instance->quarantined.load(std::memory_order_relaxed) != 0 || objects_.frozen(slot.object_a) ||
         objects_.frozen(slot.object_b);
}

bool Couplings::released_pair(uint32_t pair) const noexcept {
  for (uint32_t i = 0; i < step_.size(); ++i)
    if (rig_.couplings[i].pair == pair && rig_.couplings[i].coupling->detects && released(i)) return true;
  return false;
}

void Couplings::resolve(contact::ContactSet& contacts) noexcept {
  release(contacts);
  show(contacts);
  for (uint32_t i = 0; i < step_.size(); ++i) call(i, host::Call::kResolve, contacts);
  take_laws(contacts);
}

void Couplings::finish(contact::ContactSet& contacts) noexcept {
  release(contacts);
  show(contacts);
  for (uint32_t i = 0; i < step_.size(); ++i) call(i, host::Call::kFinish, contacts);
}

void Couplings::reset() noexcept {
  for (uint32_t i = 0; i < step_.size(); ++i) reset(i);
}

void Couplings::reset_those_of(uint32_t object) noexcept {
  for (uint32_t i = 0; i < step_.size(); ++i)
    if (rig_.couplings[i].object_a == object || rig_.couplings[i].object_b == object) reset(i);
}

void Couplings::reset(uint32_t coupling) noexcept {
  const host::CouplingSlot& slot = rig_.couplings[coupling];
  std::fill_n(step_[coupling].state, slot.state.count, 0.0);
  std::fill_n(step_[coupling].signal, slot.signal.count, 0.0);
  const swage_coupling_step& step = begin(coupling, {});
  host::guarded(*slot.instance, host::Call::kReset, step.step,
                [&] { slot.coupling->reset(slot.instance->raw, &step); });
}

swage_coupling_step& Couplings::begin(uint32_t coupling, std::span<swage_contact> contacts) noexcept {
  swage_coupling_step& s = step_[coupling];
  s.step = rig_.world.step;
  s.time_s = s.a->time_s;
  s.dt_s = s.a->dt_s;
  s.contact = contacts.data();
  s.n_contact = static_cast<uint32_t>(contacts.size());
  return s;
}

// removes the contacts of released couplings from the set; the others keep their order
void Couplings::release(contact::ContactSet& set) noexcept {
  bool any = false;
  for (uint32_t p = 0; p < set.of_pair.size(); ++p) any |= set.of_pair[p].count > 0 && released_pair(p);
  if (!any) return;
  uint32_t kept = 0;
  for (uint32_t p = 0; p < set.of_pair.size(); ++p) {
    const scene::Range from = set.of_pair[p];
    const bool gone = released_pair(p);
    set.of_pair[p] = {kept, gone ? 0 : from.count};
    for (uint32_t i = 0; !gone && i < from.count; ++i, ++kept) {
      set.contact[kept] = set.contact[from.first + i];
      set.candidate[kept] = set.candidate[from.first + i];
    }
  }
  set.contact.resize(kept);
  set.candidate.resize(kept);
}

void Couplings::show(const contact::ContactSet& set) noexcept {
  const std::size_t n = std::min(set.contact.size(), shown_.size());
  for (std::size_t i = 0; i < n; ++i) {
    const contact::Contact& c = set.contact[i];
    const contact::Pair& pair = rig_.pairs[c.pair];
    const host::ObjectSlot &a = rig_.objects[pair.object_a], &b = rig_.objects[pair.object_b];
    swage_contact& s = shown_[i];
    s.body_a = scene::local(a.body, c.body_a);
    s.shape_a = scene::local(a.shape, c.shape_a);
    s.body_b = scene::local(b.body, c.body_b);
    s.shape_b = scene::local(b.shape, c.shape_b);
    s.feature = c.feature;
    s.p_W = toolkit::raw(c.p_W);
    s.n_W = toolkit::raw(c.n_W);
    s.gap = c.gap;
    s.f_a_W = toolkit::raw(c.f_a_W);
    s.slip = c.slip;
    s.friction = c.law.friction;
    s.stiffness = c.law.stiffness;
    s.restitution = c.law.restitution;
  }
}

void Couplings::take_laws(contact::ContactSet& set) noexcept {
  const std::size_t n = std::min(set.contact.size(), shown_.size());
  for (std::size_t i = 0; i < n; ++i) {
    const swage_contact& s = shown_[i];
    set.contact[i].law = {s.friction, s.stiffness, s.restitution};
  }
}

// copies the contacts of a coupling's pair, as seen from its own side
std::span<swage_contact> Couplings::mine(uint32_t coupling, const scene::Range& range) noexcept {
  const host::CouplingSlot& slot = rig_.couplings[coupling];
  std::copy_n(shown_.begin() + range.first, range.count, mine_.begin());
  if (range.count > 0 && rig_.pairs[slot.pair].object_a != slot.object_a)
    for (uint32_t i = 0; i < range.count; ++i) turn(mine_[i]);
  return {mine_.data(), range.count};
}

void Couplings::call(uint32_t coupling, host::Call call, const contact::ContactSet& set) noexcept {
  if (released(coupling)) return;
  const host::CouplingSlot& slot = rig_.couplings[coupling];
  host::Instance& instance = *slot.instance;
  const uint64_t now = rig_.world.step;
  const scene::Range range = slot.pair < set.of_pair.size() ? set.of_pair[slot.pair] : scene::Range{};
  const std::span<swage_contact> contacts = mine(coupling, range);
  const swage_coupling_step& step = begin(coupling, contacts);
  const bool resolving = call == host::Call::kResolve;
  const bool given = host::guarded(instance, call, now, [&] {
    return resolving ? slot.coupling->resolve(instance.raw, &step)
                     : slot.coupling->finish(instance.raw, &step);
  });
  writes_.check(instance, call);

  // only the law may change, only before the solve, and only to valid numbers
  if (!host::accept(instance, call, now, step.signal, step.n_signal, kAnyNumber))
    std::fill_n(step.signal, step.n_signal, 0.0);
  if (!host::accept(instance, call, now, step.state, step.n_state, kAnyNumber))
    std::fill_n(step.state, step.n_state, 0.0);
  if (!given || !resolving) return;
  if (!std::all_of(contacts.begin(), contacts.end(), sensible)) {
    host::quarantine(instance, host::FaultKind::kNotFinite, call, now);
    return;
  }
  for (uint32_t i = 0; i < range.count; ++i) {
    shown_[range.first + i].friction = contacts[i].friction;
    shown_[range.first + i].stiffness = contacts[i].stiffness;
    shown_[range.first + i].restitution = contacts[i].restitution;
  }
}

}  // namespace swage::step
