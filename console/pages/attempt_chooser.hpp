// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Asks for one of the attempts at a lesson, with a search, for comparison.
#pragma once

#include <QDialog>
#include <QListWidget>
#include <string>
#include <vector>

#include "record/store.hpp"

namespace swage::console {

class AttemptChooser : public QDialog {
  Q_OBJECT
 public:
  /// `but`: the attempt that is not offered.
  AttemptChooser(const std::vector<record::AttemptRow>& attempts, const std::string& but, QWidget* parent);
  /// Id of the chosen attempt, "" for none.
  QString chosen() const;

 private:
  void search(const QString& text);
  QListWidget* list_;
};

}  // namespace swage::console
