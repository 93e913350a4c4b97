// SPDX-License-Identifier: Apache-2.0
//
// Our own rooms behind the interface that the peers stand behind: scene, contact and dynamics, without
// plugins.
#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "engine.hpp"
#include "scene/kinematics.hpp"

namespace swage::bench {
namespace {

enum Body : uint32_t { kNeedle, kUpper, kLower, kBase, kBodies };
enum Object : uint32_t { kNeedleObject, kJawsObject };

double unit_of(const Setup& s) { return s.unit > 0 ? s.unit : 1; }

/// Arc, straight capsule or ball of a setup, in the needle's body frame.
scene::Shape needle_shape(const Setup& s) {
  const double u = unit_of(s);
  scene::Shape shape;
  shape.body = kNeedle, shape.object = kNeedleObject;
  shape.X_BS = Pose{}.abi();
  shape.radius = s.needle.wire_radius() * u;
  if (s.ball_radius > 0) {
    shape.kind = SWAGE_SHAPE_SPHERE;
    shape.radius = shape.bounding_radius = s.ball_radius * u;
  } else if (s.needle.straight) {
    // capsule along S.z turned to +y, its rounded ends inside the wire's length
    shape.kind = SWAGE_SHAPE_CAPSULE;
    shape.half_length = s.needle.length() / 2 * u;
    shape.X_BS = Pose{Vec3::Zero(), toolkit::exp_rotation({-std::numbers::pi / 2, 0, 0})}.abi();
    shape.bounding_radius = shape.half_length + shape.radius;
  } else {
    // start of the arc at theta = -a/2; S.x towards it, S.z = S.x cross S.y against the needle's normal
    shape.kind = SWAGE_SHAPE_ARC;
    shape.arc_radius = s.needle.radius() * u;
    shape.sweep = s.needle.arc;
    const double a = -s.needle.arc / 2;
    Eigen::Matrix3d R;
    R.col(0) = Vec3{0, std::sin(a), std::cos(a)};
    R.col(1) = Vec3{0, std::cos(a), -std::sin(a)};
    R.col(2) = R.col(0).cross(R.col(1));
    shape.X_BS = Pose{Vec3{0, 0, -s.needle.offset() * u}, Quat(R)}.abi();
    shape.bounding_radius = shape.arc_radius + shape.radius;
  }
  return shape;
}

scene::Shape convex_shape(scene::World& world, uint32_t body, const Jaw& j, double unit) {
  std::vector<Vec3> vertex;
  for (const Vec3& v : j.vertex) vertex.push_back(v * unit);
  std::vector<uint32_t> start{0}, index;
  for (const auto& f : j.face) {
    index.insert(index.end(), f.begin(), f.end());
    start.push_back(static_cast<uint32_t>(index.size()));
  }
  toolkit::Convex convex;
  const std::string problem = toolkit::build_convex(vertex, start, index, convex);
  if (!problem.empty()) throw std::runtime_error("bench: " + problem);
  scene::Shape shape;
  shape.kind = SWAGE_SHAPE_CONVEX;
  shape.body = body, shape.object = kJawsObject;
  shape.X_BS = Pose{}.abi();
  shape.convex = static_cast<uint32_t>(world.convex.size());
  for (const Vec3& v : vertex) shape.bounding_radius = std::max(shape.bounding_radius, v.norm());
  world.convex.push_back(std::move(convex));
  return shape;
}

/// A plate whose top is the plane z = 0.
Jaw plate(double half) {
  Jaw j;
  for (double z : {-half, 0.0})
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      j.vertex.push_back({x * half, y * half, z});
  j.face = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return j;
}

scene::World make_world(const Setup& s) {
  const double u = unit_of(s);
  scene::World w;
  w.length = 1e-3 * u;
  w.dt = s.dt;
  w.gravity = {0, 0, 0};
  w.body.resize(kBodies);
  for (auto& b : w.body) b.start = Pose{}.abi(), b.object = kJawsObject;
  w.body[kNeedle].motion = SWAGE_MOTION_DYNAMIC;
  w.body[kNeedle].object = kNeedleObject;
  w.body[kNeedle].mass = s.mass();
  for (int i = 0; i < 3; ++i) w.body[kNeedle].inertia[i] = s.moments()[i] * u * u;
  w.body[kUpper].motion = w.body[kLower].motion = SWAGE_MOTION_FOLLOWS;
  if (s.upper_driven) {
    w.body[kUpper].motion = SWAGE_MOTION_HINGED;
    w.body[kUpper].hinge = 0;
    scene::HingeInfo hinge;
    hinge.object = kJawsObject, hinge.parent = kBase, hinge.child = kUpper;
    hinge.axis = {0, 1, 0};  // closing turns the upper jaw about +y
    hinge.X_PC0 = Pose{}.abi();
    hinge.inertia = s.jaw_mass * Jaw::kGrip * Jaw::kGrip * u * u;
    hinge.min = -1, hinge.max = 1;
    w.hinge.push_back(hinge);
  }
  w.shape.push_back(needle_shape(s));
  if (s.ball_radius > 0) {
    w.shape.push_back(convex_shape(w, kBase, plate(10 * s.ball_radius), u));
  } else if (s.jaws) {
    w.shape.push_back(convex_shape(w, kUpper, jaw(1), u));
    w.shape.push_back(convex_shape(w, kLower, jaw(-1), u));
  }
  scene::reset(w);
  return w;
}

struct Choices {
  dynamics::Options dynamics;
  contact::Options contact;
};

class Swage final : public Engine {
 public:
  Swage(const Setup& s, const Choices& c)
      : Engine(s),
        u_(unit_of(s)),
        world_(make_world(s)),
        detector_(world_, {contact::Pair{kNeedleObject, kJawsObject, {s.friction, 1e6, s.restitution}}},
                  c.contact),
        dynamics_(world_, c.dynamics) {
    detector_.reserve(contacts_);
    target_[0] = target_[1] = Pose{};
  }

