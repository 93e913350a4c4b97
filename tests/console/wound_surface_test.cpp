// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/wound_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh_measures.hpp"

namespace swage::console {
namespace wound_surface_test {

constexpr double kPi = std::numbers::pi;
constexpr float kWire = 0.05F;  // mm

// of what is seen from above
double area(const Mesh& m) {
  return area(m, [](const QVector3D& n) { return n.z(); });
}

Tear tear(float ax, float bx, uint32_t wound = 0) {
  return {{ax, 0, 0}, {bx, 0, 0}, {0, 0, 1}, kWire, wound};
}

TEST(WoundSurface, FleshIsTheTornRegionToScale) {
  const double disc = kPi * static_cast<double>(kWire * kWire);
  WoundMeshes prick, slit, twice;
  append_wounds({tear(0, 0)}, {}, prick);
  EXPECT_NEAR(area(prick.flesh), disc, 0.02 * disc);
  append_wounds({tear(0, 0), tear(0, 0.3F)}, {}, slit);
  EXPECT_NEAR(area(slit.flesh), disc + 0.3 * 0.1, 0.02 * (disc + 0.03)) << "what overlaps counts once";
  append_wounds({tear(0, 0), tear(1, 1, 1)}, {}, twice);
  EXPECT_NEAR(area(twice.flesh), 2 * disc, 0.04 * disc) << "two wounds lie apart";
}

TEST(WoundSurface, TheOpeningIsWithinAndWidestAtTheNeedle) {
  WoundMeshes slit;
  append_wounds({tear(0, 0), tear(0, 0.5F)}, {}, slit);
  float at_needle = 0, far_off = 0;
  for (const Vertex& v : slit.depth.vertex) {
    EXPECT_LT(std::abs(v.p[1]), kWire);
    if (std::abs(v.p[0] - 0.5F) < 0.02F) at_needle = std::max(at_needle, std::abs(v.p[1]));
    if (std::abs(v.p[0] - 0.1F) < 0.02F) far_off = std::max(far_off, std::abs(v.p[1]));
  }
  EXPECT_GT(at_needle, 0.75F * kWire);
  EXPECT_GT(far_off, 0.3F * kWire);
  EXPECT_LT(far_off, 0.5F * kWire);
}

TEST(WoundSurface, TheLipStandsUpAroundItAndFollowsTheDent) {
  const std::vector<Tear> tears = {tear(0, 0.2F)};
  WoundMeshes flat, dented;
  append_wounds(tears, {}, flat);
  float crest = 0, floor = 1;
  for (const Vertex& v : flat.lip.vertex) crest = std::max(crest, v.p[2]);
  for (const Vertex& v : flat.flesh.vertex) floor = std::min(floor, v.p[2]);
  EXPECT_NEAR(crest - floor, 0.35F * kWire, 0.02F * kWire);
  append_wounds(tears, {{{0, 0, 0}, {0, 0, -0.1F}, 1}}, dented);
  ASSERT_EQ(dented.flesh.vertex.size(), flat.flesh.vertex.size());
  for (size_t i = 0; i < flat.flesh.vertex.size(); ++i)
    EXPECT_NEAR(dented.flesh.vertex[i].p[2] - flat.flesh.vertex[i].p[2], -0.1F, 0.005F);
}

TEST(WoundSurface, LiesOnTheSurfaceThatIsDrawnAlong) {
  const std::vector<Dent> dents = {{{0, 0, 0}, {0.08F, 0, -0.1F}, 0.2F}};
  const QVector3D normal(0, 0, 1);
  for (const QVector3D& rest : {QVector3D(0, 0, 0), QVector3D(0.1F, 0.05F, 0), QVector3D(-0.2F, 0, 0)}) {
    const QVector3D now = rest + displacement(dents, rest), told(now.x(), now.y(), 0);
    EXPECT_NEAR((at_rest(dents, told, normal) - rest).length(), 0, 0.004F);
  }
  EXPECT_EQ(at_rest({}, {1, 2, 3}, normal), QVector3D(1, 2, 3));
}

TEST(WoundSurface, ATearToTheRimStaysCheap) {
  WoundMeshes whole;
  append_wounds({tear(0, 0), tear(0, 4)}, {}, whole);
  EXPECT_NEAR(area(whole.flesh), 0.4 + kPi * 0.0025, 0.01);
  EXPECT_LT(whole.flesh.index.size() / 3, 12000U);
}

TEST(WoundSurface, TheGreatestIsFramed) {
  EXPECT_FALSE(greatest_wound({}, {}).there());
  const WoundPlace place = greatest_wound({tear(0, 0), tear(2, 2, 1), tear(2, 2.1F, 1)}, {});
  EXPECT_NEAR(place.ratio, 3, 1e-4) << "two radii of way and one of wire";
  EXPECT_NEAR(place.middle.x(), 2.05F, 1e-5F);
  EXPECT_NEAR(place.radius, 0.1F, 1e-5F);
  EXPECT_EQ(place.of, 2);
}

TEST(WoundSurface, AHoleThatWasGivenUpIsNotFramedBesideTheLastBite) {
  const std::vector<Tear> tears = {tear(0, 0.2F), tear(2, 2.1F, 1), tear(3, 3, 2)};  // given up and the widest; entry; exit
  const Punctures last{{{2, 0, 0}}, {{3, 0, 0}}};
  EXPECT_NEAR(greatest_wound(tears, {}).middle.x(), 0.1F, 1e-5F) << "nothing is known of bites";
  const WoundPlace place = greatest_wound(tears, {}, last);
  EXPECT_NEAR(place.middle.x(), 2.05F, 1e-5F);
  EXPECT_NEAR(place.ratio, 3, 1e-4);
  // given up, and nothing else was begun
  EXPECT_TRUE(greatest_wound({tear(0, 0.2F)}, {}, last).there());
}

TEST(WoundSurface, AWoundIsAnEntryOrAnExit) {
  const Punctures last{{{0, 0, 0}, {5, 0, 0}}, {{2, 0, 0}}};
  EXPECT_EQ(kind_of_wound({0.1F, 0, 0}, last), WoundKind::kEntry);
  EXPECT_EQ(kind_of_wound({5, 0.2F, 0}, last), WoundKind::kEntry) << "the far edge has one of its own";
  EXPECT_EQ(kind_of_wound({1.9F, 0, 0}, last), WoundKind::kExit);
  EXPECT_EQ(kind_of_wound({3.4F, 0, 0}, last), WoundKind::kUnknown) << "an earlier bite";
  EXPECT_EQ(kind_of_wound({0, 0, 0}, {}), WoundKind::kUnknown);
}

}  // namespace wound_surface_test
}  // namespace swage::console
