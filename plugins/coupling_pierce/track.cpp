// SPDX-License-Identifier: Apache-2.0
#include "track.hpp"

#include <algorithm>
#include <cmath>

namespace swage::coupling_pierce {

using toolkit::Quat;
using toolkit::raw;
using toolkit::vec;

namespace {

constexpr double kStick = Track::kStick;
// In wire radii: advance over which the cutting force of the point builds up, 2.5 um.
constexpr double kFront = 0.05;
// In wire radii: first distance between supports, 0.2 mm. Doubled whenever the track is full.
constexpr double kSpacing = 4;
// In wire radii: lever arm of the tie against rolling, 0.5 mm. With a longer arm the tie bears less force across the needle.
constexpr double kLever = 10;
// In wire radii: sliding distance over which `rub` decays, 0.2 mm, the first spacing. Shorter: the friction
// force falls within a step when a track is thinned out. Longer: it stays after the needle has left the places that bore it.
constexpr double kEven = 4;
// Relaxation: share of the change of the displacement of the tissue that `given` follows in each step. 1: in tissue displaced by several
// `spread` the contact site and its displacement oscillate from step to step. Small: the needle is searched where the tissue was.
constexpr double kFollow = 0.4;
// In wire radii, 10 um: largest lag of `given`. A needle that is released springs by half a millimetre within a step.
constexpr double kLag = 0.2;
// Convergence: a crossing within this (in s) of the last estimate is final.
constexpr double kConverged = 1e-10;
// Sine of the needle's angle to the plane below which it has no well-defined crossing.
constexpr double kFlat = 0.05;

void put(double* to, const Vec3& a) {
  for (int i = 0; i < 3; ++i) to[i] = a[i];
}

Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }

uint32_t supports(const Track& track) { return static_cast<uint32_t>(track.count); }

}  // namespace

Site::Site(const Peer& pa, const Peer& pb, const Step& step_a, const Step& step_b)
    : needle(pa), tissue(pb), a(step_a), b(step_b) {
  const auto tip = needle.place(a, 0);
  const auto laws = tissue.law(b);
  if (!tip || !laws) return;
  const auto place = tissue.inside(b, tip->p_W);
  if (!place || place->body >= b->n_body) return;
  point = *tip;
  point_in = *place;
  law = *laws;
  body = place->body;
  X_WO = Pose(b->X_WB[body]);
  length = point.length;
  radius = point.radius;
  good = true;
}

double Site::inside(Vec3& normal_W) const {
  const Vec3 n = vec(point_in.normal_W);
  const double depth = point_in.depth, to_far = -point_in.beyond, edge = point_in.edge;
  if (depth <= to_far && depth <= edge) {
    normal_W = n;
    return depth;
  }
  if (to_far <= edge) {
    normal_W = -n;
    return to_far;
  }
  // through a rim or an edge: the direction in which the point moves, along the surface
  const Vec3 way = -vec(point.tangent_W), flat = way - n.dot(way) * n;
  normal_W = flat.norm() > 1e-6 ? Vec3(flat.normalized()) : n;
  return edge;
}

NeedlePoint needle_at(const Site& site, const Support& support) {
  NeedlePoint out;
  // near the present place of the tissue: from its unloaded position the nearest place of a curved needle is another one
  const Vec3 p_O = vec3(support.p) + vec3(support.given), p_W = site.world(p_O.data());
  const auto place = site.needle.nearest(site.a, raw(p_W));
  if (!place) return out;
  out.p_W = vec(place->p_W);
  out.advance_W = -vec(place->tangent_W);
  out.s = place->s;
  out.body = place->body;
  // beyond its ends the needle is continued by straight lines
  if (out.s <= 0 || out.s >= 1) out.s -= out.advance_W.dot(p_W - out.p_W) / site.length;
  out.gone = out.s * site.length + out.advance_W.dot(toolkit::rotated(site.X_WO.q, vec3(support.given)));
  return out;
}

double crossing(const Site& site, const Wound& wound, double s0, swage_piercing_place& place) {
  return crossing(site, site.X_WO * origin(wound), site.X_WO.q * axis(wound, 0), s0, place);
}

double crossing(const Site& site, const Vec3& o, const Vec3& n, double s0, swage_piercing_place& place) {
  double s = std::clamp(s0, 0.0, 1.0);
  for (int i = 0; i < 4; ++i) {
    const auto at = site.needle.place(site.a, s);
    if (!at) return s;
    place = *at;
    const double off = (vec(at->p_W) - o).dot(n), slope = vec(at->tangent_W).dot(n);
    if (std::abs(slope) < kFlat) return s;
    const double next = std::clamp(s - off / (slope * site.length), 0.0, 1.0);
    if (std::abs(next - s) <= kConverged) return next;
    s = next;
  }
  return s;
}

