// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/main_window.hpp"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHash>
#include <QPushButton>
#include <QSplitter>
#include <QUndoStack>
#include <QVBoxLayout>
#include <optional>

#include "console/app/calibration_dialog.hpp"
#include "console/app/help_dialog.hpp"
#include "console/models/lesson_files.hpp"
#include "console/models/own_cues.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {

namespace {

constexpr int kFrames_ms = 1000;  // once a second is often enough to read a number

std::optional<CameraPreset> preset_of(const QString& view) {
  static const QHash<QString, CameraPreset> presets = {{QStringLiteral("side"), CameraPreset::kSide},
                                                       {QStringLiteral("top"), CameraPreset::kTop},
                                                       {QStringLiteral("near"), CameraPreset::kNear}};
  return presets.contains(view) ? std::optional(presets[view]) : std::nullopt;
}

QByteArray layout_key(const QSplitter& splitter) { return "layout/" + splitter.objectName().toUtf8(); }

}  // namespace

MainWindow::MainWindow(Services services, const Launch& launch, QWidget* parent)
    : QMainWindow(parent),
      settings_(launch.settings_file.isEmpty() ? Settings() : Settings(launch.settings_file)),
      store_(std::move(services.open_store)),
      desk_(std::move(services.open_school)),
      stations_(new StationLink(this)) {
  setWindowTitle(tr("Swage"));
  lessons_.set_folders(launch.lesson_folders);
  auto* middle = new QWidget(this);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  pages_ = new Pages(middle);
  strip_ = new StatusStrip(middle);
  messages_ = new MessageStrip(middle);
  column->addWidget(pages_, 1);
  column->addWidget(messages_);
  column->addWidget(strip_);
  setCentralWidget(middle);
  add_pages(services);
  connect_pages();
  fill_top_bar();
  add_actions();
  strip_->set_graphics(
      run_->view()->gl().ok
          ? tr("Picture: %1").arg(run_->view()->gl().renderer.section(QLatin1Char('('), 0, 0).trimmed())
          : tr("▲ No OpenGL"));
  restore(launch);
  start_stations(std::move(services.open_stations), launch.station);
}

MainWindow::~MainWindow() = default;

// Their order is that of the buttons and of Ctrl+1, Ctrl+2...
void MainWindow::add_pages(Services& services) {
  run_ = new RunPage(std::move(services.open_session), &lessons_, strip_, pages_);
  run_->set_expert(std::move(services.open_expert));
  pages_->add({QStringLiteral("run"), tr("Run"), tr("What is happening now?"), run_, false, [this] { enter_run(); },
               [this](const UiTheme& ui, const CueTheme& cues) { run_->set_themes(ui, cues); }, run_->view()});
  lessons_page_ = new LessonsPage(
      &lessons_, [this](const QString& path) { return read_criteria(path.toStdString(), run_->catalogue()); }, pages_);
  pages_->add({QStringLiteral("lessons"), tr("Lessons"), tr("What can be practised, and what does it ask for?"),
               lessons_page_, true, [this] { lessons_page_->select(run_->setup()->lesson()); }});
  lessons_page_->set_desk(&desk_);
  courses_ = new CoursesPage(
      &desk_, &store_, &lessons_, [this](const QString& lesson) { return metrics_of(lesson); }, pages_);
  pages_->add({QStringLiteral("courses"), tr("Courses"), tr("In what order, and when is it passed?"), courses_, true,
               [this] { courses_->refresh(); }, {}, nullptr, desk_.course_edits()});
  people_ = new PeoplePage(&store_, &desk_, pages_);
  pages_->add({QStringLiteral("people"), tr("People"), tr("Who is where, and who needs help?"), people_, true,
               [this] {
                 people_->refresh();
                 people_->focus_people();
               },
               [this](const UiTheme& ui, const CueTheme&) { people_->set_theme(ui); }, nullptr, desk_.people_edits()});
  review_ = new ReviewPage(std::move(services.read_recording), std::move(services.open_player), pages_);
  review_->set_desk(&desk_);
  people_->set_export(services.read_export);
  review_->set_export(std::move(services.read_export));
  review_->set_file_services(std::move(services.open_file), std::move(services.read_file));
  pages_->add({QStringLiteral("review"), tr("Review"), tr("What happened in that attempt?"), review_, true,
               [this] { review_->setFocus(); },
               [this](const UiTheme& ui, const CueTheme& cues) { review_->set_themes(ui, cues); }, review_->view(),
               desk_.note_edits()});
  setup_ = new SetupPage(pages_);
  pages_->add({QStringLiteral("setup"), tr("Setup"), tr("Does the equipment work?"), setup_, true,
               [this] { setup_->show_calibrations(stored_calibrations()); }});
  add_stations();
  trainee_ = std::make_unique<TraineePlace>(run_, settings_, this);
  connect(trainee_.get(), &TraineePlace::shown, this, &MainWindow::show_message_to_trainee);
}

