// SPDX-License-Identifier: Apache-2.0
#include "host/services.hpp"

#include <swage/abi/display.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/rng.hpp"
#include "host/builder.hpp"
#include "scene/world.hpp"

namespace swage::host {

namespace {
thread_local constinit int32_t role = SWAGE_THREAD_MAIN;
// unread reports of one instance, and characters of each
constexpr std::size_t kMostReports = 1000;
constexpr uint64_t kLongestReport = 2000;
}

int32_t thread_role() noexcept { return role; }
void set_thread_role(int32_t new_role) noexcept { role = new_role; }

void FaultRing::push(int32_t code, double a, double b) noexcept {
  const uint64_t k = head_.fetch_add(1, std::memory_order_relaxed);
  Slot& slot = slot_[k % kCapacity];
  // release stores: a reader that sees one of these values also sees the changed ticket; ThreadSanitizer does not model fences
  slot.ticket.store(2 * k + 1, std::memory_order_relaxed);
  slot.code.store(code, std::memory_order_release);
  slot.a.store(a, std::memory_order_release);
  slot.b.store(b, std::memory_order_release);
  slot.ticket.store(2 * k + 2, std::memory_order_release);
}

std::vector<Fault> FaultRing::take(uint64_t* lost) {
  const uint64_t head = head_.load(std::memory_order_acquire);
  const uint64_t first = std::max(taken_, head > kCapacity ? head - kCapacity : 0);
  uint64_t gone = first - taken_;
  std::vector<Fault> out;
  for (uint64_t k = first; k < head; ++k) {
    const Slot& slot = slot_[k % kCapacity];
    const uint64_t before = slot.ticket.load(std::memory_order_acquire);
    const Fault fault{slot.code.load(std::memory_order_acquire), slot.a.load(std::memory_order_acquire),
                      slot.b.load(std::memory_order_acquire)};
    const bool whole = before == 2 * k + 2 && slot.ticket.load(std::memory_order_relaxed) == before;
    if (whole) {
      out.push_back(fault);
    } else {
      ++gone;
    }
  }
  taken_ = head;
  if (lost != nullptr) *lost = gone;
  return out;
}

Services::Services(std::string instance_name, const Shared& shared, uint32_t random_index, uint64_t seed)
    : name_(std::move(instance_name)),
      shared_(shared),
      random_index_(random_index),
      own_random_(base::stream_seed(seed, name_)) {
  if (shared_.world != nullptr && random_index_ < shared_.world->random.size())
    shared_.world->random[random_index_] = own_random_;
  host_.struct_size = sizeof(swage_host);
  host_.abi_major = SWAGE_ABI_MAJOR;
  host_.abi_minor = SWAGE_ABI_MINOR;
  host_.host_data = this;
  host_.get_extension = get_extension;
  host_.report = report;
  host_.fault = fault;
  host_.thread_kind = thread_kind;
  host_.random_u64 = random_u64;
}

base::Problems Services::take_reports() {
  const std::lock_guard lock(reports_mutex_);
  return std::exchange(reports_, {});
}

const void* Services::get_extension(const swage_host*, const char* id) {
  static constexpr swage_host_pointer pointer{read_pointer};
  static constexpr swage_host_attempt attempt{attempt_mode};
  static constexpr swage_host_display display{display_eyes};
  static constexpr swage_host_environment environment{read_environment};
  if (id == nullptr) return nullptr;
  static constexpr swage_host_capacities capacities{reserve_points, read_capacities};
  if (std::strcmp(id, SWAGE_HOST_HEIGHT_FIELD) == 0) return &height_field_table();
  if (std::strcmp(id, SWAGE_HOST_ATTEMPT) == 0) return &attempt;
  if (std::strcmp(id, SWAGE_HOST_DISPLAY) == 0) return &display;
  if (std::strcmp(id, SWAGE_HOST_CAPACITIES) == 0) return &capacities;
  if (std::strcmp(id, SWAGE_HOST_CHAIN) == 0) return &chain_table();
  if (std::strcmp(id, SWAGE_HOST_ENVIRONMENT) == 0) return &environment;
  return std::strcmp(id, SWAGE_HOST_POINTER) == 0 ? &pointer : nullptr;
}

int32_t Services::attempt_mode(const swage_host* host) {
  return of(host).attempt().mode;
}

int32_t Services::display_eyes(const swage_host* host) {
  return of(host).attempt().eyes;
}

void Services::read_environment(const swage_host* host, swage_environment* out) {
  if (out == nullptr) return;
  const Services& self = of(host);
  const swage_environment all = self.shared_.world != nullptr ? self.shared_.world->environment : kStillAir;
  const uint32_t size = std::min<uint32_t>(out->struct_size, sizeof all);
  std::memcpy(out, &all, size);
  out->struct_size = size;
}

void Services::report(const swage_host* host, int32_t severity, swage_str where, swage_str message) {
  Services& self = of(host);
  if (role == SWAGE_THREAD_RT) {
    // text on [rt] would allocate: it is dropped, and counted as a breach
    self.role_breaches_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  const auto level = static_cast<base::Severity>(std::clamp(severity, SWAGE_NOTE, SWAGE_SEVERE));
  const std::lock_guard lock(self.reports_mutex_);
  // a plugin that reports without end must not exhaust the memory
  if (self.reports_.size() >= kMostReports) return;
  const bool named = where.data != nullptr && where.size > 0;
  self.reports_.push_back({level, named ? std::string(where.data, std::min(where.size, kLongestReport)) : self.name_,
                           message.data != nullptr ? std::string(message.data, std::min(message.size, kLongestReport)) : ""});
}

void Services::fault(const swage_host* host, int32_t code, double a, double b) {
  of(host).faults_.push(code, a, b);
}

int32_t Services::thread_kind(const swage_host*) { return role; }

uint64_t Services::random_u64(const swage_host* host) {
  Services& self = of(host);
  if (role != SWAGE_THREAD_RT) self.role_breaches_.fetch_add(1, std::memory_order_relaxed);
  const bool in_world =
      self.shared_.world != nullptr && self.random_index_ < self.shared_.world->random.size();
  return base::splitmix64(in_world ? self.shared_.world->random[self.random_index_] : self.own_random_);
}

void Services::read_capacities(const swage_host* host, swage_capacities* out) {
  if (out == nullptr) return;
  const Services& self = of(host);
  const swage_capacities all =
      self.shared_.world != nullptr ? capacities_of(*self.shared_.world) : capacities_of(scene::World());
  const uint32_t size = std::min<uint32_t>(out->struct_size, sizeof all);
  std::memcpy(out, &all, size);
  out->struct_size = size;
}

const swage_pointer* Services::read_pointer(const swage_host* host) {
  return &of(host).attempt().pointer;
}

const Attempt& Services::attempt() const noexcept {
  static constexpr Attempt nobodys;
  return shared_.attempt != nullptr ? *shared_.attempt : nobodys;
}

}  // namespace swage::host
