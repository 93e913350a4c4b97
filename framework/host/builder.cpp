// SPDX-License-Identifier: Apache-2.0
#include "host/builder.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "host/c_values.hpp"
#include "host/plugin_info.hpp"
#include "host/sentences.hpp"
#include "host/units.hpp"
#include "snapshot/snapshot.hpp"
#include "toolkit/math.hpp"

namespace swage::host {

using scene::Range;
using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

namespace {

// m: largest distance from a body's origin, and largest radius: larger values are mistakes, and squares could overflow
constexpr double kFar = 1e3;
// shapes of a scene; a bowl from a mesh has some hundred. Each is tested in every step
constexpr uint32_t kMaxShapes = 8192;
// private doubles of a scene, 64 MB: all are saved at each rewind and hashed in each step. A tissue has some ten thousand
constexpr uint32_t kMaxState = 8u << 20;
// vertices and faces of one polyhedron
constexpr uint32_t kMaxConvex = 4096;
// characters of an id and of a sentence about it
constexpr std::size_t kMaxId = 100, kMaxDoc = 1000;
// messages about one instance: the first ones show the cause
constexpr uint32_t kMostRefusals = 20;

// finite and within kFar
bool finite(const swage_vec3& a) { return std::abs(a.x) <= kFar && std::abs(a.y) <= kFar && std::abs(a.z) <= kFar; }

// unit length within rounding; a larger deviation is a mistake of the author
bool unit(double norm) { return std::abs(norm - 1) < 1e-6; }

bool unit(const swage_quat& q) { return unit(std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z)); }

// text of a plugin, cut to a readable length
std::string shortened(const char* text, std::size_t most) {
  return text != nullptr ? std::string(text, strnlen(text, most)) : std::string();
}

Pose normalised(const swage_pose& pose) {
  Pose out(pose);
  out.q.normalize();
  return out;
}

// frame with its z axis from a to b, at their middle
Pose axis_pose(const Vec3& a, const Vec3& b) {
  return {0.5 * (a + b), Quat::FromTwoVectors(Vec3::UnitZ(), b - a)};
}

std::string article(int32_t kind) {
  return (kind == SWAGE_KIND_OBJECT ? "An " : "A ") + std::string(kind_text(kind));
}

}  // namespace

// the functions of the C table
struct BuilderCalls {
  static Builder& of(swage_builder* raw) { return *static_cast<Builder*>(raw->host_data); }

  static uint32_t body(swage_builder* raw, int32_t motion, const swage_pose* X_OB, const swage_mass* mass,
                       const char* name) {
    Builder& b = of(raw);
    const std::string called =
        name != nullptr && *name != 0 ? shortened(name, kMaxId) : "body " + std::to_string(b.body.count);
    if (!b.may(b.owner_.kind == SWAGE_KIND_OBJECT, "bodies")) return scene::kNone;
    if (!b.fits(b.world_.body.size() + 1, snapshot::kMaxBodies, "bodies")) return scene::kNone;
    if (X_OB == nullptr || !finite(X_OB->p) || !unit(X_OB->q))
      return b.refuse(say::kOfBody(called, say::kStartPose()));
    if (motion < SWAGE_MOTION_FIXED || motion > SWAGE_MOTION_FLEXIBLE)
      return b.refuse(say::kOfBody(called, say::kMotion(motion)));
    scene::BodyInfo info;
    if (const std::string wrong = take_mass(motion, mass, info); !wrong.empty())
      return b.refuse(say::kOfBody(called, wrong));

    info.motion = motion;
    info.object = b.owner_.object;
    info.name = called;
    info.start = (normalised(b.owner_.X_WO) * normalised(*X_OB)).abi();
    b.world_.body.push_back(info);
    b.world_.X_WB.push_back(info.start);
    b.world_.V_WB.push_back({});
    b.world_.F_B_W.push_back({});
    return b.body.count++;
  }

