// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/main_window.hpp"

#include <QApplication>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>
#include <optional>

#include "console/app/calibration_dialog.hpp"
#include "console/app/help_dialog.hpp"
#include "console/app/language.hpp"
#include "console/app/window_keys.hpp"
#include "console/widgets/parts.hpp"
#include "record/address.hpp"
#include "record/identity.hpp"

namespace swage::console {

MainWindow::MainWindow(Services services, const Launch& launch, QWidget* parent)
    : QMainWindow(parent),
      settings_(launch.settings_file.isEmpty() ? Settings() : Settings(launch.settings_file)),
      store_(std::move(services.open_store)),
      desk_(std::move(services.open_school)),
      stations_(new StationLink(this)) {
  setWindowTitle(tr("Swage"));
  lessons_.set_folders(launch.lesson_folders);
  make_parts(make_middle(), services);
  connect_setup();
  show_store(launch);
  fill_top_bar();
  add_keys();
  const GlProbe& gl = run_page()->view()->gl();
  strip_->set_graphics(gl.ok ? tr("Picture: %1").arg(gl.renderer.section(QLatin1Char('('), 0, 0).trimmed()) : tr("▲ No OpenGL"));
  restore(launch);
  open_given(launch);
  station_->start(std::move(services.open_stations), launch.station);
}

MainWindow::~MainWindow() = default;

Pages* MainWindow::make_middle() {
  auto* middle = new QWidget(this);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* pages = new Pages(middle);
  strip_ = new StatusStrip(middle);
  messages_ = new MessageStrip(middle);
  column->addWidget(pages, 1);
  column->addWidget(messages_);
  column->addWidget(strip_);
  setCentralWidget(middle);
  return pages;
}

void MainWindow::make_parts(Pages* pages, Services& services) {
  const SharedModels models{&lessons_, &store_, &desk_, stations_};
  pages_ = std::make_unique<WindowPages>(services, models, strip_, pages, nullptr);
  trainee_ = std::make_unique<TraineePlace>(pages_.get(), settings_, this);
  place_ = std::make_unique<WindowPlace>(this, settings_);
  theme_ = std::make_unique<WindowTheme>(pages_.get(), settings_);
  memory_ = std::make_unique<RunMemory>(pages_.get(), &lessons_, settings_);
  frames_ = std::make_unique<FrameRate>(strip_, pages_.get(), settings_);
  requests_ = std::make_unique<LessonRequests>(pages_.get(), models);
  attempts_ = std::make_unique<AttemptOpener>(pages_.get(), &store_, this);
  station_ = std::make_unique<StationMessages>(pages_.get(), models, requests_.get(), messages_, trainee_.get());
  guard_ = std::make_unique<CloseGuard>(run_page(), settings_, this);
}

void MainWindow::connect_setup() {
  SetupPage* setup = setup_page();
  QStringList names;
  for (const QString& code : languages()) names += language_name(code);
  setup->show_languages(languages(), names, settings_.text("language"));
  connect(setup, &SetupPage::language_chosen, this, [this](const QString& code) { settings_.set("language", code); });
  connect(setup, &SetupPage::trainee_view, trainee_.get(), &TraineePlace::toggle);
  connect(setup, &SetupPage::trainee_settings, trainee_.get(), &TraineePlace::show_settings);
  connect(setup, &SetupPage::station_settings, trainee_.get(), &TraineePlace::show_station);
  connect(setup, &SetupPage::calibrate_sensor, this, &MainWindow::show_calibration);
}

// Without the password that a server's address may have.
void MainWindow::show_store(const Launch& launch) {
  const std::string& given = launch.options.store_path;
  const QString store = QString::fromStdString(given.empty() ? record::Store::default_path() : given);
  const bool server = record::is_postgres(launch.options.store_path);
  const QString station = launch.station.isEmpty() ? QString::fromStdString(record::station()) : launch.station;
  setup_page()->show_place(station, store == QLatin1String(":none:") ? QString()
                                    : server                         ? QUrl(store).toString(QUrl::RemovePassword)
                                                                     : store);
}

// What belongs to no page stands behind the pages' buttons.
void MainWindow::fill_top_bar() {
  QHBoxLayout* row = pages_->all()->bar();
  QWidget* bar = pages_->all()->bar_widget();
  row->addStretch(1);
  auto* trainee =
      make_keyed_button(tr("Trainee view"), QStringLiteral("F9"), QStringLiteral("trainee_button"), bar);
  trainee->setToolTip(tr("The scene for two eyes in a window of its own; on the Review page, the replay (F9)"));
  connect(trainee, &QPushButton::clicked, trainee_.get(), &TraineePlace::toggle);
  row->addWidget(trainee);
  auto* eyes = make_button(tr("Eyes…"), {}, QStringLiteral("trainee_options"), bar);
  eyes->setAccessibleName(tr("Settings of the trainee view"));
  eyes->setToolTip(tr("Settings of the trainee view: screen, layout, eyes"));
  connect(eyes, &QPushButton::clicked, trainee_.get(), &TraineePlace::show_settings);
  row->addWidget(eyes);
  row->addSpacing(4);
  auto* help = make_keyed_button(tr("Help"), QStringLiteral("F1"), QStringLiteral("help_button"), bar);
  connect(help, &QPushButton::clicked, this, &MainWindow::show_help);
  row->addWidget(help);
}

void MainWindow::add_keys() {
  auto* keys = new WindowKeys(this);
  keys->add_attempt(run_page(), pages_->all());
  keys->add(tr("Show frame rate"), Qt::Key_F12, [this] { frames_->toggle(); });
  keys->add(tr("Quit"), Qt::CTRL | Qt::Key_Q, [this] { quit(); });
  keys->add(tr("Open an attempt"), QKeySequence::Open, [this] { attempts_->ask_file(); });
  keys->add(tr("Help"), Qt::Key_F1, [this] { show_help(); });
  keys->add(tr("Trainee view"), Qt::Key_F9, [this] { toggle_trainee(); });
  keys->add_messages(messages_);
  keys->add_edits(pages_->all()->edits());
}

void MainWindow::restore(const Launch& launch) {
  run_page()->set_base_options(launch.options);  // before the theme, which names the plugins' cues
  theme_->restore(launch);
  place_->restore(launch.size);
  instrument_ = std::make_unique<OwnInstrument>(pages_.get(), settings_);
  memory_->restore(launch);
  place_->restore_splitters();
  guard_->tell_stopped();
  run_page()->take_focus();
}

// What the launch wants to be seen.
void MainWindow::open_given(const Launch& launch) {
  const std::optional<CameraPreset> view = view_named(launch.view.toStdString());
  if (view) run_page()->look(*view);
  // the page of people was called Progress
  if (!launch.page.isEmpty()) show_page(launch.page == QLatin1String("progress") ? QStringLiteral("people") : launch.page);
  if (!launch.review.isEmpty()) {
    attempts_->open_at(launch.review, launch.start ? std::nullopt : std::optional(launch.screenshot_at_s));
    if (!launch.compare.isEmpty()) review_page()->compare(launch.compare);
    if (view) review_page()->view()->look(*view, launch.zoom);
  }
  if (!launch.attempt_file.isEmpty()) review_file(launch.attempt_file);
  if (!launch.trainee.isEmpty()) trainee_->show_with(layout_of(launch.trainee));
  // once the event loop runs and the window is there
  if (launch.start) QTimer::singleShot(0, run_page(), &RunPage::start);
}

void MainWindow::remember() {
  theme_->remember();
  place_->remember();
  memory_->remember();
  trainee_->remember();
}

// Enter presses the button that has the keyboard, as Space does: Qt leaves that to dialogs.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  auto* button = enter && !event->isAutoRepeat() ? qobject_cast<QPushButton*>(focusWidget()) : nullptr;
  if (!button) return QMainWindow::keyPressEvent(event);
  button->click();
}

void MainWindow::show_help() {
  // a held key must not go on while the help is read, so the attempt waits, and goes on afterwards
  RunControl* control = run_page()->control();
  const bool ran = control->state() == RunControl::State::kRunning;
  if (ran) control->toggle_pause();
  HelpDialog(theme_->cues(), this).exec();
  if (ran && control->state() == RunControl::State::kPaused) control->toggle_pause();
}

void MainWindow::show_calibration() {
  auto* dialog = new CalibrationDialog(UiTheme::stock(ui_theme()), {}, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &CalibrationDialog::kept, this, [this] { setup_page()->show_calibrations(stored_calibrations()); });
  dialog->show();
}

void MainWindow::leave() {
  run_page()->control()->stop();
  remember();
  QCoreApplication::exit(0);
}

void MainWindow::quit() {
  if (!guard_->agrees_to_quit()) return;
  run_page()->control()->stop();
  close();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!guard_->agrees_to_close()) return event->ignore();
  guard_->end_attempt();
  remember();
  trainee_->close();
  event->accept();
}

}  // namespace swage::console
