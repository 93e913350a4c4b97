// SPDX-License-Identifier: Apache-2.0
//
// Level `thesis`: point masses and springs. Contacts move the nodes beside them by their masses alone.
#include <algorithm>

#include "masses.hpp"
#include "thread.hpp"

namespace swage::thread {

using toolkit::RodState;
using toolkit::Vec3;

namespace {
// Parts of a step. 2370 are those of 48 pieces of 30 mm at 1 kHz, which take some milliseconds; more is of no use to anybody.
constexpr int kMostParts = 10000;
}  // namespace

double Thread::mass(int i) const { return rod_.node_mass(i); }

bool Thread::stays(int i) const {
  return (i == 0 && params_.first == End::kFixed) || (i == nodes() - 1 && params_.last == End::kFixed);
}

void Thread::activate(double dt_s) {
  if (params_.level == Level::kThesis && springs().parts(dt_s) > kMostParts)
    refuse("so stiff springs would need more than 10000 explicit steps in one: take fewer \"segments\" or a lower \"young\"");
}

Springs Thread::springs() const { return {rod_.section(), rod_.rest_length(0)}; }

/// Its whole free motion; afterwards the state is where nothing touched.
void Thread::advance_masses(const Step& step, const RodState& begun, RodState& s) {
  const Springs springs = this->springs();
  const int parts = springs.parts(step.dt()), n = nodes();
  const toolkit::RodFluid around = fluid();
  const double borne = 1 - around.density * std::numbers::pi * rod_.section().radius * rod_.section().radius / rod_.section().mass;
  for (int i = 0; i < n; ++i)
    drag_[at(i)] = mass(i) / rod_.section().mass * toolkit::rod_drag(around, springs.diameter, s.velocity(i).norm());
  const ChainState chain = step.chain(0, vertices());
  std::vector<double>& room = sides_;  // of 24 n
  std::copy_n(s.x, 3 * n, room.begin() + 3 * n), std::copy_n(s.v, 3 * n, room.begin() + 6 * n);
  double *x = room.data() + 3 * n, *v = room.data() + 6 * n;
  for (int k = 0; k < parts; ++k)
    explicit_step(springs, n, x, v, step.dt() / parts, toolkit::vec(step.gravity()), borne, drag_, charge_force_, room.data(),
                  [this](int i) { return stays(i); }, [&](int j) { return chain.radius[at(j)] > 0; });
  double* change = room.data() + 9 * n;
  for (int i = 0; i < n; ++i)
    for (int r = 0; r < 4; ++r) change[4 * i + r] = r == 3 ? 0.0 : x[3 * i + r] - begun.x[3 * i + r];
  rod_.move(begun, change, 1, s);
  std::copy_n(v, 3 * n, s.v);
  rod_.take_tension(s);
  part(step);
}

/// v = v_free + W j at the end of the step, with the masses of the two nodes beside each point. The way of explicit parts is shorter than
/// that speed tells, by a h^2 / 2.
void Thread::answer_masses(std::span<const swage_contact_point> points, std::span<const swage_chain_place> place, double* v_free, double* W) {
  const int n = static_cast<int>(std::min(points.size(), point_.size()));
  const int stride = 3 * static_cast<int>(points.size());
  const RodState base(nodes(), base_.data());
  std::fill_n(v_free, stride, 0.0), std::fill_n(W, stride * stride, 0.0);
  const auto weight = [&](const Point& p, int node) {
    if (stays(node)) return 0.0;
    return node == p.edge ? 1 - p.s : node == p.edge + 1 ? p.s : 0.0;
  };
  for (int i = 0; i < n; ++i) {
    const Point& p = point_[at(i)] = point(points[at(i)], place[at(i)]);
    const Vec3 free = (1 - p.s) * base.velocity(p.edge) + p.s * base.velocity(p.edge + 1);
    for (int r = 0; r < 3; ++r) v_free[3 * i + r] = free[r];
    for (int j = 0; j <= i; ++j) {
      double w = 0;
      for (const int node : {p.edge, p.edge + 1}) w += weight(p, node) * weight(point_[at(j)], node) / mass(node);
      for (int r = 0; r < 3; ++r) W[(3 * i + r) * stride + 3 * j + r] = W[(3 * j + r) * stride + 3 * i + r] = w;
    }
  }
}

/// The same for a host that knows bands: masses over h^2, and no gradient, as the free motion has been made.
void Thread::linearise_masses(const Step& step, double* columns) const {
  for (int i = 0; i < nodes(); ++i)
    for (int r = 0; r < 3 && !stays(i); ++r) columns[at(4 * i + r) * toolkit::Rod::Matrix::kStride] = mass(i) / (step.dt() * step.dt());
}

/// Goes on from the free motion by `change` of all unknowns; what it gains in speed it keeps.
void Thread::go_masses(const Step& step, const double* change, RodState& s) {
  const RodState base(nodes(), base_.data());
  rod_.move(base, change, 1, s);
  for (int i = 0; i < nodes(); ++i)
    for (int r = 0; r < 3; ++r) s.v[3 * i + r] = base.v[3 * i + r] + (s.x[3 * i + r] - base.x[3 * i + r]) / step.dt();
  rod_.take_tension(s);
}

}  // namespace swage::thread
