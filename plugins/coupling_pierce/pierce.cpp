// SPDX-License-Identifier: Apache-2.0
#include "pierce.hpp"

#include <algorithm>
#include <cmath>

namespace swage::coupling_pierce {

using toolkit::Quat;
using toolkit::raw;
using toolkit::vec;

namespace {

// Contacts within this many wire radii of the point count as contacts of the point.
constexpr double kPoint = 6;
// In wire radii: part of the needle outside, around its holes, that does not touch the surface either.
constexpr double kMouth = 6;
// A touch that overlaps by more than this many radii when first seen is inside a hole, not on the surface.
constexpr double kNewTouch = 2;
// s: a new touch counts as one only after this pause.
constexpr double kTouchPause = 0.15;
// A point is deflected once it has slid by this many wire radii from where it was refused.
constexpr double kSlides = 2;
// In wire radii: the point is out when it is this far outside its entry, and in again when it is this deep.
constexpr double kClear = 1;
// Cosine of the angle to a surface's normal above which a touch is one of that surface, not of an edge.
constexpr double kFaceOn = 0.7;
// A second puncture within this many wire radii of a wound belongs to that wound.
constexpr double kSameHole = 2;

void put(double* to, const Vec3& a) {
  for (int i = 0; i < 3; ++i) to[i] = a[i];
}
Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }

/// Finds the place on the needle of a contact, whose p_W is midway between the undisturbed surfaces: at any depth the needle's surface is
/// as far beyond p_W as the tissue's surface is before it.
std::optional<swage_piercing_place> place_of(const Site& site, const swage_contact& contact) {
  const Vec3 p = vec(contact.p_W), n = vec(contact.n_W);
  double half = -0.5 * contact.gap;
  const auto in = site.tissue.inside(site.b, contact.p_W);
  if (in && n.dot(vec(in->normal_W)) > kFaceOn) half = in->depth;
  return site.needle.nearest(site.a, raw(Vec3(p - half * n)));
}

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace

void Pierce::build(const PierceParams& params, CouplingBuilder& builder) {
  params_ = params;
  for (size_t i = 1; i < params.table_angle.size(); ++i)
    if (params.table_angle[i] < params.table_angle[i - 1])
      builder.error("table_angle", "the angles of the table must rise");
  reaction_ = {params.law, params.null_angle, params.reaction, params.table_angle, params.table_force};
  builder.state<PierceState>();
  declare(builder);
}

void Pierce::bind(const Peer& a, const Peer& b) {
  needle_ = a;
  tissue_ = b;
}

void Pierce::reset(const CouplingStep& step) {
  auto& state = step.state<PierceState>();
  state = {};
  before_.reset(), after_.reset();
  state.last_entry = state.last_exit = -1;
}

/// True for a contact of a part of the needle that is in a hole, or has just come out of one: it does not touch the surface.
bool Pierce::passes(const PierceState& state, const Site& site, const swage_contact& contact,
                    double s) const {
  const double mouth = kMouth * site.radius / site.length, end = kPoint * site.radius / site.length;
  if (state.clears(PierceState::kPointClears) && s < end) return true;
  if (state.clears(PierceState::kEndClears) && s > 1 - end) return true;
  for (const Track& track : state.track) {
    if (track.open == 0 || s > track.s_in + mouth) continue;
    const bool beyond = track.out == Track::kOut && s < track.s_out - mouth;
    const bool on_surface = contact.gap > -kNewTouch * site.radius || !vec(contact.f_a_W).isZero(0);
    if (!beyond || !on_surface) return true;
  }
  return false;
}

void Pierce::resolve(const CouplingStep& step) {
  after_.reset();
  const Site& site = before_.emplace(needle_, tissue_, step.a(), step.b());
  if (!site.good) return discard();
  auto& state = step.state<PierceState>();
  along_ = lateral_ = pull_ = 0;
  bool overlaps[2] = {};  // at the point; at the blunt end
  for (swage_contact& contact : step.contacts()) {
    const auto place = place_of(site, contact);
    if (!place) continue;
    const double overlap = std::max(0.0, -contact.gap);
    contact.friction = site.law.friction;
    contact.stiffness = site.law.stiffness + site.law.stiffening * overlap;
    contact.restitution = 0;
    if (passes(state, site, contact, place->s)) contact.stiffness = contact.friction = 0;
    const double end = kPoint * site.radius / site.length;
    overlaps[0] = overlaps[0] || (contact.gap < 0 && place->s < end);
    overlaps[1] = overlaps[1] || (contact.gap < 0 && place->s > 1 - end);
  }
  if (!overlaps[0]) state.set_clearing(PierceState::kPointClears, false);
  if (!overlaps[1]) state.set_clearing(PierceState::kEndClears, false);
}

uint32_t Pierce::ties(const CouplingStep& step, std::span<swage_tie> out) {
  if (!before_) return 0;
  const Site& site = *before_;
  const auto& state = step.state<PierceState>();
  uint32_t n = 0;
  for (uint32_t t = 0; site.good && t < PierceState::kTracks; ++t) {
    const Track& track = state.track[t];
    if (track.open == 0 || out.size() - n < Track::kTies) continue;
    const double theta = angle_in(site, track, state);
    const double exit_force = params_.exit_share * params_.bluntness * site.law.puncture_force;
    uint32_t of[Track::kTies];
    const uint32_t made = make_ties(site, track, reaction_(theta), exit_force, out.data() + n, of);
    for (uint32_t i = 0; i < made; ++i) made_[n + i] = {t, of[i]};
    n += made;
  }
  return n;
}

void Pierce::on_solved(const CouplingStep& step, std::span<const swage_tie> ties) {
  const Site& site = after_.emplace(needle_, tissue_, step.a(), step.b());
  auto& state = step.state<PierceState>();
  if (!site.good) return discard();
  along_ = lateral_ = pull_ = 0;
  Vec3 across = Vec3::Zero(), on_tissue = Vec3::Zero();
  const auto newest = static_cast<uint32_t>(state.newest);
  for (size_t i = 0; i < ties.size(); ++i) {
    const Made& made = made_[i];
    state.swept += take_tie(site, state.track[made.track], ties[i], made.of);
    if (made.track != newest || made.of == Track::kOfRoll) continue;
    const Vec3 f = vec(ties[i].f_a_W), axis_W = vec(ties[i].axis_W);
    along_ -= axis_W.dot(f);
    across += f - axis_W.dot(f) * axis_W;
    on_tissue -= f;
  }
  const Track& track = state.track[newest];
  if (track.open == 0) return;
  const Vec3 n = site.X_WO.q * axis(state.wound[static_cast<uint32_t>(track.entry)], 0);
  lateral_ = across.norm();
  pull_ = (on_tissue - n.dot(on_tissue) * n).norm();
}

Press Pierce::press(const CouplingStep& step, const Site& site) const {
  Press press;
  for (const swage_contact& contact : step.contacts()) {
    const Vec3 n = vec(contact.n_W);
    const double force = vec(contact.f_a_W).dot(n);
    if (!(force > 0) || contact.stiffness <= 0) continue;
    const auto place = place_of(site, contact);
    if (!place || place->s * site.length > kPoint * site.radius) continue;
    press.force += force;
    press.normal_W += force * n;
    press.surface_W += force * (vec(contact.p_W) - 0.5 * contact.gap * n);
  }
  if (!(press.force > 0)) return press;
  press.surface_W /= press.force;
  press.normal_W.normalize();

  // on the entry or the far surface: its undisturbed position, not the dented one
  const Vec3 up = vec(site.point_in.normal_W);
  const double along = up.dot(press.normal_W);
  if (std::abs(along) < kFaceOn) return press;
  press.normal_W = along > 0 ? up : Vec3(-up);
  press.surface_W =
      along > 0 ? vec(site.point_in.p_W) : Vec3(vec(site.point.p_W) + site.point_in.beyond * up);
  return press;
}

double Pierce::angle_of_point(const Site& site, const Vec3& normal_W) const {
  return angle_between(vec(site.point.tangent_W), normal_W);
}

/// Angle between the needle and the inward normal at its entry [rad, 0..pi/2]; the same hole seen from the other side gives 180 deg more.
double Pierce::angle_in(const Site& site, const Track& track, const PierceState& state) const {
  const auto place = needle_.place(site.a, track.s_in);
  if (!place) return 0;
  const Vec3 n = site.X_WO.q * axis(state.wound[static_cast<uint32_t>(track.entry)], 0);
  return std::min(angle_between(vec(place->tangent_W), n), 0.5 * std::numbers::pi);
}

void Pierce::touch(const CouplingStep& step, PierceState& state, const Site& site, const Press& press) const {
  if (!(press.force > 0)) {
    state.untouched_s += step.dt();
    if (state.untouched_s >= kTouchPause) state.touching = 0, state.peak = 0;
    return;
  }
  if (state.touching == 0) step.event(touched_, angle_of_point(site, press.normal_W));
  state.touching = 1;
  state.untouched_s = 0;
  state.peak = std::max(state.peak, press.force);
}

/// The point has borne the force that punctures at a right angle without entering: refused. It is deflected once it slides or lifts off.
void Pierce::refuse(const CouplingStep& step, PierceState& state, const Site& site, const Press& press,
                    double angle) const {
  const Vec3 point_O = site.local(vec(site.point.p_W));
  if (state.refused == 0) {
    if (press.force < params_.bluntness * site.law.puncture_force) return;
    state.refused = angle;
    put(state.refused_p, point_O);
  }
  const Vec3 n_O = site.X_WO.q.conjugate() * vec(site.point_in.normal_W),
             way = point_O - vec3(state.refused_p);
  const bool slid = (way - n_O.dot(way) * n_O).norm() >= kSlides * site.radius;
  if (!slid && press.force > 0) return;
  step.event(deflected_, state.refused);
  state.deflections += 1;
  state.refused = 0;
}

uint32_t Pierce::wound_at(PierceState& state, const Vec3& p_O, const Vec3& n_O, const Vec3& along_O,
                          double radius) const {
  uint32_t slot = PierceState::kWounds - 1;  // without a free slot the last wound is replaced
  for (uint32_t i = PierceState::kWounds; i-- > 0;)
    if (state.wound[i].open == 0) slot = i;
  for (uint32_t i = 0; i < PierceState::kWounds; ++i)
    if (state.wound[i].open != 0 && (origin(state.wound[i]) - p_O).norm() < kSameHole * radius) return i;
  open_wound(state.wound[slot], settled_[slot], p_O, n_O, along_O, radius);
  return slot;
}

void Pierce::enter(const CouplingStep& step, PierceState& state, const Site& site, const Press& press,
                   double angle) const {
  uint32_t t = 0;
  while (t < PierceState::kTracks && state.track[t].open != 0) ++t;
  if (t == PierceState::kTracks) return;

  // intersection of the needle's line with the surface: on the needle, or ahead of its point
  const Vec3 n = press.normal_W, tip = vec(site.point.p_W), back = vec(site.point.tangent_W);
  Vec3 entry = tip + n.dot(press.surface_W - tip) / std::max(0.1, n.dot(back)) * back;
  swage_piercing_place place{};
  const bool in = n.dot(tip - press.surface_W) < 0;
  const double s_in = in ? crossing(site, press.surface_W, n, 0, place) : 0;
  if (in) entry = vec(place.p_W);
  const Quat to_O = site.X_WO.q.conjugate();
  Track& track = state.track[t];
  const uint32_t wound = wound_at(state, site.local(entry), to_O * n, to_O * back, site.radius);
  open_track(site, track, entry, s_in);
  share_out(site, needle_points(site, track), track);
  track.entry = wound;
  track.age = state.entries += 1;
  state.newest = t;
  state.last_entry = wound;
  state.last_exit = -1;
  state.peak_entry = state.peak;
  state.peak_exit = state.peak = state.refused = 0;
  state.set_clearing(PierceState::kPointClears, false);
  put(state.entry_p, entry);
  put(state.exit_p, Vec3::Zero());
  step.event(entered_, angle);
}

/// Sweeps the section of the needle at `place` over the plane of a wound, where the tissue holds it at held_O.
void Pierce::tear(const CouplingStep& step, PierceState& state, const Site& site, uint32_t i,
                  const swage_piercing_place& place, const double* held_O) const {
  Wound& wound = state.wound[i];
  const Vec3 centre_O = params_.sweep == Sweep::kNeedle ? site.local(vec(place.p_W)) : vec3(held_O);
  const Vec3 t_O = site.X_WO.q.conjugate() * vec(place.tangent_W);
  sweep(wound, settled_[i], centre_O, std::abs(axis(wound, 0).dot(t_O)), t_O);
  const double ratio = wound.reach / wound.radius;
  if (wound.told != 0 || ratio <= params_.torn_from) return;
  wound.told = 1;
  step.event(torn_, ratio);
}

/// Exit: the point meets a face from inside, breaks it, leaves.
void Pierce::come_out(const CouplingStep& step, PierceState& state, const Site& site, Track& track) const {
  Vec3 n_W = Vec3::Zero();
  const bool outside = site.inside(n_W) < 0;
  if (track.out == Track::kInside) {
    // at the end of its cut, and no longer in the mouth of its entry
    const bool new_ground = track.progress > track.cut - kClear * site.radius;
    if (!outside || !new_ground || track.progress < 2 * kClear * site.radius) return;
    track.out = Track::kBreaking;
    track.cut = track.progress;
    set_front(site, track);
  }
  if (track.out != Track::kOut || track.exit >= 0) return;

  const Quat to_O = site.X_WO.q.conjugate();
  const Vec3 tip = vec(site.point.p_W), way = -vec(site.point.tangent_W);
  const Vec3 exit = tip + site.inside(n_W) / std::max(0.1, n_W.dot(way)) * way;
  track.exit = wound_at(state, site.local(exit), to_O * n_W, to_O * way, site.radius);
  state.last_exit = track.exit;
  state.peak_exit = track.peak_exit;
  put(state.exit_p, exit);
  step.event(exited_, angle_between(way, n_W));
}

/// Closes the track: the overlap that remains at that end of the needle is no touch.
void Pierce::close(PierceState& state, Track& track, int end) const {
  track.open = 0;
  state.set_clearing(end, true);
}

/// Updates a track after the step: crossings, wounds, exits, its end.
void Pierce::go_on(const CouplingStep& step, PierceState& state, const Site& site, Track& track) const {
  NeedlePoints at = needle_points(site, track);
  follow(site, at, track);
  const auto entry_at = static_cast<uint32_t>(track.entry);
  Wound& entry = state.wound[entry_at];
  entry.depth = std::max(entry.depth, track.cut);
  swage_piercing_place place{};
  track.s_in = crossing(site, entry, track.s_in, place);
  if (track.progress < -kClear * site.radius) {
    close(state, track, PierceState::kPointClears);
    step.event(back_out_, track.deepest);
    return;
  }
  if (through(track.s_in)) tear(step, state, site, entry_at, place, track.support[0].p);
  come_out(step, state, site, track);
  if (track.exit >= 0) {
    const auto exit_at = static_cast<uint32_t>(track.exit);
    Wound& exit = state.wound[exit_at];
    exit.depth = std::max(exit.depth, track.cut);
    track.s_out = crossing(site, exit, track.s_out, place);
    const Support& last = track.support[static_cast<uint32_t>(track.count) - 1];
    if (through(track.s_out)) tear(step, state, site, exit_at, place, last.p);
  }
  support_end(site, at, track);
  if (!share_out(site, at, track)) {
    close(state, track, PierceState::kPointClears);
    step.event(cut_out_, entry.reach / entry.radius);
    return;
  }
  lengthen(site, at, track);
  if (track.s_in >= 1 && track.passed == 0) {
    track.passed = 1;
    step.event(passed_, entry.reach / entry.radius);
  }
  if (is_through(site, track)) close(state, track, PierceState::kEndClears);
}

void Pierce::finish(const CouplingStep& step) {
  const Site& site = after_ ? *after_ : after_.emplace(needle_, tissue_, step.a(), step.b());
  if (!site.good) return discard();
  auto& state = step.state<PierceState>();
  for (Track& track : state.track)
    if (track.open != 0) go_on(step, state, site, track);

  const Press press = this->press(step, site);
  touch(step, state, site, press);
  const double angle = press.force > 0 ? angle_of_point(site, press.normal_W) : 0;
  const bool may = press.force > 0 && angle < params_.limit_angle;
  if (may && press.force >= params_.bluntness * site.law.puncture_force + reaction_(angle)) {
    enter(step, state, site, press, angle);
  } else {
    refuse(step, state, site, press, angle);
  }
  tell(step, state, site, press);
}

}  // namespace swage::coupling_pierce

SWAGE_EXPORT(swage::coupling_pierce::Pierce)
