// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "attempt.hpp"
#include "nasty.hpp"
#include "record/salvage.hpp"
#include "record/schema.hpp"
#include "trial.hpp"

namespace swage::record::test {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t kSteps[3] = {1130, 600, 300};

// What a run of many trials came to.
struct Tally {
  std::map<std::string, int> outcomes;
  double slowest_s = 0, largest_MB = 0;
  void add(const std::string& outcome, const Ended& ended) {
    ++outcomes[outcome];
    slowest_s = std::max(slowest_s, ended.seconds);
    largest_MB = std::max(largest_MB, ended.megabytes);
  }
  void print(const char* what) const {
    std::printf("%s:", what);
    for (const auto& [name, n] : outcomes) std::printf(" %d %s,", n, name.c_str());
    std::printf(" slowest %.2f s of wall time, largest %.0f MB\n", slowest_s, largest_MB);
  }
};

std::string refused(const std::string& error) {
  if (error.size() < 10 || !error.ends_with(".")) return "silent: \"" + error + "\"";
  return "refused";
}

// Takes a file into a fresh store, and whatever was taken is looked at from all sides.
std::string import(const std::string& file, const std::string& target) {
  std::string error, id;
  const auto store = Store::open(target, error);
  if (!store) return "no store: " + error;
  if (!store->import_attempt(file, id, error)) {
    if (!store->attempts("").empty() || !store->people().empty()) return "left something of a refused file";
    return refused(error);
  }
  AttemptRow row;
  Recording recording;
  store->recover();
  if (!store->attempt(id, row)) return "taken, and not there";
  store->events(id);
  if (!read_recording(target, id, recording, error)) return "taken, and not readable: " + error;
  if (!store->export_attempt(id, target + ".again", error)) return "taken, and not given back: " + error;
  return "taken";
}

class Imports : public testing::Test {
 protected:
  Imports() {
    id_ = record_attempt(folder_ / "seed.db", kSteps[0]);
    std::string error;
    EXPECT_TRUE(Store::open(folder_ / "seed.db", error)->export_attempt(id_, folder_ / "seed.swage", error));
  }
  void clean() {
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      if (!entry.path().filename().string().starts_with("seed")) fs::remove(entry.path());
  }
  const Folder folder_;
  std::string id_;
};

TEST_F(Imports, AreTakenWholeOrRefusedWithASentence) {
  Tally tally;
  for (int trial = 0; trial < trials(); ++trial) {
    base::Xoshiro256 random(static_cast<uint64_t>(trial) + 1);
    const std::string file = folder_ / "file.swage";
    std::string how;
    if (trial % 3 == 0) {
      fs::copy_file(folder_ / "seed.swage", file);
      how = damage_file(file, random);
    } else {
      // a file that is well-formed, with a checksum that fits what it says
      fs::copy_file(folder_ / "seed.db", folder_ / "crafted.db");
      how = craft_rows(folder_ / "crafted.db", random);
      std::string error;
      const Ended made = run_trial([&] {
        const auto store = Store::open_to_read(folder_ / "crafted.db", error);
        if (!store || !store->export_attempt(id_, file, error))
          fs::copy_file(folder_ / "seed.swage", file, fs::copy_options::overwrite_existing);
        return std::string("made");
      });
      EXPECT_EQ(made.wrong, "") << "exporting, seed " << trial + 1 << ": " << how;
      if (!fs::exists(file)) fs::copy_file(folder_ / "seed.swage", file);
      if (trial % 3 == 2) how += craft_tables(file, random);
    }
    const Ended ended = run_trial([&] { return import(file, folder_ / "target.db"); });
    EXPECT_EQ(ended.wrong, "") << "seed " << trial + 1 << ": " << how;
    EXPECT_THAT(ended.said, testing::AnyOf("taken", "refused")) << "seed " << trial + 1 << ": " << how;
    tally.add(ended.said, ended);
    clean();
  }
  tally.print("imports");
  EXPECT_GT(tally.outcomes["refused"], 0);
  EXPECT_GT(tally.outcomes["taken"], 0);
}

bool is_exact(const Recording& r, uint64_t seed) {
  if (r.step.size() != kSteps[seed - 1]) return false;
  for (uint64_t i = 0; i < r.step.size(); ++i) {
    const StepRecord wrote = make_step(seed, i);
    if (r.hash[i] != wrote.hash || std::memcmp(&r.sample[2 * i], wrote.sample, 2 * sizeof(swage_sample)) != 0)
      return false;
  }
  return true;
}

// What a person meets who lists, opens and checks a store; "" when all seems well.
std::string met_with(const std::string& path, const std::vector<std::string>& ids) {
  std::string error;
  const auto store = Store::open(path, error);
  if (!store) return refused(error) == "refused" ? error : refused(error);
  store->recover();
  const auto attempts = store->attempts("");
  if (!store->trouble().empty()) return store->trouble();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Recording recording;
    if (!read_recording(path, ids[i], recording, error)) return error;
    if (!is_exact(recording, i + 1)) return "silent: a recording is not what it was";
    store->events(ids[i]);
    if (!store->trouble().empty()) return store->trouble();
  }
  const std::string damage = store->damage();
  if (!damage.empty()) return damage;
  if (attempts.size() != ids.size()) return "silent: attempts are missing";
  for (const AttemptRow& a : attempts)
    if (a.score != 87.5 || a.metrics.size() != 2 || a.outcome != "passed" || a.person_name != "Ada")
      return "silent: a number or a word of a row is not what it was";
  return "";
}