  static std::string take_mass(int32_t motion, const swage_mass* mass, scene::BodyInfo& info) {
    if (motion != SWAGE_MOTION_DYNAMIC) return mass == nullptr ? "" : say::kNoMassHere();
    if (mass == nullptr || !positive(mass->mass)) return say::kNeedsMass();
    const double i[3] = {mass->inertia.x, mass->inertia.y, mass->inertia.z};
    for (int k = 0; k < 3; ++k) {
      if (!positive(i[k])) return say::kNeedsInertia();
      // each moment is at most the sum of the other two, for any mass distribution
      if (i[k] > (i[(k + 1) % 3] + i[(k + 2) % 3]) * (1 + 1e-9))
        return say::kNoSuchInertia();
    }
    info.mass = mass->mass;
    std::copy(std::begin(i), std::end(i), info.inertia);
    return "";
  }

  static uint32_t particles(swage_builder* raw, uint32_t n, const double* p_O, const double* mass,
                            double radius) {
    Builder& b = of(raw);
    scene::World& w = b.world_;
    if (!b.may(b.owner_.kind == SWAGE_KIND_OBJECT, "particles")) return scene::kNone;
    if (!b.fits(w.particle_mass.size() + n, snapshot::kMaxParticles, "particles")) return scene::kNone;
    if (n == 0 || p_O == nullptr || mass == nullptr || !(std::isfinite(radius) && radius >= 0))
      return b.refuse(say::kParticles());
    for (uint32_t i = 0; i < n; ++i) {
      const Vec3 p(p_O[3 * i], p_O[3 * i + 1], p_O[3 * i + 2]);
      if (!p.allFinite() || !positive(mass[i]))
        return b.refuse(say::kParticle(i));
    }
    const Pose X_WO = normalised(b.owner_.X_WO);
    for (uint32_t i = 0; i < n; ++i) {
      const Vec3 p_W = X_WO * Vec3(p_O[3 * i], p_O[3 * i + 1], p_O[3 * i + 2]);
      w.particle_p_W.insert(w.particle_p_W.end(), {p_W.x(), p_W.y(), p_W.z()});
      w.particle_v_W.insert(w.particle_v_W.end(), 3, 0.0);
      w.particle_f_W.insert(w.particle_f_W.end(), 3, 0.0);
      w.particle_mass.push_back(mass[i]);
      w.particle_radius.push_back(radius);
      w.particle_object.push_back(b.owner_.object);
    }
    const uint32_t first = b.particle.count;
    b.particle.count += n;
    return first;
  }

  static uint32_t sphere(swage_builder* raw, uint32_t body, swage_vec3 centre, double radius,
                         uint32_t flags) {
    Builder& b = of(raw);
    if (!b.owns_body(body, "A sphere")) return scene::kNone;
    if (!finite(centre) || !positive(radius) || radius > kFar) return b.refuse(say::kSphere());
    scene::Shape shape;
    shape.kind = SWAGE_SHAPE_SPHERE;
    shape.X_BS = {centre, {1, 0, 0, 0}};
    shape.radius = shape.bounding_radius = radius;
    return b.add_shape(body, shape, flags);
  }

  static uint32_t tube(Builder& b, int32_t kind, const char* what, uint32_t body, swage_vec3 a, swage_vec3 c,
                       double radius, uint32_t flags) {
    if (!b.owns_body(body, what)) return scene::kNone;
    const double length = (toolkit::vec(c) - toolkit::vec(a)).norm();
    if (!positive(length) || !positive(radius))
      return b.refuse(say::kTube(what));
    scene::Shape shape;
    shape.kind = kind;
    shape.X_BS = axis_pose(toolkit::vec(a), toolkit::vec(c)).abi();
    shape.radius = radius;
    shape.half_length = 0.5 * length;
    shape.bounding_radius =
        kind == SWAGE_SHAPE_CAPSULE ? shape.half_length + radius : std::hypot(shape.half_length, radius);
    return b.add_shape(body, shape, flags);
  }
  static uint32_t capsule(swage_builder* raw, uint32_t body, swage_vec3 a, swage_vec3 c, double radius,
                          uint32_t flags) {
    return tube(of(raw), SWAGE_SHAPE_CAPSULE, "A capsule", body, a, c, radius, flags);
  }
  static uint32_t cylinder(swage_builder* raw, uint32_t body, swage_vec3 a, swage_vec3 c, double radius,
                           uint32_t flags) {
    return tube(of(raw), SWAGE_SHAPE_CYLINDER, "A cylinder", body, a, c, radius, flags);
  }

