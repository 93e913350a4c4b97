// SPDX-License-Identifier: Apache-2.0
//
// Test of a device with a thread of its own, called as the session calls it. Every commanded force is zero.
#include <swage/abi/calibration.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/clock.hpp"
#include "host/device_signals.hpp"
#include "host/services.hpp"
#include "tools/extension_tests.hpp"
#include "tools/print.hpp"
#include "tools/processor_wait.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using host::Finding;
using host::Mark;

constexpr uint32_t kKnownFlags = SWAGE_DEVICE_LOCKSTEP | SWAGE_DEVICE_FORCE | SWAGE_DEVICE_WORLD | SWAGE_DEVICE_SCRIPTED |
                                 SWAGE_DEVICE_POINTER;
constexpr uint32_t kKnownBits = SWAGE_VALID_POSE | SWAGE_VALID_TWIST | SWAGE_VALID_CLOSURE | SWAGE_VALID_GRIP |
                                SWAGE_VALID_BUTTONS | SWAGE_VALID_DONE;
constexpr int kExchanges = 300, kAfterPause = 30;
constexpr int64_t kPause = 300'000'000;  // ns without a call, as when the machine is busy
// s, limits for one exchange: the session gives up a hand after 0.1 s without a sample, and a device after 2 s. What a busy machine
// makes the thread wait is left out.
constexpr double kSlow = 0.1, kTooSlow = 1;

class Driver {
 public:
  explicit Driver(host::DeviceSlot& slot) : slot_(slot), signals_(*slot.instance, signals_wrong_) {}

  /// "" or the fault of the table itself.
  std::string table() const {
    const swage_device& d = *slot_.device;
    if ((d.flags & ~kKnownFlags) != 0) return say::kUnknownFlags(d.flags & ~kKnownFlags);
    if (!std::isfinite(d.rate_hz) || d.rate_hz <= 0) return say::kNoRate(format("%g", d.rate_hz));
    if (!std::isfinite(d.max_force) || (d.max_force > 0) != ((d.flags & SWAGE_DEVICE_FORCE) != 0))
      return say::kForces((d.flags & SWAGE_DEVICE_FORCE) != 0 ? "takes" : "takes no", format("%g", d.max_force));
    return signals_wrong_;
  }

  Finding open() {
    swage_result result = SWAGE_ERROR;
    host::guarded(instance(), host::Call::kOpen, 0, [&] { return result = slot_.device->open(instance().raw); });
    base::Problems said = instance().services->take_reports();
    if (result >= 0) return calibration();
    if (instance().quarantined.load() != 0 && said.empty() && result != SWAGE_ERROR)
      return {Mark::kFailed, host::quarantine_text(instance())};
    if (said.empty()) return {Mark::kFailed, say::kOpensNot()};
    // missing hardware is no fault of the plugin
    return {Mark::kSkipped, say::kDidNotOpen(said[0].message)};
  }
  /// Tests that the calibration is JSON which the record can keep, or absent.
  Finding calibration() {
    const auto* table = static_cast<const swage_device_calibration*>(instance().extension(SWAGE_EXT_CALIBRATION));
    if (table == nullptr) return {};
    if (table->text == nullptr) return {Mark::kFailed, say::kTableGaps(SWAGE_EXT_CALIBRATION)};
    const swage_str text = table->text(instance().raw);
    if (text.data == nullptr || text.size == 0) return {};
    if (nlohmann::json::parse(text.data, text.data + text.size, nullptr, false).is_object()) return {};
    return {Mark::kFailed, say::kCalibrationNoJson()};
  }
  void close() {
    host::detail::contained(instance(), host::Call::kClose, 0, [&] { slot_.device->close(instance().raw); });
  }

  /// Calls exchange() on a thread of its own; "" or the fault.
  std::string run(int times) {
    std::thread io([&] {
      const host::ScopedRole role(SWAGE_THREAD_IO);
      const double period = 1 / std::clamp(slot_.device->rate_hz, 20.0, 4000.0);
      int64_t next = base::wall_ns();
      for (int i = 0; i < times && wrong_.empty(); ++i) {
        exchange();
        next = std::max(next + static_cast<int64_t>(1e9 * period), base::wall_ns());
        base::sleep_until_ns(next);
      }
    });
    io.join();
    return wrong_;
  }

