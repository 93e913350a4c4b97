// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/number_box.hpp"

#include <QKeyEvent>
#include <QLocale>
#include <QRegularExpression>

#include <cstring>

#include "host/units.hpp"

namespace swage::console {
namespace {

// The symbol of the table for what a person writes.
QString symbol_of(QString typed) {
  typed.replace(QChar(0xb5), QLatin1Char('u')).replace(QChar(0x3bc), QLatin1Char('u'));
  typed.replace(QChar(0xb0), QLatin1String("deg")).replace(QChar(0xb7), QLatin1Char('*'));
  return typed.replace(QChar(0xb2), QLatin1Char('2')).replace(QChar(0xb3), QLatin1Char('3'));
}

// A comma or a point alone is the decimal mark: no field shows groups of thousands.
std::optional<double> number_of(QString digits) {
  bool good = false;
  const double value = digits.replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&good);
  return good ? std::optional(value) : std::nullopt;
}

}  // namespace

NumberBox::NumberBox(const QString& unit, QWidget* parent) : QDoubleSpinBox(parent), unit_(unit) {}

bool NumberBox::event(QEvent* event) {
  const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (key) {
    const auto* pressed = static_cast<QKeyEvent*>(event);
    if (pressed->matches(QKeySequence::Undo) || pressed->matches(QKeySequence::Redo)) return event->ignore(), true;
  }
  return QDoubleSpinBox::event(event);
}

QString NumberBox::body(QString text) const {
  if (!prefix().isEmpty() && text.startsWith(prefix())) text.remove(0, prefix().size());
  if (!suffix().isEmpty() && text.endsWith(suffix())) text.chop(suffix().size());
  return text.trimmed();
}

std::optional<double> NumberBox::read(const QString& text) const {
  static const QRegularExpression form(QStringLiteral("^([+-]?[0-9]*[.,]?[0-9]*(?:[eE][+-]?[0-9]+)?)\\s*(\\S*)$"));
  const QRegularExpressionMatch m = form.match(body(text).replace(QChar(0x2212), QLatin1Char('-')));
  const std::optional<double> number = m.hasMatch() ? number_of(m.captured(1)) : std::nullopt;
  if (!number || m.captured(2).isEmpty()) return number;
  const host::Unit* own = host::find_unit(unit_.toStdString());
  const host::Unit* typed = host::find_unit(symbol_of(m.captured(2)).toStdString());
  if (!own || !typed || std::strcmp(own->si, typed->si) != 0) return {};
  return *number * typed->scale / own->scale;
}

double NumberBox::valueFromText(const QString& text) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) return minimum();
  return read(text).value_or(value());
}

QValidator::State NumberBox::validate(QString& text, int&) const {
  if (!specialValueText().isEmpty() && text == specialValueText()) return QValidator::Acceptable;
  const std::optional<double> number = read(text);
  return number && *number >= minimum() && *number <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
}

QString NumberBox::with_unit(double value) const {
  QLocale language;
  language.setNumberOptions(QLocale::OmitGroupSeparator);  // as in the field
  QString number = language.toString(value, 'f', decimals());
  const QString point = language.decimalPoint();
  while (number.contains(point) && (number.endsWith(QLatin1Char('0')) || number.endsWith(point))) {
    const bool whole = number.endsWith(point);
    number.chop(1);
    if (whole) break;
  }
  return number + suffix();
}

void NumberBox::fixup(QString& text) const {
  const std::optional<double> number = read(text);
  if (!number) {
    const QString typed = body(text);
    if (!typed.isEmpty()) Q_EMIT refused(tr("“%1” is no value here: as before, %2.").arg(typed, with_unit(value())));
    return;
  }
  const bool high = *number > maximum();
  const double limit = high ? maximum() : minimum();
  Q_EMIT refused((high ? tr("At most %1, not %2.") : tr("At least %1, not %2.")).arg(with_unit(limit), with_unit(*number)));
  text = prefix() + QLocale::c().toString(limit, 'f', decimals());
}

}  // namespace swage::console