  static uint32_t arc(swage_builder* raw, uint32_t body, const swage_arc* arc, uint32_t flags) {
    Builder& b = of(raw);
    if (!b.owns_body(body, "An arc")) return scene::kNone;
    if (arc == nullptr || !finite(arc->X_BA.p) || !unit(arc->X_BA.q))
      return b.refuse(say::kArcPose());
    if (!positive(arc->radius) || !positive(arc->wire_radius) || arc->wire_radius >= arc->radius)
      return b.refuse(say::kArcRadius());
    if (!positive(arc->sweep) || arc->sweep >= 2 * M_PI)
      return b.refuse(say::kArcSweep());
    scene::Shape shape;
    shape.kind = SWAGE_SHAPE_ARC;
    shape.X_BS = normalised(arc->X_BA).abi();
    shape.radius = arc->wire_radius;
    shape.arc_radius = arc->radius;
    shape.sweep = arc->sweep;
    shape.bounding_radius = arc->radius + arc->wire_radius;
    return b.add_shape(body, shape, flags);
  }

  static uint32_t convex(swage_builder* raw, uint32_t body, const swage_convex* convex, uint32_t flags) {
    Builder& b = of(raw);
    if (!b.owns_body(body, "A convex polyhedron")) return scene::kNone;
    if (convex == nullptr || convex->vertex == nullptr || convex->face_start == nullptr ||
        convex->face_vertex == nullptr || convex->n_vertex == 0 || convex->n_face == 0)
      return b.refuse(say::kConvexNothing());
    if (convex->n_vertex > kMaxConvex || convex->n_face > kMaxConvex)
      return b.refuse(say::kConvexMany(kMaxConvex));
    std::vector<Vec3> vertex;
    Vec3 low = Vec3::Constant(1e300), high = -low;
    for (uint32_t i = 0; i < convex->n_vertex; ++i) {
      vertex.emplace_back(convex->vertex[3 * i], convex->vertex[3 * i + 1], convex->vertex[3 * i + 2]);
      if (!vertex.back().allFinite()) return b.refuse(say::kConvexVertex());
      low = low.cwiseMin(vertex.back());
      high = high.cwiseMax(vertex.back());
    }
    for (uint32_t f = 0; f < convex->n_face; ++f)
      if (convex->face_start[f] > convex->face_start[f + 1])
        return b.refuse(say::kConvexFaces());

    // the origin of S is the middle of the box, so that the bounding sphere is tight
    const Vec3 centre = 0.5 * (low + high);
    scene::Shape shape;
    for (Vec3& v : vertex) {
      v -= centre;
      shape.bounding_radius = std::max(shape.bounding_radius, v.norm());
    }
    toolkit::Convex built;
    const std::string wrong =
        toolkit::build_convex(vertex, {convex->face_start, convex->n_face + 1},
                              {convex->face_vertex, convex->face_start[convex->n_face]}, built);
    if (!wrong.empty()) return b.refuse(say::kConvexRefused(wrong));
    shape.kind = SWAGE_SHAPE_CONVEX;
    shape.X_BS = {toolkit::raw(centre), {1, 0, 0, 0}};
    shape.convex = static_cast<uint32_t>(b.world_.convex.size());
    const uint32_t index = b.add_shape(body, shape, flags);
    if (index != scene::kNone) b.world_.convex.push_back(std::move(built));
    return index;
  }

