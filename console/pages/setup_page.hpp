// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Setup page: what is set once for a room and its people, and the equipment. Sections are cards, added by whoever has one.
#pragma once

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>

#include "console/cues/cue_theme.hpp"
#include "console/cues/ui_theme.hpp"
#include "console/models/instrument.hpp"

namespace swage::console {

class SetupPage : public QWidget {
  Q_OBJECT
 public:
  explicit SetupPage(QWidget* parent = nullptr);
  /// A card with a heading; the section is laid into it. Sections stand in two columns, in the order of their coming.
  void add_section(const QString& heading, QWidget* section);
  void show_themes(const QString& ui, const QString& cues);
  /// What a person can hold, and what leads the instrument of whom.
  void set_devices(const std::vector<const host::PluginInfo*>& devices);
  void show_binding(const Binding& binding, const QString& person);
  /// What is stored of sensors, a sentence each.
  void show_calibrations(const QStringList& lines);

 Q_SIGNALS:
  void themes_chosen(const QString& ui, const QString& cues);
  void trainee_view();
  void trainee_settings();
  void station_settings();
  void calibrate_sensor();
  void binding_chosen(const Binding& binding);

 private:
  QWidget* make_colours();
  QWidget* make_trainee();
  QWidget* make_sensors();
  QWidget* make_instrument();
  void enable_bindings();

  QVBoxLayout* columns_[2];
  int sections_ = 0;
  QLabel *calibrations_ = nullptr, *whose_ = nullptr;
  QComboBox *pose_ = nullptr, *jaws_ = nullptr, *clutch_ = nullptr, *pedal_ = nullptr;
  QComboBox *theme_ = nullptr, *cues_ = nullptr;
};

}  // namespace swage::console
