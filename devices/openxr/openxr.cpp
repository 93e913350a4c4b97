// SPDX-License-Identifier: Apache-2.0
#include "openxr.hpp"

#include <time.h>

#include "sentences.hpp"

namespace swage::openxr {
namespace {

constexpr double kRetry = 2;  // s between two attempts to reach a runtime that has ended

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// The aim pose points along its -z; the instrument points along x, and its closing direction z is to the left of the controller.
const Quat& aim_to_tool() {
  static const Quat q = [] {
    toolkit::Mat3 R;
    R.col(0) = -Vec3::UnitZ();
    R.col(1) = -Vec3::UnitY();
    R.col(2) = -Vec3::UnitX();
    return Quat(R);
  }();
  return q;
}

}  // namespace

void Openxr::open() {
  first_.reset();
  tried_s_ = now_s();
  std::string why;
  runtime_ = Runtime::share(why);
  if (runtime_ == nullptr) return refuse(why);
  note(say::kRuntime(runtime_->name().empty() ? say::kUnnamed() : runtime_->name()));
}

void Openxr::exchange(const swage_command&, swage_sample& sample) {
  if (runtime_ == nullptr) {
    if (now_s() - tried_s_ < kRetry) return;
    tried_s_ = now_s();
    std::string why;
    runtime_ = Runtime::share(why);
    if (runtime_ == nullptr) return;
  }
  Controller seen;
  if (!runtime_->read(params().side == Side::kLeft ? 0 : 1, seen)) {
    runtime_.reset();
    tried_s_ = now_s();
    return;
  }
  if (!seen.tracked) return;
  if (!first_) first_ = seen.X_DA.p;
  sample.sequence += 1;
  sample.time_s = seen.time_s;
  sample.pose = Pose(toolkit::vec(params().start) + seen.X_DA.p - *first_, (seen.X_DA.q * aim_to_tool()).normalized()).abi();
  sample.buttons = seen.buttons;
  sample.valid = SWAGE_VALID_POSE | SWAGE_VALID_BUTTONS;
  if (seen.moving) {
    sample.twist = {toolkit::raw(seen.v_D), toolkit::raw(seen.w_D)};
    sample.valid |= SWAGE_VALID_TWIST;
  }
  if (!params().jaws) return;
  sample.closure = seen.trigger;
  sample.valid |= SWAGE_VALID_CLOSURE;
}

}  // namespace swage::openxr

SWAGE_EXPORT(swage::openxr::Openxr)
