// SPDX-License-Identifier: Apache-2.0
//
// A libHD.so without an arm, that checks its caller: frames, order of the life cycle, finite forces below the limit, no force at the
// end. Its scheduler is a thread of 1 kHz. fake_* is for the test.
#include <time.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

#include "devices/openhaptics/hd.hpp"

namespace {

using Error = swage::openhaptics::HdError;  // the caller's own type: it is called through a pointer

constexpr unsigned kHandle = 7;

struct Fake {
  std::mutex lock;
  std::deque<Error> errors;
  std::string wrong;  // what the caller did that it must not do
  std::atomic<unsigned> calibration{0x5000};
  std::atomic<int> buttons{0}, inkwell{0}, initiated{0}, calibrated{0}, busy{0}, slow_ms{0};
  std::atomic<bool> plugged{std::getenv("SWAGE_FAKE_HD_ABSENT") == nullptr}, running{false};
  std::atomic<double> x_mm{0}, force_x{0}, force_y{0}, force_z{0}, most{0}, jump{0};
  std::atomic<unsigned long> ticks{0};
  bool open = false, in_frame = false, scheduled = false;
  unsigned enabled = 0;
  double last[3] = {};
  unsigned (*callback)(void*) = nullptr;
  void* user = nullptr;
  std::thread thread;
};
Fake& fake() {
  static Fake f;
  return f;
}

void raise(unsigned code) {
  const std::lock_guard<std::mutex> guard(fake().lock);
  fake().errors.push_front({code, 0, kHandle});
}
void blame(const std::string& what) {
  const std::lock_guard<std::mutex> guard(fake().lock);
  if (fake().wrong.find(what) == std::string::npos) fake().wrong += what + "; ";
}

void run() {
  timespec period{0, 1'000'000};
  while (fake().running) {
    nanosleep(&period, nullptr);
    if (!fake().callback) continue;
    if (!fake().plugged) raise(0x302);
    ++fake().ticks;
    if (fake().callback(fake().user) == 0) fake().callback = nullptr;
    if (fake().in_frame) blame("a frame is left open");
  }
}

}  // namespace

