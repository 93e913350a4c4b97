// SPDX-License-Identifier: Apache-2.0
#include "record/recorder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "attempt.hpp"
#include "record/schema.hpp"

namespace swage::record::test {
namespace {

TEST(Recorder, EveryBitComesBack) {
  const Folder folder;
  const std::string store = folder / "attempts.db";
  const std::string id = record_attempt(store, 1130);
  Recording recording;
  std::string error;
  ASSERT_TRUE(read_recording(store, id, recording, error)) << error;
  expect_exact(recording, 1130);

  const AttemptInfo wrote = make_info();
  EXPECT_EQ(recording.info.person, "Ada");
  EXPECT_EQ(recording.info.lesson_title, wrote.lesson_title);
  EXPECT_EQ(recording.info.descriptor_text, wrote.descriptor_text);
  EXPECT_EQ(recording.info.plugins, wrote.plugins);
  EXPECT_EQ(recording.info.devices, wrote.devices);
  EXPECT_TRUE(same_attachments(recording.info, wrote));
  EXPECT_EQ(recording.info.seed, wrote.seed);
  EXPECT_EQ(recording.info.dt, wrote.dt);
  ASSERT_EQ(recording.info.script.signals.size(), 2u);
  EXPECT_EQ(recording.info.script.signals[1].unit, "rad");
  ASSERT_EQ(recording.info.script.marks.size(), 1u);
  EXPECT_EQ(recording.info.script.marks[0].meaning, "region.target");
  EXPECT_EQ(recording.info.script.marks[0].mark.p_W.z, 3);

  ASSERT_EQ(recording.commands.size(), 4u);
  EXPECT_EQ(recording.commands[3].step, 900u);
  EXPECT_EQ(recording.commands[3].parameter, 4u);
  EXPECT_EQ(recording.commands[3].number[3], 1e-300);
  ASSERT_EQ(recording.events.size(), 11u);
  EXPECT_EQ(recording.events[1].step, 199u);
  EXPECT_EQ(recording.events[1].event, 1u);
  EXPECT_EQ(recording.events[1].value, 0.1 * 199.0);
}

TEST(Recorder, SeedsAndHashesUseAll64Bits) {
  const Folder folder;
  const uint64_t seed = 0xFEDCBA9876543210ull;
  const std::string id = record_attempt(folder / "a.db", 10, seed);
  Recording recording;
  std::string error;
  ASSERT_TRUE(read_recording(folder / "a.db", id, recording, error)) << error;
  EXPECT_EQ(recording.info.seed, seed);
  expect_exact(recording, 10, seed);
}

TEST(Recorder, ASceneWithoutDevicesAndSignalsIsRecordedToo) {
  const Folder folder;
  AttemptInfo info = make_info();
  info.devices.clear();
  info.script = {};
  base::Problems problems;
  auto recorder = Recorder::open(folder / "a.db", info, problems);
  ASSERT_TRUE(recorder);
  for (uint64_t i = 0; i < 600; ++i) recorder->step(make_step(1, i));
  recorder->finish(make_end());
  Recording recording;
  std::string error;
  ASSERT_TRUE(read_recording(folder / "a.db", recorder->attempt_id(), recording, error)) << error;
  EXPECT_EQ(recording.hash.size(), 600u);
  EXPECT_TRUE(recording.sample.empty());
}

TEST(Recorder, AMissingStepBecomesAGapThatCanBeSeen) {
  const Folder folder;
  base::Problems problems;
  auto recorder = Recorder::open(folder / "a.db", make_info(), problems);
  ASSERT_TRUE(recorder);
  for (uint64_t i = 0; i < 400; ++i)
    if (i < 100 || i >= 130) recorder->step(make_step(7, i));
  recorder->finish(make_end());

  std::string error;
  const auto store = Store::open(folder / "a.db", error);
  ASSERT_TRUE(store) << error;
  const auto events = store->events(recorder->attempt_id());
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].owner, "gap");
  EXPECT_EQ(events[0].step, 100u);
  EXPECT_EQ(events[0].value, 30);
}