void MainWindow::connect_pages() {
  const QString run = QStringLiteral("run"), people = QStringLiteral("people");
  connect(run_, &RunPage::show_progress, this, [this, people] {
    show_page(people);
    people_->select_person(run_->setup()->person());
  });
  connect(run_, &RunPage::review, this, &MainWindow::review);
  connect(run_, &RunPage::attempt_over, this, [this] {
    const QString person = run_->setup()->person();
    people_->refresh();
    people_->select_person(person);
    run_->setup()->set_people(people_->people()->names(), person);
  });
  connect(lessons_page_, &LessonsPage::run, this, [this, run](const QString& path, const QString& mode) {
    select_lesson(path);
    run_->setup()->set_mode(mode);
    show_page(run);
  });
  // the Run page makes, edits and deletes what is chosen there
  const auto with_chosen = [this](void (RunPage::*call)()) {
    return [this, call](const QString& path) {
      select_lesson(path);
      const int before = lessons_.rowCount();
      (run_->*call)();
      lessons_page_->select(run_->setup()->lesson());
      lessons_page_->show_lesson();
      if (lessons_.rowCount() > before) lessons_page_->tell(tr("Saved as a lesson of your own."));
    };
  };
  lessons_page_->set_checker([this](const QString& path) { return run_->fault_of(path); });
  connect_lesson_files();
  connect(lessons_page_, &LessonsPage::make_variant, this, with_chosen(&RunPage::make_variant));
  connect(lessons_page_, &LessonsPage::edit_lesson, this, with_chosen(&RunPage::edit_lesson));
  connect(lessons_page_, &LessonsPage::delete_lesson, this, with_chosen(&RunPage::delete_lesson));
  connect(people_, &PeoplePage::run_lesson, this, [this, run] { show_page(run); });
  connect(people_->person(), &PersonPanel::review, this, &MainWindow::review);
  connect(people_->person(), &PersonPanel::open_file, this, &MainWindow::open_attempt);
  connect(review_, &ReviewPage::back, this, [this, people] { show_page(people); });
  connect(review_, &ReviewPage::ask_file, this, &MainWindow::open_attempt);
  const auto said = [this](const QString& lesson, const std::string& metric) {
    const int row = lessons_.row_of(lesson);
    const QModelIndex index = lessons_.index(row, 0);
    return row < 0 ? MetricSaid{metric_facts(nullptr, metric), {}}
                   : run_->metric_said(index.data(LessonsModel::kPath).toString(), metric);
  };
  people_->person()->set_metric_finder(said);
  review_->set_metric_finder(said);
  connect(&store_, &StoreLink::recovered, this, [this](int n) {
    run_->set_notice(
        n == 1 ? tr("The program closed unexpectedly. 1 attempt was kept up to that moment.")
               : tr("The program closed unexpectedly. %1 attempts were kept up to that moment.").arg(n));
  });
  connect(setup_, &SetupPage::themes_chosen, this, &MainWindow::set_theme);
  connect(setup_, &SetupPage::trainee_view, trainee_.get(), &TraineePlace::toggle);
  connect(setup_, &SetupPage::trainee_settings, trainee_.get(), &TraineePlace::show_settings);
  connect(setup_, &SetupPage::station_settings, trainee_.get(), &TraineePlace::show_station);
  connect(setup_, &SetupPage::calibrate_sensor, this, &MainWindow::show_calibration);
}

