// SPDX-License-Identifier: Apache-2.0
#include "bending.hpp"

#include <algorithm>

namespace swage::needle {

using toolkit::BentWire;
using toolkit::JointMemory;
using toolkit::Quat;
using toolkit::skew;
using toolkit::vec;

namespace {

Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }
void put(const Vec3& a, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = a[i];
}

/// Rotation vector of what turned by less than a degree or two within a step, by the series of the arc sine; else in full.
Vec3 rotation_vector(const Quat& q) {
  const Vec3 v = q.w() < 0 ? Vec3(-q.vec()) : Vec3(q.vec());
  const double s2 = v.squaredNorm();
  return s2 < 4e-4 ? Vec3((2 + s2 * (1.0 / 3 + s2 * (3.0 / 20 + s2 * 5.0 / 56))) * v)
                   : toolkit::log_rotation(q);
}

/// Twist that leads from X0 to X within h.
swage_twist twist(const Pose& X0, const Pose& X, double h) {
  return {toolkit::raw(Vec3((X.p - X0.p) / h)),
          toolkit::raw(Vec3(rotation_vector(X.q * X0.q.conjugate()) / h))};
}

}  // namespace

void Bending::set_up(int n, const Form& form, const Pose& X_B0P) {
  n_ = n;
  X_B0P_ = X_B0P;
  X_PB0_ = X_B0P.inverse();
  const Arc arc = form.arc();
  wire_ = BentWire(n, arc.radius, arc.sweep, form.material);
  for (int j = 0; j < n - 1; ++j) wire_.set_section(j, form.section((j + 1.0) / n, arc.length()));

  // each piece from the same integrals as the whole, seen from its own middle
  for (int i = 0; i < n; ++i) {
    const ArcMass m = mass_of(form, static_cast<double>(i) / n, (i + 1.0) / n);
    const double s = (i + 0.5) / n;
    const Pose X_AP(place_at(arc, s).p, toolkit::exp_rotation({0, 0, arc.angle(s)}));
    Mat3 I = m.inertia.asDiagonal();
    I(0, 1) = I(1, 0) = -m.product;
    const Mat3 R = X_AP.q.toRotationMatrix();
    own_[at(i)] = {m.mass, X_AP.inverse() * Vec3(m.centre, m.along, 0), R.transpose() * I * R};
  }
  G_.resize(at(kMaxPoints * (n - 1)));
  GF_.resize(G_.size());
}

uint32_t Bending::n_state() const {
  const size_t bytes = sizeof(BendingState) + sizeof(JointMemory) * at(n_ - 1);
  return static_cast<uint32_t>(bytes / sizeof(double));
}

void Bending::reset(const Step& step) const { std::fill(step.state().begin(), step.state().end(), 0.0); }

Pose Bending::piece(const Step& step, int i) const {
  const Pose X(step->X_WB[body_of(i)]);
  return i == middle() ? X * X_B0P_ : X;
}

// --- free motion

/// Mass, centre and inertia of the whole with its pieces at X_.
Bending::Rigid Bending::weigh() const {
  Rigid whole;
  std::array<Vec3, kMax> centre;
  for (int i = 0; i < n_; ++i) {
    centre[at(i)] = X_[at(i)] * own_[at(i)].centre;
    whole.mass += own_[at(i)].mass;
    whole.centre += own_[at(i)].mass * centre[at(i)];
  }
  whole.centre /= whole.mass;
  for (int i = 0; i < n_; ++i) {
    const Rigid& own = own_[at(i)];
    const Mat3 R = X_[at(i)].q.toRotationMatrix();
    const Vec3 d = centre[at(i)] - whole.centre;
    whole.inertia += R * own.inertia * R.transpose();
    whole.inertia += own.mass * (d.squaredNorm() * Mat3::Identity() - d * d.transpose());
  }
  return whole;
}

/// Without contacts: falls, and turns with its angular momentum kept (midpoint rule, order 2).
void Bending::fly(const Step& step, const Rigid& start) {
  const double h = step.dt();
  free_.v = vec3(state(step).v) + h * vec(step.gravity());
  const Mat3 inverse = start.inertia.inverse();
  free_.w = inverse * L_start_;
  for (int i = 0; i < 3; ++i) {
    const Mat3 half = toolkit::exp_rotation(0.5 * h * free_.w).toRotationMatrix();
    free_.w = half * (inverse * (half.transpose() * L_start_));
  }
}

