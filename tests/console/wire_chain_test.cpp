// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/wire_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "console/view3d/scene_parts.hpp"

namespace swage::console {
namespace {

constexpr double kRadius = 2.6e-3, kSweep = 0.75 * std::numbers::pi;
constexpr int kPieces = 5;

swage_quat about_z(double a) { return {std::cos(0.5 * a), 0, 0, std::sin(0.5 * a)}; }

// a needle of five pieces around the origin, whose bodies are not in order along the wire
snapshot::SceneCard needle() {
  snapshot::SceneCard card;
  card.objects = {{"needle", "swage.object.needle", "1.0.0", {"swage.trait.graspable/1"}, 0, kPieces, 0, 0}};
  for (const int piece : {2, 0, 1, 3, 4}) {
    snapshot::CardShape arc;
    arc.kind = SWAGE_SHAPE_ARC;
    arc.flags = SWAGE_SHAPE_USUAL;
    arc.body = static_cast<uint32_t>(card.start.size());
    arc.arc_radius = kRadius;
    arc.radius = 50e-6;
    arc.sweep = kSweep / kPieces;
    arc.X_BS = {{0, 0, 0}, {1, 0, 0, 0}};
    card.start.push_back({{0, 0, 0}, about_z(piece * kSweep / kPieces)});
    card.shapes.push_back(arc);
  }
  card.motion.assign(kPieces, SWAGE_MOTION_DYNAMIC);
  judge::Script::Mark region;
  region.mark.kind = SWAGE_MARK_ARC_RANGE;
  region.mark.object = 0;
  region.mark.number[0] = 0.5;
  region.mark.number[1] = 0.75;
  region.meaning = "region.target";
  card.script.marks = {region};
  return card;
}

TEST(WireChain, PiecesAreOrderedAlongTheWireAndTheLineLiesOnTheArc) {
  const auto chains = find_chains(needle());
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].piece[0].body, 1U);
  EXPECT_EQ(chains[0].piece[2].body, 0U);
  const std::vector<double> line = chains[0].centre_line(needle().start);
  double last = -1;
  for (size_t i = 0; i < line.size(); i += 3) {
    EXPECT_NEAR(std::hypot(line[i], line[i + 1]), kRadius, 1e-12);
    const double angle = std::atan2(line[i + 1], line[i]);
    EXPECT_GT(angle, last - 1e-12) << "it never turns back";
    last = angle;
  }
  EXPECT_NEAR(last, kSweep, 1e-9);
}

TEST(WireChain, APartOfTheLineIsCutByLength) {
  const auto chains = find_chains(needle());
  const std::vector<double> part = part_of_line(chains[0].centre_line(needle().start), 0.5, 0.75);
  ASSERT_GE(part.size(), 6U);
  EXPECT_NEAR(std::atan2(part[1], part[0]), 0.5 * kSweep, 2e-3);
  EXPECT_NEAR(std::atan2(part[part.size() - 2], part[part.size() - 3]), 0.75 * kSweep, 2e-3);
  EXPECT_TRUE(part_of_line({}, 0, 1).empty());
}

TEST(WireChain, IsOneWireInTheSceneWithOneSleeve) {
  const SceneParts parts = make_parts(needle());
  ASSERT_EQ(parts.part.size(), 4U);  // the wire, the sleeve, a collar at either end of it
  EXPECT_EQ(parts.part[0].chain, 0);
  EXPECT_EQ(parts.part[1].role, Role::kMark);
  EXPECT_TRUE(parts.part[0].wire);
  EXPECT_GT(parts.work.radius(), 2.0F);
  EXPECT_EQ(parts.watched, 0);
  // a rigid needle is no chain
  snapshot::SceneCard rigid = needle();
  rigid.shapes.resize(1);
  EXPECT_TRUE(find_chains(rigid).empty());
}

// a kink at a joint is rounded within one station, and the line stays within the wire's radius
TEST(WireChain, ABentJointIsSmooth) {
  snapshot::SceneCard card = needle();
  const auto chains = find_chains(card);
  std::vector<swage_pose> bent = card.start;
  const double kink = 0.15, c = std::cos(4 * kSweep / kPieces), s = std::sin(4 * kSweep / kPieces);
  // the last piece rotated by the kink about its own beginning
  const double x = kRadius * c, y = kRadius * s;
  bent[4] = {{x - std::cos(kink) * x + std::sin(kink) * y, y - std::sin(kink) * x - std::cos(kink) * y, 0},
             about_z(4 * kSweep / kPieces + kink)};
  const std::vector<double> line = chains[0].centre_line(bent);
  const size_t n = line.size() / 3;
  double sharpest = 0;
  for (size_t i = 1; i + 1 < n; ++i) {
    const auto heading = [&](size_t k) {
      return std::atan2(line[3 * k + 4] - line[3 * k + 1], line[3 * k + 3] - line[3 * k]);
    };
    sharpest =
        std::max(sharpest, std::abs(std::remainder(heading(i) - heading(i - 1), 2 * std::numbers::pi)));
  }
  EXPECT_LT(sharpest, 0.5 * kink + 0.06) << "shared by the two stations beside the joint";
  EXPECT_GT(sharpest, 0.06) << "but it is seen";
}

}  // namespace
}  // namespace swage::console
