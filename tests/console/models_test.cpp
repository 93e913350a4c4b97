// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QFile>
#include <QFileInfo>
#include <QSortFilterProxyModel>
#include <QTemporaryDir>
#include <cmath>

#include "console/cues/cue_theme.hpp"
#include "console/models/attempts_model.hpp"
#include "console/models/event_log.hpp"
#include "console/models/lessons_model.hpp"
#include "console/models/metric_bars.hpp"
#include "console/models/reading.hpp"
#include "console/models/words.hpp"
#include "fake_session.hpp"
#include "fake_store.hpp"
#include "known_metrics.hpp"

namespace swage::console {
namespace {

using Tester = QAbstractItemModelTester;
constexpr auto kFatal = Tester::FailureReportingMode::Fatal;

void write(const QString& path, const QByteArray& text) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
}

/// A lesson file with these keys and no objects.
QByteArray lesson_with(const QByteArray& keys) {
  return R"({"format": "swage-lesson/1", "objects": [], "lesson": {"plugin": "x.lesson"}, )" + keys + "}";
}
const QByteArray kTwoHands = R"("devices": [{"name": "hand", "as": "mouse", "plugin": "x.mouse", "or": [{"as": "expert", "plugin": "x.hand"}, {"plugin": "x.pad"}]}])";

TEST(Words, SayUnitsAndVerdicts) {
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(quantity_text(0.58, "N"), QString("0.58") + QChar(0x202f) + "N");
  EXPECT_EQ(quantity_text(0.0012, "m"), QString("1.20") + QChar(0x202f) + "mm");
  EXPECT_EQ(quantity_text(23e-6, "m"), QString("23") + QChar(0x202f) + "µm");
  EXPECT_EQ(quantity_text(2.5e-6, "m"), QString("2.5") + QChar(0x202f) + "µm");
  EXPECT_EQ(quantity_text(0, "m"), QString("0.00") + QChar(0x202f) + "mm");
  EXPECT_EQ(quantity_text(2e-8, "m2"), QString("0.02") + QChar(0x202f) + "mm²");
  EXPECT_EQ(quantity_text(7.85e-9, "m2"), QString("7850") + QChar(0x202f) + "µm²");
  EXPECT_EQ(quantity_text(7e-22, "m2"), quantity_text(0, "m2"));
  EXPECT_EQ(quantity_text(2e-5, "N*s"), QString("0.02") + QChar(0x202f) + "mN·s");
  EXPECT_EQ(quantity_text(0.2, "rad"), QString("11.5°"));
  EXPECT_EQ(quantity_text(3, "1"), "3");
  EXPECT_EQ(quantity_text(0.25, "1"), "0.25");
  EXPECT_EQ(quantity_text(0.00035, "N"), QString("0.35") + QChar(0x202f) + "mN");
  EXPECT_EQ(quantity_text(0.12, "N"), QString("0.12") + QChar(0x202f) + "N");
  EXPECT_EQ(quantity_text(0.012, "N"), QString("12.0") + QChar(0x202f) + "mN");
  EXPECT_EQ(quantity_text(0.00013, "1"), "0.00013");
  EXPECT_EQ(quantity_text(1e-12, "1"), "0") << "a count, but for rounding";
  EXPECT_EQ(quantity_text(-5e-12, "m"), quantity_text(0, "m")) << "two points that coincide";
  EXPECT_EQ(quantity_text(std::nan(""), "N"), "–");
  EXPECT_EQ(human_id("grasp.peak_force"), "Grasp peak force");
  EXPECT_EQ(clock_text(62.9), "01:02");
  EXPECT_EQ(verdict_text("failed"), "Not passed");
}

TEST(Lessons, AreReadInOrderAndFaultyFilesSaySo) {
  QTemporaryDir dir;
  write(dir.filePath("020_b.json"), lesson_with(R"("id": "b", "title": "Second", "summary": "two", )" + kTwoHands));
  write(dir.filePath("010_a.json"), lesson_with(R"("id": "a", "title": "First")"));
  write(dir.filePath("030_broken.json"), R"({"id": )");
  write(dir.filePath("040_other.json"), R"({"poses": []})");
  LessonsModel model;
  Tester tester(&model, kFatal);
  model.set_folders({dir.path()});
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(model.at(0).title, "First");
  EXPECT_EQ(model.at(1).summary, "two");
  EXPECT_EQ(model.at(1).hands, QStringList({"mouse", "expert"}));
  EXPECT_EQ(model.at(2).title, "030_broken");
  EXPECT_FALSE(model.at(2).problem.isEmpty());

  EXPECT_EQ(model.add_file(dir.filePath("010_a.json")), 0);
  EXPECT_EQ(model.rowCount(), 3);
  QTemporaryDir other;
  write(other.filePath("mine.json"), lesson_with(R"("id": "mine", "title": "Mine")"));
  EXPECT_EQ(model.add_file(other.filePath("mine.json")), 0);
  EXPECT_EQ(model.at(0).title, "Mine");
  EXPECT_EQ(model.row_of("b"), 2);
  EXPECT_EQ(model.row_of("nobody"), -1);

  // a file given by another path, or a copy with the same id, is listed once: the file added last
  EXPECT_EQ(model.add_file(dir.filePath("../" + QFileInfo(dir.path()).fileName() + "/020_b.json")), 2);
  write(other.filePath("copy.json"), lesson_with(R"("id": "b", "title": "Second, changed")"));
  EXPECT_EQ(model.add_file(other.filePath("copy.json")), 2);
  EXPECT_EQ(model.rowCount(), 4);
  EXPECT_EQ(model.at(2).title, "Second, changed");

  // a structural error is reported as well, and the readable part is shown
  write(other.filePath("faulty.json"), lesson_with(R"("id": "f", "title": "Faulty", "devices": [{"name": "hand"}])"));
  EXPECT_EQ(model.add_file(other.filePath("faulty.json")), 0);
  EXPECT_EQ(model.at(0).title, "Faulty");
  EXPECT_TRUE(model.at(0).problem.contains("faulty.json")) << model.at(0).problem.toStdString();
}

TEST(Lessons, ThatAreBasedOnAnotherHaveItsHandsAndTheirOwnTitle) {
  QTemporaryDir dir;
  write(dir.filePath("010_a.json"), lesson_with(R"("id": "a", "title": "First", "summary": "one", )" + kTwoHands));
  write(dir.filePath("020_b.json"), R"({"format": "swage-lesson/1", "based_on": "010_a.json", "id": "b", "title": "Second"})");
  write(dir.filePath("030_c.json"), R"({"format": "swage-lesson/1", "based_on": "none.json", "id": "c", "title": "Third"})");
  LessonsModel model;
  model.set_folders({dir.path()});
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(model.at(1).id, "b");
  EXPECT_EQ(model.at(1).title, "Second");
  EXPECT_EQ(model.at(1).summary, "one");
  EXPECT_EQ(model.at(1).hands, QStringList({"mouse", "expert"}));
  EXPECT_TRUE(model.at(2).problem.contains("There is no lesson file"));
}

TEST(EventLog, ShowsWhatTheScriptMeans) {
  EventLog log;
  Tester tester(&log, kFatal);
  judge::Script script;
  script.events = {{"lesson", "needle.dropped", "1", "It fell."}};
  log.add({4200, 0, 0, 0}, script, 1e-3);
  log.add({4300, 9, 0, 0}, script, 1e-3);  // an undeclared event is not shown
  log.note(2.25, "Mark");
  ASSERT_EQ(log.rowCount(), 2);
  EXPECT_EQ(log.index(0, EventLog::kTime).data(), "00:04.2");
  EXPECT_EQ(log.index(0, EventLog::kWhat).data(), "Needle dropped");
  EXPECT_EQ(log.index(0, EventLog::kMeans).data(), "It fell.");
  EXPECT_TRUE(log.at(1).by_person);
  log.clear();
  EXPECT_EQ(log.rowCount(), 0);
}

TEST(Attempts, SortByWhatTheyMeanNotByText) {
  AttemptsModel model;
  Tester tester(&model, kFatal);
  test::FakeStore store(test::sample_attempts());
  model.set_attempts(store.attempts("p1", ""));
  ASSERT_EQ(model.rowCount(), 14);
  QSortFilterProxyModel sorted;
  Tester sorted_tester(&sorted, kFatal);
  sorted.setSourceModel(&model);
  sorted.setSortRole(AttemptsModel::kSortRole);
  sorted.sort(AttemptsModel::kTime);
  EXPECT_EQ(sorted.index(0, AttemptsModel::kTime).data(), "00:28");
  EXPECT_EQ(sorted.index(13, AttemptsModel::kTime).data(), "01:10");
  EXPECT_TRUE(sorted.index(0, AttemptsModel::kVerdict).data().toString().contains("Passed"));
  EXPECT_EQ(sorted.index(13, AttemptsModel::kReason).data(), "Failed out of time");
}

TEST(Metrics, AreOldestFirstAndLeaveOutWhatWasStopped) {
  test::learn_known_metrics();
  AttemptsModel model;
  auto rows = test::sample_attempts();
  rows[3].outcome = "aborted";
  rows[4].is_void = true;
  test::FakeStore store(rows);
  model.set_attempts(store.attempts("p1", ""));
  EXPECT_EQ(metric_ids(model.attempts()).mid(0, 3), QStringList({"score", "time", "grasp.tries"}));
  const MetricSeries path = metric_series(model.attempts(), "motion.path");
  ASSERT_EQ(path.points.size(), 12);
  EXPECT_EQ(path.unit, "mm");
  EXPECT_EQ(path.better, SWAGE_BETTER_LOWER);
  EXPECT_DOUBLE_EQ(path.factor, 1000);
  EXPECT_DOUBLE_EQ(path.points.first().value, 90);
  EXPECT_LT(path.points.last().value, path.points.first().value);
  EXPECT_TRUE(path.points.last().test);
  // an attempt that was not passed has no score: neither in the list nor in its curve
  const MetricSeries score = metric_series(model.attempts(), "score");
  EXPECT_EQ(score.better, SWAGE_BETTER_HIGHER);
  EXPECT_EQ(score.points.size() + score.without_score, 12);
  EXPECT_GT(score.without_score, 0);
  for (const MetricPoint& p : score.points) EXPECT_TRUE(p.met);
  EXPECT_EQ(score.most, 100);
  EXPECT_EQ(path.failed, score.without_score) << "of another metric they count with what was measured";
  EXPECT_EQ(metric_series(model.attempts(), "org.other.thing").better, SWAGE_BETTER_NONE);
}

TEST(Reading, FindsTheNumbersOfAScene) {
  base::Problems problems;
  const auto session = test::open_fake({}, problems, test::FakeScript{}, std::make_shared<test::FakeLog>());
  const Reader reader(session->card());
  EXPECT_TRUE(reader.has_force());
  auto s = std::make_unique<snapshot::Snapshot>();
  s->n_signal = 2;
  s->n_metric = 5;
  s->n_object = 2;
  s->signal[0] = 0.7;
  s->signal[1] = -0.3;
  s->metric[0] = 2;
  s->metric[4] = 0.5;
  s->object_cue[0] = SWAGE_NONE;
  s->object_cue[1] = 2;  // grasp.point_only
  s->phase = 1;
  const Reading r = reader.read(*s);
  EXPECT_EQ(r.force, 0.7);
  EXPECT_EQ(r.tilt, 0.3);
  EXPECT_EQ(r.spot, true);
  EXPECT_EQ(r.tips, false);
  EXPECT_EQ(r.hold, 0.5);
  EXPECT_EQ(r.phase, "Hold it");
  ASSERT_EQ(r.counts.size(), 2);
  EXPECT_EQ(r.counts[0].value, "2");

  // a scene without signals has no readings
  const Reading none = Reader(snapshot::SceneCard{}).read(*s);
  EXPECT_FALSE(none.force || none.tilt || none.spot || none.tips || none.hold);
  EXPECT_TRUE(none.counts.isEmpty());
}

// Position and tips beside a cue say what the cue says, in every theme.
TEST(Reading, PositionAndTipsSayWhatTheCueSays) {
  snapshot::SceneCard card;
  const CueTheme theme = CueTheme::stock("safe");
  int grasps = 0;
  for (const QString& meaning : theme.meanings()) {
    if (!meaning.startsWith("grasp.")) continue;
    ++grasps;
    card.script.cues = {{"lesson", meaning.toStdString(), "1", ""}};
    auto s = std::make_unique<snapshot::Snapshot>();
    s->n_object = 1;
    s->object_cue[0] = 0;
    const Reading r = Reader(card).read(*s);
    const QString text = theme.style(meaning).text;
    ASSERT_TRUE(r.spot && r.tips) << meaning.toStdString();
    EXPECT_EQ(*r.spot, text.contains("Position right")) << text.toStdString();
    EXPECT_EQ(*r.tips, !text.contains("without tips")) << text.toStdString();
  }
  EXPECT_EQ(grasps, 5);
}

TEST(Reading, WhileInsertingTheAngleToTheTissueTakesThePlaceOfTheTilt) {
  snapshot::SceneCard card;
  card.script.signals = {{"pierce", "pierce.state", "1", ""},
                         {"pierce", "pierce.angle", "rad", ""},
                         {"grasp", "grasp.tilt_axis", "rad", ""}};
  const Reader reader(card);
  EXPECT_TRUE(reader.inserts());
  EXPECT_TRUE(reader.has_tilt());
  EXPECT_FALSE(reader.has_grasp());
  auto s = std::make_unique<snapshot::Snapshot>();
  s->n_signal = 3;
  s->signal[0] = 0;
  s->signal[1] = 0.2;
  s->signal[2] = 0.9;
  EXPECT_FALSE(reader.read(*s).tilt) << "away from the tissue there is no angle";
  s->signal[0] = 2;
  EXPECT_EQ(reader.read(*s).tilt, 0.2);
}

TEST(Reading, OfSeveralThingsTheOneThatIsHeldIsTold) {
  snapshot::SceneCard card;
  card.script.signals = {{"grasp_small", "grasp.force", "N", ""},
                         {"grasp_small", "grasp.held", "1", ""},
                         {"grasp_large", "grasp.force", "N", ""},
                         {"grasp_large", "grasp.held", "1", ""}};
  const Reader reader(card);
  auto s = std::make_unique<snapshot::Snapshot>();
  s->n_signal = 4;
  for (const int held : {0, 1}) {
    s->signal[2 * held] = 0.6;
    s->signal[2 * held + 1] = 1;
    s->signal[2 * (1 - held)] = s->signal[2 * (1 - held) + 1] = 0;
    EXPECT_EQ(reader.read(*s).force, 0.6) << held;
  }
}

TEST(Reading, TheTensionIsThatOfTheThreadThatIsDrawn) {
  std::string formula;
  const auto tension_of = [&](const std::vector<judge::Name>& signals) {
    snapshot::SceneCard card;
    card.script.signals = signals;
    card.metrics.resize(1);
    card.metrics[0].formula = formula;
    auto s = std::make_unique<snapshot::Snapshot>();
    s->n_signal = static_cast<uint32_t>(signals.size());
    for (uint32_t i = 0; i < s->n_signal; ++i) s->signal[i] = 1 + i;
    const Reader reader(card);
    EXPECT_EQ(reader.has_tension(), reader.read(*s).tension.has_value());
    return reader.read(*s).tension;
  };
  const judge::Name drawn{"swaged", "swage.tension", "N", ""}, own{"suture", "thread.tension", "N", ""};
  EXPECT_EQ(tension_of({drawn, {"pull", "pull.tension_out", "N", ""}, own}), 1) << "at the needle";
  EXPECT_EQ(tension_of({{"near", "pull.tension_tail", "N", ""}, {"far", "pull.tension_out", "N", ""},
                        {"near", "pull.tension_out", "N", ""}, {"far", "pull.tension_tail", "N", ""}, own}), 3)
      << "outside of both holes, not between them";
  EXPECT_EQ(tension_of({own}), 1);
  // a piece between jaws that closed on it is tense while the rest is slack: a lesson that judges the end shows the end
  const judge::Name end{"suture", "thread.tension_first", "N", ""};
  EXPECT_EQ(tension_of({own, end}), 1);
  formula = "99.5 % quantile of thread.tension_first below 20 Hz while held";
  EXPECT_EQ(tension_of({own, end}), 2);
  EXPECT_EQ(tension_of({drawn, own, end}), 1) << "a needle draws it";
  EXPECT_EQ(tension_of({own}), 1);
  EXPECT_FALSE(tension_of({{"touch", "contact.force", "N", ""}}));
}

// an assistant's jaws hold the needle whose angle is judged: their force is not judged
TEST(Reading, AnAssistantsForceIsNotShown) {
  snapshot::SceneCard card;
  card.script.signals = {{"grasp", "grasp.force", "N", ""}, {"grasp", "grasp.held", "1", ""}};
  card.script.metrics = {{"lesson", "angles.threshold", "rad", ""}};
  EXPECT_FALSE(Reader(card).has_force());
  card.script.metrics.push_back({"lesson", "force.peak", "N", ""});
  EXPECT_TRUE(Reader(card).has_force()) << "a lesson that measures a grip";
}

TEST(Words, AxesEndAtNumbersThatAreEasilyRead) {
  EXPECT_DOUBLE_EQ(nice_end(2.1), 3);
  EXPECT_DOUBLE_EQ(nice_end(1.26), 1.5);
  EXPECT_DOUBLE_EQ(nice_end(0.9), 1);
  EXPECT_DOUBLE_EQ(nice_end(0), 0);
}

// The way from the worst attempt to the band is the bar's length, so that the mark moves when values improve.
TEST(MetricBars, AMarkLiesAsFarFromTheBandAsItsValue) {
  QVector<record::AttemptRow> own;
  for (const double time_s : {30.0, 50.0, 110.0}) {
    own += test::sample_attempts()[12];
    own.last().metrics = {{"bars.time", "s", time_s}};
  }
  const ExpertFinder experts = [](const std::string&, const QString&) { return Experts{{{10, 10, 10}}, QStringLiteral("1 expert")}; };
  const auto lower = [](const QString& id) { return id.startsWith("bars.") ? SWAGE_BETTER_LOWER : SWAGE_BETTER_NONE; };
  const auto bars = metric_bars(own, experts, lower);
  ASSERT_EQ(bars.size(), 1);
  EXPECT_NEAR((bars[0].latest - bars[0].high) * 1.1, 0.2, 1e-9) << "20 s of 100 s, with a margin of 5 % on each side";
  own.removeFirst();
  EXPECT_NEAR((metric_bars(own, experts, lower)[0].latest - bars[0].high) * 1.1, 0.4, 1e-9);
  own[0].metrics[0].value = own[1].metrics[0].value = 10;
  EXPECT_TRUE(metric_bars(own, experts, lower)[0].inside);
  EXPECT_DOUBLE_EQ(metric_bars(own, experts, lower)[0].latest, 0.5);
}

}  // namespace
}  // namespace swage::console
