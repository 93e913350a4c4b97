// SPDX-License-Identifier: Apache-2.0
#include "servo.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

namespace swage::openhaptics {
namespace {

constexpr double kMm = 1e-3;       // m
constexpr double kSlew = 300;      // N/s, as in the host's guard
constexpr double kMostTick = 5e-3; // s; after a longer gap the force changes by no more than in one of this length
constexpr int kQuietTicks = 10;    // ticks without force before the callback ends
constexpr int kMostErrors = 16;    // read per tick: the error stack of a broken driver may be endless

}  // namespace

double now_s() noexcept {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void Servo::start(const Hd* hd, unsigned device, double most) {
  hd_ = hd;
  device_ = device;
  most_ = most;
  ticks_ = 0;
  quiet_ = 0;
  last_s_ = now_s();
  applied_ = Vec3::Zero();
  wanted.write({});
  leaving_ = gone_ = false;
  lost_ = forceless_ = 0;
}

Measured Servo::read() noexcept {
  double X[16] = {}, v[3] = {}, w[3] = {};
  int buttons = 0, inkwell = 0;
  hd_->GetDoublev(kTransform, X);
  hd_->GetDoublev(kVelocity, v);
  hd_->GetDoublev(kAngularVelocity, w);
  hd_->GetIntegerv(kButtons, &buttons);
  hd_->GetIntegerv(kInkwell, &inkwell);
  // an arm that was just switched on is calibrated when its pen is in the inkwell
  if (inkwell != 0 && ticks_ % 1000 == 0 && hd_->CheckCalibration() == kNeedsUpdate) hd_->UpdateCalibration(kInkwellStyle);
  Measured out;
  out.ticks = ++ticks_;
  out.time_s = now_s();
  // 16 numbers column by column; the columns of its rotation are not exactly orthogonal
  toolkit::Mat3 R;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) R(r, c) = X[4 * c + r];
  Vec3 x = R.col(0), z = R.col(2);
  z.normalize();
  const Vec3 y = z.cross(x).normalized();
  R << y.cross(z), y, z;
  out.X_DS = Pose(kMm * Vec3(X[12], X[13], X[14]), toolkit::Quat(R).normalized());
  out.v = kMm * Vec3(v[0], v[1], v[2]);
  out.w = Vec3(w[0], w[1], w[2]);
  out.buttons = static_cast<uint32_t>(buttons);
  return out;
}

// Extrapolates the guard's force from the hand's place at that sample to its present one.
Vec3 Servo::force(const Measured& now, double dt) noexcept {
  wanted.read(want_);
  Vec3 f = Vec3::Zero();
  const bool gives = !leaving_.load(std::memory_order_relaxed) && forceless() == 0 && lost() == 0;
  if (gives && now.time_s < want_.deadline_s)
    f = want_.force + want_.stiffness * (want_.p - now.X_DS.p) + want_.damping * (want_.v - now.v);
  if (!f.allFinite()) f.setZero();
  if (const double size = f.norm(); size > most_) f *= most_ / size;
  const Vec3 change = f - applied_;
  if (const double size = change.norm(); size > kSlew * dt) f = applied_ + change * (kSlew * dt / size);
  applied_ = f;
  return f;
}

void Servo::hear_errors() noexcept {
  for (int i = 0; i < kMostErrors; ++i) {
    const HdError e = hd_->GetError();
    if (e.code == 0) return;
    (recoverable(e.code) ? forceless_ : lost_).store(e.code, std::memory_order_relaxed);
  }
}

unsigned Servo::run() noexcept {
  const double now = now_s(), dt = std::clamp(now - last_s_, 0.0, kMostTick);
  last_s_ = now;
  hd_->MakeCurrentDevice(device_);
  hd_->BeginFrame(device_);
  Measured seen = read();
  const Vec3 f = seen.X_DS.p.allFinite() && seen.X_DS.q.coeffs().allFinite() ? force(seen, dt) : Vec3(Vec3::Zero());
  const double out[3] = {f.x(), f.y(), f.z()};
  hd_->SetDoublev(kForce, out);
  hd_->EndFrame(device_);
  hear_errors();
  seen.force = f.norm();
  if (lost() == 0) measured.write(seen);
  if (!leaving_.load(std::memory_order_relaxed)) return kContinue;
  quiet_ = f.isZero() ? quiet_ + 1 : 0;
  // a lost arm accepts no force any more
  if (quiet_ < kQuietTicks && lost() == 0) return kContinue;
  gone_.store(true, std::memory_order_release);
  return kDone;
}

}  // namespace swage::openhaptics
