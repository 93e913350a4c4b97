// SPDX-License-Identifier: Apache-2.0
//
// One small plugin of each kind for the tests of the wrapper. They misbehave on demand.
#pragma once

#include <swage/coupling.hpp>
#include <swage/device.hpp>
#include <swage/lesson.hpp>
#include <swage/object.hpp>

#include <stdexcept>

namespace swage::test {

enum class Grade : int32_t { kSoft, kHard };

struct EverythingParams {
  double width = 2.6e-3;  // m
  int count = 4;
  bool bent = true;
  Grade grade = Grade::kHard;
  std::string words = "steel";
  std::string mesh;
  swage_vec3 place{1e-3, 2e-3, 3e-3};
  std::array<double, 4> four{1, 2, 3, 4};
  Interval region{0.5, 0.75};
};

/// An object with a parameter of every type; offers all traits and its own mechanics.
class Everything final : public Object<EverythingParams>,
                         public Solid,
                         public Graspable,
                         public Gripper,
                         public Solver {
 public:
  static constexpr auto id = "test.object.everything", version = "1.2.3", name = "Everything",
                        summary = "For tests.", author = "Swage", licence = "Apache-2.0";
  static constexpr const char* kGrades[] = {"soft", "hard", nullptr};
  static constexpr const char* kFormerIds[] = {"breadth", nullptr};
  static constexpr std::array fields{
      real<&EverythingParams::width>("width", "Width", "m", "mm", 1e-3, 5e-3, "How wide.")
          .group("Shape")
          .aliases(kFormerIds)
          .live(),
      integer<&EverythingParams::count>("count", "Count", 0, 10, "How many.").required(),
      boolean<&EverythingParams::bent>("bent", "Bent", "Whether it is bent.").hidden(),
      choice<&EverythingParams::grade>("grade", "Grade", kGrades, "How hard."),
      text<&EverythingParams::words>("words", "Words", "What it says."),
      file<&EverythingParams::mesh>("mesh", "Mesh", "Its surface."),
      vector<&EverythingParams::place>("place", "Place", "m", "mm", -1, 1, "Where it is."),
      vector<&EverythingParams::four>("four", "Four", "1", "1", 0, 9, "Four numbers."),
      interval<&EverythingParams::region>("region", "Region", "1", "1", 0, 1, "From where to where."),
  };
  static constexpr std::array traits{"test.trait.sticky/1", "test.trait.promise/1"};

  struct State {
    double steps, other;
  };

  void build(const EverythingParams& p, Builder& b) override {
    if (p.count == 0) throw std::runtime_error("count is zero");
    if (p.count == 1) throw 7;
    if (p.width > 4e-3) b.error("width", "too wide");
    body_ = b.dynamic_body("ball", {1e-6, {1e-12, 1e-12, 1e-12}});
    b.sphere(body_, {0, 0, 0}, 0.5 * p.width);
    b.state<State>();
    load_ = b.signal("load", "N", "The load.");
  }
  void activate(double) override {
    if (params().count == 2) refuse("count is two");
  }
  void forces(const Step& step) override {
    step.state<State>().steps += 1;
    step.add_force(body_, {0, 0, 1});
    if (params().words == "throw") throw std::runtime_error("thrown in forces");
    if (params().words == "discard") discard();
    if (params().words == "give up") give_up(42, 1, 2);
  }
  void changed() override { load_now_ = params().width; }
  void finish(const Step& step) override { step.signal(load_, load_now_); }
  void reset(const Step& step) override { step.state<State>() = {}; }

  void advance(const Step& step) override { step.pose(body_).p.x += 1; }
  void mobility(const Step&, std::span<const swage_contact_point> points, double* v_free,
                  double* W) override {
    v_free[0] = static_cast<double>(points.size());
    W[0] = 5;
  }
  void apply_impulses(const Step& step, std::span<const swage_contact_point>, const double* impulse) override {
    step.twist(body_).v.x = impulse[0];
  }
  void locate(const Step&, swage_vec3 p_W, swage_graspable_place& out) override { out.s = p_W.x; }
  void describe(const Step&, swage_gripper_state& out) override { out.opening = 0.25; }

  const void* extension(std::string_view wanted) override {
    static constexpr int sticky = 9;
    return wanted == "test.trait.sticky/1" ? &sticky : nullptr;
  }

 private:
  Body body_;
  Signal load_;
  double load_now_ = 3;
};

/// The least an object must be.
class Nothing final : public Object<> {
 public:
  static constexpr auto id = "test.object.nothing", version = "0.0.1", name = "Nothing",
                        summary = "For tests.", author = "Swage", licence = "Apache-2.0";
  void build(const NoParams&, Builder& b) override { b.fixed_body("nothing"); }
};

class Touch final : public Coupling<> {
 public:
  static constexpr auto id = "test.coupling.touch", version = "1.0.0", name = "Touch", summary = "For tests.",
                        author = "Swage", licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_GRIPPER, SWAGE_TRAIT_SOLID};
  static constexpr std::array needs_b{SWAGE_TRAIT_GRASPABLE};
  static constexpr bool detects = true;

