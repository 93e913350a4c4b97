// SPDX-License-Identifier: Apache-2.0
#include "fake_session.hpp"

#include <swage/abi/lesson_card.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>
#include <utility>

namespace swage::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kArcRadius = 2.6e-3, kWire = 0.05e-3, kSweep = 0.75 * kPi;

swage_quat about(double x, double y, double z, double a) {
  const double s = std::sin(0.5 * a);
  return {std::cos(0.5 * a), x * s, y * s, z * s};
}

double ease(double t, double from, double to) {
  const double u = std::clamp((t - from) / (to - from), 0.0, 1.0);
  return u * u * (3 - 2 * u);
}

// a wedge from the hinge (z up) to the tip, one half of the needle holder
snapshot::CardShape jaw(uint32_t body, double side) {
  snapshot::CardShape s;
  s.kind = SWAGE_SHAPE_CONVEX;
  s.flags = SWAGE_SHAPE_USUAL;
  s.body = body;
  s.object = 0;
  s.X_BS.q = {1, 0, 0, 0};
  const double tip = 0.18e-3, base = 0.55e-3, thick_tip = 0.16e-3, thick_base = 0.7e-3, length = 7e-3;
  const auto at = [&](double x, double y, double z) { s.vertex.push_back({x, side * y, z}); };
  at(-tip, 0, 0), at(tip, 0, 0), at(tip, thick_tip, 0), at(-tip, thick_tip, 0);
  at(-base, 0, length), at(base, 0, length), at(base, thick_base, length), at(-base, thick_base, length);
  s.face = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  if (side < 0) {
    for (auto& f : s.face) std::reverse(f.begin(), f.end());
  }
  return s;
}

void name(std::vector<judge::Name>& into, const char* owner, const char* id, const char* unit,
          const char* doc) {
  into.push_back({owner, id, unit, doc});
}

snapshot::SceneCard make_card(const session::Options& options, const FakeScript& script) {
  const bool with_thread = script.with_thread;
  snapshot::SceneCard card;
  card.lesson_id = "test.lesson.grasp";
  card.title = "Grasp the needle";
  card.lesson_plugin = "test.lesson";
  card.length = 1e-3;
  card.dt = 1e-3;
  card.seed = 7;
  card.view = script.view;
  card.objects = {{"holder", "swage.object.jaws", "1.0.0", {"swage.trait.gripper/1"}, 0, 2, 0, 0},
                  {"needle", "swage.object.needle", "1.0.0", {"swage.trait.graspable/1", script.with_needle ? "swage.trait.piercing/1" : "swage.trait.solid/1"}, 2, 1, 0, 0}};
  if (script.with_grasp) card.objects.push_back({"tissue", "swage.object.tissue", "1.0.0", {"swage.trait.pierceable/1"}, 0, 0, 0, 0});
  if (with_thread) card.objects.push_back({"thread", "swage.object.thread", "1.0.0", {}, 0, 0, 0, 60});
  card.devices = {
      {"hand", options.device == "mouse" ? "swage.device.mouse" : "swage.device.scripted", "1.0.0",
       options.device == "mouse" ? SWAGE_DEVICE_POINTER : SWAGE_DEVICE_SCRIPTED}};
  if (script.two_hands) card.devices.push_back({"other_hand", "swage.device.mouse", "1.0.0", SWAGE_DEVICE_POINTER});
  snapshot::CardShape needle;
  needle.kind = SWAGE_SHAPE_ARC;
  needle.flags = SWAGE_SHAPE_USUAL;
  needle.body = 2;
  needle.object = 1;
  needle.arc_radius = kArcRadius;
  needle.radius = kWire;
  needle.sweep = kSweep;
  needle.X_BS = {{0, -1.9e-3, 0}, about(0, 0, 1, 0.5 * (kPi - kSweep))};
  card.shapes = {jaw(0, +1), jaw(1, -1), needle};
  judge::Script& s = card.script;
  name(s.signals, "holder", "grasp.force", "N", "Force of the jaws on the needle");
  name(s.signals, "grasp", "grasp.tilt_axis", "rad", "Angle away from a right-angled grasp");
  if (script.with_grasp) name(s.signals, "grasp", "grasp.held", "1", "Both jaws hold it");
  name(s.metrics, "lesson", "grasp.tries", "1", "Closures before the first correct grasp");
  name(s.metrics, "lesson", "grasp.drops", "1", "Times the needle fell");
  name(s.metrics, "lesson", "force.peak", "N", "Largest force on the needle");
  name(s.metrics, "lesson", "time.task", "s", "From the first movement to the end");
  name(s.metrics, "lesson", "hold.progress", "1", "Share of the hold that is done");
  for (const char* cue :
       {"grasp.wrong", "grasp.tips_only", "grasp.point_only", "grasp.good", "grip.too_hard"}) {
    name(s.cues, "lesson", cue, "1", "");
  }
  name(s.events, "grasp", "grasp.taken", "N", "The jaws hold the needle");
  name(s.events, "lesson", "grasp.spot_reached", "1", "Held at the marked spot");
  name(s.events, "lesson", "held", "s", "Held long enough");
  name(s.events, "lesson", "time.up", "s", "The time is over");
  name(s.events, "swage", "host.gap", "1", "steps were lost because the machine was held up");
  name(s.events, "lesson", "needle.dropped", "1", "The needle fell");
  name(s.events, "swage", "host.reset", "1", "An object was put back");
  name(s.phases, "lesson", "approach", "1", "Come to the needle");
  name(s.phases, "lesson", "hold", "1", "Hold it");
  judge::Script::Mark region;
  region.meaning = "region.target";
  region.mark.kind = SWAGE_MARK_ARC_RANGE;
  region.mark.object = 1;
  region.mark.number[0] = 0.5;
  region.mark.number[1] = 0.75;
  s.marks = {region};
  card.metrics.resize(s.metrics.size());
  for (const size_t counted : {0u, 1u}) card.metrics[counted].show = SWAGE_SHOW_COUNT, card.metrics[counted].better = SWAGE_BETTER_LOWER;
  return card;
}

