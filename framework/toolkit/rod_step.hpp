// SPDX-License-Identifier: Apache-2.0
//
// Rod: a step in time. Part of rod.hpp.
#pragma once

#include "toolkit/rod.hpp"

namespace swage::toolkit {

inline void Rod::start(RodState& s) const {
  // some direction across the first edge, then transported along the rod
  const Vec3 t0 = edge(s, 0).t;
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(t0[k]) < std::abs(t0[least])) least = k;
  Vec3 d = t0.cross(Vec3::Unit(least)).normalized();
  if (clamp_[0].on) d = carried(clamp_[0].director, clamp_[0].tangent, t0);
  for (int j = 0; j < edges(); ++j) {
    if (j > 0) d = carried(d, edge(s, j - 1).t, edge(s, j).t);
    Eigen::Map<Vec3>(s.director + 3 * j) = d;
  }
  for (int k = 0; k < 3 * n_; ++k) s.v[k] = 0;
  for (int i = 0; i < n_; ++i) s.twist[i] = has_joint(i) ? twisted(s, i, 0) : 0.0;
  if (s.steps != nullptr) *s.steps = 0;
}

/// Prepares a step: x0_, the positions without forces (hat_), and the drag at the present velocity.
inline void Rod::prepare(const RodState& s, const RodLoad& load) {
  const bool second = load.second_order && *s.steps > 0;
  way_ = -1;
  g_ = second ? 2.0 / 3.0 * load.h : load.h;  // s, length of the equivalent backward Euler step
  m_hh_ = load.h > 0 ? 1 / (g_ * g_) : 0.0;
  if (second) {
    for (int k = 0; k < 3 * n_; ++k) {
      x0_[at(k)] = (4 * s.x[k] - s.before[k]) / 3;
      hat_[at(k)] = x0_[at(k)] + g_ * ((4 * s.v[k] - s.before[3 * n_ + k]) / 3);
    }
  } else {
    std::copy_n(s.x, 3 * n_, x0_.data());
    for (int k = 0; k < 3 * n_; ++k) hat_[at(k)] = s.x[k] + g_ * s.v[k];
  }
  begin_linear(s);
  add_drag(s, load);
}

/// Begins the linear model at a state, with rotations 0.
inline void Rod::begin_linear(const RodState& s) {
  take_tension(s);
  std::fill(turned_.begin(), turned_.end(), 0.0);
}

