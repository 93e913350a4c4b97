// SPDX-License-Identifier: Apache-2.0
#include "passage.hpp"

#include <algorithm>
#include <cmath>

namespace swage::coupling_pull_through {

using toolkit::raw;
using toolkit::vec;

namespace {

// In thread radii: smallest length that a hole represents.
constexpr double kLeast = 2;
// Relaxation: share of the change of the tissue's displacement that `given` follows per step, as for a needle (coupling_pierce/track.cpp).
constexpr double kFollow = 0.4;
// Bisections that find the crossing with a surface: to 1e-6 of the searched length.
constexpr int kHalvings = 20;
// Largest number of steps outwards in the search for the surface, and their length in thread radii: 5 mm of 10-0.
constexpr int kLooks = 48;
constexpr double kLook = 10;
// In thread radii: chord for the direction of the thread at a hole: 10-0 under 1 mN bends over sqrt(EI/T) = 0.17 mm, 15 radii,
// to either side of an edge. At 0 a corner between two straight segments could not pass a hole, as the direction jumps there.
constexpr double kBend = 30;
// In thread radii: on a straight segment the place is exact to rounding; a larger residual means that it is at a corner.
constexpr double kAtOnce = 1e-3;
// Relaxation in the search at a corner between two segments: with 1 the iteration overshoots at a sharp corner.
constexpr double kPart = 0.7;

void put(double* to, const Vec3& a) {
  for (int i = 0; i < 3; ++i) to[i] = a[i];
}
Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }

double stiffness(const PassageLaw& law, const Hole& hole) { return law.side_stiffness * hole.share; }

/// Makes a hole represent more length at the same force: its stretch becomes smaller, and so does the stored energy.
void grow(const PassageLaw& law, Hole& hole, double share) {
  if (share <= hole.share) return;
  if (hole.share > 0) {
    const double less = 1 / stiffness(law, hole) - 1 / (law.side_stiffness * share);
    put(hole.p, vec3(hole.p) - less * vec3(hole.across));
    hole.rest -= less / Passage::kStick * hole.along;
  }
  hole.share = share;
}

/// Finds where the thread crosses a surface between two places, one inside (`in`) and one outside (`out`) of the tissue.
Site::Place crossing(const Site& site, double in, double out, Vec3& normal_W) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (in + out);
    (site.inside(site.place(middle).p_W, normal_W) > 0 ? in : out) = middle;
  }
  const Site::Place at = site.place(in);
  site.inside(at.p_W, normal_W);
  return at;
}

Hole make_hole(const Site& site, const Site::Place& at, const Vec3& normal_W) {
  Hole hole{};
  put(hole.p, site.local(at.p_W));
  put(hole.first, vec3(hole.p));
  put(hole.normal, site.X_WO.q.conjugate() * normal_W);
  hole.u = hole.rest = at.u;
  hole.share = kLeast * site.strand.radius;
  return hole;
}

/// Lets the end into the tissue: the entry is before the thread's first place outside.
bool go_in(const Site& site, Passage& passage) {
  const double look = kLook * site.strand.radius;
  for (int i = 1; i <= kLooks; ++i) {
    Vec3 n = Vec3::Zero();
    if (site.inside(site.place(i * look).p_W, n) > 0) continue;
    const Site::Place at = crossing(site, (i - 1) * look, i * look, n);
    passage = {};
    passage.count = 1;
    passage.hole[0] = make_hole(site, at, n);
    return true;
  }
  return false;
}

void remove(Passage& passage, uint32_t i) {
  std::copy(passage.hole + i + 1, passage.hole + passage.holes(), passage.hole + i);
  passage.count -= 1;
}

}  // namespace

double Passage::inside() const {
  if (count == 0) return 0;
  return std::max(0.0, hole[0].u - (out != 0 ? hole[holes() - 1].u : 0));
}

