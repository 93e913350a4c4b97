// SPDX-License-Identifier: Apache-2.0
//
// An object: something in the scene. Most objects declare bodies and shapes in build() and add forces in forces().
// An object with its own mechanics inherits Solver as well and moves its flexible bodies itself.
//
//   class Ball final : public swage::Object<BallParams>, public swage::Solid { ... };
//   SWAGE_EXPORT(Ball)
#pragma once

#include <swage/abi/object.h>
#include <swage/plugin.hpp>
#include <swage/step.hpp>
#include <swage/visual.hpp>

namespace swage {

namespace detail {
template <class T>
struct ObjectTables;
}

/// Base of every object plugin.
template <class P = NoParams>
class Object : public WithParams<P> {
 public:
  using Kind = Object;
  using Builder = ObjectBuilder;
  template <class T>
  using Tables = detail::ObjectTables<T>;
  static constexpr int32_t kKind = SWAGE_KIND_OBJECT;

  /// Declares everything the instance will ever own. [main]
  virtual void build(const P& params, ObjectBuilder& builder) = 0;
  /// Adds forces and sets drives, before contacts. [rt]
  virtual void forces(const Step& step) SWAGE_RT { static_cast<void>(step); }
  /// Writes the signals, after the step. [rt]
  virtual void finish(const Step& step) SWAGE_RT { static_cast<void>(step); }
  /// Resets the private state, also before the first step; the bodies are at their start poses. [rt]
  virtual void reset(const Step& step) SWAGE_RT { static_cast<void>(step); }
};

/// Mechanics of flexible bodies. Per step: advance, mobility for all points of contact, apply_impulses with their
/// impulses.
class Solver {
 public:
  virtual ~Solver() = default;
  /// Free motion over dt: writes poses and twists of flexible bodies. [rt]
  virtual void advance(const Step& step) SWAGE_RT = 0;
  /// Velocities of the points under impulses j: v = v_free + W j. v_free: 3 n [m/s]; W: 3n x 3n row-major [m/s per N
  /// s], symmetric, positive semi-definite. [rt]
  virtual void mobility(const Step& step, std::span<const swage_contact_point> points, double* v_free,
                          double* W) SWAGE_RT = 0;
  /// Takes the impulses, 3 n [N s] on the object, and writes the final poses and twists. [rt]
  virtual void apply_impulses(const Step& step, std::span<const swage_contact_point> points,
                     const double* impulse) SWAGE_RT = 0;
};

/// Solver of an object with chains: place[i] is the place of points[i] on its chain.
class ChainSolver {
 public:
  virtual ~ChainSolver() = default;
  virtual void advance(const Step& step) SWAGE_RT = 0;
  virtual void mobility(const Step& step, std::span<const swage_contact_point> points,
                          std::span<const swage_chain_place> place, double* v_free, double* W) SWAGE_RT = 0;
  virtual void apply_impulses(const Step& step, std::span<const swage_contact_point> points,
                     std::span<const swage_chain_place> place, const double* impulse) SWAGE_RT = 0;
};

/// Inherited beside Solver by an object whose free surface differs from its shapes.
class Surface {
 public:
  virtual ~Surface() = default;
  /// Writes the displacement of the free surface from the shape at each point: 3 n [m]. Called after mobility. [rt]
  virtual void displacement(const Step& step, std::span<const swage_contact_point> points,
                            double* u_W) SWAGE_RT = 0;
};

/// Primitives drawn on the object that its shapes do not contain; for drawing only.
class Drawing {
 public:
  virtual ~Drawing() = default;
  /// Adds primitives to `out`. Called after finish() when a snapshot is taken; must not change state. [rt]
  virtual void draw(const Step& step, Visuals& out) SWAGE_RT = 0;
};

/// Its COLLIDES shapes resist penetration. A promise without functions.
class Solid {};

/// Can be held by a gripper.
class Graspable {
 public:
  virtual ~Graspable() = default;
  /// The place on the centre line nearest to p_W. [rt]
  virtual void locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) SWAGE_RT = 0;
};

/// Has two jaws.
class Gripper {
 public:
  virtual ~Gripper() = default;
  /// Writes the place and opening of the jaws. [rt]
  virtual void describe(const Step& step, swage_gripper_state& out) SWAGE_RT = 0;
};

/// Has a point that goes through tissue.
class Piercing {
 public:
  virtual ~Piercing() = default;
  /// The place on the centre line at s, 0 at the point and 1 at the swage. [rt]
  virtual void place(const Step& step, double s, swage_piercing_place& out) SWAGE_RT = 0;
  /// The place on the centre line nearest to p_W. [rt]
  virtual void nearest(const Step& step, swage_vec3 p_W, swage_piercing_place& out) SWAGE_RT = 0;
};

/// Can be pierced.
class Pierceable {
 public:
  virtual ~Pierceable() = default;
  /// Writes its properties, constant while active. [rt]
  virtual void law(const Step& step, swage_pierceable_law& out) SWAGE_RT = 0;
  /// Locates a point relative to its surfaces. [rt]
  virtual void locate(const Step& step, swage_vec3 p_W, swage_pierceable_place& out) SWAGE_RT = 0;
};

