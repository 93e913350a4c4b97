// SPDX-License-Identifier: Apache-2.0
//
// Open Dynamics Engine (Debian: double precision, OPCODE). It is run in mm, mg, s: in metres its tolerances
// are larger than the needle.
#include <ode/ode.h>

#include <cmath>
#include <cstdarg>

#include "peers/units.hpp"

namespace swage::bench {
namespace {

struct Options {
  bool exact = true;     // dWorldStep (Lemke) instead of QuickStep
  double soft_cfm = -1;  // 1/(h k) per contact; < 0: hard contacts
  int iterations = 20;   // QuickStep
};

/// An assertion of ODE's own that fails ends the engine's run and not the program.
struct GivesUp {};
[[noreturn]] void give_up(int, const char*, va_list) { throw GivesUp{}; }

void init_once() {
  static const bool done = [] {
    dSetDebugHandler(give_up);
    return dInitODE2(0) != 0;
  }();
  (void)done;
}

void place(dBodyID body, const Pose& X, double L) {
  dBodySetPosition(body, X.p.x() * L, X.p.y() * L, X.p.z() * L);
  const dQuaternion q = {X.q.w(), X.q.x(), X.q.y(), X.q.z()};
  dBodySetQuaternion(body, q);
}

Pose pose_of(dBodyID body, double L) {
  const dReal* p = dBodyGetPosition(body);
  const dReal* q = dBodyGetQuaternion(body);
  return {Vec3{p[0], p[1], p[2]} / L, Quat{q[0], q[1], q[2], q[3]}};
}

/// A jaw as a triangle mesh; keeps the arrays that ODE points into.
struct JawMesh {
  std::vector<double> xyz;
  std::vector<dTriIndex> index;
  dGeomID geom = nullptr;

  JawMesh(int side, double L) {
    const Jaw j = jaw(side);
    for (const Vec3& v : j.vertex)
      for (double x : {v.x(), v.y(), v.z()}) xyz.push_back(x * L);
    for (const auto& t : triangles(j)) index.insert(index.end(), t.begin(), t.end());
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, xyz.data(), 3 * sizeof(double), static_cast<int>(j.vertex.size()),
                                index.data(), static_cast<int>(index.size()), 3 * sizeof(dTriIndex));
    geom = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
  }
};

class Ode final : public Engine {
 public:
  Ode(const Setup& s, const Options& o) : Engine(s), options_(o), unit_(units_of(s)) {
    init_once();
    world_ = dWorldCreate();
    space_ = dSimpleSpaceCreate(nullptr);
    group_ = dJointGroupCreate(0);
    dWorldSetQuickStepNumIterations(world_, o.iterations);
    make_needle();
    if (s.ball_radius > 0)
      plane_ = dCreatePlane(nullptr, 0, 0, 1, 0);
    else if (s.jaws)
      make_jaws();
  }
  ~Ode() override {
    dJointGroupDestroy(group_);
    dSpaceDestroy(space_);
    for (auto& m : mesh_) dGeomDestroy(m->geom);
    if (plane_) dGeomDestroy(plane_);
    dWorldDestroy(world_);
  }

  void set_needle(const Pose& X, const Vec3& v, const Vec3& w) override {
    place(needle_, X, unit_.length);
    dBodySetLinearVel(needle_, v.x() * unit_.length, v.y() * unit_.length, v.z() * unit_.length);
    dBodySetAngularVel(needle_, w.x(), w.y(), w.z());
  }
  Pose needle() const override {
    if (gave_up_) return {Vec3::Constant(std::nan("")), Quat::Identity()};
    return pose_of(needle_, unit_.length);
  }
  Vec3 velocity() const override {
    const dReal* v = dBodyGetLinearVel(needle_);
    return Vec3{v[0], v[1], v[2]} / unit_.length;
  }
  Vec3 angular_velocity() const override {
    const dReal* w = dBodyGetAngularVel(needle_);
    return {w[0], w[1], w[2]};
  }
  void set_gravity(const Vec3& g) override {
    dWorldSetGravity(world_, g.x() * unit_.length, g.y() * unit_.length, g.z() * unit_.length);
  }
  void set_jaws(const Pose& upper, const Pose& lower, bool jump) override {
    target_[0] = upper, target_[1] = lower;
    if (!jump) return;
    for (int k = 0; k < 2; ++k) {
      place(jaw_[k], target_[k], unit_.length);
      dBodySetLinearVel(jaw_[k], 0, 0, 0);
      dBodySetAngularVel(jaw_[k], 0, 0, 0);
    }
  }
  void set_torque(double closing) override { torque_ = closing; }
  void set_force(const Vec3& f, const Vec3& p) override { force_ = f, at_ = p; }
  void set_couple(const Vec3& t) override { couple_ = t; }

