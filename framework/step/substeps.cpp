// SPDX-License-Identifier: Apache-2.0
//
// A step undone and repeated in parts (division.hpp).
#include "dynamics/rotation.hpp"
#include "step/division.hpp"
#include "step/step.hpp"

namespace swage::step {

using toolkit::Pose;
using toolkit::vec;

/// A step of World::dt that ends `rest` [s] before the end of the whole step; `level`: how often that was divided.
void Engine::move(double rest, std::size_t level) noexcept {
  if (level < begun_.size()) begin(begun_[level]);
  chains_.begin();
  free_motion();
  detect();
  chains_.keep();
  couple();
  solve();
  if (level >= begun_.size() || !fell_short(dynamics_.stats(), begun_[level].health, level, chains_, contacts_)) return;

  take_back(begun_[level]);
  ++divided_;
  scene::World& world = rig_.world;
  if (level == 0) X_end_ = world.X_WB;
  const double h = world.dt;
  world.dt = h / kParts;
  for (int left = kParts - 1; left >= 0; --left) {
    const double then = rest + left * world.dt;
    follow_to(then);
    host::renew_budgets(rig_);
    objects_.begin();
    move(then, level + 1);
  }
  world.dt = h;
  host::renew_budgets(rig_);
  objects_.begin();
}

void Engine::begin(Begun& begun) noexcept {
  scene::Writer out(begun.state);
  write_state(out);
  begun.health = dynamics_.stats().health;
  begun.events = events_.count();
}

void Engine::take_back(const Begun& begun) noexcept {
  scene::Reader in(begun.state);
  read_state(in);
  dynamics_.take_back(begun.health);
  events_.keep_first(begun.events);
}

/// Moves bodies that follow to where they are `rest` [s] before the end of the whole step.
void Engine::follow_to(double rest) noexcept {
  scene::World& world = rig_.world;
  for (uint32_t b = 0; b < world.body.size(); ++b) {
    if (world.body[b].motion != SWAGE_MOTION_FOLLOWS) continue;
    const Pose X(X_end_[b]);
    const swage_twist& V = world.V_WB[b];
    world.X_WB[b] = rest > 0 ? Pose(X.p - rest * vec(V.v), dynamics::turn(-rest * vec(V.w)) * X.q).abi() : X_end_[b];
  }
}

}  // namespace swage::step
