// SPDX-License-Identifier: Apache-2.0
//
// A rope of Bullet, btSoftBodyHelpers::CreateRope: points with links between neighbours and, against bending, between every second ones, by
// positions. It knows no bending stiffness: how stiff it is follows from the iterations. In mm, mg, s.
#include "peers/rope.hpp"

#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

namespace swage::bench {
namespace {

constexpr double kLength = 1e3, kMass = 1e6;  // per m, per kg

class BulletRope final : public Rope {
 public:
  explicit BulletRope(const RopeSetup& s) : segments_(s.segments) {
    const btVector3 g(0, 0, -9.80665 * kLength);
    world_.setGravity(g);
    world_.getWorldInfo().m_gravity = g;
    rope_ = btSoftBodyHelpers::CreateRope(world_.getWorldInfo(), btVector3(0, 0, 0), btVector3(s.length * kLength, 0, 0), s.segments - 1, 1);
    rope_->generateBendingConstraints(2);
    rope_->setTotalMass(s.line_mass * s.length * kMass);
    rope_->setMass(0, 0), rope_->setMass(1, 0);
    rope_->m_cfg.piterations = s.iterations;
    rope_->m_cfg.kDP = 0.03;  // share of the speed that a step takes away
    rope_->m_cfg.collisions = 0;
    world_.addSoftBody(rope_);
  }
  ~BulletRope() override {
    world_.removeSoftBody(rope_);
    delete rope_;
  }
  void step() override { world_.stepSimulation(1e-3, 0); }
  Vec3 end() const override {
    const btVector3& p = rope_->m_nodes[segments_].m_x;
    return Vec3(p.x(), p.y(), p.z()) / kLength;
  }

 private:
  int segments_;
  btSoftBodyRigidBodyCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btSoftBody* rope_ = nullptr;
};

}  // namespace

std::unique_ptr<Rope> bullet_rope(const RopeSetup& s) { return std::make_unique<BulletRope>(s); }

}  // namespace swage::bench