namespace detail {

inline constexpr Entry kForces{"forces", 4, kRt, When::kActive};
inline constexpr Entry kFinish{"finish", 5, kRt, When::kActive};
inline constexpr Entry kReset{"reset", 6, kRt, When::kActive};
inline constexpr Entry kAdvance{"advance", 7, kRt, When::kActive};
inline constexpr Entry kMobility{"mobility", 8, kRt, When::kActive};
inline constexpr Entry kApplyImpulses{"apply_impulses", 9, kRt, When::kActive};
inline constexpr Entry kLocate{"locate", 10, kRt, When::kActive};
inline constexpr Entry kDescribe{"describe", 11, kRt, When::kActive};
inline constexpr Entry kPlace{"place", 25, kRt, When::kActive};
inline constexpr Entry kNearest{"nearest", 32, kRt, When::kActive};
inline constexpr Entry kLaw{"law", 33, kRt, When::kActive};
inline constexpr Entry kLocateIn{"locate", 28, kRt, When::kActive};
inline constexpr Entry kDisplacement{"displacement", 29, kRt, When::kActive};
inline constexpr Entry kDraw{"draw", 30, kRt, When::kActive};

/// The tables that object T offers, and the list of its traits.
template <class T>
struct ObjectTables {
  using Raw = const swage_object_step*;
  static constexpr bool kSolves = std::is_base_of_v<Solver, T>;
  static constexpr bool kSolvesChain = std::is_base_of_v<ChainSolver, T>;
  static constexpr bool kSolid = std::is_base_of_v<Solid, T>;
  static constexpr bool kGraspable = std::is_base_of_v<Graspable, T>;
  static constexpr bool kGripper = std::is_base_of_v<Gripper, T>;
  static constexpr bool kPiercing = std::is_base_of_v<Piercing, T>;
  static constexpr bool kPierceable = std::is_base_of_v<Pierceable, T>;

  static swage_result forces(swage_instance* i, Raw s) noexcept {
    return guarded<T>(i, kForces, [&](typename T::Kind& plugin, auto&) { plugin.forces(Step(s)); });
  }
  static swage_result finish(swage_instance* i, Raw s) noexcept {
    return guarded<T>(i, kFinish, [&](typename T::Kind& plugin, auto&) { plugin.finish(Step(s)); });
  }
  static void reset(swage_instance* i, Raw s) noexcept {
    guarded<T>(i, kReset, [&](typename T::Kind& plugin, auto&) { plugin.reset(Step(s)); });
  }
  static swage_result advance(swage_instance* i, Raw s) noexcept {
    return guarded<T>(i, kAdvance, [&](auto&, Holder<T>& h) { part<Solver>(h).advance(Step(s)); });
  }
  static swage_result mobility(swage_instance* i, Raw s, uint32_t n, const swage_contact_point* point,
                                 double* v_free, double* W) noexcept {
    return guarded<T>(i, kMobility, [&](auto&, Holder<T>& h) {
      part<Solver>(h).mobility(Step(s), {point, n}, v_free, W);
    });
  }
  static swage_result apply_impulses(swage_instance* i, Raw s, uint32_t n, const swage_contact_point* point,
                            const double* impulse) noexcept {
    return guarded<T>(i, kApplyImpulses, [&](auto&, Holder<T>& h) {
      part<Solver>(h).apply_impulses(Step(s), {point, n}, impulse);
    });
  }
  static swage_result advance_chain(swage_instance* i, Raw s) noexcept {
    return guarded<T>(i, kAdvance, [&](auto&, Holder<T>& h) { part<ChainSolver>(h).advance(Step(s)); });
  }
  static swage_result mobility_of_chain(swage_instance* i, Raw s, uint32_t n, const swage_contact_point* point,
                                          const swage_chain_place* place, double* v_free,
                                          double* W) noexcept {
    return guarded<T>(i, kMobility, [&](auto&, Holder<T>& h) {
      part<ChainSolver>(h).mobility(Step(s), {point, n}, {place, n}, v_free, W);
    });
  }
  static swage_result apply_impulses_to_chain(swage_instance* i, Raw s, uint32_t n, const swage_contact_point* point,
                                  const swage_chain_place* place, const double* impulse) noexcept {
    return guarded<T>(i, kApplyImpulses, [&](auto&, Holder<T>& h) {
      part<ChainSolver>(h).apply_impulses(Step(s), {point, n}, {place, n}, impulse);
    });
  }
  static swage_result locate(swage_instance* i, Raw s, swage_vec3 p_W, swage_graspable_place* out) noexcept {
    return guarded<T>(i, kLocate,
                      [&](auto&, Holder<T>& h) { part<Graspable>(h).locate(Step(s), p_W, *out); });
  }
  static swage_result describe(swage_instance* i, Raw s, swage_gripper_state* out) noexcept {
    return guarded<T>(i, kDescribe, [&](auto&, Holder<T>& h) { part<Gripper>(h).describe(Step(s), *out); });
  }

