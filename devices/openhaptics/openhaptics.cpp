// SPDX-License-Identifier: Apache-2.0
#include "openhaptics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "nodes/nodes.hpp"
#include "sentences.hpp"

namespace swage::openhaptics {
namespace {

constexpr int kTries = 10;        // attempts to take over an arm that a crashed program has left initialised
constexpr double kReturns = 2;    // s between two searches for a lost arm
constexpr double kLeaves = 0.5;   // s within which the servo releases the force; usual is 20 ms
constexpr double kLeastForce = 0.5, kMostForce = 7.9;  // N; a reported maximum beyond these limits is not used
constexpr int kNap_ns = 1'000'000;

void nap() {
  const timespec pause{0, kNap_ns};
  nanosleep(&pause, nullptr);
}

// The stylus points along its -z; the instrument points along x, and its closing direction z is to the left of the stylus.
const toolkit::Quat& stylus_to_tool() {
  static const toolkit::Quat q = [] {
    toolkit::Mat3 R;
    R.col(0) = -Vec3::UnitZ();
    R.col(1) = -Vec3::UnitY();
    R.col(2) = -Vec3::UnitX();
    return toolkit::Quat(R);
  }();
  return q;
}

}  // namespace

void Openhaptics::drain() {
  for (int i = 0; i < 64 && hd_->GetError().code != 0; ++i) {
  }
}

// Some drivers find the default arm without a name, others by one of two.
unsigned Openhaptics::init(std::string& why) {
  const std::string& wanted = params().device;
  const std::array<const char*, 3> names = {wanted.empty() ? nullptr : wanted.c_str(), "Default Device", "Default PHANToM"};
  for (std::size_t n = 0; n < (wanted.empty() ? names.size() : 1); ++n) {
    for (int i = 0; i < kTries; ++i) {
      drain();
      const unsigned device = hd_->InitDevice(names[n]);
      const HdError error = hd_->GetError();
      if (device != kBadHandle && error.code == 0) return device;
      if (error.code != kAlreadyInitiated) {
        if (why.empty()) why = hd_->GetErrorString(error.code);
        break;
      }
      hd_->DisableDevice(hd_->GetCurrentDevice());
    }
  }
  if (why.empty()) why = say::kTaken();
  return kBadHandle;
}

// order: device, callback, scheduler; otherwise drivers report errors
bool Openhaptics::reach(std::string& why) {
  device_ = init(why);
  if (device_ == kBadHandle) {
    constexpr uint16_t k3dSystems = 0x2988;
    if (const std::string arm = nodes::closed_of_maker(k3dSystems); !arm.empty())
      why = say::kMayNotOpen(arm);
    else
      why = say::kNoArm(why);
    return false;
  }
  const unsigned calibration = hd_->CheckCalibration();
  if (calibration == kNeedsManualInput) {
    hd_->DisableDevice(device_);
    device_ = kBadHandle;
    why = say::kNotCalibrated();
    return false;
  }
  double most = 0;
  hd_->GetDoublev(kNominalMaxForce, &most);
  most = most >= kLeastForce && most <= kMostForce ? most : kLeastForce;
  for (const unsigned what : {kForceOutput, kMaxForceClamping, kForceRamping, kSoftwareForceLimit}) hd_->Enable(what);
  drain();
  servo_.start(hd_, device_, most);
  callback_ = hd_->ScheduleAsynchronous(&Servo::tick, &servo_, kHighest);
  hd_->StartScheduler();
  scheduled_ = true;
  const HdError error = hd_->GetError();
  if (error.code == 0 || recoverable(error.code)) return true;
  why = say::kNoScheduler(hd_->GetErrorString(error.code));
  close();
  return false;
}

void Openhaptics::open() {
  std::string why;
  hd_ = load_hd(params().library, why);
  if (hd_ == nullptr || !reach(why)) return refuse(why);
  last_ = {};
  closure_ = 0;
  last_s_ = tried_s_ = now_s();
  const char* const model = hd_->GetString(kModel);
  const char* const serial = hd_->GetString(kSerial);
  note(say::kArm(model != nullptr ? model : say::kUnknown(), serial != nullptr ? serial : say::kUnknown()));
}

// order: the force, the scheduler, the arm
void Openhaptics::close() {
  if (device_ == kBadHandle) return;
  servo_.leave();
  for (const double until = now_s() + kLeaves; !servo_.gone() && servo_.lost() == 0 && now_s() < until;) nap();
  if (scheduled_) hd_->StopScheduler();
  if (scheduled_ && !servo_.gone()) hd_->Unschedule(callback_);
  scheduled_ = false;
  hd_->DisableDevice(device_);
  device_ = kBadHandle;
  drain();
}

void Openhaptics::exchange(const swage_command& command, swage_sample& sample) {
  const double now = now_s(), dt = std::clamp(now - last_s_, 0.0, 0.05);
  last_s_ = now;
  if (device_ == kBadHandle || servo_.lost() != 0) {
    if (now - tried_s_ < kReturns) return;
    tried_s_ = now;
    std::string why;
    close();
    if (!reach(why)) return;
  }
  // the guard computed the force for the last sample
  Wanted want;
  want.force = toolkit::vec(command.force);
  want.p = last_.X_DS.p;
  want.v = last_.v;
  want.stiffness = command.stiffness;
  want.damping = command.damping;
  want.deadline_s = command.deadline_s;
  servo_.wanted.write(want);

  if (!servo_.measured.read(last_)) return;
  const double way = ((last_.buttons & 1) != 0 ? 1.0 : 0.0) - ((last_.buttons & 2) != 0 ? 1.0 : 0.0);
  closure_ = std::clamp(closure_ + way * dt / params().close_time, 0.0, 1.0);
  sample.sequence += 1;
  sample.time_s = last_.time_s;
  sample.pose = Pose(last_.X_DS.p, (last_.X_DS.q * stylus_to_tool()).normalized()).abi();
  sample.twist = {toolkit::raw(last_.v), toolkit::raw(last_.w)};
  sample.buttons = last_.buttons;
  sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_TWIST | SWAGE_VALID_BUTTONS;
  if (!params().jaws) return;
  sample.closure = closure_;
  sample.valid |= SWAGE_VALID_CLOSURE;
}

}  // namespace swage::openhaptics

SWAGE_EXPORT(swage::openhaptics::Openhaptics)
