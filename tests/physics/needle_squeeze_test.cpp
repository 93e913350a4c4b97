// SPDX-License-Identifier: Apache-2.0
//
// A needle squeezed on edge between the stock jaws, its plane square to the faces: three-point bending. One face touches the arc
// in its middle, the other where the edges of the jaws cross it, w apart, so under the force N the wire bears N w / 4 in the
// middle and its outer fibre yields at N = 4 M_y / w. The width w grows from the tips to the base, and so does the jaws'
// force by the lever of the hinge: deep in the jaws it bends, near the tips the same grip leaves it as it was.
#include <gtest/gtest.h>

#include <numbers>

#include "toolkit/wire_section.hpp"
#include "two_plane_pinch.hpp"

namespace swage::stage {
namespace {

using toolkit::Vec3;

constexpr double kYield = 2.0e9;  // Pa, the needle's by default
constexpr double kOnEdge = 0.5 * std::numbers::pi;

/// On edge it stands by friction. Too much of that keeps the feet of the arch from sliding apart, which bears a share of the load.
constexpr double kSlippery = 0.05, kRough = 0.6;

PinchSetup on_edge(double behind, double grip, double friction, int pieces, const std::string& more = "") {
  return {.behind = behind,
          .grip = grip,
          .friction = friction,
          .off_flat = kOnEdge,
          .needle = "\"level\": \"bending\", \"pieces\": " + std::to_string(pieces) + more};
}

double first_yield(double behind, double yield_stress) {  // N
  return 4 * toolkit::yield_moment(kWire, yield_stress) / jaw_width(behind);
}
double off_flat(const Pinch& pinch) { return std::acos(std::abs((pinch.pose().q * Vec3::UnitZ()).z())); }

// 0.38 mm of jaw: less than one piece of nine (0.7 mm), and less than two of thirteen. Of an odd number of pieces the middle one is
// held in its middle; of an even number two meet there and touch the face beside the joint that opens between them, up to 50 um
// from it, where the wire itself touches in the middle.
TEST(Squeeze, StressIsThreePointBendingUnderJawsNarrowerThanAPiece) {
  for (const int pieces : {9, 13, 23, 8, 12, 24}) {
    Pinch pinch(on_edge(0.4e-3, 0.6, kSlippery, pieces));
    ASSERT_TRUE(pinch.ready()) << pinch.run().problems();
    ASSERT_NEAR(off_flat(pinch), kOnEdge, 0.05);
    const double expected = pinch.force() / first_yield(pinch.behind(), kYield);
    EXPECT_NEAR(pinch.run().signal("needle", "needle.stress"), expected, 0.05 * expected) << pieces;
    EXPECT_EQ(pinch.run().signal("needle", "needle.bend"), 0) << pieces;
  }
}

// soft steel, which yields at 0.83 N here
TEST(Squeeze, YieldsAtFourYieldMomentsOverTheWidth) {
  for (const int pieces : {12, 13})
    for (const double share : {0.94, 1.06}) {
      constexpr double kSoft = 0.8e9;
      const double lever = kReach / (kReach - 0.4e-3);
      Pinch pinch(on_edge(0.4e-3, share * first_yield(0.4e-3, kSoft) / lever, kSlippery, pieces,
                          ", \"yield_stress\": \"800 MPa\""));
      ASSERT_TRUE(pinch.ready()) << pinch.run().problems();
      EXPECT_EQ(pinch.run().signal("needle", "needle.stress") >= 1, share > 1) << pieces << " " << share;
    }
}

// one grip, 1.5 N at the tips: there 4 M_y / w is 2.1 N, 4 mm behind them, where the lever makes it 2.5 N, 0.7 N
TEST(Squeeze, DeepInTheJawsItBendsForGoodNearTheTipsNot) {
  for (const int pieces : {12, 24}) {
    Pinch tips(on_edge(0.4e-3, 1.5, kRough, pieces)), deep(on_edge(4e-3, 1.5, kRough, pieces));
    ASSERT_TRUE(tips.ready() && deep.ready());
    EXPECT_LT(tips.run().signal("needle", "needle.stress"), 1) << pieces;
    EXPECT_EQ(tips.run().signal("needle", "needle.bend"), 0) << pieces;
    EXPECT_GT(deep.run().signal("needle", "needle.stress"), 1) << pieces;
    EXPECT_GT(deep.run().signal("needle", "needle.bend"), 0.02) << "more than a degree";
  }
}

}  // namespace
}  // namespace swage::stage
