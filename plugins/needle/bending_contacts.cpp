// SPDX-License-Identifier: Apache-2.0
//
// Contacts of a bending needle: mobility at its contact points, and the bending by their impulses.
#include <algorithm>
#include <cstdlib>

#include "bending.hpp"

namespace swage::needle {

using toolkit::BentWire;
using toolkit::JointMemory;
using toolkit::Quat;
using toolkit::vec;

/// Returns the base piece: that of the last step while a contact is on it, else the piece of the first point. So the base does not depend
/// on which other points are queried.
int Bending::carrier(const BendingState& s, std::span<const swage_contact_point> points) const {
  const auto base = static_cast<int>(s.base);
  const bool stays =
      s.held != 0 && std::any_of(points.begin(), points.end(),
                                 [&](const swage_contact_point& p) { return piece_of(p.body) == base; });
  return stays ? base : piece_of(points[0].body);
}

/// Finds the joints between the points and the base, their flexibilities, and the sums that the pieces in contact have of them.
void Bending::collect(const Step& step, std::span<const swage_contact_point> points) {
  const JointMemory* memory = joints(step);
  n_touch_ = std::min(static_cast<int>(points.size()), kMaxPoints);
  base_ = carrier(state(step), points);
  low_ = high_ = base_;
  const auto reach = [this](int piece) { low_ = std::min(low_, piece), high_ = std::max(high_, piece); };
  for (int a = 0; a < n_touch_; ++a) {
    Touch& t = touch_[at(a)];
    t.piece = piece_of(points[at(a)].body);
    t.p_W = vec(points[at(a)].p_W);
    t.arm_W = t.p_W - whole_.centre;
    reach(t.piece);
  }
  for (int l = 0; l < n_load_; ++l) reach(push_[at(l)].piece);
  for (int j = low_; j < high_; ++j) {
    joint_[at(j)] = wire_.joint_frame(X_[at(j)], memory[j]);
    flows_[at(j)] = wire_.flexibility(j, memory[j], F_[at(j)]);
  }
  load_joints();
  give(memory, step.dt());
  for (int a = 0; a < n_touch_; ++a) {
    Touch& t = touch_[at(a)];
    t.turn = turn_of(reach_[at(base_)].turn, t.arm_W);
    if (t.piece == base_) continue;
    const Reach& r = reach_[at(t.piece)];
    t.by = turn_of(r.turn, t.arm_W) - r.arm.transpose();
    t.shift = r.shift - turn_of(r.arm, t.arm_W);
  }
}

/// [q] M: translation at q due to the rotation M.
Mat3 Bending::turn_of(const Mat3& M, const Vec3& q) {
  Mat3 out;
  for (int k = 0; k < 3; ++k) out.col(k) = q.cross(M.col(k));
  return out;
}

/// From the base outwards: sums over the joints between the base and each piece, about the centre of mass.
void Bending::give(const JointMemory* memory, double h) {
  Reach& base = reach_[at(base_)];
  base = {};
  base.turn = inverse_;
  const double per_h = 1 / h, share = load_share(memory);
  const auto over = [&](int j, int from, int to) {
    const Frame& X_WJ = joint_[at(j)];
    const Vec3 x = X_WJ.p - whole_.centre;
    Mat3 RF, S;
    RF.noalias() = X_WJ.R.lazyProduct(F_[at(j)]);
    S.noalias() = (per_h * per_h * RF).lazyProduct(X_WJ.R.transpose());
    const Reach& before = reach_[at(from)];
    Reach& r = reach_[at(to)];
    const Mat3 arm = turn_of(S, x).transpose();  // S [x]'
    r.turn = before.turn + S;
    r.arm = before.arm + arm;
    r.shift = before.shift + turn_of(arm, x);
    const Vec3 w = (to > from ? per_h : -per_h) * share * (RF * (load_[at(j)] - BentWire::moment(memory[j])));
    r.w = before.w + w;
    r.v = before.v - w.cross(x);
  };
  for (int j = base_; j < high_; ++j) over(j, j, j + 1);
  for (int j = base_ - 1; j >= low_; --j) over(j, j + 1, j);
}

/// The share of the joint rotations by the wrenches alone that is done in one step (limits their sum).
double Bending::load_share(const JointMemory* memory) const {
  if (n_load_ == 0) return 1;
  double asked = 0;
  for (int j = low_; j < high_; ++j)
    asked += (F_[at(j)] * (load_[at(j)] - BentWire::moment(memory[j]))).norm();
  return BentWire::share(asked);
}

/// Moments on the joints between the base and the pieces on which wrenches act.
void Bending::load_joints() {
  std::fill(load_.begin() + low_, load_.begin() + high_, Vec3::Zero());
  for (int l = 0; l < n_load_; ++l) {
    const Load& push = push_[at(l)];
    const double sign = push.piece > base_ ? 1 : -1;
    for (int j = std::min(base_, push.piece); j < std::max(base_, push.piece); ++j) {
      const Frame& X_WJ = joint_[at(j)];
      load_[at(j)] += sign * X_WJ.turn_back(push.t_W + (push.p_W - X_WJ.p).cross(push.f_W));
    }
  }
}

/// Velocity of the point from its start to its present place, plus its velocity without contact forces: rigid motion, and springing back.
Vec3 Bending::free_velocity(int point, double h) const {
  const Touch& t = touch_[at(point)];
  const Reach& r = reach_[at(t.piece)];
  const Vec3 by_itself = free_.v + r.v + (free_.w - expected_.w + r.w).cross(t.arm_W);
  if (as_one_) return by_itself + (t.arm_W - back_W_ * t.arm_W) / h;
  const Pose &X0 = X0_[at(t.piece)], &X = X_[at(t.piece)];
  const Vec3 before = X0 * (X.q.conjugate() * (t.p_W - X.p));
  return by_itself + (t.p_W - before) / h - expected_.v;
}

/// Velocity of point a per impulse at b: the sum over what lies between the base and both.
///   W_ab = 1/m + sum over the whole (at its centre, x = 0, S = I^-1) and the common joints of [q_a - x] S [q_b - x]'
Mat3 Bending::mobility(const Touch& a, const Touch& b) const {
  const int out_a = a.piece - base_, out_b = b.piece - base_;
  const bool common = (out_a > 0 && out_b > 0) || (out_a < 0 && out_b < 0);
  Mat3 W;
  if (!common) {
    for (int i = 0; i < 3; ++i) W.row(i) = b.arm_W.cross(a.turn.row(i));
  } else if (std::abs(out_a) <= std::abs(out_b)) {
    for (int i = 0; i < 3; ++i) W.row(i) = b.arm_W.cross(a.by.row(i)).transpose() + a.shift.row(i);
  } else {
    for (int i = 0; i < 3; ++i) W.col(i) = a.arm_W.cross(b.by.row(i)).transpose() + b.shift.row(i);
  }
  W.diagonal().array() += 1 / whole_.mass;
  return W;
}

void Bending::mobility(const Step& step, std::span<const swage_contact_point> points, double* v_free,
                         double* W) {
  state(step).answered = 1;
  collect(step, points);
  const size_t n = 3 * points.size();
  for (int a = 0; a < n_touch_; ++a) {
    put(free_velocity(a, step.dt()), v_free + 3 * a);
    for (int b = 0; b <= a; ++b) {
      const Mat3 block = mobility(touch_[at(a)], touch_[at(b)]);
      double *to = W + 3 * at(a) * n + 3 * at(b), *back = W + 3 * at(b) * n + 3 * at(a);
      for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) to[i * n + k] = back[k * n + i] = block(static_cast<int>(i), static_cast<int>(k));
    }
  }
}

