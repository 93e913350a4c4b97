// SPDX-License-Identifier: Apache-2.0
//
// The People page in the whole window: empty, without a store, with attempts.
#include <QComboBox>
#include <QElapsedTimer>
#include <QFile>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableView>

#include <algorithm>
#include <cstdio>

#include "window_fixture.hpp"

namespace swage::test {
namespace {

class PeoplePages : public WindowTest {};

TEST_F(PeoplePages, ProgressIsEmptyWithANextStep) {
  open();
  click("page_people");
  auto* empty = child<QLabel>("empty");
  EXPECT_TRUE(empty->isVisible());
  EXPECT_TRUE(empty->text().contains("after the first lesson"));
  click("run_lesson");
  EXPECT_TRUE(page()->isVisible());
}

TEST_F(PeoplePages, ProgressWithoutAStoreSaysSo) {
  with_store = false;
  open();
  click("page_people");
  EXPECT_TRUE(child<QLabel>("empty")->text().contains("without a store"));
}

// The text of a row does not jump aside when the row is chosen.
TEST_F(PeoplePages, AChosenRowKeepsThePlaceOfItsText) {
  attempts = sample_attempts();
  open();
  click("page_people");
  auto* table = child<QTableView>("people");
  ASSERT_GE(table->model()->rowCount(), 2);
  const auto text_begins = [&](int row) {
    const QRect cell = table->visualRect(table->model()->index(row, 0));
    const QRect in_window(table->viewport()->mapTo(window.get(), cell.topLeft()), cell.size());
    const QImage picture = window->grab(in_window).toImage();  // with what is below the table, which is transparent
    const QRgb ground = picture.pixel(1, 1);
    for (int x = 1; x < picture.width(); ++x)
      for (int y = 2; y < picture.height() - 2; ++y)
        if (qAbs(qGray(picture.pixel(x, y)) - qGray(ground)) > 60) return x;
    return -1;
  };
  table->selectRow(1);
  const int plain = text_begins(0);
  table->selectRow(0);
  EXPECT_GT(plain, 0);
  EXPECT_EQ(text_begins(0), plain);
}

TEST_F(PeoplePages, ProgressShowsAPersonsAttempts) {
  attempts = sample_attempts();
  open();
  EXPECT_GE(child<QComboBox>("person")->findText("Bea L."), 0);
  click("page_people");
  console::PeoplePage* progress = window->people_page();
  progress->select_person("Arun P.");
  EXPECT_EQ(child<QComboBox>("lesson_filter")->currentIndex(), 1) << "the newest lesson first";
  child<QComboBox>("lesson_filter")->setCurrentIndex(0);
  EXPECT_EQ(progress->attempts()->rowCount(), 14);
  auto* metric = child<QComboBox>("metric");
  metric->setCurrentIndex(metric->findData("force.peak"));
  EXPECT_EQ(progress->chart()->series().points.size(), 14);
  EXPECT_EQ(progress->chart()->series().unit, "N");
  auto* lesson = child<QComboBox>("lesson_filter");
  lesson->setCurrentIndex(lesson->findData("swage.series.carry"));
  EXPECT_EQ(progress->attempts()->rowCount(), 2);
  EXPECT_EQ(progress->chart()->series().id, "force.peak");
  progress->select_person("Bea L.");
  EXPECT_EQ(progress->attempts()->rowCount(), 1);
  EXPECT_TRUE(progress->chart()->series().points.isEmpty());
  EXPECT_FALSE(progress->chart()->grab().isNull());
}

// Another program, or a colleague's station, has stored an attempt meanwhile.
TEST_F(PeoplePages, WhatOthersWriteAppearsByItself) {
  attempts = sample_attempts();
  open();
  click("page_people");
  console::PeoplePage* progress = window->people_page();
  progress->select_person("Arun P.");
  child<QComboBox>("lesson_filter")->setCurrentIndex(0);
  auto* table = child<QTableView>("attempts");
  table->selectRow(3);
  const QString chosen = table->selectionModel()->selectedRows().first().data(console::AttemptsModel::kId).toString();
  const int before = progress->attempts()->rowCount();
  shared->more = {sample_attempts().front()};
  shared->more[0].id = "new";
  shared->more[0].started_utc = "2026-12-24T09:00:00Z";
  shared->changed = true;
  EXPECT_TRUE(eventually([&] { return progress->attempts()->rowCount() == before + 1; }));
  ASSERT_TRUE(table->selectionModel()->hasSelection());
  EXPECT_EQ(table->selectionModel()->selectedRows().first().data(console::AttemptsModel::kId).toString(), chosen);
}

TEST_F(PeoplePages, AStoreThatIsDamagedIsNotAnEmptyOne) {
  attempts = sample_attempts();
  open();
  shared->trouble = "The store is damaged.";
  click("page_people");
  EXPECT_TRUE(child<QLabel>("empty")->isVisible());
  EXPECT_EQ(child<QLabel>("empty")->text(), "The store is damaged.");
  shared->trouble.clear();
  click("page_run");
  click("page_people");
  EXPECT_FALSE(child<QLabel>("empty")->isVisible());
}

TEST_F(PeoplePages, TheNewestAttemptIsThreeKeysAway) {
  attempts = sample_attempts();
  open();
  click("page_people");
  QTest::keyClick(child<QTableView>("people"), Qt::Key_Return);
  auto* table = child<QTableView>("attempts");
  ASSERT_TRUE(table->selectionModel()->hasSelection());
  EXPECT_EQ(table->selectionModel()->selectedRows().front().row(), 0);
  QTest::keyClick(table, Qt::Key_Return);
  EXPECT_TRUE(window->review_page()->isVisible());
}

TEST_F(PeoplePages, TheNewestAttemptIsChosenWhereAttemptsAreListed) {
  attempts = sample_attempts();
  open();
  click("page_people");
  EXPECT_FALSE(child<QPushButton>("void_attempt")->isEnabled());
  child<QTabWidget>("person_tabs")->setCurrentIndex(1);
  EXPECT_TRUE(child<QPushButton>("void_attempt")->isEnabled());
  EXPECT_EQ(child<QTableView>("attempts")->selectionModel()->selectedRows().front().row(), 0);
}

TEST_F(PeoplePages, ProgressAsksTheLessonWhichWayAMetricIsBetter) {
  attempts = sample_attempts();
  open();
  click("page_people");
  auto* metric = child<QComboBox>("metric");
  std::vector<std::string> asked;
  window->people_page()->person()->set_metric_finder([&](const QString&, const std::string& id) {
    asked.push_back(id);
    return console::MetricSaid{{SWAGE_BETTER_INSIDE, "mean of F"}, {0.001, 0.002}};
  });
  auto* lesson = child<QComboBox>("lesson_filter");
  lesson->setCurrentIndex(lesson->findData("swage.series.carry"));
  metric->setCurrentIndex(metric->findData("motion.path"));
  const console::MetricSeries& series = window->people_page()->chart()->series();
  EXPECT_EQ(asked.back(), "motion.path");
  EXPECT_EQ(series.better, SWAGE_BETTER_INSIDE);
  EXPECT_EQ(series.target, (console::MetricTarget{1, 2}));  // mm
  // attempts of several lessons have no common target
  lesson->setCurrentIndex(0);
  EXPECT_EQ(series.target, console::MetricTarget{});
  EXPECT_FALSE(window->people_page()->chart()->grab().isNull());
}

// the thesis's D-1 and D-2, of students
TEST_F(PeoplePages, TheFigureOfAGroupFollowsWhoIsChosen) {
  attempts = sample_attempts();
  attempts.back().outcome = "failed";
  open();
  click("page_people");
  console::PeoplePage* people = window->people_page();
  people->select_person("Arun P.");
  auto* tabs = child<QTabWidget>("person_tabs");
  tabs->setCurrentIndex(2);
  child<QComboBox>("lesson_filter")->setCurrentIndex(0);
  auto* metric = child<QComboBox>("metric");
  metric->setCurrentIndex(metric->findData("force.peak"));
  QCoreApplication::processEvents();  // the attempts of a group are read once, after all that a choice changes
  EXPECT_EQ(people->person()->group()->figure().people, QStringList("Arun P."));
  EXPECT_EQ(people->person()->group()->figure().lessons.size(), 2);
  child<QTableView>("people")->selectAll();
  QCoreApplication::processEvents();
  const console::GroupFigure& figure = people->person()->group()->figure();
  EXPECT_EQ(figure.people, QStringList({"Arun P.", "Bea L."}));
  EXPECT_EQ(figure.attempts, 15);
  EXPECT_FALSE(people->person()->group()->grab().isNull());
}

TEST_F(PeoplePages, AReportIsOnePage) {
  attempts = sample_attempts();
  open();
  click("page_people");
  window->people_page()->select_person("Arun P.");
  const QString file = dir.filePath("report.pdf");
  EXPECT_EQ(window->people_page()->files()->write_report_to(file, window->people_page()->chosen()), QString());
  QFile written(file);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  const QByteArray text = written.readAll();
  EXPECT_TRUE(text.startsWith("%PDF"));
  EXPECT_EQ(text.count("/Type /Page\n") + text.count("/Type /Page "), 1);
  EXPECT_TRUE(window->people_page()->files()->write_report_to(QStringLiteral("/nowhere/r.pdf"), window->people_page()->chosen()).contains("/nowhere"));
}

// All attempts are listed, on as many pages as they need.
TEST_F(PeoplePages, AReportOfManyAttemptsHasFurtherPages) {
  const record::AttemptRow one = sample_attempts().back();
  for (int i = 0; i < 72; ++i) {
    record::AttemptRow& a = attempts.emplace_back(one);
    a.id = "n" + std::to_string(i);
    a.person_id = "p1", a.person_name = "Arun P.";
    a.outcome = i % 7 == 0 ? "failed" : "passed";
    a.score = 80;
  }
  open();
  click("page_people");
  window->people_page()->select_person("Arun P.");
  const QString file = dir.filePath("report.pdf");
  ASSERT_EQ(window->people_page()->files()->write_report_to(file, window->people_page()->chosen()), QString());
  QFile written(file);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  const QByteArray text = written.readAll();
  EXPECT_EQ(text.count("/Type /Page\n") + text.count("/Type /Page "), 3) << "72 lines of 20 px beside a chart";
}

// Recorded hands, void attempts and aborted ones are listed and marked as not counted.
TEST_F(PeoplePages, CountsAreTheSameInBothListsAndSayWhatIsLeftOut) {
  attempts = sample_attempts();
  for (int i : {6, 7}) attempts[static_cast<size_t>(i)].is_scripted = true;
  attempts[10].is_void = true;
  open();
  click("page_people");
  window->people_page()->select_person("Arun P.");
  child<QComboBox>("lesson_filter")->setCurrentIndex(0);
  auto* people = child<QTableView>("people");
  const QString passed = people->currentIndex().siblingAtColumn(console::PeopleModel::kPassed).data().toString();
  EXPECT_EQ(passed, "4 of 11");
  EXPECT_EQ(child<QLabel>("person_summary")->text(), "4 of 11 attempts passed, 3 more not counted");
  const auto* rows = window->people_page()->attempts();
  int hands = 0;
  for (int i = 0; i < rows->rowCount(); ++i)
    hands += rows->index(i, console::AttemptsModel::kMode).data().toString() == "Recorded hand, not counted";
  EXPECT_EQ(hands, 2);
}

// Exports contain versions and health of the measurement; names are not exported.
TEST_F(PeoplePages, AttemptsLeaveWithVersionsAndHealth) {
  attempts = sample_attempts();
  open();
  click("page_people");
  window->people_page()->select_person("Arun P.");
  record::Selection asked;
  window->people_page()->files()->set_export([&](const std::string&, const record::Selection& which, std::vector<record::Exported>& out, std::string&) {
    asked = which;
    record::Exported& e = out.emplace_back();
    e.attempt = attempts[0];
    e.attempt.person_code = "4F2AK";
    e.metric_version = "swage.lesson.grasp 1.2.0";
    e.health = {{"solver.not_converged", "1", 3}};
    return true;
  });
  const QString file = dir.filePath("own.csv");
  ASSERT_EQ(window->people_page()->files()->write_attempts_to(file, window->people_page()->chosen()), QString());
  QFile written(file);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  const QByteArray text = written.readAll();
  EXPECT_EQ(asked.person_id, attempts[0].person_id);
  for (const char* said : {"metric_version", "lesson_version", "calibration", "swage.lesson.grasp 1.2.0", "health.solver.not_converged,3,1", "4F2AK"})
    EXPECT_TRUE(text.contains(said)) << said;
  EXPECT_FALSE(text.contains("Arun"));
}

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Paints a table at each scroll position, page by page; ms for each.
std::vector<double> scroll_times(QTableView* table) {
  std::vector<double> ms;
  QScrollBar* bar = table->verticalScrollBar();
  for (int i = 0; i <= 400; ++i) {
    QElapsedTimer clock;
    clock.start();
    bar->setValue(bar->minimum() + i * (bar->maximum() - bar->minimum()) / 400);
    table->viewport()->repaint();
    ms.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
  }
  return ms;
}

// 33 ms per picture, thirty a second, counts as smooth; nothing else is drawn here
TEST_F(PeoplePages, FiveThousandAttemptsScrollSmoothly) {
  const record::AttemptRow one = sample_attempts().front();
  for (int i = 0; i < 5000; ++i) {
    record::AttemptRow& a = attempts.emplace_back(one);
    a.id = "n" + std::to_string(i);
    a.outcome = i % 3 == 0 ? "failed" : "passed";
  }
  open();
  click("page_people");
  window->people_page()->select_person(QString::fromStdString(one.person_name));
  child<QTabWidget>("person_tabs")->setCurrentIndex(1);
  auto* table = child<QTableView>("attempts");
  ASSERT_EQ(table->model()->rowCount(), 5000);
  ASSERT_TRUE(eventually([&] { return table->isVisible() && table->verticalScrollBar()->maximum() > 0; }));
  const std::vector<double> ms = scroll_times(table);
  std::printf("scrolling 5000 attempts, 401 pictures: median %.2f, p99 %.2f, worst %.2f ms\n", percentile(ms, 0.5), percentile(ms, 0.99), percentile(ms, 1));
  EXPECT_LT(percentile(ms, 0.99), 33) << "ms";
}

}  // namespace
}  // namespace swage::test
