// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/main_window.hpp"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHash>
#include <QLabel>
#include <QVBoxLayout>
#include <optional>

#include "console/app/help_dialog.hpp"
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

constexpr int kWithLabels_px = 1060;  // the bar with everything in it needs 1020

QComboBox* add_choice(QHBoxLayout* row, QWidget* bar, const QString& label, const char* name,
                      const QString& tip) {
  auto* text = new QLabel(label, bar);
  text->setProperty("muted", true);
  text->setObjectName(QStringLiteral("choice_label"));
  text->setMinimumWidth(1);  // it goes where the window is narrow, and then keeps no window wide
  row->addWidget(text);
  auto* choice = new QComboBox(bar);
  choice->setObjectName(QString::fromLatin1(name));
  choice->setToolTip(tip);
  choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  row->addWidget(choice);
  row->addSpacing(8);
  return choice;
}

}  // namespace

MainWindow::MainWindow(Doors doors, const Launch& launch, QWidget* parent)
    : QMainWindow(parent),
      settings_(launch.settings_file.isEmpty() ? Settings() : Settings(launch.settings_file)) {
  setWindowTitle(tr("Swage"));
  lessons_.set_folders(launch.lesson_folders);
  auto* middle = new QWidget(this);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_top_bar());
  strip_ = new StatusStrip(middle);
  pages_ = new QStackedWidget(middle);
  run_ = new RunPage(std::move(doors.open_session), &lessons_, strip_, pages_);
  progress_ = new ProgressPage(std::move(doors.open_store), pages_);
  pages_->addWidget(run_);
  const auto add_page = [this](QWidget* page) {
    // a page that is larger than the window scrolls
    QScrollArea* scroll = make_scroll(pages_);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    scroll->setWidget(page);
    pages_->addWidget(scroll);
  };
  review_ = new ReviewPage(std::move(doors.read_recording), std::move(doors.open_player), pages_);
  review_->set_file_doors(std::move(doors.open_file), std::move(doors.read_file));
  add_page(progress_);
  add_page(review_);
  column->addWidget(pages_, 1);
  column->addWidget(strip_);
  setCentralWidget(middle);
  add_actions();
  connect(run_, &RunPage::show_progress, this, [this] { show_page(1); });
  connect(run_, &RunPage::review, this, &MainWindow::review);
  connect(progress_, &ProgressPage::run_lesson, this, [this] { show_page(0); });
  connect(progress_, &ProgressPage::review, this, &MainWindow::review);
  connect(progress_, &ProgressPage::open_file, this, &MainWindow::open_attempt);
  connect(review_, &ReviewPage::back, this, [this] { show_page(1); });
  progress_->set_metric_finder([this](const QString& lesson, const std::string& metric) {
    const int row = lessons_.row_of(lesson);
    const QModelIndex index = lessons_.index(row, 0);
    return row < 0 ? MetricSaid{metric_facts(nullptr, metric), {}}
                   : run_->metric_said(index.data(LessonsModel::kPath).toString(), metric);
  });
  connect(progress_, &ProgressPage::recovered, this, [this](int n) {
    run_->set_notice(
        n == 1 ? tr("The program closed unexpectedly. 1 attempt was kept up to that moment.")
               : tr("The program closed unexpectedly. %1 attempts were kept up to that moment.").arg(n));
  });
  connect(run_, &RunPage::attempt_over, this, [this] {
    const QString person = run_->setup()->person();
    progress_->refresh();
    progress_->select_person(person);
    run_->setup()->set_people(progress_->people()->names(), person);
  });
  strip_->set_graphics(
      run_->view()->gl().ok
          ? tr("Picture: %1").arg(run_->view()->gl().renderer.section(QLatin1Char('('), 0, 0).trimmed())
          : tr("▲ No OpenGL"));
  restore(launch);
}

MainWindow::~MainWindow() = default;

