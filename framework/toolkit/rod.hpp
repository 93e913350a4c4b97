// SPDX-License-Identifier: Apache-2.0
//
// A thin elastic rod: a chain of n nodes with a director on each edge (discrete elastic rod, Bergou et al. 2008 and 2010), of round
// section, that stretches, bends and twists. Unknowns are the nodes' positions and the edges' rotations about their axes, in the
// order x0 theta0 x1 theta1 .. x(n-1), so that a node is coupled to 10 unknowns before and after: the Hessian is a band.
//
//   m/h^2 (x - x_hat) + dE/dx = 0        backward Euler; second_order: BDF2, for rods in free flight
//   I/h^2 (theta - theta_0) + dE/dtheta = 0       no angular velocity: 1e-7 of the twisting stiffness, only holds torque-free edges
//
// An end that is clamped has one more joint, over half an edge, between the direction of the clamp and the first edge (half-cell
// clamp): the deflection is of order 2 in the length of the edges, where a frozen first edge is of order 1.
// Newton's method on the whole step; the tension that stiffens an edge against turning is that of the linear model of the last
// iteration (an unknown of its own, eliminated), so that a step which turns an edge does not stretch it.
//
// State is the caller's (RodState). Frames: all vectors in W. SI units. Header-only.
// Threads: built on [main]; the rest [rt], nothing allocates.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "toolkit/band.hpp"
#include "toolkit/rod_assembly.hpp"
#include "toolkit/rod_drag.hpp"
#include "toolkit/rod_edges.hpp"
#include "toolkit/rod_joint.hpp"

namespace swage::toolkit {

struct RodSection {
  double stretching = 0;  // N, EA
  double bending = 0;     // N m2, EI; 0: a chain (catenary)
  double twisting = 0;    // N m2, GJ; 0: directors only follow their edges
  double mass = 0;        // kg/m
  double radius = 0;      // m

  /// Of a round wire. E: Pa; density: kg/m3.
  static RodSection round(double diameter, double youngs, double poisson, double density) {
    const double r = 0.5 * diameter, A = std::numbers::pi * r * r, I = 0.25 * A * r * r;
    return {youngs * A, youngs * I, youngs * I / (1 + poisson), density * A, r};
  }
};

/// Bending beyond which a rod stays bent (rod_flow.hpp).
struct RodYield {
  double curvature = 0;  // 1/m, at which its moment leaves the elastic line; 0: it never does
  double hardening = 0;  // share of its stiffness that is left there, from 0 to less than 1

  /// Of a round section whose material yields at a strain of `strain`. The moment of a section that yields throughout is 16 / (3 pi) of
  /// that at first yield; the curvature is where the elastic line reaches it.
  static RodYield round(double diameter, double strain, double hardening) {
    return {16 / (3 * std::numbers::pi) * strain / (0.5 * diameter), hardening};
  }
};

/// State that lasts from step to step, in size(n) numbers of the caller.
struct RodState {
  int n = 0;
  double* x = nullptr;         // [3 n] m
  double* v = nullptr;         // [3 n] m/s
  double* director = nullptr;  // [3 (n - 1)] unit, perpendicular to its edge
  double* twist = nullptr;     // [n] rad at the nodes, whole turns counted; at an end where it is clamped
  double* before = nullptr;    // [6 n] x and v of the step before, for second_order
  double* steps = nullptr;     // [1] number of steps kept there

  RodState() = default;
  RodState(int nodes, double* numbers)
      : n(nodes),
        x(numbers),
        v(x + 3 * n),
        director(v + 3 * n),
        twist(director + 3 * (n - 1)),
        before(twist + n),
        steps(before + 6 * n) {}
  /// Nodes and velocities, 6 n, in one place and directors and twists, 4 n - 3, in another; not for second_order.
  RodState(int nodes, double* nodes_at, double* frames_at)
      : n(nodes), x(nodes_at), v(x + 3 * n), director(frames_at), twist(director + 3 * (n - 1)) {}
  static size_t size(int n) { return static_cast<size_t>(3 * n + 3 * n + 3 * (n - 1) + n + 6 * n + 1); }

  static size_t frames(int n) { return static_cast<size_t>(4 * n - 3); }
  /// All but `before`.
  void copy(const RodState& from) const {
    std::copy_n(from.x, 3 * n, x), std::copy_n(from.v, 3 * n, v);
    std::copy_n(from.director, 3 * (n - 1), director), std::copy_n(from.twist, n, twist);
  }

