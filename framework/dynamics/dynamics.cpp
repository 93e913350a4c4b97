// SPDX-License-Identifier: Apache-2.0
#include "dynamics/dynamics.hpp"

#include <algorithm>

#include "dynamics/contact_solve.hpp"
#include "dynamics/impulse.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/rebound.hpp"
#include "dynamics/refinement.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

namespace {
constexpr double kTouch = 0.01;  // tolerance of the gap at a touch of the rebound, in tolerances of the solve: 1 pm
}

struct Dynamics::Core {
  Core(const scene::World& world, const Options& chosen)
      : options(chosen),
        motion(world),
        rebound(world, world.capacity.contacts),
        contact_solve(world, chosen),
        refinement(world) {}

  void solve_contacts(scene::World& world, contact::ContactSet& contacts, std::span<FlexibleBody* const> self,
                      std::span<Tie> ties, contact::Detector* detector) noexcept;

  Options options;
  Motion motion;
  Rebound rebound;
  ContactSolve contact_solve;
  Refinement refinement;
  Stats stats;
};

/// Where rigid bodies alone touch, a step that does not converge is repeated in parts.
void Dynamics::Core::solve_contacts(scene::World& world, contact::ContactSet& contacts, std::span<FlexibleBody* const> self,
                                    std::span<Tie> ties, contact::Detector* detector) noexcept {
  const auto flew = [](uint8_t f) { return f != 0; };
  const bool rigid = self.empty() && ties.empty() && world.particle_mass.empty();
  const bool may_refine = detector && rigid && std::none_of(motion.flown.begin(), motion.flown.end(), flew) &&
                          refinement.keep(motion, contacts, stats.health);
  const uint64_t before = stats.health.not_converged;
  contact_solve.solve(world, motion, contacts, ties, self, stats);
  if (may_refine && stats.health.not_converged > before)
    refinement.run(world, motion, contacts, *detector, contact_solve, options, stats);
}

namespace {

/// Adds the torque of contacts and ties on each hinge, about its axis.
void add_hinge_torques(scene::World& world, const contact::ContactSet& contacts, std::span<const Tie> ties) {
  for (uint32_t i = 0; i < world.hinge.size(); ++i) {
    const scene::HingeInfo& info = world.hinge[i];
    const toolkit::Frame X_WP(world.X_WB[info.parent]);
    const Vec3 axis = X_WP.turn(toolkit::vec(info.axis)), anchor = X_WP * toolkit::vec(info.anchor);
    double& torque = world.hinge_torque[i];
    for (const contact::Contact& c : contacts.contact) {
      if (c.body_a == info.child) torque += axis.dot((c.p_W - anchor).cross(c.f_a_W));
      if (c.body_b == info.child) torque -= axis.dot((c.p_W - anchor).cross(c.f_a_W));
    }
    for (const Tie& tie : ties) {
      if (tie.body_a == info.child) torque += axis.dot((tie.p_W - anchor).cross(tie.f_a_W));
      if (tie.body_b == info.child) torque -= axis.dot((tie.p_W - anchor).cross(tie.f_a_W));
    }
  }
}

}  // namespace

Dynamics::Dynamics(const scene::World& world, const Options& options)
    : core_(std::make_unique<Core>(world, options)) {}

Dynamics::~Dynamics() = default;

void Dynamics::free_motion(scene::World& world) noexcept {
  core_->motion.predict(world, core_->options.free_motion);
  ++core_->stats.steps;
}

void Dynamics::solve(scene::World& world, contact::ContactSet& contacts, std::span<FlexibleBody* const> self,
                     std::span<Tie> ties, contact::Detector* detector) noexcept {
  std::fill(world.hinge_torque.begin(), world.hinge_torque.end(), 0.0);
  const Options& options = core_->options;
  const bool compliant = options.response == Response::kCompliant;
  const uint64_t short_steps = core_->stats.health.steps;
  const bool ended = !(compliant && detector) ||
                     core_->rebound.fly(world, core_->motion, contacts, *detector, options.free_motion,
                                        kTouch * options.tolerance * world.length);
  core_->stats.strayed = 0;
  if (contacts.contact.empty() && ties.empty()) {
    core_->motion.go_free(world);
  } else {
    if (compliant)
      core_->solve_contacts(world, contacts, self, ties, detector);
    else
      respond_by_impulses(world, core_->motion, contacts);
    if (compliant && detector) core_->rebound.report(contacts, world.dt);
    add_hinge_torques(world, contacts, ties);
  }
  if (ended) return;
  // the touches of this step did not end within its budget of predictions
  ++core_->stats.health.over_budget;
  core_->stats.health.steps = short_steps + 1;
}

void Dynamics::finish(scene::World& world) noexcept {
  std::fill(world.F_B_W.begin(), world.F_B_W.end(), swage_wrench{});
  std::fill(world.particle_f_W.begin(), world.particle_f_W.end(), 0.0);
}

void Dynamics::take_back(const base::SolverHealth& before) noexcept { core_->stats.health = before; }
void Dynamics::solve_sparse_beyond(uint32_t contacts) noexcept { core_->contact_solve.set_few(contacts); }
const Stats& Dynamics::stats() const noexcept { return core_->stats; }
std::span<const Waypoint> Dynamics::waypoints() const noexcept { return core_->rebound.waypoints(); }
const Options& Dynamics::options() const noexcept { return core_->options; }

void Dynamics::save(scene::Writer& out) const noexcept {
  out.put(core_->motion.held_body);
  out.put(core_->motion.held_hinge);
  out.put(core_->motion.held_particle);
  out.put(core_->motion.stiffer);
}

bool Dynamics::restore(scene::Reader& in) noexcept {
  in.get(core_->motion.held_body);
  in.get(core_->motion.held_hinge);
  in.get(core_->motion.held_particle);
  in.get(core_->motion.stiffer);
  return in.ok();
}

}  // namespace swage::dynamics
