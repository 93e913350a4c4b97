// SPDX-License-Identifier: Apache-2.0
//
// What a method must offer to be measured: ours and the peers behind one interface. SI units; each engine
// converts inside.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "scene.hpp"

namespace swage::bench {

struct Setup {
  Needle needle;
  double dt = 1e-3;  // s
  double friction = 0.3;
  double restitution = 0;
  bool jaws = true;             // false: a free body
  bool upper_driven = false;    // the upper jaw turns on its hinge under a torque; otherwise both are moved
  double jaw_mass = 5e-3;       // kg, effective at the grip, when driven
  double misaligned = 0;        // rad, the upper jaw turned about its normal at the grip
  double gravity = 9.81;        // m/s2, where a scenario has gravity
  double ball_radius = 0;       // m; > 0: a ball over the plane z = 0 instead of the needle
  Vec3 inertia = Vec3::Zero();  // kg m2; zero: the needle's own
  double unit = 0;  // lengths per metre inside the engine; 0: its own choice (ours 1, peers 1000) (S01)

  double mass() const {
    if (ball_radius > 0) return needle.density * 4.0 / 3 * std::numbers::pi * std::pow(ball_radius, 3);
    return needle.mass();
  }
  Vec3 moments() const {
    if (inertia.x() > 0) return inertia;
    if (ball_radius > 0) return Vec3::Constant(0.4 * mass() * ball_radius * ball_radius);
    return needle.inertia();
  }
};

class Engine {
 public:
  explicit Engine(const Setup& s) : setup(s) {}
  virtual ~Engine() = default;
  const Setup setup;

  virtual void set_needle(const Pose& X_WN, const Vec3& v_W, const Vec3& w_W) = 0;
  virtual Pose needle() const = 0;
  /// Poses of the needle within the last step and at its end, in the order of time, where its motion is known better than by those at
  /// the ends of the step: from one to the next its twist is constant. Empty: it is not.
  virtual std::vector<Pose> way() const { return {}; }
  virtual Vec3 velocity() const = 0;          // m/s of the centre of mass
  virtual Vec3 angular_velocity() const = 0;  // rad/s in W
  virtual void set_gravity(const Vec3& g) = 0;
  /// Poses at the end of the next step; `jump` puts the jaws there at once and at rest.
  virtual void set_jaws(const Pose& upper, const Pose& lower, bool jump) = 0;
  virtual void set_torque(double closing) = 0;                   // N m on the driven jaw during the next step
  virtual void set_force(const Vec3& f_W, const Vec3& p_W) = 0;  // N on the needle during the next step
  virtual void set_couple(const Vec3& t_W) = 0;                  // N m on the needle during the next step
  /// How far the body whose pose needle() is turns against the place of the grip per couple on it [rad / N m]: a wire that bends gives
  /// there before anything slips.
  virtual Vec3 gives() const { return Vec3::Zero(); }
  virtual void step() = 0;
  virtual Pose upper() const = 0;                   // of the upper jaw
  virtual int contacts(double& deepest) const = 0;  // deepest gap, m, negative when overlapping
  /// Which contacts there are, as a number that differs when they differ; engines that name none give their count.
  virtual uint64_t contact_set() const {
    double deepest;
    return static_cast<uint64_t>(contacts(deepest));
  }
};

/// A method with settings, by the name that charts show.
struct Method {
  std::string name;    // "ODE exact, soft contacts"
  std::string family;  // "swage", "thesis", "ODE", "MuJoCo", "Bullet", "FCL": colour of the chart
  std::function<std::unique_ptr<Engine>(const Setup&)> make;
  bool exact_arc = false;  // touches with the true arc rather than a chain of spheres
  /// Which charts tell it from its siblings: a setting of contacts moves freely as they do, and the other way round.
  enum class Differs { kEverywhere, kInContact, kFree, kNowhere } differs = Differs::kEverywhere;
};

/// Which jaws overlap the needle, and how deep.
struct Gaps {
  double gap[2] = {1e9, 1e9};  // m, negative when overlapping; 1e9: nothing reported
  int contacts = 0;
};

/// A collision query over needle and jaws, without dynamics.
struct Query {
  std::string name, family;
  bool exact_arc = false;  // knows the true arc rather than a chain or capsules
  std::function<Gaps(const Pose& needle, const Pose& upper, const Pose& lower)> run;
};

// What is compiled in; peers that are not installed give empty lists.
std::vector<Method> swage_methods();
std::vector<Method> ode_methods();
std::vector<Method> mujoco_methods();
std::vector<Method> bullet_methods();
std::vector<Query> swage_queries(const Needle&);
std::vector<Query> ode_queries(const Needle&);
std::vector<Query> mujoco_queries(const Needle&);
std::vector<Query> bullet_queries(const Needle&);
std::vector<Query> fcl_queries(const Needle&);

/// All of them, ours first.
std::vector<Method> all_methods();
std::vector<Query> all_queries(const Needle&);

}  // namespace swage::bench
