// SPDX-License-Identifier: Apache-2.0
//
// The list of attempts that a store keeps and renews is at any time what a store that is opened anew reads: after random edits by
// other connections, and of transactions that end in another order than they began. On SQLite and on a server.
#include "record/attempt_heads.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <random>

#include "attempt.hpp"
#include "postgres_server.hpp"
#include "record/identity.hpp"
#include "record/school.hpp"
#include "record/schema.hpp"

namespace swage::record::test {
namespace {

PostgresServer& server() {
  static PostgresServer one;
  return one;
}

std::string told_metrics(const AttemptRow& a) {
  std::string out;
  for (const MetricValue& m : a.metrics) out += "|" + m.id + " " + std::to_string(m.value) + " " + m.unit;
  return out;
}

// Every field, so that one that is renewed wrongly is named; a score that is not there is NaN.
std::string told(const AttemptRow& a) {
  std::string out;
  for (const std::string& s : {a.id, a.person_id, a.person_name, a.person_code, a.lesson_id, a.lesson_title, a.mode, a.device,
                               a.started_utc, a.ended_utc, a.state, a.outcome, a.reason, a.remark, a.void_reason, a.void_by,
                               a.lesson_digest})
    out += s + "|";
  return out + std::to_string(a.score) + "|" + std::to_string(a.simulated_s) + "|" + std::to_string(a.is_void) +
         std::to_string(a.is_scripted) + std::to_string(a.is_synthetic) + told_metrics(a);
}

std::vector<std::string> told(const std::vector<AttemptRow>& rows) {
  std::vector<std::string> out;
  for (const AttemptRow& a : rows) out.push_back(told(a));
  return out;
}

class HeadsTest : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    where_ = folder_ / "a.db";
    if (on_server()) {
      if (!server().running()) GTEST_SKIP() << server().why_not();
      static int count = 0;
      where_ = server().make_database("heads" + std::to_string(++count));
    }
    school_ = School::open(where_, error_);
    store_ = Store::open(where_, error_);
    ASSERT_TRUE(school_ && store_) << error_;
  }
  void TearDown() override { unsetenv("XDG_DATA_HOME"); }
  bool on_server() const { return GetParam() == std::string("PostgreSQL"); }

