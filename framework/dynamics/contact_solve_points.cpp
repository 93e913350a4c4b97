// SPDX-License-Identifier: Apache-2.0
//
// Contacts of objects with a solver of their own. What such an object costs grows with the square of the points that it is asked
// about, and most contacts that are found touch nothing: a needle has some within 20 um all along the jaws. So it is asked
// about those that overlap, or nearly so; and about all of them, from the start, where the answer goes farther than expected.
#include <algorithm>
#include <cmath>

#include "contact/candidate.hpp"
#include "dynamics/contact_solve.hpp"

namespace swage::dynamics {

using scene::kNone;

/// Points of all contacts that matter, in their order; of a block that then has none, those of all that it has.
void ContactSolve::add_flexible_points(const contact::ContactSet& contacts,
                                       std::span<const Tie> ties) noexcept {
  n_skipped_ = 0;
  std::fill(points_.begin(), points_.end(), 0u);
  const auto own = [&](const Side& s) { return place_.is_flexible(s.block); };
  const auto asks = [&](const ContactWorkspace& k) {
    for (const Side* s : {&k.a, &k.b})
      if (own(*s)) ++points_[s->block];
  };
  for (uint32_t i = 0; i < n_; ++i) {
    ContactWorkspace& k = contact_[i];
    // what passes through never pushes: nobody needs to know how much gives there
    if (!(contacts.contact[i].law.stiffness > 0))
      for (Side* s : {&k.a, &k.b})
        if (own(*s)) s->block = kNone;
    k.skipped = may_skip(contacts.contact[i], k);
    k.needed = false;
    if (!k.skipped) asks(k);
    n_skipped_ += k.skipped;
  }
  if (n_skipped_ > 0) {
    // it would be taken for free
    std::fill(touched_.begin(), touched_.end(), uint8_t{0});
    for (uint32_t m = 0; m < points_.size(); ++m) touched_[m] = place_.is_flexible(m) && points_[m] == 0;
    for (uint32_t i = 0; i < n_; ++i) {
      ContactWorkspace& k = contact_[i];
      const auto needed = [&](const Side& s) { return own(s) && touched_[s.block]; };
      if (!k.skipped || !(needed(k.a) || needed(k.b))) continue;
      k.skipped = false;
      k.needed = true;
      --n_skipped_;
      asks(k);
    }
  }
  find_who_shares(contacts, ties);
  for (const bool needed : {false, true})
    for (uint32_t i = 0; i < n_; ++i)
      if (!contact_[i].skipped && contact_[i].needed == needed)
        add_flexible_points(contacts.contact[i], contact_[i]);
  share_points(contacts);
}

void ContactSolve::add_flexible_points(const contact::Contact& c, ContactWorkspace& k) noexcept {
  for (const bool is_a : {true, false}) {
    Side& s = is_a ? k.a : k.b;
    if (!place_.is_flexible(s.block) || s.shares) continue;
    s.point = place_.flexible().add_point(place_.block(s.block).index, s.body, is_a ? c.shape_a : c.shape_b,
                                          c.p_W, is_a ? c.n_W : Vec3(-c.n_W));
  }
}

/// Shapes that are apart, where they tell how the surfaces come.
bool ContactSolve::may_skip(const contact::Contact& c, const ContactWorkspace& k) const noexcept {
  if (ask_all_ || c.gap <= lengths_.near || !(c.law.stiffness > 0)) return false;
  bool own = false;
  for (const Side* s : {&k.a, &k.b}) {
    if (!place_.is_flexible(s->block)) continue;
    own = true;
    if (!place_.flexible().surface_is_shape(place_.block(s->block).index)) return false;
  }
  return own;
}

/// The solve starts where flexible bodies expect their points: contacts that they come back to from there show when it has moved them.
void ContactSolve::start_at_predictions(contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < n_; ++i)
    for (const Side* s : {&contact_[i].a, &contact_[i].b})
      if (s->point != kNone && !s->shares) place_.expect(*s, contacts.contact[i].p_W);
  predict_ties();
  place_.flexible().start();
  for (uint32_t i = 0; i < n_; ++i)
    if (contact_[i].a.point != kNone || contact_[i].b.point != kNone)
      contacts.contact[i].gap = contact_[i].found.gap + off_shapes(contacts.contact[i], contact_[i]);
}