/// The part of inertia, drag, weight and loads in the gradient and in the Hessian, node by node: in the gradient the three directions side
/// by side in a register of four, whose fourth number is left alone, or one after the other.
template <class V>
[[gnu::always_inline]] inline void Rod::add_inertia(V, const RodState& s, const RodLoad& load, double* hessian) {
  const double fluid = load.fluid.density * std::numbers::pi * section_.radius * section_.radius;  // kg/m
  const double borne = section_.mass > 0 ? 1 - fluid / section_.mass : 1;
  const double gravity[4] = {load.gravity[0], load.gravity[1], load.gravity[2], 0};
  const double* force = load.force.empty() ? nullptr : load.force.data();
  for (int i = 0; i < n_; ++i) {
    const double m = mass_[at(i)], w = m * m_hh_, weight = borne * m;
    const double *D = drag_.data() + 6 * i, *x = s.x + 3 * i, *x0 = x0_.data() + 3 * i, *hat = hat_.data() + 3 * i;
    const double* pushed = pushed_.data() + 3 * i;
    double* g = gradient_.data() + 4 * i;
    if constexpr (V::n == 4) {
      if (i + 1 < n_) {  // what is read beyond the three numbers of the node is that of the next
        V at_x, at_x0, at_hat, at_pushed, G, low, high, F;
        at_x.load(x), at_x0.load(x0), at_hat.load(hat), at_pushed.load(pushed), G.load(gravity), low.load(D), high.load(D + 2);
        const Four d = at_x.x - at_x0.x, a = low.x, b = high.x;
        F.x = w * (at_x.x - at_hat.x) - weight * G.x;
        F.x += a * __builtin_shufflevector(d, d, 0, 0, 0, 0);
        F.x += __builtin_shufflevector(a, b, 1, 3, 6, 6) * __builtin_shufflevector(d, d, 1, 1, 1, 1);
        F.x += __builtin_shufflevector(b, b, 0, 2, 3, 3) * __builtin_shufflevector(d, d, 2, 2, 2, 2);
        if (force != nullptr) {
          V f;
          f.load(force + 3 * i);
          F.x -= f.x;
        }
        F.x -= at_pushed.x;
        V now;
        now.load(g);
        F.x = __builtin_shufflevector(now.x + F.x, now.x, 0, 1, 2, 7);
        F.store(g);
      }
    }
    if (V::n != 4 || i + 1 == n_) {
      const double DD[3][3] = {{D[0], D[1], D[2]}, {D[1], D[3], D[4]}, {D[2], D[4], D[5]}};
      for (int r = 0; r < 3; ++r) {
        double F = w * (x[r] - hat[r]) - weight * gravity[r];
        for (int c = 0; c < 3; ++c) F += DD[r][c] * (x[c] - x0[c]);
        if (force != nullptr) F -= force[3 * i + r];
        F -= pushed[r];
        g[r] += F;
      }
    }
    if (hessian == nullptr) continue;
    double *X = column(hessian, 4 * i), *Y = column(hessian, 4 * i + 1), *Z = column(hessian, 4 * i + 2);
    X[0] += w, X[0] += D[0], X[1] += D[1], X[2] += D[2];
    Y[0] += w, Y[0] += D[3], Y[1] += D[4];
    Z[0] += w, Z[0] += D[5];
  }
}

/// Gradient of the step's potential and, when asked for, its Hessian.
[[gnu::flatten]] inline void Rod::system(const RodState& s, const RodLoad& load, double* hessian) {
  way_ = -1;
  differentiate_into(s, gradient_.data(), hessian);
  has_fours() ? add_inertia_by_fours(s, load, hessian) : add_inertia(Ones{}, s, load, hessian);
  const double inertia = 0.5 * section_.mass;  // kg/m, times the square of the radius
  for (int j = 0; j < edges(); ++j) {
    const double L = rest_[at(j)], k = section_.twisting / L;
    double& F = gradient_[at(4 * j + 3)];
    // statics: torque-free edges are held by a billionth of their stiffness, in the Hessian alone
    const double I = load.h > 0 ? inertia * L * section_.radius * section_.radius * m_hh_ : 1e-9 * k;
    if (load.h > 0) F += I * turned_[at(j)];
    if (!load.torque.empty()) F -= load.torque[at(j)];
    if (hessian) *column(hessian, 4 * j + 3) += k > 0 ? I : 1.0;
    if (!(k > 0)) F = 0;
  }
  for (int i = 0; i < n_; ++i)
    for (int r = 0; held_[at(i)] != 0 && r < 3; ++r) {
      gradient_[at(4 * i + r)] = 0;
      if (hessian) Matrix::hold(hessian, 4 * i + r);
    }
  for (int j = 0; j < edges(); ++j) {
    if (turn_held_[at(j)] == 0) continue;
    gradient_[at(4 * j + 3)] = 0;
    if (hessian) Matrix::hold(hessian, 4 * j + 3);
  }
}

/// Factors the system. Where it is not positive definite, first rotations are stiffened; then compressed edges, which would
/// buckle, count as stretched by as much; then the diagonal grows until it is.
inline bool Rod::factor(const RodState& s, const RodLoad& load) {
  for (int stiffer = 0; stiffer <= kStiffer; ++stiffer) {
    A_.clear_beyond();
    stiffened_system(s, load, stiffer, A_.column(0));
    if (A_.factor()) return true;
  }
  return false;
}