void open_track(const Site& site, Track& track, const Vec3& entry_W, double s_in) {
  track = {};
  track.open = 1;
  track.exit = -1;
  track.s_in = s_in;
  track.spacing = kSpacing * site.radius;
  // the inserted part has cut nothing yet: the point advances through it until its force has fallen to the cutting force
  track.progress = track.deepest = track.shared = s_in * site.length;
  put(track.support[0].p, site.local(entry_W));
  set_front(site, track);
  // a blunt point that enters at a small force has its middle still outside: its bristle is at rest there, not at the surface
  track.support[0].rest = s_in > 0 ? s_in : needle_at(site, track.support[0]).s;
  track.count = 1;
  // supports hold the part that is already inside
  while (track.spacing * (Track::kSupports - 2) < s_in * site.length) track.spacing *= 2;
  for (uint32_t i = 1; i * track.spacing < s_in * site.length; ++i) {
    const double s = s_in - i * track.spacing / site.length;
    const auto place = site.needle.place(site.a, s);
    if (!place) return;
    Support& support = track.support[supports(track)];
    put(support.p, site.local(vec(place->p_W)));
    support.rest = s;
    support.at = i * track.spacing;
    track.count += 1;
  }
}

double progress(const Site& site, const Track& track) {
  const Support& last = track.support[supports(track) - 1];
  return last.at + needle_at(site, last).gone;
}

NeedlePoints needle_points(const Site& site, const Track& track) {
  NeedlePoints at;
  for (uint32_t i = 0; i < supports(track); ++i) at.support[i] = needle_at(site, track.support[i]);
  return at;
}

namespace {

swage_tie support_tie(const Site& site, const Support& support, const NeedlePoint& at) {
  swage_tie tie{};
  const Vec3 way = at.p_W - site.world(support.p), across = way - at.advance_W.dot(way) * at.advance_W;
  tie.body_a = at.body;
  tie.body_b = site.body;
  tie.p_W = raw(at.p_W);
  tie.axis_W = raw(at.advance_W);
  tie.offset_W = raw(Vec3(across + (at.gone - support.rest * site.length) * at.advance_W));
  tie.stiffness_across = site.law.side_stiffness * support.share;
  tie.stiffness_along = kStick * tie.stiffness_across;
  tie.strength = site.law.failure_stress * 2 * site.radius * support.share;
  tie.forward_limit = tie.backward_limit =
      site.law.drag * support.share + site.law.friction * (vec3(support.across).norm() + support.rub);
  tie.f_a_W = raw(Vec3(site.X_WO.q * vec3(support.across) + support.along * at.advance_W));
  return tie;
}

/// The tie at the end of the cut: a wall that yields at the cutting force; a face from inside bears more, and softly.
swage_tie front_tie(const Site& site, const Track& track, double progress, double exit_force) {
  swage_tie tie{};
  const Vec3 advance = -vec(site.point.tangent_W);
  const bool face = track.out == Track::kBreaking;
  tie.body_a = site.point.body;
  tie.body_b = site.body;
  tie.p_W = raw(site.world(track.front));
  tie.axis_W = raw(advance);
  tie.offset_W = raw(Vec3((progress - track.cut) * advance));
  tie.forward_limit = face ? std::max(exit_force, site.law.cutting_force) : site.law.cutting_force;
  tie.stiffness_along = face ? site.law.stiffness : site.law.cutting_force / (kFront * site.radius);
  tie.strength = HUGE_VAL;
  tie.f_a_W = raw(Vec3(-track.cutting * advance));
  return tie;
}

}  // namespace

void set_front(const Site& site, Track& track) {
  put(track.front,
      site.local(vec(site.point.p_W) + (track.progress - track.cut) * vec(site.point.tangent_W)));
}

