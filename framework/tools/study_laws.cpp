// SPDX-License-Identifier: Apache-2.0
#include "tools/study_laws.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <set>

#include "assembly/hand_shaping.hpp"
#include "assembly/reader.hpp"
#include "base/scratch_folder.hpp"
#include "record/recorder.hpp"
#include "session/force_guard.hpp"
#include "session/playback.hpp"
#include "session/session.hpp"
#include "step/reaction.hpp"
#include "toolkit/math.hpp"
#include "toolkit/read_file.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using assembly::Json;
using toolkit::Vec3;

constexpr const char* kFormat = "swage-laws/1";
constexpr double kTouches = 1e-9;  // N, contact force up to which the tool counts as free

std::string beside(const std::string& file, const std::string& path) {
  return path.empty() ? "" : (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
}

// plays the hand of a lesson once and records it
bool play(const LawsPlan& plan, const std::vector<std::string>& plugin_dirs, record::Recording& out, base::Problems& problems) {
  const base::ScratchFolder scratch("laws");
  session::Options options;
  options.lesson_path = plan.lesson;
  options.plugin_dirs = plugin_dirs;
  options.device = plan.hand;
  options.store_path = (scratch.path() / "hand.db").string();
  options.mode = "test";
  options.pace = session::Pace::kFastest;
  options.settings = {"seed=" + std::to_string(plan.seed)};
  const std::unique_ptr<session::Session> session = session::Session::open(options, problems);
  if (!session || base::failed(problems)) return false;
  session->start();
  session->wait();
  std::string error;
  if (record::read_recording(options.store_path, session->result().attempt_id, out, error)) return true;
  problems.push_back({base::Severity::kError, plan.lesson, error});
  return false;
}

/// One reaction law with its force guard, and the resulting forces.
struct Chain {
  Chain(const LawsPlan& plan, const LawsPlan::Law& law) : scale(plan.force_scale), reaction(law.reaction), guard(limits(plan)) { guard.arm(); }
  static session::ForceLimits limits(const LawsPlan& plan) {
    session::ForceLimits out;
    out.max_force = std::min(out.max_force, plan.max_force);
    out.continuous_force = std::min(out.continuous_force, out.max_force);
    return out;
  }
  /// Adds a step. `f_D`: contact force of the scene on the tool [N], in the frame of the device.
  void step(const Vec3& f_D, const session::HandMotion& hand, double dt, double time) {
    const double f = f_D.norm();
    const Vec3 wanted = f > 0 ? Vec3(scale * step::felt_force(reaction, f) / f * f_D) : Vec3(Vec3::Zero());
    session::ForceRequest request;
    request.force = toolkit::raw(wanted);
    const Vec3 given = toolkit::vec(guard.tick(request, hand, dt, time).force);
    run.wanted.push_back(wanted.norm());
    run.given.push_back(given.norm());
    run.peak = std::max(run.peak, given.norm());
    run.impulse += dt * given.norm();
    run.steepest = std::max(run.steepest, (given - last).norm() / dt);
    last = given;
  }

  double scale;
  const host::Reaction& reaction;
  session::ForceGuard guard;
  LawRun run;
  Vec3 last = Vec3::Zero();
};

/// Sum of the contact forces on the objects that follow one device [N], in its frame.
Vec3 felt(const session::Playback& scene, uint32_t device) {
  const host::Rig& rig = scene.rig();
  const auto led = [&](uint32_t body) {
    const uint32_t object = rig.world.body[body].object;
    return object < rig.objects.size() && rig.objects[object].follow.pose_device == device;
  };
  Vec3 f_W = Vec3::Zero();
  for (const contact::Contact& c : scene.engine().contacts().contact) f_W += ((led(c.body_a) ? 1.0 : 0.0) - (led(c.body_b) ? 1.0 : 0.0)) * c.f_a_W;
  const host::DeviceSlot& slot = rig.devices[device];
  const bool in_world = (slot.device->flags & SWAGE_DEVICE_WORLD) != 0;
  return in_world ? f_W : Vec3(toolkit::quat(slot.X_WD0.q).conjugate() * f_W);
}

session::HandMotion motion(const swage_sample& sample) {
  session::HandMotion hand;
  hand.p = sample.pose.p;
  hand.v = sample.twist.v;
  hand.has_velocity = (sample.valid & SWAGE_VALID_TWIST) != 0;
  return hand;
}

// computes the shares and the difference over the time in contact
void count(const LawsResult& all, LawRun& run) {
  std::size_t touched = 0, silent = 0, cut = 0;
  double off = 0;
  for (std::size_t i = 0; i < all.scene.size(); ++i) {
    if (all.scene[i] <= kTouches) continue;
    ++touched;
    silent += run.wanted[i] <= kTouches;
    cut += run.given[i] < 0.99 * run.wanted[i];
    off += std::pow(run.given[i] - all.laws.front().given[i], 2);
  }
  const auto n = static_cast<double>(std::max<std::size_t>(touched, 1));
  run.silent = static_cast<double>(silent) / n;
  run.cut = static_cast<double>(cut) / n;
  run.off = std::sqrt(off / n);
}

}  // namespace