void MainWindow::connect_lesson_files() {
  run_->editing()->set_courses([this](const QString& lesson_id) { return desk_.courses_with(lesson_id); });
  connect(run_->control(), &RunControl::state_changed, this, [this] { lessons_page_->set_running(run_->control()->running()); });
  connect(run_, &RunPage::started_elsewhere, this, [this] { show_page(QStringLiteral("run")); });
  connect(lessons_page_, &LessonsPage::import_lesson, this, [this](const QString& file) {
    const QString problem = run_->editing()->import_file(file);
    lessons_page_->select(run_->setup()->lesson());
    lessons_page_->show_lesson();
    lessons_page_->tell(problem.isEmpty() ? tr("The lesson was taken in.") : tr("▲ %1").arg(problem));
  });
  connect(lessons_page_, &LessonsPage::export_lesson, this, [this](const QString& path, const QString& file) {
    const QString problem = console::export_lesson(path, file);
    lessons_page_->tell(problem.isEmpty() ? tr("Written to %1.").arg(file) : tr("▲ %1").arg(problem));
  });
}

// as the card of the lesson's plugin says
QVector<LessonMetric> MainWindow::metrics_of(const QString& lesson_id) {
  QVector<LessonMetric> out;
  const int row = lessons_.row_of(lesson_id);
  if (row < 0) return out;
  for (const host::MetricInfo& m : lesson_metrics(lessons_.at(row).path.toStdString(), run_->catalogue()))
    if (m.show != SWAGE_SHOW_POINTS) out += {QString::fromStdString(m.id), QString::fromStdString(m.unit), m.better};
  return out;
}

void MainWindow::select_lesson(const QString& path) {
  if (const int row = lessons_.row_of(path); row >= 0) run_->setup()->select_lesson(row);
}

// What belongs to no page stands behind the pages' buttons.
void MainWindow::fill_top_bar() {
  QHBoxLayout* row = pages_->bar();
  QWidget* bar = pages_->bar_widget();
  row->addStretch(1);
  auto* trainee =
      make_button(tr("Trainee view"), QStringLiteral("F9"), QStringLiteral("trainee_button"), bar);
  trainee->setToolTip(tr("The scene for two eyes in a window of its own (F9)"));
  connect(trainee, &QPushButton::clicked, trainee_.get(), &TraineePlace::toggle);
  row->addWidget(trainee);
  auto* eyes = make_button(tr("Eyes…"), {}, QStringLiteral("trainee_options"), bar);
  eyes->setAccessibleName(tr("Settings of the trainee view"));
  eyes->setToolTip(tr("Settings of the trainee view: screen, layout, eyes"));
  connect(eyes, &QPushButton::clicked, trainee_.get(), &TraineePlace::show_settings);
  row->addWidget(eyes);
  row->addSpacing(8);
  auto* help = make_button(tr("Help"), QStringLiteral("F1"), QStringLiteral("help_button"), bar);
  connect(help, &QPushButton::clicked, this, &MainWindow::show_help);
  row->addWidget(help);
}