  Vec3 node(int i) const { return Eigen::Map<const Vec3>(x + 3 * i); }
  Vec3 velocity(int i) const { return Eigen::Map<const Vec3>(v + 3 * i); }
  Vec3 edge(int j) const { return node(j + 1) - node(j); }
  Vec3 material(int j) const { return Eigen::Map<const Vec3>(director + 3 * j); }
};

/// The fixed direction of an end, and the director there.
struct RodClamp {
  bool on = false;
  Vec3 tangent = Vec3::UnitX(), director = Vec3::UnitY();
};

/// The load of a step. Empty spans are zero.
struct RodLoad {
  double h = 0;                    // s; 0: statics, nothing has mass
  Vec3 gravity = Vec3::Zero();     // m/s2
  std::span<const double> force;   // [3 n] N on the nodes
  std::span<const double> torque;  // [n - 1] N m on the edges about their axes
  std::span<const double> spring;  // [6 n] N/m, xx yx zx yy zy zz, to the nodes' places at the start of the step
  RodFluid fluid;                  // its drag, buoyancy and added mass
  bool second_order = false;
};

struct RodEffort {
  int iterations = 0;    // linear solves
  bool settled = false;  // the last change was below the tolerance
  double change = 0;     // m, of the last iteration
};

class Rod {
 public:
  static constexpr int kHalfBand = 10;
  using Matrix = Band<kHalfBand>;

  Rod() = default;
  /// `rest`: lengths of the edges [m]. Unloaded it is straight, or bent by `memory` [1/m] about its directors (a circle).
  Rod(const RodSection& section, std::span<const double> rest, double memory = 0);

  int nodes() const { return n_; }
  int edges() const { return n_ - 1; }
  int unknowns() const { return 4 * n_ - 1; }
  const RodSection& section() const { return section_; }
  double rest_length(int j) const { return rest_[at(j)]; }
  double rest_length() const { return length_; }
  double node_mass(int i) const { return mass_[at(i)]; }

  RodClamp& clamp(int end) { return clamp_[end]; }
  /// Holds a node: it stays, or moves as the caller puts it.
  void hold(int node, bool on = true) { held_[at(node)] = on; }
  /// Cuts an edge: it bears nothing, and the ends on its two sides are free.
  void cut(int edge, bool on = true) { cut_[at(edge)] = on; }
  /// Holds the rotation of an edge about its axis.
  void hold_turn(int edge, bool on = true) { turn_held_[at(edge)] = on; }

  /// Bends to natural curvatures of the caller from here on, two numbers a node (rod_flow.hpp), which must outlast their use; nullptr: to
  /// `memory` again.
  void remember(const double* set) { set_ = set; }
  /// Sets those to `memory`.
  void start_set(double* set) const;
  /// Lets joints flow that are bent beyond `yield`, between two steps: `set` follows. Twist and stretch do not flow.
  void flow(const RodState& s, const RodYield& yield, double* set) const;

  /// Sets directors without twist and zero velocities; s.x is given.
  void start(RodState& s) const;
  /// Updates the twist at the clamps after one has turned, by less than half a turn.
  void follow_clamps(RodState& s) const;
  /// One step in time, or (h = 0) the shape at rest. `tolerance` [m], of the last change.
  RodEffort step(RodState& s, const RodLoad& load, int iterations, double tolerance);

