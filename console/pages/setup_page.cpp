// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/setup_page.hpp"

#include <QFormLayout>
#include <QHBoxLayout>
#include <algorithm>

#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kColumn_px = 560;  // longer lines are hard to read

QComboBox* make_choice(const QString& label, const char* name, const QString& tip, QFormLayout* form) {
  auto* choice = new QComboBox;
  choice->setObjectName(QString::fromLatin1(name));
  choice->setAccessibleName(label);
  choice->setToolTip(tip);
  form->addRow(label, choice);
  return choice;
}

}  // namespace

SetupPage::SetupPage(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 10, 12, 10);
  row->setSpacing(12);
  for (QVBoxLayout*& column : columns_) {
    auto* box = new QWidget(this);
    box->setMaximumWidth(kColumn_px);
    column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addStretch(1);
    row->addWidget(box, 1);
  }
  row->addStretch(0);
  add_section(tr("Colours"), make_colours());
  add_section(tr("Trainee's view"), make_trainee());
  add_section(tr("Instrument"), make_instrument());
  add_section(tr("Jaw sensors"), make_sensors());
  add_section(tr("Language"), make_language());
  place_ = make_muted({}, this);
  place_->setObjectName(QStringLiteral("setup_place"));
  place_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  add_section(tr("This station"), place_);
}

void SetupPage::add_section(const QString& heading, QWidget* section) {
  Card card = make_card(heading, this);
  card.body->addWidget(section);
  QVBoxLayout* column = columns_[sections_++ % 2];
  column->insertWidget(column->count() - 1, card.frame);
}

QWidget* SetupPage::make_colours() {
  auto* box = new QWidget(this);
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  theme_ = make_choice(tr("Theme"), "theme", tr("Colours of the window"), form);
  for (const QString& id : UiTheme::names()) theme_->addItem(UiTheme::stock(id).title(), id);
  cues_ = make_choice(tr("Cue colours"), "cue_theme", tr("Colours of the cues; shapes, words and sounds stay the same"),
                      form);
  for (const QString& id : CueTheme::stock()) cues_->addItem(CueTheme::stock(id).title(), id);
  for (QComboBox* choice : {theme_, cues_}) {
    connect(choice, &QComboBox::activated, this,
            [this] { Q_EMIT themes_chosen(theme_->currentData().toString(), cues_->currentData().toString()); });
  }
  return box;
}

QWidget* SetupPage::make_language() {
  auto* box = new QWidget(this);
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  language_ = make_choice(tr("Window"), "language", tr("What the window is written in, from the next start on"), form);
  language_->addItem(tr("As the system"), QString());
  form->addRow(make_muted(tr("From the next start on."), box));
  connect(language_, &QComboBox::activated, this, [this] { Q_EMIT language_chosen(language_->currentData().toString()); });
  return box;
}

void SetupPage::show_languages(const QStringList& codes, const QStringList& names, const QString& chosen) {
  for (qsizetype i = 0; i < codes.size(); ++i) language_->addItem(names[i], codes[i]);
  language_->setCurrentIndex(std::max(0, language_->findData(chosen)));
}

QWidget* SetupPage::make_trainee() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(make_muted(tr("The scene for two eyes, in a window of its own for the trainee's screen."), box));
  auto* row = new QHBoxLayout;
  auto* open = make_button(tr("Open, close"), QStringLiteral("F9"), QStringLiteral("setup_trainee"), box);
  auto* settings = make_button(tr("Screen, layout, eyes…"), {}, QStringLiteral("setup_trainee_options"), box);
  give_key(settings, QStringLiteral("Ctrl+D"));
  connect(open, &QPushButton::clicked, this, &SetupPage::trainee_view);
  connect(settings, &QPushButton::clicked, this, &SetupPage::trainee_settings);
  row->addWidget(open);
  row->addWidget(settings);
  row->addStretch(1);
  column->addLayout(row);
  column->addWidget(make_muted(tr("10 mm shown as 10 mm, and hand and tool in one place: by a ruler, and with an arm at four marks."), box));
  auto* station = make_button(tr("True size and place…"), {}, QStringLiteral("setup_station"), box);
  give_key(station, QStringLiteral("Ctrl+T"));
  connect(station, &QPushButton::clicked, this, &SetupPage::station_settings);
  auto* second = new QHBoxLayout;
  second->addWidget(station);
  second->addStretch(1);
  column->addLayout(second);
  return box;
}

