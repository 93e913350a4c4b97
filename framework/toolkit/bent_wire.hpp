// SPDX-License-Identifier: Apache-2.0
//
// A curved wire that bends: rigid arc pieces of equal length, joined by elastic-plastic springs that turn in the plane, out of
// it and about the wire. Each joint stands for the half pieces on its two sides: stiffness EI / length, limit by the law of its
// section at four Gauss points along them, because the moment varies there: at first yield less than a piece flows.
// Statics only: the pieces have no mass and take their shape at once, so moments follow from the forces
// alone, m = G' f, and turns from the law. That is exact up to the wire's first frequency (4 kHz for 4 mm of 0.1 mm steel).
//
// Frames: P_i of piece i in its middle, on the centre line: x away from the circle's centre, y along the wire towards the
// swage, z normal to the plane. J_j of joint j, between pieces j and j + 1, likewise. SI units.
// Threads: built on [main]; the rest [rt], nothing allocates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "toolkit/math.hpp"
#include "toolkit/wire_law.hpp"
#include "toolkit/wire_section.hpp"

namespace swage::toolkit {

/// Memory of a joint: plain numbers that a host can keep.
struct JointMemory {
  double turn[3] = {};    // rad, rotation of piece j + 1 against j beyond the unbent wire, in J
  double moment[3] = {};  // N m, moment at that rotation, in J
  struct Place {
    double curvature[3] = {};  // in yield curvatures
    WireMemory law;
  };
  static constexpr int kPlaces = 4;
  Place place[kPlaces];
  double broken = 0;  // 1: the joint is broken and has the stiffness share kLimp
};

/// exp_rotation of the rotation of a joint: below a tenth of a radian by series whose next terms are under 1e-19.
inline Quat joint_rotation(const Vec3& a) {
  const double q = 0.25 * a.squaredNorm();  // square of half the angle
  if (q > 2.5e-3) return exp_rotation(a);
  const double k = 0.5 - q * (1.0 / 12 - q * (1.0 / 240 - q * (1.0 / 10080 - q / 725760)));
  const double c = 1 - q * (0.5 - q * (1.0 / 24 - q * (1.0 / 720 - q / 40320)));
  return {c, k * a.x(), k * a.y(), k * a.z()};
}

class BentWire {
 public:
  static constexpr int kMaxPieces = 48;
  /// Share of the stiffness that is left of a broken joint: a thread of metal still connects the halves.
  static constexpr double kLimp = 1e-3;
  /// Rotation of a joint [rad] at which its two pieces lie against each other: they bear the moment beyond that of the section, and
  /// the joint turns no farther. Less would cut a bend to a right angle and back short; beyond pi pieces pass through each other.
  static constexpr double kFolded = 3;
  /// Largest sum of the rotations of all joints in one step [rad]. A load beyond the plastic moment has no shape at rest until
  /// its lever arm is gone: the wire yields at this rate. Larger: the linear step is invalid; a hand that moves the point
  /// of a 4 mm arm at 1 m/s needs less, 0.25 in 1 ms.
  static constexpr double kMostTurn = 0.5;

  BentWire() = default;
  /// n pieces of an arc, 2 to kMaxPieces. radius: m; sweep: rad, of the whole arc.
  BentWire(int n, double radius, double sweep, const WireMaterial& material)
      : n_(n), radius_(radius), piece_sweep_(sweep / n), material_(material), law_(material.hardening) {
    const double half = 0.5 * piece_sweep_;
    half_ = {{radius * (std::cos(half) - 1), radius * std::sin(half), 0}, exp_rotation({0, 0, half})};
    half_back_ = half_.inverse();
  }

  /// Sets the section at a joint.
  void set_section(int joint, const WireSection& s) {
    Joint& j = joint_[at(joint)];
    for (int i = 0; i < 3; ++i) {
      j.yield[i] = s.yield[i];
      j.yield_turn[i] = s.yield_curvature(i) * piece_length();
      j.root[i] = std::sqrt(j.yield_turn[i] / j.yield[i]);
    }
  }

  int pieces() const { return n_; }
  int joints() const { return n_ - 1; }
  double radius() const { return radius_; }                       // m
  double piece_sweep() const { return piece_sweep_; }             // rad
  double piece_length() const { return radius_ * piece_sweep_; }  // m
  const WireMaterial& material() const { return material_; }

