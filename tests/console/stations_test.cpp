// SPDX-License-Identifier: Apache-2.0
//
// The stations of a school in the console: the list's texts, the page, messages, and a real server that freezes.
#include <gmock/gmock.h>

#include <QComboBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QListWidget>
#include <QTableView>

#include "fake_stations.hpp"
#include "postgres_server.hpp"
#include "record/identity.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

using console::StationsModel;
using record::StationMessage;
using record::StationNow;
using record::StationState;
using record::Stations;
using record::test::PostgresServer;
using testing::HasSubstr;

std::string cell(const StationsModel& model, int row, int column) {
  return model.index(row, column).data().toString().toStdString();
}

TEST(StationsModelTest, EveryStateHasASignAndAWord) {
  StationsModel model;
  model.set_cue_words([](const QString& meaning) { return QStringLiteral("<") + meaning + QLatin1Char('>'); });
  model.set_stations(sample_stations(), QStringLiteral("Table 3"));
  ASSERT_EQ(model.rowCount(), 5);
  EXPECT_EQ(cell(model, 0, StationsModel::kState), "● runs");
  EXPECT_EQ(cell(model, 2, StationsModel::kState), "‖ paused");
  EXPECT_EQ(cell(model, 3, StationsModel::kState), "▲ lost for 12 s");
  EXPECT_EQ(cell(model, 4, StationsModel::kState), "– closed");
  EXPECT_EQ(cell(model, 2, StationsModel::kStation), "Table 3 (here)");
  EXPECT_EQ(cell(model, 0, StationsModel::kTime), "00:42");
  EXPECT_EQ(cell(model, 1, StationsModel::kCues), "<grasp.wrong>, <force.high>");
  EXPECT_EQ(cell(model, 0, StationsModel::kHealth), "● in order");
  EXPECT_EQ(cell(model, 1, StationsModel::kHealth), "▲ steps late: 14, solver short: 3");
  for (const int column : {StationsModel::kTime, StationsModel::kForce, StationsModel::kScore, StationsModel::kHealth})
    EXPECT_EQ(cell(model, 4, column), "") << "a closed station measures nothing";
  StationNow quiet = sample_stations()[0];
  quiet.silent_s = 4000;
  EXPECT_EQ(console::station_state_text(quiet), "▲ lost for 1 h");
  quiet.silent_s = record::kLost_s;
  EXPECT_EQ(console::station_state_text(quiet), "● runs") << "only beyond the limit";
  quiet.recorded = false;
  EXPECT_EQ(console::station_health_text(quiet), "▲ not recorded");
}

TEST(StationsModelTest, RowsStayWhileTheirStationsStay) {
  StationsModel model;
  model.set_stations(sample_stations(), {});
  const QPersistentModelIndex second = model.index(1, 0);
  std::vector<StationNow> later = sample_stations();
  later[1].time_s = 130;
  model.set_stations(later, {});
  ASSERT_TRUE(second.isValid());
  EXPECT_EQ(second.sibling(1, StationsModel::kTime).data(), "02:10");
  later.erase(later.begin());
  model.set_stations(later, {});
  EXPECT_EQ(model.rowCount(), 4);
  EXPECT_EQ(model.row_of(QStringLiteral("Table 2")), 0);
  EXPECT_EQ(model.row_of(QStringLiteral("Table 1")), -1);
}

TEST(StationsModelTest, AReceiptSaysWhatBecameOfIt) {
  StationMessage m;
  m.to = "Table 1";
  m.body = "Take the tips";
  EXPECT_EQ(console::sent_text(m), "Table 1   Take the tips   ○ sent");
  m.shown = true;
  EXPECT_EQ(console::sent_text(m), "Table 1   Take the tips   ● on the screen");
  m.answer = "read";
  EXPECT_EQ(console::sent_text(m), "Table 1   Take the tips   ✓ read");
  m.kind = StationMessage::Kind::kLesson;
  m.title = "Carry and hold";
  m.answer = "missing";
  EXPECT_EQ(console::sent_text(m), "Table 1   lesson “Carry and hold”   ▲ that station does not have it");
}

class StationsWindow : public WindowTest {
 protected:
  void open_school() {
    {
      const std::lock_guard lock(school->mutex);
      school->stations = sample_stations();
    }
    open_stations = [this](std::string& error) -> std::unique_ptr<Stations> {
      const std::lock_guard lock(school->mutex);
      error = school->refuse;
      return error.empty() ? std::make_unique<FakeStations>(school) : nullptr;
    };
    launch.station = QStringLiteral("Desk");
    open();
  }
  template <class Get>
  auto of_school(Get get) {
    const std::lock_guard lock(school->mutex);
    return get(*school);
  }
  StationsModel* model() { return window->stations_page()->stations(); }
  void arrive(StationMessage m) {
    const std::lock_guard lock(school->mutex);
    school->inbox.push_back(std::move(m));
  }
  std::shared_ptr<FakeSchool> school = std::make_shared<FakeSchool>();
};

