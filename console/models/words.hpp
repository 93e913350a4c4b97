// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Text forms of ids, units, quantities and verdicts.
#pragma once

#include <QDate>
#include <QString>
#include <string_view>

namespace swage::console {

/// "grasp.peak_force" -> "Grasp peak force".
QString human_id(const QString& id);
/// 0.0012 m -> "1.20 mm", 0.2 rad -> "11.5°", 3 of unit "1" -> "3"; "–" for NaN and infinity.
QString quantity_text(double value, const QString& unit);
/// A unit as people write it: "um2" -> "µm²", "deg" -> "°"; "" for a pure number.
QString unit_text(std::string_view unit);
/// "20" and "um" -> "20 µm": a number with a unit of base/quantity.hpp.
QString with_unit(const QString& number, std::string_view unit);
/// The factor to the display unit of a quantity, and that unit: m -> 1000, mm.
double display_factor(const QString& unit);
QString display_unit(const QString& unit);
/// The end of an axis that contains `value`: rounded up to a round number.
double nice_end(double value);
/// 62.4 -> "01:02".
QString clock_text(double seconds);
/// The clock over a replayed picture: where it is, and where it is going while a large jump takes seconds to compute.
QString replay_clock(double shown_s, double wanted_s);
/// A person's name; the stored name "Guest", the same in every language, is translated.
QString person_text(const QString& name);
/// "passed" -> "Passed", "failed" -> "Not passed", "void" -> "Void", "aborted" -> "Stopped".
QString verdict_text(const QString& outcome);
/// "practice", "test", "demo" as text.
QString mode_text(const QString& mode);
/// A caveat on the numbers of an attempt (record::AttemptRow::remark), in the language of the window.
QString remark_text(const QString& remark);
/// "29 Nov 2026": a date that reads alike wherever people write the day first or the month.
QString date_text(const QDate& date);
/// "2026-11-21T09:30:00Z" -> "21 Nov 2026 10:30" in local time.
QString when_text(const QString& utc);

}  // namespace swage::console
