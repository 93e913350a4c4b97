// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/ghost_path.hpp"

#include <algorithm>
#include <cmath>

#include "console/view3d/vec.hpp"

namespace swage::console {
namespace {

// Weights, m of pose distance per m of path. A path that leads down and up again passes each place twice: of the two frames the one
// nearer along the path is chosen, and one ahead rather than one behind.
constexpr double kAhead = 0.25, kBehind = 0.5;

Vec between_places(const Vec& a, const Vec& b, double u) { return a + (b - a) * u; }

swage_pose between_poses(const swage_pose& a, const swage_pose& b, double u) {
  const Vec p = between_places(Vec(a.p), Vec(b.p), u);
  const double same = a.q.w * b.q.w + a.q.x * b.q.x + a.q.y * b.q.y + a.q.z * b.q.z;
  const double v = same < 0 ? -u : u, w = 1 - u;
  swage_quat q{w * a.q.w + v * b.q.w, w * a.q.x + v * b.q.x, w * a.q.y + v * b.q.y, w * a.q.z + v * b.q.z};
  const double n = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (n > 0) q = {q.w / n, q.x / n, q.y / n, q.z / n};
  return {{p.x, p.y, p.z}, q};
}

double mean_distance(std::span<const swage_vec3> a, std::span<const swage_vec3> b) {
  const size_t n = std::min(a.size(), b.size());
  double sum = 0;
  for (size_t i = 0; i < n; ++i) sum += std::hypot(a[i].x - b[i].x, a[i].y - b[i].y, a[i].z - b[i].z);
  return n > 0 ? sum / static_cast<double>(n) : 0;
}

}  // namespace

std::vector<swage_vec3> GhostPath::places_of(std::span<const swage_pose> X_WB) const {
  std::vector<swage_vec3> out;
  for (const BodyPlace& place : places_) {
    if (place.body >= X_WB.size()) return {};
    const Vec p = Vec(X_WB[place.body].p) + rotate(X_WB[place.body].q, Vec(place.p_B));
    out.push_back({p.x, p.y, p.z});
  }
  return out;
}

void GhostPath::add(double time_s, uint32_t phase, std::span<const swage_pose> X_WB) {
  GhostFrame frame{time_s, phase, {X_WB.begin(), X_WB.end()}, places_of(X_WB)};
  if (!frames_.empty()) frame.way_m = frames_.back().way_m + mean_distance(frames_.back().p_W, frame.p_W);
  frames_.push_back(std::move(frame));
}

double GhostPath::distance(size_t i, std::span<const swage_vec3> p_W) const { return mean_distance(frames_[i].p_W, p_W); }

// In a new phase all frames of the phase are searched; in the same phase only the contiguous ones around the present frame.
void GhostPace::look_for_progress(std::span<const swage_vec3> p_W, uint32_t phase) {
  const bool anywhere = !begun_ || !found_ || phase != phase_;
  phase_ = phase;
  size_t first = 0, last = path_.size();
  if (!anywhere) {
    first = progress_, last = progress_ + 1;
    while (first > 0 && path_[first - 1].phase == phase) --first;
    while (last < path_.size() && path_[last].phase == phase) ++last;
  }
  const double here = path_[progress_].way_m;
  double least = 1e30;
  found_ = false;
  for (size_t i = first; i < last; ++i) {
    if (path_[i].phase != phase) continue;
    const double on = path_[i].way_m - here;
    const double cost = path_.distance(i, p_W) + (on >= 0 ? kAhead * on : -kBehind * on);
    if (cost >= least) continue;
    least = cost;
    progress_ = i;
    found_ = true;
  }
}

void GhostPace::follow(std::span<const swage_pose> X_WB, uint32_t phase, double dt_s) {
  const std::vector<swage_vec3> p_W = path_.places_of(X_WB);
  if (path_.empty() || p_W.empty()) return;
  look_for_progress(p_W, phase);
  begun_ = true;
  if (!found_) return;  // the expert has no frame near this state yet, or never: the ghost waits
  size_t last = progress_;
  const double most = path_[progress_].way_m + kLead_m;
  while (last + 1 < path_.size() && path_[last + 1].phase == phase_ && path_[last + 1].way_m <= most) ++last;
  shown_s_ = std::clamp(shown_s_ + std::max(dt_s, 0.0), path_[progress_].time_s, path_[last].time_s);
}

std::pair<size_t, double> GhostPace::between() const {
  size_t low = 0, high = path_.size();
  while (low + 1 < high) {
    const size_t middle = low + (high - low) / 2;
    (path_[middle].time_s <= shown_s_ ? low : high) = middle;
  }
  if (low + 1 >= path_.size()) return {low, 0};
  const double from = path_[low].time_s, to = path_[low + 1].time_s;
  return {low, to > from ? std::clamp((shown_s_ - from) / (to - from), 0.0, 1.0) : 0};
}

double GhostPace::shown_way_m() const {
  if (path_.empty()) return 0;
  const auto [i, u] = between();
  return u > 0 ? path_[i].way_m + u * (path_[i + 1].way_m - path_[i].way_m) : path_[i].way_m;
}

void GhostPace::pose(std::vector<swage_pose>& X_WB) const {
  X_WB.clear();
  if (path_.empty() || !begun_) return;
  const auto [i, u] = between();
  X_WB = path_[i].X_WB;
  if (u <= 0) return;
  for (size_t b = 0; b < X_WB.size() && b < path_[i + 1].X_WB.size(); ++b) X_WB[b] = between_poses(X_WB[b], path_[i + 1].X_WB[b], u);
}

}  // namespace swage::console
