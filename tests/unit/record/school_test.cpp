// SPDX-License-Identifier: Apache-2.0
//
// People, groups, courses, published lessons, decisions and notes: the same suite on SQLite and on a server of the test's own.
#include "record/school.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <iterator>

#include "attempt.hpp"
#include "base/clock.hpp"
#include "postgres_server.hpp"
#include "record/backup.hpp"
#include "record/identity.hpp"
#include "record/sentences.hpp"

namespace swage::record::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// one server for all tests: it takes a second to start
PostgresServer& server() {
  static PostgresServer one;
  return one;
}

class SchoolTest : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    where_ = folder_ / "a.db";
    if (on_server()) {
      if (!server().running()) GTEST_SKIP() << server().why_not();
      static int count = 0;
      where_ = server().make_database("school" + std::to_string(++count));
    }
    school_ = School::open(where_, error_);
    ASSERT_TRUE(school_) << error_;
  }
  void TearDown() override { unsetenv("XDG_DATA_HOME"); }
  bool on_server() const { return GetParam() == std::string("PostgreSQL"); }

  Person add(const std::string& name, const std::string& group = "") {
    Person p;
    p.name = name;
    p.group_id = group;
    EXPECT_TRUE(school_->add_person(p)) << school_->error();
    return p;
  }
  AttemptRow attempt(const std::string& id) {
    AttemptRow row;
    EXPECT_TRUE(Store::open(where_, error_)->attempt(id, row)) << error_;
    return row;
  }

  Folder folder_;
  std::string where_, error_;
  std::unique_ptr<School> school_;
};

