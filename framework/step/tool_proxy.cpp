// SPDX-License-Identifier: Apache-2.0
#include "step/tool_proxy.hpp"

#include <algorithm>
#include <cmath>

namespace swage::step {

using toolkit::Pose;
using toolkit::Vec3;

namespace {

// Lengths of the scene that any point of a tool moves between two tests for overlaps. Normal: 0.05 (a hand at 50 mm/s).
// A tool could pass through solids thinner than twice this; smaller costs time when the hand jumps
constexpr double kPart = 0.1;
// Most parts of a step. If a hand jumps farther, the parts grow
constexpr int kMostParts = 16;
// Lengths of the scene by which a tool may overlap a solid after it was pushed out: far below what is seen or felt
constexpr double kLeft = 1e-6;
// Rounds of pushing out. A corner between floor and rim takes 2 or 3
constexpr int kRounds = 12;

bool collides(const scene::Shape& s) { return (s.flags & SWAGE_SHAPE_COLLIDES) != 0; }

}  // namespace

ToolProxy::ToolProxy(const host::Rig& rig) : world_(rig.world), solid_(rig.world.shape.size()) {
  const auto led = [&](uint32_t object) {
    return object < rig.objects.size() && rig.objects[object].follow.pose_device != host::kNone;
  };
  const auto add = [&](uint32_t tool_object, uint32_t fixed_object) {
    for (uint32_t t = 0; t < world_.shape.size(); ++t)
      for (uint32_t f = 0; f < world_.shape.size(); ++f) {
        const scene::Shape &tool = world_.shape[t], &fixed = world_.shape[f];
        if (tool.object != tool_object || fixed.object != fixed_object) continue;
        if (!collides(tool) || !collides(fixed) || world_.body[fixed.body].motion != SWAGE_MOTION_FIXED)
          continue;
        stop_.push_back({tool_object, t, f, {}});
        for (const uint32_t shape : {t, f})
          if (solid_[shape].bound == 0) solid_[shape] = contact::make_solid(world_, shape);
      }
  };
  for (const contact::Pair& pair : rig.pairs) {
    if (led(pair.object_a)) add(pair.object_a, pair.object_b);
    if (led(pair.object_b)) add(pair.object_b, pair.object_a);
  }
}

Pose ToolProxy::rest(uint32_t object, const Pose& X_from, const Pose& X_to) noexcept {
  const double arm = reach(object, X_from);
  if (arm <= 0) return X_to;
  const Vec3 way = X_to.p - X_from.p, turn = toolkit::log_rotation(X_to.q * X_from.q.conjugate());
  const double parts = std::ceil((way.norm() + arm * turn.norm()) / (kPart * world_.length));
  const int n = static_cast<int>(std::clamp(parts, 1.0, static_cast<double>(kMostParts)));

  // each part moves on from where the last one came to rest, so that the tool slides
  Pose X = X_from;
  for (int i = 1; i <= n; ++i) {
    const Vec3 p = X.p + (X_to.p - X.p) / (n - i + 1);
    Pose next(p, i == n
                     ? X_to.q
                     : (toolkit::exp_rotation(turn * (static_cast<double>(i) / n)) * X_from.q).normalized());
    if (i == n) next.p = X_to.p;
    if (!push_out(object, X_from, next)) return X;
    X = next;
  }
  return X;
}

/// Moves X_WT along the normals of its shapes' overlaps until there are none. False: it cannot be done.
bool ToolProxy::push_out(uint32_t object, const Pose& X_from, Pose& X_WT) noexcept {
  contact::Query query;
  query.length = world_.length;
  const Pose undo = X_from.inverse();
  for (int round = 0; round < kRounds; ++round) {
    double deepest = 0;
    for (Stop& s : stop_) {
      if (s.object != object) continue;
      const Pose X_TB = undo * Pose(world_.X_WB[world_.shape[s.tool].body]);
      const contact::Frame X_WB(X_WT * X_TB), X_WF(world_.X_WB[world_.shape[s.fixed].body]);
      contact::collide(solid_[s.tool], X_WB, solid_[s.fixed], X_WF, query, s.memory, found_);
      const contact::Candidate* most = nullptr;
      for (int i = 0; i < found_.count; ++i) {
        const contact::Candidate& c = found_.candidate[static_cast<size_t>(i)];
        if (most == nullptr || c.touch.gap < most->touch.gap) most = &c;
      }
      if (most == nullptr || !(most->touch.gap < -kLeft * world_.length)) continue;
      deepest = std::max(deepest, -most->touch.gap);
      X_WT.p -= most->touch.gap * most->touch.n_W;
    }
    if (deepest == 0) return true;
  }
  return false;
}

/// Largest distance from the tool's frame of the shapes that can be stopped [m].
double ToolProxy::reach(uint32_t object, const Pose& X_from) const noexcept {
  double most = 0;
  for (const Stop& s : stop_) {
    if (s.object != object) continue;
    const contact::Solid& solid = solid_[s.tool];
    const Vec3 centre = Pose(world_.X_WB[world_.shape[s.tool].body]) * solid.centre;
    most = std::max(most, (centre - X_from.p).norm() + solid.bound);
  }
  return most;
}

}  // namespace swage::step