  /// Advances all nodes by h v, but for the part that alternates from node to node. False: only held nodes, as it would stretch an edge
  /// by more than `most_strain` or turn it by more than the linear model allows.
  bool go_on(RodState& s, const RodLoad& load, double most_strain);
  /// For contacts: linearises the step that prepare() or step() has begun, about the state `s`. Afterwards matrix() is the factored
  /// Hessian and change() the displacement of the rod from there without contacts. False where the Hessian cannot be factored.
  bool linearise(const RodState& s, const RodLoad& load);
  const double* change() const { return change_.data(); }
  /// The same for a caller that solves for contacts: writes the columns of the matrix (kStride numbers each, 0 on the diagonal of held
  /// unknowns) and the gradient. While the matrix cannot be factored the caller asks again, of the same state and load, with `stiffer`
  /// 1, 2 .., which stiffens a rod that is not stable.
  void linearise(const RodState& s, const RodLoad& load, int stiffer, double* columns, double* gradient);
  /// After that linearise(): moves from `s` by a change of all unknowns.
  void go(const RodState& s, const double* change, RodState& to);
  /// After the first linearise(), about `s`: solves that linear step under additional forces on the unknowns [N, N m], which the changes
  /// overwrite. One solve: the stretch of an edge that turns, of second order, is corrected by the next step.
  void respond(const RodState& s, const RodLoad& load, double* force, RodState& to);
  /// Begins a step at a state; iterate() then continues from any state, with contact forces as a load, and finish() ends the step.
  void prepare(const RodState& start, const RodLoad& load);
  RodEffort iterate(RodState& s, const RodLoad& load, int iterations, double tolerance);
  /// Sets the velocities from the positions reached.
  void finish(RodState& s, const RodLoad& load) const;
  /// True when the equilibrium is stable: the Hessian without mass is positive definite.
  bool stable(const RodState& s, const RodLoad& load);
  const Matrix& matrix() const { return A_; }

  /// Sets the tension that stiffens the edges to that of this state.
  void take_tension(const RodState& s) {
    now_.find(s.x);
    for (int j = 0; j < edges(); ++j)
      tension_[at(j)] = cut_[at(j)] ? 0.0 : section_.stretching * (now_.length(at(j)) / rest_[at(j)] - 1);
  }
  double energy(const RodState& s) const;  // J, elastic
  /// Gradient of the elastic energy, 4 n - 1 numbers, and its Hessian, when asked for.
  void differentiate(const RodState& s, double* gradient, Matrix* hessian) const;
  /// Moves by `share` of a change of all unknowns: directors are transported with their edges and turned about them.
  void move(const RodState& from, const double* change, double share, RodState& to) const;
  double tension(const RodState& s, int j) const;  // N, of an edge
  /// Tension of the linear model after the last iteration: without the stretch of an edge by its turning.
  double linear_tension(int j) const { return cut_[at(j)] ? 0.0 : tension_[at(j)]; }
  /// Angle over length at an inner node [1/m].
  double curvature(const RodState& s, int i) const;
  /// Largest of all inner nodes [1/m].
  double most_curvature(const RodState& s) const;
  /// Twist from the first to the last node, in turns.
  double turns(const RodState& s) const;

 private:
  /// Largest rotation of an edge in one iteration [rad], of its direction and about its axis: the range of the linear model.
  static constexpr double kMostAcross = 0.5, kMostAbout = 1;
  static constexpr int kStiffer = 14;  // attempts to make the matrix definite

