// SPDX-License-Identifier: Apache-2.0
#include "session/rehearsal.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "assembly/assemble.hpp"
#include "host/guard.hpp"
#include "host/services.hpp"
#include "session/lesson_rig.hpp"
#include "session/sentences.hpp"

namespace swage::session {

namespace {

using base::Severity;

// s, simulated: limit where a lesson has none of its own
constexpr double kLongest = 600;

}  // namespace

std::unique_ptr<Rehearsal> Rehearsal::open(const Options& options, const char* hand, Problems& problems) {
  const assembly::LessonFile file = read_lesson(options, problems);
  const host::Catalogue catalogue = catalogue_of(options);
  const auto scripted = [hand](const assembly::LessonDevice& device) {
    return std::any_of(device.choices.begin(), device.choices.end(), [hand](const assembly::DeviceChoice& c) { return c.as == hand; });
  };
  if (std::none_of(file.devices.begin(), file.devices.end(), scripted)) {
    problems.push_back({Severity::kError, options.lesson_path, say::kNoHand(std::string(hand))});
    return nullptr;
  }
  auto rig = assembly::assemble(file, catalogue, {hand, {}, options.mode, eyes_of(options.display)}, problems);
  if (!rig) return nullptr;
  std::unique_ptr<Rehearsal> out(new Rehearsal(std::move(rig)));
  return out->build(problems) ? std::move(out) : nullptr;
}

Rehearsal::~Rehearsal() {
  for (host::DeviceSlot* slot : opened_)
    host::detail::contained(*slot->instance, host::Call::kClose, 0, [&] { slot->device->close(slot->instance->raw); });
}

bool Rehearsal::build(Problems& problems) {
  for (host::DeviceSlot& slot : rig_->devices) {
    host::Instance& instance = *slot.instance;
    if ((slot.device->flags & SWAGE_DEVICE_LOCKSTEP) == 0) {
      problems.push_back({Severity::kError, instance.name, say::kOwnClock(instance.plugin_id)});
      return false;
    }
    swage_result result = SWAGE_ERROR;
    host::guarded(instance, host::Call::kOpen, 0, [&] { return result = slot.device->open(instance.raw); });
    for (Problem& p : instance.services->take_reports()) problems.push_back(std::move(p));
    if (result < 0) {
      problems.push_back({Severity::kError, instance.name, say::kNotOpened(instance.plugin_id)});
      return false;
    }
    opened_.push_back(&slot);
    ports_.push_back(std::make_unique<StepPort>(slot, rig_->world.dt, true));
  }
  std::vector<step::DevicePort*> ports;
  for (const auto& port : ports_) ports.push_back(port.get()), port->arm();
  try {
    engine_ = std::make_unique<step::Engine>(*rig_, step::Options(), ports);
  } catch (const std::exception& e) {
    problems.push_back({Severity::kError, rig_->descriptor_path, e.what()});
    return false;
  }
  return true;
}

bool Rehearsal::step() {
  if (over_) return false;
  const host::ScopedRole stepping(SWAGE_THREAD_RT);
  engine_->step();
  ++at_;
  const double most = rig_->max_time_s > 0 ? rig_->max_time_s : kLongest;
  over_ = engine_->verdict().outcome != judge::Outcome::kRunning || engine_->hand_gone() || engine_->quarantined() > 0 ||
          engine_->world().time() >= most;
  return !over_;
}

}  // namespace swage::session