TEST_P(SchoolTest, APersonHasANameHereAndACodeElsewhere) {
  Person ada = add("Ada Meyer");
  EXPECT_THAT(ada.code, testing::MatchesRegex("[0-9A-HJKMNP-TV-Z]+"));
  EXPECT_EQ(ada.code.size(), 5u);
  ada.handedness = "left";
  ASSERT_TRUE(school_->change_person(ada)) << school_->error();

  // an attempt that names the name, and one that names the code, are both this person's
  const std::string by_name = record_attempt(where_, 300, 1, "Ada Meyer"), by_code = record_attempt(where_, 300, 2, ada.code);
  ASSERT_EQ(school_->people().size(), 1u);
  EXPECT_EQ(school_->people()[0].attempts, 2u);
  EXPECT_EQ(school_->people()[0].handedness, "left");
  EXPECT_EQ(attempt(by_name).person_name, "Ada Meyer");
  EXPECT_EQ(attempt(by_name).person_code, ada.code);
  EXPECT_EQ(attempt(by_code).person_id, ada.id);

  // and nothing that leaves the store says the name
  const auto store = Store::open(where_, error_);
  ASSERT_TRUE(store->export_attempt(by_name, folder_ / "one.swage", error_)) << error_;
  std::ifstream file(folder_ / "one.swage", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(bytes, HasSubstr(ada.code));
  EXPECT_THAT(bytes, testing::Not(HasSubstr("Ada Meyer")));
  EXPECT_EQ(store->person("Ada Meyer").id, ada.id);
}

TEST_P(SchoolTest, RefusesWhatWouldBeMistaken) {
  const Person ada = add("Ada");
  Person again;
  again.name = "Ada";
  EXPECT_FALSE(school_->add_person(again));
  EXPECT_THAT(school_->error(), HasSubstr(say::kNameTaken("Ada")));
  again.name = "Ada 2";
  again.code = ada.code;
  EXPECT_FALSE(school_->add_person(again));
  EXPECT_THAT(school_->error(), HasSubstr(say::kCodeTaken(again.code)));
  again.code = "";
  again.handedness = "both";
  EXPECT_FALSE(school_->add_person(again));
  EXPECT_THAT(school_->error(), HasSubstr(say::kNoHandedness("both")));
  EXPECT_EQ(school_->people().size(), 1u);
  Person found;
  EXPECT_FALSE(school_->find_person("Bo", found));
  EXPECT_THAT(school_->error(), HasSubstr(say::kNobody("Bo")));
  record_attempt(where_, 10, 1, "Ada");
  EXPECT_FALSE(school_->remove_person(ada.id));
  EXPECT_THAT(school_->error(), HasSubstr(say::kHasAttempts()));
}

TEST_P(SchoolTest, GroupsAndTheirPeople) {
  Group a{"", "Residents", "", ""}, b{"", "Fellows", "", ""};
  ASSERT_TRUE(school_->add_group(a) && school_->add_group(b)) << school_->error();
  Group twice{"", "Fellows", "", ""};
  EXPECT_FALSE(school_->add_group(twice));
  const Person ada = add("Ada", a.id);
  ASSERT_EQ(school_->groups().size(), 2u);
  EXPECT_EQ(school_->groups()[0].name, "Residents") << "in the order in which they were made";
  EXPECT_EQ(school_->people()[0].group_id, a.id);
  ASSERT_TRUE(school_->remove_group(a.id));
  EXPECT_EQ(school_->people()[0].group_id, "");
  EXPECT_EQ(school_->groups().size(), 1u);
  // undo
  ASSERT_TRUE(school_->remove_person(ada.id));
  Person back = ada;
  ASSERT_TRUE(school_->add_person(back)) << school_->error();
  EXPECT_EQ(school_->people()[0].code, ada.code);
}

TEST_P(SchoolTest, AGuestsAttemptIsGivenANameLater) {
  const std::string first = record_attempt(where_, 300, 1, kGuest), second = record_attempt(where_, 300, 2, kGuest);
  const Person ada = add("Ada"), bo = add("Bo");
  ASSERT_TRUE(school_->name_attempt(first, ada.id, "Mei")) << school_->error();
  EXPECT_EQ(attempt(first).person_name, "Ada");
  EXPECT_EQ(attempt(second).person_name, kGuest) << "of the same sitting";
  EXPECT_EQ(Store::open(where_, error_)->damage(), "");
  const auto rulings = school_->rulings(first);
  ASSERT_EQ(rulings.size(), 1u);
  EXPECT_EQ(rulings[0].kind, Ruling::Kind::kNamed);
  EXPECT_EQ(rulings[0].reason, "Guest -> " + ada.code);
  EXPECT_FALSE(attempt(first).is_void);
  EXPECT_FALSE(school_->name_attempt(first, bo.id, "Mei"));
  EXPECT_THAT(school_->error(), HasSubstr(say::kNoGuest(first, ada.code)));
  ASSERT_TRUE(school_->name_attempt(first, bo.id, "Mei", true));
  EXPECT_EQ(attempt(first).person_name, "Bo");
  EXPECT_FALSE(school_->name_attempt("nobody", bo.id, "Mei"));
  EXPECT_THAT(school_->error(), HasSubstr(say::kNoAttempt("nobody")));
}

TEST_P(SchoolTest, AVoidAttemptSaysWhyAndByWhomAndCanCountAgain) {
  const std::string id = record_attempt(where_, 300);
  EXPECT_FALSE(school_->set_void(id, true, "", "Mei"));
  EXPECT_THAT(school_->error(), HasSubstr(say::kNeedsReason()));
  ASSERT_TRUE(school_->set_void(id, true, "the arm was unplugged", "Mei")) << school_->error();
  EXPECT_TRUE(attempt(id).is_void);
  EXPECT_EQ(attempt(id).void_reason, "the arm was unplugged");
  EXPECT_EQ(attempt(id).void_by, "Mei");
  // the decision goes with the attempt
  ASSERT_TRUE(Store::open(where_, error_)->export_attempt(id, folder_ / "one.swage", error_));
  const auto other = Store::open(folder_ / "b.db", error_);
  std::string same;
  ASSERT_TRUE(other->import_attempt(folder_ / "one.swage", same, error_)) << error_;
  EXPECT_EQ(other->attempts("")[0].void_by, "Mei");

  ASSERT_TRUE(school_->set_void(id, false, "it was not", "Mei"));
  EXPECT_FALSE(attempt(id).is_void);
  EXPECT_EQ(school_->rulings(id).size(), 2u);
  EXPECT_EQ(Store::open(where_, error_)->damage(), "") << "what the recorder wrote is as it was";
}

TEST_P(SchoolTest, NotesArePinnedToAMoment) {
  const std::string id = record_attempt(where_, 300);
  Note late{"", id, 250, 0.25, "", "Mei", "Here the wrist turns."}, early{"", id, 13, 0.013, "", "Mei", "Good start."};
  ASSERT_TRUE(school_->save_note(late) && school_->save_note(early)) << school_->error();
  late.text = "Here the wrist does not turn.";
  ASSERT_TRUE(school_->save_note(late));
  auto notes = school_->notes(id);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[0].text, "Good start.");
  EXPECT_EQ(notes[1].text, "Here the wrist does not turn.");
  EXPECT_DOUBLE_EQ(notes[1].time_s, 0.25);
  ASSERT_TRUE(school_->remove_note(early.id));
  EXPECT_EQ(school_->notes(id).size(), 1u);
  Note empty{"", id, 0, 0, "", "Mei", ""};
  EXPECT_FALSE(school_->save_note(empty));
  Note lost{"", "nobody", 0, 0, "", "Mei", "x"};
  EXPECT_FALSE(school_->save_note(lost));
}

