// SPDX-License-Identifier: Apache-2.0
#include "attempt.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "base/rng.hpp"

namespace swage::record::test {

Folder::Folder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "swage_record_XXXXXX").string();
  if (mkdtemp(pattern.data()) != nullptr) path_ = pattern;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

AttemptInfo make_info(uint64_t seed, const std::string& person) {
  AttemptInfo info;
  info.person = person;
  info.lesson_id = "swage.lesson.grasp";
  info.lesson_title =
      "Greifen \xC3\xBC"
      "ber der Pfanne";
  info.mode = "practice";
  info.device = "swage.device.mouse";
  info.descriptor_text = "{\"format\": \"swage-lesson/1\"}\n";
  info.descriptor_path = "lessons/series/grasp.json";
  info.plugins = {{"swage.object.needle", "1.2.0"}, {"swage.device.mouse", "1.0.0"}};
  info.devices = {"hand", "jaw"};
  info.hands = {{"hand", "expert", "swage.device.scripted", "1.0.0", R"({"file": "../hands/a.json"})", 5},
                {"jaw", "", "swage.device.mouse", "1.0.0", "{}", 0x80000000u}};
  info.files = {{"../hands/a.json", std::string("{\0 any bytes \xFF}", 15)}, {"empty.json", ""}};
  info.script.signals = {{"grasp", "force", "N", "Grip force."}, {"needle", "angle", "rad", ""}};
  info.script.metrics = {
      {"lesson", "tries", "1", "Grasps."}, {"lesson", "time", "s", ""}, {"lesson", "never", "m", ""}};
  info.script.events = {{"grasp", "grasp.taken", "1", ""}, {"grasp", "grasp.dropped", "1", ""}};
  info.script.cues = {{"lesson", "grasp.good", "", ""}};
  info.script.phases = {{"lesson", "approach", "", ""}};
  judge::Script::Mark mark{};
  mark.meaning = "region.target";
  mark.mark.number[0] = 0.5;
  mark.mark.p_W = {1, 2, 3};
  info.script.marks = {mark};
  info.seed = seed;
  return info;
}

StepRecord make_step(uint64_t seed, uint64_t step) {
  base::Xoshiro256 random(seed * 1'000'003 + step);
  StepRecord record{};
  record.step = step;
  record.hash = random();
  record.n_device = 2;
  record.n_signal = 2;
  for (uint32_t d = 0; d < 2; ++d) {
    uint64_t words[sizeof(swage_sample) / 8];
    const double slow = 1e-3 * static_cast<double>(step);
    for (uint64_t& word : words) word = std::bit_cast<uint64_t>(slow + 1e-9 * random.uniform());
    words[0] = step;
    words[2] = random();  // any bits at all
    words[3] = 0x7FF8'0000'0000'0000ull | step;
    words[4] = std::bit_cast<uint64_t>(-0.0);
    words[5] = std::bit_cast<uint64_t>(std::numeric_limits<double>::denorm_min());
    std::memcpy(&record.sample[d], words, sizeof words);
  }
  record.signal[0] = random.uniform();
  record.signal[1] =
      step % 5 == 0 ? std::numeric_limits<double>::quiet_NaN() : -1e-3 * static_cast<double>(step);
  return record;
}

bool same_attachments(const AttemptInfo& a, const AttemptInfo& b) {
  const auto hand = [](const HandInfo& x, const HandInfo& y) {
    return x.name == y.name && x.choice == y.choice && x.plugin == y.plugin && x.version == y.version &&
           x.params == y.params && x.flags == y.flags;
  };
  const auto file = [](const FileInfo& x, const FileInfo& y) {
    return x.name == y.name && x.bytes == y.bytes;
  };
  return std::equal(a.hands.begin(), a.hands.end(), b.hands.begin(), b.hands.end(), hand) &&
         std::equal(a.files.begin(), a.files.end(), b.files.begin(), b.files.end(), file);
}

AttemptEnd make_end() {
  AttemptEnd end;
  end.outcome = judge::Outcome::kPassed;
  end.reason = "grasp.taken";
  end.score = 87.5;
  end.simulated_s = 1.25;
  end.metric = {3, 0.1 + 0.2, std::numeric_limits<double>::quiet_NaN()};
  end.health.executed = 1250;
  return end;
}

std::string record_attempt(const std::string& store, uint64_t steps, uint64_t seed,
                           const std::string& person) {
  base::Problems problems;
  const auto recorder = Recorder::open(store, make_info(seed, person), problems);
  if (!recorder) {
    ADD_FAILURE() << (problems.empty() ? "no reason given" : problems[0].message);
    return "";
  }
  for (uint64_t step = 0; step < steps; ++step) {
    if (step % 300 == 0) recorder->command({step, 2, 1, 4, 0, {0.25, -1, 0, 1e-300}});
    if (step % 100 == 99)
      recorder->event({step, static_cast<uint32_t>(step / 100 % 2), 0, 0.1 * static_cast<double>(step)});
    recorder->step(make_step(seed, step));
  }
  recorder->finish(make_end());
  EXPECT_EQ(recorder->dropped(), 0u);
  return recorder->attempt_id();
}

void expect_exact(const Recording& recording, uint64_t steps, uint64_t seed) {
  ASSERT_EQ(recording.step.size(), steps);
  ASSERT_EQ(recording.hash.size(), steps);
  ASSERT_EQ(recording.sample.size(), 2 * steps);
  ASSERT_EQ(recording.signal.size(), 2 * steps);
  for (uint64_t i = 0; i < steps; ++i) {
    const StepRecord wrote = make_step(seed, i);
    ASSERT_EQ(recording.step[i], i);
    ASSERT_EQ(recording.hash[i], wrote.hash);
    ASSERT_EQ(std::memcmp(&recording.sample[2 * i], wrote.sample, 2 * sizeof(swage_sample)), 0)
        << "step " << i;
    for (std::size_t s = 0; s < 2; ++s) {
      const auto rounded = static_cast<float>(wrote.signal[s]);
      ASSERT_EQ(std::memcmp(&recording.signal[2 * i + s], &rounded, sizeof rounded), 0) << "step " << i;
    }
  }
}

}  // namespace swage::record::test
