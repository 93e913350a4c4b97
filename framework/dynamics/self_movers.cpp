// SPDX-License-Identifier: Apache-2.0
#include "dynamics/self_movers.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/dense.hpp"

namespace swage::dynamics {

namespace {

/// Without a branch: x - x is 0 for all but infinity and NaN.
bool finite(const double* x, size_t n) noexcept {
  uint64_t wrong = 0;
  for (size_t i = 0; i < n; ++i) wrong |= static_cast<uint64_t>(!(x[i] - x[i] == 0));
  return wrong == 0;
}

}  // namespace

SelfMovers::SelfMovers(const scene::World& world) {
  // one slot per object that has SELF bodies
  std::vector<uint32_t> objects;
  for (const scene::BodyInfo& body : world.body)
    if (body.motion == SWAGE_MOTION_SELF) objects.push_back(body.object);
  std::sort(objects.begin(), objects.end());
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  object_.resize(objects.size());
  constexpr size_t n = 3 * kMaxPoints;
  for (Object& o : object_) {
    o.point.resize(kMaxPoints);
    o.v_free.resize(n), o.u.resize(n), o.y.resize(n), o.impulse.resize(n), o.expected.resize(n),
        o.order.resize(n);
    o.W.resize(n * n), o.L.resize(n * n);
  }
}

void SelfMovers::begin(std::span<SelfSolver* const> self) noexcept {
  self_ = self.first(std::min(self.size(), object_.size()));
  for (Object& o : object_) o.points = o.rank = 0, o.displaced = false;
}

uint32_t SelfMovers::slot(uint32_t object) const noexcept {
  for (uint32_t i = 0; i < self_.size(); ++i)
    if (self_[i]->object() == object) return i;
  return scene::kNone;
}

uint32_t SelfMovers::add_point(uint32_t slot, uint32_t body, uint32_t shape, const Vec3& p_W,
                               const Vec3& into) noexcept {
  Object& o = object_[slot];
  if (o.points == kMaxPoints) return scene::kNone;
  o.point[o.points] = {body, shape, toolkit::raw(p_W), toolkit::raw(into)};
  return o.points++;
}

void SelfMovers::ask(double h) noexcept {
  for (uint32_t i = 0; i < self_.size(); ++i) {
    Object& o = object_[i];
    const size_t n = 3 * o.points;
    o.h = h;
    if (n == 0) continue;
    std::fill_n(o.v_free.begin(), n, 0.0);
    std::fill_n(o.u.begin(), n, 0.0);
    std::fill_n(o.W.begin(), n * n, 0.0);
    std::fill_n(o.impulse.begin(), n, 0.0);
    std::fill_n(o.expected.begin(), n, 0.0);
    const std::span<const swage_contact_point> points(o.point.data(), o.points);
    const bool answered = self_[i]->compliance(points, o.v_free.data(), o.W.data()) &&
                          self_[i]->displacement(points, o.u.data());

    // a failed object, or one that answers nonsense, stands still
    const bool sound =
        answered && finite(o.v_free.data(), n) && finite(o.u.data(), n) && finite(o.W.data(), n * n);
    if (!sound) {
      std::fill_n(o.v_free.begin(), n, 0.0);
      std::fill_n(o.u.begin(), n, 0.0);
      continue;
    }
    o.displaced = std::any_of(o.u.begin(), o.u.begin() + static_cast<std::ptrdiff_t>(n),
                              [](double u) { return u != 0; });
    o.rank = static_cast<uint32_t>(cholesky_semidefinite(n, o.W.data(), o.L.data(), o.order.data()));
    for (size_t row = 0; row < n; ++row)
      for (size_t k = 0; k < o.rank; ++k) o.L[row * n + k] *= h;
    std::fill_n(o.y.begin(), o.rank, 0.0);
  }
}

void SelfMovers::expect(uint32_t slot, uint32_t point, const Vec3& displacement) noexcept {
  const Vec3 beyond = displacement - u_free(slot, point);
  for (uint32_t i = 0; i < 3; ++i) object_[slot].expected[3 * point + i] = beyond[i];
}

void SelfMovers::start() noexcept {
  // what is stiffer than this share of the softest has its place from the rest
  constexpr double kStiff = 1e-5;
  for (uint32_t slot = 0; slot < self_.size(); ++slot) {
    Object& o = object_[slot];
    for (uint32_t r = 0; r < o.rank; ++r) {
      const double* L = o.L.data() + size_t{o.order[r]} * 3 * o.points;
      double rest = o.expected[o.order[r]];
      for (uint32_t k = 0; k < r; ++k) rest -= L[k] * o.y[k];
      o.y[r] = L[r] > kStiff * o.L[size_t{o.order[0]} * 3 * o.points] ? rest / L[r] : 0.0;
    }
  }
}

const double* SelfMovers::columns(uint32_t slot, uint32_t point, int i) const noexcept {
  const Object& o = object_[slot];
  return o.L.data() + (3 * point + static_cast<uint32_t>(i)) * (3 * o.points);
}

Vec3 SelfMovers::extra(uint32_t slot, uint32_t point) const noexcept {
  const Object& o = object_[slot];
  Vec3 u = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const double* L = columns(slot, point, i);
    for (uint32_t k = 0; k < o.rank; ++k) u[i] += L[k] * o.y[k];
  }
  return u;
}

Vec3 SelfMovers::u_free(uint32_t slot, uint32_t point) const noexcept {
  const Object& o = object_[slot];
  return o.h * Vec3(o.v_free[3 * point], o.v_free[3 * point + 1], o.v_free[3 * point + 2]);
}

void SelfMovers::add_impulse(uint32_t slot, uint32_t point, const Vec3& impulse) noexcept {
  for (uint32_t i = 0; i < 3; ++i) object_[slot].impulse[3 * point + i] += impulse[i];
}

/// Impulses that bring the points where the solve has them: y = L' j / h. Those of the contact law do but for the tolerance of
/// the solve, which is 1e-10 m, at 1e6 N/m 0.1 mN, and that would throw a needle of 0.4 mg by a quarter of a millimetre.
void SelfMovers::balance(Object& o) noexcept {
  constexpr double kStiff = 1e-5;
  const size_t stride = size_t{3} * o.points;
  const bool pushed = std::any_of(o.impulse.begin(), o.impulse.begin() + static_cast<std::ptrdiff_t>(stride),
                                  [](double j) { return j != 0; });
  if (!pushed) return;
  // what is missing, once the columns above have theirs; the rows where columns begin are triangular
  std::vector<double>& missing = o.expected;
  for (uint32_t k = 0; k < o.rank; ++k) {
    double sum = o.h * o.y[k];
    for (size_t row = 0; row < stride; ++row) sum -= o.L[row * stride + k] * o.impulse[row];
    missing[k] = sum;
  }
  for (uint32_t k = o.rank; k-- > 0;) {
    const double* L = o.L.data() + o.order[k] * stride;
    if (!(L[k] > kStiff * o.L[o.order[0] * stride])) continue;
    const double more = missing[k] / L[k];
    o.impulse[o.order[k]] += more;
    for (uint32_t i = 0; i < k; ++i) missing[i] -= L[i] * more;
  }
}

void SelfMovers::yield() noexcept {
  for (uint32_t i = 0; i < self_.size(); ++i) {
    Object& o = object_[i];
    if (o.points == 0) continue;
    balance(o);
    self_[i]->yield({o.point.data(), o.points}, o.impulse.data());
  }
}

}  // namespace swage::dynamics
