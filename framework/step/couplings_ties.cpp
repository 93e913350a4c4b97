// SPDX-License-Identifier: Apache-2.0
//
// Ties that couplings make between the bodies of their two objects: requested after resolve, returned solved.
#include <algorithm>
#include <cmath>

#include "host/guard.hpp"
#include "scene/view.hpp"
#include "step/couplings.hpp"
#include "step/limits.hpp"
#include "toolkit/math.hpp"

namespace swage::step {

using scene::kNone;

namespace {

constexpr double kUnit = 1e-6;  // tolerance of an axis' length of 1

bool finite(const swage_vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool stiffness(double k) { return std::isfinite(k) && k >= 0; }

bool sensible(const swage_tie& t, uint32_t bodies_a, uint32_t bodies_b) {
  const auto there = [](uint32_t body, uint32_t count) { return body < count || body == SWAGE_NONE; };
  return there(t.body_a, bodies_a) && there(t.body_b, bodies_b) && finite(t.p_W) && finite(t.offset_W) &&
         finite(t.axis_W) && finite(t.f_a_W) && std::abs(toolkit::vec(t.axis_W).norm() - 1) < kUnit &&
         stiffness(t.stiffness_across) && stiffness(t.stiffness_along) && t.strength >= 0 &&
         t.forward_limit >= 0 && t.backward_limit >= 0 && toolkit::vec(t.p_W).norm() < kMaxPosition;
}

dynamics::Tie tie_of(const swage_tie& t, const scene::Range& a, const scene::Range& b) {
  dynamics::Tie out;
  out.body_a = t.body_a == SWAGE_NONE ? kNone : a.first + t.body_a;
  out.body_b = t.body_b == SWAGE_NONE ? kNone : b.first + t.body_b;
  out.p_W = toolkit::vec(t.p_W);
  out.axis_W = toolkit::vec(t.axis_W).normalized();
  out.offset_W = toolkit::vec(t.offset_W);
  out.f_a_W = toolkit::vec(t.f_a_W);
  out.law = {t.stiffness_across, t.stiffness_along, t.strength, t.forward_limit, t.backward_limit};
  return out;
}

}  // namespace

std::span<dynamics::Tie> Couplings::ties() noexcept {
  tie_.clear();
  for (uint32_t i = 0; i < step_.size(); ++i) {
    ties_of_[i] = {static_cast<uint32_t>(tie_.size()), 0};
    if (rig_.couplings[i].ties != nullptr && !released(i)) ask_ties(i);
  }
  return tie_;
}

void Couplings::ask_ties(uint32_t coupling) noexcept {
  const host::CouplingSlot& slot = rig_.couplings[coupling];
  host::Instance& instance = *slot.instance;
  const uint64_t now = rig_.world.step;
  const auto first = static_cast<uint32_t>(tie_.size());
  const auto room = static_cast<uint32_t>(shown_tie_.size()) - first;
  swage_tie* const shown = shown_tie_.data() + first;
  for (uint32_t i = 0; i < room; ++i) shown[i].f_a_W = {};  // what the coupling does not say is not known
  const swage_coupling_step& step = begin(coupling, {});
  uint32_t n = 0;
  const bool given = host::guarded(instance, host::Call::kTies, now,
                                   [&] { return slot.ties->ties(instance.raw, &step, room, shown, &n); });
  if (!given) return;
  const scene::Range &a = rig_.objects[slot.object_a].body, &b = rig_.objects[slot.object_b].body;
  bool good = n <= room;
  for (uint32_t i = 0; good && i < n; ++i) good = sensible(shown[i], a.count, b.count);
  if (!good) {
    host::quarantine(instance, host::FaultKind::kNotFinite, host::Call::kTies, now);
    return;
  }
  for (uint32_t i = 0; i < n; ++i) tie_.push_back(tie_of(shown[i], a, b));
  ties_of_[coupling].count = n;
}

void Couplings::on_solved() noexcept {
  for (uint32_t i = 0; i < tie_.size(); ++i) {
    shown_tie_[i].axis_W = toolkit::raw(tie_[i].axis_W);
    shown_tie_[i].f_a_W = toolkit::raw(tie_[i].f_a_W);
    shown_tie_[i].plastic_slip_W = toolkit::raw(tie_[i].plastic_slip_W);
  }
  for (uint32_t i = 0; i < step_.size(); ++i) {
    const host::CouplingSlot& slot = rig_.couplings[i];
    if (ties_of_[i].count == 0 || released(i)) continue;
    const swage_coupling_step& step = begin(i, {});
    host::guarded(*slot.instance, host::Call::kOnSolved, rig_.world.step, [&] {
      return slot.ties->on_solved(slot.instance->raw, &step, ties_of_[i].count,
                             shown_tie_.data() + ties_of_[i].first);
    });
  }
}

}  // namespace swage::step
