// SPDX-License-Identifier: Apache-2.0
//
// The part of OpenHaptics' haptic device library (libHD.so) that is used: functions and constants of its releases 3.0 and 3.4,
// loaded at run time. Facts of its binary interface, under our own names.
#pragma once

#include <cstdint>
#include <string>

namespace swage::openhaptics {

struct HdError {
  unsigned code;
  int internal;
  unsigned handle;
};
static_assert(sizeof(HdError) == 12, "returned by value");

inline constexpr unsigned kBadHandle = 0xFFFFFFFF;
inline constexpr unsigned kButtons = 0x2000, kInkwell = 0x2002, kVelocity = 0x2051, kTransform = 0x2052, kAngularVelocity = 0x2053;
inline constexpr unsigned kModel = 0x2501, kSerial = 0x2504, kCalibrationStyle = 0x2555, kNominalMaxForce = 0x2603, kForce = 0x2700;
inline constexpr unsigned kForceOutput = 0x4000, kMaxForceClamping = 0x4001, kForceRamping = 0x4002, kSoftwareForceLimit = 0x4003;
inline constexpr unsigned kAlreadyInitiated = 0x301;
inline constexpr unsigned kWarmMotors = 0x200, kForceError = 0x204;  // errors in this range: forces must stop, the arm is still connected
inline constexpr unsigned kCalibrated = 0x5000, kNeedsUpdate = 0x5001, kNeedsManualInput = 0x5002;
inline constexpr unsigned kInkwellStyle = 4;
inline constexpr unsigned kDone = 0, kContinue = 1;
inline constexpr unsigned short kHighest = 65535;

using HdCallback = unsigned (*)(void*);

struct Hd {
  unsigned (*InitDevice)(const char*);
  void (*DisableDevice)(unsigned);
  void (*MakeCurrentDevice)(unsigned);
  unsigned (*GetCurrentDevice)();
  void (*BeginFrame)(unsigned);
  void (*EndFrame)(unsigned);
  void (*Enable)(unsigned);
  void (*GetDoublev)(unsigned, double*);
  void (*SetDoublev)(unsigned, const double*);
  void (*GetIntegerv)(unsigned, int*);
  const char* (*GetString)(unsigned);
  HdError (*GetError)();
  const char* (*GetErrorString)(unsigned);
  unsigned (*CheckCalibration)();
  void (*UpdateCalibration)(unsigned);
  void (*StartScheduler)();
  void (*StopScheduler)();
  unsigned long (*ScheduleAsynchronous)(HdCallback, void*, unsigned short);
  void (*Unschedule)(unsigned long);
};

/// The library, loaded once per process and never unloaded: its driver fails when it is loaded again. `wanted`: a file,
/// or empty for the usual names. nullptr and `why`, a sentence with the remedy. [main]
const Hd* load_hd(const std::string& wanted, std::string& why);

/// True for errors after which forces must stop but the arm is connected; any other error means that the arm is lost.
inline bool recoverable(unsigned code) { return code >= kWarmMotors && code <= kForceError; }

}  // namespace swage::openhaptics