/// Assembles the system, stiffened to make it definite; `stiffer` 0: as it is.
inline void Rod::stiffened_system(const RodState& s, const RodLoad& load, int stiffer, double* columns) {
  if (stiffer > 0) slow_ = true;
  if (stiffer > 1)
    for (double& T : tension_) T = std::abs(T);
  system(s, load, columns);
  if (slow_) slow_turns(s, columns);
  for (int k = 0; stiffer > 1 && k < unknowns(); ++k) diagonal_[at(k)] = *column(columns, k);
  shift_diagonal(stiffer, columns);
}

/// `stiffer` from 3 on: a growing shift of the diagonal of all displacements.
inline void Rod::shift_diagonal(int stiffer, double* columns) {
  if (stiffer < 3) return;
  double largest = 0;
  for (int k = 0; k < unknowns(); k += k % 4 == 2 ? 2 : 1) largest = std::max(largest, diagonal_[at(k)]);
  double shift = 1e-9 * largest;  // N/m
  for (int i = 3; i < stiffer; ++i) shift *= 30;
  for (int k = 0; k < unknowns(); k += k % 4 == 2 ? 2 : 1) *column(columns, k) = diagonal_[at(k)] + shift;
}

/// Stiffens rotations that have hardly any stiffness: a rod that bends to its natural curvature turns all of its edges together. They
/// get EI k m l, the cost of bending to the natural curvature m without turning, with k = m, or the present curvature where that is
/// greater (bent by k against its natural curvature a rod is at a maximum of energy, with the second derivative -EI k m per length); and
/// so much that their torque does not turn them beyond the range of the linear model.
inline void Rod::slow_turns(const RodState& s, double* columns) {
  for (int j = 0; j < edges(); ++j) {
    const double remembered = std::max(this->remembered(j), this->remembered(j + 1));
    double k = remembered;
    for (const int i : {j, j + 1})
      if (remembered > 0 && has_joint(i)) k = std::max(k, curvature(s, i));
    *column(columns, 4 * j + 3) +=
        section_.bending * remembered * k * rest_[at(j)] + std::abs(gradient_[at(4 * j + 3)]) / kMostAbout;
  }
}

/// Computes the next change of all unknowns. False: the system cannot be factored.
inline bool Rod::solve(const RodState& s, const RodLoad& load) {
  for (slow_ = false;; slow_ = true) {
    if (!factor(s, load)) return false;
    double most = 0;
    for (int k = 0; k < unknowns(); ++k) change_[at(k)] = -gradient_[at(k)];
    A_.solve(change_.data());
    for (int j = 0; j < edges(); ++j) most = std::max(most, std::abs(change_[at(4 * j + 3)]));
    if (slow_ || most < kMostAbout) return true;
  }
}

/// The energy that the step minimises [J].
inline double Rod::potential(const RodState& s, const RodLoad& load) const {
  double sum = energy(s);
  const double borne = section_.mass > 0 ? 1 - load.fluid.density * std::numbers::pi * section_.radius *
                                                   section_.radius / section_.mass
                                         : 1;
  for (int i = 0; i < n_; ++i) {
    const double* D = drag_.data() + 6 * i;
    double d[3];
    for (int r = 0; r < 3; ++r) {
      const int k = 3 * i + r;
      const double away = s.x[k] - hat_[at(k)];
      d[r] = s.x[k] - x0_[at(k)];
      sum += mass_[at(i)] * (0.5 * m_hh_ * away * away - borne * load.gravity[r] * d[r]);
      if (!load.force.empty()) sum -= load.force[at(k)] * d[r];
      sum -= pushed_[at(k)] * d[r];
    }
    sum += 0.5 * (D[0] * d[0] * d[0] + D[3] * d[1] * d[1] + D[5] * d[2] * d[2]) + D[1] * d[0] * d[1] +
           D[2] * d[0] * d[2] + D[4] * d[1] * d[2];
  }
  return sum;
}

