// SPDX-License-Identifier: Apache-2.0
//
// One library of devices for the validator, whose id is the name of the folder that it lies in: org.example.bad.driver.<fault>. Tests
// copy it. A fault whose name begins with "sight_" is one of a device that sees, and is asked in the step; the others are drivers
// with a thread of their own. Each behaves for kGood exchanges, and its hardware is always there. Plain tables without the wrapper.
#include <swage/abi/calibration.h>
#include <swage/abi/sight.h>

#include <cmath>
#include <new>

#include "evil.hpp"

extern "C" {
__attribute__((visibility("default"))) extern const swage_entry swage_plugin_entry;
}

namespace {

constexpr uint64_t kGood = 20;  // exchanges

const std::string& id() {
  static const std::string name = evil::bundle_of(&swage_plugin_entry);
  return name;
}
bool is(const char* fault) { return id().substr(id().rfind('.') + 1) == fault; }
bool sees() { return id().find(".sight_") != std::string::npos; }

struct Device {
  swage_instance raw{};
  swage_device table{};
  const swage_host* host = nullptr;
  uint64_t n = 0;       // exchanges so far
  double seen = 0;      // m, of what it looked at
};
Device& of(swage_instance* raw) { return *static_cast<Device*>(raw->self); }
int instances = 0;

double now_s() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void spoil(Device& d, swage_sample& s) {
  if (is("not_finite") || is("sight_not_finite")) s.pose.p.y = std::nan("");
  if (is("quaternion") || is("sight_quaternion")) s.pose.q.w = 2;
  if (is("closure") || is("sight_closure")) s.closure = 1.5;
  if (is("unknown_fields")) s.valid |= 0x8000;
  if (is("backwards")) s.sequence = 1'000'000 - d.n;
  if (is("older")) s.time_s -= 1e-3 * static_cast<double>(d.n);
  if (is("slow_exchange") && d.n == kGood + 1) evil::sleep_ms(200);
  if (is("too_slow_exchange")) evil::sleep_ms(1200);
  if (is("calls_host")) d.host->random_u64(d.host);
  if (is("sight_allocates")) {
    void* volatile block = std::malloc(8);
    std::free(block);
  }
  if (is("sight_shares")) s.pose.p.z += 1e-3 * instances;
}

swage_result exchange(swage_instance* raw, const swage_command* command, swage_sample* out) {
  Device& d = of(raw);
  if (is("sends_nothing")) return SWAGE_OK;
  ++d.n;
  *out = {};
  out->sequence = d.n;
  out->time_s = sees() || is("other_clock") ? command->time_s - (is("other_clock") ? 1e3 : 0) : now_s();
  out->pose = {{d.seen, 0, 1e-3 * std::sin(1e-3 * static_cast<double>(d.n))}, {1, 0, 0, 0}};
  out->closure = 0.5;
  out->valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;
  if (d.n > kGood) spoil(d, *out);
  return SWAGE_OK;
}

swage_result look(swage_instance* raw, const swage_sight* sight) {
  const swage_view& view = *sight->view;
  if (view.n_object > 0 && view.object_step[0].n_body > 0) {
    swage_pose& X_WB = view.object_step[0].X_WB[0];
    of(raw).seen = X_WB.p.x;
    if (is("sight_writes") && of(raw).n > kGood) X_WB.p.x += 1e-3;
  }
  return SWAGE_OK;
}

const void* table_of(Device& d, const char* wanted) {
  static constexpr swage_device_sight sight{[](swage_instance*, const swage_sight_card*) -> swage_result { return SWAGE_OK; }, look};
  static constexpr swage_device_calibration words{[](swage_instance*) -> swage_str { return {"0.5 mm", 6}; }}, none{nullptr};
  if (std::strcmp(wanted, SWAGE_EXT_DEVICE) == 0) return &d.table;
  if (std::strcmp(wanted, SWAGE_EXT_SIGHT) == 0 && sees()) return &sight;
  if (std::strcmp(wanted, SWAGE_EXT_CALIBRATION) != 0) return nullptr;
  return is("calibration_no_json") ? &words : is("calibration_gaps") ? &none : nullptr;
}

swage_instance* create(const swage_host* host, const char* wanted) {
  if (id() != wanted) return nullptr;
  auto* d = new (std::nothrow) Device;
  if (d == nullptr) return nullptr;
  ++instances;
  d->host = host;
  d->table.flags = sees() ? SWAGE_DEVICE_LOCKSTEP | SWAGE_DEVICE_WORLD : is("unknown_flags") ? 0xFF00u : 0;
  d->table.rate_hz = is("no_rate") ? 0 : 1000;
  d->table.max_force = is("force") ? 1 : 0;  // N, of a device that takes no forces
  d->table.open = [](swage_instance*) -> swage_result { return is("opens_not") ? SWAGE_ERROR : SWAGE_OK; };
  d->table.close = [](swage_instance*) {};
  d->table.exchange = exchange;
  d->raw.self = d;
  d->raw.configure = [](swage_instance*, const swage_values*, swage_builder*) -> swage_result { return SWAGE_OK; };
  d->raw.activate = [](swage_instance*, double) -> swage_result { return SWAGE_OK; };
  d->raw.deactivate = [](swage_instance*) {};
  d->raw.destroy = [](swage_instance* raw) { delete &of(raw); };
  d->raw.get_extension = [](swage_instance* raw, const char* wanted_table) { return table_of(of(raw), wanted_table); };
  return &d->raw;
}

const char* const kTraits[] = {nullptr};
const swage_descriptor* describe(uint32_t index) {
  static const swage_descriptor d{sizeof(swage_descriptor), SWAGE_KIND_DEVICE, id().c_str(), "1.0.0", "Driver", "Has one fault.",
                                  "Swage", "Apache-2.0", kTraits};
  return index == 0 ? &d : nullptr;
}

const void* get_factory(const char* wanted) {
  static const swage_factory factory = {[] { return 1u; }, describe, create};
  return std::strcmp(wanted, SWAGE_FACTORY_INSTANCES) == 0 ? &factory : nullptr;
}

}  // namespace

const swage_entry swage_plugin_entry = {sizeof(swage_entry), SWAGE_ABI_MAJOR, SWAGE_ABI_MINOR, 0, "plain C++",
                                        nullptr,             nullptr,         get_factory};
