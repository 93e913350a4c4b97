// SPDX-License-Identifier: Apache-2.0
//
// The stations of a school in memory, for tests of the console only. Used from the link's thread and from the test's.
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "record/stations.hpp"

namespace swage::test {

struct FakeSchool {
  std::mutex mutex;
  std::vector<record::StationNow> stations;  // all but that of the window
  record::StationNow said;                   // sent by the window
  std::vector<record::StationMessage> inbox, sent;
  std::vector<std::string> answers, marks, forgotten;
  int beats = 0, looks = 0, pictures = 0;
  std::string refuse;  // non-empty: opening fails
};

class FakeStations final : public record::Stations {
 public:
  explicit FakeStations(std::shared_ptr<FakeSchool> school) : s_(std::move(school)) {}
  const std::string& error() const override { return error_; }
  bool lost() const override { return false; }
  bool listen(Channel, std::function<void()>) override { return true; }
  bool enter(const std::string& wanted, const std::string&, std::string& name) override {
    name = name_ = wanted;
    return true;
  }
  bool say(const record::StationNow& now) override {
    const std::lock_guard lock(s_->mutex);
    s_->said = now;
    s_->said.station = name_;
    ++s_->beats;
    return true;
  }
  bool leave() override { return true; }
  bool inbox(std::vector<record::StationMessage>& out) override {
    const std::lock_guard lock(s_->mutex);
    out = s_->inbox;
    return true;
  }
  bool tell_shown(const std::string&) override { return true; }
  bool tell_answer(const std::string& id, const std::string& answer) override {
    const std::lock_guard lock(s_->mutex);
    std::erase_if(s_->inbox, [&](const auto& m) { return m.id == id; });
    s_->answers.push_back(id + " " + answer);
    return true;
  }
  bool show_picture(const std::string&) override {
    const std::lock_guard lock(s_->mutex);
    return ++s_->pictures > 0;
  }
  bool all(std::vector<record::StationNow>& out) override {
    const std::lock_guard lock(s_->mutex);
    out = s_->stations;
    out.push_back(s_->said);
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.station < b.station; });
    return ++s_->looks > 0;
  }
  bool send(record::StationMessage& m) override {
    const std::lock_guard lock(s_->mutex);
    m.id = "m" + std::to_string(s_->sent.size());
    m.from = name_;
    s_->sent.insert(s_->sent.begin(), m);
    return true;
  }
  bool sent(std::vector<record::StationMessage>& out) override {
    const std::lock_guard lock(s_->mutex);
    out = s_->sent;
    std::erase_if(out, [](const auto& m) { return m.kind == record::StationMessage::Kind::kPicture; });
    return true;
  }
  bool picture(const std::string&, std::string& png, double&) override { return png.clear(), true; }
  bool mark(const std::string& station, const std::string& words, const std::string&, double& time_s) override {
    const std::lock_guard lock(s_->mutex);
    time_s = 40;
    s_->marks.push_back(station + " " + words);
    return true;
  }
  bool forget(const std::string& station) override {
    const std::lock_guard lock(s_->mutex);
    std::erase_if(s_->stations, [&](const auto& n) { return n.station == station; });
    s_->forgotten.push_back(station);
    return true;
  }

 private:
  std::shared_ptr<FakeSchool> s_;
  std::string name_, error_;
};

/// Five stations as an instructor sees them: in order, in need of help, waiting, lost, closed.
inline std::vector<record::StationNow> sample_stations() {
  using State = record::StationState;
  const auto make = [](const char* name, State state, const char* who, const char* lesson, const char* phase, double t, double silent) {
    record::StationNow n;
    n.station = name;
    n.state = state;
    n.person = who;
    n.lesson_id = "swage.series.grasp";
    n.lesson_title = lesson;
    n.phase = phase;
    n.time_s = t;
    n.step = static_cast<uint64_t>(1000 * t);
    n.silent_s = silent;
    n.recorded = true;
    n.attempt_id = "0190a000-0000-7000-8000-000000000001";
    return n;
  };
  std::vector<record::StationNow> out = {
      make("Table 1", State::kRunning, "Arun P.", "Grasp the needle", "Close the jaws on the red part", 42, 0.2),
      make("Table 2", State::kRunning, "Bea L.", "Insert, flat", "Drive the needle through", 128, 0.4),
      make("Table 3", State::kPaused, "Chen W.", "Carry and hold", "Hold for 10 s", 17, 0.1),
      make("Table 4", State::kRunning, "Dora M.", "Grasp the needle", "Lift the needle", 63, 12.4),
      make("Table 5", State::kClosed, "", "", "", 0, 3600)};
  out[0].cues = {"grasp.good"};
  out[0].force_N = 0.58;
  out[0].score = 61;
  out[1].cues = {"grasp.wrong", "force.high"};
  out[1].force_N = 1.34;
  out[1].score = 12;
  out[1].late = 14;
  out[1].solver = 3;
  out[2].force_N = 0.4;
  out[2].score = 55;
  return out;
}

}  // namespace swage::test