TEST_F(StationsWindow, AloneItSaysWhatToSet) {
  open();
  QTest::keyClick(window.get(), Qt::Key_7, Qt::ControlModifier);
  const auto* words = child<QLabel>("no_stations");
  ASSERT_TRUE(words->isVisible());
  EXPECT_TRUE(words->text().contains("swage-console --store postgresql://user@server/swage?sslmode=verify-full"));
  EXPECT_FALSE(child<QTableView>("stations")->isVisible());
}

TEST_F(StationsWindow, AServerThatIsNotThereIsSaidAndTriedAgain) {
  school->refuse = "The server is asleep.";
  open_school();
  click("page_stations");
  ASSERT_TRUE(eventually([&] { return child<QLabel>("no_stations")->text().contains("The server is asleep."); }));
  of_school([](FakeSchool& s) { return s.refuse.clear(), 0; });
  EXPECT_TRUE(eventually([&] { return model()->rowCount() == 6; }));
  EXPECT_TRUE(child<QTableView>("stations")->isVisible());
  EXPECT_FALSE(child<QLabel>("stations_problem")->isVisible());
}

TEST_F(StationsWindow, SeesAllAndIsAskedOnlyWhileSomebodyLooks) {
  open_school();
  ASSERT_TRUE(eventually([&] { return of_school([](FakeSchool& s) { return s.beats; }) >= 2; }));
  EXPECT_EQ(of_school([](FakeSchool& s) { return s.looks; }), 0);
  click("page_stations");
  ASSERT_TRUE(eventually([&] { return model()->rowCount() == 6; }));
  EXPECT_EQ(child<QLabel>("stations_count")->text(), "6 stations");
  EXPECT_EQ(model()->row_of(QStringLiteral("Desk")), 0);
  EXPECT_EQ(cell(*model(), 0, StationsModel::kStation), "Desk (here)");
  window->stations_page()->choose(QStringLiteral("Table 4"));
  EXPECT_FALSE(child<QPushButton>("send_words")->isEnabled()) << "nobody is there to read it";
  EXPECT_FALSE(child<QPushButton>("mark_station")->isEnabled());
  click("forget_station");
  EXPECT_TRUE(eventually([&] { return model()->row_of(QStringLiteral("Table 4")) < 0; }));
}

TEST_F(StationsWindow, WritesGivesAndMarksByKeys) {
  open_school();
  QTest::keyClick(window.get(), Qt::Key_7, Qt::ControlModifier);
  ASSERT_TRUE(eventually([&] { return model()->rowCount() == 6; }));
  auto* table = child<QTableView>("stations");
  EXPECT_TRUE(table->hasFocus());
  QTest::keyClick(table, Qt::Key_Down);
  EXPECT_EQ(window->stations_page()->chosen(), "Table 1");
  QTest::keyClick(table, Qt::Key_Return);
  auto* words = child<QLineEdit>("station_words");
  ASSERT_TRUE(words->hasFocus());
  QTest::keyClicks(words, QStringLiteral("Take the tips"));
  QTest::keyClick(words, Qt::Key_Return);
  EXPECT_EQ(words->text(), "");
  ASSERT_TRUE(eventually([&] { return child<QListWidget>("sent")->count() == 1; }));
  EXPECT_EQ(child<QListWidget>("sent")->item(0)->text(), "Table 1   Take the tips   ○ sent");
  QTest::keyClick(window.get(), Qt::Key_L, Qt::ControlModifier);
  ASSERT_TRUE(eventually([&] { return child<QListWidget>("sent")->count() == 2; }));
  const StationMessage lesson = of_school([](FakeSchool& s) { return s.sent.front(); });
  EXPECT_EQ(lesson.kind, StationMessage::Kind::kLesson);
  EXPECT_EQ(QString::fromStdString(lesson.title), child<QComboBox>("station_lesson")->currentText());
  QTest::keyClicks(child<QLineEdit>("station_moment"), QStringLiteral("slips"));
  QTest::keyClick(window.get(), Qt::Key_M, Qt::ControlModifier);
  ASSERT_TRUE(eventually([&] { return child<QLabel>("station_said")->text().contains("00:40"); }));
  EXPECT_EQ(of_school([](FakeSchool& s) { return s.marks; }), std::vector<std::string>{"Table 1 slips"});
}

