// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The parts of an edited lesson: its objects, couplings and devices, with buttons to add and remove.
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>

#include "console/models/lesson_draft.hpp"
#include "host/catalogue.hpp"

class QFormLayout;

namespace swage::console {

/// Asks for a new part: its plugin and name; for an object its position and the object that it follows; for a coupling its two objects.
class PartDialog : public QDialog {
  Q_OBJECT
 public:
  PartDialog(LessonPart::Kind kind, const LessonDraft& draft, const host::Catalogue& catalogue, QWidget* parent);
  /// The part as in a lesson file.
  nlohmann::ordered_json part() const;

 private:
  void add_place();
  void add_pair();
  void check();

  LessonPart::Kind kind_;
  const LessonDraft& draft_;
  QVector<LessonPart> parts_;
  QFormLayout* form_;
  QComboBox *plugin_, *follows_ = nullptr, *a_ = nullptr, *b_ = nullptr;
  QLineEdit* name_;
  QVector<QDoubleSpinBox*> at_;  // mm
  QLabel* problem_;
  QPushButton* add_;
};

class PartsPanel : public QFrame {
  Q_OBJECT
 public:
  /// Both outlive the panel.
  PartsPanel(LessonDraft* draft, const host::Catalogue* catalogue, QWidget* parent);
  /// Reads the draft again.
  void refresh();

 public Q_SLOTS:
  void add(swage::console::LessonPart::Kind kind);
  void remove();

 Q_SIGNALS:
  /// A side effect of the last action, as a sentence; "" for none.
  void told(const QString& words);

 private:
  LessonDraft* draft_;
  const host::Catalogue* catalogue_;
  QListWidget* list_;
  QPushButton* remove_;
};

}  // namespace swage::console