  std::size_t draw(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  std::string some_attempt() { return known_.empty() ? "" : known_[draw(known_.size())].id; }
  std::string some_person() {
    const auto people = school_->people();
    return people.empty() ? "" : people[draw(people.size())].id;
  }

  void record() {
    base::Problems problems;
    const char* names[] = {"Ada", "Bo", "Cem", kGuest};
    AttemptInfo info = make_info(draw(1000), names[draw(4)]);
    info.realtime = draw(2) == 0;
    info.lesson_id = draw(2) == 0 ? "org.example.a" : "org.example.b";
    const auto recorder = Recorder::open(where_, info, problems);
    ASSERT_TRUE(recorder);
    if (draw(5) == 0) return;  // as if the program had died
    AttemptEnd end = make_end();
    end.outcome = draw(2) == 0 ? judge::Outcome::kPassed : judge::Outcome::kFailed;
    end.is_void = draw(6) == 0;
    if (draw(3) == 0) end.health.dropped = 1000;
    if (draw(4) == 0) end.forces_off_s = 1.5;
    recorder->finish(end);
  }

  void rename() {
    auto people = school_->people();
    if (people.empty()) return;
    Person& p = people[draw(people.size())];
    if (p.code == kGuest) return;
    p.name += draw(2) == 0 ? "x" : "y";
    EXPECT_TRUE(school_->change_person(p)) << school_->error();
  }

  void bring_in() {
    const std::string id = some_attempt();
    if (id.empty() || known_.front().state == "running") return;
    const std::string file = folder_ / (make_id() + ".swage");
    const auto other = Store::open(where_, error_);
    if (!other->export_attempt(id, file, error_)) return;
    // it comes back after its person may have been erased, or is there already
    std::string same;
    if (draw(2) == 0) school_->erase_person(some_person());
    other->import_attempt(file, same, error_);
  }

  void compare_attempts(const std::string& person) {
    ASSERT_EQ(told(store_->attempts(person, "")), told(Store::open(where_, error_)->attempts(person, "")));
  }

  void edit() {
    switch (draw(9)) {
      case 0:
      case 1:
      case 2:
        return record();
      case 3:
        school_->set_void(some_attempt(), draw(2) == 0, "why " + std::to_string(draw(100)), "Mei");
        return;
      case 4:
        return rename();
      case 5:
        school_->name_attempt(some_attempt(), some_person(), "Mei", true);
        return;
      case 6:
        if (draw(3) == 0) school_->erase_person(some_person());
        return;
      case 7:
        return bring_in();
      default:
        Store::open(where_, error_)->recover();
        return;
    }
  }

  Folder folder_;
  std::mt19937 random_{20261124};
  std::string where_, error_;
  std::unique_ptr<School> school_;
  std::unique_ptr<Store> store_;
  std::vector<AttemptRow> known_;
};

TEST_P(HeadsTest, AreThoseOfAFullReadAfterAnyEdit) {
  std::size_t most = 0, erased = 0;
  for (int i = 0; i < 120; ++i) {
    edit();
    if (draw(3) == 0) continue;  // several edits between two looks
    const std::size_t before = known_.size();
    known_ = Store::open(where_, error_)->attempt_heads();
    ASSERT_EQ(told(store_->attempt_heads()), told(known_)) << "after edit " << i;
    EXPECT_EQ(store_->trouble(), "");
    // metrics are kept, too
    if (draw(3) == 0) {
      ASSERT_NO_FATAL_FAILURE(compare_attempts(draw(2) == 0 ? "" : some_person()));
    }
    most = std::max(most, known_.size());
    erased += known_.size() < before;
  }
  EXPECT_GT(most, 10u);
  EXPECT_GT(erased, 0u);
  if (known_.empty()) return;
  const std::string person = known_[0].person_id, lesson = known_[0].lesson_id;
  EXPECT_EQ(told(store_->attempt_heads(person, lesson)), told(Store::open(where_, error_)->attempt_heads(person, lesson)));
}

TEST_P(HeadsTest, SeeWhatTheirOwnStoreWrites) {
  const std::string id = record_attempt(where_, 300, 1, "Ada");
  ASSERT_EQ(store_->attempt_heads().size(), 1u);
  const std::string file = folder_ / "one.swage";
  ASSERT_TRUE(store_->export_attempt(id, file, error_)) << error_;
  const auto other = Store::open(folder_ / "b.db", error_);
  EXPECT_TRUE(other->attempt_heads().empty());
  std::string same;
  ASSERT_TRUE(other->import_attempt(file, same, error_)) << error_;
  EXPECT_EQ(other->attempt_heads().size(), 1u);
}

TEST_P(HeadsTest, ReadOnlyWhatIsNew) {
  for (int i = 0; i < 30; ++i) record_attempt(where_, 1, 7, "Ada");
  const auto db = open_store(where_, error_);
  ASSERT_TRUE(db) << error_;
  AttemptHeads heads(*db, true);
  ASSERT_TRUE(heads.renew());
  ASSERT_EQ(heads.rows_read(), 30u);
  // a table that a server tidies up meanwhile has no new rows; a transaction of its own may hold the mark for a moment
  ASSERT_TRUE(heads.renew());
  EXPECT_LE(heads.rows_read(), 33u);
  EXPECT_TRUE(on_server() || heads.rows_read() == 30u);
  ASSERT_TRUE(school_->set_void(heads.all()[17].id, true, "why", "Mei"));
  ASSERT_TRUE(heads.renew());
  EXPECT_TRUE(heads.all()[17].is_void);
  EXPECT_TRUE(!on_server() || heads.rows_read() <= 36u) << heads.rows_read();
}

// The last transaction to end is not the last that began: a mark that is the newest number, or time, seen so far would miss it.
TEST_P(HeadsTest, SeeATransactionThatEndsLate) {
  if (!on_server()) GTEST_SKIP() << "SQLite has one writer at a time.";
  const std::string early = record_attempt(where_, 1, 7, "Ada");
  ASSERT_EQ(store_->attempt_heads().size(), 1u);
  const auto late = open_store(where_, error_);
  ASSERT_TRUE(late && late->begin()) << error_;
  ASSERT_TRUE(late->run("UPDATE attempt SET reason = ? WHERE attempt_id = ?", {std::string("late"), early}));
  for (int i = 0; i < 3; ++i) {
    record_attempt(where_, 1, 8, "Bo");
    EXPECT_EQ(store_->attempt_heads().size(), 2u + static_cast<std::size_t>(i));
    EXPECT_NE(store_->attempt_heads().back().reason, "late");
  }
  ASSERT_TRUE(late->commit());
  EXPECT_EQ(store_->attempt_heads().back().reason, "late");
}

TEST_P(HeadsTest, AfterAnErrorEverythingIsReadAgain) {
  record_attempt(where_, 1, 7, "Ada");
  ASSERT_EQ(store_->attempt_heads().size(), 1u);
  const auto db = open_store(where_, error_);
  ASSERT_TRUE(db->run("ALTER TABLE provenance RENAME TO provenance_away"));
  EXPECT_TRUE(store_->attempt_heads().empty());
  EXPECT_NE(store_->trouble(), "");
  ASSERT_TRUE(db->run("ALTER TABLE provenance_away RENAME TO provenance"));
  EXPECT_EQ(store_->attempt_heads().size(), 1u);
  EXPECT_EQ(store_->trouble(), "");
}

INSTANTIATE_TEST_SUITE_P(Stores, HeadsTest, testing::Values("SQLite", "PostgreSQL"),
                         [](const auto& store) { return std::string(store.param); });

}  // namespace
}  // namespace swage::record::test
