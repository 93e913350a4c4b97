// SPDX-License-Identifier: Apache-2.0
//
// The services of the host for one instance (swage_host): reports, faults, the thread's role, seeded random
// numbers, extensions.
#pragma once

#include <swage/abi/builder.h>
#include <swage/abi/device.h>
#include <swage/abi/display.h>
#include <swage/abi/environment.h>
#include <swage/abi/lesson.h>
#include <swage/abi/plugin.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "base/problem.hpp"

namespace swage::scene {
struct World;
}

namespace swage::host {

/// Role of the calling thread, SWAGE_THREAD_*; MAIN unless set. [any]
int32_t thread_role() noexcept;
void set_thread_role(int32_t role) noexcept;

/// Sets a role for a scope: tests run the whole life of an instance on one thread.
class ScopedRole {
 public:
  explicit ScopedRole(int32_t role) : before_(thread_role()) { set_thread_role(role); }
  ~ScopedRole() { set_thread_role(before_); }
  ScopedRole(const ScopedRole&) = delete;
  ScopedRole& operator=(const ScopedRole&) = delete;

 private:
  int32_t before_;
};

/// A fault that a plugin reported with swage_host.fault.
struct Fault {
  int32_t code = 0;
  double a = 0, b = 0;
};

/// The last kCapacity faults of an instance: wait-free writers from any thread, one reader on [main].
class FaultRing {
 public:
  static constexpr uint64_t kCapacity =
      32;  // more faults in one reading interval overwrite the oldest; `lost` counts them
  void push(int32_t code, double a, double b) noexcept;
  /// Returns the faults since the last call, oldest first. [main]
  std::vector<Fault> take(uint64_t* lost = nullptr);

 private:
  struct Slot {
    std::atomic<uint64_t> ticket{0};  // 2 k + 1 while the k-th fault is written, 2 k + 2 when complete
    std::atomic<int32_t> code{0};
    std::atomic<double> a{0}, b{0};
  };
  std::array<Slot, kCapacity> slot_;
  std::atomic<uint64_t> head_{0};
  uint64_t taken_ = 0;
};

/// The attempt, as every instance may query it.
struct Attempt {
  int32_t mode = SWAGE_ATTEMPT_TEST;
  int32_t eyes = SWAGE_EYES_NONE;                         // at the beginning of the attempt
  swage_pointer pointer{0, 0, 0, 0, 0, 0, {1, 0, 0, 0}};  // of this step; mirrored in a lesson for the other hand
};

/// Data shared by the services of all instances of a rig; owned by the rig.
struct Shared {
  scene::World* world = nullptr;     // random streams live in its saved state
  const Attempt* attempt = nullptr;  // nullptr: a test without a viewer
};

class Services {
 public:
  /// `random_index`: the instance's generator in World::random, or scene::kNone to keep one here.
  Services(std::string instance_name, const Shared& shared, uint32_t random_index, uint64_t seed);
  Services(const Services&) = delete;
  Services& operator=(const Services&) = delete;

  const swage_host* abi() const { return &host_; }
  /// Problems that the plugin reported since the last call. [main]
  base::Problems take_reports();
  FaultRing& faults() { return faults_; }
  /// Number of calls of host functions from a role that may not make them (always checked, reported by the validator).
  /// [any]
  uint32_t role_breaches() const { return role_breaches_.load(std::memory_order_relaxed); }

 private:
  static Services& of(const swage_host* host) { return *static_cast<Services*>(host->host_data); }
  static const void* get_extension(const swage_host*, const char* id);
  static void report(const swage_host*, int32_t severity, swage_str where, swage_str message);
  static void fault(const swage_host*, int32_t code, double a, double b);
  static int32_t thread_kind(const swage_host*);
  static uint64_t random_u64(const swage_host*);
  static void read_capacities(const swage_host*, swage_capacities* out);
  static const swage_pointer* read_pointer(const swage_host*);
  static int32_t attempt_mode(const swage_host*);
  static int32_t display_eyes(const swage_host*);
  static void read_environment(const swage_host*, swage_environment* out);

  swage_host host_{};
  std::string name_;
  const Attempt& attempt() const noexcept;

  Shared shared_;
  uint32_t random_index_;
  uint64_t own_random_;
  FaultRing faults_;
  std::mutex reports_mutex_;  // [main] and [io] only
  base::Problems reports_;
  std::atomic<uint32_t> role_breaches_{0};
};

}  // namespace swage::host