  static uint32_t hinge(swage_builder* raw, const swage_hinge* hinge) {
    Builder& b = of(raw);
    scene::World& w = b.world_;
    if (hinge == nullptr || !b.owns_body(hinge->parent, "A hinge") || !b.owns_body(hinge->child, "A hinge"))
      return hinge == nullptr ? b.refuse(say::kNullHinge()) : scene::kNone;
    const uint32_t parent = b.body.first + hinge->parent, child = b.body.first + hinge->child;
    const std::string& name = w.body[child].name;
    if (w.body[child].motion != SWAGE_MOTION_HINGED)
      return b.refuse(say::kOfHinge(name, say::kChildNotHinged()));
    if (w.body[child].hinge != scene::kNone) return b.refuse(say::kOfHinge(name, say::kHingeTwice()));
    if (parent >= child) return b.refuse(say::kOfHinge(name, say::kChildBeforeParent()));
    if (!finite(hinge->anchor) || !finite(hinge->axis) || !unit(toolkit::vec(hinge->axis).norm()))
      return b.refuse(say::kOfHinge(name, say::kHingeAxis()));
    if (!positive(hinge->inertia)) return b.refuse(say::kOfHinge(name, say::kHingeInertia()));
    if (!(hinge->min <= 0 && hinge->max >= 0 && hinge->min < hinge->max))
      return b.refuse(say::kOfHinge(name, say::kHingeAngles()));

    scene::HingeInfo info;
    info.object = b.owner_.object;
    info.parent = parent;
    info.child = child;
    info.anchor = hinge->anchor;
    info.axis = toolkit::raw(toolkit::vec(hinge->axis).normalized());
    info.X_PC0 = (Pose(w.body[parent].start).inverse() * Pose(w.body[child].start)).abi();
    info.inertia = hinge->inertia;
    info.min = hinge->min;
    info.max = hinge->max;
    w.body[child].hinge = static_cast<uint32_t>(w.hinge.size());
    w.hinge.push_back(info);
    w.hinge_angle.push_back(0);
    w.hinge_rate.push_back(0);
    w.hinge_torque.push_back(0);
    w.drive.push_back({});
    return b.hinge.count++;
  }

  static uint32_t state(swage_builder* raw, uint32_t n) {
    Builder& b = of(raw);
    if (!b.may(b.owner_.kind != SWAGE_KIND_DEVICE, "private state")) return scene::kNone;
    // 1 Mi doubles are 8 MB to save at each rewind; a larger number is a mistake
    if (n > (1u << 20)) return b.refuse(say::kLargeState(n));
    if (!b.fits(b.world_.plugin_state.size() + n, kMaxState, "private numbers")) return scene::kNone;
    const uint32_t first = b.state.count;
    b.state.count += n;
    b.world_.plugin_state.resize(b.world_.plugin_state.size() + n, 0.0);
    return first;
  }

  static uint32_t declare(swage_builder* raw, int32_t what, const char* id, const char* unit_text,
                          const char* doc) {
    Builder& b = of(raw);
    const int32_t kind = b.owner_.kind;
    judge::Name name{b.owner_.name, shortened(id, kMaxId), shortened(unit_text, kMaxId), shortened(doc, kMaxDoc)};
    switch (what) {
      case SWAGE_DECLARE_SIGNAL: {
        if (!b.may(kind == SWAGE_KIND_OBJECT || kind == SWAGE_KIND_COUPLING, "signals")) return scene::kNone;
        if (!b.fits(b.script_.signals.size() + 1, snapshot::kMaxSignals, "signals")) return scene::kNone;
        const uint32_t index = b.add_name(b.script_.signals, b.signal, std::move(name));
        if (index != scene::kNone) b.world_.signal.push_back(0);
        return index;
      }
      case SWAGE_DECLARE_METRIC:
        if (!b.may(kind == SWAGE_KIND_LESSON, "metrics")) return scene::kNone;
        if (!b.fits(b.script_.metrics.size() + 1, snapshot::kMaxMetrics, "metrics")) return scene::kNone;
        return b.add_name(b.script_.metrics, b.metric, std::move(name));
      case SWAGE_DECLARE_CUE:
        if (!b.may(kind == SWAGE_KIND_LESSON, "cues")) return scene::kNone;
        return b.add_name(b.script_.cues, b.cue, std::move(name));
      case SWAGE_DECLARE_EVENT:
        if (!b.may(kind == SWAGE_KIND_COUPLING || kind == SWAGE_KIND_LESSON, "events")) return scene::kNone;
        return b.add_name(b.script_.events, b.event, std::move(name));
      case SWAGE_DECLARE_PHASE:
        if (!b.may(kind == SWAGE_KIND_LESSON, "phases")) return scene::kNone;
        return b.add_name(b.script_.phases, b.phase, std::move(name));
      default:
        return b.refuse(say::kUnknownWhat(what));
    }
  }

