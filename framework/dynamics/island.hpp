// SPDX-License-Identifier: Apache-2.0
//
// The contact problem of blocks that touch one another, with the geometry linearised at the present poses: find d with
//
//     F(d) = A (x + d - x_hat) - sum over contacts of J' f(u + J d) = 0.
//
// f is Coulomb's law of a compliant contact (contact_law.hpp). Newton's method on F with a line search; where that stalls, its
// path is followed from piece to piece of the law; where that does not converge, a convex problem with the friction limits held
// (Tresca). README.md. The unknowns are d, or the forces of the constraints: space.hpp.
//
// Threads: the solver is built on [main]; solve() is [rt] and neither allocates nor throws.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "dynamics/contact_law.hpp"
#include "dynamics/dof_block.hpp"
#include "dynamics/scales.hpp"
#include "dynamics/sparse_room.hpp"
#include "dynamics/tie.hpp"

namespace swage::dynamics {

/// The pieces of its law that a constraint is on: of a contact, or of a tie.
struct Pieces {
  Piece contact = Piece::kOpen;
  TiePieces tie;
};

/// One contact or tie in an island. Side a pushes with +f, side b with -f; a side that cannot be moved has no columns.
struct Constraint {
  uint32_t contact = 0;         // in the contact set, or among the ties
  const TieLaw* tie = nullptr;  // of a tie, else nullptr: n is then its axis, and g the displacement along it
  uint32_t block_a = UINT32_MAX, block_b = UINT32_MAX;  // among those of the island; none: cannot be moved
  uint32_t point_a = 0, point_b = 0;                    // on flexible bodies
  uint32_t size_a = 0, size_b = 0;                      // columns of J of either side
  uint32_t offset_a = 0, offset_b = 0;                  // of the unknowns in the island
  Surface surface;
  Vec3 n, t1, t2;          // axes in W
  Displacement at;         // at the linearisation; its gap counts from `relaxed_gap`
  double relaxed_gap = 0;  // m, gap at which retarded surfaces stop pushing
  Force before;            // force of the last step or pass, in the present axes
  const double* J =
      nullptr;  // 3 x (size_a + size_b), row-major: d(g, s1, s2) / d(unknowns of a, unknowns of b)

  // --- results of solve()
  Displacement u;
  Force f;
  double limit = 0;  // N, of friction
  Pieces on;
  Force projected;         // project() only: the iterate of the force
  Displacement along;      // displacement along the Newton step
  Tangent D;               // tangent in the last system
  Displacement last_step;  // from `at` to `u`, in the last pass
  // N on a, in W; contact space only. The force that flexible bodies get: it is f but for the tolerance of the solve, 1e-10 m or, at
  // 1e6 N/m, 0.1 mN, which would throw a needle of 0.4 mg by a quarter of a millimetre
  Vec3 y = Vec3::Zero();
};

struct Island {
  std::span<DofBlock* const> blocks;
  std::span<Constraint> constraints;
  uint32_t size = 0;           // numbers of d
  bool contact_space = false;  // solved for the forces: flexible bodies are among the blocks
  bool banded = false;         // bands are among the blocks: solved sparse unless in contact space
};

/// How a solve ended.
struct Outcome {
  bool converged = false;   // the last correction was below the tolerance
  bool limits_hold = true;  // and every friction limit is mu f_n, to a thousandth of the largest
  bool fell_back = false;   // Newton's method alone did not converge
  bool held = false;        // friction limits are held from here on
  uint32_t newton = 0;      // linear systems solved
  uint32_t rounds = 0;      // convex problems solved
  double moved = 0;         // m, from the pose of the linearisation
};

/// How friction limits are found.
enum class Limits : uint8_t {
  kCoulomb,  // mu f_n
  kHeld,     // Constraint::limit as it stands: convex, so that passes do not alternate
};

/// True when a tangent is not zero: its constraint resists.
inline bool stiffens(const Tangent& D) { return D.nn != 0 || D.t11 != 0 || D.t22 != 0; }

class Space;

/// What a path meets along the direction from where it is.
struct Bend {
  uint32_t constraint = UINT32_MAX;  // that comes to the end of its piece; none: the direction leads to where F would vanish
  Pieces next;                       // of that constraint, beyond
  double fraction = 1;               // of the direction, at which it does
  double far = 0;                    // m, length of the direction
  bool down = true;                  // the direction leads down |F|; else it was reversed
};

class IslandSolver {
 public:
  /// Constraints of an island with threads whose path is followed: a longer one uses up the budget.
  static constexpr uint32_t kMostBends = 100;

