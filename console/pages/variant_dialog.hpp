// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <functional>

#include "console/models/lessons_model.hpp"
#include "console/models/variant.hpp"
#include "console/widgets/live_form.hpp"

namespace swage::console {

/// An instructor's own lesson: another one with a title and values of its own. Nothing is written before the scene has been
/// built with those values.
class VariantDialog : public QDialog {
  Q_OBJECT
 public:
  /// Builds the lesson with values; "" when it can be practised, else why not.
  using Check = std::function<QString(const QVector<std::pair<std::string, std::string>>& set)>;

  /// A new lesson below `folder`, based on `lesson`.
  VariantDialog(const LessonEntry& lesson, const QVector<LiveParam>& params, Check check, const QString& folder,
                QWidget* parent);
  /// Edits `lesson` itself, one of one's own.
  VariantDialog(const LessonEntry& lesson, const QVector<LiveParam>& params, Check check, QWidget* parent);
  /// Values that an attempt was adjusted to are in the form from the start.
  void preset(const QVector<LiveForm::Change>& values);
  /// After Save: the file.
  QString saved() const { return saved_; }

 private:
  QWidget* make_words(const LessonEntry& base);
  QWidget* make_values(const QVector<LiveParam>& params);
  QWidget* make_buttons();
  void update_state();
  void save();

  QString write(const QVector<std::pair<std::string, std::string>>& set);  // "" or why not

  LessonEntry lesson_;
  QString folder_, saved_;  // no folder: the lesson itself is edited
  int preset_ = 0;
  Check check_;
  QLineEdit *title_ = nullptr, *summary_ = nullptr, *find_ = nullptr;
  QPlainTextEdit* goal_ = nullptr;
  LiveForm* form_ = nullptr;
  QLabel *problem_ = nullptr, *none_ = nullptr;
  QPushButton* save_ = nullptr;
};

}  // namespace swage::console
