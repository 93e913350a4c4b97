// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Setup page: what is set once for a room and its people, and the equipment. Sections are cards, added by whoever has one.
#pragma once

#include <QComboBox>
#include <QGridLayout>
#include <QVBoxLayout>
#include <QWidget>

#include "console/cues/cue_theme.hpp"
#include "console/cues/ui_theme.hpp"

namespace swage::console {

class SetupPage : public QWidget {
  Q_OBJECT
 public:
  explicit SetupPage(QWidget* parent = nullptr);
  /// A card with a heading; the section is laid into it. Sections stand in two columns, in the order of their coming.
  void add_section(const QString& heading, QWidget* section);
  void show_themes(const QString& ui, const QString& cues);

 Q_SIGNALS:
  void themes_chosen(const QString& ui, const QString& cues);
  void trainee_view();
  void trainee_settings();

 private:
  QWidget* make_colours();
  QWidget* make_trainee();

  QVBoxLayout* columns_[2];
  int sections_ = 0;
  QComboBox *theme_ = nullptr, *cues_ = nullptr;
};

}  // namespace swage::console
