// SPDX-License-Identifier: Apache-2.0
#include "thread.hpp"

#include <swage/plugin.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace swage::thread {

using toolkit::Pose;
using toolkit::raw;
using toolkit::RodState;
using toolkit::vec;
using toolkit::Vec3;

/// Nodes of the start shape in O, an edge apart. The coil rises by two diameters a turn, so that it does not touch itself.
Vec3 Thread::start_node(int i) const {
  const double l = params_.length / params_.segments;
  if (params_.start == Start::kStraight) return {l * i, 0, 0};
  if (params_.start == Start::kHanging) return {0, 0, -l * i};
  const double r = params_.coil_radius, turn = 2 * std::asin(std::min(1.0, 0.5 * l / r));
  const double rise = 2 * params_.diameter * turn / (2 * std::numbers::pi),
               flat = std::sqrt(1 - std::pow(rise / l, 2));
  return {flat * r * std::cos(turn * i), flat * r * std::sin(turn * i), rise * i};
}

/// Pose of a segment: x along it, y its director. Its length is that of the shape: one that has parted goes with the node before it.
Pose Thread::segment(const RodState& s, int j) const {
  const Vec3 t = s.edge(j).normalized(), d = s.material(j);
  toolkit::Mat3 R;
  R << t, d, t.cross(d);
  toolkit::Quat q(R);
  q.normalize();
  return {s.node(j) + 0.5 * rod_.rest_length(j) * t, q};
}

void Thread::build(const ThreadParams& params, ObjectBuilder& builder) {
  params_ = params;
  const double l = params.length / params.segments;
  if (params.start == Start::kCoil && params.coil_radius < l)
    builder.error(
        "coil_radius",
        "the coil's radius is at least the length of a segment: take more segments or a wider coil");
  if (builder.failed()) return;
  const std::vector<double> rest(at(params.segments), l);
  rod_ =
      toolkit::Rod(toolkit::RodSection::round(params.diameter, params.young, params.poisson, params.density),
                   rest, params.memory);
  if (params.first == End::kFixed) rod_.hold(0);
  if (params.last == End::kFixed) rod_.hold(params.segments);

  std::vector<double> numbers(RodState::size(nodes()), 0.0);
  RodState s(nodes(), numbers.data());
  for (int i = 0; i < nodes(); ++i) Eigen::Map<Vec3>(s.x + 3 * i) = start_node(i);
  rod_.start(s);
  const double half = 0.5 * l;
  for (int j = 0; j < params.segments; ++j) {
    const Pose X_OB = segment(s, j);
    const Body body = builder.own_body(("segment " + std::to_string(j + 1)).c_str(), X_OB.abi());
    if (j == 0) first_ = body, X_OB0_ = X_OB;
    builder.capsule(body, {-half, 0, 0}, {half, 0, 0}, 0.5 * params.diameter);
  }
  builder.state(static_cast<uint32_t>(RodState::size(nodes())) + static_cast<uint32_t>(params.segments) + 1);
  tension_first_ = builder.signal("thread.tension_first", "N", "Tension at the first end.");
  tension_last_ = builder.signal("thread.tension_last", "N", "Tension at the last end.");
  tension_ = builder.signal("thread.tension", "N", "Greatest tension.");
  bend_radius_ =
      builder.signal("thread.bend_radius", "m", "Least radius of bending; 1 m where it is straighter.");
  parted_ = builder.signal("thread.parted", "1", "Places at which it has parted.");

  begun_.resize(RodState::size(nodes())), base_.resize(RodState::size(nodes()));
  sides_.resize(at(kSides * rod_.unknowns()));
  force_.resize(at(3 * nodes())), torque_.resize(at(params.segments));
  point_.resize(kMaxPoints);
}

void Thread::reset(const Step& step) {
  std::fill(step.state().begin(), step.state().end(), 0.0);
  const Pose X_WO = Pose(step.pose(first_)) * X_OB0_.inverse();
  RodState s = state(step);
  for (int i = 0; i < nodes(); ++i) Eigen::Map<Vec3>(s.x + 3 * i) = X_WO * start_node(i);
  take_parted(step);
  rod_.clamp(0).on = rod_.clamp(1).on = false;
  rod_.start(s);
  const int last = params_.segments - 1;
  if (params_.first == End::kFixed) rod_.clamp(0) = {true, s.edge(0).normalized(), s.material(0)};
  if (params_.last == End::kFixed) rod_.clamp(1) = {true, s.edge(last).normalized(), s.material(last)};
}

void Thread::finish(const Step& step) {
  const RodState s = state(step);
  double most = 0, bend = 1, parted = 0;
  for (int j = 0; j < params_.segments; ++j) {
    most = std::max(most, rod_.linear_tension(j));
    parted += this->parted(step)[j];
  }
  for (int i = 1; i < params_.segments; ++i) bend = std::max(bend, rod_.curvature(s, i));
  step.signal(tension_first_, rod_.linear_tension(0));
  step.signal(tension_last_, rod_.linear_tension(params_.segments - 1));
  step.signal(tension_, most);
  step.signal(bend_radius_, 1 / bend);
  step.signal(parted_, parted);
}

void Thread::locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) {
  const RodState s = state(step);
  const Vec3 p = vec(p_W);
  double nearest = HUGE_VAL;
  for (int j = 0; j < params_.segments; ++j) {
    const Vec3 a = s.node(j), e = s.edge(j);
    const double share = std::clamp((p - a).dot(e) / e.squaredNorm(), 0.0, 1.0),
                 away = (p - a - share * e).squaredNorm();
    if (away >= nearest) continue;
    nearest = away;
    out.s = (j + share) / params_.segments;
    out.p_W = raw(Vec3(a + share * e));
    out.tangent_W = raw(Vec3(e.normalized()));
    out.normal_W = raw(s.material(j));
  }
  out.length = params_.length;
}

}  // namespace swage::thread

SWAGE_EXPORT(swage::thread::Thread)
