// SPDX-License-Identifier: Apache-2.0
//
// The contact coupling sets the law of every contact and reports force and overlap.
#include "stage.hpp"

namespace swage::coupling_contact {
namespace {

// a grip of 2 MN came out of 100 steps a second with the default stiffness
TEST(Contact, RefusesAStiffnessThatTheStepCannotBear) {
  for (const auto& [stiffness, dt_s, good] : {std::tuple{3e7, 1e-3, true}, {1e6, 5e-3, true}, {1e6, 1e-2, false}, {3e7, 2e-3, false}}) {
    stage::Stage stage("swage.coupling.contact");
    ASSERT_EQ(stage.configure({{"stiffness", stiffness}}), SWAGE_OK);
    EXPECT_EQ(stage.activate(dt_s) == SWAGE_OK, good) << stiffness << " " << dt_s;
  }
}

TEST(Contact, SetsTheLawAndTellsForceAndOverlap) {
  stage::Stage stage("swage.coupling.contact");
  ASSERT_EQ(stage.configure({{"friction", 0.8}, {"stiffness", 5e3}, {"restitution", 0.25}}), SWAGE_OK);
  ASSERT_EQ(stage.activate(), SWAGE_OK);
  stage.on_rt();
  const auto& table = stage.table<swage_coupling>(SWAGE_EXT_COUPLING);
  EXPECT_EQ(table.detects, 1u);

  std::vector<swage_contact> contacts(3);
  for (swage_contact& c : contacts) c.n_W = {0, 0, 1};
  contacts[0].f_a_W = {0.3, 0, 0.4};  // friction does not count
  contacts[0].gap = -2e-6;
  contacts[1].f_a_W = {0, 0, 0.1};
  contacts[1].gap = -5e-6;
  contacts[2].gap = 8e-6;  // near, not touching
  std::vector<double> signal(stage.declared[SWAGE_DECLARE_SIGNAL].size());
  swage_coupling_step s{};
  s.struct_size = sizeof(s);
  s.contact = contacts.data();
  s.n_contact = 3;
  s.signal = signal.data();
  s.n_signal = static_cast<uint32_t>(signal.size());

  ASSERT_EQ(table.resolve(stage.raw(), &s), SWAGE_OK);
  for (const swage_contact& c : contacts) {
    EXPECT_EQ(c.friction, 0.8);
    EXPECT_EQ(c.stiffness, 5e3);
    EXPECT_EQ(c.restitution, 0.25);
  }
  ASSERT_EQ(table.finish(stage.raw(), &s), SWAGE_OK);
  EXPECT_NEAR(signal[stage.index_of(SWAGE_DECLARE_SIGNAL, "contact.force")], 0.5, 1e-15);
  EXPECT_NEAR(signal[stage.index_of(SWAGE_DECLARE_SIGNAL, "contact.overlap")], 5e-6, 1e-18);

  s.n_contact = 0;
  table.finish(stage.raw(), &s);
  EXPECT_EQ(signal[0], 0);
  EXPECT_EQ(signal[1], 0);
}

}  // namespace
}  // namespace swage::coupling_contact
