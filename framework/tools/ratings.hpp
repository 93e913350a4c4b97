// SPDX-License-Identifier: Apache-2.0
//
// An attempt on the rating scales of surgeons, for the verbs that tell of attempts. [main]
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "judge/rating.hpp"
#include "judge/verdict.hpp"

namespace swage::tools {

/// [{"id", "title", "source", "lowest", "highest", "mean", "items": [{"id", "title", "points"}]}], null for what the attempt does not
/// decide. Empty for an attempt that did not end by itself, and where no scales are installed.
nlohmann::ordered_json ratings_json(judge::Outcome outcome, judge::Metrics metrics);

/// A line for each scale of which something is decided: "  SMaRT: 4.6 of 5 over 6 of 9 items". "" where there is none.
std::string ratings_text(judge::Outcome outcome, judge::Metrics metrics);

}  // namespace swage::tools