/// Updates the tension of the linear model after a change.
[[gnu::flatten]] inline void Rod::follow_tension(const RodState& s, const double* change, double share) {
  now_.find(s.x);
  for (int j = 0; j < edges(); ++j) {
    const Edge e = found(j);
    const double* d = change + 4 * j;
    const double more = e.t.dot(Vec3(d[4] - d[0], d[5] - d[1], d[6] - d[2]));
    const double T = section_.stretching * ((1 / e.inverse + more) / rest_[at(j)] - 1);
    tension_[at(j)] += share * (T - tension_[at(j)]);
  }
}

/// The share of a change after which no edge has turned by more than half a radian, nor about itself by more than one.
[[gnu::flatten]] inline double Rod::bounded(const RodState& s) const {
  constexpr double kLess = 0.99 * kMostAcross * kMostAcross;  // needs no root: it is within the bound
  double most = 1;
  now_.find(s.x);
  for (int j = 0; j < edges(); ++j) {
    const double* d = change_.data() + 4 * j;
    const Edge e = found(j);
    const Vec3 by = e.inverse * Vec3(d[4] - d[0], d[5] - d[1], d[6] - d[2]), across = by - by.dot(e.t) * e.t;
    if (across.squaredNorm() > kLess) most = std::max(most, across.norm() / kMostAcross);
    most = std::max(most, std::abs(d[3]) / kMostAbout);
  }
  return 1 / most;
}

inline void Rod::finish(RodState& s, const RodLoad& load) const {
  if (load.h == 0) return;
  for (int k = 0; k < 3 * n_; ++k) s.v[k] = (s.x[k] - x0_[at(k)]) / g_;
}

/// Newton's method starts at the nodes advanced by their velocities; or at the present ones, if that would stretch an edge or turn it too
/// far (held nodes advance nevertheless). The part that alternates from node to node does not advance: contacts are detected there, and
/// edges that lie on a round surface would rock on it. A joint of edges of length l under the tension T has the stiffnesses EI / l and
/// T l; the reaction of a contact to the tilt of its edge, T l too, comes one step late, and an advanced edge tilts twice as far: beyond
/// T = 2 EI / l^2 the tilt would be amplified.
[[gnu::flatten]] inline bool Rod::go_on(RodState& s, const RodLoad& load, double most_strain) {
  if (load.h == 0) return true;
  for (int i = 0; i < n_; ++i) {
    const double* v = s.v + 3 * i;
    double* d = change_.data() + 4 * i;
    const bool inner = i > 0 && i < n_ - 1 && held_[at(i)] == 0;
    for (int r = 0; r < 3; ++r) d[r] = load.h * (inner ? 0.25 * (v[r - 3] + v[r + 3]) + 0.5 * v[r] : v[r]);
    if (i < n_ - 1) d[3] = 0;
  }
  bool far = bounded(s) < 1;
  for (int j = 0; j < edges() && !far; ++j) {
    const double* d = change_.data() + 4 * j;
    const Vec3 now = s.edge(j), then = now + Vec3(d[4] - d[0], d[5] - d[1], d[6] - d[2]);
    const double most = most_strain * rest_[at(j)], half = 0.5 * rest_[at(j)];
    // an edge of half its rest length or more that changes so little needs no root
    if (now.squaredNorm() >= half * half && std::abs(then.squaredNorm() - now.squaredNorm()) <= half * most) continue;
    far = std::abs(then.norm() - now.norm()) > most;
  }
  for (int k = 0; far && k < unknowns(); ++k)
    if (k % 4 != 3 && held_[at(k / 4)] == 0) change_[at(k)] = 0;
  move(s, change_.data(), 1, s);
  return !far;
}

inline RodEffort Rod::step(RodState& s, const RodLoad& load, int iterations, double tolerance) {
  prepare(s, load);
  RodState old(n_, stored_.data());
  old.copy(s);
  go_on(s, load, 0.1);
  const RodEffort effort = iterate(s, load, iterations, tolerance);
  finish(s, load);
  if (load.second_order) std::copy_n(old.x, 6 * n_, s.before), *s.steps = 1;
  return effort;
}