  void step() override {
    if (gave_up_) return;
    for (int k = 0; k < 2; ++k)
      if (jaw_[k] && moved(k)) chase(k);
    if (jaw_[0] && !moved(0)) dBodyAddTorque(jaw_[0], 0, torque_ * unit_.torque(), 0);
    dBodyAddForceAtPos(needle_, force_.x() * unit_.force(), force_.y() * unit_.force(),
                       force_.z() * unit_.force(), at_.x() * unit_.length, at_.y() * unit_.length,
                       at_.z() * unit_.length);
    dBodyAddTorque(needle_, couple_.x() * unit_.torque(), couple_.y() * unit_.torque(),
                   couple_.z() * unit_.torque());
    count_ = 0, deepest_ = 0;
    if (plane_) dSpaceCollide2(plane_, reinterpret_cast<dGeomID>(space_), this, &Ode::near);
    for (auto& m : mesh_) dSpaceCollide2(m->geom, reinterpret_cast<dGeomID>(space_), this, &Ode::near);
    try {
      (options_.exact ? dWorldStep : dWorldQuickStep)(world_, setup.dt);
    } catch (const GivesUp&) {
      gave_up_ = true;
    }
    dJointGroupEmpty(group_);
    for (int k = 0; k < 2; ++k)
      if (jaw_[k] && moved(k)) place(jaw_[k], target_[k], unit_.length);
    torque_ = 0, force_.setZero(), couple_.setZero();
  }
  Pose upper() const override { return pose_of(jaw_[0], unit_.length); }
  int contacts(double& deepest) const override {
    deepest = deepest_;
    return count_;
  }

 private:
  bool moved(int k) const { return !(setup.upper_driven && k == 0); }

  void make_needle() {
    needle_ = dBodyCreate(world_);
    dMass mass;
    dMassSetZero(&mass);
    const Vec3 I = setup.moments() * unit_.mass * unit_.length * unit_.length;
    dMassSetParameters(&mass, setup.mass() * unit_.mass, 0, 0, 0, I.x(), I.y(), I.z(), 0, 0, 0);
    dBodySetMass(needle_, &mass);
    if (setup.ball_radius > 0) {
      dGeomSetBody(dCreateSphere(space_, setup.ball_radius * unit_.length), needle_);
      return;
    }
    for (const Vec3& c : setup.needle.chain(100)) {
      const dGeomID g = dCreateSphere(space_, setup.needle.wire_radius() * unit_.length);
      dGeomSetBody(g, needle_);
      dGeomSetOffsetPosition(g, c.x() * unit_.length, c.y() * unit_.length, c.z() * unit_.length);
    }
  }
  void make_jaws() {
    for (int k = 0; k < 2; ++k) {
      mesh_.push_back(std::make_unique<JawMesh>(k == 0 ? 1 : -1, unit_.length));
      jaw_[k] = dBodyCreate(world_);
      const double I = setup.jaw_mass * Jaw::kGrip * Jaw::kGrip * unit_.mass * unit_.length * unit_.length;
      dMass mass;
      dMassSetZero(&mass);
      dMassSetParameters(&mass, setup.jaw_mass * unit_.mass, 0, 0, 0, I, I, I, 0, 0, 0);
      dBodySetMass(jaw_[k], &mass);
      dGeomSetBody(mesh_[static_cast<size_t>(k)]->geom, jaw_[k]);
      if (moved(k)) {
        dBodySetKinematic(jaw_[k]);
        continue;
      }
      dBodySetGravityMode(jaw_[k], 0);
      const dJointID hinge = dJointCreateHinge(world_, nullptr);
      dJointAttach(hinge, jaw_[k], nullptr);
      dJointSetHingeAnchor(hinge, 0, 0, 0);
      dJointSetHingeAxis(hinge, 0, 1, 0);
    }
  }
  /// Gives a moved jaw the velocity that brings it to its target in one step.
  void chase(int k) {
    const Pose X = pose_of(jaw_[k], unit_.length);
    const Vec3 v = (target_[k].p - X.p) * unit_.length / setup.dt;
    const Vec3 w = toolkit::log_rotation(target_[k].q * X.q.conjugate()) / setup.dt;
    dBodySetLinearVel(jaw_[k], v.x(), v.y(), v.z());
    dBodySetAngularVel(jaw_[k], w.x(), w.y(), w.z());
  }
  static void near(void* self, dGeomID a, dGeomID b) { static_cast<Ode*>(self)->touch(a, b); }
  void touch(dGeomID a, dGeomID b) {
    dContact c[8];
    const int n = dCollide(a, b, 8, &c[0].geom, sizeof(dContact));
    for (int i = 0; i < n; ++i) {
      c[i].surface = dSurfaceParameters{};
      c[i].surface.mode = dContactApprox1;
      c[i].surface.mu = setup.friction;
      if (setup.restitution > 0) c[i].surface.mode |= dContactBounce, c[i].surface.bounce = setup.restitution;
      if (options_.soft_cfm >= 0)
        c[i].surface.mode |= dContactSoftCFM, c[i].surface.soft_cfm = options_.soft_cfm;
      const dJointID joint = dJointCreateContact(world_, group_, &c[i]);
      dJointAttach(joint, dGeomGetBody(c[i].geom.g1), dGeomGetBody(c[i].geom.g2));
      deepest_ = std::min(deepest_, -c[i].geom.depth / unit_.length);
      ++count_;
    }
  }