/// Forces of the contacts along the wire, in order. Two pieces that touch a face beside their common joint make one contact: a joint
/// that is turned by theta leaves a dent of length R theta between them, where the real wire is round and touches in the middle of it.
int Bending::along(const double* impulse, double h, std::span<Force> force) {
  int n = 0, turned = -1;
  for (int a = 0; a < n_touch_; ++a) {
    const Vec3 f = vec3(impulse + 3 * a) / h;
    if (f.isZero(0)) continue;
    const int piece = touch_[at(a)].piece;
    if (piece != turned) R_[at(turned = piece)] = X_[at(piece)].q.toRotationMatrix();
    const Force now = force_at(touch_[at(a)], f);
    int i = n++;
    for (; i > 0 && force[at(i - 1)].s > now.s; --i) force[at(i)] = force[at(i - 1)];
    force[at(i)] = now;
  }
  int kept = 0;
  for (int i = 0; i < n; ++i) {
    const Force now = force[at(i)];
    Force* const before = kept > 0 ? &force[at(kept - 1)] : nullptr;
    if (before != nullptr && now.dent >= 0 && now.dent == before->dent && before->f_W.dot(now.f_W) > 0) {
      const double share = now.f_W.norm() / (now.f_W.norm() + before->f_W.norm());
      before->p_W += share * (now.p_W - before->p_W);
      before->f_W += now.f_W;
    } else {
      force[at(kept++)] = now;
    }
  }
  return kept;
}

/// Reduces a contact's force to the centre line, and finds the joint in whose dent it is.
Bending::Force Bending::force_at(const Touch& t, const Vec3& f_W) const {
  constexpr double kDent =
      0.75;  // half extent of the dent, in R theta: a half, and a margin for tilt and for rotation within the step
  const Mat3& R = R_[at(t.piece)];
  const Vec3& middle = X_[at(t.piece)].p;
  const double y = (t.p_W - middle).dot(R.col(1)), sag = 0.5 * y * y / wire_.radius();
  Force force{t.piece * wire_.piece_length() + y, t.piece, -1, f_W, middle + y * R.col(1) - sag * R.col(0)};
  const int joint = y > 0 ? t.piece : t.piece - 1;
  if (joint < 0 || joint >= n_ - 1) return force;
  const double dent = kDent * wire_.radius() * std::abs(known_[at(joint)].turn[2]);
  if (0.5 * wire_.piece_length() - std::abs(y) < dent) force.dent = joint;
  return force;
}