inline RodEffort Rod::iterate(RodState& s, const RodLoad& load, int iterations, double tolerance) {
  RodEffort effort;
  double last = HUGE_VAL;
  bool guarded = false;
  for (int it = 0; it < iterations; ++it) {
    if (!solve(s, load)) break;
    ++effort.iterations;
    double share = bounded(s), size = 0;
    for (int k = 0; k < unknowns(); ++k)
      if (k % 4 != 3) size = std::max(size, std::abs(change_[at(k)]));
    if (guarded) share = search(s, load, share);
    follow_tension(s, change_.data(), share);
    move(s, change_.data(), share, s);
    for (int j = 0; j < edges(); ++j) turned_[at(j)] += share * change_[at(4 * j + 3)];
    effort.change = share * size;
    effort.settled = share == 1 && size <= tolerance;
    if (effort.settled) break;
    // whole steps while they shrink; else a search on the potential
    guarded = guarded || (it > 3 && size > 0.7 * last);
    last = size;
  }
  return effort;
}

/// The share of a change, halved until it lowers the potential.
inline double Rod::search(const RodState& s, const RodLoad& load, double share) {
  const double before = potential(s, load);
  RodState trial(n_, trial_.data());
  for (int halved = 0; halved < 12; ++halved, share *= 0.5) {
    move(s, change_.data(), share, trial);
    if (potential(trial, load) <= before) break;
  }
  return share;
}

inline bool Rod::linearise(const RodState& s, const RodLoad& load) {
  begin_linear(s);
  slow_ = false;
  if (!factor(s, load)) return false;
  for (int k = 0; k < unknowns(); ++k) change_[at(k)] = -gradient_[at(k)];
  A_.solve(change_.data());
  return true;
}

inline void Rod::linearise(const RodState& s, const RodLoad& load, int stiffer, double* columns, double* gradient) {
  const bool kept = stiffer > 1;  // for the next call, which shifts its diagonal
  if (stiffer < 3 || way_ != stiffer - 1) {
    begin_linear(s);
    slow_ = false;
    stiffened_system(s, load, stiffer, kept ? A_.column(0) : columns);
  } else {
    shift_diagonal(stiffer, A_.column(0));  // the rest is that of the last call, with stiffer - 1
  }
  way_ = stiffer;
  if (kept) std::copy_n(A_.column(0), at(unknowns()) * Matrix::kStride, columns);
  std::copy_n(gradient_.data(), unknowns(), gradient);
  for (int i = 0; i < n_; ++i) {
    for (int r = 0; held_[at(i)] != 0 && r < 3; ++r) *column(columns, 4 * i + r) = 0;
    if (i < edges() && turn_held_[at(i)] != 0) *column(columns, 4 * i + 3) = 0;
  }
}

inline void Rod::go(const RodState& s, const double* change, RodState& to) {
  follow_tension(s, change, 1);
  move(s, change, 1, to);
  for (int k = 0; k < 3 * n_; ++k) to.v[k] = (to.x[k] - x0_[at(k)]) / g_;
}

inline void Rod::respond(const RodState& s, const RodLoad& load, double* force, RodState& to) {
  for (int k = 0; k < unknowns(); ++k)
    if (k % 4 == 3 ? turn_held_[at(k / 4)] != 0 : held_[at(k / 4)] != 0) force[k] = 0;
  A_.solve(force);
  for (int k = 0; k < unknowns(); ++k) force[k] += change_[at(k)];
  follow_tension(s, force, 1);
  move(s, force, 1, to);
  finish(to, load);
}

inline bool Rod::stable(const RodState& s, const RodLoad& load) {
  RodLoad at_rest = load;
  at_rest.h = 0;
  prepare(s, at_rest);
  A_.clear_beyond();
  system(s, at_rest, A_.column(0));
  return A_.factor();
}

inline void Rod::follow_clamps(RodState& s) const {
  for (const int i : {0, n_ - 1})
    if (has_joint(i)) s.twist[i] = twisted(s, i, s.twist[i]);
}

}  // namespace swage::toolkit