// What can be read of the damaged store is in the new one, and the new one is whole.
std::string salvaged(const std::string& path, const std::string& fresh, const std::vector<std::string>& ids) {
  Salvaged out;
  std::string error;
  if (!salvage(path, fresh, out, error)) return refused(error) == "refused" ? "nothing left" : refused(error);
  const auto store = Store::open(fresh, error);
  if (!store) return "salvaged, and not usable: " + error;
  if (!store->damage().empty()) return "salvaged, and damaged: " + store->damage();
  int exact = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Recording recording;
    AttemptRow row;
    if (!store->attempt(ids[i], row)) continue;
    if (!read_recording(fresh, ids[i], recording, error)) {
      if (error.find("is damaged: its plugins") == std::string::npos) return "salvaged, and not readable: " + error;
      continue;
    }
    exact += is_exact(recording, i + 1);
  }
  return "salvaged " + std::to_string(exact);
}

TEST(Stores, DamagedInAnyWaySayThatTheyAreAndGiveWhatIsLeft) {
  const Folder folder;
  const std::string seed = folder / "seed.db";
  std::vector<std::string> ids;
  for (uint64_t i = 1; i <= 3; ++i) ids.push_back(record_attempt(seed, kSteps[i - 1], i));
  Tally tally, rescued;
  for (int trial = 0; trial < trials(); ++trial) {
    base::Xoshiro256 random(static_cast<uint64_t>(trial) + 1);
    const std::string path = folder / "a.db";
    fs::copy_file(seed, path);
    const std::string how = damage_file(path, random);
    // first the salvage, which changes nothing in what it reads
    const Ended saved = run_trial([&] { return salvaged(path, folder / "fresh.db", ids); });
    EXPECT_EQ(saved.wrong, "") << "salvaging, seed " << trial + 1 << ":" << how;
    EXPECT_TRUE(saved.said.starts_with("salvaged ") || saved.said == "nothing left")
        << saved.said << ", seed " << trial + 1 << ":" << how;
    rescued.add(saved.said, saved);
    const Ended ended = run_trial([&] { return met_with(path, ids); });
    EXPECT_EQ(ended.wrong, "") << "seed " << trial + 1 << ":" << how;
    EXPECT_THAT(ended.said, testing::Not(testing::StartsWith("silent"))) << "seed " << trial + 1 << ":" << how;
    tally.add(ended.said.empty() ? "unharmed" : "told", ended);
    for (const auto& entry : fs::directory_iterator(folder.path()))
      if (entry.path().filename() != "seed.db") fs::remove(entry.path());
  }
  tally.print("damaged stores");
  rescued.print("salvaged, with exact recordings of three");
  EXPECT_GT(tally.outcomes["told"], 0);
}

}  // namespace
}  // namespace swage::record::test