void MainWindow::add_actions() {
  const auto add = [this](const QString& text, const QKeySequence& key, auto&& call) {
    auto* action = new QAction(text, this);
    action->setShortcut(key);
    action->setShortcutContext(Qt::ApplicationShortcut);
    connect(action, &QAction::triggered, this, call);
    addAction(action);
  };
  RunControl* control = run_->control();
  add(tr("Start"), Qt::Key_F5, [this] {
    show_page(QStringLiteral("run"));
    run_->start();
  });
  add(tr("Pause"), Qt::Key_F6, [control] { control->toggle_pause(); });
  add(tr("Put back"), Qt::Key_F7, [control] { control->reset_work(); });
  add(tr("Mark"), Qt::Key_F8, [control] { control->mark(); });
  add(tr("Stop"), Qt::SHIFT | Qt::Key_F5, [control] { control->stop(); });
  add(tr("Guide"), Qt::Key_F4, [this] { run_->click_guide(); });
  add(tr("Instructor"), Qt::Key_F10, [this] { run_->show_instructor(!run_->instructor_shown()); });
  add(tr("Show frame rate"), Qt::Key_F12, [this] {
    strip_->set_frames_shown(!strip_->frames_shown());
    settings_.set("frames", strip_->frames_shown());
    strip_->show_frames(shown_view()->frames(), shown_view()->latency());
  });
  connect(&frames_timer_, &QTimer::timeout, this, [this] { strip_->show_frames(shown_view()->frames(), shown_view()->latency()); });
  add(tr("Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { quit(); });
  add(tr("Open an attempt"), QKeySequence::Open, [this] { open_attempt(); });
  add(tr("Help"), Qt::Key_F1, [this] { show_help(); });
  add(tr("Trainee view"), Qt::Key_F9, [this] { toggle_trainee(); });
  for (const bool undo : {true, false}) {
    QAction* action = undo ? pages_->edits()->createUndoAction(this) : pages_->edits()->createRedoAction(this);
    action->setShortcuts(undo ? QKeySequence::Undo : QKeySequence::Redo);  // of the desktop
    // the same key twice is ambiguous, and then does nothing: where it is the desktop's own it stands once
    if (const QKeySequence usual(Qt::CTRL | Qt::Key_Y); !undo && !action->shortcuts().contains(usual))
      action->setShortcuts(action->shortcuts() + QList<QKeySequence>{usual});
    action->setShortcutContext(Qt::ApplicationShortcut);
    addAction(action);
  }
}

const SceneView* MainWindow::shown_view() const {
  const SceneView* view = pages_->current().view;
  return view ? view : run_->view();
}

void MainWindow::review(const QString& attempt_id) {
  const std::shared_ptr<record::Store> store = store_.store();
  if (!store) return;
  review_->open(store, attempt_id);
  show_page(QStringLiteral("review"));
}

void MainWindow::open_attempt() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open an attempt"), {},
                                                    tr("Swage attempts (*.swage);;All files (*)"));
  if (!file.isEmpty()) review_file(file);
}

void MainWindow::review_file(const QString& file) {
  review_->open_file(file);
  show_page(QStringLiteral("review"));
}

void MainWindow::leave() {
  run_->control()->stop();
  remember();
  QCoreApplication::exit(0);
}

void MainWindow::show_help() {
  // a held key must not go on while the help is read, so the attempt waits, and goes on afterwards
  RunControl* control = run_->control();
  const bool ran = control->state() == RunControl::State::kRunning;
  if (ran) control->toggle_pause();
  HelpDialog(cue_theme(cues_id_, UiTheme::stock(ui_id_).dark()), this).exec();
  if (ran && control->state() == RunControl::State::kPaused) control->toggle_pause();
}

// a theme names the cues that come with the program; those of other plugins are shown by their roles
CueTheme MainWindow::cue_theme(const QString& id, bool dark) const {
  const CueTheme all = CueTheme::stock(id).with(own_cues(run_->catalogue().plugins()));
  return dark ? all.on_dark() : all;
}

void MainWindow::set_theme(const QString& ui, const QString& cues) {
  const UiTheme theme = UiTheme::stock(ui);
  const CueTheme all_cues = cue_theme(cues, theme.dark());
  ui_id_ = theme.id();
  cues_id_ = all_cues.id();
  qApp->setPalette(theme.palette());
  qApp->setStyleSheet(theme.style_sheet());
  pages_->set_themes(theme, all_cues);
  setup_->show_themes(ui_id_, cues_id_);
}

