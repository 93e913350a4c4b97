// SPDX-License-Identifier: Apache-2.0
#include "tools/fuzz_harness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "host/guard.hpp"
#include "host/malloc_guard.hpp"
#include "host/services.hpp"
#include "scene/view.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/visual_test.hpp"

namespace swage::tools {

namespace {

// numbers of contacts in a step; a grasp has about ten, a needle in a tray about three
constexpr uint32_t kContacts[] = {0, 1, 3, 17, 64};
// ties that there is room for
constexpr uint32_t kRoom = 64;

swage_quat turn(base::Xoshiro256& random) {
  double q[4], sum = 0;
  for (double& x : q) {
    x = random.uniform(-1, 1);
    sum += x * x;
  }
  const double k = 1 / std::sqrt(std::max(sum, 1e-12));
  return {k * q[0], k * q[1], k * q[2], k * q[3]};
}

// --- a lesson: observes everything, and may use only declared outputs

class Lesson final : public FuzzHarness {
 public:
  Lesson(std::unique_ptr<Stepped> scene, uint64_t seed)
      : FuzzHarness(std::move(scene), instance_of(*scene), seed), slot_(rig().lesson) {
    verdict_.struct_size = sizeof verdict_;
    verdict_.host_data = this;
    verdict_.cue = [](const swage_verdict* v, uint32_t object, uint32_t cue) {
      self(v).say("cue", cue, self(v).slot_.cue.count, object, true);
      self(v).say("object", object, static_cast<uint32_t>(self(v).rig().objects.size()), 0, false);
    };
    verdict_.mark = [](const swage_verdict* v, uint32_t mark, uint32_t cue, const swage_vec3* p) {
      self(v).say("mark", mark, static_cast<uint32_t>(self(v).rig().script.marks.size()), 0, false);
      self(v).say("cue", cue, self(v).slot_.cue.count, p != nullptr ? p->x + p->y + p->z : 0, true);
    };
    verdict_.metric = [](const swage_verdict* v, uint32_t metric, double value) {
      self(v).say("metric", metric, self(v).slot_.metric.count, value, false);
    };
    verdict_.event = [](const swage_verdict* v, uint32_t event, double value) {
      self(v).say("event", event, self(v).slot_.event.count, value, false);
    };
    verdict_.phase = [](const swage_verdict* v, uint32_t phase) {
      self(v).say("phase", phase, self(v).slot_.phase.count, 0, false);
    };
    verdict_.finish = [](const swage_verdict* v, int32_t passed, double score, uint32_t reason) {
      self(v).say("reason", reason, self(v).slot_.event.count, score, true);
      if (!(score >= 0 && score <= 100)) self(v).report_fault(say::kScore(format("%g", score)));
      if (passed == 0 && reason == SWAGE_NONE) self(v).report_fault(say::kFailedSilently());
    };
  }

 protected:
  void on_reset() override {
    call(host::Call::kReset, [&] { slot_.lesson->reset(slot_.instance->raw, state()); });
  }

  void on_step(base::Xoshiro256& random, bool) override {
    std::vector<swage_view_event> events;
    const auto known = static_cast<uint32_t>(rig().script.events.size());
    for (uint64_t n = known > 0 ? random() % 4 : 0; n > 0; --n)
      events.push_back({static_cast<uint32_t>(random() % known), 0, wild(random)});
    const swage_view view = scene::view(world_, view_, events);
    call(host::Call::kObserve, [&] { return slot_.lesson->observe(slot_.instance->raw, &view, &verdict_, state()); });
    said_.add(state(), slot_.state.count * sizeof(double));
  }

 private:
  static host::Instance& instance_of(const Stepped& scene) { return *scene.rig->lesson.instance; }
  static Lesson& self(const swage_verdict* v) { return *static_cast<Lesson*>(v->host_data); }
  double* state() { return world_.plugin_state.data() + slot_.state.first; }
  void say(const char* what, uint32_t index, uint32_t count, double value, bool may_be_none) {
    said_.add(uint64_t{index}).add(value);
    if (index >= count && !(may_be_none && index == SWAGE_NONE))
      report_fault(say::kUndeclared(what, index, count));
    if (!std::isfinite(value)) report_fault(say::kSaidNotFinite(what, index));
  }

