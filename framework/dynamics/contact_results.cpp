// SPDX-License-Identifier: Apache-2.0
//
// The end of a contact solve: slows islands that did not converge, writes the results, counts the shortfalls.
#include <algorithm>
#include <cmath>

#include "dynamics/contact_solve.hpp"

namespace swage::dynamics {

using scene::kNone;

namespace {

/// True when the contact's plane is that of a flat face that stands still, and the displacement does not lead over an edge of it.
bool stays_over_face(const scene::World& world, const contact::Contact& c, const contact::Candidate& at, const Vec3& off) noexcept {
  using Kind = contact::Feature::Kind;
  const bool of_b = at.b.kind == Kind::kPlane;
  if (!of_b && at.a.kind != Kind::kPlane) return false;
  const scene::Shape& shape = world.shape[of_b ? c.shape_b : c.shape_a];
  if (shape.kind != SWAGE_SHAPE_CONVEX || world.body[shape.body].motion != SWAGE_MOTION_FIXED) return false;
  const toolkit::Pose X_SW = (toolkit::Pose(world.X_WB[shape.body]) * toolkit::Pose(shape.X_BS)).inverse();
  const Vec3 p = X_SW * c.p_W, way = X_SW.q * off, outward = X_SW.q * Vec3(of_b ? c.n_W : Vec3(-c.n_W));
  constexpr double kSame = 1 - 1e-6;  // cosine between the normals of a face and of its contact
  for (const toolkit::Convex::Face& face : world.convex[shape.convex].face)
    if (face.n.dot(outward) > kSame) return face.covers(p) && face.covers(p + way) && face.covers(p - way);
  return false;
}

}  // namespace

/// Slows an island that did not converge, so that it gains no energy: nothing in it moves faster than its loads can make it
/// in a step, or than twice the fastest of the bodies that push it.
void ContactSolve::clamp_velocity(const contact::ContactSet& contacts,
                                  const IslandWorkspace& island) noexcept {
  double fastest = 0;
  for (uint32_t r = island.first_constraint; r < island.first_constraint + island.constraints; ++r) {
    const uint32_t i = p_.constraint[r].contact;
    const bool tie = p_.constraint[r].tie != nullptr;
    const Vec3& p = tie ? p_.tie_workspace[i].p_W : contacts.contact[i].p_W;
    const Side* const sides[2] = {tie ? &p_.tie_workspace[i].a : &p_.contact[i].a,
                                  tie ? &p_.tie_workspace[i].b : &p_.contact[i].b};
    for (const Side* s : sides) {
      if (s->body == kNone && s->particle == kNone) continue;  // the world
      if (!p_.place.moves(s->block) || p_.place.block(s->block).kind == DofBlock::Kind::kHinge)
        fastest = std::max(fastest, p_.place.speed(*s, p));
    }
  }
  for (const uint32_t m : islands_.members(island)) {
    p_.place.slow_down(m, std::max(2 * fastest, p_.place.gain(m)));
  }
}

void ContactSolve::write_back(Motion& motion, contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < p_.n; ++i) write_contact(contacts.contact[i], p_.contact[i]);
  for (size_t i = p_.n; i < contacts.contact.size(); ++i) {
    contacts.contact[i].bristle_W.setZero();
    contacts.contact[i].f_a_W.setZero();
    contacts.contact[i].slip = 0;
  }
  ties_.write();
  mark_held(motion, contacts);
  p_.place.write_back(p_.solved);
  report_forces(contacts);
  p_.place.flexible().apply_impulses();
}

/// Adds the contact and tie forces on the points of bands, to be reported to their objects; bands move by their unknowns.
void ContactSolve::report_forces(const contact::ContactSet& contacts) noexcept {
  const auto report = [&](const Side& s, const Vec3& f) {
    if (s.point != kNone && p_.place.is_banded(s.block))
      p_.place.flexible().report_force(p_.place.block(s.block).index, s.point, f);
  };
  for (uint32_t i = 0; i < p_.n; ++i)
    report(p_.contact[i].a, contacts.contact[i].f_a_W), report(p_.contact[i].b, -contacts.contact[i].f_a_W);
  for (uint32_t i = 0; i < p_.tie.size(); ++i)
    report(p_.tie_workspace[i].a, p_.tie[i].f_a_W), report(p_.tie_workspace[i].b, -p_.tie[i].f_a_W);
}

