// SPDX-License-Identifier: Apache-2.0
//
// One live instance of a plugin, its configuration, and its record with the guard (guard.hpp).
#pragma once

#include <swage/abi/plugin.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host/params.hpp"
#include "host/services.hpp"

namespace swage::host {

class Builder;
class Library;
struct PluginInfo;

/// Reason for which an instance is in quarantine.
enum class FaultKind : uint32_t {
  kNone,
  kError,
  kFault,
  kNotFinite,
  kTooLarge,
  kFpuMode,
  kLate,
  kWaited,
  kStalled,
  kLocale,
  kMeddled
};

/// The function of a plugin that is running.
enum class Call : uint32_t {
  kNone,
  kCreate,
  kConfigure,
  kActivate,
  kDeactivate,
  kDestroy,
  kExtension,
  kBind,
  kOpen,
  kClose,  // [main]
  kForces,
  kFinish,
  kReset,
  kAdvance,
  kMobility,
  kApplyImpulses,
  kResolve,
  kObserve,
  kExchange,  // [rt], [io]
  kChange,    // [rt]
  kTies,
  kOnSolved,
  kDisplacement,
  kDraw,
  kLinearise,
  kDisplace,  // [rt]
  kLoad,
  kInit,
  kDescribe  // [main]
};

/// Calls outside of the step that must return within CallWatch::kLimit; open and close of a device have their own limits.
constexpr bool on_main(Call call) {
  return (call >= Call::kCreate && call <= Call::kBind) || call >= Call::kLoad;
}

const char* text(FaultKind fault);  // "returned an error", ...
const char* text(Call call);        // "forces", ...

/// Timing of the guard; written by the thread that calls the instance.
struct Watch {
  int64_t budget_ns =
      0;  // own processor time per step; 0: untimed, so that nothing depends on the wall clock
  uint64_t step = ~uint64_t{0};
  int64_t wall_ns = 0, cpu_ns = 0;  // in this step so far
  uint64_t investigate_until = 0;   // up to this step the processor clock is read around each call
  bool investigated = false;        // in this step, from its first call on
  bool may_wait = false;            // it is called on [io]: a driver may wait
  int64_t waited_ns = 0;            // in this step so far: wall time of calls that waited voluntarily
  int64_t excess_ns = 0;            // ns over the budget, since the late steps were last cleared
  uint64_t late[2] = {0, 0};        // bit i: late i steps ago; [0] the latest 64
  std::atomic<uint32_t> badge{0};   // 1: late in 5 of the last 100 steps
  std::atomic<uint64_t> late_steps{0};
  std::atomic<uint64_t> preempted{0};  // number of steps over the budget by the wall clock and within it by the processor clock
  std::atomic<int64_t> worst_wall_ns{0};

  /// Restarts the budget within a step: time spent on it so far is not counted.
  void renew() noexcept { wall_ns = cpu_ns = waited_ns = 0; }
};

class Instance {
 public:
  Instance() = default;
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;
  ~Instance();  // deactivates and destroys the plugin's instance

  /// Creates an instance of `plugin`. nullptr: `error` has one sentence. [main]
  static std::unique_ptr<Instance> create(const PluginInfo& plugin, const Library& library,
                                          const std::string& name, const Shared& shared,
                                          uint32_t random_index, uint64_t seed, std::string& error);

  /// Stores the values and passes them to the plugin. False: `error` has a sentence, the builder may have more.
  /// [main]
  bool configure(ParamValues values, Builder& builder, std::string& error);
  bool activate(double dt_s, std::string& error);  // [main]
  void deactivate();                               // [main]
  bool active() const { return active_; }

  /// An extension of the instance, guarded; nullptr when it does not offer it. [main]
  const void* extension(const char* id);

  std::string name;  // in the lesson file
  std::string plugin_id, plugin_version;
  std::vector<swage_value> values;
  std::vector<std::string> texts;  // texts to which values[i].text points
  std::vector<std::string> traits;
  swage_instance* raw = nullptr;
  std::unique_ptr<Services> services;

  // --- guard: written on [rt], read anywhere
  std::atomic<uint32_t> quarantined{0};
  std::atomic<uint64_t> quarantine_step{0};
  std::atomic<FaultKind> fault{FaultKind::kNone};
  std::atomic<Call> fault_call{Call::kNone};
  Watch watch;

 private:
  bool active_ = false;
};

/// "needle (swage.object.needle 1.2.0): forces() returned a number that is not finite at step 120; ..."
/// [main]
std::string quarantine_text(const Instance& instance);

}  // namespace swage::host
