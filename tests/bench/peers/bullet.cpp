// SPDX-License-Identifier: Apache-2.0
//
// Bullet as Debian ships it, double precision build, in mm, mg, s with collision margin 0: its 40 mm margins
// make every pair of a metre-scaled scene touch.
#include <btBulletDynamicsCommon.h>

#include "peers/units.hpp"

namespace swage::bench {
namespace {

struct Options {
  int iterations = 10;
  double stiffness = 0;  // N/m per contact; 0: hard
};

btVector3 vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
btTransform transform(const Pose& X, double L) {
  return btTransform(btQuaternion(X.q.x(), X.q.y(), X.q.z(), X.q.w()), vector(X.p * L));
}
Pose pose(const btTransform& t, double L) {
  const btQuaternion q = t.getRotation();
  const btVector3 p = t.getOrigin();
  return {Vec3{p.x(), p.y(), p.z()} / L, Quat{q.w(), q.x(), q.y(), q.z()}};
}
std::unique_ptr<btConvexHullShape> hull(int side, double L) {
  auto h = std::make_unique<btConvexHullShape>();
  for (const Vec3& v : jaw(side).vertex) h->addPoint(vector(v * L));
  h->setMargin(0);
  return h;
}
/// Needle as a compound of 100 spheres that share one shape.
struct Chain {
  btSphereShape sphere;
  btCompoundShape compound{true};
  Chain(const Needle& n, double L) : sphere(n.wire_radius() * L) {
    for (const Vec3& c : n.chain(100))
      compound.addChildShape(btTransform(btQuaternion::getIdentity(), vector(c * L)), &sphere);
  }
};

class Bullet final : public Engine {
 public:
  Bullet(const Setup& s, const Options& o) : Engine(s), options_(o), unit_(units_of(s)) {
    world_.getSolverInfo().m_numIterations = o.iterations;
    world_.getSolverInfo().m_restitutionVelocityThreshold = 0;
    btCollisionShape* shape = nullptr;
    if (s.ball_radius > 0 || !s.jaws) {
      ball_ = std::make_unique<btSphereShape>((s.ball_radius > 0 ? s.ball_radius : 1e-4) * unit_.length);
      shape = ball_.get();
    } else {
      chain_ = std::make_unique<Chain>(s.needle, unit_.length);
      shape = &chain_->compound;
    }
    needle_ = add(s.mass() * unit_.mass, vector(s.moments() * unit_.mass * unit_.length * unit_.length),
                  shape, 1, 2);
    if (s.ball_radius > 0) {
      const double half = 10 * s.ball_radius * unit_.length;
      plate_ = std::make_unique<btBoxShape>(btVector3(half, half, half / 2));
      plate_->setMargin(0);
      add(0, btVector3(0, 0, 0), plate_.get(), 2, 1)
          ->setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, -half / 2)));
    } else if (s.jaws) {
      make_jaws();
    }
  }
  ~Bullet() override {
    if (hinge_) world_.removeConstraint(hinge_.get());
    for (auto& b : bodies_) world_.removeRigidBody(b.get());
  }

  void set_needle(const Pose& X, const Vec3& v, const Vec3& w) override {
    needle_->setWorldTransform(transform(X, unit_.length));
    needle_->setInterpolationWorldTransform(transform(X, unit_.length));
    needle_->getMotionState()->setWorldTransform(transform(X, unit_.length));
    needle_->setLinearVelocity(vector(v * unit_.length));
    needle_->setAngularVelocity(vector(w));
    needle_->updateInertiaTensor();
  }
  Pose needle() const override { return pose(needle_->getWorldTransform(), unit_.length); }
  Vec3 velocity() const override {
    const btVector3& v = needle_->getLinearVelocity();
    return Vec3{v.x(), v.y(), v.z()} / unit_.length;
  }
  Vec3 angular_velocity() const override {
    const btVector3& w = needle_->getAngularVelocity();
    return {w.x(), w.y(), w.z()};
  }
  void set_gravity(const Vec3& g) override {
    world_.setGravity(vector(g * unit_.length));
    needle_->setGravity(vector(g * unit_.length));
    if (setup.upper_driven && jaw_[0]) jaw_[0]->setGravity(btVector3(0, 0, 0));
  }
  void set_jaws(const Pose& upper, const Pose& lower, bool jump) override {
    const Pose* X[2] = {&upper, &lower};
    for (int k = 0; k < 2; ++k) {
      const bool driven = setup.upper_driven && k == 0;
      if (driven && !jump) continue;
      jaw_[k]->getMotionState()->setWorldTransform(transform(*X[k], unit_.length));
      if (!jump) continue;
      jaw_[k]->setWorldTransform(transform(*X[k], unit_.length));
      jaw_[k]->setInterpolationWorldTransform(transform(*X[k], unit_.length));
      if (driven) jaw_[k]->updateInertiaTensor();
    }
  }
  void set_torque(double closing) override {
    jaw_[0]->applyTorque(btVector3(0, closing * unit_.torque(), 0));
  }
  void set_force(const Vec3& f, const Vec3& p) override {
    needle_->applyForce(vector(f * unit_.force()), vector((p - needle().p) * unit_.length));
  }
  void set_couple(const Vec3& t) override { needle_->applyTorque(vector(t * unit_.torque())); }
  void step() override { world_.stepSimulation(setup.dt, 1, setup.dt); }
  Pose upper() const override { return pose(jaw_[0]->getWorldTransform(), unit_.length); }
  int contacts(double& deepest) const override {
    int n = 0;
    deepest = 0;
    for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
      const btPersistentManifold* manifold =
          const_cast<btCollisionDispatcher&>(dispatcher_).getManifoldByIndexInternal(m);
      for (int i = 0; i < manifold->getNumContacts(); ++i) {
        const double gap = manifold->getContactPoint(i).getDistance() / unit_.length;
        n += gap <= 1e-9;
        deepest = std::min(deepest, gap);
      }
    }
    return n;
  }

 private:
  btRigidBody* add(double mass, const btVector3& moments, btCollisionShape* shape, int group, int mask) {
    states_.push_back(std::make_unique<btDefaultMotionState>());
    btRigidBody::btRigidBodyConstructionInfo info(mass, states_.back().get(), shape, moments);
    info.m_linearDamping = info.m_angularDamping = 0;
    info.m_friction = std::sqrt(setup.friction);  // Bullet multiplies the two sides
    info.m_restitution = std::sqrt(setup.restitution);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody* body = bodies_.back().get();
    body->setActivationState(DISABLE_DEACTIVATION);
    if (options_.stiffness > 0)
      body->setContactStiffnessAndDamping(options_.stiffness * unit_.mass,
                                          2 * std::sqrt(options_.stiffness * setup.mass()) * unit_.mass);
    world_.addRigidBody(body, group, mask);
    return body;
  }
  void make_jaws() {
    for (int k = 0; k < 2; ++k) {
      hull_[k] = hull(k == 0 ? 1 : -1, unit_.length);
      const bool driven = setup.upper_driven && k == 0;
      const double I = setup.jaw_mass * Jaw::kGrip * Jaw::kGrip * unit_.mass * unit_.length * unit_.length;
      jaw_[k] = add(driven ? setup.jaw_mass * unit_.mass : 0,
                    driven ? btVector3(I, I, I) : btVector3(0, 0, 0), hull_[k].get(), 2, 1);
      if (driven) {
        hinge_ = std::make_unique<btHingeConstraint>(*jaw_[0], btVector3(0, 0, 0), btVector3(0, 1, 0));
        world_.addConstraint(hinge_.get(), true);
      } else {
        jaw_[k]->setCollisionFlags(jaw_[k]->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
      }
    }
  }

  Options options_;
  Units unit_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broad_, &solver_, &configuration_};
  std::unique_ptr<btSphereShape> ball_;
  std::unique_ptr<btBoxShape> plate_;
  std::unique_ptr<Chain> chain_;
  std::unique_ptr<btConvexHullShape> hull_[2];
  std::vector<std::unique_ptr<btMotionState>> states_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::unique_ptr<btHingeConstraint> hinge_;
  btRigidBody *needle_ = nullptr, *jaw_[2] = {nullptr, nullptr};
};