/// All pieces along with a rigid motion.
void Bending::carry(const Step& step, const Twist& V, const Rigid& start) {
  const double h = step.dt();
  const Quat turn = toolkit::exp_rotation(h * V.w);
  const Mat3 R = turn.toRotationMatrix();
  whole_.mass = start.mass;
  whole_.centre = start.centre + h * V.v;
  whole_.inertia = R * start.inertia * R.transpose();
  inverse_ = whole_.inertia.inverse();
  expected_ = V;
  for (int i = 0; i < n_; ++i) {
    const Pose& X0 = X0_[at(i)];
    X_[at(i)] = {whole_.centre + R * (X0.p - start.centre), (turn * X0.q).normalized()};
  }
}

/// Without forces each joint goes back to what it keeps. Twice, because layers of the section may flow back on the way.
void Bending::relax(const Step& step) const {
  JointMemory* memory = joints(step);
  for (int j = 0; j < n_ - 1; ++j)
    for (int k = 0; k < 2; ++k) {
      const Vec3 m = BentWire::moment(memory[j]);
      if (m.isZero(0)) break;
      wire_.bend(j, wire_.answer(j, Vec3::Zero(), wire_.elastic(j), true, memory[j]), memory[j]);
    }
}

void Bending::write(const Step& step) const {
  for (int i = 0; i < n_; ++i) {
    const bool carrier = i == middle();
    const Pose X0 = carrier ? X0_[at(i)] * X_PB0_ : X0_[at(i)], X = carrier ? X_[at(i)] * X_PB0_ : X_[at(i)];
    step->X_WB[body_of(i)] = X.abi();
    step->V_WB[body_of(i)] = twist(X0, X, step.dt());
  }
}

/// As if nothing touched it. Held, it is expected to go on as it went, so that contacts are looked for where they will be;
/// free, it springs back and flies.
void Bending::advance(const Step& step) {
  BendingState& s = state(step);
  if (s.answered == 0) s.held = 0;
  s.answered = 0;
  for (int i = 0; i < n_; ++i) X0_[at(i)] = X_[at(i)] = piece(step, i);
  const Rigid start = weigh();
  L_start_ = vec3(s.L);
  fly(step, start);
  if (s.held != 0) {
    const swage_twist& V = step->V_WB[0];
    const Vec3 w = vec(V.w), arm = start.centre - vec(step->X_WB[0].p);
    carry(step, {vec(V.v) + w.cross(arm), w}, start);
    put(whole_.inertia * w, s.L);
  } else {
    carry(step, free_, start);
    const JointMemory* memory = joints(step);
    const bool bent = std::any_of(memory, memory + n_ - 1,
                                  [](const JointMemory& j) { return !BentWire::moment(j).isZero(0); });
    if (bent) {
      relax(step);
      wire_.place(middle(), X_[at(middle())], memory, X_.data());
    }
  }
  put(expected_.v, s.v);
  write(step);
}

// --- contacts

/// Which joints lie between the points and the piece that carries, how the points move with them, and how they give.
void Bending::collect(const Step& step, std::span<const swage_contact_point> points) {
  const JointMemory* memory = joints(step);
  n_touch_ = std::min(static_cast<int>(points.size()), kMaxPoints);
  base_ = piece_of(points[0].body);
  low_ = high_ = base_;
  for (int a = 0; a < n_touch_; ++a) {
    Touch& t = touch_[at(a)];
    t.piece = piece_of(points[at(a)].body);
    t.low = std::min(base_, t.piece), t.high = std::max(base_, t.piece);
    t.p_W = vec(points[at(a)].p_W);
    t.arm_W = t.p_W - whole_.centre;
    t.turn = inverse_ * skew(t.arm_W);
    low_ = std::min(low_, t.low), high_ = std::max(high_, t.high);
  }
  for (int j = low_; j < high_; ++j) {
    joint_[at(j)] = wire_.joint_frame(X_[at(j)], memory[j]);
    flows_[at(j)] = wire_.flexibility(j, memory[j], F_[at(j)]);
  }
  for (int a = 0; a < n_touch_; ++a)
    for (int j = touch_[at(a)].low; j < touch_[at(a)].high; ++j) {
      Mat3& G = G_[pair(a, j)];
      G = BentWire::gain(j, joint_[at(j)], base_, touch_[at(a)].piece, touch_[at(a)].p_W);
      GF_[pair(a, j)] = G * F_[at(j)];
    }
}