  /// Computes the poses of all pieces from that of piece `base`. X: n.
  void place(int base, const Pose& X_WP, const JointMemory* memory, Pose* X) const {
    X[base] = X_WP;
    for (int j = base; j < joints(); ++j) {
      Pose X_WJ = X[j] * half_;
      bend_frame(turn(memory[j]), X_WJ);
      X[j + 1] = X_WJ * half_;
      X[j + 1].q.normalize();
    }
    for (int j = base - 1; j >= 0; --j) {
      Pose X_WJ = X[j + 1] * half_back_;
      bend_frame(-turn(memory[j]), X_WJ);
      X[j] = X_WJ * half_back_;
      X[j].q.normalize();
    }
  }

  /// Pose of piece j + 1 in P_j where the joint between them has turned by `turn` [rad].
  Pose over(const Vec3& turn) const {
    Pose X = half_;
    bend_frame(turn, X);
    X = X * half_;
    X.q.normalize();
    return X;
  }

  /// Frame J of a joint, from the pose of the piece before it.
  Frame joint_frame(const Pose& X_WP, const JointMemory& memory) const {
    const Pose X_WJ = X_WP * half_;
    return {X_WJ.p, (X_WJ.q * joint_rotation(0.5 * turn(memory))).toRotationMatrix()};
  }

  /// Displacement of a point of piece i per turn of joint j, while piece `base` is fixed; zero when the joint is not
  /// between the two. Its transpose maps forces to moments.
  static Mat3 gain(int j, const Frame& X_WJ, int base, int piece, const Vec3& p_W) {
    Mat3 G = Mat3::Zero();
    const double sign = base <= j && j < piece ? 1 : piece <= j && j < base ? -1 : 0;
    if (sign == 0) return G;
    const Vec3 r = sign * (p_W - X_WJ.p);
    for (int k = 0; k < 3; ++k) G.col(k) = X_WJ.R.col(k).cross(r);
    return G;
  }

  /// Rotation per moment [rad / N m] of a joint under continued loading; 0 when folded. True: it yields or is folded.
  bool flexibility(int j, const JointMemory& memory, Mat3& F) const {
    if (folded(memory)) {
      F.setZero();
      return true;
    }
    const Joint& joint = joint_[at(j)];
    Mat3 D[JointMemory::kPlaces];
    bool flows = false;
    for (int k = 0; k < JointMemory::kPlaces && memory.broken == 0; ++k)
      flows = law_.tangent(curvature(memory.place[k]), memory.place[k].law, D[k]) || flows;
    if (!flows) {
      F = unloading(j, memory);
      return false;
    }
    const Vec3 root(joint.root[0], joint.root[1], joint.root[2]);
    Mat3 mean = Mat3::Zero();
    for (int k = 0; k < JointMemory::kPlaces; ++k) mean += kShare[k] * D[k].inverse();
    F = root.asDiagonal() * mean * root.asDiagonal();
    return true;
  }
  Mat3 elastic(int j) const {
    Mat3 F = Mat3::Zero();
    for (int i = 0; i < 3; ++i) F(i, i) = joint_[at(j)].root[i] * joint_[at(j)].root[i];
    return F;
  }

  /// Change of the moment from one end of a joint's stretch to the other [N m], from the moments on all joints, in their axes: that
  /// towards the neighbour to which it is less, as the moment may drop to zero beyond a clamp.
  Vec3 slope(int j, const Vec3* moment) const {
    const auto turned = [](const Vec3& v, double c, double s) { return Vec3(c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]); };
    const double c = std::cos(piece_sweep_), s = std::sin(piece_sweep_);
    if (j == 0) return joints() > 1 ? Vec3(turned(moment[1], c, s) - moment[0]) : Vec3(Vec3::Zero());
    const Vec3 before = moment[j] - turned(moment[j - 1], c, -s);
    if (j == joints() - 1) return before;
    const Vec3 after = turned(moment[j + 1], c, s) - moment[j];
    return before.squaredNorm() < after.squaredNorm() ? before : after;
  }