  struct State {
    double count;
  };

  void build(const NoParams&, Builder& b) override {
    b.state<State>();
    touched_ = b.event("touched", "They touch.");
  }
  void bind(const Peer& a, const Peer& b) override {
    a_ = a;
    b_ = b;
    if (!a.gripper() || !b.graspable()) refuse("wrong partners");
  }
  void resolve(const CouplingStep& step) override {
    for (swage_contact& contact : step.contacts()) contact.friction = 0.5;
    step.state<State>().count += static_cast<double>(step.contacts().size());
    const auto place = b_.locate(step.b(), {0.125, 0, 0});
    if (place) step.event(touched_, place->s);
  }
  void reset(const CouplingStep& step) override { step.state<State>().count = 0; }

 private:
  Peer a_, b_;
  Event touched_;
};

class Wheel final : public Device<> {
 public:
  static constexpr auto id = "test.device.wheel", version = "1.0.0", name = "Wheel", summary = "For tests.",
                        author = "Swage", licence = "Apache-2.0";
  static constexpr DeviceCard card{.flags = SWAGE_DEVICE_FORCE, .rate_hz = 500, .max_force = 3};
  void exchange(const swage_command& command, swage_sample& sample) override {
    sample.sequence += 1;
    sample.closure = command.gain;
    sample.valid = SWAGE_VALID_CLOSURE;
  }
};

class Script final : public Device<> {
 public:
  static constexpr auto id = "test.device.script", version = "1.0.0", name = "Script", summary = "For tests.",
                        author = "Swage", licence = "Apache-2.0";
  static constexpr DeviceCard card{.flags = SWAGE_DEVICE_LOCKSTEP};
  void open() override { throw std::runtime_error("no such script"); }
  void exchange(const swage_command&, swage_sample& sample) override { sample.sequence += 1; }
};

class Watch final : public Lesson<> {
 public:
  static constexpr auto id = "test.lesson.watch", version = "1.0.0", name = "Watch", summary = "For tests.",
                        author = "Swage", licence = "Apache-2.0";
  struct State {
    double time, seen;
  };
  void build(const NoParams&, Builder& b) override {
    b.state<State>();
    time_ = b.metric("time", "s", "How long it took.");
    good_ = b.cue("good", "As it should be.");
    late_ = b.event("late", "It took too long.");
    look_ = b.phase("look", "Looking.");
  }
  void bind(const Scene& scene, Binder& binder) override {
    ball_ = scene.find_object("ball");
    load_ = scene.find_signal("ball", "load");
    if (ball_ == kNone) binder.error("there is no object \"ball\"");
    if (!load_.valid()) binder.error("nobody offers \"load\"");
    target_ = binder.mark_point({0, 0, 1e-3}, 1e-4, "target.point");
  }
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override {
    State& mine = as<State>(state);
    mine.time += view.dt();
    verdict.phase(look_);
    verdict.cue(ball_, good_);
    verdict.metric(time_, mine.time);
    verdict.mark(target_, good_);
    if (view.signal(load_) > 1) verdict.pass(0.5);
    if (mine.time > 1) verdict.fail(late_);
  }
  void reset(std::span<double> state) override { as<State>(state).seen = 1; }

 private:
  uint32_t ball_ = kNone;
  Signal load_;
  Metric time_;
  Cue good_;
  Event late_;
  Phase look_;
  Mark target_;
};

}  // namespace swage::test
