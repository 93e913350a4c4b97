// SPDX-License-Identifier: Apache-2.0
//
// Rating scales of surgeons: each item is computed from metrics, where the state of a scene can decide it. Pure
// functions. [any]
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "judge/pass_rule.hpp"

namespace swage::judge {

/// Text in several languages: code ("en", "de"), text. The first one is English.
using Words = std::vector<std::pair<std::string, std::string>>;
/// The text in `language`, else the English one.
const std::string& said_in(const Words& words, const std::string& language);

/// A metric as a part of an item: top of the scale at `best`, bottom at `worst`, linear between them. In its SI unit.
struct RatedBy {
  std::string metric, unit;
  double best = 0, worst = 1;
  bool of_failed = false;  // decides the item of a failed attempt only; see RatingItem
};

/// An item is the mean of its metrics; without metrics it is left to an observer. Of a failed attempt no lost points are told
/// ("points.wound"): what is left would be a mean without the errors. An item with such metrics is then the lowest of those marked
/// of_failed, and not decided without them.
struct RatingItem {
  std::string id;
  Words title;
  std::vector<RatedBy> by;
  bool is_product = false;  // rates the product: bottom of the scale where the attempt failed
};

struct RatingScale {
  std::string id;
  Words title;
  Words source;  // where the scale comes from and what is assumed of it; a single text counts as English
  double lowest = 1, highest = 5;  // of each item
  std::vector<std::string> needs;  // metrics without which the scale does not apply to an attempt
  std::vector<RatingItem> items;
};

/// Rating of one attempt.
struct Rating {
  std::vector<std::optional<double>> item;  // as RatingScale::items; empty: the attempt does not decide the item
  std::size_t decided = 0;
  double mean = 0;  // over the decided items; 0 when there are none
};

/// A missing metric, or one that is not a number, decides nothing. `passed`: the attempt's own verdict.
Rating rate(const RatingScale& scale, Metrics metrics, bool passed);

}  // namespace swage::judge