  /// Turns a joint by `by` [rad] more, to kFolded at most, and computes its moment. `slope`: of slope().
  void bend(int j, const Vec3& by, JointMemory& memory, const Vec3& slope = Vec3::Zero()) const {
    const Vec3 to = turn(memory) + by;
    const double size = to.norm(), kept = size > kFolded ? kFolded / size : 1;
    for (int i = 0; i < 3; ++i) memory.turn[i] = kept * to[i];
    const Vec3 e = normalised(j, turn(memory));
    const Vec3 m = memory.broken != 0 ? Vec3(kLimp * e) : bend_places(e, normalised_slope(j, slope), memory);
    for (int i = 0; i < 3; ++i) memory.moment[i] = joint_[at(j)].yield[i] * m[i];
    if (damage(memory) >= 1) memory.broken = 1;
  }

  /// Rotation of a joint to the moment of a load. Where the load falls the joint unloads elastically, even if it was yielding.
  Vec3 answer(int j, const Vec3& moment, const Mat3& F, bool flows, const JointMemory& memory) const {
    const Vec3 now = this->moment(memory), more = moment - now;
    return flows && now.dot(more) < 0 ? Vec3(unloading(j, memory) * more) : Vec3(F * more);
  }
  /// Share of the requested rotations, [rad] summed, that all joints get.
  static double share(double asked) { return asked > kMostTurn ? kMostTurn / asked : 1; }
  /// True when the two pieces of a joint lie against each other.
  static bool folded(const JointMemory& m) { return turn(m).squaredNorm() >= (1 - 1e-9) * kFolded * kFolded; }

  static Vec3 turn(const JointMemory& m) { return {m.turn[0], m.turn[1], m.turn[2]}; }
  static Vec3 moment(const JointMemory& m) { return {m.moment[0], m.moment[1], m.moment[2]}; }
  /// Moment over the moment at which the outer fibre first yields.
  double stress(int j, const JointMemory& memory) const { return stress(j, moment(memory)); }
  /// The same for any moment [N m] on the section of a joint, in its axes.
  double stress(int j, const Vec3& m) const {
    const Joint& joint = joint_[at(j)];
    return Vec3(m[0] / joint.yield[0], m[1] / joint.yield[1], m[2] / joint.yield[2]).norm();
  }
  /// Rotation that remains after unloading [rad].
  Vec3 residual(int j, const JointMemory& memory) const {
    if (memory.broken != 0) return turn(memory);
    Vec3 e = Vec3::Zero();
    for (int k = 0; k < JointMemory::kPlaces; ++k) e += kShare[k] * law_.relaxed(memory.place[k].law);
    const Joint& joint = joint_[at(j)];
    return {joint.yield_turn[0] * e[0], joint.yield_turn[1] * e[1], joint.yield_turn[2] * e[2]};
  }
  /// Accumulated plastic strain of the outer fibre over the strain that breaks it.
  double damage(const JointMemory& memory) const {
    return path(memory) * material_.yield / material_.youngs / material_.break_strain;
  }
  /// Path length of the plastic curvature where it is longest, in yield curvatures.
  static double path(const JointMemory& memory) {
    double longest = 0;
    for (const JointMemory::Place& place : memory.place) longest = std::max(longest, place.law.path);
    return longest;
  }

 private:
  struct Joint {
    double yield[3] = {1, 1, 1};       // N m
    double yield_turn[3] = {1, 1, 1};  // rad
    double root[3] = {1, 1, 1};        // root of the elastic flexibility
  };
  // Gauss points along a joint's stretch, from its middle in lengths of the stretch, and their weights. Where 1.02 of first yield stands at the
  // clamp of an arm of 12 pieces a quarter of a stretch flows: three points see 77 % of what it keeps, four 108 %.
  static constexpr double kAlong[JointMemory::kPlaces] = {-0.4305681557970263, -0.1699905217924281, 0.1699905217924281,
                                                            0.4305681557970263};
  static constexpr double kShare[JointMemory::kPlaces] = {0.1739274225687269, 0.3260725774312731, 0.3260725774312731, 0.1739274225687269};
  // Largest change of the moment along a stretch, in yield moments: that of a wire of four pieces with its plastic moment at one end and
  // nothing at the other. Only loads beyond that, which no section bears, cause more.
  static constexpr double kMostSlope = 0.5;
  static constexpr int kPasses = 12;     // normal: 3 to 5
  static constexpr double kNear = 1e-9;  // yield curvatures: the last correction

