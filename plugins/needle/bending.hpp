// SPDX-License-Identifier: Apache-2.0
//
// A needle that bends, as the contact solve sees it. The wire is a chain of arcs (toolkit/bent_wire.hpp) whose shape follows
// the contact forces at once; the whole moves with the mass and the inertia of a rigid body of its present shape, carried by a
// piece that is touched. Per step, with h its length, f = j/h the forces and G, F gains and flexibilities of the joints:
//
//   v = v_rigid - (1/h) sum G F m_now  +  W j,     W = J M^-1 J' + (1/h^2) sum G F G'
//
// Then each joint is turned by F (G' f - m_now) and the law says what moment it really bears. What is left over is
// in m_now of the next step: one Newton step per millisecond, which never leaves the contacts.
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
/// Back to unit length; exact to rounding for a quaternion that left it by rounding.
inline void renormalise(toolkit::Quat& q) { q.coeffs() *= 1.5 - 0.5 * q.squaredNorm(); }

/// What lasts from step to step besides the poses. Followed by one JointMemory per joint.
struct BendingState {
  double v[3];      // m/s, of the centre of mass
  double L[3];      // kg m2/s, about it
  double held;      // 1: contacts pushed in the last step
  double answered;  // 1: contacts asked in this step
  double base;      // piece that carried the others when contacts last pushed
  double told;      // 1: that it gave way, 2: that it broke, 3: both
};

class Bending {
 public:
  /// Contact points of one step that are answered; the host asks for at most 96.
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
  /// Which piece a body of the object is, and back: body 0 is the middle one.
  int piece_of(uint32_t body) const {
    return body == 0                            ? middle()
           : static_cast<int>(body) <= middle() ? static_cast<int>(body) - 1
                                                : static_cast<int>(body);
  }
  uint32_t body_of(int piece) const {
    return static_cast<uint32_t>(piece == middle() ? 0 : piece < middle() ? piece + 1 : piece);
  }

  /// Largest share of first yield; angles that stay, summed; largest damage; joints broken.
  struct Reading {
    double stress = 0, bend = 0, damage = 0, broken = 0;
  };
  Reading read(const Step& step) const;
  /// Where along the wire, from 0 at the point to 1 at the swage, it gave way for the first time in this attempt, its whole section
  /// plastic, and where it broke; below 0: it did not, or that has been told.
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
    Vec3 p_W, arm_W;  // m; q, from the centre of mass
    // of its mobility what does not depend on the other point: [q] I^-1, and with its Reach [q] turn - arm', shift - [q] arm
    Mat3 turn, by, shift;
  };
  /// What the joints between a piece and the one that carries do to it, summed. With S = R F R'/h^2 of a joint at x from the centre
  /// of mass: S, S [x]' and [x] S [x]', and the motion that its springing back makes.
  struct Reach {
    Mat3 turn = Mat3::Zero(), arm = Mat3::Zero(), shift = Mat3::Zero();
    Vec3 w = Vec3::Zero(), v = Vec3::Zero();  // rad/s; m/s, at the centre of mass
  };
  struct Force {      // left as it is: there is room for many, and few push
    double s;         // m along the wire, from the middle of the first piece
    int piece, dent;  // joint beside which it is in the dent, or -1
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
  Pose X_B0P_, X_PB0_;           // of the middle piece in body 0, and back
  std::array<Rigid, kMax> own_;  // of each piece, in P

  // What follows from the turns of the joints alone, found again where one has changed: an arm that keeps its shape costs little.
  std::array<JointMemory, kMax> known_;     // whose turns the rest is for
  std::array<Pose, kMax> over_, back_;      // of piece j + 1 in P_j, of piece j in P_j+1
  std::array<Rigid, kMax> before_, after_;  // all pieces before i and all after it, in P_i
  int before_known_ = 0, after_known_ = 0;  // before_ up to this one and after_ from this one on are right
  std::array<bool, kMax> moved_{};          // joints that have turned in this step

  // of the present step
  std::array<Pose, kMax> X0_, X_;  // of the pieces, at its start and now
  bool as_one_ = true;             // from there to now all pieces have gone as one
  Mat3 back_W_ = Mat3::Zero();     // and this turns them back
  Pose X0_WB0_;                    // of body 0 at its start
  Rigid whole_;                    // in W, now
  Mat3 inverse_ = Mat3::Zero();    // of its inertia
  Vec3 L_start_ = Vec3::Zero();    // at its start and with the loads of the step
  Twist free_, expected_;          // without contacts; what the poses of advance() follow
  int base_ = 0;                   // piece that carries
  int low_ = 0, high_ = 0;         // joints [low_, high_) are between it and the points
  int n_touch_ = 0, n_load_ = 0;
  double peak_ = 0;  // greatest stress under the contacts of this step, over first yield
  std::array<Touch, kMaxPoints> touch_;
  std::array<Load, kMax> push_;  // wrenches on pieces
  std::array<Vec3, kMax> load_;  // N m, that they put on the joints
  std::array<Frame, kMax> joint_;
  std::array<Mat3, kMax> F_;
  std::array<bool, kMax> flows_{};
  std::array<Reach, kMax> reach_;
  std::array<Mat3, kMax> R_;  // attitudes of the pieces that touch
};

}  // namespace swage::needle
