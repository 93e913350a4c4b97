// SPDX-License-Identifier: Apache-2.0
//
// A coupling: the interaction of two objects. It names the traits it needs on each side, never a plugin.
//
//   class Grip final : public swage::Coupling<GripParams> {
//    public:
//     static constexpr std::array needs_a{SWAGE_TRAIT_GRIPPER}, needs_b{SWAGE_TRAIT_GRASPABLE};
//     static constexpr bool detects = true;  // the host finds the contacts between a and b for the solver
//     ...
//   };
#pragma once

#include <swage/abi/coupling.h>
#include <swage/peer.hpp>
#include <swage/plugin.hpp>
#include <swage/step.hpp>
#include <swage/visual.hpp>

namespace swage {

/// View of a swage_coupling_step.
class CouplingStep {
 public:
  explicit CouplingStep(const swage_coupling_step* raw) : raw_(raw) {}
  const swage_coupling_step* operator->() const { return raw_; }

  double time() const { return raw_->time_s; }  // s
  double dt() const { return raw_->dt_s; }      // s
  Step a() const { return Step(raw_->a); }
  Step b() const { return Step(raw_->b); }

  /// The contacts of this step. In resolve() their law may be changed; in finish() their forces are known.
  std::span<swage_contact> contacts() const { return {raw_->contact, raw_->n_contact}; }

  /// Reports that an event happened.
  void event(Event event, double value = 0) const { raw_->event(raw_, event, value); }
  void signal(Signal signal, double value) const {
    assert(signal < raw_->n_signal);
    raw_->signal[signal] = value;
  }

  /// The private numbers, as declared with builder.state<T>().
  template <class T>
  T& state() const {
    assert(sizeof(T) <= raw_->n_state * sizeof(double));
    return *static_cast<T*>(static_cast<void*>(raw_->state));
  }
  std::span<double> state() const { return {raw_->state, raw_->n_state}; }

 private:
  const swage_coupling_step* raw_;
};

/// Compliant constraints between the two objects: a spring that slides beyond a limit along an axis, a spring across it. A coupling
/// inherits it beside Coupling; the rest position of a tie is the coupling's own state.
class Ties {
 public:
  virtual ~Ties() = default;
  /// After resolve(): writes at most out.size() ties, returns how many; f_a_W of each: its force in the step before, or 0. [rt]
  virtual uint32_t ties(const CouplingStep& step, std::span<swage_tie> out) SWAGE_RT = 0;
  /// Before finish(): the same ties with their forces and plastic slips. [rt]
  virtual void on_solved(const CouplingStep& step, std::span<const swage_tie> ties) SWAGE_RT = 0;
};

/// Primitives drawn on object b that its shapes do not contain, such as torn regions; for drawing only.
class DrawingOnB {
 public:
  virtual ~DrawingOnB() = default;
  /// Adds primitives to `out`. Called after finish() when a snapshot is taken; must not change state. [rt]
  virtual void draw(const CouplingStep& step, Visuals& out) SWAGE_RT = 0;
};

namespace detail {
template <class T>
struct CouplingTables;
}

/// Base of every coupling plugin.
template <class P = NoParams>
class Coupling : public WithParams<P> {
 public:
  using Kind = Coupling;
  using Builder = CouplingBuilder;
  template <class T>
  using Tables = detail::CouplingTables<T>;
  static constexpr int32_t kKind = SWAGE_KIND_COUPLING;