TEST_P(SchoolTest, EachPersonRatesAnItemOnce) {
  const std::string id = record_attempt(where_, 300);
  const auto store = Store::open(where_, error_);
  store->changed();
  ObserverRating mei{id, "smart.efficiency", 4, "", "Mei"}, bo{id, "smart.efficiency", 2.5, "", "Bo"};
  ASSERT_TRUE(school_->save_rating(mei) && school_->save_rating(bo)) << school_->error();
  EXPECT_NE(mei.made_utc, "");
  EXPECT_TRUE(store->changed());
  mei.points = 3;
  ASSERT_TRUE(school_->save_rating(mei)) << school_->error();
  auto ratings = school_->ratings(id);
  ASSERT_EQ(ratings.size(), 2u) << "the later points of a person take the place of the earlier ones";
  EXPECT_EQ(ratings[0].made_by, "Bo");
  EXPECT_EQ(ratings[0].points, 2.5);
  EXPECT_EQ(ratings[1].points, 3);
  // they go with the attempt
  ASSERT_TRUE(Store::open(where_, error_)->export_attempt(id, folder_ / "one.swage", error_)) << error_;
  const auto other = Store::open(folder_ / "b.db", error_);
  std::string same;
  ASSERT_TRUE(other->import_attempt(folder_ / "one.swage", same, error_)) << error_;
  EXPECT_EQ(School::open(folder_ / "b.db", error_)->ratings(id).size(), 2u);
  ASSERT_TRUE(school_->remove_rating(id, "smart.efficiency", "Bo"));
  ratings = school_->ratings(id);
  ASSERT_EQ(ratings.size(), 1u);
  EXPECT_EQ(ratings[0].made_by, "Mei");
  ObserverRating lost{"nobody", "smart.efficiency", 4, "", "Mei"}, nothing{id, "", 4, "", "Mei"};
  EXPECT_FALSE(school_->save_rating(lost));
  EXPECT_FALSE(school_->save_rating(nothing));
}

TEST_P(SchoolTest, APublishedLessonIsOneVersionPerText) {
  LessonVersion one, same, two;
  ASSERT_TRUE(school_->publish_lesson("org.example.a", "A", R"({"format": "swage-lesson/1", "x": 1})", one)) << school_->error();
  ASSERT_TRUE(school_->publish_lesson("org.example.a", "A", "{\"x\": 1,\n \"format\": \"swage-lesson/1\"}", same));
  EXPECT_EQ(same.id, one.id) << "order and spaces are not a lesson";
  ASSERT_TRUE(school_->publish_lesson("org.example.a", "A", R"({"format": "swage-lesson/1", "x": 2})", two));
  EXPECT_EQ(two.number, 2u);
  EXPECT_NE(two.digest, one.digest);
  LessonVersion read;
  ASSERT_TRUE(school_->lesson(one.digest, read));
  EXPECT_EQ(read.text, R"({"format": "swage-lesson/1", "x": 1})");
  ASSERT_TRUE(school_->retire_lesson(one.digest, true));
  const auto all = school_->lessons();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].digest, two.digest);
  EXPECT_NE(all[1].retired_utc, "");
  EXPECT_EQ(all[0].text, "") << "only when it is asked for";
  // attempts of that lesson say the same digest
  const std::string id = record_attempt(where_, 10);
  EXPECT_EQ(attempt(id).lesson_digest, lesson_digest(make_info().descriptor_text));
  EXPECT_FALSE(attempt(id).is_scripted);
}