/// From where the point came to where it is now, and on from there without forces: as a rigid body, and springing back.
Vec3 Bending::free_velocity(int point, const JointMemory* memory, double h) const {
  const Touch& t = touch_[at(point)];
  const Pose &X0 = X0_[at(t.piece)], &X = X_[at(t.piece)];
  const Vec3 before = X0 * (X.q.conjugate() * (t.p_W - X.p));
  Vec3 v = (t.p_W - before) / h + (free_.v - expected_.v) + (free_.w - expected_.w).cross(t.arm_W);
  for (int j = t.low; j < t.high; ++j) v -= GF_[pair(point, j)] * BentWire::moment(memory[j]) / h;
  return v;
}

/// Velocity of point a per impulse at b.
Mat3 Bending::mobility(int a, int b, double h) const {
  const Touch &ta = touch_[at(a)], &tb = touch_[at(b)];
  Mat3 W;
  for (int k = 0; k < 3; ++k) W.col(k) = tb.turn.col(k).cross(ta.arm_W);
  W.diagonal().array() += 1 / whole_.mass;
  const int low = std::max(ta.low, tb.low), high = std::min(ta.high, tb.high);
  const double per_hh = 1 / (h * h);
  for (int j = low; j < high; ++j)
    W.noalias() += (per_hh * GF_[pair(a, j)]).lazyProduct(G_[pair(b, j)].transpose());
  return W;
}

void Bending::compliance(const Step& step, std::span<const swage_contact_point> points, double* v_free,
                         double* W) {
  state(step).answered = 1;
  collect(step, points);
  const size_t n = 3 * points.size();
  for (int a = 0; a < n_touch_; ++a) {
    put(free_velocity(a, joints(step), step.dt()), v_free + 3 * a);
    for (int b = 0; b <= a; ++b) {
      const Mat3 block = mobility(a, b, step.dt());
      for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) {
          const double w = block(static_cast<int>(i), static_cast<int>(k));
          W[(3 * at(a) + i) * n + 3 * at(b) + k] = W[(3 * at(b) + k) * n + 3 * at(a) + i] = w;
        }
    }
  }
}

void Bending::yield(const Step& step, std::span<const swage_contact_point>, const double* impulse) {
  const double h = step.dt();
  JointMemory* memory = joints(step);
  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
  std::array<Vec3, kMax> m;
  std::fill_n(m.begin(), n_, Vec3::Zero());
  bool touched = false;
  for (int a = 0; a < n_touch_; ++a) {
    const Vec3 j_W = vec3(impulse + 3 * a);
    if (j_W.isZero(0)) continue;
    touched = true;
    sum += j_W;
    moment += touch_[at(a)].arm_W.cross(j_W);
    for (int j = touch_[at(a)].low; j < touch_[at(a)].high; ++j)
      m[at(j)] += G_[pair(a, j)].transpose() * j_W / h;
  }

  // the shape: joints that no contact reaches bear nothing
  for (int j = 0; j < n_ - 1; ++j) {
    const bool reached = low_ <= j && j < high_;
    if (m[at(j)].isZero(0) && BentWire::moment(memory[j]).isZero(0)) continue;
    const Vec3 by = reached ? wire_.answer(j, m[at(j)], F_[at(j)], flows_[at(j)], memory[j])
                            : wire_.answer(j, m[at(j)], wire_.elastic(j), true, memory[j]);
    wire_.bend(j, by, memory[j]);
  }

  // the whole: its centre and the piece that carries go as a rigid body
  BendingState& s = state(step);
  const Vec3 v = free_.v + sum / whole_.mass, w = free_.w + inverse_ * moment;
  const Vec3 centre = whole_.centre - h * expected_.v;
  const Pose& X0 = X0_[at(base_)];
  const Quat turn = toolkit::exp_rotation(h * w);
  wire_.place(base_, Pose(centre + h * v + turn * (X0.p - centre), (turn * X0.q).normalized()), memory,
              X_.data());
  write(step);
  put(v, s.v);
  put(Vec3(L_start_ + moment), s.L);
  s.held = touched ? 1 : 0;
}

Bending::Reading Bending::read(const Step& step) const {
  const JointMemory* memory = joints(step);
  Reading out;
  for (int j = 0; j < n_ - 1; ++j) {
    out.stress = std::max(out.stress, wire_.stress(j, memory[j]));
    out.bend += wire_.residual(j, memory[j]).norm();
    out.damage = std::max(out.damage, std::min(1.0, wire_.damage(memory[j])));
    out.broken += memory[j].broken;
  }
  return out;
}

}  // namespace swage::needle
