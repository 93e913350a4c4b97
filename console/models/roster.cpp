// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/roster.hpp"

#include <QCoreApplication>
#include <QSet>
#include <string>
#include <vector>

#include "record/people_list.hpp"

namespace swage::console {
namespace {

constexpr int kLongest = 80;  // a longer name, in characters, is a paragraph pasted by mistake

class RosterWords {
  Q_DECLARE_TR_FUNCTIONS(roster)
};

/// The cells of one line; a separator within quotes belongs to the cell, and two quotes are one.
QStringList cells(const QString& line, QChar separator) {
  QStringList out = {QString()};
  bool quoted = false;
  for (qsizetype i = 0; i < line.size(); ++i) {
    const QChar c = line[i];
    if (c == QLatin1Char('"') && quoted && i + 1 < line.size() && line[i + 1] == c)
      out.last() += line[++i];
    else if (c == QLatin1Char('"'))
      quoted = !quoted;
    else if (c == separator && !quoted)
      out += QString();
    else
      out.last() += c;
  }
  for (QString& cell : out) cell = cell.simplified();
  return out;
}

QChar separator_of(const QString& line) {
  for (const char c : {'\t', ';', ','})
    if (line.contains(QLatin1Char(c))) return QLatin1Char(c);
  return QLatin1Char(',');
}

using Column = record::ListColumn;

/// "left", "right", "" for nothing; false for anything else.
bool read_hand(const QString& cell, QString& hand) {
  const QString word = cell.toLower();
  if (word.isEmpty()) return true;
  if (QStringLiteral("left").startsWith(word) || QStringLiteral("links").startsWith(word)) return hand = QStringLiteral("left"), true;
  if (QStringLiteral("right").startsWith(word) || QStringLiteral("rechts").startsWith(word)) return hand = QStringLiteral("right"), true;
  return false;
}

RosterLine read_line(const QStringList& line, const QVector<Column>& order) {
  RosterLine out;
  QString hand, last;
  for (qsizetype i = 0; i < std::min(line.size(), order.size()); ++i) {
    if (order[i] == Column::kName || order[i] == Column::kFirst) out.name = line[i];
    if (order[i] == Column::kLast) last = line[i];
    if (order[i] == Column::kGroup) out.group = line[i];
    if (order[i] == Column::kHand) hand = line[i];
    if (order[i] == Column::kCode) out.code = line[i];
  }
  out.name = QStringLiteral("%1 %2").arg(out.name, last).trimmed();
  if (!read_hand(hand, out.hand)) out.is = RosterLine::Is::kFaulty, out.says = RosterWords::tr("\"%1\" is neither left nor right").arg(hand);
  if (out.name.isEmpty()) out.is = RosterLine::Is::kFaulty, out.says = RosterWords::tr("No name");
  if (out.name.size() > kLongest) out.is = RosterLine::Is::kFaulty, out.says = RosterWords::tr("Longer than %1 characters").arg(kLongest);
  return out;
}

}  // namespace

QVector<RosterLine> read_roster(const QString& text, const QStringList& known, QStringList* left_out) {
  QVector<RosterLine> out;
  QStringList lines = text.split(QLatin1Char('\n'));
  lines.removeIf([](const QString& line) { return line.trimmed().isEmpty(); });
  if (lines.isEmpty()) return out;
  const QChar separator = separator_of(lines.first());
  std::vector<std::string> titles;
  for (const QString& title : cells(lines.first(), separator)) titles.push_back(title.toStdString());
  const record::ListHead head = record::read_list_head(titles);
  if (!head.columns.empty()) lines.removeFirst();
  const std::vector<Column> columns = head.columns.empty() ? record::usual_columns() : head.columns;
  const QVector<Column> order(columns.begin(), columns.end());
  for (const std::string& title : head.left_out)
    if (left_out) *left_out += QString::fromStdString(title);
  QSet<QString> names, there;
  for (const QString& name : known) there += name.toCaseFolded();
  for (const QString& text_line : lines) {
    RosterLine line = read_line(cells(text_line, separator), order);
    const QString key = line.name.toCaseFolded();
    if (line.is == RosterLine::Is::kNew && there.contains(key))
      line.is = RosterLine::Is::kKnown, line.says = RosterWords::tr("Is there already");
    else if (line.is == RosterLine::Is::kNew && names.contains(key))
      line.is = RosterLine::Is::kTwice, line.says = RosterWords::tr("Twice in the list");
    names += key;
    out += line;
  }
  return out;
}

}  // namespace swage::console
