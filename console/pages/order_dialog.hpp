// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The question about a lesson whose turn has not come in a course of the person. [main]
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QPushButton>

namespace swage::console {

class OrderDialog : public QDialog {
  Q_OBJECT
 public:
  enum class Answer { kCancel, kToTheFirst, kBegin };
  /// `why`: which lesson comes first. `first`: its title, "" where it is not installed. `test`: an attempt that counts is to be begun, which
  /// an instructor opens with a reason; else practice, which needs none.
  OrderDialog(const QString& why, const QString& first, bool test, QWidget* parent);
  Answer answer() const { return answer_; }
  QString reason() const;  // of the instructor; "" in practice

 private:
  QPushButton* add_button(const QString& words, const char* name, Answer answer);
  Answer answer_ = Answer::kCancel;
  QComboBox* reason_ = nullptr;
};

}  // namespace swage::console