Site::Site(const StrandPeer& pa, const Peer& pb, const Step& step_a, const Step& step_b, bool last)
    : thread(pa), tissue(pb), a(step_a), b(step_b), last_leads(last) {
  const auto of_thread = thread.law(a);
  const auto of_tissue = tissue.law(b);
  if (!of_thread || !of_tissue) return;
  strand = *of_thread, law = *of_tissue;
  const auto end = thread.place(a, last ? strand.length : 0);
  if (!end) return;
  const auto in = tissue.inside(b, end->p_W);
  if (!in || in->body >= b->n_body) return;
  body = in->body;
  X_WO = Pose(b->X_WB[body]);
  good = true;
}

Site::Place Site::place(double u) const {
  const double s = std::clamp(u, 0.0, strand.length);
  const auto at = thread.place(a, last_leads ? strand.length - s : s);
  Place out;
  if (!at) return out;
  // beyond its ends the thread is continued by straight lines
  out.advance_W = (last_leads ? 1.0 : -1.0) * vec(at->tangent_W);
  out.p_W = vec(at->p_W) - (u - s) * out.advance_W;
  out.u = u, out.tension = at->tension, out.body = at->body, out.good = true;
  return out;
}

Vec3 Site::way(double u) const {
  const double half = 0.5 * kBend * strand.radius;
  const Vec3 chord = place(u - half).p_W - place(u + half).p_W;
  const double length = chord.norm();
  return length > half ? Vec3(chord / length) : place(u).advance_W;  // a thread that is folded back on itself has no chord direction there
}

Site::Place Site::near(double u, const Vec3& p_W) const {
  const auto off = [&](const Place& at, const Vec3& way_W) { return way_W.dot(p_W - at.p_W); };
  Place at = place(u);
  for (int i = 0; i < 4; ++i) at = place(at.u - off(at, at.advance_W));
  if (std::abs(off(at, at.advance_W)) < kAtOnce * strand.radius) return at;
  // no place on either segment: it is at the corner between them, where the direction turns from one to the other
  for (int i = 0; i < 12; ++i) at = place(at.u - kPart * off(at, way(at.u)));
  at.advance_W = way(at.u);
  return at;
}

double Site::inside(const Vec3& p_W, Vec3& normal_W) const {
  const auto in = tissue.inside(b, raw(p_W));
  if (!in) return -1;
  const Vec3 n = vec(in->normal_W);
  const double depth = in->depth, to_far = -in->beyond, edge = in->edge;
  normal_W = depth <= to_far ? n : Vec3(-n);
  return std::min({depth, to_far, edge});
}

Spot spot(const Site& site, const Hole& hole) {
  Spot out;
  const Vec3 p_O = vec3(hole.p) + vec3(hole.given);
  out.at = site.near(hole.u, site.world(p_O.data()));
  out.gone = out.at.u + out.at.advance_W.dot(toolkit::rotated(site.X_WO.q, vec3(hole.given)));
  return out;
}

bool lie_through(const Site& site, Passage& passage) {
  const double look = kLook * site.strand.radius;
  const int looks = static_cast<int>(site.strand.length / look);
  int first = -1, last = -1;
  Vec3 n = Vec3::Zero();
  for (int i = 0; i <= looks; ++i) {
    if (!(site.inside(site.place(i * look).p_W, n) > 0)) continue;
    if (first < 0) first = i;
    last = i;
  }
  if (first < 1 || last == looks) return false;
  passage = {};
  const Site::Place in = crossing(site, last * look, (last + 1) * look, n);
  passage.hole[0] = make_hole(site, in, n);
  const Site::Place out = crossing(site, first * look, (first - 1) * look, n);
  passage.hole[1] = make_hole(site, out, n);
  passage.count = 2, passage.out = 1;
  for (Hole& hole : passage.hole) hole.share = std::max(hole.share, 0.5 * passage.inside());
  return true;
}