QWidget* SetupPage::make_instrument() {
  auto* box = new QWidget(this);
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  whose_ = make_muted({}, box);
  form->addRow(whose_);
  pose_ = make_choice(tr("Pose from"), "binding_pose", tr("The device that says where the instrument is"), form);
  jaws_ = make_choice(tr("Jaws from"), "binding_jaws", tr("The device that says how far the jaws are closed, and how hard"), form);
  clutch_ = make_choice(tr("Clutch"), "binding_clutch",
                        tr("While this button or pedal is down the tool stands still; afterwards it goes on from there"), form);
  clutch_->addItem(tr("None"), -1);
  for (int i = 0; i < 16; ++i) clutch_->addItem(tr("Button %1").arg(i + 1), i);
  pedal_ = make_choice(tr("Clutch of"), "binding_pedal", tr("The device whose button or pedal that is"), form);
  for (QComboBox* choice : {pose_, jaws_, clutch_, pedal_})
    connect(choice, &QComboBox::activated, this, [this] {
      enable_bindings();
      Q_EMIT binding_chosen({pose_->currentData().toString().toStdString(), jaws_->currentData().toString().toStdString(),
                             clutch_->currentData().toInt(), pedal_->currentData().toString().toStdString()});
    });
  auto* pedal = make_muted(tr("A pedal that sends the keys F5, F6 and F7 starts, pauses and puts back without letting go of the instrument."), box);
  form->addRow(pedal);
  return box;
}

void SetupPage::set_devices(const std::vector<const host::PluginInfo*>& devices) {
  for (QComboBox* choice : {pose_, jaws_, pedal_}) choice->clear();
  pose_->addItem(tr("As the lesson says"), QString());
  for (QComboBox* choice : {jaws_, pedal_}) choice->addItem(tr("The same device"), QString());
  for (const host::PluginInfo* plugin : devices)
    for (QComboBox* choice : {pose_, jaws_, pedal_}) choice->addItem(said(plugin->name, plugin->bundle_dir), QString::fromStdString(plugin->id));
}

void SetupPage::show_binding(const Binding& binding, const QString& person) {
  whose_->setText(tr("Of %1, at this computer").arg(person_text(person)));
  pose_->setCurrentIndex(std::max(0, pose_->findData(QString::fromStdString(binding.pose))));
  jaws_->setCurrentIndex(std::max(0, jaws_->findData(QString::fromStdString(binding.jaws))));
  clutch_->setCurrentIndex(std::max(0, clutch_->findData(binding.clutch)));
  pedal_->setCurrentIndex(std::max(0, pedal_->findData(QString::fromStdString(binding.pedal))));
  enable_bindings();
}

void SetupPage::enable_bindings() {
  const bool any = pose_->currentIndex() > 0;
  jaws_->setEnabled(any);
  clutch_->setEnabled(any);
  pedal_->setEnabled(any && clutch_->currentIndex() > 0);
}

QWidget* SetupPage::make_sensors() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  calibrations_ = new QLabel(box);
  calibrations_->setObjectName(QStringLiteral("setup_calibrations"));
  calibrations_->setWordWrap(true);
  column->addWidget(calibrations_);
  auto* row = new QHBoxLayout;
  auto* calibrate = make_button(tr("Calibrate…"), {}, QStringLiteral("setup_calibrate"), box);
  calibrate->setToolTip(tr("What the volts of a sensor in a needleholder's handle mean: thirteen lengths on a bench, and three poses"));
  give_key(calibrate, QStringLiteral("Ctrl+K"));
  connect(calibrate, &QPushButton::clicked, this, &SetupPage::calibrate_sensor);
  row->addWidget(calibrate);
  row->addStretch(1);
  column->addLayout(row);
  show_calibrations({});
  return box;
}

void SetupPage::show_calibrations(const QStringList& lines) {
  calibrations_->setText(lines.isEmpty() ? tr("No sensor is calibrated on this computer.") : lines.join(QLatin1Char('\n')));
}

void SetupPage::show_place(const QString& station, const QString& store) {
  place_->setText(tr("Station: %1").arg(station) + QLatin1Char('\n') +
                  (store.isEmpty() ? tr("No store: nothing is kept.") : tr("Store: %1").arg(store)));
}

void SetupPage::show_themes(const QString& ui, const QString& cues) {
  theme_->setCurrentIndex(theme_->findData(ui));
  cues_->setCurrentIndex(cues_->findData(cues));
}

}  // namespace swage::console
