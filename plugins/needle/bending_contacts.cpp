// SPDX-License-Identifier: Apache-2.0
//
// What contacts do to a bending needle: how its points give, and what the impulses on them bend.
#include <algorithm>

#include "bending.hpp"

namespace swage::needle {

using toolkit::BentWire;
using toolkit::JointMemory;
using toolkit::Quat;
using toolkit::skew;
using toolkit::vec;

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
  for (int l = 0; l < n_load_; ++l)
    low_ = std::min(low_, push_[at(l)].piece), high_ = std::max(high_, push_[at(l)].piece);
  for (int j = low_; j < high_; ++j) {
    joint_[at(j)] = wire_.joint_frame(X_[at(j)], memory[j]);
    flows_[at(j)] = wire_.flexibility(j, memory[j], F_[at(j)]);
  }
  for (int a = 0; a < n_touch_; ++a)
    for (int j = touch_[at(a)].low; j < touch_[at(a)].high; ++j) {
      Mat3& G = G_[pair(a, j)];
      G = BentWire::gain(j, joint_[at(j)], base_, touch_[at(a)].piece, touch_[at(a)].p_W);
      GF_[pair(a, j)].noalias() = G.lazyProduct(F_[at(j)]);
    }
  load_joints();
}

/// Moments that the wrenches on the pieces put on the joints between them and the one that carries.
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

/// From where the point came to where it is now, and on from there without forces: as a rigid body, and springing back.
Vec3 Bending::free_velocity(int point, const JointMemory* memory, double h) const {
  const Touch& t = touch_[at(point)];
  const Pose &X0 = X0_[at(t.piece)], &X = X_[at(t.piece)];
  const Vec3 before = X0 * (X.q.conjugate() * (t.p_W - X.p));
  Vec3 v = (t.p_W - before) / h + (free_.v - expected_.v) + (free_.w - expected_.w).cross(t.arm_W);
  for (int j = t.low; j < t.high; ++j)
    v += GF_[pair(point, j)] * (load_[at(j)] - BentWire::moment(memory[j])) / h;
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

/// Stress over first yield where it is greatest, by statics: between the forces of contacts the moment of a wire changes evenly,
/// so that it is greatest at one of them, also within a piece. Joints alone would not see what bends between narrow jaws.
double Bending::peak(const double* impulse, double h) const {
  struct Force {
    double s;  // m along the wire
    int piece;
    Vec3 f_W, p_W;  // N; m, on the centre line
  };
  std::array<Force, kMaxPoints> force;
  size_t n = 0;
  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();  // of all, about the centre of mass
  for (int a = 0; a < n_touch_; ++a) {
    const Touch& t = touch_[at(a)];
    const Vec3 f = vec3(impulse + 3 * a) / h;
    if (f.isZero(0)) continue;
    const Pose& X = X_[at(t.piece)];
    const double y = (t.p_W - X.p).dot(X.q * Vec3::UnitY());
    Force now{t.piece * wire_.piece_length() + y, t.piece, f, X * Vec3(-0.5 * y * y / wire_.radius(), y, 0)};
    sum += f, moment += (now.p_W - whole_.centre).cross(f);
    size_t i = n++;
    for (; i > 0 && force[i - 1].s > now.s; --i) force[i] = force[i - 1];
    force[i] = now;
  }
  double greatest = 0;
  Vec3 sum_before = Vec3::Zero(), before = Vec3::Zero();
  for (size_t i = 0; i < n; ++i) {
    const Force& here = force[i];
    const Vec3 arm = here.p_W - whole_.centre;
    // from either side; what they differ by moves the needle
    const Vec3 m_before = before - arm.cross(sum_before);
    const Vec3 m_after = (moment - before) - arm.cross(sum - sum_before);
    const Vec3& m = m_before.squaredNorm() < m_after.squaredNorm() ? m_before : m_after;
    greatest =
        std::max(greatest, wire_.stress(std::min(here.piece, n_ - 2), X_[at(here.piece)].q.conjugate() * m));
    sum_before += here.f_W, before += arm.cross(here.f_W);
  }
  return greatest;
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
  for (int j = low_; touched && n_load_ > 0 && j < high_; ++j) m[at(j)] += load_[at(j)];
  if (touched) peak_ = peak(impulse, h);

  // the shape: joints that no contact reaches bear nothing
  for (int j = 0; j < n_ - 1; ++j) {
    const bool reached = low_ <= j && j < high_;
    if (m[at(j)].isZero(0) && BentWire::moment(memory[j]).isZero(0)) continue;
    const Vec3 by = reached ? wire_.answer(j, m[at(j)], F_[at(j)], flows_[at(j)], memory[j])
                            : wire_.answer(j, m[at(j)], wire_.elastic(j), true, memory[j]);
    wire_.bend(j, by, memory[j]);
  }
  follow_joints(memory);

  // the whole: its centre and the piece that carries go as a rigid body
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