QWidget* MainWindow::make_top_bar() {
  auto* bar = new QFrame(this);
  bar->setObjectName(QStringLiteral("top_bar"));
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(14, 0, 14, 0);
  row->setSpacing(4);
  auto* name = new QLabel(QStringLiteral("Swage"), bar);
  name->setProperty("brand", true);
  row->addWidget(name);
  row->addSpacing(14);
  const QStringList pages = {tr("Run"), tr("Progress"), tr("Review")};
  for (int i = 0; i < pages.size(); ++i) {
    auto* button = make_button(pages[i], {}, QStringLiteral("page_%1").arg(i), bar);
    button->setProperty("page", true);
    button->setCheckable(true);
    button->setAutoExclusive(true);
    button->setToolTip(QStringLiteral("%1 (Ctrl+%2)").arg(pages[i]).arg(i + 1));
    connect(button, &QPushButton::clicked, this, [this, i] { show_page(i); });
    row->addWidget(button);
    page_buttons_ += button;
  }
  page_buttons_.first()->setChecked(true);
  row->addStretch(1);
  cues_ = add_choice(row, bar, tr("Cue colours"), "cue_theme",
                     tr("Colours of the cues; shapes, words and sounds stay the same"));
  cues_->setAccessibleName(tr("Cue colours"));
  for (const QString& id : CueTheme::stock()) cues_->addItem(CueTheme::stock(id).title(), id);
  connect(cues_, &QComboBox::activated, this, [this] { set_theme(ui_id_, cues_->currentData().toString()); });
  theme_ = add_choice(row, bar, tr("Theme"), "theme", tr("Colours of the window"));
  theme_->setAccessibleName(tr("Theme"));
  for (const QString& id : UiTheme::names()) theme_->addItem(UiTheme::stock(id).title(), id);
  connect(theme_, &QComboBox::activated, this,
          [this] { set_theme(theme_->currentData().toString(), cues_id_); });
  auto* trainee =
      make_button(tr("Trainee view"), QStringLiteral("F9"), QStringLiteral("trainee_button"), bar);
  trainee->setToolTip(tr("The scene for two eyes in a window of its own (F9)"));
  connect(trainee, &QPushButton::clicked, this, &MainWindow::toggle_trainee);
  row->addWidget(trainee);
  auto* eyes = make_button(tr("…"), {}, QStringLiteral("trainee_options"), bar);
  eyes->setAccessibleName(tr("Settings of the trainee view"));
  eyes->setToolTip(tr("Settings of the trainee view: screen, layout, eyes"));
  connect(eyes, &QPushButton::clicked, this, &MainWindow::show_trainee_settings);
  row->addWidget(eyes);
  row->addSpacing(8);
  auto* help = make_button(tr("Help"), QStringLiteral("F1"), QStringLiteral("help_button"), bar);
  connect(help, &QPushButton::clicked, this, &MainWindow::show_help);
  row->addWidget(help);
  return bar;
}

// The choices of the bar have their names in tool tips too: where it is narrow they stand alone.
void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  for (QLabel* label : findChildren<QLabel*>(QStringLiteral("choice_label")))
    label->setVisible(width() >= kWithLabels_px);
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
  add(tr("Start"), Qt::Key_F5, [this] { show_page(0), run_->start(); });
  add(tr("Pause"), Qt::Key_F6, [control] { control->toggle_pause(); });
  add(tr("Put back"), Qt::Key_F7, [control] { control->reset_work(); });
  add(tr("Mark"), Qt::Key_F8, [control] { control->mark(); });
  add(tr("Stop"), Qt::SHIFT | Qt::Key_F5, [control] { control->stop(); });
  add(tr("Instructor"), Qt::Key_F10, [this] { run_->show_instructor(!run_->instructor_shown()); });
  add(tr("Show frame rate"), Qt::Key_F12, [this] {
    strip_->set_frames_shown(!strip_->frames_shown());
    settings_.set("frames", strip_->frames_shown());
    strip_->show_frames(shown_view()->frames());
  });
  connect(&frames_timer_, &QTimer::timeout, this, [this] { strip_->show_frames(shown_view()->frames()); });
  add(tr("Open an attempt"), QKeySequence::Open, [this] { open_attempt(); });
  add(tr("Help"), Qt::Key_F1, [this] { show_help(); });
  add(tr("Trainee view"), Qt::Key_F9, [this] { toggle_trainee(); });
  for (int i = 0; i < page_buttons_.size(); ++i) {
    add(page_buttons_[i]->accessibleName(), Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + i),
        [this, i] { show_page(i); });
  }
}

const SceneView* MainWindow::shown_view() const {
  return pages_->currentIndex() == 2 ? review_->view() : run_->view();
}

void MainWindow::show_page(int page) {
  pages_->setCurrentIndex(page);
  page_buttons_[page]->setChecked(true);
  if (page != 1) return;
  progress_->refresh();
  progress_->focus_attempts();
}

void MainWindow::review(const QString& attempt_id) {
  if (!progress_->store()) return;
  review_->open(progress_->store(), attempt_id);
  show_page(2);
  review_->setFocus();
}

void MainWindow::open_attempt() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open an attempt"), {},
                                                    tr("Swage attempts (*.swage);;All files (*)"));
  if (!file.isEmpty()) review_file(file);
}

void MainWindow::review_file(const QString& file) {
  review_->open_file(file);
  show_page(2);
  review_->setFocus();
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
  const CueTheme cues = CueTheme::stock(cues_id_);
  HelpDialog(UiTheme::stock(ui_id_).dark() ? cues.on_dark() : cues, this).exec();
  if (ran && control->state() == RunControl::State::kPaused) control->toggle_pause();
}