extern "C" {

unsigned hdInitDevice(const char*) {
  Fake& f = fake();
  if (!f.plugged) {
    raise(0x300);
    return 0xFFFFFFFF;
  }
  if (f.busy > 0) {
    --f.busy;
    raise(0x301);
    return 0xFFFFFFFF;
  }
  if (f.open) blame("initialised twice");
  f.open = true;
  ++f.initiated;
  return kHandle;
}
void hdDisableDevice(unsigned) {
  Fake& f = fake();
  if (f.running) blame("disabled while the scheduler runs");
  if (f.open && f.plugged && (f.last[0] != 0 || f.last[1] != 0 || f.last[2] != 0)) blame("disabled under force");
  f.open = false;
}
void hdMakeCurrentDevice(unsigned h) {
  if (h != kHandle) raise(0x104);
}
unsigned hdGetCurrentDevice() { return kHandle; }
void hdBeginFrame(unsigned) {
  if (fake().in_frame) blame("begun twice"), raise(0x400);
  fake().in_frame = true;
}
void hdEndFrame(unsigned) {
  if (!fake().in_frame) blame("ended without a beginning"), raise(0x401);
  fake().in_frame = false;
}
void hdEnable(unsigned what) {
  if (what < 0x4000 || what > 0x4004) return raise(0x100);
  fake().enabled |= 1u << (what - 0x4000);
}
void hdGetDoublev(unsigned name, double* out) {
  Fake& f = fake();
  if (name == 0x2603) {
    out[0] = 3.3;
    return;
  }
  if (!f.in_frame) blame("read outside of a frame"), raise(0x402);
  if (name == 0x2052) {
    // a pen that points straight down: its z up; not quite a rotation, as of a real encoder
    const double X[16] = {1.0001, 0, 0, 0, 0, 0, -1, 0, 0.0001, 1, 0, 0, f.x_mm, 20, 30, 1};
    std::memcpy(out, X, sizeof X);
  } else if (name == 0x2051 || name == 0x2053) {
    out[0] = name == 0x2051 ? 5 : 0, out[1] = out[2] = 0;
  } else {
    raise(0x100);
  }
}
void hdSetDoublev(unsigned name, const double* v) {
  Fake& f = fake();
  if (!f.in_frame) blame("force set outside of a frame"), raise(0x402);
  if (name != 0x2700) return raise(0x100);
  const double size = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (!std::isfinite(size)) blame("a force that is no number");
  if (size > 3.3 + 1e-9) blame("a force above the limit"), raise(0x201);
  if ((f.enabled & 1) == 0 && size > 0) blame("a force that is not enabled");
  const double change = std::sqrt(std::pow(v[0] - f.last[0], 2) + std::pow(v[1] - f.last[1], 2) + std::pow(v[2] - f.last[2], 2));
  if (change > f.jump) f.jump = change;
  if (size > f.most) f.most = size;
  std::memcpy(f.last, v, sizeof f.last);
  f.force_x = v[0], f.force_y = v[1], f.force_z = v[2];
}
void hdGetIntegerv(unsigned name, int* out) {
  *out = 0;
  if (name == 0x2000)
    *out = fake().buttons;
  else if (name == 0x2002)
    *out = fake().inkwell;
  else
    raise(0x100);
}
const char* hdGetString(unsigned name) { return name == 0x2501 ? "Fake arm" : name == 0x2504 ? "F-1" : ""; }
Error hdGetError() {
  const std::lock_guard<std::mutex> guard(fake().lock);
  if (fake().errors.empty()) return {0, 0, 0};
  const Error e = fake().errors.front();
  fake().errors.pop_front();
  return e;
}
const char* hdGetErrorString(unsigned code) { return code == 0x300 ? "device fault" : code == 0x301 ? "already initiated" : "some error"; }
unsigned hdCheckCalibration() { return fake().calibration; }
void hdUpdateCalibration(unsigned style) {
  if (style == 4) fake().calibration = 0x5000;
  ++fake().calibrated;
}
void hdStartScheduler() {
  Fake& f = fake();
  if (!f.open) blame("scheduled before the device");
  if (!f.callback) blame("started before the callback");
  if (f.running.exchange(true)) return;
  f.thread = std::thread(run);
}
void hdStopScheduler() {
  if (fake().running.exchange(false)) fake().thread.join();
}
unsigned long hdScheduleAsynchronous(unsigned (*callback)(void*), void* user, unsigned short) {
  if (!fake().open) blame("a callback before the device");
  fake().callback = callback;
  fake().user = user;
  return 1;
}
void hdUnschedule(unsigned long) { fake().callback = nullptr; }

void fake_reset() {
  Fake& f = fake();
  f.errors.clear();
  f.wrong.clear();
  f.calibration = 0x5000;
  f.buttons = f.inkwell = f.initiated = f.calibrated = f.busy = 0;
  f.plugged = true;
  f.x_mm = f.force_x = f.force_y = f.force_z = f.most = f.jump = 0;
  f.ticks = 0;
  f.open = f.in_frame = false;
  f.enabled = 0;
  std::memset(f.last, 0, sizeof f.last);
}
void fake_move(double x_mm) { fake().x_mm = x_mm; }
void fake_plug(int there) { fake().plugged = there != 0; }
void fake_press(int buttons) { fake().buttons = buttons; }
void fake_raise(unsigned code) { raise(code); }
void fake_busy(int times) { fake().busy = times; }
void fake_calibration(unsigned state, int inkwell) { fake().calibration = state, fake().inkwell = inkwell; }
int fake_calibrated() { return fake().calibrated; }
double fake_force() { return fake().force_x; }
double fake_force_of(int axis) { return axis == 0 ? fake().force_x : axis == 1 ? fake().force_y : fake().force_z; }
double fake_most() { return fake().most; }
double fake_jump() { return fake().jump; }
unsigned long fake_ticks() { return fake().ticks; }
const char* fake_wrong() { return fake().wrong.c_str(); }
}
