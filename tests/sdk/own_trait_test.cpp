// SPDX-License-Identifier: Apache-2.0
//
// A trait of one's own with a table: the functions find the object's class behind the instance (swage::self), and a coupling that
// knows only the trait gets its answer.
#include <gtest/gtest.h>
#include <swage/abi/visual.h>
#include <swage/testbed.hpp>

#include "../plugins_for_tests/sticky/sticky.hpp"
#include "loaded_plugin.hpp"

namespace swage::test {
namespace {

TEST(OwnTrait, a_coupling_asks_a_class_it_has_never_heard_of) {
  const swage_entry* entry = load_entry(SWAGE_STICKY);
  ASSERT_NE(entry, nullptr);
  testbed::Host host;
  testbed::Declared pad_builder, peel_builder;
  const auto& factory = instances_of(*entry);
  swage_instance* pad = factory.create(&host.raw, Pad::id);
  swage_instance* peel = factory.create(&host.raw, Peel::id);
  ASSERT_TRUE(pad != nullptr && peel != nullptr);
  const swage_value strength{{5e3, 0, 0, 0}, {}};
  const swage_values of_pad{sizeof(swage_values), 1, &strength, {"pad", 3}}, none{sizeof(swage_values), 0, nullptr, {"peel", 4}};
  ASSERT_EQ(pad->configure(pad, &of_pad, &pad_builder.raw), SWAGE_OK);
  ASSERT_EQ(peel->configure(peel, &none, &peel_builder.raw), SWAGE_OK);
  const auto* coupling = static_cast<const swage_coupling*>(peel->get_extension(peel, SWAGE_EXT_COUPLING));
  ASSERT_NE(coupling, nullptr);
  ASSERT_EQ(coupling->bind(peel, pad, pad), SWAGE_OK);
  ASSERT_EQ(pad->activate(pad, 1e-3), SWAGE_OK);
  ASSERT_EQ(peel->activate(peel, 1e-3), SWAGE_OK);

  swage_object_step object{};
  double signal = 0;
  swage_coupling_step step{};
  step.a = step.b = &object;
  step.signal = &signal;
  step.n_signal = 1;
  host.role = SWAGE_THREAD_RT;
  EXPECT_EQ(coupling->finish(peel, &step), SWAGE_OK);
  EXPECT_DOUBLE_EQ(signal, 5e3 * 293 / 310);

  // what it draws keeps within the room that there is
  const auto* visuals = static_cast<const swage_visuals*>(pad->get_extension(pad, SWAGE_EXT_VISUAL));
  ASSERT_NE(visuals, nullptr);
  EXPECT_EQ(peel->get_extension(peel, SWAGE_EXT_VISUAL), nullptr);
  for (uint32_t room = 0; room <= 3; ++room) {
    swage_visual drawn[3] = {};
    uint32_t n = 99;
    EXPECT_EQ(visuals->draw(pad, &object, nullptr, room, drawn, &n), SWAGE_OK);
    EXPECT_EQ(n, room < 2 ? room : 2u);
    if (room == 0) continue;
    EXPECT_EQ(drawn[0].kind, uint32_t{SWAGE_VISUAL_DISC});
    EXPECT_EQ(drawn[0].body, 0u);
    EXPECT_EQ(drawn[0].direction.z, 1);
    EXPECT_EQ(drawn[1].kind, room < 2 ? 0u : uint32_t{SWAGE_VISUAL_LINE});
  }
  host.role = SWAGE_THREAD_MAIN;
  for (swage_instance* i : {peel, pad}) {
    i->deactivate(i);
    i->destroy(i);
  }
  EXPECT_TRUE(host.faults.empty());
}

}  // namespace
}  // namespace swage::test