Change follow(const Site& site, Passage& passage, const PassageLaw& law, double from) {
  Vec3 n = Vec3::Zero();
  const double inside = site.inside(site.place(0).p_W, n);
  if (passage.count == 0) return inside > from && go_in(site, passage) ? Change::kWentIn : Change::kNone;
  for (uint32_t i = 0; i < passage.holes(); ++i) passage.hole[i].u = spot(site, passage.hole[i]).at.u;

  // drawn through to its other end, or back out of the entry
  while (passage.count > 0 && passage.hole[0].u > site.strand.length) {
    remove(passage, 0);
    if (passage.count == 0) return Change::kIsThrough;
  }
  while (passage.count > 0 && passage.hole[passage.holes() - 1].u < 0) {
    remove(passage, passage.holes() - 1);
    passage.out = 0;
    if (passage.count == 0) return Change::kWentBack;
  }
  // each hole represents half of the length inside; the other half of the length behind the leading end is held by the needle
  for (uint32_t i = 0; i < passage.holes(); ++i) grow(law, passage.hole[i], 0.5 * passage.inside());
  if (passage.out != 0 || passage.count > 1 || inside >= 0 || passage.hole[0].u < kLeast * site.strand.radius) return Change::kNone;
  passage.hole[1] = make_hole(site, crossing(site, passage.hole[0].u, 0, n), n);
  passage.count = 2, passage.out = 1;
  grow(law, passage.hole[1], 0.5 * passage.inside());
  return Change::kCameOut;
}

swage_tie tie_of(const Site& site, const PassageLaw& law, const Passage& passage, uint32_t i) {
  const Hole& hole = passage.hole[i];
  const Spot at = spot(site, hole);
  const Vec3 advance = at.at.advance_W, way = at.at.p_W - site.world(hole.p), across = way - advance.dot(way) * advance;
  swage_tie tie{};
  tie.body_a = at.at.body, tie.body_b = site.body;
  tie.p_W = raw(at.at.p_W);
  tie.axis_W = raw(advance);
  tie.offset_W = raw(Vec3(across + (at.gone - hole.rest) * advance));
  tie.stiffness_across = stiffness(law, hole);
  tie.stiffness_along = Passage::kStick * tie.stiffness_across;
  tie.strength = law.failure_stress * 2 * site.strand.radius * hole.share;
  tie.forward_limit = tie.backward_limit = 0.5 * law.drag * passage.inside() + law.friction * vec3(hole.across).norm();
  tie.f_a_W = raw(Vec3(site.X_WO.q * vec3(hole.across) + hole.along * advance));
  return tie;
}

double take_tie(const Site& site, const PassageLaw& law, const swage_tie& tie, Hole& hole) {
  const Vec3 axis_W = vec(tie.axis_W), slid = vec(tie.plastic_slip_W), f = vec(tie.f_a_W);
  const double along = axis_W.dot(slid), k = stiffness(law, hole);
  const Vec3 across_W = f - axis_W.dot(f) * axis_W;
  hole.rest += along;
  hole.along = axis_W.dot(f);
  // torn: the force is at its limit; sawn: sliding removes tissue on which the thread bears, and the force on it
  Vec3 torn_O = site.X_WO.q.conjugate() * (slid - along * axis_W), across = site.X_WO.q.conjugate() * across_W;
  const double bears = across.norm();
  if (bears > 0 && k > 0 && tie.strength > 0) {
    const double sawn = std::min(bears / k, law.saw * std::abs(along) * bears / tie.strength);
    torn_O -= sawn / bears * across;
    across *= 1 - sawn * k / bears;
  }
  put(hole.p, vec3(hole.p) + torn_O);
  put(hole.across, across);
  // displacement of the tissue: it is at the thread, less the stretch of the hole
  if (k > 0) {
    const Site::Place at = site.place(hole.rest - hole.along / (Passage::kStick * k));
    const Vec3 gives = site.local(at.p_W) + across / k - vec3(hole.p);
    put(hole.given, vec3(hole.given) + kFollow * (gives - vec3(hole.given)));
  }
  hole.cut += torn_O.norm();
  return torn_O.norm();
}

void begin_here(Hole& hole) {
  put(hole.first, vec3(hole.p));
  hole.cut = 0;
}

}  // namespace swage::coupling_pull_through