  host::LessonSlot& slot_;
  swage_verdict verdict_{};
};

// --- a coupling: observes two objects and their contacts, changes contact laws, reports events

class Coupling final : public FuzzHarness {
 public:
  Coupling(std::unique_ptr<Stepped> scene, uint64_t seed)
      : FuzzHarness(std::move(scene), instance_of(*scene), seed), slot_(rig().couplings.back()) {
    contact_.reserve(kContacts[std::size(kContacts) - 1]);
    step_.struct_size = sizeof step_;
    step_.dt_s = world_.dt;
    step_.n_state = slot_.state.count;
    step_.n_signal = slot_.signal.count;
    step_.host_data = this;
    step_.event = [](const swage_coupling_step* s, uint32_t event, double value) {
      auto& self = *static_cast<Coupling*>(s->host_data);
      self.said_.add(uint64_t{event}).add(value);
      if (event >= self.slot_.event.count)
        self.report_fault(say::kUndeclared("event", event, self.slot_.event.count));
    };
  }

 protected:
  void on_reset() override {
    contact_.clear();
    place();
    call(host::Call::kReset, [&] { slot_.coupling->reset(slot_.instance->raw, &step_); });
  }

  void on_step(base::Xoshiro256& random, bool poisoned) override {
    contact_.resize(kContacts[random() % std::size(kContacts)]);
    for (swage_contact& c : contact_) c = touch(random, poisoned);
    place();
    const bool resolved = call(host::Call::kResolve, [&] { return slot_.coupling->resolve(slot_.instance->raw, &step_); });
    for (const swage_contact& c : contact_) {
      said_.add(c.friction).add(c.stiffness).add(c.restitution);
      if (!poisoned && resolved && !sensible(c))
        report_fault(say::kContact(format("%g", c.friction), format("%g", c.stiffness), format("%g", c.restitution)));
    }
    for (swage_contact& c : contact_) push(c, random, poisoned);
    ties(random, poisoned);
    call(host::Call::kFinish, [&] { return slot_.coupling->finish(slot_.instance->raw, &step_); });
    for (uint32_t i = 0; i < step_.n_signal; ++i) {
      said_.add(step_.signal[i]);
      if (!poisoned && !std::isfinite(step_.signal[i])) report_fault(say::kSignalNotFinite());
    }
    draw(poisoned);
    said_.add(step_.state, step_.n_state * sizeof(double));
  }

 private:
  static host::Instance& instance_of(const Stepped& scene) { return *scene.rig->couplings.back().instance; }

  // calls for its ties, which get random forces
  void ties(base::Xoshiro256& random, bool poisoned) {
    if (slot_.ties == nullptr) return;
    std::vector<swage_tie> tie(kRoom + 1);
    uint32_t n = 0;
    const bool given =
        call(host::Call::kTies, [&] { return slot_.ties->ties(slot_.instance->raw, &step_, kRoom, tie.data(), &n); });
    if (n > kRoom) report_fault(say::kTooMany(n, "ties", kRoom));
    n = given ? std::min(n, kRoom) : 0;
    for (uint32_t i = 0; i < n && !poisoned; ++i) check(tie[i]);
    for (uint32_t i = 0; i < n; ++i) {
      said_.add(&tie[i].p_W, sizeof tie[i].p_W);
      tie[i].f_a_W = {wild(random), wild(random), wild(random)};
      tie[i].plastic_slip_W = {1e-3 * wild(random), 1e-3 * wild(random), 1e-3 * wild(random)};
    }
    call(host::Call::kOnSolved, [&] { return slot_.ties->on_solved(slot_.instance->raw, &step_, n, tie.data()); });
  }

  void check(const swage_tie& t) {
    const auto& v = t.axis_W;
    const bool unit = std::abs(v.x * v.x + v.y * v.y + v.z * v.z - 1) < 1e-6;
    const auto body = [&](uint32_t index, uint32_t object) {
      return index == SWAGE_NONE || index < rig().objects[object].body.count;
    };
    if (!host::finite(&t.p_W.x, 3) || !unit || !host::finite(&t.offset_W.x, 3))
      report_fault(say::kTiePlace());
    if (!host::finite(&t.f_a_W.x, 3)) report_fault(say::kTieForce());
    if (!body(t.body_a, slot_.object_a) || !body(t.body_b, slot_.object_b)) report_fault(say::kTieBody());
    for (const double x : {t.stiffness_across, t.stiffness_along, t.strength, t.forward_limit, t.backward_limit})
      if (!(x >= 0)) report_fault(say::kTieStiffness(format("%g", x)));
  }