bool is_laws_plan(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  return json.is_object() && json.value("format", Json()) == kFormat;
}

bool read_laws(const std::string& path, LawsPlan& out, base::Problems& problems) {
  std::string text, why;
  const assembly::Teller teller{[&](const std::string& pointer) { return path + " #" + pointer; }, problems};
  if (!toolkit::read_file(path, toolkit::kMostFileBytes, text, why)) {
    problems.push_back({base::Severity::kError, path, why});
    return false;
  }
  const Json json = Json::parse(text, nullptr, false);
  assembly::ObjectReader reader(json, "", "a study of laws", teller);
  reader.text("format", true);
  reader.find("doc");
  out.title = reader.text("title", true);
  out.attempt = beside(path, reader.filled("attempt"));
  out.lesson = beside(path, reader.text("lesson", out.attempt.empty()));
  out.hand = reader.text("hand", out.attempt.empty());
  out.seed = reader.whole("seed", 1);
  out.device = reader.name("device", true);
  out.force_scale = reader.quantity("force_scale", "1", 1, 1e-6, 1e6);
  out.max_force = reader.quantity("max_force", "N", 3.3, 1e-3, 100);
  out.file = reader.text("file", true);
  if (out.file.find('/') != std::string::npos) teller.error("/file", say::kPlainName());
  std::set<std::string> names;
  reader.each("laws", 5, [&](const Json& law, const std::string& at) {
    assembly::ObjectReader one(law, at, "a law", teller);
    LawsPlan::Law item;
    item.name = one.text("name", true);
    if (const Json* reaction = one.need("reaction")) assembly::read_reaction(*reaction, one.at("reaction"), teller, item.reaction);
    if (!names.insert(item.name).second) teller.error(one.at("name"), say::kSameLaw(item.name));
    one.finish();
    out.laws.push_back(std::move(item));
  });
  if (out.laws.size() < 2) teller.error("/laws", say::kFewLaws());
  if (!out.attempt.empty() && !out.lesson.empty()) teller.error("/attempt", say::kAttemptOrLesson());
  reader.finish();
  return !base::failed(problems);
}

bool run_laws(const LawsPlan& plan, const std::vector<std::string>& plugin_dirs, LawsResult& out, base::Problems& problems) {
  record::Recording hand;
  std::string error;
  if (plan.attempt.empty() && !play(plan, plugin_dirs, hand, problems)) return false;
  if (!plan.attempt.empty() && !record::read_recording(plan.attempt, "", hand, error))
    return problems.push_back({base::Severity::kError, plan.attempt, error}), false;
  const std::unique_ptr<session::Playback> scene = session::Playback::open(hand, plugin_dirs, problems);
  if (!scene) return false;
  const auto& names = hand.info.devices;
  const auto device = static_cast<std::size_t>(std::find(names.begin(), names.end(), plan.device) - names.begin());
  if (device == names.size())
    return problems.push_back({base::Severity::kError, plan.device, say::kNoDevice()}), false;

  out.dt = hand.info.dt;
  std::deque<Chain> chains;  // a force guard cannot be moved
  for (const LawsPlan::Law& law : plan.laws) chains.emplace_back(plan, law);
  for (std::size_t i = 0; scene->step(); ++i) {
    const Vec3 f_D = felt(*scene, static_cast<uint32_t>(device));
    const session::HandMotion at = motion(hand.sample[names.size() * i + device]);
    out.scene.push_back(f_D.norm());
    for (Chain& chain : chains) chain.step(f_D, at, out.dt, out.dt * static_cast<double>(i));
  }
  if (scene->first_difference() < scene->count()) {
    problems.push_back({base::Severity::kError, plan.title,
                        say::kOtherVersions(scene->first_difference())});
    return false;
  }
  for (Chain& chain : chains) out.laws.push_back(std::move(chain.run));
  for (LawRun& run : out.laws) count(out, run);
  return true;
}

std::string laws_csv(const LawsPlan& plan, const LawsResult& result) {
  std::string out = "time [s],scene [N]";
  for (const LawsPlan::Law& law : plan.laws) out += "," + law.name + " wanted [N]," + law.name + " given [N]";
  out += "\n";
  for (std::size_t i = 0; i < result.scene.size(); ++i) {
    out += format("%.6f,%.9g", result.dt * static_cast<double>(i + 1), result.scene[i]);
    for (const LawRun& run : result.laws) out += format(",%.9g,%.9g", run.wanted[i], run.given[i]);
    out += "\n";
  }
  return out;
}

}  // namespace swage::tools
