// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Explains a course's pass rule and limits in sentences.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "record/course.hpp"
#include "record/store.hpp"

namespace swage::console {

/// "Passed when 2 Test attempts in a row ..."; or the error in the rule.
QString rule_words(const judge::PassRule& rule);
/// The simulated result of the rule for trainees who succeed 5, 7 and 9 times in 10. Takes about a tenth of a second.
QStringList rule_odds(const judge::PassRule& rule);
/// How many expert attempts were passed and meet all limits together, and which limit fails most of them. "" without limits.
QString together_words(const std::vector<judge::Limit>& limits, const std::vector<const record::AttemptRow*>& experts);
/// Suggests a limit that all but the worst tenth of the experts' passed attempts meet. False without values or a direction.
bool suggest_limit(judge::Limit& limit, const std::vector<const record::AttemptRow*>& experts, int32_t better);

}  // namespace swage::console