  // what it draws on object b
  void draw(bool poisoned) {
    if (poisoned || slot_.visuals == nullptr) return;
    const auto ask = [&](uint32_t capacity, swage_visual* out, uint32_t* n) {
      return call(host::Call::kDraw, [&] { return slot_.visuals->draw(slot_.instance->raw, nullptr, &step_, capacity, out, n); });
    };
    if (const std::string wrong = visuals(ask, rig().objects[slot_.object_b].body.count, world_); !wrong.empty()) report_fault(wrong);
  }
  static bool sensible(const swage_contact& c) {
    return std::isfinite(c.friction) && c.friction >= 0 && std::isfinite(c.stiffness) && c.stiffness >= 0 &&
           c.restitution >= 0 && c.restitution <= 1;
  }
  static double poison(base::Xoshiro256& random) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    const uint64_t n = random() % 3;
    return n == 0 ? std::nan("") : n == 1 ? kInfinite : -kInfinite;
  }

  void place() {
    step_.step = world_.step;
    step_.time_s = world_.time();
    step_.a = &view_[slot_.object_a];
    step_.b = &view_[slot_.object_b];
    step_.contact = contact_.data();
    step_.n_contact = static_cast<uint32_t>(contact_.size());
    step_.state = world_.plugin_state.data() + slot_.state.first;
    step_.signal = world_.signal.data() + slot_.signal.first;
  }

  swage_contact touch(base::Xoshiro256& random, bool poisoned) const {
    const host::ObjectSlot &a = rig().objects[slot_.object_a], &b = rig().objects[slot_.object_b];
    const auto one_of = [&random](uint32_t count) { return count > 0 ? static_cast<uint32_t>(random() % count) : SWAGE_NONE; };
    swage_contact c{};
    c.body_a = one_of(a.body.count);
    c.shape_a = one_of(a.shape.count);
    c.body_b = one_of(b.body.count);
    c.shape_b = one_of(b.shape.count);
    c.feature = random();
    c.p_W = {wild(random), wild(random), wild(random)};
    const swage_quat q = turn(random);
    const double k = 1 / std::sqrt(std::max(q.x * q.x + q.y * q.y + q.z * q.z, 1e-12));
    c.n_W = {k * q.x, k * q.y, k * q.z};
    c.gap = poisoned ? poison(random) : 1e-4 * random.uniform(-1, 0.1);
    c.friction = random.uniform();
    c.stiffness = 1e3;
    push(c, random, poisoned);
    return c;
  }

  // gives a contact a force from 0 to a hundred times that which breaks a needle
  static void push(swage_contact& c, base::Xoshiro256& random, bool poisoned) {
    constexpr double kForce[] = {0, 1e-12, 1e-3, 1, 1e3};  // N
    const double f = poisoned ? poison(random) : kForce[random() % std::size(kForce)];
    c.f_a_W = {f * c.n_W.x, f * c.n_W.y, f * c.n_W.z};
    c.slip = poisoned ? poison(random) : random.uniform();
  }

  host::CouplingSlot& slot_;
  std::vector<swage_contact> contact_;
  swage_coupling_step step_{};
};

}  // namespace

FuzzHarness::FuzzHarness(std::unique_ptr<Stepped>&& scene, host::Instance& instance, uint64_t seed)
    : world_(scene->rig->world),
      scene_(std::move(scene)),
      instance_(instance),
      seed_(seed),
      start_{world_, scene_->rig->world.random} {}

template <class F>
bool FuzzHarness::call(host::Call which, F&& f) {
  const host::ScopedRole rt(SWAGE_THREAD_RT);
  const uint64_t before = host::thread_allocations();
  const bool kept = host::guarded(instance_, which, world_.step, f);
  allocations_ += host::thread_allocations() - before;
  if (fault_.empty() && instance_.quarantined.load() != 0) fault_ = host::quarantine_text(instance_);
  if (const uint32_t n = instance_.services->role_breaches(); n > 0)
    report_fault(say::kMainThread(n));
  return kept;
}

void FuzzHarness::report_fault(const std::string& what) {
  if (fault_.empty())
    fault_ = say::kInStep(instance_.plugin_id, what, world_.step);
}

double FuzzHarness::wild(base::Xoshiro256& random) {
  switch (random() % 8) {
    case 0:
      return 0;
    case 1:
      return 1;
    case 2:
      return random.uniform(-1e3, 1e3);
    case 3:
      return std::numeric_limits<double>::denorm_min();
    default:
      return 1e-2 * random.uniform(-1, 1);
  }
}

void FuzzHarness::reset() {
  restore(start_);
  std::fill(world_.plugin_state.begin(), world_.plugin_state.end(), 0.0);
  std::fill(world_.signal.begin(), world_.signal.end(), 0.0);
  base::Xoshiro256 random(seed_);
  show(random);
  on_reset();
}