  static size_t at(int i) { return static_cast<size_t>(i); }
  /// The column of an unknown in a matrix of columns.
  static double* column(double* columns, int k) { return columns + static_cast<std::ptrdiff_t>(Matrix::kStride) * k; }
  struct Edge {
    Vec3 t;
    double inverse;  // 1/m
  };
  using Derivatives = JointDerivatives<Ones>;
  bool curved() const { return memory_ != 0 || set_ != nullptr; }
  double remembered(int i) const;
  static Edge along(const Vec3& e);
  Edge edge(const RodState& s, int j) const { return along(s.edge(j)); }
  Edge found(int j) const { return {now_.t(at(j)), now_.inverse(at(j))}; }
  RodJoint<Ones> joint(const RodState& s, int i) const;
  RodJoint<Ones> joint(const RodState& s, int i, const Edge& e, const Edge& f) const;
  bool has_joint(int i) const {
    if (i == 0) return clamp_[0].on && !cut_[0];
    if (i == n_ - 1) return clamp_[1].on && !cut_[at(i - 1)];
    return !cut_[at(i - 1)] && !cut_[at(i)];
  }
  double joint_length(int i) const;
  /// Twist between the directors of two edges: of the angles that differ by whole turns the one nearest to `before`.
  static double angle(const Vec3& te, const Vec3& tf, const Vec3& de, const Vec3& df, double before);
  static double turned_from(double before, double m);
  static Vec3 transported(const Vec3& director, const Vec3& from, const Vec3& to);
  static Vec3 carried(const Vec3& director, const Vec3& from, const Vec3& to);
  template <class V>
  [[gnu::always_inline]] inline void differentiate_with(const RodState& s, double* gradient, double* hessian) const;
  /// `hessian`: its 4 n columns of kStride numbers, which are written whole; nullptr: it is not wanted.
  void differentiate_into(const RodState& s, double* gradient, double* hessian) const;
  SWAGE_FOURS void differentiate_by_fours(const RodState& s, double* gradient, double* hessian) const {
    differentiate_with<Fours>(s, gradient, hessian);
  }
  void differentiate_by_twos(const RodState& s, double* gradient, double* hessian) const {
    differentiate_with<Twos>(s, gradient, hessian);
  }
  template <class V>
  [[gnu::always_inline]] inline void take_inner_joints(const RodState& s, int i, int place, bool second) const;
  template <class V>
  [[gnu::always_inline]] inline void take_edges(int j, int place, bool second) const;
  void take_joint(const RodState& s, int i, int place, bool second) const;
  void take_edge(int j, int place, bool second) const;
  template <class V>
  [[gnu::always_inline]] inline void take_four(const RodState& s, int i, bool second) const;
  void begin_linear(const RodState& s);
  void add_drag(const RodState& s, const RodLoad& load);
  template <class V>
  [[gnu::always_inline]] inline void add_drag_of(V v, const RodState& s, const RodFluid& fluid, int j);
  SWAGE_FOURS void add_drag_by_fours(const RodState& s, const RodFluid& fluid) {
    for_each<Fours>(at(edges()), [&](auto v, size_t j) __attribute__((always_inline)) { add_drag_of(v, s, fluid, static_cast<int>(j)); });
  }
  void add_drag_by_twos(const RodState& s, const RodFluid& fluid) {
    for_each<Twos>(at(edges()), [&](auto v, size_t j) __attribute__((always_inline)) { add_drag_of(v, s, fluid, static_cast<int>(j)); });
  }
  void add_pushed(const RodFluid& fluid);
  void add_springs(const RodLoad& load);
  template <class V>
  [[gnu::always_inline]] inline void add_inertia(V v, const RodState& s, const RodLoad& load, double* hessian);
  SWAGE_FOURS void add_inertia_by_fours(const RodState& s, const RodLoad& load, double* hessian) { add_inertia(Fours{}, s, load, hessian); }
  void system(const RodState& s, const RodLoad& load, double* hessian);
  void stiffened_system(const RodState& s, const RodLoad& load, int stiffer, double* columns);
  void shift_diagonal(int stiffer, double* columns);
  bool factor(const RodState& s, const RodLoad& load);
  void slow_turns(const RodState& s, double* columns);
  bool solve(const RodState& s, const RodLoad& load);
  double potential(const RodState& s, const RodLoad& load) const;
  void follow_tension(const RodState& s, const double* change, double share);
  double bounded(const RodState& s) const;
  double search(const RodState& s, const RodLoad& load, double share);
  double twisted(const RodState& s, int i, double before) const;

  int n_ = 0;
  RodSection section_;
  double length_ = 0;                          // m
  double memory_ = 0;                          // 1/m
  std::vector<double> rest_, mass_, tension_;  // m, kg, N
  std::vector<double> remembered_;             // of each joint: natural curvature times its length
  const double* set_ = nullptr;                // of the caller, in their place
  std::vector<char> held_, turn_held_, cut_;
  RodClamp clamp_[2];

  // of the present step
  Matrix A_;
  std::vector<double> x0_, hat_, drag_, pushed_, gradient_, change_, turned_, stored_, trial_;
  std::vector<double> diagonal_;  // of A_, before it was shifted
  mutable RodEdges now_, next_;  // of a state, and after a change
  mutable RodAssembly parts_;
  mutable std::vector<double> gone_, carried_, sine_, cosine_;  // nodes, directors and joints after it
  bool slow_ = false;
  int way_ = -1;     // `stiffer` with which linearise() left A_; -1: it did not
  double g_ = 0;     // s, length of the equivalent backward Euler step
  double m_hh_ = 0;  // 1/s2, 1 / g^2
};

}  // namespace swage::toolkit

#include "toolkit/rod_derivatives.hpp"
#include "toolkit/rod_energy.hpp"
#include "toolkit/rod_flow.hpp"
#include "toolkit/rod_surroundings.hpp"
#include "toolkit/rod_step.hpp"
