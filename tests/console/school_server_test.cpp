// SPDX-License-Identifier: Apache-2.0
//
// A synthetic school in a file, and on a PostgreSQL server while stations record into it: every page opens, and no written data is
// lost. Small by default; the label soak (SWAGE_SOAK_SCHOOL=1) has 5 000 attempts and ten stations. Prints what pages and stations took.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "postgres_server.hpp"
#include "record/identity.hpp"
#include "record/recorder.hpp"
#include "record/stations.hpp"
#include "record/synthetic.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

using Clock = std::chrono::steady_clock;

bool soak() { return qEnvironmentVariableIsSet("SWAGE_SOAK_SCHOOL"); }
double ms_since(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

record::AttemptInfo lesson(const std::string& person, uint32_t flags) {
  record::AttemptInfo info;
  info.person = person;
  info.lesson_id = "org.example.a";
  info.lesson_title = "A lesson";
  info.mode = "test";
  info.device = "hand";
  info.devices = {"hand"};
  info.hands = {{"hand", "", "swage.device.scripted", "1.0.0", "{}", flags}};
  for (int i = 0; i < 30; ++i) info.script.metrics.push_back({"lesson", "metric." + std::to_string(i), "1", ""});
  return info;
}

std::string keep_hand(const std::string& store, double score) {
  base::Problems problems;
  const auto recorder = record::Recorder::open(store, lesson("hand", SWAGE_DEVICE_SCRIPTED), problems);
  if (!recorder) return {};
  record::AttemptEnd end;
  end.outcome = judge::Outcome::kPassed;
  end.score = score;
  end.simulated_s = 1000 / score;
  for (int i = 0; i < 30; ++i) end.metric.push_back(score + i);
  recorder->finish(end);
  return recorder->attempt_id();
}

/// A station: attempts at 1 kHz one after the other, and a state report twice a second, until it is stopped.
class Table {
 public:
  Table(std::string where, int number) : where_(std::move(where)), number_(number), thread_([this] { work(); }) {}
  void end() { ends_ = true, thread_.join(); }
  std::vector<std::string> attempts;
  uint64_t steps = 0, dropped = 0, beats = 0, refused = 0;
  double slowest_beat_ms = 0;

 private:
  void work() {
    std::string error, name;
    const auto stations = record::Stations::open(where_, error);
    if (!stations || !stations->enter("Table " + std::to_string(number_), record::make_id(), name)) return void(++refused);
    while (!ends_) attempt(*stations);
    stations->leave();
  }
  void attempt(record::Stations& stations) {
    constexpr uint64_t kSteps = 3000, kBeatSteps = 500;
    record::AttemptInfo info = lesson("Trainee " + std::to_string(number_), 0);
    info.realtime = true;
    base::Problems problems;
    const auto recorder = record::Recorder::open(where_, info, problems);
    if (!recorder) return void(++refused);
    auto deadline = Clock::now();
    for (uint64_t i = 0; i < kSteps && !ends_; ++i) {
      record::StepRecord step{};
      step.step = i;
      step.hash = i * 0x9e3779b97f4a7c15ull;
      step.n_device = 1;
      recorder->step(step);
      if (i % kBeatSteps == 0) beat(stations, recorder->attempt_id(), i);
      std::this_thread::sleep_until(deadline += std::chrono::milliseconds(1));
      ++steps;
    }
    record::AttemptEnd end;
    end.outcome = judge::Outcome::kPassed;
    recorder->finish(end);
    dropped += recorder->dropped();
    if (recorder->kept().where == record::Kept::Where::kStore) attempts.push_back(recorder->attempt_id());
  }
  void beat(record::Stations& stations, const std::string& attempt, uint64_t step) {
    record::StationNow now;
    now.state = record::StationState::kRunning;
    now.attempt_id = attempt;
    now.step = step;
    now.time_s = 1e-3 * static_cast<double>(step);
    const auto start = Clock::now();
    stations.say(now) ? ++beats : ++refused;
    slowest_beat_ms = std::max(slowest_beat_ms, ms_since(start));
  }

  const std::string where_;
  const int number_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

class BigSchool : public WindowTest {
 protected:
  BigSchool() { with_school = true; }
  void SetUp() override { qputenv("XDG_DATA_HOME", dir.path().toUtf8()); }
  void TearDown() override {
    window.reset();
    qunsetenv("XDG_DATA_HOME");
  }
  void write() {
    record::SyntheticSchool school;
    school.from = dir.filePath(QStringLiteral("hands.db")).toStdString();
    school.lessons = {{keep_hand(school.from, 98), {keep_hand(school.from, 60), keep_hand(school.from, 50)}}};
    school.attempts = soak() ? 5000 : 300;
    school.recordings = 1;
    std::string error;
    const auto start = Clock::now();
    ASSERT_TRUE(record::write_synthetic_school(school_file(), school, error)) << error;
    std::printf("%u attempts written in %.1f s\n", school.attempts, 1e-3 * ms_since(start));
  }
  /// Prints times from the click to the painted page; for the window, from its construction.
  void tell_open_times(const char* store) {
    auto start = Clock::now();
    open();
    std::printf("%s: window %.0f ms\n", store, ms_since(start));
    for (const char* page : {"page_people", "page_courses", "page_lessons", "page_review", "page_setup", "page_stations", "page_run"}) {
      if (!window->findChild<QPushButton*>(QString::fromLatin1(page))) continue;  // a file has no stations
      std::vector<double> took;
      for (int round = 0; round < (soak() ? 7 : 1); ++round) {
        click(page == std::string("page_run") ? "page_setup" : "page_run");
        QApplication::processEvents();
        start = Clock::now();
        click(page);
        QApplication::processEvents();
        window->grab();
        took.push_back(ms_since(start));
        EXPECT_TRUE(child<QPushButton>(page)->isChecked());
      }
      const double first = took[0];
      std::sort(took.begin(), took.end());
      std::printf("%s: %s first %.0f, median %.0f, worst %.0f ms\n", store, page, first, took[took.size() / 2], took.back());
    }
    EXPECT_GT(window->people_page()->people()->rowCount(), 29);
  }
};

using SchoolInAFile = BigSchool;

TEST_F(SchoolInAFile, EveryPageOpens) {
  write();
  tell_open_times("SQLite");
}

class SchoolOnAServer : public BigSchool {
 protected:
  /// Times reads of everybody's attempts while stations write: all of them, as at the first visit of a page, and the new ones.
  void tell_read_times(int rounds) {
    std::string error;
    const auto known = record::Store::open(school_place, error);
    ASSERT_TRUE(known) << error;
    known->attempt_heads();
    std::vector<double> whole, renewed;
    for (int i = 0; i < rounds; ++i) {
      const auto fresh = record::Store::open(school_place, error);
      ASSERT_TRUE(fresh) << error;
      auto start = Clock::now();
      const size_t n = fresh->attempt_heads().size();
      whole.push_back(ms_since(start));
      start = Clock::now();
      EXPECT_GE(known->attempt_heads().size(), n);
      renewed.push_back(ms_since(start));
    }
    const auto median = [](std::vector<double>& v) { return std::nth_element(v.begin(), v.begin() + static_cast<long>(v.size() / 2), v.end()), v[v.size() / 2]; };
    const double all = median(whole), some = median(renewed);
    std::printf("list of all attempts, median of %d: %.0f ms read whole, %.1f ms renewed, ratio %.1f\n", rounds, all, some, all / some);
  }
  void SetUp() override {
    if (!server.running()) GTEST_SKIP() << server.why_not();
    BigSchool::SetUp();
    school_place = server.make_database("school");
    open_stations = [this](std::string& error) { return record::Stations::open(school_place, error); };
    launch.station = QStringLiteral("Desk");
  }
  record::test::PostgresServer server;
};

TEST_F(SchoolOnAServer, EveryPageOpensWhileStationsWrite) {
  const int kStations = soak() ? 10 : 3;
  write();
  std::vector<std::unique_ptr<Table>> tables;
  for (int i = 0; i < kStations; ++i) tables.push_back(std::make_unique<Table>(school_place, i + 1));
  tell_open_times("PostgreSQL, stations write");
  tell_read_times(soak() ? 15 : 3);
  click("page_stations");
  EXPECT_TRUE(eventually([&] { return window->stations_page()->stations()->rowCount() == kStations + 1; }));
  // each has ended at least one attempt
  QTest::qWait(soak() ? 20000 : 4000);

  uint64_t steps = 0, beats = 0;
  double slowest = 0;
  std::string error;
  for (const auto& table : tables) table->end();
  for (const auto& table : tables) {
    EXPECT_EQ(table->refused, 0u);
    EXPECT_EQ(table->dropped, 0u);
    EXPECT_GE(table->attempts.size(), 1u);
    for (const std::string& id : table->attempts) EXPECT_TRUE(record::check_recording(school_place, id, error)) << error;
    steps += table->steps;
    beats += table->beats;
    slowest = std::max(slowest, table->slowest_beat_ms);
  }
  std::printf("%d stations: %llu steps, none lost; %llu beats, the slowest %.0f ms\n", kStations,
              static_cast<unsigned long long>(steps), static_cast<unsigned long long>(beats), slowest);
}

}  // namespace
}  // namespace swage::test