  static swage_result displacement(swage_instance* i, Raw s, uint32_t n, const swage_contact_point* point,
                                   double* u_W) noexcept {
    return guarded<T>(i, kDisplacement, [&](auto&, Holder<T>& h) {
      part<Surface>(h).displacement(Step(s), {point, n}, u_W);
    });
  }
  static swage_result draw(swage_instance* i, Raw s, const swage_coupling_step*, uint32_t capacity, swage_visual* out,
                           uint32_t* n) noexcept {
    return guarded<T>(i, kDraw, [&](auto&, Holder<T>& h) {
      Visuals list({out, capacity});
      part<Drawing>(h).draw(Step(s), list);
      *n = list.size();
    });
  }
  static swage_result place(swage_instance* i, Raw s, double where, swage_piercing_place* out) noexcept {
    return guarded<T>(i, kPlace, [&](auto&, Holder<T>& h) { part<Piercing>(h).place(Step(s), where, *out); });
  }
  static swage_result nearest(swage_instance* i, Raw s, swage_vec3 p_W, swage_piercing_place* out) noexcept {
    return guarded<T>(i, kNearest,
                      [&](auto&, Holder<T>& h) { part<Piercing>(h).nearest(Step(s), p_W, *out); });
  }
  static swage_result law(swage_instance* i, Raw s, swage_pierceable_law* out) noexcept {
    return guarded<T>(i, kLaw, [&](auto&, Holder<T>& h) { part<Pierceable>(h).law(Step(s), *out); });
  }
  static swage_result locate_in(swage_instance* i, Raw s, swage_vec3 p_W,
                                swage_pierceable_place* out) noexcept {
    return guarded<T>(i, kLocateIn,
                      [&](auto&, Holder<T>& h) { part<Pierceable>(h).locate(Step(s), p_W, *out); });
  }

  static const void* find(const char* id) {
    static constexpr swage_object object{forces, finish, reset};
    static constexpr uint32_t promise = 1;
    if (same(id, SWAGE_EXT_OBJECT)) return &object;
    if constexpr (kSolves) {
      static constexpr swage_solver solver{advance, mobility, apply_impulses};
      if (same(id, SWAGE_EXT_SOLVER)) return &solver;
    }
    if constexpr (kSolvesChain) {
      static_assert(!kSolves, "an object has one solver");
      static constexpr swage_solver_2 solver{advance_chain, mobility_of_chain, apply_impulses_to_chain};
      if (same(id, SWAGE_EXT_SOLVER_2)) return &solver;
    }
    if constexpr (kGraspable) {
      static constexpr swage_graspable graspable{locate};
      if (same(id, SWAGE_TRAIT_GRASPABLE)) return &graspable;
    }
    if constexpr (kGripper) {
      static constexpr swage_gripper gripper{describe};
      if (same(id, SWAGE_TRAIT_GRIPPER)) return &gripper;
    }
    if constexpr (std::is_base_of_v<Surface, T>) {
      static_assert(kSolves || kSolvesChain, "a Surface stands beside a Solver");
      static constexpr swage_surface surface{displacement};
      if (same(id, SWAGE_EXT_SURFACE)) return &surface;
    }
    if constexpr (std::is_base_of_v<Drawing, T>) {
      static constexpr swage_visuals drawing{draw};
      if (same(id, SWAGE_EXT_VISUAL)) return &drawing;
    }
    if constexpr (kPiercing) {
      static constexpr swage_piercing piercing{place, nearest};
      if (same(id, SWAGE_TRAIT_PIERCING)) return &piercing;
    }
    if constexpr (kPierceable) {
      static constexpr swage_pierceable pierceable{law, locate_in};
      if (same(id, SWAGE_TRAIT_PIERCEABLE)) return &pierceable;
    }
    if (kSolid && same(id, SWAGE_TRAIT_SOLID)) return &promise;
    return nullptr;
  }

 private:
  template <class Part>
  static Part& part(Holder<T>& holder) {
    return *holder.plugin;
  }

  // the traits of the interfaces that T inherits, then those it lists itself, then NULL
  static constexpr size_t n_own() {
    if constexpr (requires { T::traits; }) return T::traits.size();
    return 0;
  }
  static constexpr auto list_traits() {
    std::array<const char*, n_own() + 6> list{};
    size_t n = 0;
    if (kSolid) list[n++] = SWAGE_TRAIT_SOLID;
    if (kGraspable) list[n++] = SWAGE_TRAIT_GRASPABLE;
    if (kGripper) list[n++] = SWAGE_TRAIT_GRIPPER;
    if (kPiercing) list[n++] = SWAGE_TRAIT_PIERCING;
    if (kPierceable) list[n++] = SWAGE_TRAIT_PIERCEABLE;
    if constexpr (n_own() > 0) {
      for (const char* trait : T::traits) list[n++] = trait;
    }
    return list;
  }
  static constexpr auto trait_list = list_traits();

 public:
  static constexpr const char* const* traits = trait_list.data();
};

}  // namespace detail

}  // namespace swage
