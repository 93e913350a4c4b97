// SPDX-License-Identifier: Apache-2.0
//
// The thread as the contact solve sees it. A step begins at x0; it is linear about x1, where the thread goes by itself, or, where it
// was held in the last step, where it would go on to (a held thread does, so that what contacts change is little). There
//
//   v_free = (x1 - x0 + d) / h,  d = -A^-1 F(x1),     W = J A^-1 J' / h^2
//
// with the band A = M/h^2 + K. A host that knows bands is given A and F and finds d itself. The impulses j are forces j / h of that linear step, and the thread goes exactly where it leads: a
// held place stays where the contacts have it. What an edge is stretched by turning, of second order, the next step takes back.
#include <algorithm>

#include "thread.hpp"

namespace swage::thread {

using toolkit::Pose;
using toolkit::raw;
using toolkit::RodState;
using toolkit::vec;
using toolkit::Vec3;

namespace {
// Newton iterations of a step without contacts; with them it is one.
constexpr int kFreeIterations = 6;
// What going on may stretch a held thread: 1e-3 is 1 mN of 10-0 nylon. More: what is snatched away swings up from step to step.
constexpr double kMostStrain = 1e-3;
// Of the last change of an iteration, over the length: 20 pm of 20 mm.
constexpr double kSettled = 1e-9;
}  // namespace

/// The rod has no memory of its own: what has parted, a piece of the chain without thickness, is the host's to keep and take back.
void Thread::take_parted(const Step& step) {
  const ChainState chain = step.chain(0, vertices());
  for (int j = 0; j < params_.segments; ++j) rod_.cut(j, chain.radius[at(j)] == 0);
}

/// The body goes along. Nodes and velocities have been written in place.
void Thread::write(const Step& step, const RodState& before, const RodState& now) const {
  const Pose X0 = middle(before), X = middle(now);
  step.pose(body_) = X.abi();
  const Vec3 w = toolkit::log_rotation(X.q * X0.q.conjugate()) / step.dt();
  step.twist(body_) = {raw(Vec3((X.p - X0.p) / step.dt())), raw(w)};
}

void Thread::advance(const Step& step) {
  RodState s = state(step);
  // of a step that is divided, the part before has ended here
  if (step.time() == advanced_at_) count_passages(step);
  advanced_at_ = step.time();
  const bool goes_on = held(step) != 0;
  held(step) = 0, grip(step)[0] = 0, grip(step)[1] = -1;
  take_parted(step);
  if (stays_bent()) rod_.flow(s, yield_, set(step)), rod_.remember(set(step));
  const RodState begun(nodes(), begun_.data()), base(nodes(), base_.data());
  begun.copy(s);
  feel_charge(step);
  const toolkit::RodLoad load = this->load(step);
  if (masses()) {
    advance_masses(step, begun, s);
  } else if (goes_on) {
    rod_.prepare(begun, load);
    rod_.go_on(s, load, kMostStrain);
    rod_.finish(s, load);
  } else {
    rod_.step(s, load, kFreeIterations, kSettled * params_.length);
    part(step);
  }
  base.copy(s);
  write(step, begun, s);
}

Thread::Point Thread::point(const swage_contact_point& c, const swage_chain_place& place) const {
  const RodState base(nodes(), const_cast<double*>(base_.data()));
  Point p;
  p.edge = std::min(static_cast<int>(place.segment), params_.segments - 1);
  p.s = place.share;
  const Vec3 e = base.edge(p.edge);
  p.t = e.normalized();
  p.arm = vec(c.p_W) - base.node(p.edge) - p.s * e;
  p.arm -= p.arm.dot(p.t) * p.t;
  return p;
}

Vec3 Thread::at_point(const Point& p, const double* unknowns, int line) const {
  const double* u = unknowns + 4 * p.edge * line;
  Vec3 out;
  for (int r = 0; r < 3; ++r) out[r] = (1 - p.s) * u[r * line] + p.s * u[(4 + r) * line];
  return out + u[3 * line] * p.t.cross(p.arm);
}

void Thread::push(const Point& p, const Vec3& f, double* unknowns, int line) const {
  double* u = unknowns + 4 * p.edge * line;
  for (int r = 0; r < 3; ++r) u[r * line] += (1 - p.s) * f[r], u[(4 + r) * line] += p.s * f[r];
  u[3 * line] += p.t.dot(p.arm.cross(f));
}

void Thread::mobility(const Step& step, std::span<const swage_contact_point> points,
                        std::span<const swage_chain_place> place, double* v_free, double* W) {
  if (masses()) return answer_masses(points, place, v_free, W);
  const int n = static_cast<int>(std::min(points.size(), point_.size()));
  const double h = step.dt();
  const RodState begun(nodes(), begun_.data()), base(nodes(), base_.data());
  const int rows = 3 * n, stride = 3 * static_cast<int>(points.size());
  std::fill_n(v_free, stride, 0.0), std::fill_n(W, stride * stride, 0.0);
  linear_ = rod_.linearise(base, load(step));
  for (int i = 0; i < n; ++i) {
    const Point& p = point_[at(i)] = point(points[at(i)], place[at(i)]);
    const Vec3 x0 = begun.node(p.edge) + p.s * begun.edge(p.edge),
               x1 = base.node(p.edge) + p.s * base.edge(p.edge);
    Vec3 d = x1 - x0;
    if (linear_) d += at_point(p, rod_.change(), 1);
    for (int r = 0; r < 3; ++r) v_free[3 * i + r] = d[r] / h;
  }
  for (int first = 0; linear_ && first < rows; first += kSides) {
    std::fill(sides_.begin(), sides_.end(), 0.0);
    const int last = std::min(first + kSides, rows);
    for (int c = first; c < last; ++c)
      push(point_[at(c / 3)], Vec3::Unit(c % 3), sides_.data() + (c - first), kSides);
    hold_sides();
    rod_.matrix().solve<kSides>(sides_.data());
    // rows from here on; the others by symmetry
    for (int c = first; c < last; ++c)
      for (int i = c / 3; i < n; ++i) {
        const Vec3 w = at_point(point_[at(i)], sides_.data() + (c - first), kSides) / (h * h);
        for (int r = 0; r < 3; ++r) W[(3 * i + r) * stride + c] = W[c * stride + 3 * i + r] = w[r];
      }
  }
}

/// Nodes that stay take no forces.
void Thread::hold_sides() {
  for (int i = 0; i < nodes(); i += params_.segments) {
    if ((i == 0 ? params_.first : params_.last) == End::kFree) continue;
    std::fill_n(sides_.begin() + 4 * i * kSides, 3 * kSides, 0.0);
  }
}

void Thread::apply_impulses(const Step& step, std::span<const swage_contact_point> points,
                   std::span<const swage_chain_place> place, const double* impulse) {
  RodState s = state(step);
  const RodState begun(nodes(), begun_.data()), base(nodes(), base_.data());
  const int n = static_cast<int>(std::min(points.size(), point_.size()));
  if ((!linear_ && !masses()) || n == 0) return;
  std::fill_n(sides_.begin(), rod_.unknowns(), 0.0);
  for (int i = 0; i < n; ++i)
    push(point(points[at(i)], place[at(i)]), Vec3(impulse[3 * i], impulse[3 * i + 1], impulse[3 * i + 2]) / step.dt(),
         sides_.data(), 1);
  press(step, place.first(at(n)), impulse);
  if (masses()) {
    for (int k = 0; k < rod_.unknowns(); ++k)
      sides_[at(k)] *= k % 4 == 3 || stays(k / 4) ? 0.0 : step.dt() * step.dt() / mass(k / 4);
    go_masses(step, sides_.data(), s);
  } else {
    rod_.respond(base, load(step), sides_.data(), s);
  }
  part(step);
  write(step, begun, s);
}

void Thread::linearise(const Step& step, uint32_t stiffer, double* stiffness, double* gradient) {
  if (masses()) return linearise_masses(step, stiffness);
  const RodState base(nodes(), base_.data());
  rod_.linearise(base, load(step), static_cast<int>(stiffer), stiffness, gradient);
}

void Thread::displace(const Step& step, const double* change, std::span<const swage_contact_point>,
                      std::span<const swage_chain_place> place, const double* impulse) {
  RodState s = state(step);
  const RodState begun(nodes(), begun_.data()), base(nodes(), base_.data());
  press(step, place, impulse);
  masses() ? go_masses(step, change, s) : rod_.go(base, change, s);
  part(step);
  write(step, begun, s);
}

/// What contacts press, and the hardest of them.
void Thread::press(const Step& step, std::span<const swage_chain_place> place, const double* impulse) {
  std::fill(pressed_.begin(), pressed_.end(), char{0});
  double most = 0;
  int hardest = -1;
  for (size_t i = 0; i < place.size(); ++i) {
    const int edge = std::min(static_cast<int>(place[i].segment), params_.segments - 1);
    const double hard = (Vec3(impulse[3 * i], impulse[3 * i + 1], impulse[3 * i + 2]) / step.dt()).squaredNorm();
    if (hard > 0) pressed_[at(edge)] = 1;
    if (hard > most) most = hard, hardest = edge;
  }
  held(step) = hardest >= 0;
  find_grip(step, hardest);
}

void Thread::find_grip(const Step& step, int hardest) const {
  if (hardest < 0) return;
  int first = hardest, last = hardest;
  while (first > 0 && pressed_[at(first - 1)] != 0) --first;
  while (last + 1 < params_.segments && pressed_[at(last + 1)] != 0) ++last;
  grip(step)[0] = first, grip(step)[1] = last;
}

/// Breaks where the tension is greatest, if that is beyond its strength: at one place in a step, which relieves the others.
void Thread::part(const Step& step) const {
  int most = 0;
  for (int j = 1; j < params_.segments; ++j)
    if (rod_.linear_tension(j) > rod_.linear_tension(most)) most = j;
  if (rod_.linear_tension(most) > suture_.strength) step.chain(0, vertices()).radius[at(most)] = 0;
}

}  // namespace swage::thread
