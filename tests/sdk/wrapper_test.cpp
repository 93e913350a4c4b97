// SPDX-License-Identifier: Apache-2.0
//
// The wrapper as a host meets it: through the C tables only.
#include <gtest/gtest.h>
#include <swage/testbed.hpp>

#include "sample_plugins.hpp"

namespace swage::test {
namespace {

constexpr swage_entry kEntry = make_entry<Everything, Nothing, Touch, Wheel, Script, Watch>();

/// "what id unit" of everything that has a name.
std::vector<std::string> names(const testbed::Declared& declared) {
  std::vector<std::string> lines;
  for (const auto& name : declared.names)
    lines.push_back(std::to_string(name.what) + " " + name.id + " " + name.unit);
  return lines;
}

const swage_factory& factory() {
  return *static_cast<const swage_factory*>(kEntry.get_factory(SWAGE_FACTORY_INSTANCES));
}
const swage_param* table(const char* id, uint32_t& n) {
  return static_cast<const swage_param_factory*>(kEntry.get_factory(SWAGE_FACTORY_PARAMS))->table(id, &n);
}

/// The host's values for Everything: the defaults, to be changed by tests.
struct Values {
  std::vector<swage_value> value;
  std::string words = "steel";
  swage_values raw{};

  Values() {
    uint32_t n = 0;
    const swage_param* row = table(Everything::id, n);
    value.resize(n);
    for (uint32_t i = 0; i < n; ++i)
      for (int k = 0; k < 4; ++k) value[i].number[k] = row[i].default_number[k];
  }
  const swage_values* get() {
    value[4].text = str(words);
    raw = {sizeof(swage_values), static_cast<uint32_t>(value.size()), value.data(), str("ball")};
    return &raw;
  }
};

/// An instance of Everything with the arrays that a step needs.
struct Ball {
  testbed::Host host;
  testbed::Declared builder;
  Values values;
  swage_instance* raw = factory().create(&host.raw, Everything::id);
  swage_pose pose = kIdentity;
  swage_twist twist{};
  swage_wrench wrench{};
  double state[2] = {0, 0};
  double signal[1] = {0};
  swage_object_step step{};

