// SPDX-License-Identifier: Apache-2.0
//
// The builders that build() receives. Each kind of plugin gets one with exactly the declarations of its kind.
// [main]
//
// A declaration that the host refuses returns an index that is not valid(); the host has reported why, and
// configure fails.
#pragma once

#include <swage/abi/lesson_card.h>
#include <swage/common.hpp>

#include <span>
#include <string>
#include <type_traits>

namespace swage {

/// The declarations of every kind: private numbers and signals; and reports of problems.
class Builder {
 public:
  explicit Builder(swage_builder* raw) : raw_(raw) {}
  Builder(const Builder&) = delete;
  Builder& operator=(const Builder&) = delete;

  /// A number per step for graphs, lessons and records, e.g. ("grip.force", "N", "Normal force between the
  /// jaws.").
  Signal signal(const char* id, const char* unit, const char* doc) {
    return Signal(declare(SWAGE_DECLARE_SIGNAL, id, unit, doc));
  }

  /// The private numbers of the instance: a struct of doubles, kept, saved, restored and hashed by the host.
  template <class T>
  void state() {
    static_assert(std::is_trivially_copyable_v<T> && std::is_standard_layout_v<T>,
                  "state is a plain struct of doubles");
    static_assert(alignof(T) == alignof(double) && sizeof(T) % sizeof(double) == 0,
                  "state is a plain struct of doubles");
    state(sizeof(T) / sizeof(double));
  }
  void state(uint32_t n_double) {
    checked(raw_->state(raw_, n_double));
    n_state_ += n_double;
  }

  /// Reports a problem with one parameter ("" for the whole instance). Several may be reported; configure then fails.
  void error(const char* param_id, const std::string& message) {
    raw_->error(raw_, param_id, message.c_str());
    failed_ = true;
  }

  bool failed() const { return failed_; }
  uint32_t n_state() const { return n_state_; }
  swage_builder* raw() const { return raw_; }

 protected:
  uint32_t checked(uint32_t index) {
    failed_ = failed_ || index == kNone;
    return index;
  }
  uint32_t declare(int32_t what, const char* id, const char* unit, const char* doc) {
    return checked(raw_->declare(raw_, what, id, unit, doc));
  }

 private:
  swage_builder* raw_;
  uint32_t n_state_ = 0;
  bool failed_ = false;
};

/// Objects: bodies, particles, shapes, hinges. Poses are in the object's own frame O.
class ObjectBuilder : public Builder {
 public:
  using Builder::Builder;

  /// Never moves.
  Body fixed_body(const char* name, const swage_pose& X_OB = kIdentity) {
    return body(SWAGE_MOTION_FIXED, name, X_OB);
  }
  /// Takes the pose of the device that the lesson binds to the object.
  Body following_body(const char* name, const swage_pose& X_OB = kIdentity) {
    return body(SWAGE_MOTION_FOLLOWS, name, X_OB);
  }
  /// Moved by the host under forces and contacts. B sits at the centre of mass, axes along the principal
  /// ones.
  Body dynamic_body(const char* name, const swage_mass& mass, const swage_pose& X_OB = kIdentity) {
    return Body(checked(raw()->body(raw(), SWAGE_MOTION_DYNAMIC, &X_OB, &mass, name)));
  }
  /// Turns about an axis of its parent; declare its hinge() too.
  Body hinged_body(const char* name, const swage_pose& X_OB = kIdentity) {
    return body(SWAGE_MOTION_HINGED, name, X_OB);
  }
  /// Moved by the object's own Solver.
  Body flexible_body(const char* name, const swage_pose& X_OB = kIdentity) {
    return body(SWAGE_MOTION_FLEXIBLE, name, X_OB);
  }

  /// Point masses moved by the host: 3 n positions in O [m], n masses [kg]. Returns the first index.
  Particles particles(std::span<const double> p_O, std::span<const double> mass, double radius) {
    const auto n = static_cast<uint32_t>(mass.size());
    if (p_O.size() != 3 * mass.size()) {
      error("", "particles() needs three coordinates for each mass");
      return Particles();
    }
    return Particles(checked(raw()->particles(raw(), n, p_O.data(), mass.data(), radius)));
  }

