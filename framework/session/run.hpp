// SPDX-License-Identifier: Apache-2.0
//
// Implementation of Session: owns the scene, the threads and the record of one attempt.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "host/catalogue.hpp"
#include "host/guard.hpp"
#include "host/rig.hpp"
#include "record/recorder.hpp"
#include "session/device_ports.hpp"
#include "session/knot_test.hpp"
#include "session/loop.hpp"
#include "session/processor_wait.hpp"
#include "session/rt_thread.hpp"
#include "session/sentinel.hpp"
#include "session/session.hpp"
#include "session/watchdog.hpp"
#include "step/step.hpp"

namespace swage::session {

class Run final : public Session {
 public:
  /// `rig` is assembled and active. [main]
  Run(const Options& options, host::Catalogue catalogue, std::unique_ptr<host::Rig> rig,
      std::unique_ptr<Sentinel> sentinel);
  ~Run() override;

  /// Opens devices and the record. False: the reasons are in `problems`. [main]
  bool prepare(Problems& problems);

  const snapshot::SceneCard& card() const override { return rig_->card; }
  void start() override;
  void pause(bool on) override { loop_->pause(on); }
  void reset_object(const std::string& object_name) override;
  void mark(const std::string& note) override;
  bool change(const std::string& instance_name, const std::string& params, Problems& problems) override;
  void stop() override;
  bool finished() const override { return loop_->finished(); }
  void wait() override;
  bool pull_knot(uint64_t most_steps, PullProgress& out) override;
  void pointer(const swage_pointer& p, int64_t due_ns) override { loop_->pointer(p, due_ns); }
  bool latest(snapshot::Snapshot& out) const override { return loop_->latest(out); }
  bool next_event(judge::Event& out) override { return loop_->next_event(out); }
  Result result() const override;

 private:
  void open_devices(Problems& problems);
  void add_signals(Problems& problems);
  void open_record(Problems& problems);
  void close();
  void close_devices(Problems& problems);
  void open_port(host::DeviceSlot& slot, Problems& problems);
  void hung();
  void save_void(const char* reason);
  static void ended_by_plugin(const host::LastCall& call, const char* cause);
  void collect_reports();
  void tell_kept(const record::Kept& kept);
  Result make_result(Ending ending) const;
  void tell_circumstances(Result& out) const;
  record::AttemptEnd make_end(const Result& result) const;
  bool realtime() const { return options_.pace == Pace::kRealtime; }

  const Options options_;
  const host::Catalogue catalogue_;
  std::unique_ptr<Sentinel> sentinel_;  // outlives the plugins
  std::unique_ptr<host::Rig> rig_;
  ProcessorWait processor_wait_;  // of the step's thread; read by the watchdog
  std::unique_ptr<Watchdog> watchdog_;
  std::vector<std::unique_ptr<Port>> ports_;
  std::vector<host::DeviceSlot*> opened_;
  std::unique_ptr<step::Engine> engine_;
  std::unique_ptr<record::Recorder> recorder_;
  std::unique_ptr<Loop> loop_;
  std::unique_ptr<KnotTest> knot_test_;  // once the attempt has been passed, where the lesson asks for it
  std::unique_ptr<RtThread> thread_;

  static std::atomic<Run*> current_;
  std::atomic<const host::LastCall*> last_call_{nullptr};  // of the step thread
  uint64_t idle_beats_ = 0;                                // heartbeat for the watchdog after the attempt has ended
  uint32_t marks_ = 0;
  bool left_ = false;  // a device has not returned from a call: data that its thread may use are never destroyed
  bool started_ = false, closed_ = false;
  std::string grant_;
  Problems problems_;
  Result result_;
};

}  // namespace swage::session
