// SPDX-License-Identifier: Apache-2.0
#include "bending.hpp"

#include <algorithm>
#include <cstring>

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

/// Back to unit length; exact to rounding for a quaternion that left it by rounding.
void renormalise(Quat& q) { q.coeffs() *= 1.5 - 0.5 * q.squaredNorm(); }

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
  // Steiner: the two about their common centre
  const Vec3 d = other.centre - centre;
  const Mat3 apart = d.squaredNorm() * Mat3::Identity() - d * d.transpose();
  both.inertia = inertia + other.inertia + mass * other.mass / both.mass * apart;
  return both;
}

/// Finds again what follows from the turns of joints that have changed.
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

/// Mass, centre and inertia of the whole with its pieces at X0_, put together about one of them.
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

/// Wrenches that others put on the pieces: they move the whole, and bend it where contacts hold it.
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

/// Without contacts: falls, and turns with its angular momentum kept (midpoint rule, order 2).
void Bending::fly(const Step& step, const Rigid& start) {
  const double h = step.dt();
  L_start_ = vec3(state(step).L);
  free_.v = vec3(state(step).v) + h * vec(step.gravity());
  take_loads(step, start);
  const Mat3 inverse = start.inertia.inverse();
  const Vec3 L = vec3(state(step).L);
  free_.w = inverse * L;
  for (int i = 0; i < 3; ++i) {
    const Mat3 half = toolkit::exp_rotation(0.5 * h * free_.w).toRotationMatrix();
    free_.w = half * (inverse * (half.transpose() * L));
  }
  // loads are balanced within the step: what they would spin a thin wire to is no attitude to turn it by
  if (n_load_ > 0) free_.w += inverse * (L_start_ - L);
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
    X_[at(i)] = {whole_.centre + R * (X0.p - start.centre), turn * X0.q};
    renormalise(X_[at(i)].q);
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

/// Poses of all pieces from that of one, with the joints as they were followed last.
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

/// Poses and twists to the host. Beyond a joint that has not turned a piece spins as the one before it does.
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

/// As if nothing touched it. Held, it is expected to go on as it went, so that contacts are looked for where they will be;
/// free, it springs back and flies.
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
    const swage_twist& V = step->V_WB[0];
    const Vec3 w = vec(V.w), arm = start.centre - X0_WB0_.p;
    carry(step, {vec(V.v) + w.cross(arm), w}, start);
    put(whole_.inertia * w, s.L);
  } else {
    carry(step, free_, start);
    put(L_start_, s.L);
    const JointMemory* memory = joints(step);
    const bool bent = std::any_of(memory, memory + n_ - 1,
                                  [](const JointMemory& j) { return !BentWire::moment(j).isZero(0); });
    if (bent) {
      relax(step);
      follow_joints(memory);
      place(middle(), Pose(X_[at(middle())]));
    }
  }
  put(expected_.v, s.v);
  write(step, middle());
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

Bending::Reading Bending::read(const Step& step) const {
  const JointMemory* memory = joints(step);
  Reading out;
  out.stress = peak_;
  for (int j = 0; j < n_ - 1; ++j) {
    if (BentWire::moment(memory[j]).isZero(0) && memory[j].law.path == 0) continue;
    out.stress = std::max(out.stress, wire_.stress(j, memory[j]));
    out.bend += wire_.residual(j, memory[j]).norm();
    out.damage = std::max(out.damage, std::min(1.0, wire_.damage(memory[j])));
    out.broken += memory[j].broken;
  }
  return out;
}

}  // namespace swage::needle
