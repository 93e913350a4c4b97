// SPDX-License-Identifier: Apache-2.0
//
// A lesson: observes the scene and judges. It sees everything as const, so the same code judges live and
// re-judges recordings; its cues are meanings ("grasp.good"), to which the console gives colours, shapes
// and sounds.
#pragma once

#include <swage/abi/lesson.h>
#include <swage/peer.hpp>
#include <swage/plugin.hpp>

#include <optional>

namespace swage {

/// Everything with a name in the scene. [main]
class Scene {
 public:
  explicit Scene(const swage_scene_card* raw) : raw_(raw) {}
  const swage_scene_card* operator->() const { return raw_; }

  double length() const { return raw_->scene_length; }  // m, tolerances are relative to it
  std::span<const swage_scene_object> objects() const { return {raw_->object, raw_->n_object}; }

  /// Index of an object by its name in the lesson file, or kNone.
  uint32_t find_object(std::string_view name) const {
    for (uint32_t i = 0; i < raw_->n_object; ++i)
      if (view(raw_->object[i].name) == name) return i;
    return kNone;
  }
  /// A signal by owner and id; not valid() when there is none.
  Signal find_signal(std::string_view owner, std::string_view id) const {
    for (uint32_t i = 0; i < raw_->n_signal; ++i)
      if (view(raw_->signal[i].owner) == owner && view(raw_->signal[i].id) == id) return Signal(i);
    return Signal();
  }
  /// An event by owner and id; not valid() when there is none.
  Event find_event(std::string_view owner, std::string_view id) const {
    for (uint32_t i = 0; i < raw_->n_event; ++i)
      if (view(raw_->event[i].owner) == owner && view(raw_->event[i].id) == id) return Event(i);
    return Event();
  }

 private:
  const swage_scene_card* raw_;
};

/// Argument of bind(): declares marks and reports problems. [main]
class Binder {
 public:
  explicit Binder(swage_lesson_binder* raw) : raw_(raw) {}

  /// Part of an object's arc, from and to in 0..1; meaning e.g. "region.target".
  Mark mark_arc(uint32_t object, double from, double to, std::string_view meaning) {
    return add({SWAGE_MARK_ARC_RANGE, object, str(meaning), {from, to}, {}});
  }
  /// A point in the world with a radius [m]; meaning e.g. "target.point".
  Mark mark_point(swage_vec3 p_W, double radius, std::string_view meaning) {
    return add({SWAGE_MARK_POINT, kNone, str(meaning), {radius, 0}, p_W});
  }
  /// Reports a signal or event that `owner` does not offer, with those that it does offer. [main]
  void missing(const Scene& scene, std::string_view what, std::string_view owner, std::string_view id, std::string_view why) {
    const bool event = what == "event";
    std::string text = "\"" + std::string(owner) + "\" has no " + std::string(what) + " \"" + std::string(id) + "\"";
    if (!why.empty()) text += ", " + std::string(why);
    std::string there, others;
    const auto add = [&](const swage_str& of, const swage_str& one) {
      const std::string name(view(of));
      if (name == owner) there += (there.empty() ? "" : ", ") + std::string(view(one));
      if ((", " + others + ", ").find(", " + name + ", ") == std::string::npos) others += (others.empty() ? "" : ", ") + name;
    };
    for (uint32_t i = 0; !event && i < scene->n_signal; ++i) add(scene->signal[i].owner, scene->signal[i].id);
    for (uint32_t i = 0; event && i < scene->n_event; ++i) add(scene->event[i].owner, scene->event[i].id);
    const std::string who = others.empty() ? "" : ". Here " + std::string(what) + "s are those of: " + others;
    error(text + ". It has: " + (there.empty() ? "none" + who : there));
  }
  /// Reports that something the lesson needs is missing. Several may be reported; bind then fails.
  void error(const std::string& message) {
    raw_->error(raw_, message.c_str());
    failed_ = true;
  }
  bool failed() const { return failed_; }

 private:
  Mark add(const swage_mark& mark) {
    const Mark index(raw_->mark(raw_, &mark));
    failed_ = failed_ || !index.valid();
    return index;
  }

  swage_lesson_binder* raw_;
  bool failed_ = false;
};

/// The scene in observe(); all const. [rt]
class View {
 public:
  explicit View(const swage_view* raw) : raw_(raw) {}
  const swage_view* operator->() const { return raw_; }

  double time() const { return raw_->time_s; }  // s
  double dt() const { return raw_->dt_s; }      // s
  double signal(Signal signal) const {
    assert(signal < raw_->n_signal);
    return raw_->signal[signal];
  }
  std::span<const swage_view_event> events() const { return {raw_->event, raw_->n_event}; }
  /// Whether an event happened in this step.
  bool happened(Event wanted) const {
    for (const swage_view_event& event : events())
      if (event.event == wanted) return true;
    return false;
  }
  /// X_WB of a body; global index: first_body of the object in the scene card, plus the object's own index.
  const swage_pose& pose(uint32_t body) const {
    assert(body < raw_->n_body);
    return raw_->X_WB[body];
  }
  const swage_twist& twist(uint32_t body) const {
    assert(body < raw_->n_body);
    return raw_->V_WB[body];
  }
  /// For calls to the traits of a Peer.
  Step object(uint32_t index) const {
    assert(index < raw_->n_object);
    return Step(&raw_->object_step[index]);
  }

