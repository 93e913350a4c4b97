// SPDX-License-Identifier: Apache-2.0
#include "session/run.hpp"

#include <swage/abi/calibration.h>
#include <swage/abi/display.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "host/call_watch.hpp"
#include "host/nearest.hpp"
#include "host/services.hpp"
#include "host/units.hpp"
#include "record/store.hpp"
#include "session/bounded_call.hpp"
#include "session/live.hpp"
#include "session/sentences.hpp"
#include "step/limits.hpp"
#include "step/overlaps.hpp"
#include "toolkit/read_file.hpp"

namespace swage::session {

namespace {

using base::Severity;

// Own processor time of a plugin per step. A fifth of a step: five plugins at their limit still fit. Builds for
// finding faults run many times slower.
#if defined(__OPTIMIZE__) && !defined(SWAGE_SANITIZED)
constexpr double kBudget = 200e-6;  // s
#else
constexpr double kBudget = 20e-3;  // s
#endif
// s by which a person's mark is dated back: the event has just been seen
constexpr double kMarkBack = 2.0;  // s
// limit of the bytes of files stored with an attempt; scripted hands have some thousand, meshes some million
constexpr std::size_t kMostAttached = std::size_t{16} << 20;

std::string lost_text(const host::Instance& device, const char* call, double limit_s) {
  return say::kLeftBehind(device.plugin_id, device.plugin_version, call, host::format_number(limit_s));
}

// adds data that a replay elsewhere needs beside the samples: the devices of the hands, and the files that the lesson names
void add_attachments(const host::Rig& rig, record::AttemptInfo& info, Problems& problems) {
  for (const host::DeviceSlot& slot : rig.devices) {
    const host::Instance& i = *slot.instance;
    info.hands.push_back(
        {i.name, slot.choice, i.plugin_id, i.plugin_version, slot.params, slot.device->flags});
  }
  std::size_t total = 0;
  for (const host::GivenFile& file : rig.files) {
    std::string bytes, why;
    const bool read = toolkit::read_file(file.path, kMostAttached - total, bytes, why);
    total += bytes.size();
    if (!read)
      problems.push_back({Severity::kWarning, file.path,
                          say::kFileNotKept()});
    else
      info.files.push_back({file.written, std::move(bytes)});
  }
}

// The calibration that an open device uses, as it reports; "" for none.
std::string calibration_of(host::Instance& instance) {
  constexpr uint64_t kMost = 1 << 20;  // bytes; usual are some thousand
  const auto* table = static_cast<const swage_device_calibration*>(instance.extension(SWAGE_EXT_CALIBRATION));
  std::string out;
  if (table == nullptr || table->text == nullptr) return out;
  host::guarded(instance, host::Call::kOpen, 0, [&] {
    const swage_str text = table->text(instance.raw);
    if (text.data != nullptr && text.size <= kMost) out.assign(text.data, text.size);
    return SWAGE_OK;
  });
  return out;
}

}  // namespace

int32_t eyes_of(const record::Display& display) {
  if (display.mode.empty()) return SWAGE_EYES_NONE;
  return display.stereo ? SWAGE_EYES_STEREO : SWAGE_EYES_MONO;
}

// the attempt in progress, for code that ends the program during it
std::atomic<Run*> Run::current_{nullptr};

Run::Run(const Options& options, host::Catalogue catalogue, std::unique_ptr<host::Rig> rig,
         std::unique_ptr<Sentinel> sentinel)
    : options_(options), catalogue_(std::move(catalogue)), sentinel_(std::move(sentinel)), rig_(std::move(rig)) {}

Run::~Run() {
  if (started_) stop();
  if (!started_ && recorder_) recorder_->discard();
  Problems late;
  close_devices(late);
  for (const Problem& p : late) std::fprintf(stderr, "swage: %s: %s\n", p.where.c_str(), p.message.c_str());
  if (!left_) return;
  for (auto& port : ports_) static_cast<void>(port.release());
  static_cast<void>(rig_.release());
  static_cast<void>(watchdog_.release());
}

bool Run::prepare(Problems& problems) {
  host::CallWatch::on_end(ended_by_plugin);
  if (realtime()) host::set_budgets(*rig_, kBudget);
  watchdog_ = std::make_unique<Watchdog>(
      [this] { return loop_->finished() ? ++idle_beats_ : thread_->beats(); }, [this] { hung(); },
      Watchdog::Settings(), [this] { return processor_wait_.starved(thread_->tid()); });
  open_devices(problems);
  if (base::failed(problems)) return false;
  std::vector<step::DevicePort*> step_ports;
  std::vector<Port*> ports;
  for (const auto& port : ports_) {
    step_ports.push_back(port.get());
    ports.push_back(port.get());
  }
  try {
    engine_ = std::make_unique<step::Engine>(*rig_, step::Options(), step_ports);
  } catch (const std::exception& e) {
    problems.push_back({Severity::kError, rig_->descriptor_path, e.what()});
    return false;
  }
  for (Problem& p : step::start_overlaps(*rig_, contact::Options())) problems.push_back(std::move(p));
  add_signals(problems);
  open_record(problems);
  if (base::failed(problems)) return false;
  Loop::Settings settings;
  settings.realtime = realtime();
  settings.start_paused = options_.start_paused;
  settings.max_time_s = options_.max_time_s;
  settings.lesson_max_time_s = rig_->max_time_s;
  settings.cue_pulses = options_.cue_pulses;
  loop_ = std::make_unique<Loop>(*rig_, *engine_, std::move(ports), recorder_.get(), settings);
  return true;
}

void Run::open_devices(Problems& problems) {
  for (host::DeviceSlot& slot : rig_->devices) {
    host::Instance& instance = *slot.instance;
    // written by a thread that may outlive this function
    const auto result = std::make_shared<std::atomic<swage_result>>(SWAGE_ERROR);
    const auto open = [&instance, device = slot.device, result] {
      host::guarded(instance, host::Call::kOpen, 0, [&] { return *result = device->open(instance.raw); });
    };
    if (!bounded_call(open, driver_limits().open)) {
      left_ = true;
      problems.push_back({Severity::kError, instance.name, lost_text(instance, "open", driver_limits().open)});
      continue;
    }
    Problems said = instance.services->take_reports();
    const bool told = base::failed(said);
    for (Problem& p : said) problems.push_back(std::move(p));
    if (*result < 0) {
      if (!told)
        problems.push_back({Severity::kError, instance.name, say::kNotOpened(instance.plugin_id)});
      continue;
    }
    opened_.push_back(&slot);
    open_port(slot, problems);
  }
}

void Run::open_port(host::DeviceSlot& slot, Problems& problems) {
  const host::Instance& instance = *slot.instance;
  const bool lockstep = (slot.device->flags & SWAGE_DEVICE_LOCKSTEP) != 0;
  const bool force = (slot.device->flags & SWAGE_DEVICE_FORCE) != 0;
  if (!lockstep) {
    ports_.push_back(std::make_unique<IoPort>(slot, watchdog_->stalled_flag()));
    if (!realtime())
      problems.push_back({Severity::kError, instance.name,
                          say::kWithoutClock(instance.plugin_id)});
    return;
  }
  ports_.push_back(std::make_unique<StepPort>(slot, rig_->world.dt, !realtime()));
  if (force && realtime())
    problems.push_back({Severity::kNote, instance.name,
                        say::kNoForces(instance.plugin_id)});
}

// Appends the signals of devices to the scene's own, in the record and on the screen.
void Run::add_signals(Problems& problems) {
  std::vector<judge::Name>& all = rig_->card.script.signals;
  for (const auto& port : ports_) {
    host::Instance& instance = *port->slot().instance;
    std::string wrong;
    const host::DeviceSignals signals(instance, wrong);
    if (all.size() + signals.count() > snapshot::kMaxSignals)
      wrong = say::kManySignals(snapshot::kMaxSignals);
    if (!wrong.empty()) {
      problems.push_back({Severity::kWarning, instance.name, wrong});
      continue;
    }
    for (uint32_t i = 0; i < signals.count(); ++i) {
      const swage_device_signal& s = signals.signal(i);
      all.push_back({instance.name, s.id, s.unit, s.doc});
    }
    port->tell(signals);
  }
}

// A device whose exchange has not returned is not closed: one caller at a time.
void Run::close_devices(Problems& problems) {
  std::vector<const host::Instance*> lost;
  for (const auto& port : ports_) {
    if (port->stop()) continue;
    left_ = true;
    const host::Instance& instance = *port->slot().instance;
    lost.push_back(&instance);
    problems.push_back({Severity::kWarning, instance.name, lost_text(instance, "exchange", driver_limits().exchange)});
  }
  for (host::DeviceSlot* slot : opened_) {
    host::Instance& instance = *slot->instance;
    if (std::find(lost.begin(), lost.end(), &instance) != lost.end()) continue;
    const auto close = [&instance, device = slot->device] {
      // also in quarantine: its resources must be released
      host::detail::contained(instance, host::Call::kClose, 0, [&] { device->close(instance.raw); });
    };
    if (bounded_call(close, driver_limits().close)) continue;
    left_ = true;
    problems.push_back({Severity::kWarning, instance.name, lost_text(instance, "close", driver_limits().close)});
  }
  opened_.clear();
}

void Run::open_record(Problems& problems) {
  // a demonstration is not recorded
  if (options_.store_path == ":none:" || rig_->card.mode == "demo") return;
  record::AttemptInfo info;
  info.person = options_.person;
  info.lesson_id = rig_->card.lesson_id;
  info.lesson_title = rig_->card.title;
  info.mode = rig_->card.mode;
  info.descriptor_text = rig_->descriptor_text;
  info.descriptor_path = rig_->descriptor_path;
  for (const host::Instance* i : host::instances(*rig_))
    info.plugins.emplace_back(i->plugin_id, i->plugin_version);
  for (const host::DeviceSlot& slot : rig_->devices) {
    info.devices.push_back(slot.instance->name);
    if (info.device.empty()) info.device = slot.instance->plugin_id;
  }
  add_attachments(*rig_, info, problems);
  for (const host::DeviceSlot& slot : rig_->devices)
    if (std::string text = calibration_of(*slot.instance); !text.empty())
      info.files.push_back({record::kCalibrationFile + slot.instance->name, std::move(text)});
  info.display = options_.display;
  info.script = rig_->script;
  info.script.signals = rig_->card.script.signals;  // with those of the devices
  info.seed = rig_->seed;
  info.dt = rig_->world.dt;
  info.realtime = realtime();
  const std::string where = options_.store_path.empty() ? record::Store::default_path() : options_.store_path;
  recorder_ = record::Recorder::open(where, info, problems);
}

void Run::start() {
  if (started_) return;
  started_ = true;
  current_ = this;
  host::CallWatch::guard_exit();
  const bool forces = std::any_of(rig_->devices.begin(), rig_->devices.end(), [](const host::DeviceSlot& s) {
    return (s.device->flags & SWAGE_DEVICE_FORCE) != 0;
  });
  const Lateness lateness = !realtime() ? Lateness::kLockstep : forces ? Lateness::kDrop : Lateness::kCatchUp;
  thread_ = std::make_unique<RtThread>(lateness, rig_->world.dt, [this](const RtThread::Tick& tick) {
    return loop_->tick(tick, thread_->stats());
  });
  for (const auto& port : ports_) port->start();
  thread_->start([this](const RtGrant& grant) {
    host::set_thread_role(SWAGE_THREAD_RT);
    Sentinel::protect_thread();
    last_call_.store(&host::last_call);
    loop_->grant(grant.fifo && grant.locked);
    grant_ = grant.sentence;
  });
  watchdog_->start();
}

void Run::reset_object(const std::string& object_name) {
  for (uint32_t i = 0; i < rig_->objects.size(); ++i) {
    if (rig_->objects[i].instance->name != object_name) continue;
    step::Command command;
    command.kind = step::CommandKind::kResetObject;
    command.object = i;
    loop_->command(command);
  }
}

void Run::mark(const std::string& note) {
  step::Command command;
  command.kind = step::CommandKind::kMark;
  command.object = marks_++;
  loop_->command(command);
  const auto back = static_cast<uint64_t>(kMarkBack / rig_->world.dt);
  const uint64_t now = loop_->steps();
  if (recorder_) recorder_->note(now > back ? now - back : 0, note);
}

bool Run::change(const std::string& instance_name, const std::string& params_json, Problems& problems) {
  const std::vector<host::Instance*> all = host::instances(*rig_);
  for (uint32_t i = 0; i < all.size(); ++i) {
    if (all[i]->name != instance_name) continue;
    const host::PluginInfo* plugin = catalogue_.find(all[i]->plugin_id);
    std::vector<step::Command> commands;
    if (!plugin || !live_commands(*all[i], i, plugin->params, params_json, commands, problems)) return false;
    for (const step::Command& c : commands) loop_->command(c);
    return true;
  }
  problems.push_back({Severity::kError, instance_name, say::kNobody()});
  return false;
}

void Run::stop() {
  if (!started_) return;
  loop_->stop();
  close();
}

void Run::wait() {
  if (!started_) return;
  thread_->join();
  for (PullProgress ignored; pull_knot(1000, ignored);) continue;
  close();
}

bool Run::pull_knot(uint64_t most_steps, PullProgress& out) {
  if (closed_ || !started_ || !loop_->finished()) return false;
  if (loop_->ending() != Ending::kVerdict || engine_->quarantined() > 0 || !KnotTest::wanted(*rig_, engine_->verdict())) return false;
  thread_->join();
  if (!knot_test_) knot_test_ = std::make_unique<KnotTest>(*rig_, engine_->world(), options_.pull_lesson, options_.plugin_dirs);
  const bool more = knot_test_->step(most_steps);
  out = knot_test_->progress();
  return more;
}

// Waits for the end of the attempt and stores its result before any device is closed. The watchdog runs meanwhile.
void Run::close() {
  if (closed_) return;
  closed_ = true;
  thread_->join();
  collect_reports();
  result_ = make_result(loop_->ending());
  if (recorder_) {
    recorder_->finish(make_end(result_));
    for (Problem& p : recorder_->problems()) result_.problems.push_back(std::move(p));
    tell_kept(recorder_->kept());
  }
  current_ = nullptr;
  close_devices(result_.problems);
  watchdog_->stop();
}

// result of reading the record back from the disk
void Run::tell_kept(const record::Kept& kept) {
  result_.not_kept = kept.where == record::Kept::Where::kNowhere;
  if (result_.not_kept) result_.attempt_id.clear();
  result_.kept_beside = kept.file;
  result_.missing_steps = kept.missing_steps;
}

Result Run::result() const { return closed_ ? result_ : make_result(Ending::kNone); }

void Run::collect_reports() {
  if (realtime()) problems_.push_back({Severity::kNote, "loop", grant_});
  for (std::size_t i = 0; i < ports_.size(); ++i)
    if (const uint32_t times = loop_->times_lost(i); times > 0)
      problems_.push_back({Severity::kWarning, ports_[i]->slot().instance->name,
                           "This hand was lost " + std::to_string(times) + (times == 1 ? " time" : " times") +
                               "; the lesson waited " + host::format_number(0.1 * std::round(10 * loop_->seconds_lost(i))) +
                               " s for it while its tool held."});
  for (host::Instance* instance : host::instances(*rig_)) {
    for (Problem& p : instance->services->take_reports()) problems_.push_back(std::move(p));
    if (instance->quarantined.load() != 0)
      problems_.push_back({Severity::kError, instance->name, host::quarantine_text(*instance)});
  }
}

}  // namespace swage::session
