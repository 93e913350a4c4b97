// SPDX-License-Identifier: Apache-2.0
#include "host/device_signals.hpp"

#include <cmath>
#include <limits>
#include <set>

#include "host/guard.hpp"

namespace swage::host {
namespace {

// "" or the fault of a table
std::string fault(const swage_device_signals& table) {
  if (table.count < 1 || table.count > SWAGE_MOST_DEVICE_SIGNALS)
    return "says " + std::to_string(table.count) + " signals; allowed are 1 to " + std::to_string(SWAGE_MOST_DEVICE_SIGNALS);
  if (table.signal == nullptr || table.read == nullptr) return "has gaps";
  std::set<std::string> ids;
  for (uint32_t i = 0; i < table.count; ++i) {
    const swage_device_signal& s = table.signal[i];
    if (s.id == nullptr || s.unit == nullptr || s.doc == nullptr || *s.id == 0 || *s.unit == 0 || *s.doc == 0)
      return "has a signal without id, unit or meaning";
    if (!ids.insert(s.id).second) return "has two signals \"" + std::string(s.id) + "\"";
  }
  return "";
}

}  // namespace

DeviceSignals::DeviceSignals(Instance& instance, std::string& error) : instance_(&instance) {
  const auto* table = static_cast<const swage_device_signals*>(instance.extension(SWAGE_EXT_DEVICE_SIGNALS));
  if (table == nullptr) return;
  const std::string wrong = fault(*table);
  if (wrong.empty())
    table_ = table;
  else
    error = "The table " SWAGE_EXT_DEVICE_SIGNALS " of " + instance.plugin_id + " " + wrong + ".";
}

bool DeviceSignals::read(uint64_t step, double* out) const noexcept {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (uint32_t i = 0; i < count(); ++i) out[i] = kNan;
  if (count() == 0 || instance_->quarantined.load(std::memory_order_relaxed) != 0) return true;
  guarded(*instance_, Call::kExchange, step, [&] { return table_->read(instance_->raw, out); });
  bool finite = true;
  for (uint32_t i = 0; i < count(); ++i) {
    if (!std::isinf(out[i])) continue;
    finite = false;
    out[i] = kNan;
  }
  return finite;
}

}  // namespace swage::host
