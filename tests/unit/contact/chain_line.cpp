// SPDX-License-Identifier: Apache-2.0
#include "contact/chain_line.hpp"

#include <gtest/gtest.h>

namespace swage::contact {
namespace chain_line_test {

/// A wire of two arcs (shapes 0 and 1) on bodies of `motion`, and a block (shape 2).
scene::World chain(int32_t motion) {
  scene::World w;
  w.body.resize(3);
  w.body[0].motion = w.body[1].motion = motion;
  w.body[2].motion = SWAGE_MOTION_FIXED;
  w.shape.resize(3);
  for (uint32_t i = 0; i < 3; ++i) w.shape[i].body = i;
  w.shape[0].kind = w.shape[1].kind = SWAGE_SHAPE_ARC;
  w.shape[2].kind = SWAGE_SHAPE_CONVEX;
  return w;
}

/// The two points that a stretch of `length` [m] of an arc has on the block.
void lie(ContactSet& set, uint32_t arc, double length, bool arc_is_a) {
  for (const uint64_t point : {uint64_t{1}, uint64_t{2}}) {
    Contact c;
    c.shape_a = arc_is_a ? arc : 2;
    c.shape_b = arc_is_a ? 2 : arc;
    c.feature = 0x100 | point;
    c.weight = 0.5;
    c.p_W = Vec3(1e-3 * arc + (0.25 + 0.5 * static_cast<double>(point - 1)) * length, 0, 0);
    set.contact.push_back(c);
  }
}

double weight(const ContactSet& set) {
  double sum = 0;
  for (const Contact& c : set.contact) sum += c.weight;
  return sum;
}

TEST(ChainLine, ArcsOfOneWireShareItsWeightByTheirLength) {
  for (const bool arc_is_a : {true, false}) {
    ContactSet set;
    lie(set, 0, 0.3e-3, arc_is_a);
    lie(set, 1, 0.1e-3, arc_is_a);
    share_chain_lines(chain(SWAGE_MOTION_FLEXIBLE), set, 0);
    EXPECT_NEAR(set.contact[0].weight, 0.5 * 0.75, 1e-12);
    EXPECT_NEAR(set.contact[1].weight, 0.5 * 0.75, 1e-12);
    EXPECT_NEAR(set.contact[2].weight, 0.5 * 0.25, 1e-12);
    EXPECT_NEAR(weight(set), 1, 1e-12);
  }
}

// An arc round an edge has two lines, which already share the weight of the arc by their lengths: 0.3 mm and 0.1 mm of 0.8 mm.
TEST(ChainLine, AnArcWithTwoLinesHasTheShareOfBoth) {
  ContactSet set;
  lie(set, 0, 0.4e-3, true);
  lie(set, 1, 0.3e-3, true), lie(set, 1, 0.1e-3, true);
  for (size_t i = 2; i < 6; ++i) set.contact[i].weight *= i < 4 ? 0.75 : 0.25;
  set.contact[4].feature += 0x100, set.contact[5].feature += 0x100;
  share_chain_lines(chain(SWAGE_MOTION_FLEXIBLE), set, 0);
  EXPECT_NEAR(set.contact[0].weight, 0.5 * 0.5, 1e-12);
  EXPECT_NEAR(set.contact[2].weight, 0.5 * 0.375, 1e-12);
  EXPECT_NEAR(set.contact[4].weight, 0.5 * 0.125, 1e-12);
  EXPECT_NEAR(weight(set), 1, 1e-12);
}

TEST(ChainLine, LeavesTheRestAlone) {
  // one arc only; two needles that are rigid; a single point; another pair's contacts
  ContactSet one;
  lie(one, 0, 0.3e-3, true);
  share_chain_lines(chain(SWAGE_MOTION_FLEXIBLE), one, 0);
  EXPECT_EQ(weight(one), 1);
  ContactSet rigid;
  lie(rigid, 0, 0.3e-3, true), lie(rigid, 1, 0.1e-3, true);
  share_chain_lines(chain(SWAGE_MOTION_DYNAMIC), rigid, 0);
  EXPECT_EQ(weight(rigid), 2);
  ContactSet point;
  lie(point, 0, 0.3e-3, true), lie(point, 1, 0.1e-3, true);
  point.contact[2].feature = point.contact[3].feature = 0x200;
  share_chain_lines(chain(SWAGE_MOTION_FLEXIBLE), point, 0);
  EXPECT_EQ(weight(point), 2);
  ContactSet other;
  lie(other, 0, 0.3e-3, true), lie(other, 1, 0.1e-3, true);
  share_chain_lines(chain(SWAGE_MOTION_FLEXIBLE), other, 2);
  EXPECT_EQ(weight(other), 2);
}

}  // namespace chain_line_test
}  // namespace swage::contact