struct BulletQuery {
  static constexpr double kLength = 1e3;  // per m
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broad;
  btCollisionWorld world{&dispatcher, &broad, &configuration};
  Chain chain;
  std::unique_ptr<btConvexHullShape> shape[2] = {hull(1, kLength), hull(-1, kLength)};
  btCollisionObject needle_object, jaw_object[2];

  explicit BulletQuery(const Needle& n) : chain(n, kLength) {
    needle_object.setCollisionShape(&chain.compound);
    world.addCollisionObject(&needle_object, 1, 2);
    for (int k = 0; k < 2; ++k) {
      jaw_object[k].setCollisionShape(shape[k].get());
      world.addCollisionObject(&jaw_object[k], 2, 1);
    }
  }
  ~BulletQuery() {
    for (auto& j : jaw_object) world.removeCollisionObject(&j);
    world.removeCollisionObject(&needle_object);
  }
  BulletQuery(const BulletQuery&) = delete;
  BulletQuery& operator=(const BulletQuery&) = delete;

  Gaps run(const Pose& needle, const Pose& upper, const Pose& lower) {
    needle_object.setWorldTransform(transform(needle, kLength));
    jaw_object[0].setWorldTransform(transform(upper, kLength));
    jaw_object[1].setWorldTransform(transform(lower, kLength));
    world.performDiscreteCollisionDetection();
    Gaps g;
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
      const btPersistentManifold* manifold = dispatcher.getManifoldByIndexInternal(m);
      const int k = manifold->getBody0() == &jaw_object[0] || manifold->getBody1() == &jaw_object[0] ? 0 : 1;
      for (int i = 0; i < manifold->getNumContacts(); ++i, ++g.contacts)
        g.gap[k] = std::min(g.gap[k], manifold->getContactPoint(i).getDistance() / kLength);
    }
    return g;
  }
};

}  // namespace

std::vector<Method> bullet_methods() {
  const auto with = [](Options o) { return [o](const Setup& s) { return std::make_unique<Bullet>(s, o); }; };
  return {
      {"Bullet", "Bullet", with({10, 0})},
      {"Bullet, 50 iterations", "Bullet", with({50, 0}), false, Method::Differs::kInContact},
      {"Bullet, soft contacts", "Bullet", with({50, 1e3}), false, Method::Differs::kInContact},
  };
}

std::vector<Query> bullet_queries(const Needle& needle) {
  auto q = std::make_shared<BulletQuery>(needle);
  return {{"Bullet spheres, hull jaws", "Bullet", false,
           [q](const Pose& n, const Pose& u, const Pose& l) { return q->run(n, u, l); }}};
}

}  // namespace swage::bench
