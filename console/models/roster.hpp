// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A pasted list of people, one per line or CSV, parsed for a preview.
#pragma once

#include <QString>
#include <QStringList>
#include <QVector>

namespace swage::console {

struct RosterLine {
  enum class Is { kNew, kKnown, kTwice, kFaulty };
  Is is = Is::kNew;
  QString name, group, hand, code;  // hand: "left", "right" or ""; code: the pseudonymous id, "" for a generated one
  QString says;                     // why the person is not added; "" for a new person
};

/// Columns are separated by tabs, semicolons or commas, whichever the first line has. A first line with the words name, group, hand, id
/// gives their order; without it that is the order. `known`: existing names. `left_out`: titles of columns that are not known.
QVector<RosterLine> read_roster(const QString& text, const QStringList& known, QStringList* left_out = nullptr);

}  // namespace swage::console
