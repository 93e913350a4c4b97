// SPDX-License-Identifier: Apache-2.0
#include "meniscus.hpp"

#include <algorithm>
#include <cmath>

namespace swage::coupling_meniscus {

using toolkit::Pose;
using toolkit::raw;
using toolkit::vec;
using toolkit::Vec3;

namespace {

void put(double* to, const Vec3& a) {
  for (int i = 0; i < 3; ++i) to[i] = a[i];
}
Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }

}  // namespace

void Meniscus::build(const MeniscusParams& params, CouplingBuilder& builder) {
  params_ = params;
  environment_ = environment(host());
  if (moist()) builder.state<MeniscusState>();
  force_ = builder.signal("meniscus.force", "N", "Sum of the pulls with which the film holds the thread to the other object.");
  wet_ = builder.signal("meniscus.wet", "m", "Length of thread that the film holds.");
  left_out_ = builder.signal("meniscus.left_out", "1", "Wet places that bear nothing because too many are wet.");
}

void Meniscus::bind(const Peer& a, const Peer&) {
  thread_ = StrandPeer(a);
  if (!thread_.valid()) refuse("the thread has no table of " SWAGE_TRAIT_STRAND);
}

void Meniscus::reset(const CouplingStep& step) {
  if (moist()) step.state<MeniscusState>() = {};
}

uint32_t Meniscus::count(double length) const {
  return std::min(kPlaces, static_cast<uint32_t>(std::floor(length / params_.spacing)));
}

/// Marks places that touch the film as wet, and stores where they lie.
void Meniscus::resolve(const CouplingStep& step) {
  if (!moist()) return;
  const auto law = thread_.law(step.a());
  if (!law) return;
  auto& state = step.state<MeniscusState>();
  const uint32_t n = count(law->length);
  for (const swage_contact& contact : step.contacts()) {
    // a contact that a coupling lets pass, as in a hole, is not on the surface
    if (contact.gap > environment_.film || contact.stiffness == 0) continue;
    const auto near = thread_.nearest(step.a(), contact.p_W);
    if (!near || contact.body_b >= step.b()->n_body) continue;
    const auto i = static_cast<uint32_t>(near->s / params_.spacing);
    if (i >= n) continue;
    Place& place = state.place[i];
    const Pose X_BW = Pose(step.b()->X_WB[contact.body_b]).inverse();
    const Vec3 normal = vec(contact.n_W);
    place.wet = 1, place.body = contact.body_b;
    put(place.p_B, X_BW * Vec3(vec(contact.p_W) - 0.5 * contact.gap * normal));
    put(place.n_B, X_BW.q * normal);
  }
}

Meniscus::Lift Meniscus::lift(const CouplingStep& step, const swage_strand_law& law, const Place& place, double s) const {
  Lift out;
  const auto at = thread_.place(step.a(), s);
  const auto body = static_cast<uint32_t>(place.body);
  if (!at || at->parted != 0 || body >= step.b()->n_body) return out;
  const Pose X_WB(step.b()->X_WB[body]);
  out.p_W = vec(at->p_W), out.n_W = X_WB.q * vec3(place.n_B), out.body = at->body;
  const Vec3 way = out.p_W - X_WB * vec3(place.p_B);
  out.up = way.dot(out.n_W) - law.radius;
  out.aside = (way - way.dot(out.n_W) * out.n_W).norm();
  out.good = true;
  return out;
}

/// Makes a tie for each wet place, along the normal: it pulls and never pushes. First places beside a dry one, then the others.
uint32_t Meniscus::ties(const CouplingStep& step, std::span<swage_tie> out) {
  if (!moist()) return 0;
  auto& state = step.state<MeniscusState>();
  state.served = state.force = 0;
  const auto law = thread_.law(step.a());
  if (!law) return 0;
  const uint32_t n = count(law->length), room = std::min(static_cast<uint32_t>(params_.most), static_cast<uint32_t>(out.size()));
  const Bridge film = bridge(work_of_adhesion(law->radius, environment_.surface_tension, environment_.contact_angle), params_.spacing,
                             environment_.film);
  const auto wet = [&](uint32_t i) { return i < n && state.place[i].wet != 0; };
  uint32_t used = 0;
  for (const bool fronts : {true, false})
    for (uint32_t i = 0; i < n && used < room; ++i) {
      if (!wet(i) || (wet(i + 1) && i > 0 && wet(i - 1)) == fronts) continue;
      const Lift at = lift(step, *law, state.place[i], this->at(i));
      if (!at.good) continue;
      bridge_[used] = i;
      swage_tie& tie = out[used++] = {};
      tie.body_a = at.body, tie.body_b = static_cast<uint32_t>(state.place[i].body);
      tie.p_W = raw(at.p_W), tie.axis_W = raw(at.n_W), tie.offset_W = raw(Vec3(at.up * at.n_W));
      tie.stiffness_along = film.stiffness, tie.forward_limit = film.pull, tie.backward_limit = 0;
      tie.strength = 0, tie.f_a_W = raw(Vec3(-state.place[i].pull * at.n_W));
    }
  state.served = used;
  return used;
}

void Meniscus::on_solved(const CouplingStep& step, std::span<const swage_tie> ties) {
  if (!moist()) return;
  auto& state = step.state<MeniscusState>();
  state.force = 0;
  for (Place& place : state.place) place.pull = 0;
  for (size_t k = 0; k < ties.size(); ++k) {
    Place& place = state.place[bridge_[k]];
    place.pull = vec(ties[k].f_a_W).norm();
    state.force += place.pull;
  }
}

/// A place becomes dry when it is lifted out of the film, or without a touch has moved along the surface by more than film and spacing.
void Meniscus::finish(const CouplingStep& step) {
  const auto law = thread_.law(step.a());
  if (!moist() || !law) return step.signal(force_, 0), step.signal(wet_, 0), step.signal(left_out_, 0);
  auto& state = step.state<MeniscusState>();
  const uint32_t n = count(law->length);
  double wet = 0;
  for (uint32_t i = 0; i < n; ++i) {
    if (state.place[i].wet == 0) continue;
    const Lift at = lift(step, *law, state.place[i], this->at(i));
    const double aside = std::max(environment_.film, params_.spacing);
    state.place[i].wet = at.good && at.up < environment_.film && at.aside < aside ? 1 : 0;
    wet += state.place[i].wet;
  }
  step.signal(force_, state.force);
  step.signal(wet_, wet * params_.spacing);
  step.signal(left_out_, std::max(0.0, wet - state.served));
}

}  // namespace swage::coupling_meniscus

SWAGE_EXPORT(swage::coupling_meniscus::Meniscus)