/// By how much a gap is wider than that of the shapes.
double ContactSolve::off_shapes(const contact::Contact& c, const ContactWorkspace& k) const noexcept {
  double off = 0;
  if (k.a.point != kNone) off += c.n_W.dot(off_shape(k.a, c.p_W));
  if (k.b.point != kNone) off -= c.n_W.dot(off_shape(k.b, c.p_W));
  return off;
}

/// What is between the shape on which a contact was found and the surface at the present poses, at a point of a flexible body.
Vec3 ContactSolve::off_shape(const Side& side, const Vec3& p_W) const noexcept {
  const uint32_t slot = place_.block(side.block).index;
  return place_.flexible().displaced(slot) ? place_.flexible().off_shape(slot, side.point)
                                           : place_.prediction_error_at(side, p_W);
}

/// Contacts were found on shapes; where a surface stands elsewhere they overlap by something else.
void ContactSolve::meet_surfaces(contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < n_; ++i) {
    ContactWorkspace& k = contact_[i];
    bool elsewhere = false;
    for (const Side* s : {&k.a, &k.b})
      elsewhere =
          elsewhere || (s->point != kNone && place_.flexible().displaced(place_.block(s->block).index));
    if (!elsewhere) continue;
    contacts.contact[i].gap = k.found.gap + off_shapes(contacts.contact[i], k);
    k.active = overlaps(contacts.contact[i]);
  }
}

/// Whether something came so far from where it was expected that a contact may touch of which nobody was told. `moved`: that the
/// solve moved anything at all.
bool ContactSolve::missed_contact(contact::ContactSet& contacts, bool moved) noexcept {
  uint32_t of = kNone;  // whose way is known
  PredictionError prediction_error;
  for (uint32_t i = 0; n_skipped_ > 0 && i < n_; ++i) {
    const ContactWorkspace& k = contact_[i];
    if (!k.skipped) continue;
    const auto still = [&](const Side& s) { return !moved && solved_[s.block]; };
    const bool own_a = place_.is_flexible(k.a.block), own_b = place_.is_flexible(k.b.block);
    if ((!own_a || still(k.a)) && (!own_b || still(k.b))) continue;
    evaluate(contacts, i);
    double gap = contacts.contact[i].gap;
    for (const Side* s : {&k.a, &k.b}) {
      if (!place_.is_flexible(s->block)) continue;
      if (of != s->block) prediction_error = this->prediction_error(contacts, of = s->block);
      gap -= prediction_error.most *
             (1 + prediction_error.grows * (contacts.contact[i].p_W - prediction_error.middle).norm());
    }
    if (gap < 0) return true;
  }
  return false;
}

/// How far points of a flexible body may be from where they were expected, at most: what its asked points are, and the farther a
/// point is from them, for the width that they have across their length, the more.
ContactSolve::PredictionError ContactSolve::prediction_error(const contact::ContactSet& contacts,
                                                             uint32_t block) const noexcept {
  PredictionError out;
  Vec3 end = Vec3::Zero();
  double n = 0, length = 0, width = 0;
  const auto each = [&](auto&& linearise) {
    for (uint32_t i = 0; i < n_; ++i)
      for (const Side* s : {&contact_[i].a, &contact_[i].b})
        if (s->block == block && s->point != kNone && !s->shares) linearise(contacts.contact[i].p_W, *s);
  };
  each([&](const Vec3& p, const Side& s) {
    const Vec3 off =
        solved_[block] ? place_.prediction_error_at(s, p) : place_.free_prediction_error_at(s, p);
    out.middle += p, ++n, out.most = std::max(out.most, off.norm());
  });
  if (n == 0) out.most = HUGE_VAL;  // there was no room for its points
  if (n == 0 || out.most == 0) return out;
  out.middle /= n;
  each([&](const Vec3& p, const Side&) {
    const double away = (p - out.middle).norm();
    if (away > length) length = away, end = (p - out.middle) / length;
  });
  each([&](const Vec3& p, const Side&) { width = std::max(width, end.cross(p - out.middle).norm()); });
  out.grows = 2 / width;
  return out;
}

/// Contacts as they were before the solve looked at them.
void ContactSolve::restore_found(contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < n_; ++i) {
    contact::Contact& c = contacts.contact[i];
    c.gap = contact_[i].found.gap, c.p_W = contact_[i].found.p_W, c.n_W = contact_[i].found.n_W;
  }
}

}  // namespace swage::dynamics
