// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What an instructor says to this station: a line below the pages, over nothing of the work, until it is answered by a key or button.
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
  /// Oldest first; the first is shown.
  void set_messages(const std::vector<record::StationMessage>& messages);
  /// A lesson is taken between two attempts.
  void set_running(bool running);
  /// As it stands in the trainee's view, with the key that answers; "" when nothing is said.
  QString words() const;

 public Q_SLOTS:
  /// Read, or the lesson taken.
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