TEST_P(SchoolTest, CoursesComeBackAsTheyWere) {
  Course c;
  c.title = "Basic course";
  CourseStep step;
  step.lesson_id = "org.example.a";
  step.title = "A";
  step.digest = std::string(64, 'a');
  step.limits = {{"wound.size", "1", 0.5, 0.1 + 0.2 + 1, true, "experts"}};
  step.rule.kind = judge::PassRule::Kind::kLcCusum;
  step.rule.signal = 1.6;
  c.steps = {step, step};
  c.steps[1].rule = judge::PassRule();
  c.steps[1].rule.a_day = 7;
  c.steps[1].is_open = true;
  ASSERT_TRUE(school_->save_course(c)) << school_->error();
  auto all = school_->courses();
  ASSERT_EQ(all.size(), 1u);
  ASSERT_EQ(all[0].steps.size(), 2u);
  EXPECT_EQ(all[0].steps[0].limits, c.steps[0].limits);
  EXPECT_EQ(all[0].steps[0].rule, c.steps[0].rule);
  EXPECT_EQ(all[0].steps[1].rule, c.steps[1].rule);
  EXPECT_TRUE(all[0].steps[1].is_open);

  Course wrong = c;
  wrong.steps[0].limits[0].least = 5;
  EXPECT_FALSE(school_->save_course(wrong));
  EXPECT_THAT(school_->error(), HasSubstr(say::kEmptyLimit(say::kOfStep(1, "Basic course"), "wound.size")));
  wrong = c;
  wrong.steps[1].rule.in_a_row = 0;
  EXPECT_FALSE(school_->save_course(wrong));
  wrong = c;
  wrong.title = "";
  EXPECT_FALSE(school_->save_course(wrong));

  const Person ada = add("Ada");
  Assignment task{"", c.id, ada.id, false, "", "2030-01-01"};
  ASSERT_TRUE(school_->assign(task)) << school_->error();
  EXPECT_EQ(school_->assignments().size(), 1u);
  Assignment lost{"", c.id, "nobody", false, "", ""};
  EXPECT_FALSE(school_->assign(lost));
  ASSERT_TRUE(school_->remove_course(c.id));
  EXPECT_TRUE(school_->assignments().empty());
}

TEST_P(SchoolTest, WhoIsErasedDoesNotComeBack) {
  const Person ada = add("Ada Meyer");
  const std::string gone = record_attempt(where_, 300, 1, "Ada Meyer"), stays = record_attempt(where_, 300, 2, "Bo");
  auto store = Store::open(where_, error_);
  ASSERT_TRUE(store->export_attempt(gone, folder_ / "gone.swage", error_)) << error_;
  Copied copied;
  ASSERT_TRUE(backup_store(where_, folder_ / "old.backup", copied, error_)) << error_;
  ASSERT_TRUE(school_->log_export({ada.id}, "csv", "/tmp/ada.csv"));
  ASSERT_EQ(school_->exported_files(ada.id).size(), 1u);
  EXPECT_TRUE(school_->exported_files(ada.id)[0].whole);

  ASSERT_TRUE(school_->erase_person(ada.id)) << school_->error();
  EXPECT_FALSE(school_->erase_person(ada.id));
  const auto expect_gone = [&] {
    store = Store::open(where_, error_);
    ASSERT_EQ(store->attempts("").size(), 1u);
    EXPECT_EQ(store->attempts("")[0].id, stays);
    EXPECT_EQ(store->damage(), "");
    for (const Person& p : store->people()) EXPECT_NE(p.name, "Ada Meyer");
  };
  expect_gone();
  // neither a file nor a backup brings back what was erased
  std::string id;
  EXPECT_FALSE(store->import_attempt(folder_ / "gone.swage", id, error_));
  EXPECT_THAT(error_, HasSubstr(say::kErased()));
  ASSERT_TRUE(restore_store(folder_ / "old.backup", where_, copied, error_)) << error_;
  EXPECT_EQ(copied.added, 0u);
  expect_gone();
  // a backup made now takes the erasure to where the old one was restored
  ASSERT_TRUE(restore_store(folder_ / "old.backup", folder_ / "other.db", copied, error_)) << error_;
  EXPECT_EQ(copied.added, 2u);
  ASSERT_TRUE(backup_store(where_, folder_ / "new.backup", copied, error_)) << error_;
  ASSERT_TRUE(restore_store(folder_ / "new.backup", folder_ / "other.db", copied, error_)) << error_;
  where_ = folder_ / "other.db";
  expect_gone();
}

