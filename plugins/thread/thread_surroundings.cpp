// SPDX-License-Identifier: Apache-2.0
//
// What surrounds the thread: the fluid that drags on it and bears it up, and its own charge.
#include <algorithm>

#include "thread.hpp"
#include "toolkit/line_charge.hpp"

namespace swage::thread {

using toolkit::RodState;
using toolkit::Vec3;

toolkit::RodFluid Thread::fluid() const {
  if (params_.around == Around::kWater) return {998, 1.0e-3, 998};
  const swage_environment& e = params_.around == Around::kAir ? kStillAir : environment_;
  // air that goes along is a thousandth of the thread: left out where the lesson names no medium
  return {e.density, e.viscosity, e.medium == SWAGE_MEDIUM_UNSET ? 0.0 : e.density};
}

toolkit::RodLoad Thread::load(const Step& step) const {
  toolkit::RodLoad out;
  out.h = step.dt();
  out.gravity = toolkit::vec(step.gravity());
  out.fluid = fluid();
  if (charged()) out.force = charge_force_, out.spring = charge_spring_;
  return out;
}

void Thread::set_up_surroundings() {
  environment_ = environment(host());
  charge_force_.assign(charged() ? at(3 * nodes()) : 0, 0.0);
  charge_spring_.assign(charged() ? at(6 * nodes()) : 0, 0.0);
}

/// Half a force on an edge to each of its nodes; `stiff` [N/m]: how fast it falls when the edge goes along n.
void Thread::push_edge(int edge, const Vec3& f, double stiff, const Vec3& n) {
  for (const int i : {edge, edge + 1}) {
    double* K = charge_spring_.data() + 6 * i;
    for (int col = 0, k = 0; col < 3; ++col)
      for (int r = col; r < 3; ++r, ++k) K[k] += 0.5 * stiff * n[r] * n[col];
    for (int r = 0; r < 3; ++r) charge_force_[at(3 * i + r)] += 0.5 * f[r];
  }
}

/// Edges of one charge push each other, but for neighbours, whose push is along the thread and a hundred-thousandth of what stretches it
/// by 1 %. The mean of what each does to the middle of the other acts on both, so that none moves the whole. The force of a step is
/// that of its beginning; a spring across, of the slope of the force, keeps the edge from going farther in a step than it was away.
/// Edges of pieces that were parted have their charge as before. The earthed plane is the top of something: below it, beside that, an edge
/// feels and is nothing to it, as the image of what hangs past the plane would lie in the thread itself.
void Thread::feel_charge(const Step& step) {
  if (!charged()) return;
  std::fill(charge_force_.begin(), charge_force_.end(), 0.0), std::fill(charge_spring_.begin(), charge_spring_.end(), 0.0);
  const RodState s = state(step);
  const double q = environment_.charge, least = suture_.diameter;
  const auto middle = [&](int j) { return Vec3(0.5 * (s.node(j) + s.node(j + 1))); };
  const auto on = [&](int i, int j) {
    return Vec3(q * rod_.rest_length(i) * toolkit::charged_piece_field(s.node(j), s.node(j + 1), q, middle(i), least));
  };
  for (int i = 0; i < params_.segments; ++i)
    for (int j = i + 2; j < params_.segments; ++j) {
      const Vec3 f = 0.5 * (on(i, j) - on(j, i));
      const double size = f.norm();
      if (!(size > 0)) continue;
      const Vec3 n = f / size;
      // how far they are from each other in the direction of the push
      const double away = std::max(std::abs((middle(i) - middle(j)).dot(n)), least);
      push_edge(i, f, size / away, n), push_edge(j, -f, size / away, n);
    }
  if (environment_.grounded == 0) return;
  const auto image = [&](Vec3 p) { return p.z() = 2 * environment_.ground_z - p.z(), p; };
  const auto above = [&](int j) { return middle(j).z() > environment_.ground_z; };
  for (int i = 0; i < params_.segments; ++i)
    for (int j = 0; above(i) && j < params_.segments; ++j)
      if (above(j)) push_edge(i, q * rod_.rest_length(i) * toolkit::charged_piece_field(image(s.node(j)), image(s.node(j + 1)), -q, middle(i), least), 0, Vec3::UnitZ());
}

}  // namespace swage::thread
