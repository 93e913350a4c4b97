// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a course's rule and limits mean, in sentences.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "record/course.hpp"
#include "record/store.hpp"

namespace swage::console {

/// "Passed when 2 Test attempts in a row ..."; or what is wrong with the rule.
QString rule_words(const judge::PassRule& rule);
/// What the rule does with a trainee who succeeds 5, 7 and 9 times in 10, simulated. Takes about a tenth of a second.
QStringList rule_odds(const judge::PassRule& rule);
/// How many expert attempts were passed and meet all limits together, and which limit costs most of them. "" without limits.
QString together_words(const std::vector<judge::Limit>& limits, const std::vector<const record::AttemptRow*>& experts);
/// The limit that the values of experts' passed attempts suggest: all but the worst tenth of them keep it. Nothing without values or a direction.
bool suggest_limit(judge::Limit& limit, const std::vector<const record::AttemptRow*>& experts, int32_t better);

}  // namespace swage::console
