// SPDX-License-Identifier: Apache-2.0
//
// The same for couplings, devices and lessons.
#include "wrapper_bed.hpp"

namespace swage::test {
namespace {

TEST(Coupling, binds_changes_the_law_and_tells) {
  Ball gripper, needle;
  gripper.start();
  needle.start();
  testbed::Host host;
  testbed::Declared builder;
  swage_instance* made = factory().create(&host.raw, Touch::id);
  ASSERT_EQ(made->configure(made, nullptr, &builder.raw), SWAGE_OK);
  EXPECT_EQ(names(builder), std::vector<std::string>{"4 touched 1"});
  const auto* coupling = static_cast<const swage_coupling*>(made->get_extension(made, SWAGE_EXT_COUPLING));
  ASSERT_NE(coupling, nullptr);
  EXPECT_EQ(coupling->detects, 1u);
  EXPECT_STREQ(coupling->needs_a[1], SWAGE_TRAIT_SOLID);
  EXPECT_EQ(coupling->needs_a[2], nullptr);
  EXPECT_STREQ(coupling->needs_b[0], SWAGE_TRAIT_GRASPABLE);
  EXPECT_EQ(coupling->needs_b[1], nullptr);
  ASSERT_EQ(coupling->bind(made, gripper.raw, needle.raw), SWAGE_OK);
  ASSERT_EQ(made->activate(made, 1e-3), SWAGE_OK);

  host.role = SWAGE_THREAD_RT;
  std::vector<double> told;
  swage_contact contacts[2] = {};
  double state[1] = {0};
  swage_coupling_step step{};
  step.struct_size = sizeof step;
  step.n_contact = 2;
  step.contact = contacts;
  step.a = &gripper.step;
  step.b = &needle.step;
  step.state = state;
  step.n_state = 1;
  step.host_data = &told;
  step.event = [](const swage_coupling_step* s, uint32_t, double value) {
    static_cast<std::vector<double>*>(s->host_data)->push_back(value);
  };
  EXPECT_EQ(coupling->resolve(made, &step), SWAGE_OK);
  EXPECT_EQ(contacts[1].friction, 0.5);
  EXPECT_EQ(state[0], 2);
  EXPECT_EQ(told, std::vector<double>{0.125});
  coupling->reset(made, &step);
  EXPECT_EQ(state[0], 0);
  host.role = SWAGE_THREAD_MAIN;
  made->destroy(made);
}

TEST(Coupling, refuses_partners_without_the_traits) {
  testbed::Host host;
  testbed::Declared builder;
  swage_instance* made = factory().create(&host.raw, Touch::id);
  swage_instance* nothing = factory().create(&host.raw, Nothing::id);
  ASSERT_EQ(made->configure(made, nullptr, &builder.raw), SWAGE_OK);
  const auto* coupling = static_cast<const swage_coupling*>(made->get_extension(made, SWAGE_EXT_COUPLING));
  EXPECT_EQ(coupling->bind(made, nothing, nothing), SWAGE_ERROR);
  EXPECT_EQ(host.reports.back(), "test.coupling.touch: wrong partners");
  nothing->destroy(nothing);
  made->destroy(made);
}

TEST(Device, exchanges_on_its_own_thread) {
  testbed::Host host;
  testbed::Declared builder;
  swage_instance* made = factory().create(&host.raw, Wheel::id);
  ASSERT_EQ(made->configure(made, nullptr, &builder.raw), SWAGE_OK);
  ASSERT_EQ(made->activate(made, 1e-3), SWAGE_OK);
  const auto* device = static_cast<const swage_device*>(made->get_extension(made, SWAGE_EXT_DEVICE));
  ASSERT_NE(device, nullptr);
  EXPECT_EQ(device->flags, SWAGE_DEVICE_FORCE);
  EXPECT_EQ(device->rate_hz, 500);
  EXPECT_EQ(device->max_force, 3);
  EXPECT_EQ(device->open(made), SWAGE_OK);
  host.role = SWAGE_THREAD_IO;
  swage_command command{};
  command.gain = 0.75;
  swage_sample sample{};
  EXPECT_EQ(device->exchange(made, &command, &sample), SWAGE_OK);
  EXPECT_EQ(sample.closure, 0.75);
  EXPECT_TRUE(host.faults.empty());
  host.role = SWAGE_THREAD_RT;
  EXPECT_EQ(device->exchange(made, &command, &sample), SWAGE_OK);
  ASSERT_EQ(host.faults.size(), 1u) << "this one is not LOCKSTEP";
  host.role = SWAGE_THREAD_MAIN;
  device->close(made);
  made->destroy(made);
}

TEST(Device, lockstep_exchanges_in_the_step_and_a_failed_open_is_told) {
  testbed::Host host;
  testbed::Declared builder;
  swage_instance* made = factory().create(&host.raw, Script::id);
  ASSERT_EQ(made->configure(made, nullptr, &builder.raw), SWAGE_OK);
  ASSERT_EQ(made->activate(made, 1e-3), SWAGE_OK);
  const auto* device = static_cast<const swage_device*>(made->get_extension(made, SWAGE_EXT_DEVICE));
  EXPECT_EQ(device->open(made), SWAGE_FAULT);
  EXPECT_EQ(host.reports.back(), "test.device.script: open: no such script");
  host.faults.clear();
  host.role = SWAGE_THREAD_RT;
  swage_command command{};
  swage_sample sample{};
  EXPECT_EQ(device->exchange(made, &command, &sample), SWAGE_OK);
  EXPECT_TRUE(host.faults.empty());
  host.role = SWAGE_THREAD_IO;
  EXPECT_EQ(device->exchange(made, &command, &sample), SWAGE_OK);
  EXPECT_EQ(host.faults.size(), 1u);
  host.role = SWAGE_THREAD_MAIN;
  made->destroy(made);
}

/// What a lesson said.
struct Said {
  uint32_t object = kNone, cue = kNone, mark = kNone, phase = kNone;
  double metric = 0, score = -1;
  int32_t passed = -1;
  uint32_t reason = 0;
  std::vector<std::string> errors;