  Shape sphere(Body body, swage_vec3 centre, double radius, uint32_t flags = SWAGE_SHAPE_USUAL) {
    return Shape(checked(raw()->sphere(raw(), body, centre, radius, flags)));
  }
  Shape capsule(Body body, swage_vec3 a, swage_vec3 b, double radius, uint32_t flags = SWAGE_SHAPE_USUAL) {
    return Shape(checked(raw()->capsule(raw(), body, a, b, radius, flags)));
  }
  Shape cylinder(Body body, swage_vec3 a, swage_vec3 b, double radius, uint32_t flags = SWAGE_SHAPE_USUAL) {
    return Shape(checked(raw()->cylinder(raw(), body, a, b, radius, flags)));
  }
  Shape arc(Body body, const swage_arc& arc, uint32_t flags = SWAGE_SHAPE_USUAL) {
    return Shape(checked(raw()->arc(raw(), body, &arc, flags)));
  }
  /// vertex: 3 n coordinates in B [m]; face i has face_vertex[face_start[i] .. face_start[i + 1]),
  /// counter-clockwise seen from outside, so face_start has one entry more than there are faces.
  Shape convex(Body body, std::span<const double> vertex, std::span<const uint32_t> face_start,
               std::span<const uint32_t> face_vertex, uint32_t flags = SWAGE_SHAPE_USUAL) {
    if (vertex.size() % 3 != 0 || face_start.size() < 2 || face_start.back() != face_vertex.size()) {
      error("",
            "convex() needs three coordinates a vertex, and face_start ending at the size of face_vertex");
      return Shape();
    }
    const swage_convex convex{static_cast<uint32_t>(vertex.size() / 3),
                              static_cast<uint32_t>(face_start.size() - 1), vertex.data(), face_start.data(),
                              face_vertex.data()};
    return Shape(checked(raw()->convex(raw(), body, &convex, flags)));
  }

  /// A surface over a grid. `table`: host_extension<swage_host_height_field>(SWAGE_HOST_HEIGHT_FIELD).
  Shape height_field(const swage_host_height_field* table, Body body, const swage_height_field& field,
                     uint32_t flags = SWAGE_SHAPE_USUAL) {
    if (table == nullptr) {
      error("", "this host knows no height fields");
      return Shape();
    }
    return Shape(checked(table->declare(raw(), body, &field, flags)));
  }

  /// Reserves room for so many contact points at once, for an object that is a Solver. Returns the number that it gets.
  /// `table`: host_extension<swage_host_capacities>(SWAGE_HOST_CAPACITIES).
  uint32_t reserve_points(const swage_host_capacities* table, uint32_t points) {
    if (table == nullptr) {
      error("", "this host has no capacities to ask for");
      return 0;
    }
    return table->reserve_points(raw(), points);
  }

  /// A flexible wire on a flexible_body(), with the first of the 8 n private doubles (ChainState in step.hpp) that hold its shape.
  /// `table`: host_extension<swage_host_chain>(SWAGE_HOST_CHAIN).
  Shape chain(const swage_host_chain* table, Body body, const swage_chain& chain,
              uint32_t flags = SWAGE_SHAPE_USUAL) {
    if (table == nullptr) {
      error("", "this host knows no chains");
      return Shape();
    }
    return Shape(checked(table->declare(raw(), body, &chain, flags)));
  }

  Hinge hinge(const swage_hinge& hinge) { return Hinge(checked(raw()->hinge(raw(), &hinge))); }

 private:
  Body body(int32_t motion, const char* name, const swage_pose& X_OB) {
    return Body(checked(raw()->body(raw(), motion, &X_OB, nullptr, name)));
  }
};

/// Couplings: events.
class CouplingBuilder : public Builder {
 public:
  using Builder::Builder;
  /// Something that happens, e.g. ("grasp.taken", "The needle is held by both jaws.").
  Event event(const char* id, const char* doc) { return Event(declare(SWAGE_DECLARE_EVENT, id, "1", doc)); }
};

/// Devices declare nothing beyond what all kinds may.
using DeviceBuilder = Builder;

/// Lessons: metrics, cues, events, phases. Ids are meanings, never colours.
class LessonBuilder : public Builder {
 public:
  using Builder::Builder;
  Metric metric(const char* id, const char* unit, const char* doc) {
    return Metric(declare(SWAGE_DECLARE_METRIC, id, unit, doc));
  }
  Cue cue(const char* id, const char* doc) { return Cue(declare(SWAGE_DECLARE_CUE, id, "1", doc)); }
  /// Declares an entry of the lesson's card (static constexpr arrays `metrics` and `cues` of the class).
  Metric metric(const swage_metric_info& m) { return metric(m.id, m.unit, m.doc); }
  Cue cue(const swage_cue_info& c) { return cue(c.id, c.doc); }
  Event event(const char* id, const char* doc) { return Event(declare(SWAGE_DECLARE_EVENT, id, "1", doc)); }
  Phase phase(const char* id, const char* doc) { return Phase(declare(SWAGE_DECLARE_PHASE, id, "1", doc)); }
};

}  // namespace swage
