// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/snapshot_source.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swage::console {
namespace {

constexpr double kLeastDelay_s = 0.002;  // two steps: hides the jitter of one step
constexpr double kMostDelay_s = 0.1;     // longest delay; a session with larger gaps is shown with pauses
constexpr double kForget = 0.02;  // share by which the delay shrinks at each arrival: 1 s to recover from a pause

double mix(double a, double b, double t) { return a + (b - a) * t; }

swage_pose mix(const swage_pose& a, const swage_pose& b, double t) {
  // the shorter of the two rotations; between two display frames linear interpolation of quaternions is as good as slerp
  const double d = a.q.w * b.q.w + a.q.x * b.q.x + a.q.y * b.q.y + a.q.z * b.q.z;
  const double s = d < 0 ? -1 : 1;
  swage_pose out{{mix(a.p.x, b.p.x, t), mix(a.p.y, b.p.y, t), mix(a.p.z, b.p.z, t)},
                 {mix(a.q.w, s * b.q.w, t), mix(a.q.x, s * b.q.x, t), mix(a.q.y, s * b.q.y, t),
                  mix(a.q.z, s * b.q.z, t)}};
  const double n = std::sqrt(out.q.w * out.q.w + out.q.x * out.q.x + out.q.y * out.q.y + out.q.z * out.q.z);
  if (n > 0) out.q = {out.q.w / n, out.q.x / n, out.q.y / n, out.q.z / n};
  return out;
}

}  // namespace

void interpolate(const snapshot::Snapshot& from, const snapshot::Snapshot& to, double a,
                 snapshot::Snapshot& out) {
  out = to;
  if (a >= 1 || from.n_body != to.n_body || from.n_particle != to.n_particle) return;
  for (uint32_t i = 0; i < to.n_body; ++i) out.X_WB[i] = mix(from.X_WB[i], to.X_WB[i], a);
  for (uint32_t i = 0; i < 3 * to.n_particle; ++i) {
    out.particle_p_W[i] = mix(from.particle_p_W[i], to.particle_p_W[i], a);
  }
  out.time_s = mix(from.time_s, to.time_s, a);
}

SnapshotSource::SnapshotSource()
    : from_(std::make_unique<snapshot::Snapshot>()),
      to_(std::make_unique<snapshot::Snapshot>()),
      shown_(std::make_unique<snapshot::Snapshot>()) {}

void SnapshotSource::clear() {
  have_ = 0;
  delay_s_ = 0;
}

void SnapshotSource::push(const snapshot::Snapshot& newest, double wall_s) {
  const double last_poll = std::exchange(last_poll_s_, wall_s);
  if (have_ > 0 && newest.step == to_->step) return;
  // time without a new snapshot: the delay that keeps the picture smooth
  const double gap = have_ > 0 ? std::max(0.0, last_poll - to_wall_s_) : 0;
  delay_s_ = std::clamp(std::max(gap, delay_s_ * (1 - kForget)), kLeastDelay_s, kMostDelay_s);
  std::swap(from_, to_);
  *to_ = newest;
  to_wall_s_ = wall_s;
  have_ = std::min(have_ + 1, 2);
}

const snapshot::Snapshot* SnapshotSource::sample(double wall_s) {
  if (have_ == 0) return nullptr;
  if (have_ == 1 || to_->step < from_->step) return to_.get();
  const double span = to_->time_s - from_->time_s;
  const double target = to_->time_s - delay_s_ + (wall_s - to_wall_s_);
  const double a = span > 0 ? std::clamp((target - from_->time_s) / span, 0.0, 1.0) : 1;
  interpolate(*from_, *to_, a, *shown_);
  return shown_.get();
}

}  // namespace swage::console
