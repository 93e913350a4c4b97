// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/window_pages.hpp"

#include <QUndoStack>
#include <utility>

#include "console/app/calibration_dialog.hpp"
#include "console/models/people_courses.hpp"

namespace swage::console {

// The order of the pages is that of the buttons and of Ctrl+1, Ctrl+2...
WindowPages::WindowPages(Services& services, const SharedModels& models, StatusStrip* strip, Pages* all, QObject* parent)
    : QObject(parent), models_(models), all_(all) {
  add_run(services, strip);
  add_lessons();
  add_courses();
  add_people();
  add_review(services);
  add_setup();
  add_stations();
  people_->files()->set_export(std::move(services.read_export));
  connect_people();
  set_metric_finder();
}

void WindowPages::add_run(Services& services, StatusStrip* strip) {
  run_ = new RunPage(std::move(services.open_session), models_.lessons, strip, all_);
  run_->set_expert(std::move(services.open_expert));
  run_->set_person_adder([this](const QString& name) { return enter_person(name); });
  run_->set_course_finder([this](const QString& name) { return course_of(name); });
  all_->add({QStringLiteral("run"), tr("Run"), tr("What is happening now?"), run_, false, [this] { enter_run(); },
             [this](const UiTheme& ui, const CueTheme& cues) { run_->set_themes(ui, cues); }, run_->view()});
  connect(models_.store, &StoreLink::recovered, this, [this](int n) {
    run_->set_notice(
        n == 1 ? tr("The program closed unexpectedly. 1 attempt was kept up to that moment.")
               : tr("The program closed unexpectedly. %1 attempts were kept up to that moment.").arg(n));
  });
}

void WindowPages::add_lessons() {
  lessons_ = new LessonsPage(
      models_.lessons, [this](const QString& path) { return read_criteria(path.toStdString(), run_->catalogue()); }, all_);
  all_->add({QStringLiteral("lessons"), tr("Lessons"), tr("What can be practised, and what does it ask for?"), lessons_, true,
             [this] { lessons_->select(run_->setup()->lesson()); }});
  lessons_->set_desk(models_.desk);
}

void WindowPages::add_courses() {
  courses_ = new CoursesPage(
      models_.desk, models_.store, models_.lessons, [this](const QString& lesson) { return metrics_of(lesson); }, all_);
  all_->add({QStringLiteral("courses"), tr("Courses"), tr("In what order, and when is it passed?"), courses_, true,
             [this] { courses_->refresh(); }, {}, nullptr, models_.desk->course_edits()});
}

void WindowPages::add_people() {
  people_ = new PeoplePage(models_.store, models_.desk, all_);
  all_->add({QStringLiteral("people"), tr("People"), tr("Who is where, and who needs help?"), people_, true,
             [this] {
               people_->refresh();
               people_->focus_people();
             },
             [this](const UiTheme& ui, const CueTheme&) { people_->set_theme(ui); }, nullptr, models_.desk->people_edits()});
}

void WindowPages::add_review(Services& services) {
  review_ = new ReviewPage(std::move(services.read_recording), std::move(services.open_player), all_);
  review_->set_desk(models_.desk);
  review_->attempt().set_export(services.read_export);
  review_->attempt().set_file_services(std::move(services.open_file), std::move(services.read_file));
  all_->add({QStringLiteral("review"), tr("Review"), tr("What happened in that attempt?"), review_, true,
             [this] { review_->setFocus(); },
             [this](const UiTheme& ui, const CueTheme& cues) { review_->set_themes(ui, cues); }, review_->view(),
             models_.desk->note_edits()});
}

void WindowPages::add_setup() {
  setup_ = new SetupPage(all_);
  all_->add({QStringLiteral("setup"), tr("Setup"), tr("Does the equipment work?"), setup_, true,
             [this] { setup_->show_calibrations(stored_calibrations()); }});
}

void WindowPages::add_stations() {
  stations_ = new StationsPage(models_.stations, models_.lessons, all_);
  all_->add({QStringLiteral("stations"), tr("Stations"), tr("Who does what at every station, now?"), stations_, true,
             [this] { stations_->focus_stations(); },
             [this](const UiTheme&, const CueTheme& cues) { stations_->set_cues(cues); }});
}

// People and their attempts, between the pages that show them.
void WindowPages::connect_people() {
  const QString run = QStringLiteral("run"), people = QStringLiteral("people");
  connect(run_, &RunPage::show_progress, this, [this, people] {
    all_->go(people);
    people_->select_person(run_->setup()->person());
  });
  connect(run_, &RunPage::attempt_over, this, [this] {
    const QString person = run_->setup()->person();
    people_->refresh();
    people_->select_person(person);
    run_->setup()->set_people(people_->people()->names(), person);
  });
  connect(run_, &RunPage::started_elsewhere, this, [this, run] { all_->go(run); });
  connect(people_, &PeoplePage::run_lesson, this, [this, run] { all_->go(run); });
  connect(review_, &ReviewPage::back, this, [this, people] { all_->go(people); });
}

void WindowPages::set_metric_finder() {
  const auto metric_said = [this](const QString& lesson, const std::string& metric) {
    const int row = models_.lessons->row_of(lesson);
    const QModelIndex index = models_.lessons->index(row, 0);
    return row < 0 ? MetricSaid{metric_facts(nullptr, metric), {}}
                   : run_->metric_said(index.data(LessonsModel::kPath).toString(), metric);
  };
  people_->person()->set_metric_finder(metric_said);
  review_->attempt().set_metric_finder(metric_said);
}

// The metrics of the card of the lesson's plugin.
QVector<LessonMetric> WindowPages::metrics_of(const QString& lesson_id) const {
  QVector<LessonMetric> out;
  const int row = models_.lessons->row_of(lesson_id);
  if (row < 0) return out;
  for (const host::MetricInfo& m : lesson_metrics(models_.lessons->at(row).path.toStdString(), run_->catalogue()))
    if (m.show != SWAGE_SHOW_POINTS) out += {QString::fromStdString(m.id), QString::fromStdString(m.unit), m.better};
  return out;
}

// A person who was entered on another page is known here.
void WindowPages::enter_run() {
  SetupPanel* setup = run_->setup();
  if (!run_->control()->running()) setup->set_people(people_->people()->names(), setup->person());
  run_->take_focus();
}

// A new person of the Run page gets a code as on the People page. Without a store nothing is kept, and nobody is entered.
QString WindowPages::enter_person(const QString& name) {
  record::School* school = models_.desk->school();
  record::Person there;
  if (!school || school->find_person(name.toStdString(), there)) return {};
  RosterLine line;
  line.name = name;
  return models_.desk->add_people({line}) ? QString() : models_.desk->problem();
}

std::optional<CourseNext> WindowPages::course_of(const QString& name) const {
  record::School* school = models_.desk->school();
  const std::shared_ptr<record::Store> store = models_.store->store();
  record::Person person;
  if (!school || !store || !school->find_person(name.toStdString(), person)) return {};
  const std::vector<record::Course> courses = courses_of_any(*school, {person});
  if (courses.empty()) return {};
  return course_next(courses, store->attempts(person.id, ""));
}

const SceneView* WindowPages::shown_view() const {
  const SceneView* view = all_->current().view;
  return view ? view : run_->view();
}

}  // namespace swage::console
