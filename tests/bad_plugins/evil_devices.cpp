// SPDX-License-Identifier: Apache-2.0
//
// Evil devices: org.example.bad.device.<fault>. Those whose name begins with "step_" are asked in the step (LOCKSTEP). Each moves
// well for kGood exchanges before it does in exchange() what its name says.
#include <swage/abi/device_signals.h>
#include <swage/abi/device.h>

#include <cmath>
#include <limits>
#include <new>
#include <thread>

#include "evil.hpp"

namespace {

constexpr uint64_t kGood = 20;  // exchanges

const std::vector<evil::Fault> kFaults = {
    {"good", "Does nothing wrong."},
    {"open_refuses", "Refuses to open and does not say why."},
    {"exchange_refuses", "Answers exchange with an error."},
    {"exchange_discards", "Has no sample any more."},
    {"nan_pose", "Sends a pose that is no number."},
    {"nan_closure", "Sends a closure that is no number."},
    {"infinite_time", "Sends a time that is infinite."},
    {"huge_pose", "Sends a pose 1e200 m away."},
    {"zero_quaternion", "Sends a rotation that is none."},
    {"wild_closure", "Sends closures far outside of 0 to 1."},
    {"unknown_bits", "Says that fields are valid that nobody knows."},
    {"falls_silent", "Sends no new measurement any more."},
    {"loses_pose", "Says that its pose is not valid any more."},
    {"goes_back", "Counts and measures backwards."},
    {"jumps", "Jumps by half a metre with each sample."},
    {"no_table", "Has no table of a device."},
    {"no_exchange", "Has a table without exchange."},
    {"rate_nan", "Wants to be asked at a rate that is no number."},
    {"rate_zero", "Wants to be asked never."},
    {"force_nan", "Bears a force that is no number."},
    {"force_infinite", "Bears any force."},
    {"unknown_flags", "Has flags that nobody knows."},
    {"tells_infinity", "Tells of itself what is infinite."},
    {"tells_refuses", "Answers with an error when it is asked what it tells of itself."},
    {"tells_nameless", "Tells what has no name."},
    {"tells_twice", "Tells two things of one name."},
    {"tells_many", "Tells more than is allowed."},
    {"tells_gap", "Tells, and has no function for it."},
    {"step_sleeps", "Sleeps 2 ms in each step."},
    {"step_allocates", "Allocates memory in each step."},
    {"step_nan_pose", "Sends a pose that is no number, in the step."},
    {"step_done", "Says at once that it has come to its end."},
};

const char* const kNoTraits[] = {nullptr};
const evil::Catalogue& catalogue() {
  static const evil::Catalogue all(SWAGE_KIND_DEVICE, "org.example.bad.device.", kFaults,
                                    {"open", "exchange", "step", "close"}, kNoTraits);
  return all;
}

struct Device {
  swage_instance raw{};
  swage_device table{};
  swage_device_signals signals{};
  std::string fault;
  uint64_t n = 0;
};

Device& of(swage_instance* raw) { return *static_cast<Device*>(raw->self); }

void spoil(Device& d, swage_sample& s) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::string& f = d.fault;
  if (f == "nan_pose" || f == "step_nan_pose") s.pose.p.y = kNan;
  if (f == "nan_closure") s.closure = kNan;
  if (f == "infinite_time") s.time_s = HUGE_VAL;
  if (f == "huge_pose") s.pose.p.x = 1e200;
  if (f == "zero_quaternion") s.pose.q = {0, 0, 0, 0};
  if (f == "wild_closure") s.closure = d.n % 2 ? 1e9 : -1e9;
  if (f == "unknown_bits") s.valid = ~0u & ~SWAGE_VALID_DONE;
  if (f == "loses_pose") s.valid = SWAGE_VALID_CLOSURE;
  if (f == "goes_back") s.sequence = 1'000'000 - d.n, s.time_s = -static_cast<double>(d.n);
  if (f == "jumps") s.pose.p.x = d.n % 2 ? 0.5 : 0;
  if (f == "step_done") s.valid |= SWAGE_VALID_DONE;
  if (f == "falls_silent") s.sequence = kGood;
}