TEST_F(StationsWindow, SaysWhatItsTraineeDoes) {
  script.rate = 20;
  script.end_s = 0;
  open_school();
  ASSERT_TRUE(eventually([&] { return of_school([](FakeSchool& s) { return s.beats; }) >= 1; }));
  EXPECT_EQ(of_school([](FakeSchool& s) { return s.said.state; }), StationState::kIdle);
  EXPECT_NE(of_school([](FakeSchool& s) { return s.said.lesson_title; }), "");
  click("start");
  ASSERT_TRUE(eventually([&] { return of_school([](FakeSchool& s) { return s.said.state == StationState::kRunning && s.said.time_s > 4; }); }));
  const StationNow said = of_school([](FakeSchool& s) { return s.said; });
  EXPECT_EQ(said.lesson_id, control()->card().lesson_id);
  EXPECT_EQ(said.person, page()->setup()->person().toStdString());
  EXPECT_GT(said.step, 0u);
  EXPECT_FALSE(said.phase.empty());
  click("pause");
  EXPECT_TRUE(eventually([&] { return of_school([](FakeSchool& s) { return s.said.state; }) == StationState::kPaused; }));
}

TEST_F(StationsWindow, AMessageCoversNoWorkAndIsAnsweredByAKey) {
  script.rate = 20;
  script.end_s = 0;
  arrive({"m1", "Desk", "Teacher", StationMessage::Kind::kWords, "Take the tips", "", "", 0, false});
  open_school();
  window->toggle_trainee();
  ASSERT_NE(window->trainee(), nullptr);
  auto* strip = window->messages();
  ASSERT_TRUE(eventually([&] { return strip->isVisible(); }));
  EXPECT_EQ(child<QLabel>("message_words")->text(), "✉ Teacher: Take the tips");
  EXPECT_TRUE(window->trainee()->view()->message().startsWith("✉ Teacher: Take the tips"));
  // beside the picture, not over it
  const QRect picture(page()->view()->mapTo(window.get(), QPoint()), page()->view()->size());
  const QRect words(strip->mapTo(window.get(), QPoint()), strip->size());
  EXPECT_FALSE(picture.intersects(words));
  QTest::keyClick(window.get(), Qt::Key_F3);
  EXPECT_FALSE(strip->isVisible());
  EXPECT_EQ(window->trainee()->view()->message(), "");
  EXPECT_TRUE(eventually([&] { return of_school([](FakeSchool& s) { return s.answers; }) == std::vector<std::string>{"m1 read"}; }));
}

TEST_F(StationsWindow, ALessonIsTakenBetweenAttempts) {
  script.rate = 20;
  script.end_s = 0;
  arrive({"m1", "Desk", "Teacher", StationMessage::Kind::kLesson, "no.such.lesson", "Nowhere", "", 0, false});
  open_school();
  ASSERT_TRUE(eventually([&] { return of_school([](FakeSchool& s) { return s.answers; }) == std::vector<std::string>{"m1 missing"}; }));
  EXPECT_FALSE(window->messages()->isVisible()) << "the trainee could do nothing about it";
  window.reset();

  const console::LessonEntry wanted = console::read_lesson(launch.lesson_folders[0] + QStringLiteral("/020_carry.json"));
  arrive({"m2", "Desk", "Teacher", StationMessage::Kind::kLesson, wanted.id.toStdString(), wanted.title.toStdString(), "", 0, false});
  open_school();
  ASSERT_TRUE(eventually([&] { return window->messages()->isVisible(); }));
  click("start");
  EXPECT_FALSE(child<QPushButton>("accept_message")->isEnabled());
  QTest::keyClick(window.get(), Qt::Key_F3);
  EXPECT_TRUE(window->messages()->isVisible()) << "an attempt runs";
  control()->stop();
  ASSERT_TRUE(child<QPushButton>("accept_message")->isEnabled());
  click("page_setup");
  QTest::keyClick(window.get(), Qt::Key_F3);
  EXPECT_EQ(page()->setup()->lesson(), wanted.path);
  EXPECT_TRUE(page()->isVisible());
  EXPECT_TRUE(eventually([&] { return of_school([](FakeSchool& s) { return s.answers.back(); }) == "m2 taken"; }));
}

class StationsServer : public WindowTest {
 protected:
  void SetUp() override {
    if (!server.running()) GTEST_SKIP() << server.why_not();
    qputenv("XDG_DATA_HOME", dir.path().toUtf8());
    where = server.make_database("school");
    open_stations = [this](std::string& error) { return Stations::open(where, error); };
    launch.station = QStringLiteral("Table 1");
  }
  void TearDown() override {
    window.reset();
    qunsetenv("XDG_DATA_HOME");
  }
  std::unique_ptr<Stations> enter(const char* wanted) {
    std::string error, name;
    auto out = Stations::open(where, error);
    EXPECT_TRUE(out) << error;
    if (out) {
      EXPECT_TRUE(out->enter(wanted, record::make_id(), name)) << out->error();
    }
    return out;
  }
  PostgresServer server;
  std::string where;
};

