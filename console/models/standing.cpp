// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/standing.hpp"

#include <QCoreApplication>
#include <QSet>
#include <algorithm>

#include "console/models/attempts_model.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"

namespace swage::console {
namespace {

constexpr int kStuck = 3;         // fewer failures in a row are a normal part of learning
constexpr int kWeek = 7;          // days; retention drops visibly after about a week without practice
constexpr int kMostWeeks = 4;     // a person who left for good must not stay at the top of the list
constexpr int kReady = 3;         // passed attempts in a row after which a test is due

class StandingWords {
  Q_DECLARE_TR_FUNCTIONS(standing)
};

// "failed.dropped" -> its translation, else "Dropped"
QString short_reason(const QString& id) {
  const QString words = said(id);
  return words != id ? words : human_id(id.section(QLatin1Char('.'), -1));
}

}  // namespace

Standing standing_of(const std::vector<const record::AttemptRow*>& newest_first, const QDateTime& now) {
  Standing out;
  QSet<QString> passed_lessons;
  bool ends = true;  // still in the run of failures at the end
  QString newest_lesson;
  for (const record::AttemptRow* a : newest_first) {
    if (out.last_utc.isEmpty() && !is_hand(*a)) {
      out.last_utc = QString::fromStdString(a->started_utc);
      out.lesson = said(a->lesson_title.empty() ? a->lesson_id : a->lesson_title);
      const QDateTime when = QDateTime::fromString(out.last_utc, Qt::ISODate);
      out.days = when.isValid() ? std::max<int>(0, static_cast<int>(when.daysTo(now))) : 0;
    }
    if (!counts(*a)) continue;
    const bool passed = a->outcome == "passed";
    const QString lesson = QString::fromStdString(a->lesson_id), reason = QString::fromStdString(a->reason);
    ++out.attempts;
    out.passed += passed;
    if (passed) passed_lessons += lesson;
    if (out.last.size() < kLastShown) out.last.prepend(passed);
    if (out.attempts == 1) newest_lesson = lesson, out.same_reason = reason;
    ends = ends && !passed && lesson == newest_lesson;
    if (!ends) continue;
    ++out.failing;
    if (reason != out.same_reason) out.same_reason.clear();
  }
  out.lessons_passed = static_cast<int>(passed_lessons.size());
  if (out.failing == 0) out.same_reason.clear();
  return out;
}

double attention(const Standing& s) {
  const int stuck = std::max(0, s.failing - kStuck + 1);
  const int weeks = s.attempts > 0 ? std::min(s.days / kWeek, kMostWeeks) : 0;
  return stuck * (s.same_reason.isEmpty() ? 1 : 2) + weeks;
}

QString attention_words(const Standing& s) {
  QStringList words;
  if (s.failing >= kStuck)
    words += s.same_reason.isEmpty()
                 ? StandingWords::tr("%1 not passed in a row").arg(s.failing)
                 : StandingWords::tr("%1 not passed in a row: %2").arg(s.failing).arg(short_reason(s.same_reason));
  if (s.attempts > 0 && s.days >= kWeek) words += StandingWords::tr("%1 days without practice").arg(s.days);
  if (!words.isEmpty()) return words.join(StandingWords::tr(", "));
  const auto n = s.last.size();
  if (n >= kReady && std::all_of(s.last.end() - kReady, s.last.end(), [](bool b) { return b; })) return StandingWords::tr("doing well");
  return {};
}

}  // namespace swage::console