 private:
  const swage_view* raw_;
};

/// Outputs of observe(). [rt]
class Verdict {
 public:
  explicit Verdict(const swage_verdict* raw) : raw_(raw) {}

  /// Sets the cue of an object from now on.
  void cue(uint32_t object, Cue cue) const { raw_->cue(raw_, object, cue); }
  void clear_cue(uint32_t object) const { raw_->cue(raw_, object, kNone); }
  /// Sets the cue of a mark from now on; p_W moves the mark.
  void mark(Mark mark, Cue cue, const swage_vec3* p_W = nullptr) const { raw_->mark(raw_, mark, cue, p_W); }
  void clear_mark(Mark mark) const { raw_->mark(raw_, mark, kNone, nullptr); }
  void metric(Metric metric, double value) const { raw_->metric(raw_, metric, value); }
  void event(Event event, double value = 0) const { raw_->event(raw_, event, value); }
  void phase(Phase phase) const { raw_->phase(raw_, phase); }
  /// Ends the attempt; score 0..100.
  void pass(double score) const { raw_->finish(raw_, 1, score, kNone); }
  void fail(Event reason, double score = 0) const { raw_->finish(raw_, 0, score, reason); }

 private:
  const swage_verdict* raw_;
};

namespace detail {
template <class T>
struct LessonTables;
}

/// Base of every lesson plugin.
template <class P = NoParams>
class Lesson : public WithParams<P> {
 public:
  using Kind = Lesson;
  using Builder = LessonBuilder;
  template <class T>
  using Tables = detail::LessonTables<T>;
  static constexpr int32_t kKind = SWAGE_KIND_LESSON;

  /// Declares metrics, cues, events, phases and private numbers. [main]
  virtual void build(const P& params, LessonBuilder& builder) = 0;
  /// Finds the objects, signals and events that it watches in the scene. [main]
  virtual void bind(const Scene& scene, Binder& binder) {
    static_cast<void>(scene);
    static_cast<void>(binder);
  }
  /// Observes one step; `state` holds the private numbers. [rt]
  virtual void observe(const View& view, const Verdict& verdict, std::span<double> state) SWAGE_RT = 0;
  /// Sets the private numbers to their start (the host has set them to zero). [rt]
  virtual void reset(std::span<double> state) SWAGE_RT { static_cast<void>(state); }

 protected:
  /// Whether the attempt is practice: limits of force and time are then reported and do not end it. Known from activate on. [any]
  bool is_practice() const {
    const auto* attempt = this->template host_extension<swage_host_attempt>(SWAGE_HOST_ATTEMPT);
    return attempt != nullptr && attempt->mode(&this->host()) == SWAGE_ATTEMPT_PRACTICE;
  }
  /// The private numbers by name, as declared with builder.state<T>().
  template <class T>
  static T& as(std::span<double> state) {
    assert(sizeof(T) <= state.size_bytes());
    return *static_cast<T*>(static_cast<void*>(state.data()));
  }
};

namespace detail {

inline constexpr Entry kBindLesson{"bind", 19, kMain, When::kReady};
inline constexpr Entry kObserve{"observe", 20, kRt, When::kActive};
inline constexpr Entry kResetLesson{"reset", 21, kRt, When::kActive};

/// The table that lesson T offers.
template <class T>
struct LessonTables {
  static constexpr const char* no_traits[] = {nullptr};
  static constexpr const char* const* traits = no_traits;

  static swage_result bind(swage_instance* i, const swage_scene_card* card,
                           swage_lesson_binder* raw) noexcept {
    bool failed = false;
    const swage_result result = guarded<T>(i, kBindLesson, [&](typename T::Kind& plugin, auto&) {
      Binder binder(raw);
      plugin.bind(Scene(card), binder);
      failed = binder.failed();
    });
    return result == SWAGE_OK && failed ? SWAGE_ERROR : result;
  }
  static swage_result observe(swage_instance* i, const swage_view* v, const swage_verdict* verdict,
                              double* state) noexcept {
    return guarded<T>(i, kObserve, [&](typename T::Kind& plugin, Holder<T>& holder) {
      plugin.observe(View(v), Verdict(verdict), {state, holder.n_state});
    });
  }
  static void reset(swage_instance* i, double* state) noexcept {
    guarded<T>(i, kResetLesson, [&](typename T::Kind& plugin, Holder<T>& holder) {
      plugin.reset({state, holder.n_state});
    });
  }

  static const void* find(const char* id) {
    static constexpr swage_lesson table{bind, observe, reset, 0};
    return same(id, SWAGE_EXT_LESSON) ? &table : nullptr;
  }
};

}  // namespace detail

}  // namespace swage