// No polling: messages arrive because the server notifies.
TEST_F(StationsServer, NotificationsArriveInTheEventLoop) {
  const auto desk = enter("Desk"), table = enter("Table 2");
  int now = 0, message = 0;
  ASSERT_TRUE(desk->listen(Stations::Channel::kNow, [&] { ++now; })) << desk->error();
  ASSERT_TRUE(table->listen(Stations::Channel::kMessage, [&] { ++message; })) << table->error();
  QTest::qWait(50);
  now = 0;
  ASSERT_TRUE(table->say({}));
  EXPECT_TRUE(eventually([&] { return now == 1; }));
  EXPECT_EQ(message, 0);
  StationMessage m;
  m.to = "Table 2";
  ASSERT_TRUE(desk->send(m));
  EXPECT_TRUE(eventually([&] { return message == 1; })) << message;
}

TEST_F(StationsServer, AWindowIsSeenWrittenToAndPictured) {
  script.rate = 20;
  script.end_s = 0;
  open();
  click("start");
  const auto desk = enter("Desk");
  std::vector<StationNow> all;
  ASSERT_TRUE(eventually([&] { return desk->all(all) && all.size() == 2 && all[1].state == StationState::kRunning; }));
  EXPECT_EQ(all[1].station, "Table 1");
  StationMessage words;
  words.to = "Table 1";
  words.body = "Take the tips";
  ASSERT_TRUE(desk->send(words));
  ASSERT_TRUE(eventually([&] { return window->messages()->isVisible(); }));
  std::vector<StationMessage> sent;
  EXPECT_TRUE(eventually([&] { return desk->sent(sent) && sent[0].shown && sent[0].answer.empty(); }));
  QTest::keyClick(window.get(), Qt::Key_F3);
  EXPECT_TRUE(eventually([&] { return desk->sent(sent) && sent[0].answer == "read"; }));
  StationMessage picture;
  picture.to = "Table 1";
  picture.kind = StationMessage::Kind::kPicture;
  ASSERT_TRUE(desk->send(picture));
  std::string png;
  double age_s = 0;
  ASSERT_TRUE(eventually([&] { return desk->picture("Table 1", png, age_s) && !png.empty(); }));
  const QImage image = QImage::fromData(QByteArray::fromStdString(png), "PNG");
  EXPECT_EQ(image.width(), 480);
  EXPECT_LT(png.size(), 300000u);
  window.reset();
  ASSERT_TRUE(desk->all(all));
  EXPECT_EQ(all[1].state, StationState::kClosed);
}

// Number of turns of the event loop in a period, and the longest interval between two, s.
struct Smoothness {
  int turns = 0;
  double longest_s = 0;
};
Smoothness smoothness(int ms) {
  Smoothness out;
  QElapsedTimer all, last;
  QTimer timer;
  timer.setTimerType(Qt::PreciseTimer);
  QObject::connect(&timer, &QTimer::timeout, [&] {
    out.longest_s = std::max(out.longest_s, 1e-9 * static_cast<double>(last.nsecsElapsed()));
    last.restart();
    ++out.turns;
  });
  all.start();
  last.start();
  timer.start(5);
  QTest::qWait(ms);
  return out;
}

TEST_F(StationsServer, AFrozenServerLeavesTheWindowSmooth) {
  constexpr int kWatched_ms = 5000;  // longer than a connection waits for an answer
  script.rate = 20;
  script.end_s = 0;
  open();
  click("page_stations");
  ASSERT_TRUE(eventually([&] { return window->stations_page()->stations()->rowCount() == 1; }));
  const Smoothness before = smoothness(kWatched_ms);
  server.freeze(true);
  window->stations()->send(QStringLiteral("Table 1"), StationMessage::Kind::kWords, QStringLiteral("Nobody reads this"));
  const Smoothness frozen = smoothness(kWatched_ms);
  EXPECT_TRUE(eventually([&] { return !window->stations()->problem().isEmpty(); })) << "it did meet the frozen server";
  EXPECT_TRUE(child<QLabel>("stations_problem")->isVisible());
  EXPECT_EQ(window->stations_page()->stations()->rowCount(), 1) << "what was seen stays to be read";
  // a blocked window would make 2/5 of the turns, and none for 3 s
  EXPECT_GT(frozen.turns, before.turns / 2) << before.turns;
  EXPECT_LT(frozen.longest_s, 1.0) << "before: " << before.longest_s;
  std::printf("turns in %d ms: %d before, %d frozen; longest wait %.1f and %.1f ms\n", kWatched_ms, before.turns, frozen.turns,
              1e3 * before.longest_s, 1e3 * frozen.longest_s);
  server.freeze(false);
  EXPECT_TRUE(eventually([&] { return window->stations()->problem().isEmpty(); })) << "and comes back by itself";
  EXPECT_EQ(window->stations()->name(), "Table 1") << "under its own name";
}

}  // namespace
}  // namespace swage::test
