// SPDX-License-Identifier: Apache-2.0
//
// A step is divided where a chain moves too far in it. Contacts are detected where the chain would advance to, and each is a plane
// for the whole step. A chain that is snatched or springs back leaves the plane, and passes the edge of what it touched, or something that
// was not near. Such a step is undone and repeated in four parts, each of them again in four where that is still too far. A spring moves a
// mass from rest as the square of the time: 0.4 mm in a step become 0.1 um in a sixty-fourth.
#include "dynamics/rotation.hpp"
#include "step/step.hpp"

namespace swage::step {

using toolkit::Pose;
using toolkit::vec;

namespace {

/// Parts of a divided step; kUsual and Engine::kDivisions limit how often. More parts: a step that is too far in one of
/// them alone costs more. Fewer divisions: a snatched thread passes through itself.
constexpr int kParts = 4;

/// How often a step is divided for displacements that may lead to a passage: down to 1/64. Where a chain did pass through itself it is
/// divided further (Engine::kDivisions): a thread of 4e-7 kg/m that bears 20 mN springs by ten of its diameters in 1/64 ms.
constexpr std::size_t kUsual = 3;

/// In radii of a chain: allowed displacement relative to what it is near to since contacts were detected, where that is no flat face that stands
/// still; its own thickness. Smaller: fast sliding costs several times as much. Larger: passages.
constexpr double kFar = 2;

}  // namespace

/// A step of World::dt that ends `rest` [s] before the end of the whole step; `level`: how often that was divided.
void Engine::move(double rest, std::size_t level) noexcept {
  if (level < begun_.size()) begin(begun_[level]);
  chains_.begin();
  free_motion();
  detect();
  chains_.keep();
  couple();
  solve();
  if (level >= begun_.size() || !fell_short(begun_[level], level)) return;

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

/// True when the step was too far for one. If it did not converge it is divided once: where it never does, the cost stays that of five.
bool Engine::fell_short(const Begun& begun, std::size_t level) noexcept {
  const dynamics::Stats& stats = dynamics_.stats();
  if ((level < kUsual && stats.strayed > kFar) || (level == 0 && stats.health.not_converged > begun.health.not_converged)) return true;
  return chains_.passed_itself() || (level < kUsual && chains_.met_unseen(contacts_));
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