  void set_needle(const Pose& X, const Vec3& v, const Vec3& w) override {
    world_.X_WB[kNeedle] = Pose{X.p * u_, X.q}.abi();
    world_.V_WB[kNeedle] = {toolkit::raw(Vec3(v * u_)), toolkit::raw(w)};
  }
  Pose needle() const override {
    const Pose X(world_.X_WB[kNeedle]);
    return {X.p / u_, X.q};
  }
  Vec3 velocity() const override { return toolkit::vec(world_.V_WB[kNeedle].v) / u_; }
  Vec3 angular_velocity() const override { return toolkit::vec(world_.V_WB[kNeedle].w); }
  void set_gravity(const Vec3& g) override { world_.gravity = toolkit::raw(Vec3(g * u_)); }
  void set_jaws(const Pose& upper, const Pose& lower, bool jump) override {
    target_[0] = Pose{upper.p * u_, upper.q}, target_[1] = Pose{lower.p * u_, lower.q};
    if (!jump) return;
    for (uint32_t k = 0; k < 2; ++k) {
      world_.X_WB[kUpper + k] = target_[k].abi();
      world_.V_WB[kUpper + k] = {};
    }
    if (setup.upper_driven) {
      world_.hinge_angle[0] = toolkit::log_rotation(upper.q).y();
      world_.hinge_rate[0] = 0;
    }
  }
  void set_torque(double closing) override { torque_ = closing * u_ * u_; }
  void set_force(const Vec3& f, const Vec3& p) override {
    force_ = f * u_, couple_ += (p - needle().p).cross(f) * u_ * u_;
  }
  void set_couple(const Vec3& t) override { couple_ += t * u_ * u_; }

