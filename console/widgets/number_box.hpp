// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace swage::console {

/// A number with a unit, which may be typed in any unit of the same quantity: "2500 um" in a field of mm becomes 2.5 mm. With a decimal point
/// or the language's own decimal mark. A value beyond the range becomes the limit, what is no value is taken back, and both are told.
/// [main] Units: host/units.hpp.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT
 public:
  /// `unit`: that of the number shown, a symbol of the table ("mm"; "1" for a pure number).
  NumberBox(const QString& unit, QWidget* parent = nullptr);

  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;
  void fixup(QString& text) const override;
  /// Keys of undo are left to the window around the field.
  bool event(QEvent* event) override;

 Q_SIGNALS:
  /// What was typed is not what is there now: why, as a sentence.
  void refused(const QString& words) const;

 private:
  /// The number in the unit shown; none where the text is no value of this quantity.
  std::optional<double> read(const QString& text) const;
  QString with_unit(double value) const;
  QString body(QString text) const;  // without prefix and suffix

  QString unit_;
};

}  // namespace swage::console
