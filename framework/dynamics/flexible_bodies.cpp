// SPDX-License-Identifier: Apache-2.0
#include "dynamics/flexible_bodies.hpp"

#include <algorithm>
#include <cmath>

namespace swage::dynamics {

namespace {

/// True when all numbers are finite: 0 x is 0 except for infinity and NaN, in whatever order the sum is taken.
bool finite(const double* x, size_t n) noexcept {
  return (0.0 * Eigen::Map<const Eigen::VectorXd>(x, static_cast<Eigen::Index>(n))).sum() == 0;
}

}  // namespace

FlexibleBodies::FlexibleBodies(const scene::World& world) : room_(world.capacity.points) {
  // one slot per object that has flexible bodies
  std::vector<uint32_t> objects;
  for (const scene::BodyInfo& body : world.body)
    if (body.motion == SWAGE_MOTION_FLEXIBLE) objects.push_back(body.object);
  std::sort(objects.begin(), objects.end());
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  object_.resize(objects.size());
  for (const uint32_t object : objects) {
    const auto chain = [&](const scene::Shape& s) { return s.object == object && s.kind == SWAGE_SHAPE_CHAIN; };
    const auto first = std::find_if(world.shape.begin(), world.shape.end(), chain);
    if (std::count_if(world.shape.begin(), world.shape.end(), chain) != 1) continue;
    band_.push_back(std::make_unique<BandedBody>(object, static_cast<uint32_t>(world.chain[first->chain].start.size())));
  }
  // both sides of a contact may be on one of them
  const size_t points = band_.empty() ? room_ : std::max<size_t>(room_, 2 * (size_t{world.capacity.contacts} + world.capacity.ties));
  const size_t n = size_t{3} * room_;
  for (Object& o : object_) {
    o.point.resize(points), o.place.resize(points);
    for (std::vector<double>* v : {&o.v_free, &o.u, &o.expected, &o.extra, &o.to}) v->resize(n);
    for (std::vector<double>* v : {&o.force, &o.impulse}) v->resize(3 * points);
    o.W.resize(n * n);
  }
}

uint32_t FlexibleBodies::vertices() const noexcept {
  uint32_t sum = 0;
  for (const auto& band : band_) sum += band->vertices();
  return sum;
}

void FlexibleBodies::begin(std::span<FlexibleBody* const> self, std::span<uint64_t> stiffer) noexcept {
  flexible_ = self.first(std::min(self.size(), object_.size()));
  for (Object& o : object_) o.points = 0, o.displaced = o.sound = false, o.band = nullptr;
  for (uint32_t i = 0; i < flexible_.size(); ++i) {
    if (!flexible_[i]->banded()) continue;
    for (uint32_t b = 0; b < band_.size(); ++b)
      if (band_[b]->object() == flexible_[i]->object())
        object_[i].band = band_[b].get(), object_[i].stiffer = &stiffer[b], band_[b]->begin();
  }
}

uint32_t FlexibleBodies::slot(uint32_t object) const noexcept {
  for (uint32_t i = 0; i < flexible_.size(); ++i)
    if (flexible_[i]->object() == object) return i;
  return scene::kNone;
}

uint32_t FlexibleBodies::add_point(uint32_t slot, uint32_t body, uint32_t shape, const Vec3& p_W,
                                   const Vec3& into, const contact::ChainPlace& place) noexcept {
  Object& o = object_[slot];
  if (o.points == room(slot)) return scene::kNone;
  o.place[o.points] = {place.segment, 0, place.share, place.s};
  o.point[o.points] = {body, shape, toolkit::raw(p_W), toolkit::raw(into)};
  return o.points++;
}

uint32_t FlexibleBodies::nearest(uint32_t slot, const Vec3& p_W) const noexcept {
  const Object& o = object_[slot];
  uint32_t nearest = scene::kNone;
  double least = HUGE_VAL;
  for (uint32_t i = 0; i < o.points; ++i) {
    const double far = (toolkit::vec(o.point[i].p_W) - p_W).squaredNorm();
    if (far < least) least = far, nearest = i;
  }
  return nearest;
}

/// Whether the points of a chain are nearer to its first end.
bool FlexibleBodies::nearer_first(const Object& o) noexcept {
  uint32_t low = UINT32_MAX, high = 0;
  for (uint32_t i = 0; i < o.points; ++i) low = std::min(low, o.place[i].segment), high = std::max(high, o.place[i].segment);
  return low + high + 2 < o.band->vertices();
}

uint32_t FlexibleBodies::ask(double h) noexcept {
  uint32_t unanswered = 0;
  for (uint32_t i = 0; i < flexible_.size(); ++i) {
    Object& o = object_[i];
    const size_t n = 3 * o.points;
    o.h = h;
    if (n == 0) continue;
    if (o.band) {
      std::fill_n(o.force.begin(), n, 0.0);
      o.sound = o.band->linearise(*flexible_[i], nearer_first(o), *o.stiffer);
      unanswered += o.sound ? 0 : o.points;
      continue;
    }
    std::fill_n(o.v_free.begin(), n, 0.0);
    std::fill_n(o.u.begin(), n, 0.0);
    std::fill_n(o.W.begin(), n * n, 0.0);
    for (std::vector<double>* v : {&o.expected, &o.extra, &o.force}) std::fill_n(v->begin(), n, 0.0);
    const std::span<const swage_contact_point> points(o.point.data(), o.points);
    flexible_[i]->locate({o.place.data(), o.points});
    const bool answered = flexible_[i]->mobility(points, o.v_free.data(), o.W.data()) &&
                          flexible_[i]->displacement(points, o.u.data());

    // a failed object, or one whose answer is not finite, cannot be moved
    o.sound = answered && finite(o.v_free.data(), n) && finite(o.u.data(), n) && finite(o.W.data(), n * n);
    if (!o.sound) {
      unanswered += o.points;
      std::fill_n(o.v_free.begin(), n, 0.0);
      std::fill_n(o.u.begin(), n, 0.0);
      continue;
    }
    o.displaced = flexible_[i]->displaces();
  }
  return unanswered;
}

void FlexibleBodies::expect(uint32_t slot, uint32_t point, const Vec3& displacement) noexcept {
  if (object_[slot].band) return;  // a band starts at the state to which it advanced
  const Vec3 prediction_error_at = displacement - u_free(slot, point);
  for (uint32_t i = 0; i < 3; ++i) object_[slot].expected[3 * point + i] = prediction_error_at[i];
}

void FlexibleBodies::start() noexcept {
  for (uint32_t slot = 0; slot < flexible_.size(); ++slot) {
    Object& o = object_[slot];
    if (o.sound && !o.band) std::copy_n(o.expected.begin(), 3 * o.points, o.extra.begin());
  }
}

bool FlexibleBodies::release(uint32_t slot) noexcept {
  Object& o = object_[slot];
  if (!o.sound || o.displaced) return false;
  if (o.band) return o.band->release();
  const auto first = o.extra.begin(), last = first + static_cast<std::ptrdiff_t>(3 * o.points);
  if (std::all_of(first, last, [](double x) { return x == 0; })) return false;
  std::fill(first, last, 0.0);
  return true;
}

PointMobility FlexibleBodies::answer(uint32_t slot) const noexcept {
  const Object& o = object_[slot];
  return {o.W.data(), o.extra.data(), size_t{3} * o.points, o.h * o.h};
}

void FlexibleBodies::begin_forces(uint32_t slot) noexcept {
  std::fill_n(object_[slot].to.begin(), 3 * object_[slot].points, 0.0);
}

void FlexibleBodies::add_force(uint32_t slot, uint32_t point, const Vec3& force) noexcept {
  for (uint32_t i = 0; i < 3; ++i) object_[slot].to[3 * point + i] += force[i];
}

void FlexibleBodies::go(uint32_t slot, double relaxation) noexcept {
  Object& o = object_[slot];
  const size_t n = size_t{3} * o.points;
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::Map<Eigen::VectorXd> extra(o.extra.data(), size);
  extra *= 1 - relaxation;
  for (size_t i = 0; i < n; ++i) {
    o.force[i] += relaxation * (o.to[i] - o.force[i]);
    const double push = relaxation * o.h * o.h * o.to[i];
    if (push != 0) extra += push * Eigen::Map<const Eigen::VectorXd>(o.W.data() + i * n, size);
  }
}

void FlexibleBodies::apply_impulses() noexcept {
  for (uint32_t i = 0; i < flexible_.size(); ++i) {
    Object& o = object_[i];
    if (o.points == 0) continue;
    for (size_t k = 0; k < 3 * o.points; ++k) o.impulse[k] = o.h * o.force[k];
    const std::span<const swage_contact_point> points(o.point.data(), o.points);
    if (o.band) {
      flexible_[i]->locate({o.place.data(), o.points});
      flexible_[i]->displace(o.band->change(), points, o.impulse.data());
    } else {
      flexible_[i]->apply_impulses(points, o.impulse.data());
    }
  }
}

}  // namespace swage::dynamics