  void step() override {
    for (uint32_t k = 0; k < 2; ++k)
      if (world_.body[kUpper + k].motion == SWAGE_MOTION_FOLLOWS)
        scene::follow(world_, kUpper + k, target_[k]);
    // a drive asked to go far beyond its limit gives a constant torque
    if (setup.upper_driven)
      world_.drive[0] = {torque_ < 0 ? -1.0 : 1.0, 1e3 * std::abs(torque_), 0, std::abs(torque_)};
    world_.F_B_W[kNeedle] = {toolkit::raw(force_), toolkit::raw(couple_)};
    dynamics_.free_motion(world_);
    detector_.detect(world_, contacts_);
    dynamics_.solve(world_, contacts_, {});
    dynamics_.finish(world_);
    ++world_.step;
    torque_ = 0, force_.setZero(), couple_.setZero();
  }
  Pose upper() const override {
    const Pose X(world_.X_WB[kUpper]);
    return {X.p / u_, X.q};
  }
  int contacts(double& deepest) const override {
    deepest = 0;
    int n = 0;
    for (const contact::Contact& c : contacts_.contact) {
      n += c.gap < 0;
      deepest = std::min(deepest, c.gap / u_);
    }
    return n;
  }

 private:
  double u_;
  scene::World world_;
  contact::Detector detector_;
  dynamics::Dynamics dynamics_;
  contact::ContactSet contacts_;
  Pose target_[2];
  double torque_ = 0;
  Vec3 force_ = Vec3::Zero(), couple_ = Vec3::Zero();
};

/// Both jaws against the needle, as the detector asks: solids once, separations remembered.
struct SwageQuery {
  contact::Solid needle, jaws[2];
  contact::Separation memory[2];
  contact::Query query;
  contact::Manifold manifold;

  SwageQuery(const Needle& n, double unit) {
    Setup s;
    s.needle = n, s.unit = unit;
    const scene::World w = make_world(s);
    needle = contact::make_solid(w.shape[0], w.convex);
    for (size_t k = 0; k < 2; ++k) jaws[k] = contact::make_solid(w.shape[1 + k], w.convex);
    query.length = w.length;
  }
  Gaps run(const Pose& X_WN, const Pose& upper, const Pose& lower) {
    Gaps g;
    const contact::Frame F(X_WN);
    const Pose* X[2] = {&upper, &lower};
    for (size_t k = 0; k < 2; ++k) {
      contact::collide(needle, F, jaws[k], contact::Frame(*X[k]), query, memory[k], manifold);
      for (int i = 0; i < manifold.count; ++i)
        g.gap[k] = std::min(g.gap[k], manifold.candidate[static_cast<size_t>(i)].touch.gap);
      g.contacts += manifold.count;
    }
    return g;
  }
};

}  // namespace

std::vector<Method> swage_methods() {
  const auto with = [](Choices c) { return [c](const Setup& s) { return std::make_unique<Swage>(s, c); }; };
  const auto free = [](dynamics::FreeMotion f) {
    Choices c;
    c.dynamics.free_motion = f;
    return c;
  };
  Choices impulse, chain;
  impulse.dynamics.response = dynamics::Response::kImpulse;
  chain.contact.level = contact::Level::kThesis;
  return {
      {"swage", "swage", with({}), true},
      {"swage, chain of spheres", "thesis", with(chain), false},
      {"swage, impulse method of the thesis", "thesis", with(impulse), true},
      {"swage, explicit Euler of the thesis", "thesis", with(free(dynamics::FreeMotion::kThesis)), true},
      {"swage, symplectic Euler", "swage", with(free(dynamics::FreeMotion::kSymplecticEuler)), true},
      {"swage, RK4", "swage", with(free(dynamics::FreeMotion::kRungeKutta4)), true},
      {"swage, splitting of order 2", "swage", with(free(dynamics::FreeMotion::kSplitting2)), true},
      {"swage, splitting of order 4", "swage", with(free(dynamics::FreeMotion::kSplitting4)), true},
  };
}

std::vector<Query> swage_queries(const Needle& needle) {
  auto q = std::make_shared<SwageQuery>(needle, 1.0);
  return {{"swage, exact arc", "swage", true,
           [q](const Pose& n, const Pose& u, const Pose& l) { return q->run(n, u, l); }}};
}

}  // namespace swage::bench