void ContactSolve::write_contact(contact::Contact& c, const ContactWorkspace& k) noexcept {
  const bool touches =
      k.active && k.constraint != kNone && p_.first_block(k) != kNone && p_.constraint[k.constraint].f.fn > 0;
  c.slip = 0;
  if (!touches) {
    c.bristle_W.setZero();
    c.f_a_W.setZero();
    return;
  }
  const Constraint& constraint = p_.constraint[k.constraint];
  c.gap = constraint.at.g + constraint.relaxed_gap;

  // the bristle keeps the stretch that friction bears; the rest is slip
  const double stretch = std::sqrt(constraint.at.s1 * constraint.at.s1 + constraint.at.s2 * constraint.at.s2);
  const double most = constraint.limit / constraint.surface.kt;
  const double keep = stretch > most ? most / stretch : 1;
  c.bristle_W = keep * (constraint.at.s1 * constraint.t1 + constraint.at.s2 * constraint.t2);
  c.slip = (1 - keep) * stretch / p_.h;
}

void ContactSolve::mark_held(Motion& motion, const contact::ContactSet& contacts) noexcept {
  std::fill(motion.held_body.begin(), motion.held_body.end(), 0);
  std::fill(motion.held_hinge.begin(), motion.held_hinge.end(), 0);
  std::fill(motion.held_particle.begin(), motion.held_particle.end(), 0);
  for (uint32_t i = 0; i < p_.n; ++i) {
    if (contacts.contact[i].f_a_W.isZero(0)) continue;
    hold(motion, p_.contact[i].a), hold(motion, p_.contact[i].b);
  }
  for (uint32_t i = 0; i < p_.tie.size(); ++i)
    if (!p_.tie[i].f_a_W.isZero(0)) hold(motion, p_.tie_workspace[i].a), hold(motion, p_.tie_workspace[i].b);
}

void ContactSolve::hold(Motion& motion, const Side& side) const noexcept {
  if (side.block == kNone) return;
  const DofBlock& m = p_.place.block(side.block);
  if (m.kind == DofBlock::Kind::kRigid) motion.held_body[m.index] = 1;
  if (m.kind == DofBlock::Kind::kHinge) motion.held_hinge[m.index] = 1;
  if (m.kind == DofBlock::Kind::kParticle) motion.held_particle[m.index] = 1;
}

/// Largest displacement of one side of a chain's contact relative to the other since contacts were detected, in radii of the chain.
/// A contact is a plane: some radii away the surface there is another, unless it is a flat face that stands still, over which
/// a chain may slide as far as that reaches. Displacements that both sides share do not count.
double ContactSolve::strayed(const contact::ContactSet& contacts) const noexcept {
  const auto chain = [&](const Side& s) { return s.point != kNone && p_.place.is_banded(s.block); };
  double most = 0;
  for (uint32_t i = 0; i < p_.n; ++i) {
    const contact::Contact& c = contacts.contact[i];
    const ContactWorkspace& k = p_.contact[i];
    if (k.skipped || !(c.law.stiffness > 0) || (!chain(k.a) && !chain(k.b))) continue;
    double radius = HUGE_VAL;
    for (const Side* s : {&k.a, &k.b})
      if (chain(*s)) radius = std::min(radius, p_.place.radius(*s));
    if (!(radius > 0) || (!k.active && c.gap > 2 * radius)) continue;
    const Vec3 off = p_.place.off_prediction(k.a, c.p_W) - p_.place.off_prediction(k.b, c.p_W);
    double far = off.norm() / radius;
    if (far > most && stays_over_face(p_.place.world(), c, contacts.candidate[i], off)) far = std::abs(c.n_W.dot(off)) / radius;
    most = std::max(most, far);
  }
  return most;
}

/// Counts the shortfalls and the work of this step.
void ContactSolve::count(const contact::ContactSet& contacts, Stats& stats) noexcept {
  p_.health.dropped_contacts += contacts.dropped + (contacts.contact.size() - p_.n);
  for (uint32_t i = 0; i < p_.n; ++i) p_.health.dropped_contacts += p_.contact[i].dropped;
  p_.health.over_budget += solver_.over_budget();
  p_.health.steps = p_.health.total() > 0;
  for (const auto& field : base::kSolverHealthFields) stats.health.*field.count += p_.health.*field.count;
  stats.health.steps += p_.health.steps;
  stats.work += solver_.work();
  stats.most_work = std::max(stats.most_work, solver_.work());
}

}  // namespace swage::dynamics