  static Said& of(const swage_verdict* v) { return *static_cast<Said*>(v->host_data); }
};

swage_verdict verdict_into(Said& said) {
  swage_verdict v{};
  v.struct_size = sizeof v;
  v.host_data = &said;
  v.cue = [](const swage_verdict* s, uint32_t object, uint32_t cue) {
    Said::of(s).object = object;
    Said::of(s).cue = cue;
  };
  v.mark = [](const swage_verdict* s, uint32_t mark, uint32_t, const swage_vec3*) {
    Said::of(s).mark = mark;
  };
  v.metric = [](const swage_verdict* s, uint32_t, double value) { Said::of(s).metric = value; };
  v.event = [](const swage_verdict*, uint32_t, double) {};
  v.phase = [](const swage_verdict* s, uint32_t phase) { Said::of(s).phase = phase; };
  v.finish = [](const swage_verdict* s, int32_t passed, double score, uint32_t reason) {
    Said::of(s).passed = passed;
    Said::of(s).score = score;
    Said::of(s).reason = reason;
  };
  return v;
}

swage_lesson_binder binder_into(Said& said) {
  swage_lesson_binder binder{};
  binder.struct_size = sizeof binder;
  binder.host_data = &said;
  binder.mark = [](swage_lesson_binder*, const swage_mark*) -> uint32_t { return 5; };
  binder.error = [](swage_lesson_binder* b, const char* message) {
    static_cast<Said*>(b->host_data)->errors.push_back(message);
  };
  return binder;
}

/// A configured Watch.
struct Watching {
  testbed::Host host;
  testbed::Declared builder;
  Said said;
  swage_instance* raw = factory().create(&host.raw, Watch::id);
  const swage_lesson* lesson = static_cast<const swage_lesson*>(raw->get_extension(raw, SWAGE_EXT_LESSON));
  swage_lesson_binder binder = binder_into(said);
  swage_scene_object object{str("ball"), str("test.object.everything"), 0, 1, 0, 0, nullptr};
  swage_scene_signal signal{str("ball"), str("load"), str("N")};
  swage_scene_card card{sizeof(swage_scene_card), 1, 1, 0, &object, &signal, nullptr, 1e-3};

  Watching() { EXPECT_EQ(raw->configure(raw, nullptr, &builder.raw), SWAGE_OK); }
  ~Watching() {
    host.role = SWAGE_THREAD_MAIN;
    raw->destroy(raw);
  }
};

TEST(Lesson, finds_watches_and_judges) {
  Watching w;
  const std::vector<std::string> declared{"2 time s", "3 good 1", "4 late 1", "5 look 1"};
  EXPECT_EQ(names(w.builder), declared);
  ASSERT_EQ(w.lesson->bind(w.raw, &w.card, &w.binder), SWAGE_OK);
  ASSERT_EQ(w.raw->activate(w.raw, 1e-3), SWAGE_OK);
  w.host.role = SWAGE_THREAD_RT;
  double state[2] = {0, 0}, signal[1] = {0};
  w.lesson->reset(w.raw, state);
  EXPECT_EQ(state[1], 1);

  const swage_verdict verdict = verdict_into(w.said);
  swage_view seen{};
  seen.struct_size = sizeof seen;
  seen.dt_s = 0.25;
  seen.signal = signal;
  seen.n_signal = 1;
  EXPECT_EQ(w.lesson->observe(w.raw, &seen, &verdict, state), SWAGE_OK);
  EXPECT_EQ(w.said.object, 0u);
  EXPECT_EQ(w.said.cue, 0u);
  EXPECT_EQ(w.said.mark, 5u);
  EXPECT_EQ(w.said.phase, 0u);
  EXPECT_EQ(w.said.metric, 0.25);
  EXPECT_EQ(w.said.passed, -1);
  signal[0] = 2;
  EXPECT_EQ(w.lesson->observe(w.raw, &seen, &verdict, state), SWAGE_OK);
  EXPECT_EQ(w.said.passed, 1);
  EXPECT_EQ(w.said.score, 0.5);
  signal[0] = 0;
  state[0] = 2;
  EXPECT_EQ(w.lesson->observe(w.raw, &seen, &verdict, state), SWAGE_OK);
  EXPECT_EQ(w.said.passed, 0);
  EXPECT_TRUE(w.host.faults.empty());
}

TEST(Lesson, tells_everything_that_is_missing) {
  Watching w;
  w.object.name = str("balloon");
  w.card.n_signal = 0;
  EXPECT_EQ(w.lesson->bind(w.raw, &w.card, &w.binder), SWAGE_ERROR);
  const std::vector<std::string> expected{"there is no object \"ball\"", "nobody offers \"load\""};
  EXPECT_EQ(w.said.errors, expected);
}

}  // namespace
}  // namespace swage::test
