// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Setup page: settings of the room and its people, and the equipment. Sections are cards, added by the parts of the program.
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
  /// Adds a card with a heading around the section. Cards are laid out in two columns, in the order of the calls.
  void add_section(const QString& heading, QWidget* section);
  /// Names of the station and of its store: a file or a server's address; "" for none.
  void show_place(const QString& station, const QString& store);
  void show_themes(const QString& ui, const QString& cues);
  /// The available languages, their own names, and the chosen one; "" for the system's.
  void show_languages(const QStringList& codes, const QStringList& names, const QString& chosen);
  /// Lists the devices for a person's hand, to be bound to a person's instrument.
  void set_devices(const std::vector<const host::PluginInfo*>& devices);
  void show_binding(const Binding& binding, const QString& person);
  /// Shows the stored sensor calibrations, a sentence each.
  void show_calibrations(const QStringList& lines);

 Q_SIGNALS:
  void themes_chosen(const QString& ui, const QString& cues);
  void language_chosen(const QString& code);
  void trainee_view();
  void trainee_settings();
  void station_settings();
  void calibrate_sensor();
  void binding_chosen(const Binding& binding);

 private:
  QWidget* make_colours();
  QWidget* make_language();
  QWidget* make_trainee();
  QWidget* make_sensors();
  QWidget* make_instrument();
  void enable_bindings();

  QVBoxLayout* columns_[2];
  int sections_ = 0;
  QLabel *calibrations_ = nullptr, *whose_ = nullptr, *place_ = nullptr;
  QComboBox *pose_ = nullptr, *jaws_ = nullptr, *clutch_ = nullptr, *pedal_ = nullptr;
  QComboBox *theme_ = nullptr, *cues_ = nullptr, *language_ = nullptr;
};

}  // namespace swage::console
