// SPDX-License-Identifier: Apache-2.0
//
// An open overhand knot in a long thread: n turns of a braid and the loop that they close, with tails along -x and +x, in the host's
// own detector and solver, without plugins. The trefoil has one turn.
//
//                  .-- loop --.
//                 (            )
//     tail  -------\/\/ braid \/-------  tail        braid: two strands, 2 n + 1 half turns about each other
//
// Steps are divided as those of a lesson are (step/division.hpp). It starts near its equilibrium. Both ends are held in their places: hinged,
// so that they may turn about the thread, or clamped. Units SI. Threads: [main].
#pragma once

#include <memory>
#include <vector>

#include "../unit/dynamics/divided_steps.hpp"
#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"

namespace swage::test {

using toolkit::Vec3;

struct OpenKnotTest {
  int turns = 1;
  double loop = 1e-3;    // m, radius of the two halves of the loop as it is laid
  double braid = 0;      // m, straight between them, beside the braid and above it
  double tail = 6e-3;    // m, from the middle of the braid to an end
  double friction = 0;
  double fine = 22e-6, coarse = 150e-6;  // m, of segments in the braid and far from it
  // of 10-0 nylon, as resources/threads has it
  double diameter = 22e-6, young = 2.5e9, poisson = 0.39, density = 1140;
  double stiffness = 5e4;  // N/m, of a contact of the thread with itself
  double dt = 1e-3;        // s
  bool clamped = false;    // ends keep their direction and do not turn about the thread
};

class OpenKnot {
 public:
  explicit OpenKnot(const OpenKnotTest& test);

  /// Steps until the pull changes by less than `share` of itself in 50 steps, or so many steps. Steps that it took.
  int relax(int most, double share = 1e-4);
  /// Ends go apart (loosening: together) by so much each [m], at `speed` [m/s].
  void draw(double each, double speed);
  void set_friction(double mu) { friction_ = mu; }
  /// A step of OpenKnotTest::dt, in parts where it is too far for one.
  void step();

  double pull() const;               // N, mean of the two ends
  double shortening() const;         // m, length of the thread less the distance between its ends
  double bending() const;            // N m2
  double apex_curvature() const;     // 1/m, greatest part of the loop: where the thread is farthest from the ends' line
  double apex_tension() const;       // N, there
  double pressing() const { return pressing_; }  // N, sum of the contact forces
  int passages() const { return passages_; }
  uint64_t not_converged() const { return solve_->stats().health.total(); }
  double strayed() const { return solve_->stats().strayed; }  // radii, of the last step: how far it went beyond what its contacts say
  size_t contacts() const { return bearing_; }
  double overlap() const { return overlap_; }
  /// Twist and writhe of the thread, its ends joined far away [turns]: constant while clamped ends hold and nothing passes.
  double linking() const;
  double from_an_end() const;  // m, along the thread from the farthest part of the loop to the nearer end
  uint64_t divided() const { return steps_->divided(); }  // steps, and parts of steps, that were done in parts
  int nodes() const { return n_; }
  Vec3 node(int i) const { return const_cast<OpenKnot*>(this)->rod_->state().node(i); }
  toolkit::Rod& rod() { return rod_->rod(); }

 private:
  int apex() const;
  void begin_part();

  OpenKnotTest test_;
  std::vector<Vec3> laid_;
  scene::World world_;
  std::unique_ptr<dynamics::RodBody> rod_;
  int n_ = 0;
  std::vector<double> boxes_, before_;  // of passages
  std::unique_ptr<contact::Detector> detector_;
  std::unique_ptr<dynamics::Dynamics> solve_;
  std::unique_ptr<dynamics::DividedSteps> steps_;
  contact::ContactSet contacts_;
  double friction_ = 0, speed_ = 0, overlap_ = 0, pressing_ = 0, time_ = 0;
  int passages_ = 0;
  size_t bearing_ = 0;
};

}  // namespace swage::test
