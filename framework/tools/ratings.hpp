// SPDX-License-Identifier: Apache-2.0
//
// Ratings of an attempt on published scales of surgeons, for the verbs that report attempts. [main]
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "judge/rating.hpp"
#include "judge/verdict.hpp"

namespace swage::tools {

/// [{"id", "title", "source", "lowest", "highest", "mean", "items": [{"id", "title", "points"}]}], null for a rating that the attempt
/// does not determine. Empty for an attempt that was stopped from outside, and where no scales are installed.
nlohmann::ordered_json ratings_json(judge::Outcome outcome, judge::Metrics metrics);

/// A line for each scale with at least one rating: "  SMaRT: 4.6 of 5 over 6 of 9 items". "" where there is none.
std::string ratings_text(judge::Outcome outcome, judge::Metrics metrics);

}  // namespace swage::tools
