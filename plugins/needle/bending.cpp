// SPDX-License-Identifier: Apache-2.0
#include "bending.hpp"

#include <algorithm>
#include <cstring>
#include <numbers>

namespace swage::needle {

using toolkit::BentWire;
using toolkit::JointMemory;
using toolkit::Quat;
using toolkit::vec;

namespace {

// Plastic moment of a round section over that of first yield, and the share of it at which the section counts as plastic as a whole,
// since the limit is reached only at infinite curvature. At 0.995 the curvature is 4 to 5 times that of first yield.
constexpr double kPlastic = 16 / (3 * std::numbers::pi), kWhole = 0.995;

/// Rotation vector of a rotation within one step: of less than a degree or two by the series of the arc sine, else by the full formula.
Vec3 rotation_vector(const Quat& q) {
  const Vec3 v = q.w() < 0 ? Vec3(-q.vec()) : Vec3(q.vec());
  const double s2 = v.squaredNorm();
  return s2 < 4e-4 ? Vec3((2 + s2 * (1.0 / 3 + s2 * (3.0 / 20 + s2 * 5.0 / 56))) * v)
                   : toolkit::log_rotation(q);
}

}  // namespace

void Bending::set_up(int n, const Form& form, const Pose& X_B0P) {
  n_ = n;
  X_B0P_ = X_B0P;
  X_PB0_ = X_B0P.inverse();
  const Arc arc = form.arc();
  wire_ = BentWire(n, arc.radius, arc.sweep, form.material);
  for (int j = 0; j < n - 1; ++j) wire_.set_section(j, form.section((j + 1.0) / n, arc.length()));

  // each piece from the same integrals as the whole, about its own middle
  for (int i = 0; i < n; ++i) {
    const ArcMass m = mass_of(form, static_cast<double>(i) / n, (i + 1.0) / n);
    const double s = (i + 0.5) / n;
    const Pose X_AP(place_at(arc, s).p, toolkit::exp_rotation({0, 0, arc.angle(s)}));
    Mat3 I = m.inertia.asDiagonal();
    I(0, 1) = I(1, 0) = -m.product;
    const Mat3 R = X_AP.q.toRotationMatrix();
    own_[at(i)] = {m.mass, X_AP.inverse() * Vec3(m.centre, m.along, 0), R.transpose() * I * R};
  }

  known_.fill({});
  over_.fill(wire_.over(Vec3::Zero()));
  back_.fill(over_[0].inverse());
  before_known_ = 0, after_known_ = n - 1;
}

uint32_t Bending::n_state() const {
  const size_t bytes = sizeof(BendingState) + sizeof(JointMemory) * at(n_ - 1);
  return static_cast<uint32_t>(bytes / sizeof(double));
}

void Bending::reset(const Step& step) const {
  std::fill(step.state().begin(), step.state().end(), 0.0);
  state(step).base = middle();
}

Pose Bending::piece(const Step& step, int i) const {
  const Pose X(step->X_WB[body_of(i)]);
  return i == middle() ? X * X_B0P_ : X;
}

// --- free motion

Bending::Rigid Bending::Rigid::seen_from(const Pose& X_AB) const {
  const Mat3 R = X_AB.q.toRotationMatrix();
  Mat3 turned;
  turned.noalias() = R.lazyProduct(inertia);
  Rigid out{mass, X_AB.p + R * centre, Mat3::Zero()};
  out.inertia.noalias() = turned.lazyProduct(R.transpose());
  return out;
}

Bending::Rigid Bending::Rigid::with(const Rigid& other) const {
  Rigid both;
  both.mass = mass + other.mass;
  both.centre = (mass * centre + other.mass * other.centre) / both.mass;
  // parallel axis theorem: both about their common centre of mass
  const Vec3 d = other.centre - centre;
  const Mat3 apart = d.squaredNorm() * Mat3::Identity() - d * d.transpose();
  both.inertia = inertia + other.inertia + mass * other.mass / both.mass * apart;
  return both;
}

/// Updates the results that depend on joint rotations, for joints that have turned.
void Bending::follow_joints(const JointMemory* memory) {
  for (int j = 0; j < n_ - 1; ++j) {
    JointMemory& known = known_[at(j)];
    moved_[at(j)] = std::memcmp(known.turn, memory[j].turn, sizeof known.turn) != 0;
    if (!moved_[at(j)]) continue;
    std::copy_n(memory[j].turn, 3, known.turn);
    over_[at(j)] = wire_.over(BentWire::turn(known));
    back_[at(j)] = over_[at(j)].inverse();
    before_known_ = std::min(before_known_, j);
    after_known_ = std::max(after_known_, j + 1);
  }
}

/// Mass, centre and inertia of the whole with its pieces at X0_, summed in the frame of the piece `root`.
Bending::Rigid Bending::weigh(int root) {
  for (; before_known_ < root; ++before_known_) {
    const size_t i = at(before_known_);
    before_[i + 1] = (i > 0 ? before_[i].with(own_[i]) : own_[i]).seen_from(back_[i]);
  }
  for (; after_known_ > root; --after_known_) {
    const size_t i = at(after_known_);
    after_[i - 1] = (after_known_ < n_ - 1 ? after_[i].with(own_[i]) : own_[i]).seen_from(over_[i - 1]);
  }
  Rigid whole = own_[at(root)];
  if (root > 0) whole = whole.with(before_[at(root)]);
  if (root < n_ - 1) whole = whole.with(after_[at(root)]);
  return whole.seen_from(X0_[at(root)]);
}

/// Takes the wrenches of other objects on the pieces: they move the whole, and bend it where contacts hold it.
void Bending::take_loads(const Step& step, const Rigid& start) {
  n_load_ = 0;
  const double h = step.dt();
  for (int i = 0; i < n_; ++i) {
    const swage_wrench& F = step->F_B_W[body_of(i)];
    const Vec3 f = vec(F.f), t = vec(F.t);
    if (f.isZero(0) && t.isZero(0)) continue;
    const Vec3 p = i == middle() ? X0_WB0_.p : X0_[at(i)].p;
    push_[at(n_load_++)] = {i, f, t, p};
    free_.v += h / start.mass * f;
    L_start_ += h * (t + (p - start.centre).cross(f));
  }
}

/// Free motion without contacts: falls, and rotates with constant angular momentum (midpoint rule, order 2).
void Bending::fly(const Step& step, const Rigid& start) {
  const double h = step.dt();
  L_start_ = vec3(state(step).L);
  free_.v = vec3(state(step).v) + h * vec(step.gravity());
  take_loads(step, start);
  const Mat3 inverse = start.inertia.inverse();
  const Vec3 L = vec3(state(step).L);
  free_.w = inverse * L;
  constexpr double kSettled = 1e-28;  // of the square, relative: a small rotation has converged at once
  for (int i = 0; i < 3; ++i) {
    const Mat3 half = toolkit::exp_rotation(0.5 * h * free_.w).toRotationMatrix();
    const Vec3 w = half * (inverse * (half.transpose() * L));
    const bool settled = (w - free_.w).squaredNorm() <= kSettled * w.squaredNorm();
    free_.w = w;
    if (settled) break;
  }
}

/// Angular velocity due to the loads, with the inertia that the contact solve uses: contacts balance the loads within the step, and a
/// thin wire has 2600 times less inertia about itself than across, so that the smallest rotation between the two inertias would turn a
/// balanced couple about the wire into one across it.
void Bending::spin_by_loads(const Step& step) {
  if (n_load_ > 0) free_.w += inverse_ * (L_start_ - vec3(state(step).L));
}

/// Moves all pieces with one rigid motion.
void Bending::carry(const Step& step, const Twist& V, const Rigid& start) {
  const double h = step.dt();
  const Quat turn = toolkit::exp_rotation(h * V.w);
  const Mat3 R = turn.toRotationMatrix();
  whole_.mass = start.mass;
  whole_.centre = start.centre + h * V.v;
  whole_.inertia = R * start.inertia * R.transpose();
  inverse_ = whole_.inertia.inverse();
  expected_ = V;
  as_one_ = true;
  back_W_ = R.transpose();
  for (int i = 0; i < n_; ++i) {
    const Pose& X0 = X0_[at(i)];
    X_[at(i)] = {whole_.centre + R * (X0.p - start.centre), turn * X0.q};
    renormalise(X_[at(i)].q);
  }
}

/// Without forces each joint returns to its permanent angle. Two iterations, because layers of the section may yield in reverse.
void Bending::relax(const Step& step) const {
  JointMemory* memory = joints(step);
  for (int j = 0; j < n_ - 1; ++j)
    for (int k = 0; k < 2; ++k) {
      const Vec3 m = BentWire::moment(memory[j]);
      if (m.isZero(0)) break;
      wire_.bend(j, wire_.answer(j, Vec3::Zero(), wire_.elastic(j), true, memory[j]), memory[j]);
    }
}

/// Poses of all pieces from that of one, with the joint rotations of the last follow_joints().
void Bending::place(int base, const Pose& X_WP) {
  X_[at(base)] = X_WP;
  for (int j = base; j < n_ - 1; ++j) {
    X_[at(j + 1)] = X_[at(j)] * over_[at(j)];
    renormalise(X_[at(j + 1)].q);
  }
  for (int j = base - 1; j >= 0; --j) {
    X_[at(j)] = X_[at(j + 1)] * back_[at(j)];
    renormalise(X_[at(j)].q);
  }
}

/// Writes poses and twists to the host. Beyond a joint that has not turned, a piece has the angular velocity of the piece before it.
void Bending::write(const Step& step, int base) const {
  const auto spin = [&](int i) {
    return Vec3(rotation_vector(X_[at(i)].q * X0_[at(i)].q.conjugate()) / step.dt());
  };
  const Vec3 w_base = spin(base);
  write_piece(step, base, w_base);
  Vec3 w = w_base;
  for (int i = base + 1; i < n_; ++i) write_piece(step, i, moved_[at(i - 1)] ? w = spin(i) : w);
  w = w_base;
  for (int i = base - 1; i >= 0; --i) write_piece(step, i, moved_[at(i)] ? w = spin(i) : w);
}

void Bending::write_piece(const Step& step, int i, const Vec3& w_W) const {
  const bool carrier = i == middle();
  const Pose X = carrier ? X_[at(i)] * X_PB0_ : X_[at(i)];
  const Vec3& p0 = carrier ? X0_WB0_.p : X0_[at(i)].p;
  step->X_WB[body_of(i)] = X.abi();
  step->V_WB[body_of(i)] = {toolkit::raw(Vec3((X.p - p0) / step.dt())), toolkit::raw(w_W)};
}

/// Body of the middle piece or of the base: the one that spins less. An arm that springs back, or that a thread jerks at, is not held.
uint32_t Bending::calmer(const Step& step) const {
  const uint32_t base = body_of(static_cast<int>(state(step).base));
  return vec(step->V_WB[base].w).squaredNorm() < vec(step->V_WB[0].w).squaredNorm() ? base : 0;
}

/// Predicts the motion without contacts. A held needle is predicted to continue its motion, so that contacts are detected where they will
/// be; a free one springs back and flies.
void Bending::advance(const Step& step) {
  BendingState& s = state(step);
  if (s.answered == 0) s.held = 0;
  s.answered = 0;
  peak_ = 0;
  X0_WB0_ = Pose(step->X_WB[0]);
  for (int i = 0; i < n_; ++i) X0_[at(i)] = piece(step, i);
  follow_joints(joints(step));
  moved_.fill(false);
  const Rigid start = weigh(static_cast<int>(s.base));
  fly(step, start);
  if (s.held != 0) {
    const uint32_t calm = calmer(step);
    const Vec3 w = vec(step->V_WB[calm].w), arm = start.centre - vec(step->X_WB[calm].p);
    carry(step, {vec(step->V_WB[calm].v) + w.cross(arm), w}, start);
    spin_by_loads(step);
    put(whole_.inertia * w, s.L);
  } else {
    inverse_ = start.inertia.inverse();
    spin_by_loads(step);
    carry(step, free_, start);
    put(L_start_, s.L);
    const JointMemory* memory = joints(step);
    const bool bent = std::any_of(memory, memory + n_ - 1,
                                  [](const JointMemory& j) { return !BentWire::moment(j).isZero(0); });
    if (bent) {
      relax(step);
      follow_joints(memory);
      place(middle(), Pose(X_[at(middle())]));
      as_one_ = false;
    }
  }
  put(expected_.v, s.v);
  write(step, middle());
}

Bending::Reading Bending::read(const Step& step) const {
  const JointMemory* memory = joints(step);
  Reading out;
  // statics has no limit: a section bears at most its plastic moment, and hardening is included in the joints
  out.stress = std::min(peak_, kPlastic);
  for (int j = 0; j < n_ - 1; ++j) {
    if (BentWire::moment(memory[j]).isZero(0) && BentWire::path(memory[j]) == 0) continue;
    out.stress = std::max(out.stress, wire_.stress(j, memory[j]));
    out.bend += wire_.residual(j, memory[j]).norm();
    out.damage = std::max(out.damage, std::min(1.0, wire_.damage(memory[j])));
    out.broken += memory[j].broken;
  }
  return out;
}

Bending::End Bending::end(const Step& step) const {
  constexpr int kBoth = 3;
  const JointMemory* memory = joints(step);
  BendingState& s = state(step);
  const int told = static_cast<int>(s.told);
  End out;
  if (told == kBoth) return out;
  for (int j = 0; j < n_ - 1; ++j) {
    const double where = (j + 1.0) / n_;
    if ((told & 1) == 0 && out.collapsed < 0 && wire_.stress(j, memory[j]) >= kWhole * kPlastic) out.collapsed = where;
    if ((told & 2) == 0 && out.broke < 0 && memory[j].broken != 0) out.broke = where;
  }
  s.told = told | (out.collapsed < 0 ? 0 : 1) | (out.broke < 0 ? 0 : 2);
  return out;
}

}  // namespace swage::needle
