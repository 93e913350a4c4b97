// SPDX-License-Identifier: Apache-2.0
//
// The state of an engine: saving, hashing and snapshots.
#include <algorithm>

#include "step/step.hpp"
#include "step/visuals.hpp"
#include "toolkit/math.hpp"
#include "toolkit/mirror.hpp"

namespace swage::step {

// state that the next step depends on and that the hash of a step covers; the memory of the judge has no influence on the motion
void Engine::write_state(scene::Writer& out) const noexcept {
  scene::save(rig_.world, out);
  dynamics_.save(out);
  detector_.save(contacts_, out);
}

void Engine::rehash() noexcept {
  scene::Writer counted;
  write_state(counted);
  hash_ = counted.hash();
}

bool Engine::read_state(scene::Reader& in) noexcept {
  return scene::restore(rig_.world, in) && dynamics_.restore(in) && detector_.restore(contacts_, in);
}

// largest size of an image: the number of contacts varies
std::size_t Engine::image_size() const {
  scene::Writer dynamics;
  dynamics_.save(dynamics);
  return scene::image_size(rig_.world) + dynamics.size() + detector_.image_size() + hands_.image_size() +
         judging_.image_size() + sizeof told_short_;
}

bool Engine::save(std::span<std::byte> out) const noexcept {
  scene::Writer writer(out);
  write_state(writer);
  hands_.save(writer);
  judging_.save(writer);
  writer.put(told_short_);
  return writer.ok();
}

bool Engine::restore(std::span<const std::byte> in) noexcept {
  scene::Reader reader(in);
  if (!read_state(reader) || !hands_.restore(reader) || !judging_.restore(reader)) return false;
  reader.get(told_short_);
  rehash();
  objects_.begin();
  events_.clear();
  return true;
}

uint64_t Engine::object_hash(uint32_t object) const noexcept {
  const host::ObjectSlot& slot = rig_.objects[object];
  const scene::World& w = rig_.world;
  scene::Writer hash;
  const auto put = [&](const auto& array, const scene::Range& range, std::size_t width) {
    hash.put_bytes(array.data() + width * range.first, width * range.count * sizeof(array[0]));
  };
  put(w.X_WB, slot.body, 1);
  put(w.V_WB, slot.body, 1);
  put(w.particle_p_W, slot.particle, 3);
  put(w.particle_v_W, slot.particle, 3);
  put(w.hinge_angle, slot.hinge, 1);
  put(w.hinge_rate, slot.hinge, 1);
  put(w.plugin_state, slot.state, 1);
  put(w.signal, slot.signal, 1);
  return hash.hash();
}

namespace {

// mirrors what is shown of a lesson for the left hand
void mirror(snapshot::Snapshot& out) {
  using toolkit::mirrored;
  for (uint32_t i = 0; i < out.n_body; ++i) out.X_WB[i] = mirrored(out.X_WB[i]);
  for (uint32_t i = 0; i < out.n_particle; ++i) out.particle_p_W[3 * i] *= -1;
  for (uint32_t i = 0; i < out.n_mark; ++i) out.mark_p_W[i] = mirrored(out.mark_p_W[i]);
  for (uint32_t i = 0; i < out.n_device; ++i) out.device[i].X_WD = mirrored(out.device[i].X_WD);
  for (uint32_t i = 0; i < out.n_contact; ++i)
    out.contact[i] = {mirrored(out.contact[i].p_W), mirrored(out.contact[i].f_W)};
  for (uint32_t i = 0; i < out.n_visual; ++i) {
    swage_visual& v = out.visual[i].visual;
    v.a = mirrored(v.a), v.b = mirrored(v.b), v.direction = mirrored(v.direction);
  }
}

}  // namespace

// sizes of all arrays, and the verdict of the lesson
void Engine::fill_head(snapshot::Snapshot& out) const noexcept {
  using namespace snapshot;
  const scene::World& w = rig_.world;
  const judge::Verdict& v = judging_.verdict();
  const auto limit = [](std::size_t n, uint32_t most) {
    return static_cast<uint32_t>(std::min<std::size_t>(n, most));
  };
  out.step = w.step;
  out.time_s = w.time();
  out.hash = hash_;
  out.n_body = limit(w.X_WB.size(), kMaxBodies);
  out.n_particle = limit(w.particle_mass.size(), kMaxParticles);
  for (const scene::ChainInfo& chain : w.chain)  // the vertices of chains follow, as in the scene card
    out.n_particle = limit(out.n_particle + chain.start.size(), kMaxParticles);
  out.n_object = limit(rig_.objects.size(), kMaxObjects);
  out.n_signal = limit(w.signal.size(), kMaxSignals);
  out.n_metric = limit(v.metric.size(), kMaxMetrics);
  out.n_mark = limit(v.mark_cue.size(), kMaxMarks);
  out.n_device = limit(rig_.devices.size(), kMaxDevices);
  out.n_contact = limit(contacts_.contact.size(), kMaxContacts);
  out.outcome = static_cast<uint32_t>(v.outcome);
  out.reason = v.reason;
  out.phase = v.phase;
  out.score = v.score;
}

void Engine::fill(snapshot::Snapshot& out) const noexcept {
  // the first picture is taken on [main], before the step thread lives; the plugins it asks are between steps all the same
  const host::ScopedRole rt(SWAGE_THREAD_RT);
  const scene::World& w = rig_.world;
  const judge::Verdict& v = judging_.verdict();
  fill_head(out);
  std::copy_n(w.X_WB.begin(), out.n_body, out.X_WB);
  const auto particles = static_cast<uint32_t>(w.particle_mass.size());
  std::copy_n(w.particle_p_W.begin(), 3 * std::min(particles, out.n_particle), out.particle_p_W);
  uint32_t next = particles;
  for (const scene::ChainInfo& chain : w.chain) {
    const uint32_t n = std::min(static_cast<uint32_t>(chain.start.size()), out.n_particle - std::min(next, out.n_particle));
    std::copy_n(w.plugin_state.begin() + chain.state, 3 * n, out.particle_p_W + 3 * next);
    next += n;
  }
  std::copy_n(v.object_cue.begin(), out.n_object, out.object_cue);
  std::copy_n(w.signal.begin(), out.n_signal, out.signal);
  std::copy_n(v.metric.begin(), out.n_metric, out.metric);
  std::copy_n(v.mark_cue.begin(), out.n_mark, out.mark_cue);
  std::copy_n(v.mark_p_W.begin(), out.n_mark, out.mark_p_W);
  for (uint32_t i = 0; i < out.n_object; ++i) out.object_quarantined[i] = objects_.frozen(i);
  for (uint32_t i = 0; i < out.n_device; ++i) {
    const swage_sample& s = hands_.samples()[i];
    out.device[i].X_WD = hands_.hands()[i];
    out.device[i].closure = s.closure;
    out.device[i].grip_force = s.grip_force;
    out.device[i].valid = s.valid;
  }
  for (uint32_t i = 0; i < out.n_contact; ++i) {
    const contact::Contact& c = contacts_.contact[i];
    out.contact[i] = {toolkit::raw(c.p_W), toolkit::raw(c.f_a_W)};
  }
  fill_visuals(rig_, objects_, couplings_, out);
  if (rig_.mirror) mirror(out);
}

}  // namespace swage::step
