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

void ask(const Asked& asked, snapshot::Snapshot& out) noexcept {
  swage_visual list[snapshot::kMaxVisualsOfOne];
  const uint32_t room = std::min(snapshot::kMaxVisualsOfOne, snapshot::kMaxVisuals - out.n_visual);
  if (asked.table == nullptr || room == 0) return;
  uint32_t n = 0;
  const bool given = host::guarded(asked.instance, host::Call::kDraw, asked.on.step, [&] {
    return asked.table->draw(asked.instance.raw, asked.object, asked.coupling, room, list, &n);
  });
  const auto good = [&](const swage_visual& v) { return host::fault_of(v, asked.on.n_body) == host::VisualFault::kGood; };
  if (!given || n > room || !std::all_of(list, list + n, good)) return;
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
