// SPDX-License-Identifier: Apache-2.0
#include "step/visuals.hpp"

#include <algorithm>

#include "host/guard.hpp"
#include "host/visuals.hpp"
#include "toolkit/math.hpp"

namespace swage::step {

namespace {

swage_visual in_world(const swage_visual& v, const swage_pose* X_WB) noexcept {
  if (v.body == SWAGE_NONE) return v;
  const toolkit::Pose X(X_WB[v.body]);
  swage_visual out = v;
  out.a = toolkit::raw(X * toolkit::vec(v.a));
  out.b = toolkit::raw(X * toolkit::vec(v.b));
  out.direction = toolkit::raw(toolkit::rotated(X.q, toolkit::vec(v.direction)));
  return out;
}

/// Who draws, on what.
struct Asked {
  host::Instance& instance;
  const swage_visuals* table;
  const swage_object_step* object;      // of an object, else nullptr
  const swage_coupling_step* coupling;  // of a coupling, else nullptr
  const swage_object_step& on;
  uint32_t on_object, by_coupling;
};

// counts a list that is left out; the first is remembered
void leave_out(const Asked& asked, uint32_t index, uint32_t kind, base::VisualMember member, base::DrawingHealth& health) noexcept {
  if (health.faulty++ > 0) return;
  health.object = asked.on_object;
  health.coupling = asked.by_coupling;
  health.index = index;
  health.kind = kind;
  health.member = static_cast<uint32_t>(member);
}

void ask(const Asked& asked, snapshot::Snapshot& out) noexcept {
  // one place more than is drawn: a list that fills it is longer than what is drawn of it
  swage_visual list[snapshot::kMaxVisualsOfOne + 1];
  const uint32_t room = std::min(snapshot::kMaxVisualsOfOne, snapshot::kMaxVisuals - out.n_visual);
  if (asked.table == nullptr) return;
  uint32_t n = 0;
  const bool given = host::guarded(asked.instance, host::Call::kDraw, asked.on.step, [&] {
    return asked.table->draw(asked.instance.raw, asked.object, asked.coupling, room + 1, list, &n);
  });
  if (!given) return;
  base::DrawingHealth& health = out.health.visuals;
  if (n > room + 1) return leave_out(asked, room + 1, 0, base::VisualMember::kLength, health);
  for (uint32_t k = 0; k < n; ++k)
    if (const host::VisualFlaw flaw = host::flaw_of(list[k], asked.on.n_body); !flaw.good())
      return leave_out(asked, k, list[k].kind, flaw.member, health);
  health.cut += n > room;
  n = std::min(n, room);
  for (uint32_t k = 0; k < n; ++k) out.visual[out.n_visual++] = {in_world(list[k], asked.on.X_WB), asked.on_object, asked.by_coupling};
}

}  // namespace

void fill_visuals(const host::Rig& rig, const Objects& objects, const Couplings& couplings, snapshot::Snapshot& out) noexcept {
  out.n_visual = 0;
  for (uint32_t i = 0; i < out.n_object; ++i) {
    const swage_object_step& view = objects.view(i);
    ask({*rig.objects[i].instance, rig.objects[i].visuals, &view, nullptr, view, i, scene::kNone}, out);
  }
  for (uint32_t i = 0; i < rig.couplings.size(); ++i) {
    const host::CouplingSlot& slot = rig.couplings[i];
    if (const swage_coupling_step* step = couplings.shown(i); step != nullptr)
      ask({*slot.instance, slot.visuals, nullptr, step, objects.view(slot.object_b), slot.object_b, i}, out);
  }
}

}  // namespace swage::step