  static size_t at(int i) { return static_cast<size_t>(i); }
  static Vec3 curvature(const JointMemory::Place& p) { return {p.curvature[0], p.curvature[1], p.curvature[2]}; }
  Vec3 normalised_slope(int j, const Vec3& slope) const {
    const Joint& joint = joint_[at(j)];
    const Vec3 s(slope[0] / joint.yield[0], slope[1] / joint.yield[1], slope[2] / joint.yield[2]);
    const double size = s.norm();
    return size > kMostSlope ? Vec3(kMostSlope / size * s) : s;
  }

  /// Bends the Gauss points of a joint to curvatures whose mean is e, under moments that vary linearly along it. Returns the mean
  /// of the moments; all in yield curvatures and moments. While elastic, that mean is e.
  Vec3 bend_places(const Vec3& e, const Vec3& slope, JointMemory& memory) const {
    constexpr int n = JointMemory::kPlaces;
    Vec3 c[n], before = Vec3::Zero();
    bool elastic = true;
    for (int k = 0; k < n; ++k) {
      c[k] = e + kAlong[k] * slope;
      elastic = elastic && law_.elastic(c[k], memory.place[k].law);
      before += kShare[k] * curvature(memory.place[k]);
    }
    if (!elastic) {
      for (int k = 0; k < n; ++k) c[k] = curvature(memory.place[k]) + (e - before);
      if (!find_places(e, slope, memory, c))
        for (int k = 0; k < n; ++k) c[k] = curvature(memory.place[k]) + (e - before);
    }
    Vec3 m = Vec3::Zero();
    for (int k = 0; k < n; ++k) {
      for (int i = 0; i < 3; ++i) memory.place[k].curvature[i] = c[k][i];
      if (!elastic) m += kShare[k] * law_.bend(c[k], memory.place[k].law);
    }
    return elastic ? e : m;
  }

  /// Newton's method for the curvatures, from c. False where it does not converge.
  bool find_places(const Vec3& e, const Vec3& slope, const JointMemory& memory, Vec3* c) const {
    constexpr int n = JointMemory::kPlaces;
    for (int pass = 0; pass < kPasses; ++pass) {
      Mat3 gives[n], sum = Mat3::Zero();
      Vec3 left[n], rest = e;
      for (int k = 0; k < n; ++k) {
        WireMemory trial = memory.place[k].law;
        Mat3 D;
        left[k] = kAlong[k] * slope - law_.bend(c[k], trial);
        law_.tangent(c[k], trial, D);
        gives[k] = D.inverse();
        sum += kShare[k] * gives[k];
        rest -= kShare[k] * (c[k] + gives[k] * left[k]);
      }
      const Vec3 mean = sum.inverse() * rest;
      double far = 0;
      for (int k = 0; k < n; ++k) {
        const Vec3 by = gives[k] * (left[k] + mean);
        c[k] += by;
        far = std::max(far, by.norm());
      }
      if (far <= kNear) return true;
    }
    return false;
  }
  /// Rotation per moment of a joint whose load falls.
  Mat3 unloading(int j, const JointMemory& memory) const {
    return elastic(j) / (memory.broken != 0 ? kLimp : 1);
  }
  static void bend_frame(const Vec3& turn, Pose& X_WJ) {
    if (!turn.isZero(0)) X_WJ.q = X_WJ.q * joint_rotation(turn);
  }
  Vec3 normalised(int j, const Vec3& t) const {
    const Joint& joint = joint_[at(j)];
    return {t[0] / joint.yield_turn[0], t[1] / joint.yield_turn[1], t[2] / joint.yield_turn[2]};
  }

  int n_ = 2;
  double radius_ = 1, piece_sweep_ = 1;
  WireMaterial material_;
  WireLaw law_;
  Pose half_, half_back_;  // from the middle of a piece to its end, and back
  std::array<Joint, kMaxPieces - 1> joint_;
};

}  // namespace swage::toolkit