class FakeSession final : public session::Session {
 public:
  FakeSession(const session::Options& o, const FakeScript& script, std::shared_ptr<FakeLog> log)
      : options_(o), script_(script), log_(std::move(log)), card_(make_card(o, script)) {
    snapshot::Snapshot s;
    pose(0, s);
    card_.start.assign(s.X_WB, s.X_WB + 3);
    card_.motion = {SWAGE_MOTION_FOLLOWS, SWAGE_MOTION_HINGED, SWAGE_MOTION_DYNAMIC};
  }

  const snapshot::SceneCard& card() const override { return card_; }
  void start() override {
    ++log_->started;
    running_ = true;
    paused_ = options_.start_paused;
    since_ = Clock::now();
  }
  void pause(bool on) override {
    ++(on ? log_->paused : log_->resumed);
    before_ = now();
    since_ = Clock::now();
    paused_ = on;
  }
  void reset_object(const std::string&) override {
    ++log_->reset;
    put_back_ = true;
  }
  void mark(const std::string& text) override {
    ++log_->marked;
    log_->noted.push_back(text);
  }
  void stop() override {
    ++log_->stopped;
    if (!finished()) aborted_ = true;
    before_ = now();
    running_ = false;
  }
  bool finished() const override { return aborted_ || (script_.end_s > 0 && now() >= script_.end_s); }
  void wait() override {}
  bool pull_knot(uint64_t, session::PullProgress& out) override {
    if (pulled_ < script_.pulls) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    out = {0.1 * pulled_ / std::max(1, script_.pulls), 0.1};
    return ++pulled_ <= script_.pulls;
  }
  bool change(const std::string& instance, const std::string& json, base::Problems&) override {
    log_->changed.push_back(instance + " " + json);
    return false;
  }
  void pointer(const swage_pointer& p, int64_t) override { log_->pointer.push_back(p); }

