// SPDX-License-Identifier: Apache-2.0
//
// An actor of every kind, so that assembling can be tested without the stock plugins.
#include <swage/coupling.hpp>
#include <swage/device.hpp>
#include <swage/lesson.hpp>
#include <swage/object.hpp>

#define ACTOR(ID, NAME)                                 \
  static constexpr auto id = "org.example." ID;         \
  static constexpr auto version = "1.2.3", name = NAME; \
  static constexpr auto summary = "Acts in tests.";     \
  static constexpr auto author = "Swage", licence = "Apache-2.0"

namespace {

constexpr swage_mass kMass{1e-6, {1e-12, 1e-12, 1e-12}};

struct BallParams {
  double radius = 1e-3;  // m
};

class Ball final : public swage::Object<BallParams>, public swage::Solid {
 public:
  ACTOR("ball", "Ball");
  static constexpr std::array fields = {
      swage::real<&BallParams::radius>("radius", "Radius", "m", "mm", 0.1e-3, 10e-3, "Of the ball.")};
  void build(const BallParams& p, swage::ObjectBuilder& b) override {
    b.sphere(b.dynamic_body("ball", kMass), {0, 0, 0}, p.radius);
    b.signal("ball.height", "m", "Above the ground.");
    b.state(2);
  }
};

// a hand's tool with a jaw on a hinge, an arc, a polyhedron and three particles
class Tool final : public swage::Object<>, public swage::Solid {
 public:
  ACTOR("tool", "Tool");
  void build(const swage::NoParams&, swage::ObjectBuilder& b) override {
    const swage::Body hand = b.following_body("hand");
    const swage::Body jaw = b.hinged_body("jaw", {{0, 0, 1e-3}, {1, 0, 0, 0}});
    b.hinge({hand, jaw, {0, 0, 1e-3}, {0, 1, 0}, 1e-9, -0.1, 0.5});
    b.arc(hand, {{{0, 0, 0}, {1, 0, 0, 0}}, 2e-3, 2.0, 1e-4});
    const double v[] = {0, 0, 0, 1e-3, 0, 0, 0, 1e-3, 0, 0, 0, 1e-3};
    const uint32_t start[] = {0, 3, 6, 9, 12}, face[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    b.convex(jaw, v, start, face);
    const double p[9] = {}, m[] = {1e-9, 1e-9, 1e-9};
    b.particles(p, m, 1e-5);
  }
};

class Finds final : public swage::Coupling<> {
 public:
  ACTOR("finds", "Finds contacts");
  static constexpr std::array needs_a{SWAGE_TRAIT_SOLID}, needs_b{SWAGE_TRAIT_SOLID};
  static constexpr bool detects = true;
};

class Looks final : public swage::Coupling<> {
 public:
  ACTOR("looks", "Looks at contacts");
  static constexpr std::array needs_a{SWAGE_TRAIT_SOLID}, needs_b{SWAGE_TRAIT_SOLID};
  static constexpr bool detects = false;
  void build(const swage::NoParams&, swage::CouplingBuilder& b) override {
    b.signal("looks.force", "N", "What it sees.");
    b.event("looks.seen", "It has seen something.");
  }
};

class Pad final : public swage::Device<> {
 public:
  ACTOR("pad", "Pad with forces");
  static constexpr swage::DeviceCard card{.flags = SWAGE_DEVICE_FORCE, .rate_hz = 1000, .max_force = 3};
  void exchange(const swage_command&, swage_sample&) override {}
};

struct PenParams {
  double speed = 1;
};
class Pen final : public swage::Device<PenParams> {
 public:
  ACTOR("pen", "Pen in the world");
  static constexpr swage::DeviceCard card{.flags = SWAGE_DEVICE_LOCKSTEP | SWAGE_DEVICE_WORLD};
  static constexpr std::array fields = {
      swage::real<&PenParams::speed>("speed", "Speed", "1", "1", 0.1, 10, "How fast it writes.")};
  void exchange(const swage_command&, swage_sample&) override {}
};

struct WatchParams {
  std::string arc_of;
  double from = 0.5;
};
class Watch final : public swage::Lesson<WatchParams> {
 public:
  ACTOR("watch", "Watches");
  static constexpr std::array fields = {
      swage::text<&WatchParams::arc_of>("arc_of", "Arc of",
                                        "Object with an arc, marked from \"from\" to 0.9."),
      swage::real<&WatchParams::from>("from", "From", "1", "%", 0, 1, "Start of the mark.")};
  void build(const WatchParams&, swage::LessonBuilder& b) override {
    b.metric("watch.time", "s", "How long it watched.");
    b.cue("watch.good", "All is well.");
    b.event("watch.done", "It is over.");
    b.phase("watch.wait", "Nothing happens.");
  }
  void bind(const swage::Scene& scene, swage::Binder& binder) override {
    if (params().arc_of.empty()) return;
    binder.mark_arc(scene.find_object(params().arc_of), params().from, 0.9, "region.target");
    binder.mark_point({1, 2, 3}, 1e-3, "target.point");
  }
  void observe(const swage::View&, const swage::Verdict&, std::span<double>) override {}
};

}  // namespace

SWAGE_EXPORT(Ball, Tool, Finds, Looks, Pad, Pen, Watch)
