// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/roster.hpp"

#include <QCoreApplication>
#include <QSet>
#include <array>

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

enum Column { kName, kGroup, kHand, kCode, kNone };

Column column_of(const QString& word) {
  static const std::array<QStringList, 4> words = {
      QStringList{QStringLiteral("name"), QStringLiteral("trainee"), QStringLiteral("student")},
      QStringList{QStringLiteral("group"), QStringLiteral("gruppe"), QStringLiteral("cohort"), QStringLiteral("class")},
      QStringList{QStringLiteral("hand"), QStringLiteral("handedness")},
      QStringList{QStringLiteral("id"), QStringLiteral("code"), QStringLiteral("pseudonym")}};
  for (size_t i = 0; i < words.size(); ++i)
    if (words[i].contains(word.toLower())) return static_cast<Column>(i);
  return kNone;
}

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
  QString hand;
  for (qsizetype i = 0; i < std::min(line.size(), order.size()); ++i) {
    if (order[i] == kName) out.name = line[i];
    if (order[i] == kGroup) out.group = line[i];
    if (order[i] == kHand) hand = line[i];
    if (order[i] == kCode) out.code = line[i];
  }
  if (!read_hand(hand, out.hand)) out.is = RosterLine::Is::kFaulty, out.says = RosterWords::tr("\"%1\" is neither left nor right").arg(hand);
  if (out.name.isEmpty()) out.is = RosterLine::Is::kFaulty, out.says = RosterWords::tr("No name");
  if (out.name.size() > kLongest) out.is = RosterLine::Is::kFaulty, out.says = RosterWords::tr("Longer than %1 characters").arg(kLongest);
  return out;
}

}  // namespace

QVector<RosterLine> read_roster(const QString& text, const QStringList& known) {
  QVector<RosterLine> out;
  QStringList lines = text.split(QLatin1Char('\n'));
  lines.removeIf([](const QString& line) { return line.trimmed().isEmpty(); });
  if (lines.isEmpty()) return out;
  const QChar separator = separator_of(lines.first());
  QVector<Column> order;
  for (const QString& word : cells(lines.first(), separator)) order += column_of(word);
  if (order.contains(kName))
    lines.removeFirst();
  else
    order = {kName, kGroup, kHand, kCode};
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