  /// `max_constraints`, `max_hinges`: of an island solved in contact space.
  /// `max_unknowns`: of everything but bands.
  explicit IslandSolver(uint32_t max_unknowns, uint32_t max_constraints = 0, uint32_t max_hinges = 0,
                        const SparseRoom& bands = {});
  ~IslandSolver();

  /// Solves for d, to be added to the blocks' unknowns (d() below), and fills u, f, limit of every constraint.
  Outcome solve(const Island& island, const Scales& scales, Limits limits) noexcept;

  std::span<const double> d() const { return {d_.data(), size_}; }

  /// Begins a step with a budget of multiply-adds. Beyond it each island is left at its best point so far, with friction limits held.
  void begin_step(uint64_t budget) noexcept;
  uint64_t work() const noexcept;
  bool over_budget() const noexcept { return work() > budget_; }

 private:
  void start() noexcept;
  void evaluate(const Island& island, const double* z, Friction friction) noexcept;
  bool search_direction(const Island& island, Friction friction) noexcept;
  bool same_stiffness(const Island& island, Friction friction) noexcept;
  bool make_consistent(const Island& island, Friction friction) noexcept;
  bool begin_where_it_was(const Island& island) noexcept;
  void advance(double fraction) noexcept;
  double negligible_merit(const Island& island, double tolerance) const noexcept;
  bool sticks(const Island& island) const noexcept;
  bool newton(const Island& island, double tolerance) noexcept;
  bool begins_with_projection(const Island& island) const noexcept;
  bool project_first(const Island& island, double tolerance, Outcome& outcome) noexcept;
  void fall_back(const Island& island, const Scales& scales, Outcome& outcome) noexcept;
  void stick_all(const Island& island, double tolerance) noexcept;
  bool hold_limits(const Island& island, double tolerance, uint32_t rounds, Outcome& outcome) noexcept;

  // island_projection.cpp
  bool project(const Island& island, double tolerance, uint32_t steps) noexcept;
  bool search_direction_of_projection(const Island& island) noexcept;
  bool settle(const Island& island, double tolerance) noexcept;

  // island_path.cpp
  bool follow_path(const Island& island, double tolerance) noexcept;
  bool follow_path_near(const Island& island, const Scales& scales, bool consistent) noexcept;
  void evaluate_pieces(const Island& island, const double* z) noexcept;
  bool search_direction_on_pieces(const Island& island) noexcept;
  bool correct_direction_on_pieces(const Island& island, uint32_t changed) noexcept;
  bool look_ahead(const Island& island, Bend& bend, bool may_turn) noexcept;
  bool find_bend(const Island& island, Bend& bend, bool may_turn) noexcept;
  uint32_t first_kink(const Island& island, uint32_t passed, bool turns, double& fraction, Pieces& next) const noexcept;
  bool whole_step(const Island& island, double far, double tolerance, double& merit) noexcept;
  bool on_their_pieces(const Island& island, double tolerance) noexcept;
  bool limits_hold(const Island& island) const noexcept;
  bool minimise(const Island& island, double tolerance) noexcept;
  double slope(const Island& island, double fraction) noexcept;
  double search(const Island& island) noexcept;

  uint64_t budget_ = UINT64_MAX;
  size_t size_ = 0, point_size_ = 0;  // numbers of d, of a point z
  uint32_t touching_ = 0;             // constraints that overlap at the start or bore force; the others may touch within the step
  uint32_t newton_ = 0;
  bool consistent_ = false;  // z_ is a consistent point of the space, not only the start
  bool has_first_ = false;
  bool law_ = false;         // D of the constraints is that of the last system, where only same_stiffness() changes it from here on
  std::unique_ptr<Space> displacement_space_, sparse_space_, contact_space_;
  Space* space_ = nullptr;
  std::vector<double> z_, trial_, step_, d_;
  std::vector<double> before_;  // z_ of the last convex problem
  std::vector<double> first_;   // z_ after the step of begin_where_it_was()
};

}  // namespace swage::dynamics
