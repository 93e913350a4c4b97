// SPDX-License-Identifier: Apache-2.0
//
// A bending needle as the contact solve takes it. The wire is a chain of arcs (toolkit/bent_wire.hpp) whose shape follows
// the contact forces within the step; the whole moves with the mass and inertia of a rigid body of its present shape, whose pose is
// that of one piece in contact, the base. Per step h, with forces f = j/h and G, F gains and flexibilities of the joints:
//
//   v = v_rigid - (1/h) sum G F m_now  +  W j,     W = J M^-1 J' + (1/h^2) sum G F G'
//
// Then each joint is turned by F (G' f - m_now), and the material law gives the moment that it really bears. The residual is
// in m_now of the next step: one Newton step per millisecond, within the contacts.
//
// Threads: set_up() on [main]; the rest [rt], nothing allocates.
#pragma once

#include <swage/step.hpp>

#include <array>
#include <span>

#include "form.hpp"
#include "toolkit/bent_wire.hpp"

namespace swage::needle {

using toolkit::Frame;
using toolkit::JointMemory;
using toolkit::Mat3;
using toolkit::Pose;

inline Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }
inline void put(const Vec3& a, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = a[i];
}
/// Normalises; exact to rounding for a quaternion whose length is off by rounding.
inline void renormalise(toolkit::Quat& q) { q.coeffs() *= 1.5 - 0.5 * q.squaredNorm(); }

/// The state kept from step to step besides the poses. Followed by one JointMemory per joint.
struct BendingState {
  double v[3];      // m/s, of the centre of mass
  double L[3];      // kg m2/s, angular momentum about it
  double held;      // 1: contacts pushed in the last step
  double answered;  // 1: the contact solve has queried the mobility in this step
  double base;      // index of the base piece when contacts last pushed
  double told;      // reported events. 1: collapsed, 2: broken, 3: both
};

class Bending {
 public:
  /// Largest number of contact points of one step; the host passes at most 96.
  static constexpr int kMaxPoints = 96;

  /// n pieces of the needle. X_B0P: of the middle piece in body 0, which carries it.
  void set_up(int n, const Form& form, const Pose& X_B0P);
  int pieces() const { return n_; }
  int middle() const { return n_ / 2; }
  uint32_t n_state() const;
  double piece_sweep() const { return wire_.piece_sweep(); }
  double radius() const { return wire_.radius(); }

  void reset(const Step& step) const;
  void advance(const Step& step);
  void mobility(const Step& step, std::span<const swage_contact_point> points, double* v_free, double* W);
  void apply_impulses(const Step& step, std::span<const swage_contact_point> points, const double* impulse);

  /// Pose of piece i in W.
  Pose piece(const Step& step, int i) const;
  /// Index of the piece that is a body of the object, and back: body 0 is the middle piece.
  int piece_of(uint32_t body) const {
    return body == 0                            ? middle()
           : static_cast<int>(body) <= middle() ? static_cast<int>(body) - 1
                                                : static_cast<int>(body);
  }
  uint32_t body_of(int piece) const {
    return static_cast<uint32_t>(piece == middle() ? 0 : piece < middle() ? piece + 1 : piece);
  }

  /// Largest stress over first yield; sum of the permanent angles; largest damage; number of broken joints.
  struct Reading {
    double stress = 0, bend = 0, damage = 0, broken = 0;
  };
  Reading read(const Step& step) const;
  /// Place along the wire, 0 at the point to 1 at the swage, where it first collapsed in this attempt, that is, its whole section became
  /// plastic, and where it broke; below 0: it did not, or that has been reported.
  struct End {
    double collapsed = -1, broke = -1;
  };
  End end(const Step& step) const;

 private:
  static constexpr int kMax = toolkit::BentWire::kMaxPieces;
  struct Rigid {
    double mass = 0;              // kg
    Vec3 centre = Vec3::Zero();   // m
    Mat3 inertia = Mat3::Zero();  // kg m2 about it