  Finding verdict() const {
    if (measurements_ == 0)
      return {Mark::kWarning, say::kSentNothing()};
    if (longest_ > kSlow)
      return {Mark::kWarning, say::kSlowExchange(format("%.2f", longest_), format("%.1f", kSlow))};
    if (!odd_.empty()) return {Mark::kWarning, odd_};
    return {Mark::kSuccess, say::kMeasurements(measurements_, format("%.1f", 1e3 * longest_))};
  }

 private:
  host::Instance& instance() { return *slot_.instance; }

  void exchange() {
    swage_command command{};
    command.time_s = 1e-9 * static_cast<double>(base::wall_ns());
    command.anchor.q.w = 1;
    swage_sample sample = last_;
    const int64_t begin = base::wall_ns() - processor_wait_ns();
    const bool good = host::guarded(instance(), host::Call::kExchange, ++n_,
                                    [&] { return slot_.device->exchange(instance().raw, &command, &sample); });
    const double took = 1e-9 * static_cast<double>(base::wall_ns() - processor_wait_ns() - begin);
    longest_ = std::max(longest_, took);
    if (took > kTooSlow) wrong_ = say::kTooSlowExchange(format("%.2f", took));
    if (instance().quarantined.load() != 0) wrong_ = host::quarantine_text(instance());
    if (instance().services->role_breaches() > 0) wrong_ = say::kCallsHost();
    if (good && wrong_.empty()) look(sample);
    if (good && wrong_.empty()) listen();
  }

  /// Tests that the device's signals are numbers or NaN (unknown).
  void listen() {
    if (signals_.count() == 0) return;
    double told[SWAGE_MOST_DEVICE_SIGNALS];
    const bool finite = signals_.read(n_, told);
    if (instance().quarantined.load() != 0) wrong_ = host::quarantine_text(instance());
    if (!finite) wrong_ = say::kInfinite();
  }

  void look(const swage_sample& s) {
    if (!host::finite(&s.time_s, 16)) wrong_ = say::kSampleNotFinite();
    if ((s.valid & ~kKnownBits) != 0) wrong_ = say::kUnknownFields(s.valid & ~kKnownBits);
    if (s.sequence < last_.sequence) wrong_ = say::kBackwards();
    const swage_quat& q = s.pose.q;
    const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    if ((s.valid & SWAGE_VALID_POSE) != 0 && !(std::abs(norm - 1) < 1e-3))
      wrong_ = say::kQuaternion(format("%g", norm));
    if ((s.valid & SWAGE_VALID_CLOSURE) != 0 && !(s.closure >= 0 && s.closure <= 1))
      odd_ = say::kClosure(format("%g", s.closure));
    if (s.sequence > last_.sequence) {
      if (measurements_ > 0 && s.time_s < last_.time_s) wrong_ = say::kOlder();
      if (std::abs(s.time_s - 1e-9 * static_cast<double>(base::wall_ns())) > 5)
        odd_ = say::kOtherClock();
      ++measurements_;
    }
    if (!wrong_.empty()) wrong_ += say::kExchange(n_);
    last_ = s;
  }

  host::DeviceSlot& slot_;
  std::string signals_wrong_;
  host::DeviceSignals signals_;
  swage_sample last_{};
  uint64_t n_ = 0, measurements_ = 0;
  double longest_ = 0;  // s
  std::string wrong_, odd_;
};

}  // namespace

Finding driver(const TestScene& scene, uint64_t) {
  Stepped s;
  std::string error;
  if (!scene.make({}, s, error)) return {Mark::kFailed, error};
  Driver driver(s.rig->devices[0]);
  if (std::string wrong = driver.table(); !wrong.empty()) return {Mark::kFailed, wrong};
  if (!scene.on_thread()) return {Mark::kSkipped, say::kInTheStep()};
  for (int round = 0; round < 3; ++round) {
    if (Finding f = driver.open(); f.mark != Mark::kSuccess) return f;
    std::string wrong = driver.run(kExchanges);
    if (wrong.empty()) base::sleep_until_ns(base::wall_ns() + kPause);
    if (wrong.empty()) wrong = driver.run(kAfterPause);
    driver.close();
    if (!wrong.empty()) return {Mark::kFailed, wrong};
  }
  return driver.verdict();
}

}  // namespace swage::tools