/// The tie against rolling: the wire's surface has friction in rolling as in sliding. A bristle at the end of a lever across the middle of
/// the inserted part. Without this tie only the needle's curvature would keep it from rotating about its own axis.
swage_tie roll_tie(const Site& site, const Track& track, double stiffness, double drag) {
  swage_tie tie{};
  tie.axis_W = {1, 0, 0};
  const double tip = track.out == Track::kOut ? track.s_out : 0;
  const auto middle = site.needle.place(site.a, 0.5 * (tip + track.s_in));
  if (!middle) return tie;
  const Vec3 advance = -vec(middle->tangent_W), lever = kLever * site.radius * advance.unitOrthogonal();
  const double ratio = 1 / kLever;
  tie.body_a = middle->body;
  // a tissue at rest is equivalent to the world, and then no mobility is needed at the end of the lever
  const swage_twist& V = site.b->V_WB[site.body];
  const bool stands = vec(V.v).isZero(0) && vec(V.w).isZero(0);
  tie.body_b = stands ? SWAGE_NONE : site.body;
  tie.p_W = raw(Vec3(vec(middle->p_W) + lever));
  tie.axis_W = raw(Vec3(advance.cross(lever).normalized()));
  tie.stiffness_along = stiffness * ratio * ratio;
  tie.forward_limit = tie.backward_limit = drag * ratio;
  tie.strength = HUGE_VAL;
  // stretched as in the last step, plus the predicted rolling
  const double rolls = vec(site.a->V_WB[middle->body].w).dot(advance) * site.a.dt() * lever.norm();
  const double stretch = -track.roll / (lever.norm() * tie.stiffness_along);
  tie.offset_W = raw(Vec3((stretch + rolls) * vec(tie.axis_W)));
  tie.f_a_W = raw(Vec3(track.roll / lever.norm() * vec(tie.axis_W)));
  return tie;
}

uint32_t make_ties(const Site& site, const Track& track, double reaction, double exit_force, swage_tie* out,
                   uint32_t* of) {
  uint32_t n = 0;
  double stiffness = 0, drag = 0, progress = 0;
  for (uint32_t i = 0; i < supports(track); ++i) {
    const Support& support = track.support[i];
    const NeedlePoint at = needle_at(site, support);
    progress = support.at + at.gone;  // the value of the last support counts
    if (!(support.share > 0)) continue;
    out[n] = support_tie(site, support, at);
    stiffness += out[n].stiffness_along, drag += out[n].backward_limit;
    if (i == 0) out[n].forward_limit += reaction;
    of[n++] = i;
  }
  if (stiffness > 0) {
    out[n] = roll_tie(site, track, stiffness, drag);
    of[n++] = Track::kOfRoll;
  }
  if (track.out != Track::kOut) {
    out[n] = front_tie(site, track, progress, exit_force);
    of[n++] = Track::kOfPoint;
  }
  return n;
}

/// Updates the displacement of the tissue: it is at the needle, less the stretch of the support.
void settle(const Site& site, Support& support) {
  const double k = site.law.side_stiffness * support.share;
  if (!(k > 0)) return;
  const double s = support.rest - support.along / (kStick * k) / site.length, on = std::clamp(s, 0.0, 1.0);
  const auto place = site.needle.place(site.a, on);
  if (!place) return;
  const Vec3 p_W = vec(place->p_W) + (s - on) * site.length * vec(place->tangent_W);
  const Vec3 gives = site.local(p_W) + vec3(support.across) / k - vec3(support.p);
  const Vec3 behind = gives - vec3(support.given);
  const double lag = std::min((1 - kFollow) * behind.norm(), kLag * site.radius);
  put(support.given, lag > 0 ? Vec3(gives - lag * behind.normalized()) : gives);
}

double take_tie(const Site& site, Track& track, const swage_tie& tie, uint32_t of) {
  const Vec3 axis_W = vec(tie.axis_W), slid = vec(tie.plastic_slip_W), f = vec(tie.f_a_W);
  const double along = axis_W.dot(slid);
  if (of == Track::kOfRoll) {
    track.roll = kLever * site.radius * axis_W.dot(f);
    return 0;
  }
  if (of == Track::kOfPoint) {
    const double force = track.cutting = -axis_W.dot(f);
    const bool gives = along > 0 && force >= (1 - 1e-9) * tie.forward_limit;
    if (track.out == Track::kBreaking) {
      track.peak_exit = std::max(track.peak_exit, force);
      if (gives) track.out = Track::kOut;
    }
    if (gives) {
      track.cut += along;
      track.progress = progress(site, track);
      set_front(site, track);
    }
    return 0;
  }
  Support& support = track.support[of];
  const Vec3 torn = slid - along * axis_W;
  support.rest += along / site.length;
  put(support.p, site.local(site.world(support.p) + torn));
  put(support.across, site.X_WO.q.conjugate() * (f - axis_W.dot(f) * axis_W));
  support.along = axis_W.dot(f);
  settle(site, support);
  support.rub *= std::exp(-std::abs(along) / (kEven * site.radius));
  return torn.norm() * support.share;
}

}  // namespace swage::coupling_pierce