    Rigid seen_from(const Pose& X_AB) const;  // of frame B, in A
    Rigid with(const Rigid& other) const;     // both of one frame
  };
  struct Twist {
    Vec3 v = Vec3::Zero(), w = Vec3::Zero();  // of the centre of mass, m/s; rad/s
  };
  struct Touch {
    int piece = 0;
    Vec3 p_W, arm_W;  // m, position; m, position from the centre of mass (q below)
    // parts of its mobility that do not depend on the other point: [q] I^-1, and with its Reach [q] turn - arm', shift - [q] arm
    Mat3 turn, by, shift;
  };
  /// Sums over the joints between a piece and the base, for the piece's motion. With S = R F R'/h^2 of a joint at x from the centre
  /// of mass: S, S [x]' and [x] S [x]', and the velocity of springing back without contacts.
  struct Reach {
    Mat3 turn = Mat3::Zero(), arm = Mat3::Zero(), shift = Mat3::Zero();
    Vec3 w = Vec3::Zero(), v = Vec3::Zero();  // rad/s; m/s, at the centre of mass
  };
  struct Force {      // not initialised: there is room for many, and few are in use
    double s;         // m along the wire, from the middle of the first piece
    int piece, dent;  // joint in whose dent the force is, or -1
    Vec3 f_W, p_W;    // N; m, on the centre line
  };
  struct Load {
    int piece = 0;
    Vec3 f_W, t_W, p_W;  // N, N m about p, m
  };
  static size_t at(int i) { return static_cast<size_t>(i); }
  static BendingState& state(const Step& step) {
    return *static_cast<BendingState*>(static_cast<void*>(step.state().data()));
  }
  static JointMemory* joints(const Step& step) {
    void* first = step.state().data() + sizeof(BendingState) / sizeof(double);
    return static_cast<JointMemory*>(first);
  }

  void follow_joints(const JointMemory* memory);
  Rigid weigh(int root);
  void take_loads(const Step& step, const Rigid& start);
  void fly(const Step& step, const Rigid& start);
  void spin_by_loads(const Step& step);
  void carry(const Step& step, const Twist& V, const Rigid& start);
  uint32_t calmer(const Step& step) const;
  void relax(const Step& step) const;
  void place(int base, const Pose& X_WP);
  void write(const Step& step, int base) const;
  void write_piece(const Step& step, int i, const Vec3& w_W) const;
  void load_joints();
  double load_share(const JointMemory* memory) const;
  int along(const double* impulse, double h, std::span<Force> force);
  Force force_at(const Touch& t, const Vec3& f_W) const;
  double peak(const double* impulse, double h);
  void collect(const Step& step, std::span<const swage_contact_point> points);
  int carrier(const BendingState& s, std::span<const swage_contact_point> points) const;
  static Mat3 turn_of(const Mat3& M, const Vec3& q);
  void give(const JointMemory* memory, double h);
  Vec3 free_velocity(int point, double h) const;
  Mat3 mobility(const Touch& a, const Touch& b) const;
  void bear(const double* impulse, double h, Vec3* m) const;

  int n_ = 0;
  toolkit::BentWire wire_;
  Pose X_B0P_, X_PB0_;           // pose of the middle piece in body 0, and its inverse
  std::array<Rigid, kMax> own_;  // of each piece, in P

  // Results that depend on the joints' rotations alone, computed anew where one has changed: a needle that keeps its shape costs little.
  std::array<JointMemory, kMax> known_;     // rotations for which the results below are valid
  std::array<Pose, kMax> over_, back_;      // of piece j + 1 in P_j, of piece j in P_j+1
  std::array<Rigid, kMax> before_, after_;  // all pieces before i and all after it, in P_i
  int before_known_ = 0, after_known_ = 0;  // before_ is valid up to this piece, and after_ from this one on
  std::array<bool, kMax> moved_{};          // joints that have turned in this step

  // valid within the present step
  std::array<Pose, kMax> X0_, X_;  // poses of the pieces, at the start of the step and now
  bool as_one_ = true;             // since the start of the step all pieces have moved as one rigid body
  Mat3 back_W_ = Mat3::Zero();     // rotation back to the start, where as_one_
  Pose X0_WB0_;                    // pose of body 0 at the start of the step
  Rigid whole_;                    // in W, now
  Mat3 inverse_ = Mat3::Zero();    // inverse of its inertia
  Vec3 L_start_ = Vec3::Zero();    // at the start of the step, with the impulses of the loads
  Twist free_, expected_;          // without contacts; the twist that advance() used
  int base_ = 0;                   // index of the base piece
  int low_ = 0, high_ = 0;         // joints [low_, high_) are between the base and the contact points
  int n_touch_ = 0, n_load_ = 0;
  double peak_ = 0;  // greatest stress under the contacts of this step, over first yield
  std::array<Touch, kMaxPoints> touch_;
  std::array<Load, kMax> push_;  // wrenches on pieces, from other objects
  std::array<Vec3, kMax> load_;  // N m, their moments on the joints
  std::array<Frame, kMax> joint_;
  std::array<Mat3, kMax> F_;
  std::array<bool, kMax> flows_{};
  std::array<Reach, kMax> reach_;
  std::array<Mat3, kMax> R_;  // rotation matrices of the pieces in contact
};

}  // namespace swage::needle
