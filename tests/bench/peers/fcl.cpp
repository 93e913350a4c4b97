// SPDX-License-Identifier: Apache-2.0
//
// FCL as Debian ships it, in mm: 100 spheres in a dynamic AABB tree against two convex jaws, solved by
// libccd.
#include <fcl/fcl.h>

#include "engine.hpp"

namespace swage::bench {
namespace {

constexpr double kLength = 1e3;  // per m

fcl::Transform3d transform(const Pose& X) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  t.linear() = X.q.toRotationMatrix();
  t.translation() = X.p * kLength;
  return t;
}

std::shared_ptr<fcl::Convexd> convex(int side) {
  const Jaw j = jaw(side);
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const Vec3& v : j.vertex) vertices->push_back(v * kLength);
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& f : j.face) {
    faces->push_back(static_cast<int>(f.size()));
    for (uint32_t i : f) faces->push_back(static_cast<int>(i));
  }
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(j.face.size()), faces);
}

struct FclQuery {
  std::vector<Vec3> centre;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> sphere;
  fcl::DynamicAABBTreeCollisionManagerd manager;
  fcl::CollisionObjectd jaws[2] = {fcl::CollisionObjectd(convex(1)), fcl::CollisionObjectd(convex(-1))};
  Gaps gaps;

  explicit FclQuery(const Needle& n) : centre(n.chain(100)) {
    const auto geometry = std::make_shared<fcl::Sphered>(n.wire_radius() * kLength);
    for (size_t i = 0; i < centre.size(); ++i) {
      sphere.push_back(std::make_unique<fcl::CollisionObjectd>(geometry));
      manager.registerObject(sphere.back().get());
    }
    manager.setup();
  }
  static bool near(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* self) {
    auto* q = static_cast<FclQuery*>(self);
    fcl::CollisionRequestd request(8, true);
    request.gjk_solver_type = fcl::GST_LIBCCD;
    fcl::CollisionResultd result;
    fcl::collide(a, b, request, result);
    const int k = a == &q->jaws[0] || b == &q->jaws[0] ? 0 : 1;
    for (size_t i = 0; i < result.numContacts(); ++i, ++q->gaps.contacts)
      q->gaps.gap[k] = std::min(q->gaps.gap[k], -std::abs(result.getContact(i).penetration_depth) / kLength);
    return false;
  }
  Gaps run(const Pose& needle, const Pose& upper, const Pose& lower) {
    for (size_t i = 0; i < centre.size(); ++i) {
      sphere[i]->setTranslation(needle * centre[i] * kLength);
      sphere[i]->computeAABB();
    }
    manager.update();
    gaps = Gaps{};
    const Pose* X[2] = {&upper, &lower};
    for (int k = 0; k < 2; ++k) {
      jaws[k].setTransform(transform(*X[k]));
      jaws[k].computeAABB();
      manager.collide(&jaws[k], this, &FclQuery::near);
    }
    return gaps;
  }
};

}  // namespace

std::vector<Query> fcl_queries(const Needle& needle) {
  auto q = std::make_shared<FclQuery>(needle);
  return {{"FCL spheres, convex jaws", "FCL", false,
           [q](const Pose& n, const Pose& u, const Pose& l) { return q->run(n, u, l); }}};
}

}  // namespace swage::bench