  Ball() {
    step.struct_size = sizeof step;
    step.dt_s = 1e-3;
    step.X_WB = &pose;
    step.V_WB = &twist;
    step.F_B_W = &wrench;
    step.state = state;
    step.signal = signal;
    step.n_body = 1;
    step.n_state = 2;
    step.n_signal = 1;
  }
  ~Ball() {
    host.role = SWAGE_THREAD_MAIN;
    raw->destroy(raw);
  }
  swage_result configure() { return raw->configure(raw, values.get(), &builder.raw); }
  void start() {
    ASSERT_EQ(configure(), SWAGE_OK);
    ASSERT_EQ(raw->activate(raw, 1e-3), SWAGE_OK);
    host.role = SWAGE_THREAD_RT;
  }
  template <class Table>
  const Table* get(const char* id) {
    return static_cast<const Table*>(raw->get_extension(raw, id));
  }
};

TEST(Entry, says_what_it_was_built_for) {
  EXPECT_EQ(kEntry.struct_size, sizeof(swage_entry));
  EXPECT_EQ(kEntry.abi_major, SWAGE_ABI_MAJOR);
  EXPECT_EQ(kEntry.abi_minor, SWAGE_ABI_MINOR);
  EXPECT_NE(std::string(kEntry.build_info).find("C++ 202"), std::string::npos) << kEntry.build_info;
  EXPECT_EQ(kEntry.get_factory("swage.factory.instances/2"), nullptr);
  EXPECT_EQ(kEntry.init("/somewhere/bundle"), SWAGE_OK);
  EXPECT_EQ(bundle_dir(), "/somewhere/bundle");
  EXPECT_EQ(kEntry.init(nullptr), SWAGE_OK);
  EXPECT_EQ(bundle_dir(), "");
}

TEST(Factory, describes_every_plugin) {
  ASSERT_EQ(factory().count(), 6u);
  EXPECT_EQ(factory().descriptor(6), nullptr);
  const swage_descriptor* who = factory().descriptor(0);
  EXPECT_EQ(who->struct_size, sizeof(swage_descriptor));
  EXPECT_EQ(who->kind, SWAGE_KIND_OBJECT);
  EXPECT_STREQ(who->id, "test.object.everything");
  EXPECT_STREQ(who->version, "1.2.3");
  EXPECT_STREQ(who->licence, "Apache-2.0");
  EXPECT_EQ(factory().descriptor(2)->kind, SWAGE_KIND_COUPLING);
  EXPECT_EQ(factory().descriptor(3)->kind, SWAGE_KIND_DEVICE);
  EXPECT_EQ(factory().descriptor(5)->kind, SWAGE_KIND_LESSON);
}

TEST(Factory, lists_inherited_and_own_traits) {
  std::vector<std::string> traits;
  for (const char* const* t = factory().descriptor(0)->traits; *t != nullptr; ++t) traits.push_back(*t);
  const std::vector<std::string> expected{SWAGE_TRAIT_SOLID, SWAGE_TRAIT_GRASPABLE, SWAGE_TRAIT_GRIPPER,
                                          "test.trait.sticky/1", "test.trait.promise/1"};
  EXPECT_EQ(traits, expected);
  for (uint32_t i = 1; i < factory().count(); ++i) EXPECT_EQ(factory().descriptor(i)->traits[0], nullptr);
}

TEST(Factory, every_listed_trait_is_offered_from_the_start) {
  Ball ball;
  for (const char* const* t = factory().descriptor(0)->traits; *t != nullptr; ++t) {
    const void* before = ball.raw->get_extension(ball.raw, *t);
    EXPECT_NE(before, nullptr) << *t;
    EXPECT_EQ(ball.configure(), SWAGE_OK);
    EXPECT_EQ(ball.raw->get_extension(ball.raw, *t), before) << *t;
  }
}

TEST(Factory, creates_nothing_for_an_unknown_id) {
  testbed::Host host;
  for (uint32_t i = 0; i < factory().count(); ++i) {
    const std::string id = factory().descriptor(i)->id;
    EXPECT_EQ(factory().create(&host.raw, (id + "x").c_str()), nullptr);
    EXPECT_EQ(factory().create(&host.raw, id.substr(0, id.size() - 1).c_str()), nullptr);
    swage_instance* made = factory().create(&host.raw, id.c_str());
    ASSERT_NE(made, nullptr);
    made->destroy(made);
  }
  EXPECT_EQ(factory().create(&host.raw, ""), nullptr);
  EXPECT_TRUE(host.faults.empty());
}

TEST(Params, one_table_says_it_all) {
  uint32_t n = 0;
  const swage_param* row = table(Everything::id, n);
  ASSERT_EQ(n, 9u);
  const int32_t types[] = {SWAGE_PARAM_REAL,   SWAGE_PARAM_INTEGER, SWAGE_PARAM_BOOL,
                           SWAGE_PARAM_CHOICE, SWAGE_PARAM_TEXT,    SWAGE_PARAM_FILE,
                           SWAGE_PARAM_VECTOR, SWAGE_PARAM_VECTOR,  SWAGE_PARAM_VECTOR};
  for (uint32_t i = 0; i < n; ++i) {
    EXPECT_EQ(row[i].struct_size, sizeof(swage_param));
    EXPECT_EQ(row[i].type, types[i]) << row[i].id;
  }
  EXPECT_STREQ(row[0].id, "width");
  EXPECT_STREQ(row[0].label, "Width");
  EXPECT_STREQ(row[0].group, "Shape");
  EXPECT_STREQ(row[0].unit, "m");
  EXPECT_STREQ(row[0].display_unit, "mm");
  EXPECT_STREQ(row[0].doc, "How wide.");
  EXPECT_STREQ(row[0].aliases[0], "breadth");
  EXPECT_EQ(row[0].min, 1e-3);
  EXPECT_EQ(row[0].max, 5e-3);
  EXPECT_EQ(row[0].flags, SWAGE_PARAM_LIVE);
  EXPECT_EQ(row[1].flags, SWAGE_PARAM_REQUIRED);
  EXPECT_EQ(row[2].flags, SWAGE_PARAM_HIDDEN);
  EXPECT_STREQ(row[3].choices[1], "hard");
  EXPECT_EQ(row[3].max, 1);
  EXPECT_EQ(row[6].dimension, 3u);
  EXPECT_EQ(row[7].dimension, 4u);
  EXPECT_EQ(row[8].dimension, 2u);
}

TEST(Params, defaults_are_the_member_initialisers) {
  uint32_t n = 0;
  const swage_param* row = table(Everything::id, n);
  ASSERT_EQ(n, 9u);
  EXPECT_EQ(row[0].default_number[0], 2.6e-3);
  EXPECT_EQ(row[1].default_number[0], 4);
  EXPECT_EQ(row[2].default_number[0], 1);
  EXPECT_EQ(row[3].default_number[0], 1);
  EXPECT_STREQ(row[4].default_text, "steel");
  EXPECT_STREQ(row[5].default_text, "");
  EXPECT_EQ(row[6].default_number[2], 3e-3);
  EXPECT_EQ(row[7].default_number[3], 4);
  EXPECT_EQ(row[8].default_number[0], 0.5);
  EXPECT_EQ(row[8].default_number[1], 0.75);
}

TEST(Params, none_at_all_is_fine) {
  uint32_t n = 7;
  EXPECT_EQ(table(Nothing::id, n), nullptr);
  EXPECT_EQ(n, 0u);
  n = 7;
  EXPECT_EQ(table("test.object.everythingx", n), nullptr);
  EXPECT_EQ(n, 0u);
  testbed::Host host;
  testbed::Declared builder;
  swage_instance* made = factory().create(&host.raw, Nothing::id);
  EXPECT_EQ(made->configure(made, nullptr, &builder.raw), SWAGE_OK);
  EXPECT_EQ(builder.bodies.size(), 1u);
  made->destroy(made);
}

TEST(Params, values_reach_the_members) {
  Ball ball;
  ball.values.value[0].number[0] = 4.5e-3;  // above what build() takes
  EXPECT_EQ(ball.configure(), SWAGE_ERROR);
  EXPECT_EQ(ball.builder.errors, std::vector<std::string>{"width: too wide"});
}

TEST(Configure, contains_a_throw_and_passes_on_its_words) {
  Ball ball;
  ball.values.value[1].number[0] = 0;
  EXPECT_EQ(ball.configure(), SWAGE_FAULT);
  ASSERT_EQ(ball.host.reports.size(), 1u);
  EXPECT_EQ(ball.host.reports[0], "ball: configure: count is zero");
  ball.values.value[1].number[0] = 1;
  EXPECT_EQ(ball.configure(), SWAGE_FAULT);
  EXPECT_EQ(ball.host.reports.back(), "ball: configure: threw something that is not a std::exception");
  EXPECT_EQ(ball.raw->activate(ball.raw, 1e-3), SWAGE_ERROR);  // not ready
}

TEST(Configure, starts_afresh_each_time) {
  Ball ball;
  ASSERT_EQ(ball.configure(), SWAGE_OK);
  testbed::Declared again;
  EXPECT_EQ(ball.raw->configure(ball.raw, ball.values.get(), &again.raw), SWAGE_OK);
  EXPECT_EQ(again.bodies.size(), 1u);
  EXPECT_EQ(again.shapes.size(), 1u);
  EXPECT_EQ(again.n_state, 2u);
  EXPECT_EQ(names(again), std::vector<std::string>{"1 load N"});
}

TEST(Configure, fails_when_a_declaration_is_refused) {
  Ball ball;
  ball.builder.refuse_bodies = true;
  EXPECT_EQ(ball.configure(), SWAGE_ERROR);
}

TEST(Activate, may_refuse) {
  Ball ball;
  ball.values.value[1].number[0] = 2;
  ASSERT_EQ(ball.configure(), SWAGE_OK);
  EXPECT_EQ(ball.raw->activate(ball.raw, 1e-3), SWAGE_ERROR);
  EXPECT_EQ(ball.host.reports, std::vector<std::string>{"ball: count is two"});
}

TEST(Object, adds_forces_writes_signals_and_state) {
  Ball ball;
  ball.start();
  const auto* object = ball.get<swage_object>(SWAGE_EXT_OBJECT);
  ASSERT_NE(object, nullptr);
  EXPECT_EQ(object->forces(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(object->forces(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(ball.wrench.f.z, 2);
  EXPECT_EQ(ball.state[0], 2);
  EXPECT_EQ(object->finish(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(ball.signal[0], 3);
  object->reset(ball.raw, &ball.step);
  EXPECT_EQ(ball.state[0], 0);
  EXPECT_TRUE(ball.host.faults.empty());
}

TEST(Object, results_of_a_step) {
  const struct {
    const char* words;
    swage_result result;
    int32_t code;
  } cases[] = {{"throw", SWAGE_FAULT, SWAGE_FAULT_THROWN},
               {"discard", SWAGE_DISCARD, 0},
               {"give up", SWAGE_ERROR, 42}};
  for (const auto& c : cases) {
    Ball ball;
    ball.values.words = c.words;
    ball.start();
    EXPECT_EQ(ball.get<swage_object>(SWAGE_EXT_OBJECT)->forces(ball.raw, &ball.step), c.result) << c.words;
    EXPECT_TRUE(ball.host.reports.empty()) << "no words on [rt]";
    if (c.code == 0) continue;
    ASSERT_EQ(ball.host.faults.size(), 1u) << c.words;
    EXPECT_EQ(ball.host.faults[0].code, c.code);
  }
}

TEST(Object, takes_live_parameters) {
  Ball ball;
  ball.start();
  const auto* live = ball.get<swage_live>(SWAGE_EXT_LIVE);
  ASSERT_NE(live, nullptr);
  const swage_value value{{4e-3, 0, 0, 0}, {}};
  EXPECT_EQ(live->change(ball.raw, 0, &value), SWAGE_OK);
  EXPECT_EQ(ball.get<swage_object>(SWAGE_EXT_OBJECT)->finish(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(ball.signal[0], 4e-3);
  EXPECT_EQ(live->change(ball.raw, 1, &value), SWAGE_ERROR) << "count is not live";
  EXPECT_EQ(live->change(ball.raw, 9, &value), SWAGE_ERROR) << "there is no such parameter";
}

TEST(Object, offers_its_mechanics_and_traits) {
  Ball ball;
  ball.start();
  const auto* solver = ball.get<swage_solver>(SWAGE_EXT_SOLVER);
  const auto* graspable = ball.get<swage_graspable>(SWAGE_TRAIT_GRASPABLE);
  const auto* gripper = ball.get<swage_gripper>(SWAGE_TRAIT_GRIPPER);
  ASSERT_TRUE(solver != nullptr && graspable != nullptr && gripper != nullptr);
  EXPECT_NE(ball.raw->get_extension(ball.raw, SWAGE_TRAIT_SOLID), nullptr);
  EXPECT_NE(ball.raw->get_extension(ball.raw, "test.trait.sticky/1"), nullptr);
  EXPECT_EQ(ball.raw->get_extension(ball.raw, "test.trait.sticky/1x"), nullptr);
  EXPECT_EQ(ball.raw->get_extension(ball.raw, SWAGE_TRAIT_SOLID "x"), nullptr);
  EXPECT_EQ(ball.raw->get_extension(ball.raw, "swage.coupling/1"), nullptr);

  EXPECT_EQ(solver->advance(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(ball.pose.p.x, 1);
  const swage_contact_point points[2] = {};
  double v_free[6] = {}, W[36] = {}, impulse[6] = {8, 0, 0, 0, 0, 0};
  EXPECT_EQ(solver->compliance(ball.raw, &ball.step, 2, points, v_free, W), SWAGE_OK);
  EXPECT_EQ(v_free[0], 2);
  EXPECT_EQ(W[0], 5);
  EXPECT_EQ(solver->yield(ball.raw, &ball.step, 2, points, impulse), SWAGE_OK);
  EXPECT_EQ(ball.twist.v.x, 8);

  swage_graspable_place place{};
  EXPECT_EQ(graspable->locate(ball.raw, &ball.step, {0.5, 0, 0}, &place), SWAGE_OK);
  EXPECT_EQ(place.s, 0.5);
  swage_gripper_state jaws{};
  EXPECT_EQ(gripper->describe(ball.raw, &ball.step, &jaws), SWAGE_OK);
  EXPECT_EQ(jaws.opening, 0.25);
}

TEST(Object, offers_nothing_that_it_did_not_inherit) {
  testbed::Host host;
  swage_instance* made = factory().create(&host.raw, Nothing::id);
  EXPECT_NE(made->get_extension(made, SWAGE_EXT_OBJECT), nullptr);
  for (const char* id :
       {SWAGE_EXT_LIVE, SWAGE_EXT_SOLVER, SWAGE_TRAIT_SOLID, SWAGE_TRAIT_GRASPABLE, SWAGE_TRAIT_GRIPPER})
    EXPECT_EQ(made->get_extension(made, id), nullptr) << id;
  made->destroy(made);
}

TEST(Guard, wrong_thread_is_reported_once_and_not_fatal) {
  static_assert(SWAGE_CHECKS == 1, "this test is compiled with checks");
  Ball ball;
  ball.start();
  const auto* object = ball.get<swage_object>(SWAGE_EXT_OBJECT);
  ball.host.role = SWAGE_THREAD_MAIN;
  EXPECT_EQ(object->forces(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(object->forces(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_EQ(ball.wrench.f.z, 2) << "the call went through";
  ASSERT_EQ(ball.host.faults.size(), 1u);
  EXPECT_EQ(ball.host.faults[0].code, SWAGE_FAULT_THREAD);
  EXPECT_EQ(ball.host.faults[0].b, SWAGE_THREAD_MAIN);
  EXPECT_EQ(ball.host.reports,
            std::vector<std::string>{"ball: forces: the host called from the wrong thread"});
}

TEST(Guard, main_calls_from_the_step_leave_a_record_without_words) {
  Ball ball;
  ball.host.role = SWAGE_THREAD_RT;
  EXPECT_EQ(ball.configure(), SWAGE_OK);
  ASSERT_EQ(ball.host.faults.size(), 1u);
  EXPECT_EQ(ball.host.faults[0].code, SWAGE_FAULT_THREAD);
  EXPECT_TRUE(ball.host.reports.empty());
}

TEST(Guard, wrong_order_is_reported_and_does_nothing) {
  Ball ball;
  const auto* object = ball.get<swage_object>(SWAGE_EXT_OBJECT);
  ball.host.role = SWAGE_THREAD_RT;
  EXPECT_EQ(object->forces(ball.raw, &ball.step), SWAGE_ERROR);
  EXPECT_EQ(ball.host.faults.back().code, SWAGE_FAULT_ORDER);
  ball.host.role = SWAGE_THREAD_MAIN;
  EXPECT_EQ(ball.raw->activate(ball.raw, 1e-3), SWAGE_ERROR);
  EXPECT_EQ(ball.host.reports.back(),
            "test.object.everything: activate: called before a configure that succeeded");
  ball.raw->deactivate(ball.raw);
  EXPECT_EQ(ball.host.reports.back(), "test.object.everything: deactivate: called before activate");
  ASSERT_EQ(ball.configure(), SWAGE_OK);
  ASSERT_EQ(ball.raw->activate(ball.raw, 1e-3), SWAGE_OK);
  EXPECT_EQ(ball.raw->activate(ball.raw, 1e-3), SWAGE_ERROR);
  EXPECT_EQ(ball.configure(), SWAGE_ERROR);
  EXPECT_EQ(ball.host.reports.back(), "ball: configure: called while active");
  ball.raw->deactivate(ball.raw);
  EXPECT_EQ(ball.configure(), SWAGE_OK);
}

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