swage_result exchange(swage_instance* raw, const swage_command* command, swage_sample* out) {
  Device& d = of(raw);
  const bool now = ++d.n > kGood;
  *out = {};
  out->sequence = d.n;
  out->time_s = command->time_s;
  out->pose.p.x = 1e-3 * std::sin(1e-3 * static_cast<double>(d.n));
  out->pose.q.w = 1;
  out->closure = 0.5;
  out->valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;
  if (!now) return SWAGE_OK;
  evil::misbehave_in("exchange", d.fault);
  evil::misbehave_in("step", d.fault);
  if (d.fault == "step_sleeps") evil::sleep_ms(2);
  if (d.fault == "step_allocates") {
    void* volatile block = std::malloc(8);
    std::free(block);
  }
  spoil(d, *out);
  if (d.fault == "exchange_refuses") return SWAGE_ERROR;
  return d.fault == "exchange_discards" ? SWAGE_DISCARD : SWAGE_OK;
}

swage_device table_of(const std::string& f) {
  swage_device t{};
  t.flags = f.rfind("step_", 0) == 0 ? SWAGE_DEVICE_LOCKSTEP : 0;
  t.rate_hz = f == "rate_nan" ? std::nan("") : f == "rate_zero" ? 0 : 1000;
  if (f.rfind("force_", 0) == 0) t.flags |= SWAGE_DEVICE_FORCE;
  if (f == "force_nan") t.max_force = std::nan("");
  if (f == "force_infinite") t.max_force = HUGE_VAL;
  if (f == "unknown_flags") t.flags |= 0xFF00;
  t.open = [](swage_instance* raw) -> swage_result {
    evil::misbehave_in("open", of(raw).fault);
    return of(raw).fault == "open_refuses" ? SWAGE_ERROR : SWAGE_OK;
  };
  t.close = [](swage_instance* raw) { evil::misbehave_in("close", of(raw).fault); };
  t.exchange = f == "no_exchange" ? nullptr : exchange;
  return t;
}

swage_device_signals signals_of(const std::string& f) {
  static constexpr swage_device_signal kGoodOnes[] = {{"a", "1", "One."}, {"b", "1", "Another."}};
  static constexpr swage_device_signal kTwice[] = {{"a", "1", "One."}, {"a", "1", "Another."}};
  static constexpr swage_device_signal kNameless[] = {{nullptr, "1", "One."}};
  swage_device_signals t{};
  t.count = f == "tells_many" ? 1'000'000 : f == "tells_nameless" ? 1 : 2;
  t.signal = f == "tells_twice" ? kTwice : f == "tells_nameless" ? kNameless : kGoodOnes;
  if (f == "tells_gap") return t;
  t.read = [](swage_instance* raw, double* out) -> swage_result {
    const Device& d = of(raw);
    out[0] = d.n > kGood && d.fault == "tells_infinity" ? HUGE_VAL : 0.5;
    return d.n > kGood && d.fault == "tells_refuses" ? SWAGE_ERROR : SWAGE_OK;
  };
  return t;
}

swage_instance* create(const swage_host*, const char* id) {
  const std::string fault = catalogue().fault(id);
  if (fault.empty()) return nullptr;
  auto* d = new (std::nothrow) Device;
  if (d == nullptr) return nullptr;
  d->fault = fault;
  d->table = table_of(fault);
  d->signals = signals_of(fault);
  d->raw.self = d;
  d->raw.configure = [](swage_instance*, const swage_values*, swage_builder*) -> swage_result { return SWAGE_OK; };
  d->raw.activate = [](swage_instance*, double) -> swage_result { return SWAGE_OK; };
  d->raw.deactivate = [](swage_instance*) {};
  d->raw.destroy = [](swage_instance* raw) { delete &of(raw); };
  d->raw.get_extension = [](swage_instance* raw, const char* wanted) -> const void* {
    if (of(raw).fault == "no_table") return nullptr;
    if (of(raw).fault.rfind("tells_", 0) == 0 && std::strcmp(wanted, SWAGE_EXT_DEVICE_SIGNALS) == 0) return &of(raw).signals;
    return std::strcmp(wanted, SWAGE_EXT_DEVICE) == 0 ? &of(raw).table : nullptr;
  };
  return &d->raw;
}

const void* get_factory(const char* id) {
  static const swage_factory factory = {[] { return catalogue().count(); },
                                        [](uint32_t i) { return catalogue().at(i); }, create};
  return std::strcmp(id, SWAGE_FACTORY_INSTANCES) == 0 ? &factory : nullptr;
}

}  // namespace

extern "C" {
__attribute__((visibility("default"))) extern const swage_entry swage_plugin_entry;
}
const swage_entry swage_plugin_entry = {sizeof(swage_entry), SWAGE_ABI_MAJOR, SWAGE_ABI_MINOR, 0, "plain C++",
                                        nullptr,             nullptr,         get_factory};