  Options options_;
  Units unit_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID group_;
  dBodyID needle_ = nullptr, jaw_[2] = {nullptr, nullptr};
  std::vector<std::unique_ptr<JawMesh>> mesh_;
  dGeomID plane_ = nullptr;
  Pose target_[2];
  double torque_ = 0, deepest_ = 0;
  bool gave_up_ = false;
  Vec3 force_ = Vec3::Zero(), at_ = Vec3::Zero(), couple_ = Vec3::Zero();
  int count_ = 0;
};

/// Needle against jaws without dynamics: the chain of 100 spheres in a simple space against two triangle
/// meshes.
struct OdeQuery {
  static constexpr double kLength = 1e3;  // per m
  dSpaceID space;
  std::vector<dGeomID> sphere;
  std::vector<Vec3> centre;
  JawMesh upper{1, kLength}, lower{-1, kLength};
  Gaps gaps;

  explicit OdeQuery(const Needle& n) : centre(n.chain(100)) {
    space = dSimpleSpaceCreate(nullptr);
    for (size_t i = 0; i < centre.size(); ++i)
      sphere.push_back(dCreateSphere(space, n.wire_radius() * kLength));
  }
  static void near(void* self, dGeomID a, dGeomID b) {
    auto* q = static_cast<OdeQuery*>(self);
    dContactGeom c[8];
    const int n = dCollide(a, b, 8, c, sizeof(dContactGeom));
    const int k = a == q->upper.geom || b == q->upper.geom ? 0 : 1;
    for (int i = 0; i < n; ++i) q->gaps.gap[k] = std::min(q->gaps.gap[k], -c[i].depth / kLength);
    q->gaps.contacts += n;
  }
  Gaps run(const Pose& needle, const Pose& up, const Pose& low) {
    for (size_t i = 0; i < sphere.size(); ++i) {
      const Vec3 p = needle * centre[i] * kLength;
      dGeomSetPosition(sphere[i], p.x(), p.y(), p.z());
    }
    gaps = Gaps{};
    for (const auto& [mesh, X] : {std::pair{&upper, &up}, std::pair{&lower, &low}}) {
      dGeomSetPosition(mesh->geom, X->p.x() * kLength, X->p.y() * kLength, X->p.z() * kLength);
      const dQuaternion q = {X->q.w(), X->q.x(), X->q.y(), X->q.z()};
      dGeomSetQuaternion(mesh->geom, q);
      dSpaceCollide2(mesh->geom, reinterpret_cast<dGeomID>(space), this, &OdeQuery::near);
    }
    return gaps;
  }
};

}  // namespace

std::vector<Method> ode_methods() {
  const auto with = [](Options o) { return [o](const Setup& s) { return std::make_unique<Ode>(s, o); }; };
  return {
      {"ODE exact, soft contacts", "ODE", with({true, 1e-6, 20}), false,
       Method::Differs::kInContact},  // k = 1e3 N/m: the best found
      {"ODE exact", "ODE", with({true, -1, 20})},
      {"ODE QuickStep", "ODE", with({false, -1, 20}), false, Method::Differs::kInContact},
      {"ODE QuickStep, 100 iterations", "ODE", with({false, -1, 100}), false, Method::Differs::kInContact},
  };
}

std::vector<Query> ode_queries(const Needle& needle) {
  init_once();
  auto q = std::make_shared<OdeQuery>(needle);
  return {{"ODE spheres, trimesh jaws", "ODE", false,
           [q](const Pose& n, const Pose& u, const Pose& l) { return q->run(n, u, l); }}};
}

}  // namespace swage::bench
