// SPDX-License-Identifier: Apache-2.0
#include "dynamics/flexible_points.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/tie_constraints.hpp"

namespace swage::dynamics {

using scene::kNone;

FlexiblePoints::FlexiblePoints(ContactProblem& problem) : p_(problem) {
  touched_.assign(p_.place.blocks(), 0), points_.assign(p_.place.blocks(), 0);
}

/// Adds the points of all contacts that are not skipped, in their order; for a block without any, those of all its contacts.
void FlexiblePoints::add(const contact::ContactSet& contacts, std::span<const Tie> ties, bool all) noexcept {
  ask_all_ = all;
  n_skipped_ = 0;
  std::fill(points_.begin(), points_.end(), 0u);
  const auto own = [&](const Side& s) { return p_.place.is_flexible(s.block); };
  const auto asks = [&](const ContactWorkspace& k) {
    for (const Side* s : {&k.a, &k.b})
      if (own(*s)) ++points_[s->block];
  };
  for (uint32_t i = 0; i < p_.n; ++i) {
    ContactWorkspace& k = p_.contact[i];
    // a contact of stiffness 0 never pushes: its mobility is not needed
    if (!(contacts.contact[i].law.stiffness > 0))
      for (Side* s : {&k.a, &k.b})
        if (own(*s)) s->block = kNone;
    k.skipped = may_skip(contacts.contact[i], k);
    k.needed = false;
    if (!k.skipped) asks(k);
    n_skipped_ += k.skipped;
  }
  if (n_skipped_ > 0) {
    // a block without points would be taken for free
    std::fill(touched_.begin(), touched_.end(), uint8_t{0});
    for (uint32_t m = 0; m < points_.size(); ++m) touched_[m] = p_.place.is_flexible(m) && points_[m] == 0;
    for (uint32_t i = 0; i < p_.n; ++i) {
      ContactWorkspace& k = p_.contact[i];
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
    for (uint32_t i = 0; i < p_.n; ++i)
      if (!p_.contact[i].skipped && p_.contact[i].needed == needed) add(contacts.contact[i], p_.contact[i]);
  share_points(contacts);
}

void FlexiblePoints::add(const contact::Contact& c, ContactWorkspace& k) noexcept {
  for (const bool is_a : {true, false}) {
    Side& s = is_a ? k.a : k.b;
    if (!p_.place.is_flexible(s.block) || s.shares) continue;
    s.point = p_.place.flexible().add_point(p_.place.block(s.block).index, s.body,
                                            is_a ? c.shape_a : c.shape_b, c.p_W, is_a ? c.n_W : Vec3(-c.n_W),
                                            s.place);
  }
}

/// True for a contact whose shapes are apart, where the surface of the flexible body is that of its shapes.
bool FlexiblePoints::may_skip(const contact::Contact& c, const ContactWorkspace& k) const noexcept {
  if (ask_all_ || c.gap <= p_.scales.near || !(c.law.stiffness > 0)) return false;
  bool own = false;
  for (const Side* s : {&k.a, &k.b}) {
    if (!p_.place.is_flexible(s->block)) continue;
    own = true;
    if (p_.place.is_banded(s->block)) return false;  // the cost of a band does not grow with its points
    if (!p_.place.flexible().surface_is_shape(p_.place.block(s->block).index)) return false;
  }
  return own;
}

/// Starts the solve where flexible bodies expect their points. Contacts to which they return are found once the solve has moved them.
void FlexiblePoints::start_at_predictions(contact::ContactSet& contacts, TieConstraints& ties) noexcept {
  for (uint32_t i = 0; i < p_.n; ++i)
    for (const Side* s : {&p_.contact[i].a, &p_.contact[i].b})
      if (s->point != kNone && !s->shares) p_.place.expect(*s, contacts.contact[i].p_W);
  ties.predict();
  p_.place.flexible().start();
  for (uint32_t i = 0; i < p_.n; ++i)
    if (p_.contact[i].a.point != kNone || p_.contact[i].b.point != kNone)
      contacts.contact[i].gap = p_.contact[i].found.gap + p_.off_shapes(contacts.contact[i], p_.contact[i]);
}

/// Corrects the gaps, found on shapes, where the surface of a flexible body is displaced from its shapes.
void FlexiblePoints::meet_surfaces(contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < p_.n; ++i) {
    ContactWorkspace& k = p_.contact[i];
    bool elsewhere = false;
    for (const Side* s : {&k.a, &k.b})
      elsewhere =
          elsewhere || (s->point != kNone && p_.place.flexible().displaced(p_.place.block(s->block).index));
    if (!elsewhere) continue;
    contacts.contact[i].gap = k.found.gap + p_.off_shapes(contacts.contact[i], k);
    k.active = p_.takes_part(contacts.contact[i], k);
  }
}

/// Whether something moved so far from its expected place that a contact that no flexible body was asked about may touch.
/// `moved`: the solve has moved something.
bool FlexiblePoints::missed_contact(contact::ContactSet& contacts, bool moved) noexcept {
  uint32_t of = kNone;  // block to which prediction_error belongs
  PredictionError prediction_error;
  for (uint32_t i = 0; n_skipped_ > 0 && i < p_.n; ++i) {
    const ContactWorkspace& k = p_.contact[i];
    if (!k.skipped) continue;
    const auto still = [&](const Side& s) { return !moved && p_.solved[s.block]; };
    const bool own_a = p_.place.is_flexible(k.a.block), own_b = p_.place.is_flexible(k.b.block);
    if ((!own_a || still(k.a)) && (!own_b || still(k.b))) continue;
    p_.evaluate(contacts, i);
    double gap = contacts.contact[i].gap;
    for (const Side* s : {&k.a, &k.b}) {
      if (!p_.place.is_flexible(s->block)) continue;
      if (of != s->block) prediction_error = this->prediction_error(contacts, of = s->block);
      gap -= prediction_error.most *
             (1 + prediction_error.grows * (contacts.contact[i].p_W - prediction_error.middle).norm());
    }
    if (gap < 0) return true;
  }
  return false;
}

/// Bound on the prediction error of a flexible body's points: the largest error of the points asked about, which grows with the
/// distance of a point from their centre, relative to their width across their length.
FlexiblePoints::PredictionError FlexiblePoints::prediction_error(const contact::ContactSet& contacts,
                                                                 uint32_t block) const noexcept {
  PredictionError out;
  Vec3 end = Vec3::Zero();
  double n = 0, length = 0, width = 0;
  const auto each = [&](auto&& linearise) {
    for (uint32_t i = 0; i < p_.n; ++i)
      for (const Side* s : {&p_.contact[i].a, &p_.contact[i].b})
        if (s->block == block && s->point != kNone && !s->shares) linearise(contacts.contact[i].p_W, *s);
  };
  each([&](const Vec3& p, const Side& s) {
    const Vec3 off =
        p_.solved[block] ? p_.place.prediction_error_at(s, p) : p_.place.free_prediction_error_at(s, p);
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

/// Restores gap, place and normal of the contacts to those before the solve.
void FlexiblePoints::restore(contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < p_.n; ++i) {
    contact::Contact& c = contacts.contact[i];
    c.gap = p_.contact[i].found.gap, c.p_W = p_.contact[i].found.p_W, c.n_W = p_.contact[i].found.n_W;
  }
}

/// Marks contacts for which flexible bodies have no room: they share the points of others.
void FlexiblePoints::find_who_shares(const contact::ContactSet& contacts,
                                     std::span<const Tie> ties) noexcept {
  const size_t n_ties = std::min<size_t>(ties.size(), p_.room.ties);
  const auto room = [&](uint32_t block) { return p_.place.flexible().room(p_.place.block(block).index); };
  bool fit = true;
  for (uint32_t m = 0; m < points_.size(); ++m)
    fit = fit && (points_[m] == 0 || points_[m] + 2 * n_ties <= room(m));
  if (fit) return;
  // points of ties come first
  std::fill(points_.begin(), points_.end(), 0u);
  for (const Tie& tie : ties.first(n_ties))
    for (const uint32_t body : {tie.body_a, tie.body_b}) {
      const uint32_t block = body == kNone ? kNone : p_.place.side(body, kNone).block;
      if (p_.place.is_flexible(block)) ++points_[block];
    }
  p_.rank(contacts);
  for (const uint32_t i : p_.ranked) {
    ContactWorkspace& k = p_.contact[i];
    if (k.skipped) continue;
    for (Side* s : {&k.a, &k.b})
      if (p_.place.is_flexible(s->block)) s->shares = ++points_[s->block] > room(s->block);
  }
}

void FlexiblePoints::share_points(const contact::ContactSet& contacts) noexcept {
  for (uint32_t i = 0; i < p_.n; ++i)
    for (Side* s : {&p_.contact[i].a, &p_.contact[i].b}) {
      if (!s->shares) continue;
      s->point = p_.place.flexible().nearest(p_.place.block(s->block).index, contacts.contact[i].p_W);
      ++p_.health.shared_points;
    }
}

}  // namespace swage::dynamics
