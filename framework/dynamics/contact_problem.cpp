// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact_problem.hpp"

#include <algorithm>

#include "contact/candidate.hpp"
#include "dynamics/axes.hpp"

namespace swage::dynamics {

using scene::kNone;

namespace {
// Active contacts of strands with strands beyond which threads are wound. Islands of fewer constraints are solved for their forces, where
// each one that bears nothing costs as much as one that does.
constexpr uint32_t kWound = 16;
}  // namespace

ContactProblem::ContactProblem(const scene::World& world) : room(world.capacity), place(world) {
  contact.resize(room.contacts), tie_workspace.resize(room.ties);
  constraint.resize(size_t{room.contacts} + room.ties);
  solved.assign(place.blocks(), 0);
  ranked.reserve(room.contacts);
}

void ContactProblem::begin(scene::World& world, Motion& motion, const contact::ContactSet& contacts,
                           std::span<FlexibleBody* const> self) noexcept {
  h = world.dt;
  health = {};
  place.begin(world, motion, self);
  std::fill(solved.begin(), solved.end(), uint8_t{0});

  n = static_cast<uint32_t>(std::min({contacts.contact.size(), contacts.candidate.size(), contact.size()}));
  for (uint32_t i = 0; i < n; ++i) {
    const contact::Contact& c = contacts.contact[i];
    ContactWorkspace& k = contact[i];
    k.a = place.side(c.body_a, c.particle_a, c.shape_a, c.place_a);
    k.b = place.side(c.body_b, c.particle_b, c.shape_b, c.place_b);
    k.active = takes_part(c, k);
    k.dropped = false;
    k.constraint = kNone;
    k.found = {c.gap, c.p_W, c.n_W};
  }
  expect_touches(contacts);
}

void ContactProblem::expect_touches(const contact::ContactSet& contacts) noexcept {
  const auto strands = [&](const ContactWorkspace& k) { return place.is_banded(k.a.block) && place.is_banded(k.b.block); };
  uint32_t wound = 0;
  for (uint32_t i = 0; i < n; ++i) wound += contact[i].active && strands(contact[i]);
  // beyond kMostBends the projection alone is to converge, which it then does less often
  if (wound <= kWound || wound > IslandSolver::kMostBends) return;
  for (uint32_t i = 0; i < n; ++i) {
    const contact::Contact& c = contacts.contact[i];
    contact[i].active = contact[i].active || (c.gap < scales.soon && c.law.stiffness > 0 && strands(contact[i]));
  }
}

/// True for contacts that overlap, and for those that bore force on a band: without forces, at the predicted poses, they may be open.
bool ContactProblem::takes_part(const contact::Contact& c, const ContactWorkspace& k) const noexcept {
  if (overlaps(c)) return true;
  return k.bore && c.law.stiffness > 0 && (place.is_banded(k.a.block) || place.is_banded(k.b.block));
}

/// The contact at the present poses: axes, law, gap and tangential displacement.
void ContactProblem::linearise(const contact::Contact& c, const ContactWorkspace& k,
                               Constraint& to) noexcept {
  to.n = c.n_W;
  axes_across(to.n, to.t1, to.t2);
  const Vec3 u = place.displacement(k.a, c.p_W) - place.displacement(k.b, c.p_W);
  const double T = retardation(c.law.restitution, scales.retardation);
  to.surface = surface(c.law.stiffness * c.weight, c.law.friction, T, h);
  to.relaxed_gap = relaxed_gap(T, h, c.gap - to.n.dot(u));
  const Vec3 s = carried_bristle(c, k) + u;
  to.at = {c.gap - to.relaxed_gap, to.t1.dot(s), to.t2.dot(s)};
  to.before = force_before(to.surface, to.n.dot(c.f_a_W), to.t1.dot(c.f_a_W), to.t2.dot(c.f_a_W));
}

/// Displacement of a side's material point from its predicted place or, on a flexible body, of the surface from its shape [m].
Vec3 ContactProblem::moved(const Side& side, const Vec3& p_own, const Vec3& p_W) const noexcept {
  if (side.body == kNone) return Vec3::Zero();
  if (side.point != kNone) return off_shape(side, p_W);
  return place.frame(side) * p_own - p_W;
}

/// Linearises a tie at the present poses. Its axis turns with a; its offset across the axis keeps its direction in the world.
void ContactProblem::linearise(const Tie& of, TieWorkspace& k, Constraint& to) noexcept {
  to.n = k.a.body != kNone ? Vec3(place.frame(k.a).R * k.axis_A) : k.axis_A;
  axes_across(to.n, to.t1, to.t2);
  const Vec3 a = moved(k.a, k.p_A, of.p_W), b = moved(k.b, k.p_B, of.p_W);
  const double along = of.axis_W.dot(of.offset_W);
  const Vec3 s = of.offset_W - along * of.axis_W + a - b;
  k.p_W = of.p_W + (place.moves(k.a.block) ? a - s : b);
  to.at = {along + to.n.dot(s), to.t1.dot(s), to.t2.dot(s)};
  to.before = {to.n.dot(of.f_a_W), to.t1.dot(of.f_a_W), to.t2.dot(of.f_a_W)};
}

/// The bristle of the last step, rotated with its surfaces since, in the present tangent plane.
Vec3 ContactProblem::carried_bristle(const contact::Contact& c, const ContactWorkspace& k) const noexcept {
  if (c.bristle_W.isZero(0)) return Vec3::Zero();
  bool has_a, has_b;
  const Vec3 a = place.rotation(k.a, has_a), b = place.rotation(k.b, has_b);
  const Vec3 turn = has_a && has_b ? Vec3(0.5 * (a + b)) : Vec3(a + b);

  // both turns and the tilt of the normal change its direction, not its length
  const Vec3 s = carried(c.bristle_W, turn);
  const Vec3 flat = s - c.n_W.dot(s) * c.n_W;
  const double length = flat.norm();
  return length > 0 ? Vec3(flat * (c.bristle_W.norm() / length)) : Vec3::Zero();
}

/// Gap, place and normal of a contact at the present poses. The shapes of a flexible side stay where it advanced to; the displacement
/// of the surface from them is added to the gap.
void ContactProblem::evaluate(contact::ContactSet& contacts, uint32_t i) noexcept {
  contact::Contact& c = contacts.contact[i];
  const ContactWorkspace& k = contact[i];
  const contact::Touch touch = reevaluate(contacts.candidate[i], place.frame(k.a), place.frame(k.b));
  c.gap = touch.gap;
  c.p_W = touch.p_W;
  c.n_W = touch.n_W;
  c.gap += off_shapes(c, k);
}

/// Gap of the surfaces minus that of the shapes [m].
double ContactProblem::off_shapes(const contact::Contact& c, const ContactWorkspace& k) const noexcept {
  double off = 0;
  if (k.a.point != kNone) off += c.n_W.dot(off_shape(k.a, c.p_W));
  if (k.b.point != kNone) off -= c.n_W.dot(off_shape(k.b, c.p_W));
  return off;
}

/// Displacement of the surface at the present poses from the shape on which a contact was found, at a point of a flexible body [m].
Vec3 ContactProblem::off_shape(const Side& side, const Vec3& p_W) const noexcept {
  const uint32_t slot = place.block(side.block).index;
  return place.flexible().displaced(slot) ? place.flexible().off_shape(slot, side.point)
                                          : place.prediction_error_at(side, p_W);
}

/// Contacts in the order in which they are given room. Without allocation; the index makes the order total.
void ContactProblem::rank(const contact::ContactSet& contacts) noexcept {
  ranked.clear();
  for (uint32_t i = 0; i < n; ++i) ranked.push_back(i);
  std::sort(ranked.begin(), ranked.end(), [&](uint32_t i, uint32_t j) {
    if (contact[i].bore != contact[j].bore) return contact[i].bore;
    const double a = contacts.contact[i].gap, b = contacts.contact[j].gap;
    return a != b ? a < b : i < j;
  });
}

}  // namespace swage::dynamics