  /// Declares signals, events and private numbers. [main]
  virtual void build(const P& params, CouplingBuilder& builder) {
    static_cast<void>(params);
    static_cast<void>(builder);
  }
  /// Receives the two objects, which offer the traits in needs_a and needs_b; refuse() rejects them. [main]
  virtual void bind(const Peer& a, const Peer& b) {
    static_cast<void>(a);
    static_cast<void>(b);
  }
  /// Contacts are detected and not yet solved. [rt]
  virtual void resolve(const CouplingStep& step) SWAGE_RT { static_cast<void>(step); }
  /// Contacts are solved. [rt]
  virtual void finish(const CouplingStep& step) SWAGE_RT { static_cast<void>(step); }
  /// Private numbers back to the start. [rt]
  virtual void reset(const CouplingStep& step) SWAGE_RT { static_cast<void>(step); }
};

namespace detail {

inline constexpr Entry kBindCoupling{"bind", 12, kMain, When::kReady};
inline constexpr Entry kResolve{"resolve", 13, kRt, When::kActive};
inline constexpr Entry kFinishCoupling{"finish", 14, kRt, When::kActive};
inline constexpr Entry kResetCoupling{"reset", 15, kRt, When::kActive};
inline constexpr Entry kTies{"ties", 23, kRt, When::kActive};
inline constexpr Entry kOnSolved{"on_solved", 24, kRt, When::kActive};
inline constexpr Entry kDrawOnB{"draw", 31, kRt, When::kActive};

template <class List>
constexpr auto null_terminated(const List& list) {
  std::array<const char*, std::tuple_size_v<List> + 1> out{};
  for (size_t i = 0; i < list.size(); ++i) out[i] = list[i];
  return out;
}

/// The table that coupling T offers.
template <class T>
struct CouplingTables {
  using Raw = const swage_coupling_step*;
  static constexpr const char* no_traits[] = {nullptr};
  static constexpr const char* const* traits = no_traits;

  static swage_result bind(swage_instance* i, swage_instance* a, swage_instance* b) noexcept {
    return guarded<T>(i, kBindCoupling,
                      [&](typename T::Kind& plugin, auto&) { plugin.bind(Peer(a), Peer(b)); });
  }
  static swage_result resolve(swage_instance* i, Raw s) noexcept {
    return guarded<T>(i, kResolve, [&](typename T::Kind& plugin, auto&) { plugin.resolve(CouplingStep(s)); });
  }
  static swage_result finish(swage_instance* i, Raw s) noexcept {
    return guarded<T>(i, kFinishCoupling,
                      [&](typename T::Kind& plugin, auto&) { plugin.finish(CouplingStep(s)); });
  }
  static void reset(swage_instance* i, Raw s) noexcept {
    guarded<T>(i, kResetCoupling, [&](typename T::Kind& plugin, auto&) { plugin.reset(CouplingStep(s)); });
  }

  static swage_result ties(swage_instance* i, Raw s, uint32_t capacity, swage_tie* out,
                           uint32_t* n) noexcept {
    return guarded<T>(i, kTies, [&](auto&, Holder<T>& h) {
      *n = part<Ties>(h).ties(CouplingStep(s), {out, capacity});
    });
  }
  static swage_result on_solved(swage_instance* i, Raw s, uint32_t n, const swage_tie* tie) noexcept {
    return guarded<T>(i, kOnSolved, [&](auto&, Holder<T>& h) { part<Ties>(h).on_solved(CouplingStep(s), {tie, n}); });
  }

  static swage_result draw(swage_instance* i, const swage_object_step*, Raw s, uint32_t capacity, swage_visual* out,
                           uint32_t* n) noexcept {
    return guarded<T>(i, kDrawOnB, [&](auto&, Holder<T>& h) {
      Visuals list({out, capacity});
      part<DrawingOnB>(h).draw(CouplingStep(s), list);
      *n = list.size();
    });
  }

  static const void* find(const char* id) {
    static_assert(
        requires { T::needs_a.size() + T::needs_b.size(); },
        "a coupling lists the traits it needs: static constexpr std::array needs_a{...}, needs_b{...}");
    static_assert(
        requires { bool{T::detects}; },
        "a coupling says whether the host finds contacts for it: static constexpr bool detects");
    static constexpr auto needs_a = null_terminated(T::needs_a);
    static constexpr auto needs_b = null_terminated(T::needs_b);
    static constexpr swage_coupling table{
        needs_a.data(), needs_b.data(), T::detects ? 1u : 0u, 0, bind, resolve, finish, reset};
    if (same(id, SWAGE_EXT_COUPLING)) return &table;
    if constexpr (std::is_base_of_v<Ties, T>) {
      static constexpr swage_ties links{ties, on_solved};
      if (same(id, SWAGE_EXT_TIES)) return &links;
    }
    if constexpr (std::is_base_of_v<DrawingOnB, T>) {
      static constexpr swage_visuals drawing{draw};
      if (same(id, SWAGE_EXT_VISUAL)) return &drawing;
    }
    return nullptr;
  }

 private:
  template <class Part>
  static Part& part(Holder<T>& holder) {
    return *holder.plugin;
  }
};

}  // namespace detail

}  // namespace swage
