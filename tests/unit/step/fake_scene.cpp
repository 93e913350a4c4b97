// SPDX-License-Identifier: Apache-2.0
#include "fake_scene.hpp"

#include <cstring>

namespace swage::step {

namespace {

constexpr double kRadius = 0.5e-3;  // m
constexpr double kMass = 1e-6;      // kg

template <class F, class... Args>
swage_result call(const F& f, Args... args) {
  return f ? f(args...) : SWAGE_OK;
}

const void* extension(swage_instance* raw, const char* id) {
  Fake& f = Fake::of(raw);
  return f.has_live && std::strcmp(id, SWAGE_EXT_LIVE) == 0 ? &f.live : nullptr;
}

}  // namespace

Fake::Fake() {
  using I = swage_instance*;
  raw.self = this;
  raw.configure = [](I, const swage_values*, swage_builder*) { return swage_result{SWAGE_OK}; };
  raw.activate = [](I, double) { return swage_result{SWAGE_OK}; };
  raw.deactivate = raw.destroy = [](I) {};
  raw.get_extension = extension;
  object.forces = [](I i, const swage_object_step* s) { return call(of(i).forces, s); };
  object.finish = [](I i, const swage_object_step* s) { return call(of(i).finish, s); };
  object.reset = [](I i, const swage_object_step* s) {
    if (of(i).reset) of(i).reset(s);
  };
  solver.advance = [](I i, const swage_object_step* s) { return call(of(i).advance, s); };
  coupling.detects = 1;
  coupling.resolve = [](I i, const swage_coupling_step* s) { return call(of(i).resolve, s); };
  coupling.finish = [](I i, const swage_coupling_step* s) { return call(of(i).coupling_finish, s); };
  coupling.reset = [](I i, const swage_coupling_step* s) {
    if (of(i).coupling_reset) of(i).coupling_reset(s);
  };
  device.flags = SWAGE_DEVICE_LOCKSTEP | SWAGE_DEVICE_WORLD;
  device.exchange = [](I i, const swage_command* c, swage_sample* s) { return call(of(i).exchange, c, s); };
  lesson.observe = [](I i, const swage_view* v, const swage_verdict* s, double* d) {
    return call(of(i).observe, v, s, d);
  };
  lesson.reset = [](I, double*) {};
  live.change = [](I i, uint32_t p, const swage_value* v) { return call(of(i).change, p, v); };
}

std::unique_ptr<host::Instance> Fake::instance(const std::string& name) {
  auto out = std::make_unique<host::Instance>();
  out->name = name;
  out->plugin_id = "test." + name;
  out->plugin_version = "1.0.0";
  out->raw = &raw;
  return out;
}

FakeScene::FakeScene() {
  scene::World& w = rig.world;
  w.gravity = {0, 0, 0};
  w.length = 1e-3;
  add_body(SWAGE_MOTION_FOLLOWS, 0, {0, 0, 0});
  add_body(SWAGE_MOTION_DYNAMIC, 1, {0, 0, 5e-3});
  w.plugin_state.resize(4);
  w.signal.resize(3);
  w.random = {11, 12};
  w.F_B_W.resize(2);
  add_objects();
  add_contact();

  host::DeviceSlot& d = rig.devices.emplace_back();
  d.instance = device_.instance("hand");
  d.device = &device_.device;
  d.X_WD0 = {{0, 0, 0}, {1, 0, 0, 0}};

  rig.script.events = {{"contact", "touch", "1", ""}, {"lesson", "lesson.said", "1", ""}};
  rig.script.metrics = {{"lesson", "metric", "1", ""}};
  rig.lesson.instance = lesson_.instance("lesson");
  rig.lesson.lesson = &lesson_.lesson;
  rig.lesson.state = {3, 1};
  rig.lesson.event = {1, 1};
  rig.lesson.metric = {0, 1};
}

void FakeScene::add_objects() {
  rig.objects.resize(2);
  Fake* fakes[] = {&tool_, &ball_};
  for (uint32_t i = 0; i < 2; ++i) {
    host::ObjectSlot& slot = rig.objects[i];
    slot.instance = fakes[i]->instance(i == 0 ? "tool" : "ball");
    slot.object = &fakes[i]->object;
    slot.body = slot.shape = {i, 1};
    slot.signal = {i, 1};
    slot.X_WO = {{0, 0, 0}, {1, 0, 0, 0}};
  }
  rig.objects[1].state = {0, 2};
  rig.objects[0].follow = {0, 0};
}

void FakeScene::add_contact() {
  host::CouplingSlot& c = rig.couplings.emplace_back();
  c.instance = coupling_.instance("contact");
  c.coupling = &coupling_.coupling;
  c.object_a = 0;
  c.object_b = 1;
  c.pair = 0;
  c.state = {2, 1};
  c.signal = {2, 1};
  c.event = {0, 1};
  rig.pairs.push_back({0, 1, {}});
}

void FakeScene::add_body(int32_t motion, uint32_t object, swage_vec3 p) {
  scene::BodyInfo body;
  body.motion = motion;
  body.object = object;
  body.start = {p, {1, 0, 0, 0}};
  if (motion == SWAGE_MOTION_DYNAMIC) {
    body.mass = kMass;
    for (double& i : body.inertia) i = 0.4 * kMass * kRadius * kRadius;
  }
  scene::Shape shape;
  shape.kind = SWAGE_SHAPE_SPHERE;
  shape.body = static_cast<uint32_t>(rig.world.body.size());
  shape.object = object;
  shape.X_BS.q.w = 1;
  shape.radius = shape.bounding_radius = kRadius;
  rig.world.body.push_back(body);
  rig.world.shape.push_back(shape);
}

Engine& FakeScene::engine() {
  if (!engine_) engine_ = std::make_unique<Engine>(rig, Options());
  return *engine_;
}

}  // namespace swage::step