  static void error(swage_builder* raw, const char* param_id, const char* message) {
    of(raw).refuse(shortened(message, kMaxDoc), shortened(param_id, kMaxId));
  }
};

Builder::Builder(Owner owner, scene::World& world, judge::Script& script, base::Problems& problems)
    : body{static_cast<uint32_t>(world.body.size()), 0},
      particle{static_cast<uint32_t>(world.particle_mass.size()), 0},
      shape{static_cast<uint32_t>(world.shape.size()), 0},
      hinge{static_cast<uint32_t>(world.hinge.size()), 0},
      state{static_cast<uint32_t>(world.plugin_state.size()), 0},
      signal{static_cast<uint32_t>(script.signals.size()), 0},
      metric{static_cast<uint32_t>(script.metrics.size()), 0},
      cue{static_cast<uint32_t>(script.cues.size()), 0},
      event{static_cast<uint32_t>(script.events.size()), 0},
      phase{static_cast<uint32_t>(script.phases.size()), 0},
      owner_(std::move(owner)),
      world_(world),
      script_(script),
      problems_(problems) {
  using Calls = BuilderCalls;
  abi_ = {sizeof(swage_builder),
          0,
          this,
          Calls::body,
          Calls::particles,
          Calls::sphere,
          Calls::capsule,
          Calls::cylinder,
          Calls::arc,
          Calls::convex,
          Calls::hinge,
          Calls::state,
          Calls::declare,
          Calls::error};
}

uint32_t Builder::refuse(const std::string& message, const std::string& param_id) {
  const std::string where = owner_.where ? owner_.where(param_id) : owner_.name;
  // A refusal repeated in a loop is reported once.
  const bool told = !problems_.empty() && problems_.back().where == where && problems_.back().message == message;
  if (!told && ++refusals_ <= kMostRefusals) problems_.push_back({base::Severity::kError, where, message});
  failed_ = true;
  return scene::kNone;
}

bool Builder::may(bool allowed, const char* what) {
  if (!allowed) refuse(say::kHasNo(article(owner_.kind), what));
  return allowed;
}

bool Builder::fits(std::size_t n, uint32_t capacity, const char* what) {
  if (n <= capacity) return true;
  refuse(say::kNoRoom(n, what, capacity));
  return false;
}

bool Builder::owns_body(uint32_t index, const char* shape_name) {
  if (index < body.count) return true;
  refuse(say::kNotDeclared(shape_name, index == scene::kNone ? "NONE" : std::to_string(index)));
  return false;
}

uint32_t Builder::add_shape(uint32_t body_index, scene::Shape s, uint32_t flags) {
  if (!fits(world_.shape.size() + 1, kMaxShapes, "shapes")) return scene::kNone;
  if ((flags & ~SWAGE_SHAPE_USUAL) != 0)
    return refuse(say::kUnknownFlags(flags));
  s.body = body.first + body_index;
  s.object = owner_.object;
  s.flags = flags;
  world_.shape.push_back(s);
  return shape.count++;
}

}  // namespace swage::host
