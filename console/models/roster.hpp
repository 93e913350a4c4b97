// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A list of people as somebody pastes it, a line each or a CSV, told as it would be added.
#pragma once

#include <QString>
#include <QStringList>
#include <QVector>

namespace swage::console {

struct RosterLine {
  enum class Is { kNew, kKnown, kTwice, kFaulty };
  Is is = Is::kNew;
  QString name, group, hand, code;  // hand: "left", "right" or ""; code: the pseudonymous id, "" to have one made
  QString says;                     // why it is not added; "" for a new one
};

/// Columns part at tabs, semicolons or commas, whichever the first line has. A first line of the words name, group, hand, id
/// says their order; without it that is the order. `known`: the names that are there already.
QVector<RosterLine> read_roster(const QString& text, const QStringList& known);

}  // namespace swage::console