  bool latest(snapshot::Snapshot& out) const override {
    if (!running_ && before_ <= 0) return false;
    state(std::floor(now() * 1000) / 1000, out);
    out.paused = paused_;
    return true;
  }
  void state(double t, snapshot::Snapshot& out) const {
    out = {};
    out.step = static_cast<uint64_t>(t * 1000);
    out.time_s = t;
    pose(t, out);
    judge(t, out);
  }

  bool next_event(judge::Event& out) override {
    const double at[] = {4.0, 7.5, 11.5};
    if (script_.with_gap && !gap_told_ && now() > 1) {
      gap_told_ = true;
      out = {1000, 4, 0, 12};
      return true;
    }
    if (fallen(now()) && !drop_told_) {
      drop_told_ = true;
      out = {static_cast<uint64_t>(script_.drop_s * 1000), 5, 0, 0};
      return true;
    }
    if (std::exchange(put_back_, false)) {
      out = {static_cast<uint64_t>(now() * 1000), 6, 0, 1};
      return true;
    }
    if (told_ >= 3 || now() < at[told_]) return false;
    out = {static_cast<uint64_t>(at[told_] * 1000), told_, 0, told_ == 0 ? 0.42 : 1};
    ++told_;
    return true;
  }

  session::Result result() const override {
    session::Result r;
    r.outcome = aborted_       ? judge::Outcome::kAborted
                : script_.pass ? judge::Outcome::kPassed
                               : judge::Outcome::kFailed;
    r.reason = aborted_ ? "" : script_.pass ? "held" : "time.up";
    if (options_.store_path != ":none:") r.attempt_id = "fake";  // otherwise the attempt is not stored
    r.score = script_.pass && !aborted_ ? 87 : 0;
    r.simulated_s = now();
    r.steps = static_cast<uint64_t>(now() * 1000);
    snapshot::Snapshot s;
    judge(now(), s);
    for (uint32_t i = 0; i < card_.script.metrics.size(); ++i) {
      const judge::Name& m = card_.script.metrics[i];
      r.metrics.push_back({m.id, m.unit, m.doc, s.metric[i]});
    }
    return r;
  }

 private:
  using Clock = std::chrono::steady_clock;

  double now() const {
    if (!running_ || paused_) return before_;
    const double t = before_ + script_.rate * std::chrono::duration<double>(Clock::now() - since_).count();
    return script_.end_s > 0 ? std::min(t, script_.end_s) : t;
  }

