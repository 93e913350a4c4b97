// SPDX-License-Identifier: Apache-2.0
//
// Evil objects, couplings and lessons: org.example.bad.object.<fault>, .coupling.<fault>, .lesson.<fault>. Each behaves for
// kGood steps before it does in the step what its name says.
#include <swage/abi/builder.h>
#include <swage/abi/coupling.h>
#include <swage/abi/lesson.h>
#include <swage/abi/object.h>

#include <cmath>
#include <limits>
#include <new>

#include "evil.hpp"
#include "evil_object_faults.hpp"

namespace {

constexpr uint64_t kGood = 10;  // steps
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr swage_pose kHere{{0, 0, 0}, {1, 0, 0, 0}};

const std::vector<evil::Fault> kCouplingFaults = {
    {"good", "Does nothing wrong."},
    {"signal_nan", "Writes a signal that is no number."},
    {"state_nan", "Keeps a number that is none."},
    {"event_unknown", "Tells of events that it has not declared."},
    {"moves_object", "Moves an object that it only looks at."},
    {"bind_refuses", "Refuses the two objects and does not say why."},
    {"no_table", "Has no table of a coupling."},
    {"table_gaps", "Has a table of a coupling without finish."},
    {"needs_endless", "Needs traits that are no names."},
    {"tie_nan", "Has a tie at a place that is no number."},
    {"tie_force_nan", "Has a tie whose force of the step before is no number."},
    {"tie_unknown_body", "Has a tie to a body that is not there."},
    {"ties_many", "Says that it has four billion ties."},
    {"body_declared", "Declares a body."},
};
const std::vector<evil::Fault> kLessonFaults = {
    {"good", "Does nothing wrong."},
    {"metric_nan", "Reports a metric that is no number."},
    {"metric_unknown", "Reports a metric that it has not declared."},
    {"cue_unknown", "Raises a cue that it has not declared."},
    {"cue_of_nobody", "Raises a cue on an object that is not there."},
    {"event_unknown", "Tells of an event that it has not declared."},
    {"phase_unknown", "Enters a phase that it has not declared."},
    {"mark_unknown", "Moves a mark that it has not declared."},
    {"score_high", "Gives 1000 points of 100."},
    {"score_nan", "Gives a score that is no number."},
    {"fails_silently", "Fails an attempt without a reason."},
    {"state_nan", "Keeps a number that is none."},
    {"moves_object", "Moves an object."},
    {"bind_refuses", "Refuses the scene and does not say why."},
    {"marks_many", "Declares a thousand marks."},
    {"metrics_many", "Declares a thousand metrics."},
    {"no_table", "Has no table of a lesson."},
    {"body_declared", "Declares a body."},
};

const char* const kSolid[] = {SWAGE_TRAIT_SOLID, nullptr};
const char* const kNone[] = {nullptr};
const evil::Catalogue& objects() {
  static const evil::Catalogue all(
      SWAGE_KIND_OBJECT, "org.example.bad.object.", kObjectFaults,
      {"create", "configure", "activate", "extension", "reset", "forces", "finish", "deactivate", "destroy"}, kSolid);
  return all;
}
const evil::Catalogue& couplings() {
  static const evil::Catalogue all(SWAGE_KIND_COUPLING, "org.example.bad.coupling.", kCouplingFaults,
                                   {"bind", "resolve", "finish"}, kNone);
  return all;
}
const evil::Catalogue& lessons() {
  static const evil::Catalogue all(SWAGE_KIND_LESSON, "org.example.bad.lesson.", kLessonFaults, {"bind", "observe"}, kNone);
  return all;
}

struct Thing {
  swage_instance raw{};
  swage_object object{};
  swage_coupling coupling{};
  swage_lesson lesson{};
  const swage_host* host = nullptr;
  int32_t kind = 0;
  std::string fault;
};

Thing& of(swage_instance* raw) { return *static_cast<Thing*>(raw->self); }
bool is(swage_instance* raw, const char* fault) { return of(raw).fault == fault; }
swage_str text(const std::string& s) { return {s.data(), s.size()}; }

// --- what an object declares

void build_usual(swage_builder* b, const std::string& f) {
  const std::string endless(f == "doc_endless" ? std::size_t{64} << 20 : 0, 'x');
  const swage_mass mass{1e-3, {1e-9, 1e-9, 1e-9}};
  const uint32_t body = b->body(b, SWAGE_MOTION_DYNAMIC, &kHere, &mass, "ball");
  b->sphere(b, body, {0, 0, 0}, 1e-3, SWAGE_SHAPE_USUAL);
  b->state(b, 1);
  b->declare(b, SWAGE_DECLARE_SIGNAL, "height", "m", endless.empty() ? "Of the ball." : endless.c_str());
}

void build_many(swage_builder* b, const std::string& f) {
  const auto again = [&](int n, auto&& one) {
    for (int i = 0; i < n; ++i) one(i);
  };
  if (f == "bodies_many") again(1000, [&](int) { b->body(b, SWAGE_MOTION_FIXED, &kHere, nullptr, "more"); });
  if (f == "shapes_many") again(1'000'000, [&](int) { b->sphere(b, 0, {0, 0, 0}, 1e-3, SWAGE_SHAPE_USUAL); });
  if (f == "state_much") again(1024, [&](int) { b->state(b, 1u << 20); });
  if (f == "signals_many")
    again(1000, [&](int i) { b->declare(b, SWAGE_DECLARE_SIGNAL, ("s" + std::to_string(i)).c_str(), "m", "One of many."); });
  if (f == "particles_many") {
    const std::vector<double> p(3'000'000, 0.0), m(1'000'000, 1e-6);
    b->particles(b, 1'000'000, p.data(), m.data(), 1e-4);
  }
}

void build_wrong(swage_builder* b, const std::string& f) {
  swage_pose pose = kHere;
  swage_mass mass{1e-3, {1e-9, 1e-9, 1e-9}};
  if (f == "pose_nan") pose.p.z = kNan;
  if (f == "mass_zero") mass.mass = 0;
  if (f == "mass_nan") mass.mass = kNan;
  if (f == "inertia_impossible") mass.inertia.x = 1;
  if (f == "pose_nan" || f.rfind("mass_", 0) == 0 || f == "inertia_impossible")
    b->body(b, SWAGE_MOTION_DYNAMIC, &pose, &mass, "wrong");
  if (f == "motion_unknown") b->body(b, 99, &kHere, nullptr, "wrong");
  if (f == "self_alone") b->body(b, SWAGE_MOTION_FLEXIBLE, &kHere, nullptr, "alone");
  if (f == "hinge_missing") b->body(b, SWAGE_MOTION_HINGED, &kHere, nullptr, "loose");
  if (f == "hinge_of_itself") {
    const uint32_t h = b->body(b, SWAGE_MOTION_HINGED, &kHere, nullptr, "own");
    const swage_hinge hinge{h, h, {0, 0, 0}, {1, 0, 0}, 1e-9, -1, 1};
    b->hinge(b, &hinge);
  }
  if (f == "radius_negative") b->sphere(b, 0, {0, 0, 0}, -1e-3, SWAGE_SHAPE_USUAL);
  if (f == "radius_infinite") b->sphere(b, 0, {0, 0, 0}, HUGE_VAL, SWAGE_SHAPE_USUAL);
  if (f == "centre_far") b->sphere(b, 0, {1e300, 0, 0}, 1e-3, SWAGE_SHAPE_USUAL);
  if (f == "shape_of_nobody") b->sphere(b, 77, {0, 0, 0}, 1e-3, SWAGE_SHAPE_USUAL);
  if (f == "flags_unknown") b->sphere(b, 0, {0, 0, 0}, 1e-3, 0xFF00);
  const double corner[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const uint32_t start[] = {0, 3}, face[] = {0, 1, 4'000'000'000u};
  swage_convex convex{4, 1, corner, start, face};
  if (f == "convex_wild") b->convex(b, 0, &convex, SWAGE_SHAPE_USUAL);
  convex.n_vertex = 4'000'000'000u;
  if (f == "convex_huge") b->convex(b, 0, &convex, SWAGE_SHAPE_USUAL);
}

void build_names(swage_builder* b, const std::string& f) {
  if (f == "metric_declared") b->declare(b, SWAGE_DECLARE_METRIC, "points", "1", "Not its own.");
  if (f == "declares_unknown") b->declare(b, 99, "thing", "1", "Of no kind.");
  if (f == "signal_unnamed") b->declare(b, SWAGE_DECLARE_SIGNAL, nullptr, nullptr, nullptr);
  if (f == "signal_twice") b->declare(b, SWAGE_DECLARE_SIGNAL, "height", "m", "Again.");
}

swage_result configure(swage_instance* raw, const swage_values*, swage_builder* b) {
  Thing& t = of(raw);
  evil::misbehave_in("configure", t.fault);
  if (t.fault == "configure_refuses") return SWAGE_ERROR;
  if (t.fault == "talks_endlessly")
    for (int i = 0; i < 1'000'000; ++i) t.host->report(t.host, SWAGE_WARNING, {nullptr, 0}, text("Once more."));
  if (t.fault == "body_declared") b->body(b, SWAGE_MOTION_FIXED, &kHere, nullptr, "mine");
  if (t.kind == SWAGE_KIND_OBJECT) {
    build_usual(b, t.fault);
    build_many(b, t.fault);
    build_wrong(b, t.fault);
    build_names(b, t.fault);
    return SWAGE_OK;
  }
  b->state(b, 1);
  if (t.kind == SWAGE_KIND_COUPLING) b->declare(b, SWAGE_DECLARE_SIGNAL, "gap", "m", "Between the two.");
  if (t.kind == SWAGE_KIND_LESSON) b->declare(b, SWAGE_DECLARE_METRIC, "points", "1", "Of the attempt.");
  if (t.kind == SWAGE_KIND_LESSON) b->declare(b, SWAGE_DECLARE_EVENT, "lost", "1", "It was lost.");
  for (int i = 0; i < 1000 && t.fault == "metrics_many"; ++i)
    b->declare(b, SWAGE_DECLARE_METRIC, ("m" + std::to_string(i)).c_str(), "1", "One of many.");
  return SWAGE_OK;
}

// --- an object in the step

void burn_ms(double ms) {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  const double end = 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec) + ms;
  do clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  while (1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec) < end);
}

swage_result object_forces(swage_instance* raw, const swage_object_step* s) {
  const std::string& f = of(raw).fault;
  if (s->step < kGood) return SWAGE_OK;
  evil::misbehave_in("forces", f);
  if (f == "force_nan") s->F_B_W[0].f.x = kNan;
  if (f == "force_infinite") s->F_B_W[0].f.y = -HUGE_VAL;
  if (f == "force_huge") s->F_B_W[0].f.z = 1e9;
  if (f == "torque_nan") s->F_B_W[0].t.z = kNan;
  // the neighbour's body lies behind or before its own
  if (f == "neighbour_pose") const_cast<swage_pose*>(s->X_WB)[-1].p.x += 1e-3;
  if (f == "neighbour_twist") const_cast<swage_twist*>(s->V_WB)[-1].v.x = 1;
  if (f == "sleeps") evil::sleep_ms(2);
  if (f == "sleeps_long") evil::sleep_ms(300);
  if (f == "burns") burn_ms(2);
  return f == "forces_refuses" ? SWAGE_ERROR : SWAGE_OK;
}

swage_result object_finish(swage_instance* raw, const swage_object_step* s) {
  const std::string& f = of(raw).fault;
  s->signal[0] = s->X_WB[0].p.z;
  if (s->step < kGood) return SWAGE_OK;
  evil::misbehave_in("finish", f);
  if (f == "signal_nan") s->signal[0] = kNan;
  if (f == "state_nan") s->state[0] = kNan;
  if (f == "state_infinite") s->state[0] = HUGE_VAL;
  if (f == "neighbour_late") const_cast<swage_pose*>(s->X_WB)[-1].p.x += 1e-3;
  return f == "finish_refuses" ? SWAGE_ERROR : SWAGE_OK;
}

// --- a coupling

swage_result coupling_bind(swage_instance* raw, swage_instance*, swage_instance*) {
  evil::misbehave_in("bind", of(raw).fault);
  return is(raw, "bind_refuses") ? SWAGE_ERROR : SWAGE_OK;
}

swage_result coupling_resolve(swage_instance* raw, const swage_coupling_step* s) {
  if (s->step < kGood) return SWAGE_OK;
  evil::misbehave_in("resolve", of(raw).fault);
  if (is(raw, "moves_object")) const_cast<swage_pose*>(s->a->X_WB)[0].p.x += 1e-3;
  if (is(raw, "event_unknown")) s->event(s, 99, 1);
  return SWAGE_OK;
}

swage_result coupling_finish(swage_instance* raw, const swage_coupling_step* s) {
  s->signal[0] = 0;
  if (s->step < kGood) return SWAGE_OK;
  evil::misbehave_in("finish", of(raw).fault);
  if (is(raw, "signal_nan")) s->signal[0] = kNan;
  if (is(raw, "state_nan")) s->state[0] = kNan;
  return SWAGE_OK;
}

swage_result coupling_ties(swage_instance* raw, const swage_coupling_step* s, uint32_t capacity, swage_tie* out, uint32_t* n) {
  *n = 0;
  if (s->step < kGood || capacity == 0) return SWAGE_OK;
  if (is(raw, "ties_many")) *n = 4'000'000'000u;
  if (!is(raw, "tie_nan") && !is(raw, "tie_force_nan") && !is(raw, "tie_unknown_body")) return SWAGE_OK;
  out[0] = {};
  out[0].axis_W = {0, 0, 1};
  out[0].stiffness_across = out[0].stiffness_along = 1;
  out[0].strength = out[0].forward_limit = out[0].backward_limit = 1;
  if (is(raw, "tie_nan")) out[0].p_W.x = kNan;
  if (is(raw, "tie_force_nan")) out[0].f_a_W.x = kNan;
  if (is(raw, "tie_unknown_body")) out[0].body_a = 4711;
  *n = 1;
  return SWAGE_OK;
}
swage_result coupling_tied(swage_instance*, const swage_coupling_step*, uint32_t, const swage_tie*) { return SWAGE_OK; }

// --- a lesson

swage_result lesson_bind(swage_instance* raw, const swage_scene_card*, swage_lesson_binder* b) {
  evil::misbehave_in("bind", of(raw).fault);
  swage_mark mark{};
  mark.kind = SWAGE_MARK_POINT;
  mark.meaning = text("target.point");
  mark.number[0] = 1e-3;
  for (int i = 0; i < 1000 && is(raw, "marks_many"); ++i) b->mark(b, &mark);
  return is(raw, "bind_refuses") ? SWAGE_ERROR : SWAGE_OK;
}

swage_result lesson_observe(swage_instance* raw, const swage_view* view, const swage_verdict* v, double* state) {
  const std::string& f = of(raw).fault;
  if (view->step < kGood) return SWAGE_OK;
  evil::misbehave_in("observe", f);
  if (f == "metric_nan") v->metric(v, 0, kNan);
  if (f == "metric_unknown") v->metric(v, 99, 1);
  if (f == "cue_unknown") v->cue(v, 0, 99);
  if (f == "cue_of_nobody") v->cue(v, 99, SWAGE_NONE);
  if (f == "event_unknown") v->event(v, 99, 1);
  if (f == "phase_unknown") v->phase(v, 99);
  if (f == "mark_unknown") v->mark(v, 99, SWAGE_NONE, nullptr);
  if (f == "score_high") v->finish(v, 1, 1000, SWAGE_NONE);
  if (f == "score_nan") v->finish(v, 1, kNan, SWAGE_NONE);
  if (f == "fails_silently") v->finish(v, 0, 0, SWAGE_NONE);
  if (f == "state_nan") state[0] = kNan;
  if (f == "moves_object") const_cast<swage_pose*>(view->X_WB)[0].p.x += 1e-3;
  return SWAGE_OK;
}

// --- instances

const void* get_extension(swage_instance* raw, const char* id) {
  static const swage_ties ties{coupling_ties, coupling_tied};
  static const int promise = 1;
  Thing& t = of(raw);
  evil::misbehave_in("extension", t.fault);
  const bool own = t.fault != "no_table";
  if (own && t.kind == SWAGE_KIND_OBJECT && std::strcmp(id, SWAGE_EXT_OBJECT) == 0) return &t.object;
  if (own && t.kind == SWAGE_KIND_COUPLING && std::strcmp(id, SWAGE_EXT_COUPLING) == 0) return &t.coupling;
  if (own && t.kind == SWAGE_KIND_LESSON && std::strcmp(id, SWAGE_EXT_LESSON) == 0) return &t.lesson;
  if (t.fault.rfind("tie", 0) == 0 && std::strcmp(id, SWAGE_EXT_TIES) == 0) return &ties;
  const bool solid = t.kind == SWAGE_KIND_OBJECT && t.fault != "no_trait";
  return solid && std::strcmp(id, SWAGE_TRAIT_SOLID) == 0 ? &promise : nullptr;
}

swage_instance* create(const swage_host* host, const char* id) {
  int32_t kind = SWAGE_KIND_OBJECT;
  std::string fault = objects().fault(id);
  if (fault.empty()) fault = couplings().fault(id), kind = SWAGE_KIND_COUPLING;
  if (fault.empty()) fault = lessons().fault(id), kind = SWAGE_KIND_LESSON;
  if (fault.empty()) return nullptr;
  evil::misbehave_in("create", fault);
  auto* t = fault == "create_null" ? nullptr : new (std::nothrow) Thing;
  if (t == nullptr) return nullptr;
  t->fault = fault;
  t->host = host;
  t->kind = kind;
  t->raw.self = t;
  if (fault == "create_bare") return &t->raw;
  t->raw.configure = configure;
  t->raw.activate = [](swage_instance* raw, double) -> swage_result {
    evil::misbehave_in("activate", of(raw).fault);
    return is(raw, "activate_refuses") ? SWAGE_ERROR : SWAGE_OK;
  };
  t->raw.deactivate = [](swage_instance* raw) { evil::misbehave_in("deactivate", of(raw).fault); };
  t->raw.destroy = [](swage_instance* raw) {
    const std::string name = of(raw).fault;
    delete &of(raw);
    evil::misbehave_in("destroy", name);
  };
  t->raw.get_extension = get_extension;
  const bool gaps = fault == "table_gaps";
  t->object = {object_forces, gaps ? nullptr : object_finish,
               [](swage_instance* raw, const swage_object_step*) { evil::misbehave_in("reset", of(raw).fault); }};
  static const char* const kWild[] = {"\x01\xff", "", nullptr};
  const char* const* needs = fault == "needs_endless" ? kWild : kNone;
  t->coupling = {needs,
                 needs,
                 1,
                 0,
                 coupling_bind,
                 coupling_resolve,
                 gaps ? nullptr : coupling_finish,
                 [](swage_instance*, const swage_coupling_step*) {}};
  t->lesson = {lesson_bind, lesson_observe, [](swage_instance*, double*) {}, 0};
  return &t->raw;
}

const void* get_factory(const char* id) {
  static const swage_factory factory = {
      [] { return objects().count() + couplings().count() + lessons().count(); },
      [](uint32_t i) {
        const uint32_t n = objects().count(), m = couplings().count();
        return i < n ? objects().at(i) : i < n + m ? couplings().at(i - n) : lessons().at(i - n - m);
      },
      create};
  return std::strcmp(id, SWAGE_FACTORY_INSTANCES) == 0 ? &factory : nullptr;
}

}  // namespace

extern "C" {
__attribute__((visibility("default"))) extern const swage_entry swage_plugin_entry;
}
const swage_entry swage_plugin_entry = {sizeof(swage_entry), SWAGE_ABI_MAJOR, SWAGE_ABI_MINOR, 0,
                                        "plain C++",         nullptr,         nullptr,         get_factory};