void FuzzHarness::restore(const Image& image) {
  world_ = image.world;
  rig().world.random = image.random;
}

void FuzzHarness::step(uint64_t number, bool poisoned) {
  base::Xoshiro256 random(seed_ * 1'000'003 + number);
  world_.step = number;
  show(random);
  said_ = base::Hash();
  on_step(random, poisoned);
  for (const uint64_t word : rig().world.random) said_.add(word);
  hash_ = said_.value();
}

// fills the world with unrelated random values; the private state of the objects is kept
void FuzzHarness::show(base::Xoshiro256& random) {
  for (std::size_t i = 0; i < world_.X_WB.size(); ++i) {
    world_.X_WB[i] = {{wild(random), wild(random), wild(random)}, turn(random)};
    world_.V_WB[i] = {{wild(random), wild(random), wild(random)}, {wild(random), wild(random), wild(random)}};
  }
  for (double& p : world_.particle_p_W) p = wild(random);
  const bool is_lesson = scene_->rig->lesson.instance != nullptr;
  for (std::size_t i = 0; is_lesson && i < world_.signal.size(); ++i) world_.signal[i] = wild(random);
  view_.clear();
  for (const host::ObjectSlot& o : scene_->rig->objects)
    view_.push_back(scene::view(world_, {o.body, o.particle, o.shape, o.hinge, o.state, o.signal}, &input_));
}

std::unique_ptr<FuzzHarness> make_fuzz_harness(const TestScene& scene, uint64_t seed, std::string& error) {
  auto stepped = std::make_unique<Stepped>();
  if (!scene.make({}, *stepped, error)) return nullptr;
  if (error = stepped->run(10); !error.empty()) return nullptr;
  if (scene.plugin().kind == SWAGE_KIND_LESSON) return std::make_unique<Lesson>(std::move(stepped), seed);
  if (scene.plugin().kind == SWAGE_KIND_COUPLING) return std::make_unique<Coupling>(std::move(stepped), seed);
  error = say::kDoesMore();
  return nullptr;
}

namespace {

constexpr uint64_t kFuzzSteps = 2000, kFrom = 500, kElsewhere = 100'000;

// the hashes of steps from..to; ends early at a fault
std::vector<uint64_t> look(FuzzHarness& harness, uint64_t from, uint64_t to) {
  std::vector<uint64_t> hashes;
  for (uint64_t i = from; i < to && harness.fault().empty(); ++i) {
    harness.step(i);
    hashes.push_back(harness.hash());
  }
  return hashes;
}

// true when the same steps give the same hashes after other steps and a restore
bool rewinds(FuzzHarness& harness, const std::vector<uint64_t>& first) {
  harness.reset();
  look(harness, 0, kFrom);
  const FuzzHarness::Image image = harness.save();
  look(harness, kElsewhere, kElsewhere + 300);
  harness.restore(image);
  return look(harness, kFrom, kFuzzSteps) == std::vector<uint64_t>(first.begin() + kFrom, first.end());
}

}  // namespace

host::Finding fuzz_values(const TestScene& scene, uint64_t seed) {
  const auto failed = [seed](const std::string& text) {
    return host::Finding{host::Mark::kFailed, text + say::kSeed(seed)};
  };
  std::string error;
  const auto one = make_fuzz_harness(scene, seed, error), other = make_fuzz_harness(scene, seed, error);
  if (!one || !other) return failed(error);
  one->reset();
  const std::vector<uint64_t> first = look(*one, 0, kFuzzSteps);
  if (!one->fault().empty()) return failed(one->fault());
  if (one->allocations() > 0)
    return failed(say::kAllocates(one->allocations(), kFuzzSteps));
  one->reset();
  if (look(*one, 0, kFuzzSteps) != first)
    return failed(say::kForgets());
  other->reset();
  if (look(*other, 0, kFuzzSteps) != first)
    return failed(say::kShares());
  if (!rewinds(*one, first))
    return failed(say::kRemembers());
  // values that no host sends must cause no exception and leave no trace after a reset
  one->reset();
  for (uint64_t i = 0; i < 200; ++i) one->step(kElsewhere + i, true);
  one->reset();
  if (look(*one, 0, kFuzzSteps) != first && one->fault().empty())
    return failed(say::kPoisoned());
  return one->fault().empty() ? host::Finding{} : failed(one->fault());
}

}  // namespace swage::tools