  void pose(double t, snapshot::Snapshot& s) const {
    s.n_body = 3;
    s.n_object = static_cast<uint32_t>(card_.objects.size());
    // descend to the marked region, close, lift
    const double down = ease(t, 0.5, 3), close = ease(t, 3.2, 4), lift = ease(t, 5, 8);
    const double spot = 0.5 * (kPi - kSweep) + 0.62 * kSweep;
    const swage_vec3 grasp{kArcRadius * std::cos(spot), kArcRadius * std::sin(spot) - 1.9e-3, 0};
    const double height = kWire - 0.03e-3 + 3.5e-3 * (1 - down) + 3e-3 * lift;
    const swage_vec3 tip{grasp.x + 1.2e-3 * (1 - down), grasp.y - 1.0e-3 * (1 - down), height};
    const swage_quat turn = about(0, 0, 1, spot);
    const double open = 0.17 * (1 - close) + 0.006, tilt = 0.22;
    const auto times = [](const swage_quat& a, const swage_quat& b) {
      return swage_quat{
          a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
    };
    const swage_quat hand = times(times(turn, about(0, 0, 1, kPi / 2)), about(1, 0, 0, tilt));
    // each jaw opens by a sideways motion of its tip: sufficient for a picture
    for (uint32_t j = 0; j < 2; ++j) {
      const double side = j == 0 ? 1 : -1;
      const swage_quat q = times(hand, about(1, 0, 0, -side * open));
      const double out = side * (kWire * (close > 0.5 ? 0.98 : 1.0) + 3e-3 * open - 3e-3 * 0.006);
      const double ay = out * std::cos(tilt), c = std::cos(spot + kPi / 2), sn = std::sin(spot + kPi / 2);
      s.X_WB[j] = {{tip.x - sn * ay, tip.y + c * ay, tip.z + out * std::sin(tilt)}, q};
    }
    s.X_WB[2] = {{0, 0, kWire + 3e-3 * lift}, about(1, 0, 0, 0.15 * lift)};
    if (script_.with_thread) {
      s.n_particle = 60;
      for (uint32_t i = 0; i < 60; ++i) {
        const double u = i / 59.0;
        s.particle_p_W[3 * i] = -2.4e-3 - 6e-3 * u;
        s.particle_p_W[3 * i + 1] = -1.0e-3 + 0.8e-3 * std::sin(9 * u + t);
        s.particle_p_W[3 * i + 2] = 2e-5 + 3e-3 * lift * (1 - u) * (1 - u);
      }
    }
  }

  bool fallen(double t) const { return script_.drop_s > 0 && t > script_.drop_s; }

  void judge(double t, snapshot::Snapshot& s) const {
    std::fill(s.object_cue, s.object_cue + s.n_object, SWAGE_NONE);
    const bool held = t > 4 && !fallen(t);
    if (held) s.object_cue[1] = t < 5 ? 0 : t < 6.2 ? 1 : t < 7.5 ? 2 : 3;
    s.n_signal = 2;
    s.signal[0] = held ? 0.6 + 0.25 * std::exp(-(t - 4)) * std::cos(9 * t) + 0.03 * std::sin(31 * t) : 0;
    s.signal[1] = held ? 0.2 * std::exp(-0.4 * (t - 4)) + 0.02 * std::sin(5 * t) : 0;
    if (script_.with_grasp) s.signal[s.n_signal++] = held ? 1 : 0;
    s.n_metric = 5;
    s.metric[0] = held ? 1 : 0;
    s.metric[1] = fallen(t) ? 1 : 0;
    s.metric[2] = held ? 0.83 : 0;
    s.metric[3] = t;
    s.metric[4] = std::clamp((t - 7.5) / 4, 0.0, 1.0);
    s.phase = held ? 1 : 0;
    s.n_mark = 1;
    s.mark_cue[0] = SWAGE_NONE;
    if (held) {
      const double spot = 0.5 * (kPi - kSweep) + 0.62 * kSweep, z = s.X_WB[2].p.z;
      s.n_contact = 2;
      for (uint32_t c = 0; c < 2; ++c) {
        const double side = c == 0 ? 1 : -1;
        s.contact[c].p_W = {kArcRadius * std::cos(spot), kArcRadius * std::sin(spot) - 1.9e-3, z};
        s.contact[c].f_W = {side * s.signal[0] * std::cos(spot), side * s.signal[0] * std::sin(spot), 0.05};
      }
    }
    s.health.executed = s.step;
    s.health.worst_step_s = 0.00031;
    s.health.mean_step_cpu_s = 0.00004;
    s.n_device = 1;
    s.device[0].valid = 1;
  }

  session::Options options_;
  FakeScript script_;
  std::shared_ptr<FakeLog> log_;
  snapshot::SceneCard card_;
  Clock::time_point since_{};
  double before_ = 0;
  bool running_ = false, paused_ = false, aborted_ = false;
  int pulled_ = 0;  // calls of pull_knot()
  uint32_t told_ = 0;
  bool gap_told_ = false, drop_told_ = false, put_back_ = false;
};

}  // namespace

std::unique_ptr<session::Session> open_fake(const session::Options& options,
                                            std::vector<base::Problem>& problems, const FakeScript& script,
                                            std::shared_ptr<FakeLog> log) {
  log->last = options;
  if (!script.refuse.empty()) {
    problems.push_back({base::Severity::kError, options.lesson_path, script.refuse});
    return nullptr;
  }
  if (!script.refuse_record.empty() && options.store_path != ":none:") {
    problems.push_back({base::Severity::kError, "record /full/attempts.db", script.refuse_record});
    return nullptr;
  }
  ++log->opened;
  return std::make_unique<FakeSession>(options, script, std::move(log));
}

void fake_state(const FakeScript& script, double t, snapshot::Snapshot& out) { FakeSession({}, script, nullptr).state(t, out); }

}  // namespace swage::test
