// SPDX-License-Identifier: Apache-2.0
//
// swage.object.thread: a suture that hangs, bends, twists, is held and breaks. Model and limits: thread.md.
#pragma once

#include <swage/object.hpp>
#include <swage/units.hpp>

#include <vector>

#include "toolkit/rod.hpp"

namespace swage::thread {

enum class Start : int { kStraight, kHanging, kCoil };
enum class End : int { kFree, kFixed };
enum class Around : int { kAir, kWater };

struct ThreadParams {
  Start start = Start::kStraight;
  double length = 20e-3;  // m
  int segments = 32;
  double coil_radius = 3e-3;  // m
  End first = End::kFree, last = End::kFree;
  Around around = Around::kAir;
  double diameter = 22e-6;  // m
  double young = 2.5e9;     // Pa
  double poisson = 0.39;
  double density = 1140;   // kg/m3
  double memory = 0;       // 1/m
  double strength = 0.19;  // N
};

class Thread final : public Object<ThreadParams>, public Solid, public Graspable, public Solver {
 public:
  static constexpr auto id = "swage.object.thread";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Thread";
  static constexpr auto summary =
      "A suture: a thin elastic rod that stretches, bends and twists, in air or under water; breaks where it "
      "is "
      "pulled too hard.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const char* kStarts[] = {"straight", "hanging", "coil", nullptr};
  static constexpr const char* kEnds[] = {"free", "fixed", nullptr};
  static constexpr const char* kAround[] = {"air", "water", nullptr};
  static constexpr std::array fields = {
      choice<&ThreadParams::start>("start", "Start shape", kStarts,
                                   "Straight along x, hanging along -z, or a coil about z, from the origin."),
      real<&ThreadParams::length>("length", "Length", "m", "mm", 1e-3, 0.3, "Unloaded."),
      integer<&ThreadParams::segments>("segments", "Segments", 4, 48,
                                       "Straight pieces: each is one body of the scene."),
      real<&ThreadParams::coil_radius>("coil_radius", "Coil radius", "m", "mm", 0.2e-3, 50e-3,
                                       "Of the start shape coil."),
      choice<&ThreadParams::first>("first", "First end", kEnds, "Fixed: place and direction are kept."),
      choice<&ThreadParams::last>("last", "Last end", kEnds, "Fixed: place and direction are kept."),
      choice<&ThreadParams::around>("around", "Surroundings", kAround, "What drags on it and bears it up."),
      real<&ThreadParams::diameter>("diameter", "Diameter", "m", "um", 5e-6, 1e-3, "10-0: 20 to 29 um.")
          .group("Material"),
      real<&ThreadParams::young>("young", "Young's modulus", "Pa", "GPa", 1e6, 1e12, "Nylon about 2.5 GPa.")
          .group("Material"),
      real<&ThreadParams::poisson>("poisson", "Poisson's ratio", "1", "1", 0, 0.5,
                                   "Gives the stiffness against twisting.")
          .group("Material"),
      real<&ThreadParams::density>("density", "Density", "kg/m3", "kg/m3", 100, 25000, "Nylon 1140.")
          .group("Material"),
      real<&ThreadParams::memory>("memory", "Memory", "1/m", "1/m", 0, 1000,
                                  "Curvature to which it goes back unloaded; 0 is straight.")
          .group("Material"),
      real<&ThreadParams::strength>("strength", "Strength", "N", "mN", 1e-4, 100,
                                    "Tension at which it breaks. Knot-pull minimum of 10-0: about 190 mN.")
          .group("Material"),
  };

  void build(const ThreadParams& params, ObjectBuilder& builder) override;
  void reset(const Step& step) override;
  void finish(const Step& step) override;
  void locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) override;

  void advance(const Step& step) override;
  void compliance(const Step& step, std::span<const swage_contact_point> points, double* v_free,
                  double* W) override;
  void yield(const Step& step, std::span<const swage_contact_point> points, const double* impulse) override;

 private:
  static constexpr int kMaxPoints = 96;  // of one step; the host asks for no more
  static constexpr int kSides = 6;       // right-hand sides that are solved together

  /// A point of contact as the rod has it.
  struct Point {
    int edge = 0;
    double s = 0;          // share of the edge from its first node
    toolkit::Vec3 t, arm;  // unit; m, from the centre line
  };
  static size_t at(int i) { return static_cast<size_t>(i); }
  int nodes() const { return params_.segments + 1; }
  toolkit::RodState state(const Step& step) const { return {nodes(), step.state().data()}; }
  /// What lasts beside the rod: edges that have parted, and whether contacts pushed in the last step.
  double* parted(const Step& step) const { return step.state().data() + toolkit::RodState::size(nodes()); }
  double& held(const Step& step) const { return parted(step)[params_.segments]; }

  toolkit::Vec3 start_node(int i) const;
  toolkit::Pose segment(const toolkit::RodState& s, int j) const;
  toolkit::RodLoad load(const Step& step) const;
  void take_parted(const Step& step);
  void part(const Step& step) const;
  void write(const Step& step, const toolkit::RodState& before, const toolkit::RodState& now) const;
  Point point(const swage_contact_point& c) const;
  /// Velocity-like numbers of all unknowns (`line` apart) at a point.
  toolkit::Vec3 at_point(const Point& p, const double* unknowns, int line) const;
  void push(const Point& p, const toolkit::Vec3& f, double* unknowns, int line) const;
  void hold_sides();

  ThreadParams params_;
  toolkit::Rod rod_;
  toolkit::Pose X_OB0_;
  Body first_;
  Signal tension_first_, tension_last_, tension_, bend_radius_, parted_;

  // of the present step
  std::vector<double> begun_, base_;  // states: at its start, and about which it is linear
  std::vector<double> sides_;         // kSides right-hand sides
  std::vector<double> force_, torque_;
  std::vector<Point> point_;
};

}  // namespace swage::thread
