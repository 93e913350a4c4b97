// SPDX-License-Identifier: Apache-2.0
#include "thread.hpp"

#include <swage/abi/spheres.h>
#include <swage/plugin.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "path.hpp"
#include "toolkit/read_file.hpp"
#include "toolkit/rod_passage.hpp"

namespace swage::thread {

using toolkit::Pose;
using toolkit::raw;
using toolkit::RodState;
using toolkit::vec;
using toolkit::Vec3;

namespace {
// How much finer the level `reference` is, and its most pieces: those that have room for their contacts.
constexpr int kFiner = 4, kFinest = 200;
}  // namespace

/// Each path that is written down.
bool Thread::lay_written(const ThreadParams& p, ObjectBuilder& builder) {
  std::vector<std::string> paths = {p.path};
  if (!p.paths.empty()) {
    std::string text, why;
    if (!toolkit::read_file(p.paths, toolkit::kMostFileBytes, text, why)) return builder.error("paths", why), false;
    paths = path_lines(text);
    if (paths.empty()) return builder.error("paths", "there is no path in it"), false;
  }
  for (const std::string& path : paths) {
    std::vector<Vec3> nodes_O;
    const std::string wrong =
        p.start == Start::kNodes ? nodes_at(path, given_nodes_, nodes(), nodes_O) : nodes_along(path, lengths_, nodes_O);
    if (!wrong.empty()) return builder.error(p.paths.empty() ? "path" : "paths", wrong), false;
    starts_.push_back(std::move(nodes_O));
  }
  if (p.shape > static_cast<int>(starts_.size())) return builder.error("shape", "there are not so many paths"), false;
  if (p.shape > 0) starts_ = {starts_[at(p.shape - 1)]};
  return true;
}

/// Nodes of the start shape in O, an edge apart. The coil rises by two diameters a turn, so that it does not touch itself.
bool Thread::lay_start(const ThreadParams& p, ObjectBuilder& builder) {
  starts_.clear();
  if (written()) return lay_written(p, builder);
  std::vector<Vec3>& start = starts_.emplace_back();
  for (const double s : s_) {
    if (p.start == Start::kStraight)
      start.emplace_back(s, 0, 0);
    else if (p.start == Start::kHanging)
      start.emplace_back(0, 0, -s);
  }
  const double l = p.length / p.segments, r = p.coil_radius, turn = 2 * std::asin(std::min(1.0, 0.5 * l / r));
  const double rise = 2 * suture_.diameter * turn / (2 * std::numbers::pi),
               flat = std::sqrt(1 - std::pow(rise / l, 2));
  for (int i = 0; i < nodes() && p.start == Start::kCoil; ++i)
    start.emplace_back(flat * r * std::cos(turn * i), flat * r * std::sin(turn * i), rise * i);
  return true;
}

double Thread::shortest() const {
  return *std::min_element(lengths_.begin(), lengths_.end());
}

/// Arc lengths of the nodes, and what shorter segments cannot be.
bool Thread::lay_nodes(ObjectBuilder& builder) {
  const ThreadParams& p = params_;
  if (p.finer > 1) {
    if (!(p.fine_from < p.fine_to) || p.fine_to > p.length)
      builder.error("fine_to", "the part with shorter segments ends behind its beginning, on the thread");
    if (p.start == Start::kCoil || p.start == Start::kNodes)
      builder.error("finer", "a coil, and a thread that is given node by node, have segments of one length");
    if (masses()) builder.error("finer", "point masses and springs have segments of one length: take another level");
  }
  if (builder.failed()) return false;
  s_ = node_places(p.length, p.segments, {p.fine_from, p.fine_to, p.finer});
  lengths_.assign(at(p.segments), p.length / p.segments);
  for (int j = 0; j < p.segments && p.finer > 1; ++j) lengths_[at(j)] = s_[at(j + 1)] - s_[at(j)];
  return true;
}

/// The body goes with the edge in the middle: its first node, x along it, y its director.
Pose Thread::middle(const RodState& s) const {
  const int j = params_.segments / 2;
  const Vec3 t = s.edge(j).normalized(), d = s.material(j);
  toolkit::Mat3 R;
  R << t, d, t.cross(d);
  toolkit::Quat q(R);
  q.normalize();
  return {s.node(j), q};
}

/// Directors without twist, on which the memory bends: a straight thread to its left in its plane, one that hangs towards x, a coil
/// as it lies, one along a path across its first piece. A coil is fixed along its circle, of which an edge is a chord.
void Thread::start_frames(RodState& s, const std::vector<Vec3>& start_O, const toolkit::Quat& q_WO) {
  Vec3 d_O = params_.start == Start::kHanging ? Vec3(0, -1, 0) : Vec3(0, 0, 1);
  if (written()) d_O = (start_O[1] - start_O[0]).unitOrthogonal();
  const Vec3 d = q_WO * d_O;
  const bool coil = params_.start == Start::kCoil;
  const double chord = coil ? std::asin(std::min(1.0, 0.5 * rod_.rest_length(0) / params_.coil_radius)) : 0;
  const auto clamp = [&](const Vec3& t, double turn) {
    return toolkit::RodClamp{true, std::cos(turn) * t + std::sin(turn) * d.cross(t), (d - d.dot(t) * t).normalized()};
  };
  const int last = params_.segments - 1;
  rod_.clamp(0) = clamp(s.edge(0).normalized(), 0);
  rod_.clamp(1).on = false;
  rod_.start(s);
  rod_.clamp(0) = clamp(s.edge(0).normalized(), -chord);
  rod_.clamp(0).on = params_.first == End::kFixed;
  const Vec3 t = s.edge(last).normalized();
  rod_.clamp(1) = {params_.last == End::kFixed, std::cos(chord) * t + std::sin(chord) * s.material(last).cross(t), s.material(last)};
}

bool Thread::take_suture(const ThreadParams& p, ObjectBuilder& builder) {
  suture_ = {};
  if (!p.suture.empty()) {
    const std::string wrong = read_suture(p.suture, suture_);
    if (!wrong.empty()) builder.error("suture", wrong);
  }
  if (p.diameter > 0) suture_.diameter = p.diameter;
  if (p.young > 0) suture_.young = p.young;
  if (p.poisson >= 0) suture_.poisson = p.poisson;
  if (p.density > 0) suture_.density = p.density;
  if (p.memory >= 0) suture_.memory = p.memory;
  if (p.strength > 0) suture_.strength = p.strength;
  if (p.pull_off > 0) suture_.pull_off = p.pull_off;
  if (p.yield >= 0) suture_.yield = p.yield;
  if (p.hardening >= 0) suture_.hardening = p.hardening;
  if (const std::string wrong = fault(suture_); !wrong.empty()) builder.error("suture", wrong);
  const double l = p.length / p.segments;
  if (shortest() < suture_.diameter)
    builder.error("segments", "a segment is at least as long as the thread is thick: take fewer segments");
  if (p.start == Start::kCoil && p.coil_radius < l)
    builder.error(
        "coil_radius",
        "the coil's radius is at least the length of a segment: take more segments or a wider coil");
  return !builder.failed();
}

void Thread::build(const ThreadParams& params, ObjectBuilder& builder) {
  params_ = params;
  given_nodes_ = params.segments + 1;
  if (params.level == Level::kReference) params_.segments = std::min(kFiner * params.segments, kFinest);
  set_up_surroundings();
  if (!lay_nodes(builder) || !take_suture(params_, builder)) return;
  toolkit::RodSection section = toolkit::RodSection::round(suture_.diameter, suture_.young, suture_.poisson, suture_.density);
  const bool rod = params.level == Level::kRod || params.level == Level::kReference;
  if (!rod) section.bending = section.twisting = 0;
  rod_ = toolkit::Rod(section, lengths_, rod ? suture_.memory : 0);
  yield_ = rod ? toolkit::RodYield::round(suture_.diameter, suture_.yield, suture_.hardening) : toolkit::RodYield{};
  if (params.first == End::kFixed) rod_.hold(0);
  if (params.last == End::kFixed) rod_.hold(params_.segments);
  if (!lay_start(params_, builder)) return;
  declare(builder);
  begun_.resize(RodState::size(nodes())), base_.resize(RodState::size(nodes()));
  sides_.resize(at(kSides * rod_.unknowns())), drag_.resize(at(nodes()));
  pressed_.resize(at(params_.segments));
  boxes_.resize(toolkit::room_for_passages(nodes()));
}

void Thread::declare(ObjectBuilder& builder) {
  std::vector<double> numbers(RodState::size(nodes()), 0.0), p_B;
  RodState s(nodes(), numbers.data());
  for (int i = 0; i < nodes(); ++i) Eigen::Map<Vec3>(s.x + 3 * i) = starts_.front()[at(i)];
  start_frames(s, starts_.front(), toolkit::Quat::Identity());
  X_OB0_ = middle(s);
  body_ = builder.flexible_body("thread", X_OB0_.abi());
  for (int i = 0; i < nodes(); ++i) {
    const Vec3 p = X_OB0_.inverse() * starts_.front()[at(i)];
    p_B.insert(p_B.end(), {p.x(), p.y(), p.z()});
  }
  const std::vector<double> radius(at(params_.segments), 0.5 * suture_.diameter);
  builder.state(ChainState::doubles(vertices()));  // the first
  // tighter than a piece is long no chain of straight pieces bends
  // half a circle of it, within which the thread is not looked for, is two segments: of three that close a loop the outer ones meet
  const double bend_radius = std::max(2 * suture_.diameter, 2 / std::numbers::pi * shortest());
  builder.chain(host_extension<swage_host_chain>(SWAGE_HOST_CHAIN), body_,
                {masses() ? uint32_t{SWAGE_CHAIN_SPHERES} : uint32_t{SWAGE_CHAIN_SEGMENTS}, vertices(), p_B.data(), nullptr, radius.data(), bend_radius, 0, 0});
  builder.state(static_cast<uint32_t>(RodState::frames(nodes())) + (stays_bent() ? 2 * vertices() : 0) + (several() ? 5 : 4));
  point_.resize(builder.reserve_points(host_extension<swage_host_capacities>(SWAGE_HOST_CAPACITIES), vertices() + kPoints));
  tension_first_ = builder.signal("thread.tension_first", "N", "Tension at the first end.");
  tension_last_ = builder.signal("thread.tension_last", "N", "Tension at the last end.");
  tension_grip_ = builder.signal("thread.tension_grip", "N",
                                 "Greatest tension beside the place where it is pressed hardest; 0 where nothing touches.");
  tension_ = builder.signal("thread.tension", "N", "Greatest tension.");
  bend_radius_ =
      builder.signal("thread.bend_radius", "m", "Least radius of bending; 1 m where it is straighter.");
  parted_ = builder.signal("thread.parted", "1", "Places at which it has parted.");
  passed_ = builder.signal("thread.passed", "1", "Times that it went fast and came out on the other side of itself: what follows is not physics.");
  if (tells_shape()) shape_told_ = builder.signal("thread.shape", "1", "Which of the paths it started along, from 1 on.");
}

void Thread::reset(const Step& step) {
  const ChainState chain = step.chain(0, vertices());
  const Pose X_WO = Pose(step.pose(body_)) * X_OB0_.inverse();
  const int last = params_.segments - 1;
  if (several()) shape(step) = 1 + std::floor(random() * static_cast<double>(starts_.size()));
  const std::vector<Vec3>& start_O = several() ? starts_[static_cast<size_t>(shape(step)) - 1] : starts_.front();
  RodState s = state(step);
  for (int i = 0; i < nodes(); ++i) {
    Eigen::Map<Vec3>(s.x + 3 * i) = X_WO * start_O[at(i)];
    chain.s[at(i)] = s_[at(i)];
    chain.radius[at(i)] = i <= last ? 0.5 * suture_.diameter : 0;
  }
  passed(step) = 0, held(step) = 0, grip(step)[0] = 0, grip(step)[1] = -1;
  take_parted(step);
  if (stays_bent()) rod_.start_set(set(step));
  start_frames(s, start_O, X_WO.q);
}

void Thread::finish(const Step& step) {
  const RodState s = state(step);
  const ChainState chain = step.chain(0, vertices());
  const int last = params_.segments - 1;
  const double* grip = this->grip(step);
  double most = 0, parted = 0, beside = 0;
  for (int j = 0; j <= last; ++j) {
    most = std::max(most, rod_.linear_tension(j));
    parted += chain.radius[at(j)] == 0;
    // segments between the jaws keep the tension that they had when the jaws closed: a hand feels those outside
    if (grip[0] <= grip[1] && (j == grip[0] - 1 || j == grip[1] + 1)) beside = std::max(beside, rod_.linear_tension(j));
  }
  step.signal(tension_first_, rod_.linear_tension(0));
  step.signal(tension_last_, rod_.linear_tension(last));
  step.signal(tension_grip_, beside);
  step.signal(tension_, most);
  step.signal(bend_radius_, 1 / std::max(1.0, rod_.most_curvature(s)));
  step.signal(parted_, parted);
  count_passages(step);
  step.signal(passed_, passed(step));
  if (tells_shape()) step.signal(shape_told_, several() ? shape(step) : std::max(1, params_.shape));
}

void Thread::count_passages(const Step& step) {
  const RodState s = state(step), begun(nodes(), begun_.data());
  if (!toolkit::may_have_passed(nodes(), begun.x, s.x, rod_.section().radius)) return;
  const ChainState chain = step.chain(0, vertices());
  passed(step) += toolkit::passages(nodes(), begun.x, s.x, [&](int j) { return chain.radius[at(j)] > 0; }, boxes_);
}

}  // namespace swage::thread

SWAGE_EXPORT(swage::thread::Thread)
