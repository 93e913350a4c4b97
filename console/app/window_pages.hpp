// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The pages of the main window, in the order of their buttons, and what one page has to tell another. [main]
#pragma once

#include <QObject>

#include "console/app/pages.hpp"
#include "console/app/services.hpp"
#include "console/models/lessons_model.hpp"
#include "console/pages/courses_page.hpp"
#include "console/pages/lessons_page.hpp"
#include "console/pages/people_page.hpp"
#include "console/pages/review_page.hpp"
#include "console/pages/run_page.hpp"
#include "console/pages/setup_page.hpp"
#include "console/pages/stations_page.hpp"

namespace swage::console {

/// What several pages work on. All outlive the pages.
struct SharedModels {
  LessonsModel* lessons;
  StoreLink* store;
  SchoolDesk* desk;
  StationLink* stations;
};

class WindowPages : public QObject {
  Q_OBJECT
 public:
  /// `all`: takes the pages, and owns them. `strip`: outlives them.
  WindowPages(Services& services, const SharedModels& models, StatusStrip* strip, Pages* all, QObject* parent);

  Pages* all() const { return all_; }
  RunPage* run() const { return run_; }
  LessonsPage* lessons() const { return lessons_; }
  CoursesPage* courses() const { return courses_; }
  PeoplePage* people() const { return people_; }
  ReviewPage* review() const { return review_; }
  SetupPage* setup() const { return setup_; }
  StationsPage* stations() const { return stations_; }
  /// The picture of the page in front; of the Run page where that has none.
  const SceneView* shown_view() const;

 private:
  void add_run(Services& services, StatusStrip* strip);
  void add_lessons();
  void add_courses();
  void add_people();
  void add_review(Services& services);
  void add_setup();
  void add_stations();
  void connect_people();
  void set_metric_finder();
  void enter_run();
  QString enter_person(const QString& name);
  std::optional<CourseNext> course_of(const QString& name) const;
  QVector<LessonMetric> metrics_of(const QString& lesson_id) const;

  SharedModels models_;
  Pages* all_;
  RunPage* run_ = nullptr;
  LessonsPage* lessons_ = nullptr;
  CoursesPage* courses_ = nullptr;
  PeoplePage* people_ = nullptr;
  ReviewPage* review_ = nullptr;
  SetupPage* setup_ = nullptr;
  StationsPage* stations_ = nullptr;
};

}  // namespace swage::console