void MainWindow::show_trainee() {
  if (!trainee_) {
    trainee_ = std::make_unique<TraineeWindow>();
    run_->add_view(trainee_->view());
    // it is closed from within
    connect(trainee_.get(), &TraineeWindow::closed, this, [this] {
      if (trainee_) trainee_.release()->deleteLater();
      if (trainee_settings_) trainee_settings_->set_open(false);
    });
  }
  trainee_->show_as(trainee_look_);
  if (trainee_settings_) trainee_settings_->set_open(true);
}

void MainWindow::toggle_trainee() {
  if (!trainee_) return show_trainee();
  trainee_->close();
}

void MainWindow::show_trainee_settings() {
  if (!trainee_settings_) {
    trainee_settings_ = new TraineeSettings(trainee_look_, this);
    connect(trainee_settings_, &TraineeSettings::changed, this, [this] {
      trainee_look_ = trainee_settings_->look();
      if (trainee_) show_trainee();
    });
    connect(trainee_settings_, &TraineeSettings::toggled, this, &MainWindow::toggle_trainee);
  }
  trainee_settings_->set_open(trainee_ != nullptr);
  trainee_settings_->show();
  trainee_settings_->raise();
}

void MainWindow::set_theme(const QString& ui, const QString& cues) {
  const UiTheme theme = UiTheme::stock(ui);
  const CueTheme cue_theme = theme.dark() ? CueTheme::stock(cues).on_dark() : CueTheme::stock(cues);
  ui_id_ = theme.id();
  cues_id_ = cue_theme.id();
  qApp->setPalette(theme.palette());
  qApp->setStyleSheet(theme.style_sheet());
  run_->set_themes(theme, cue_theme);
  progress_->set_theme(theme);
  review_->set_themes(theme, cue_theme);
  theme_->setCurrentIndex(theme_->findData(ui_id_));
  cues_->setCurrentIndex(cues_->findData(cues_id_));
}

// Nothing lies outside the screen, at the first start and on a smaller screen than the last time.
void MainWindow::fit_screen() {
  const QRect all = screen()->availableGeometry();
  const QSize frame = frameGeometry().size() - size();
  resize(size().boundedTo(all.size() - frame));
  if (!all.contains(geometry())) move(all.topLeft());
}

void MainWindow::restore(const Launch& launch) {
  const auto or_remembered = [&](const QString& given, const char* key, const char* otherwise) {
    return given.isEmpty() ? settings_.text(key, QString::fromLatin1(otherwise)) : given;
  };
  set_theme(or_remembered(launch.theme, "theme", "light"), or_remembered(launch.cues, "cues", "thesis"));
  resize(launch.size.isValid() ? launch.size : QSize(1440, 900));
  if (!launch.size.isValid()) {
    restoreGeometry(settings_.bytes("geometry"));
    fit_screen();
  }
  run_->set_base_options(launch.options);
  run_->set_draws_seed(launch.draws_seed);
  run_->set_sound(settings_.text("sound", QStringLiteral("true")) == QLatin1String("true"),
                  settings_.text("volume", QStringLiteral("0.7")).toDouble());
  run_->set_used_controls(settings_.text("used_controls"));
  trainee_look_ = read_trainee_look(settings_);
  strip_->set_frames_shown(settings_.text("frames") == QLatin1String("true"));
  frames_timer_.start(kFrames_ms);
  SetupPanel* setup = run_->setup();
  setup->set_left_handed(settings_.text("left_handed") == QLatin1String("true"));
  progress_->refresh();
  const QString person =
      launch.person_given ? QString::fromStdString(launch.options.person) : settings_.text("person");
  setup->set_people(progress_->people()->names(), person);
  progress_->select_person(setup->person());
  if (launch.device_given) setup->set_device(QString::fromStdString(launch.options.device));
  if (launch.mode_given) setup->set_mode(QString::fromStdString(launch.options.mode));
  select_first(launch);
  if (const auto view = preset_of(launch.view)) run_->look(*view);
  if (launch.page == QLatin1String("progress")) show_page(1);
  if (!launch.review.isEmpty()) review_given(launch);
  if (!launch.attempt_file.isEmpty()) review_file(launch.attempt_file);
  if (!launch.trainee.isEmpty()) {
    trainee_look_.stereo.layout = layout_of(launch.trainee);
    show_trainee();
  }
  // once the event loop runs and the window is there
  if (launch.start) QTimer::singleShot(0, run_, &RunPage::start);
}

void MainWindow::review_given(const Launch& launch) {
  if (!progress_->store()) return;
  QString id = launch.review;
  const std::vector<record::AttemptRow> all = progress_->store()->attempts("");
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
  settings_.set("sound", run_->sound_on());
  settings_.set("left_handed", run_->setup()->left_handed());
  console::remember(trainee_look_, settings_);
  settings_.set("volume", run_->speaker().volume());
  settings_.set("person", run_->setup()->person());
  settings_.set("lesson", run_->setup()->lesson());
  settings_.set("used_controls", run_->used_controls());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  run_->control()->stop();
  remember();
  if (trainee_) trainee_->close();
  event->accept();
}

}  // namespace swage::console