TEST(Recorder, AFullRingDropsAndCountsWhenTheClockRules) {
  const Folder folder;
  AttemptInfo info = make_info();
  info.realtime = true;
  base::Problems problems;
  auto recorder = Recorder::open(folder / "a.db", info, problems);
  ASSERT_TRUE(recorder);
  // faster than the writer can take them, until one finds no room
  StepRecord record = make_step(7, 0);
  for (; recorder->dropped() == 0; ++record.step) recorder->step(record);
  const uint64_t steps = record.step;
  recorder->finish(make_end());
  EXPECT_TRUE(recorder->healthy());
  ASSERT_GT(recorder->dropped(), 0u);

  Recording recording;
  std::string error;
  ASSERT_TRUE(read_recording(folder / "a.db", recorder->attempt_id(), recording, error)) << error;
  EXPECT_EQ(recording.step.size() + recorder->dropped(), steps);
  double lost = 0;
  const auto store = Store::open(folder / "a.db", error);
  for (const EventRow& e : store->events(recorder->attempt_id())) lost += e.value;
  EXPECT_EQ(static_cast<uint64_t>(lost), recorder->dropped());
}

TEST(Recorder, WithoutAClockNothingIsLost) {
  const Folder folder;
  const std::string id = record_attempt(folder / "a.db", 20'000);
  Recording recording;
  std::string error;
  ASSERT_TRUE(read_recording(folder / "a.db", id, recording, error)) << error;
  EXPECT_EQ(recording.step.size(), 20'000u);
  EXPECT_EQ(recording.step.back(), 19'999u);
}

TEST(Recorder, NotesAreKeptWithTheirMoment) {
  const Folder folder;
  base::Problems problems;
  auto recorder = Recorder::open(folder / "a.db", make_info(), problems);
  ASSERT_TRUE(recorder);
  recorder->step(make_step(7, 0));
  recorder->note(2500, "Handgelenk ruhiger");
  recorder->finish(make_end());
  std::string error;
  const auto store = Store::open(folder / "a.db", error);
  const auto events = store->events(recorder->attempt_id());
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].owner, "note");
  EXPECT_EQ(events[0].id, "Handgelenk ruhiger");
  EXPECT_DOUBLE_EQ(events[0].time_s, 2.5);
}

TEST(Recorder, AQuarterOfASecondIsOnDiskWhileTheAttemptRuns) {
  const Folder folder;
  AttemptInfo info = make_info();
  info.realtime = true;
  base::Problems problems;
  auto recorder = Recorder::open(folder / "a.db", info, problems);
  ASSERT_TRUE(recorder);
  // fewer steps than a chunk: the time closes it
  for (uint64_t i = 0; i < 40; ++i) recorder->step(make_step(7, i));
  Recording recording;
  std::string error;
  while (recording.step.size() < 40) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_TRUE(read_recording(folder / "a.db", recorder->attempt_id(), recording, error)) << error;
  }
  expect_exact(recording, 40);
}

TEST(Recorder, ADiscardedAttemptWasNeverThere) {
  const Folder folder;
  base::Problems problems;
  const auto recorder = Recorder::open(folder / "a.db", make_info(), problems);
  ASSERT_TRUE(recorder);
  recorder->discard();
  recorder->finish(make_end());  // too late
  std::string error;
  const auto store = Store::open(folder / "a.db", error);
  ASSERT_TRUE(store) << error;
  EXPECT_TRUE(store->attempts("").empty());
  const auto db = open_for_reading(folder / "a.db", error);
  for (const char* table : {"hand", "file", "chunk"})
    EXPECT_TRUE(db->rows("SELECT attempt_id FROM " + std::string(table)).empty()) << table;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_NE(entry.path().extension(), ".journal");
}

TEST(Recorder, AFinishedAttemptIsOneFile) {
  const Folder folder;
  record_attempt(folder / "sub/attempts.db", 500);
  struct stat facts {};
  ASSERT_EQ(stat((folder / "sub/attempts.db").c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777u, 0600u);
  ASSERT_EQ(stat((folder / "sub").c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777u, 0700u);
  // the write-ahead log has been emptied and no fallback file stays
  std::size_t bytes_elsewhere = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "sub"))
    if (entry.path().filename() != "attempts.db") bytes_elsewhere += entry.file_size();
  EXPECT_EQ(bytes_elsewhere, 0u);
}

TEST(Recorder, StreamsNameTheirColumns) {
  const Folder folder;
  const std::string id = record_attempt(folder / "a.db", 600);
  std::string error;
  const auto db = open_for_reading(folder / "a.db", error);
  ASSERT_TRUE(db) << error;
  const auto rows =
      db->rows("SELECT dictionary FROM chunk WHERE attempt_id = ? AND stream = 'input' ORDER BY seq", {id});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_NE(text(rows[0][0]).find("{\"name\":\"jaw.pose.p.x\",\"type\":\"f64\",\"unit\":\"m\"}"),
            std::string::npos);
  EXPECT_EQ(text(rows[1][0]), "");
}

}  // namespace
}  // namespace swage::record::test
