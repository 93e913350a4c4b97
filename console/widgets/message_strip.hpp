// SPDX-License-Identifier: LGPL-3.0-or-later
//
// An instructor's message to this station: a line below the pages, beside the picture, until it is answered by key or button.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <vector>

#include "record/stations.hpp"

namespace swage::console {

class MessageStrip : public QFrame {
  Q_OBJECT
 public:
  explicit MessageStrip(QWidget* parent = nullptr);
  /// Oldest first; the first one is shown.
  void set_messages(const std::vector<record::StationMessage>& messages);
  /// While an attempt runs a lesson cannot be accepted.
  void set_running(bool running);
  /// The text for the trainee's view, with the answering key; "" without a message.
  QString words() const;

 public Q_SLOTS:
  /// Marks the message as read, or accepts the lesson.
  void accept();
  void decline();

 Q_SIGNALS:
  void changed();
  void answered(const swage::record::StationMessage& message, bool accepted);

 private:
  void show_first();
  std::vector<record::StationMessage> messages_;
  QLabel* text_;
  QPushButton *accept_, *decline_;
  bool running_ = false;
};

}  // namespace swage::console