TEST_P(SchoolTest, NothingOfWhoIsErasedIsLeftInTheFile) {
  if (on_server()) GTEST_SKIP() << "the files are the server's";
  const Person ada = add("Ada Meyer-Unmistakable");
  record_attempt(where_, 300, 1, ada.name);
  ASSERT_TRUE(school_->erase_person(ada.id)) << school_->error();
  for (const char* end : {"", "-wal"}) {
    std::ifstream file(where_ + end, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_THAT(bytes, testing::Not(HasSubstr("Unmistakable"))) << "in the file" << end;
    EXPECT_THAT(bytes, testing::Not(HasSubstr(ada.code))) << "in the file" << end;
  }
}

TEST_P(SchoolTest, ABackupTakesEverythingThatPeopleEdit) {
  Group group{"", "Residents", "", ""};
  ASSERT_TRUE(school_->add_group(group));
  const Person ada = add("Ada", group.id);
  const std::string id = record_attempt(where_, 300, 1, "Ada");
  Course c;
  c.title = "Basic";
  ASSERT_TRUE(school_->save_course(c));
  Assignment task{"", c.id, ada.id, false, "", ""};
  Note note{"", id, 1, 0.001, "", "Mei", "x"};
  LessonVersion lesson;
  ObserverRating rating{id, "smart.efficiency", 4, "", "Mei"};
  ASSERT_TRUE(school_->assign(task) && school_->save_note(note) && school_->save_rating(rating) && school_->set_void(id, true, "why", "Mei") &&
              school_->publish_lesson("a", "A", "{}", lesson));
  Copied out;
  ASSERT_TRUE(backup_store(where_, folder_ / "all.backup", out, error_)) << error_;

  // the other station knows the person already, by another identifier
  std::string error;
  const auto other = School::open(folder_ / "b.db", error);
  Person known;
  known.name = "Ada";
  known.code = ada.code;
  ASSERT_TRUE(other->add_person(known)) << other->error();
  ASSERT_TRUE(restore_store(folder_ / "all.backup", folder_ / "b.db", out, error_)) << error_;
  EXPECT_EQ(other->people().size(), 1u);
  EXPECT_EQ(other->groups().size(), 1u);
  EXPECT_EQ(other->courses().size(), 1u);
  ASSERT_EQ(other->assignments().size(), 1u);
  EXPECT_EQ(other->assignments()[0].who_id, known.id);
  EXPECT_EQ(other->notes(id).size(), 1u);
  ASSERT_EQ(other->ratings(id).size(), 1u);
  EXPECT_EQ(other->ratings(id)[0].points, 4);
  EXPECT_EQ(other->rulings(id).size(), 1u);
  EXPECT_EQ(other->lessons().size(), 1u);
  const auto store = Store::open(folder_ / "b.db", error_);
  EXPECT_EQ(store->attempts(known.id).size(), 1u);
  EXPECT_EQ(store->damage(), "");
}

TEST_P(SchoolTest, AnEditIsSeenByWhoeverLooks) {
  const auto store = Store::open(where_, error_);
  store->changed();
  EXPECT_FALSE(store->changed());
  Person ada = add("Ada");
  EXPECT_TRUE(store->changed());
  base::sleep_until_ns(base::wall_ns() + 2'000'000);  // an edit is told by its time, to the millisecond
  ada.handedness = "right";
  ASSERT_TRUE(school_->change_person(ada));
  EXPECT_TRUE(store->changed());
  EXPECT_FALSE(store->changed());
}

INSTANTIATE_TEST_SUITE_P(Stores, SchoolTest, testing::Values("SQLite", "PostgreSQL"),
                         [](const auto& store) { return std::string(store.param); });

}  // namespace
}  // namespace swage::record::test