void MainWindow::restore(const Launch& launch) {
  const auto or_remembered = [&](const QString& given, const char* key, const char* otherwise) {
    return given.isEmpty() ? settings_.text(key, QString::fromLatin1(otherwise)) : given;
  };
  run_->set_base_options(launch.options);  // before the themes: they name the plugins' cues
  set_theme(or_remembered(launch.theme, "theme", "light"), or_remembered(launch.cues, "cues", "thesis"));
  resize(launch.size.isValid() ? launch.size : QSize(1440, 900));
  if (!launch.size.isValid()) {
    restoreGeometry(settings_.bytes("geometry"));
    fit_screen();
    fits_ = true;
  }
  connect_instrument();
  run_->set_draws_seed(launch.draws_seed);
  run_->set_sound(settings_.text("sound", QStringLiteral("true")) == QLatin1String("true"),
                  settings_.text("volume", QStringLiteral("0.7")).toDouble());
  run_->set_used_controls(settings_.text("used_controls"));
  run_->set_guided(settings_.text("guided") == QLatin1String("true"));
  strip_->set_frames_shown(settings_.text("frames") == QLatin1String("true"));
  frames_timer_.start(kFrames_ms);
  SetupPanel* setup = run_->setup();
  setup->set_left_handed(settings_.text("left_handed") == QLatin1String("true"));
  people_->refresh();
  const QString person =
      launch.person_given ? QString::fromStdString(launch.options.person) : settings_.text("person");
  setup->set_people(people_->people()->names(), person);
  if (launch.person_given) setup->know_person(setup->person());
  people_->select_person(setup->person());
  if (launch.device_given) setup->set_device(QString::fromStdString(launch.options.device));
  if (launch.mode_given) setup->set_mode(QString::fromStdString(launch.options.mode));
  select_first(launch);
  if (const auto view = preset_of(launch.view)) run_->look(*view);
  for (QSplitter* splitter : findChildren<QSplitter*>())
    splitter->restoreState(settings_.bytes(layout_key(*splitter)));
  tell_stopped();
  offer_languages();
  run_->take_focus();
  // the page of people was called Progress
  if (!launch.page.isEmpty()) show_page(launch.page == QLatin1String("progress") ? QStringLiteral("people") : launch.page);
  if (!launch.review.isEmpty()) review_given(launch);
  if (!launch.attempt_file.isEmpty()) review_file(launch.attempt_file);
  if (!launch.trainee.isEmpty()) trainee_->show_with(layout_of(launch.trainee));
  // once the event loop runs and the window is there
  if (launch.start) QTimer::singleShot(0, run_, &RunPage::start);
}

void MainWindow::review_given(const Launch& launch) {
  const std::shared_ptr<record::Store> store = store_.store();
  if (!store) return;
  QString id = launch.review;
  const std::vector<record::AttemptRow> all = store->attempt_heads();
  if (id == QLatin1String("latest")) id = all.empty() ? QString() : QString::fromStdString(all.front().id);
  review(id);
  if (const auto view = preset_of(launch.view)) review_->view()->look(*view);
  if (!launch.start) review_->go(launch.screenshot_at_s);
}

// the lesson named, else the last one, else the first
void MainWindow::select_first(const Launch& launch) {
  int row = lessons_.row_of(settings_.text("lesson"));
  if (!launch.options.lesson_path.empty())
    row = lessons_.add_file(QString::fromStdString(launch.options.lesson_path));
  if (lessons_.rowCount() > 0) run_->setup()->select_lesson(std::max(row, 0));
}

void MainWindow::remember() {
  settings_.set("theme", ui_id_);
  settings_.set("cues", cues_id_);
  settings_.set("geometry", saveGeometry());
  for (const QSplitter* splitter : findChildren<QSplitter*>())
    settings_.set(layout_key(*splitter), splitter->saveState());
  settings_.set("sound", run_->sound_on());
  settings_.set("left_handed", run_->setup()->left_handed());
  trainee_->remember();
  settings_.set("volume", run_->speaker().volume());
  settings_.set("person", run_->setup()->person());
  settings_.set("lesson", run_->setup()->lesson());
  settings_.set("used_controls", run_->used_controls());
  settings_.set("guided", run_->guided());
}

}  // namespace swage::console
