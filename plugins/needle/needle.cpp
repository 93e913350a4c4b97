// SPDX-License-Identifier: Apache-2.0
#include "needle.hpp"

#include <swage/plugin.hpp>

#include <array>
#include <bit>
#include <numbers>

namespace swage::needle {
namespace {

// A straight needle is an arc of a thousandth of a radian: its middle is off the chord by an eight-thousandth of its length, 0.6 um for
// 5 mm, and its radius is still so small that lengths of a micrometre are exact to ten digits.
constexpr double kStraightShare = 1e-3 / (2 * std::numbers::pi);
constexpr double kShare[] = {0, 1.0 / 4, 3.0 / 8, 1.0 / 2, 5.0 / 8, 2.0 / 8, 4.0 / 8, kStraightShare};

// Smallest radius of the circle in wire radii: a tighter bend could not be made, long before its inner side
// folds into itself.
constexpr double kTightest = 4;
// Thinnest wire, m: below it the contact compliances no longer hold for a wire.
constexpr double kThinnest = 20e-6;
// Shortest needle, m.
constexpr double kShortest = 0.5e-3;
// Factor in the number of pieces of the level `reference`.
constexpr int kFiner = 4;

void take(double given, double& value) {
  if (given > 0) value = given;
}

/// Compares bits: +0 and -0 differ.
bool same_bits(const swage_pose& a, const swage_pose& b) {
  constexpr size_t kWords = sizeof(swage_pose) / sizeof(uint64_t);
  using Words = std::array<uint64_t, kWords>;
  const auto x = std::bit_cast<Words>(a), y = std::bit_cast<Words>(b);
  uint64_t differ = 0;
  for (size_t i = 0; i < kWords; ++i) differ |= x[i] ^ y[i];
  return differ == 0;
}

}  // namespace

bool Needle::read_form(const NeedleParams& p, ObjectBuilder& builder) {
  form_ = {};
  if (!p.model.empty()) {
    const std::string wrong = read_model(p.model, form_);
    if (!wrong.empty()) builder.error("model", wrong);
  }
  if (p.arc != Circle::kModel) form_.share = kShare[static_cast<int>(p.arc)];
  if (p.size_of != SizeOf::kModel) form_.chord = p.size_of == SizeOf::kChord;
  take(p.size, form_.size);
  take(p.wire_diameter, form_.wire_diameter);
  take(p.taper_length, form_.taper_length);
  take(p.flattening, form_.flattening);
  take(p.swage_length, form_.swage_length);
  take(p.density, form_.material.density);
  take(p.youngs_modulus, form_.material.youngs);
  take(p.yield_stress, form_.material.yield);
  take(p.hardening, form_.material.hardening);
  take(p.break_strain, form_.material.break_strain);
  if (builder.failed()) return false;
  const std::string wrong = fault(form_);
  if (!wrong.empty()) builder.error("", wrong);
  arc_ = form_.arc();
  if (form_.size < kShortest) builder.error("size", "a needle is at least 0.5 mm long");
  if (form_.wire_diameter < kThinnest) builder.error("wire_diameter", "the wire is at least 20 um thick");
  if (arc_.radius < kTightest * arc_.wire_radius)
    builder.error(
        "size", "the needle is too short for so thick a wire: the bend needs a radius of two wire diameters");
  return !builder.failed();
}

void Needle::build(const NeedleParams& params, ObjectBuilder& builder) {
  bending_ = {};
  environment_ = environment(host());
  if (!read_form(params, builder)) return;

  // B: centre of mass, x away from the circle's centre, z normal to its plane. O: the same axes, in the
  // middle of the wire. A wire that is thicker towards one end has its principal axes turned a little
  const ArcMass m = mass_of(form_);
  mass_ = m.mass, inertia_ = m.principal_inertia();
  turn_B_ = toolkit::exp_rotation({0, 0, -m.principal()});
  centre_B_ = turn_B_ * Vec3(-m.centre, -m.along, 0);
  const toolkit::Pose X_OB(Vec3(m.centre - arc_.radius, m.along, 0), turn_B_.conjugate());
  if (params.level == Level::kRigid) {
    body_ = builder.dynamic_body("needle", {m.mass, toolkit::raw(m.principal_inertia())}, X_OB.abi());
    // the shape's arc starts on its own +x axis, which is therefore turned to the needle's point
    const toolkit::Pose X_BA(centre_B_, turn_B_ * toolkit::exp_rotation({0, 0, -0.5 * arc_.sweep}));
    builder.arc(body_, {X_BA.abi(), arc_.radius, arc_.sweep, arc_.wire_radius});
  } else {
    const int n = params.level == Level::kReference
                      ? std::min(kFiner * params.pieces, toolkit::BentWire::kMaxPieces)
                      : params.pieces;
    build_bending(n, X_OB, builder);
  }
  divide();
}

/// Body 0 has the frame B of a rigid needle and is the middle piece; the other bodies have their frames in the middles of their pieces.
void Needle::build_bending(int n, const toolkit::Pose& X_OB, ObjectBuilder& builder) {
  const toolkit::Pose X_OA(Vec3(-arc_.radius, 0, 0), toolkit::Quat::Identity());
  const auto X_OP = [&](int i) {
    const double s = (i + 0.5) / n;
    return X_OA * toolkit::Pose(place_at(arc_, s).p, toolkit::exp_rotation({0, 0, arc_.angle(s)}));
  };
  const toolkit::Pose X_BP = X_OB.inverse() * X_OP(n / 2);
  bending_.set_up(n, form_, X_BP);
  builder.state(bending_.n_state());

  const double sweep = bending_.piece_sweep();
  const toolkit::Pose X_PA(Vec3(-arc_.radius, 0, 0), toolkit::exp_rotation({0, 0, -0.5 * sweep}));
  std::vector<Body> bodies;
  for (uint32_t b = 0; b < static_cast<uint32_t>(n); ++b) {
    const int i = bending_.piece_of(b);
    const std::string body_name = b == 0 ? "needle" : "piece_" + std::to_string(i + 1);
    bodies.push_back(builder.flexible_body(body_name.c_str(), (b == 0 ? X_OB : X_OP(i)).abi()));
  }
  body_ = bodies[0];
  // several arcs of one object are one wire, in the order of their declaration
  for (int i = 0; i < n; ++i) {
    const toolkit::Pose X_BA = i == bending_.middle() ? X_BP * X_PA : X_PA;
    builder.arc(bodies[bending_.body_of(i)], {X_BA.abi(), arc_.radius, sweep, arc_.wire_radius});
  }
  stress_ = builder.signal("needle.stress", "1",
                           "Greatest bending moment along the wire over that of first yield.");
  bend_ = builder.signal("needle.bend", "rad", "Angles by which the wire stays bent, summed along it.");
  damage_ = builder.signal("needle.damage", "1",
                           "Plastic strain so far over what breaks it, where it is greatest.");
  broken_ = builder.signal("needle.broken", "1", "Number of places where it is broken.");
}

void Needle::reset(const Step& step) {
  if (bends()) bending_.reset(step);
}
void Needle::advance(const Step& step) {
  if (bends()) bending_.advance(step);
}
void Needle::mobility(const Step& step, std::span<const swage_contact_point> points, double* v_free,
                        double* W) {
  bending_.mobility(step, points, v_free, W);
}
void Needle::apply_impulses(const Step& step, std::span<const swage_contact_point> points, const double* impulse) {
  bending_.apply_impulses(step, points, impulse);
}

void Needle::finish(const Step& step) {
  if (!bends()) return;
  const Bending::Reading now = bending_.read(step);
  step.signal(stress_, now.stress);
  step.signal(bend_, now.bend);
  step.signal(damage_, now.damage);
  step.signal(broken_, now.broken);
}

void Needle::wire_end(const Step& step, swage_wire_end& out) {
  if (!bends()) return;
  const Bending::End end = bending_.end(step);
  out = {end.collapsed, end.broke};
}

const void* Needle::extension(std::string_view wanted) {
  return wanted == SWAGE_TRAIT_WIRE ? wire_table<Needle>() : nullptr;
}

/// Sets up the stretches of the wire, from the point on.
void Needle::divide() {
  const int n = std::max(1, bending_.pieces());
  for (int i = 0; i < n; ++i) {
    Stretch& wire = wire_[static_cast<size_t>(i)] = {};
    wire.arc = {arc_.radius, arc_.sweep / n, arc_.wire_radius};
    wire.s0 = static_cast<double>(i) / n, wire.s1 = (i + 1.0) / n;
    wire.body = bends() ? bending_.body_of(i) : 0;
  }
}

/// One piece of the wire as an arc about its own middle: queried dozens of times a step, it is computed once for each pose.
const Needle::Stretch& Needle::stretch(const Step& step, int i) {
  Stretch& wire = wire_[static_cast<size_t>(i)];
  const swage_pose& X = step->X_WB[wire.body];
  if (same_bits(X, wire.known)) return wire;
  wire.known = X;
  if (!bends()) {
    wire.X_WA = toolkit::Frame(toolkit::Pose(X) * toolkit::Pose(centre_B_, turn_B_));
  } else {
    wire.X_WA = toolkit::Frame(bending_.piece(step, i));
    wire.middle_W = wire.X_WA.p;
    wire.X_WA.p -= arc_.radius * wire.X_WA.R.col(0);
  }
  return wire;
}

Needle::Found Needle::nearest_on(const Stretch& wire, const Vec3& p_W) {
  return {&wire, nearest_place(wire.arc, wire.X_WA.inverse_times(p_W))};
}

/// The nearest place on any piece.
Needle::Found Needle::find_nearest(const Step& step, const Vec3& p_W) {
  if (!bends()) return nearest_on(stretch(step, 0), p_W);
  const int n = bending_.pieces();
  int nearest = 0;
  double least = 1e300;
  for (int i = 0; i < n; ++i) {
    // bodies have their origins in the middles of their pieces, but for the one whose body has the frame of the whole
    const uint32_t body = wire_[static_cast<size_t>(i)].body;
    const Vec3 middle_W = body == 0 ? stretch(step, i).middle_W : toolkit::vec(step->X_WB[body].p);
    const double d = (middle_W - p_W).squaredNorm();
    if (d < least) least = d, nearest = i;
  }
  // at an end of the piece its neighbour may be as near
  const Found best = nearest_on(stretch(step, nearest), p_W);
  const int beside = best.place.s <= 0 ? nearest - 1 : best.place.s >= 1 ? nearest + 1 : nearest;
  if (beside == nearest || beside < 0 || beside >= n) return best;
  const Found other = nearest_on(stretch(step, beside), p_W);
  return (other.p_W() - p_W).squaredNorm() < (best.p_W() - p_W).squaredNorm() ? other : best;
}

void Needle::locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) {
  const Found at = find_nearest(step, toolkit::vec(p_W));
  out.s = at.s();
  out.length = arc_.length();
  out.p_W = toolkit::raw(at.p_W());
  out.tangent_W = toolkit::raw(at.tangent_W());
  out.normal_W = toolkit::raw(Vec3(at.wire->X_WA.R.col(2)));
}

void Needle::place(const Step& step, double s, swage_piercing_place& out) {
  const int n = std::max(1, bending_.pieces());
  const Stretch& wire = stretch(step, std::clamp(static_cast<int>(s * n), 0, n - 1));
  tell({&wire, place_at(wire.arc, (s - wire.s0) / (wire.s1 - wire.s0))}, out);
}

void Needle::nearest(const Step& step, swage_vec3 p_W, swage_piercing_place& out) {
  tell(find_nearest(step, toolkit::vec(p_W)), out);
}

void Needle::tell(const Found& found, swage_piercing_place& out) const {
  out = {found.s(),
         arc_.length(),
         arc_.wire_radius,
         toolkit::raw(found.p_W()),
         toolkit::raw(found.tangent_W()),
         found.wire->body,
         0};
}

}  // namespace swage::needle

SWAGE_EXPORT(swage::needle::Needle)
