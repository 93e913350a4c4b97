// SPDX-License-Identifier: Apache-2.0
//
// The wrapper as a host meets it, through the C tables only: the entry, the tables of parameters, the life of an instance.
#include "wrapper_bed.hpp"

namespace swage::test {
namespace {

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
  EXPECT_EQ(row[6].flags, 0u);
  EXPECT_EQ(row[8].flags, SWAGE_PARAM_INTERVAL);
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
  EXPECT_EQ(ball.host.reports.back(), std::string("ball: configure: ") + detail::kThrewAnything);
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

}  // namespace
}  // namespace swage::test
