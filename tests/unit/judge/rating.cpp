// SPDX-License-Identifier: Apache-2.0
#include "judge/rating.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace swage::judge {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::Optional;

const RatingScale kScale = {"s", {{"en", "Scale"}}, {{"en", "a source"}}, 1, 5, {},
                            {{"force", {{"en", "Force"}, {"de", "Kraft"}}, {{"force.peak", "N", 0.2, 0.6}, {"drops", "1", 0, 2}}},
                             {"flow", {{"en", "Flow"}}, {}},
                             {"done", {{"en", "Done"}}, {{"task.success", "1", 1, 0}}}}};
using Told = std::vector<std::pair<std::string, double>>;

TEST(Rating, AnItemIsTheMeanOfItsMetricsBetweenBestAndWorst) {
  const Rating r = rate(kScale, Told{{"force.peak", 0.3}, {"drops", 1}, {"task.success", 1}}, true);
  // shares 0.75 and 0.5; 1 + 4 (0.625)
  EXPECT_THAT(r.item, ElementsAre(Optional(DoubleEq(3.5)), std::nullopt, Optional(DoubleEq(5))));
  EXPECT_EQ(r.decided, 2u);
  EXPECT_DOUBLE_EQ(r.mean, 4.25);
}

TEST(Rating, BeyondBestAndWorstTheScaleEnds) {
  EXPECT_DOUBLE_EQ(*rate(kScale, Told{{"force.peak", 0.1}}, true).item[0], 5);
  EXPECT_DOUBLE_EQ(*rate(kScale, Told{{"force.peak", 9}}, true).item[0], 1);
}

TEST(Rating, WhatWasNotToldDecidesNothing) {
  const Rating one = rate(kScale, Told{{"drops", 0}, {"force.peak", std::numeric_limits<double>::quiet_NaN()}}, true);
  EXPECT_THAT(one.item, ElementsAre(Optional(DoubleEq(5)), std::nullopt, std::nullopt));
  const Rating none = rate(kScale, {}, true);
  EXPECT_EQ(none.decided, 0u);
  EXPECT_EQ(none.mean, 0);
}

TEST(Rating, AFailedAttemptHasNoProduct) {
  RatingScale scale = kScale;
  scale.items[0].is_product = true;
  const Told told = {{"drops", 0}, {"task.success", 0.5}};
  EXPECT_THAT(rate(scale, told, true).item, ElementsAre(Optional(DoubleEq(5)), std::nullopt, Optional(DoubleEq(3))));
  EXPECT_THAT(rate(scale, told, false).item, ElementsAre(Optional(DoubleEq(1)), std::nullopt, Optional(DoubleEq(3))));
}

// Of a failed attempt no lost points are told: a mean of what is left would leave the errors out.
TEST(Rating, AnItemOfLostPointsIsTheWorstOfWhatDecidesAFailedAttempt) {
  RatingScale scale = kScale;
  scale.items[0].by = {{"points.wound", "1", 0, 30}, {"stray", "1", 0, 5}, {"wound", "1", 1, 3, true}, {"refused", "1", 0, 3, true}};
  scale.items[1].by = {{"points.time", "1", 0, 15}, {"path", "1", 0, 1}};
  const Told told = {{"stray", 0}, {"wound", 3.01}, {"refused", 0}, {"path", 0}, {"task.success", 0}};
  EXPECT_THAT(rate(scale, told, false).item, ElementsAre(Optional(DoubleEq(1)), std::nullopt, Optional(DoubleEq(1))));
  EXPECT_THAT(rate(scale, Told{{"stray", 0}}, false).item[0], std::nullopt) << "nothing decides it";
  EXPECT_THAT(rate(scale, Told{{"stray", 0}, {"wound", 2}}, false).item[0], Optional(DoubleEq(3)));
  const Told passed = {{"stray", 0}, {"points.wound", 15}, {"wound", 3}};
  EXPECT_THAT(rate(scale, passed, true).item[0], Optional(DoubleEq(4))) << "of a passed one the points count, and the wound not twice";
}

TEST(Rating, AScaleSaysNothingOfAnAttemptThatLacksWhatItNeeds) {
  RatingScale scale = kScale;
  scale.needs = {"knot.slides"};
  EXPECT_EQ(rate(scale, Told{{"drops", 0}}, true).decided, 0u);
  EXPECT_EQ(rate(scale, Told{{"drops", 0}, {"knot.slides", 0}}, true).decided, 1u);
}

TEST(Rating, WordsFallBackToEnglish) {
  EXPECT_EQ(said_in(kScale.items[0].title, "de"), "Kraft");
  EXPECT_EQ(said_in(kScale.items[0].title, "fr"), "Force");
  EXPECT_EQ(said_in({}, "de"), "");
}

}  // namespace
}  // namespace swage::judge