/// Greatest stress over first yield, by statics: between the contact forces the moment of a wire is linear, so that it
/// is greatest at one of them, also within a piece. At the joints alone the bending between narrow jaws would be missed.
double Bending::peak(const double* impulse, double h) {
  std::array<Force, kMaxPoints> force;
  const int n = along(impulse, h, force);
  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();  // of all forces, about the centre of mass
  for (int i = 0; i < n; ++i) {
    const Force& here = force[at(i)];
    sum += here.f_W, moment += (here.p_W - whole_.centre).cross(here.f_W);
  }
  double greatest = 0;
  Vec3 sum_before = Vec3::Zero(), before = Vec3::Zero();
  for (int i = 0; i < n; ++i) {
    const Force& here = force[at(i)];
    const Vec3 arm = here.p_W - whole_.centre;
    // moment from either side; their difference accelerates the needle
    const Vec3 m_before = before - arm.cross(sum_before);
    const Vec3 m_after = (moment - before) - arm.cross(sum - sum_before);
    const Vec3& m = m_before.squaredNorm() < m_after.squaredNorm() ? m_before : m_after;
    greatest =
        std::max(greatest, wire_.stress(std::min(here.piece, n_ - 2), R_[at(here.piece)].transpose() * m));
    sum_before += here.f_W, before += arm.cross(here.f_W);
  }
  return greatest;
}

/// Moments on the joints: of the contact forces beyond them, as seen from the base.
void Bending::bear(const double* impulse, double h, Vec3* m) const {
  std::array<Vec3, kMax> f, t;  // on each piece, N; N m about the centre of mass
  std::fill(f.begin() + low_, f.begin() + high_ + 1, Vec3::Zero());
  std::fill(t.begin() + low_, t.begin() + high_ + 1, Vec3::Zero());
  for (int a = 0; a < n_touch_; ++a) {
    const Vec3 push = vec3(impulse + 3 * a) / h;
    f[at(touch_[at(a)].piece)] += push, t[at(touch_[at(a)].piece)] += touch_[at(a)].arm_W.cross(push);
  }
  const auto moment = [&](int j, const Vec3& force, const Vec3& torque) {
    const Frame& X_WJ = joint_[at(j)];
    return Vec3(X_WJ.turn_back(torque - (X_WJ.p - whole_.centre).cross(force)));
  };
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (int j = high_ - 1; j >= base_; --j) {
    force += f[at(j + 1)], torque += t[at(j + 1)];
    m[j] = moment(j, force, torque) + load_[at(j)];
  }
  force.setZero(), torque.setZero();
  for (int j = low_; j < base_; ++j) {
    force += f[at(j)], torque += t[at(j)];
    m[j] = load_[at(j)] - moment(j, force, torque);
  }
}

void Bending::apply_impulses(const Step& step, std::span<const swage_contact_point>, const double* impulse) {
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
  }
  if (touched) bear(impulse, h, m.data());
  if (touched) peak_ = peak(impulse, h);

  // shape: joints outside of [low_, high_) bear no moment
  std::array<Vec3, kMax> by;
  double asked = 0;
  for (int j = 0; j < n_ - 1; ++j) {
    const bool reached = low_ <= j && j < high_;
    by[at(j)].setZero();
    if (m[at(j)].isZero(0) && BentWire::moment(memory[j]).isZero(0)) continue;
    by[at(j)] = reached ? wire_.answer(j, m[at(j)], F_[at(j)], flows_[at(j)], memory[j])
                        : wire_.answer(j, m[at(j)], wire_.elastic(j), true, memory[j]);
    asked += by[at(j)].norm();
  }
  const double share = BentWire::share(asked);
  for (int j = 0; j < n_ - 1; ++j)
    if (!by[at(j)].isZero(0)) wire_.bend(j, share * by[at(j)], memory[j], wire_.slope(j, m.data()));
  follow_joints(memory);

  // motion of the whole: its centre and the base move as a rigid body
  BendingState& s = state(step);
  const Vec3 v = free_.v + sum / whole_.mass, w = free_.w + inverse_ * moment;
  const Vec3 centre = whole_.centre - h * expected_.v;
  const Pose& X0 = X0_[at(base_)];
  const Quat turn = toolkit::exp_rotation(h * w);
  Quat q = turn * X0.q;
  renormalise(q);
  place(base_, Pose(centre + h * v + turn * (X0.p - centre), q));
  write(step, base_);
  put(v, s.v);
  put(Vec3(L_start_ + moment), s.L);
  s.held = touched ? 1 : 0;
  if (touched) s.base = base_;
}

}  // namespace swage::needle
