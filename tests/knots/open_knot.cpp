// SPDX-License-Identifier: Apache-2.0
#include "open_knot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolkit/knot/writhe.hpp"
#include "toolkit/rod_passage.hpp"

namespace swage::test {
namespace {

constexpr double kPi = std::numbers::pi;
// What is laid is bent more than it would be by itself: in oil it finds its shape without passing through itself. Viscosity at first, the
// time in which it falls to a third, and that of air, which it has after twenty times that [Pa s, s, Pa s].
constexpr double kOil = 1e4, kThins = 0.02, kAir = 1.8e-5;

/// The centre line as it is laid, in small steps. In the braid the strands are at +-D/2 (cos phi, sin phi) about the line midway between
/// tail and loop, D the distance between these, phi from -90 degrees on the left, tail below loop, to +90 degrees on the right.
class Line {
 public:
  explicit Line(const OpenKnotTest& t)
      : half_(0.5 * t.braid), rho_(t.loop), apart_(1.1 * t.diameter),
        wound_(half_ + 2.5 * std::sqrt(t.diameter * t.loop)), total_((2 * t.turns + 1) * kPi) {
    const double end = half_ + rho_ * std::sin(kLeaves);
    const double d = 0.05 * t.diameter;
    for (double x = -t.tail; x < end; x += d) add(strand(x, -1), x);
    // round the loop: two arcs and the straight above the braid
    for (double a = kLeaves; a < kPi; a += d / rho_) add({half_ + rho_ * std::sin(a), rho_ * (1 - std::cos(a)), 0}, kFar);
    for (double x = half_; x > -half_; x -= d) add({x, 2 * rho_, 0}, kFar);
    for (double a = kPi; a > kLeaves; a -= d / rho_) add({-half_ - rho_ * std::sin(a), rho_ * (1 - std::cos(a)), 0}, kFar);
    for (double x = -end; x < t.tail; x += d) add(strand(x, 1), x);
  }
  /// Nodes along it: fine in the braid, then each segment at most so much longer than the one before it.
  std::vector<Vec3> nodes(double fine, double coarse) const {
    constexpr double kGrows = 0.12;  // per length: 12 % longer over the length of a segment
    std::vector<double> length(point_.size(), coarse);
    for (size_t i = 0; i < point_.size(); ++i)
      if (std::abs(x_[i]) < wound_ + 0.3 * rho_) length[i] = fine;
    const auto d = [&](size_t i) { return (point_[i] - point_[i - 1]).norm(); };
    for (size_t i = 1; i < point_.size(); ++i) length[i] = std::min(length[i], length[i - 1] + kGrows * d(i));
    for (size_t i = point_.size() - 1; i > 0; --i) length[i - 1] = std::min(length[i - 1], length[i] + kGrows * d(i));
    std::vector<Vec3> out{point_.front()};
    for (size_t i = 1; i < point_.size(); ++i)
      if ((point_[i] - out.back()).norm() >= length[i]) out.push_back(point_[i]);
    return out;
  }

 private:
  static constexpr double kLeaves = kPi / 3;  // on the arc of the loop: beyond, the strands are far apart
  static constexpr double kFar = 1e9;

  void add(const Vec3& p, double x) { point_.push_back(p), x_.push_back(x); }
  double height(double x) const {
    const double out = std::min(std::abs(x) - half_, rho_ * std::sin(kLeaves));
    return out > 0 ? rho_ - std::sqrt(rho_ * rho_ - out * out) : 0;
  }
  /// side -1: the strand that is a tail on the left.
  Vec3 strand(double x, double side) const {
    const double s = std::clamp(0.5 * (x / wound_ + 1), 0.0, 1.0), phi = -0.5 * kPi + total_ * s;
    const double far = height(x), apart = std::abs(x) < wound_ ? std::hypot(apart_, far) : far;
    if (std::abs(x) >= wound_) return {x, side * x > 0 ? 0 : far, 0};
    return Vec3(x, 0.5 * far - side * 0.5 * apart * std::sin(phi), -side * 0.5 * apart * std::cos(phi));
  }

  double half_, rho_, apart_, wound_, total_;
  std::vector<Vec3> point_;
  std::vector<double> x_;
};

scene::World make_world(const OpenKnotTest& test, const std::vector<Vec3>& laid) {
  scene::World w;
  w.dt = test.dt;
  w.gravity = {0, 0, 0};
  w.capacity.contacts = 2048;
  dynamics::add_chain(w, laid, 0.5 * test.diameter, 0);
  w.chain[0].bend_radius = test.diameter;
  scene::reset(w);
  return w;
}

}  // namespace

OpenKnot::OpenKnot(const OpenKnotTest& test)
    : test_(test), laid_(Line(test).nodes(test.fine, test.coarse)), world_(make_world(test, laid_)),
      n_(static_cast<int>(laid_.size())), boxes_(toolkit::room_for_passages(n_)), friction_(test.friction) {
  const auto section = toolkit::RodSection::round(test.diameter, test.young, test.poisson, test.density);
  rod_ = std::make_unique<dynamics::RodBody>(world_, 0, 0, section, true);
  contact::Options options;
  options.capacity = world_.capacity.contacts, options.margin = 5e-6 / world_.length;
  const contact::Law law{test.friction, test.stiffness, 0};
  detector_ = std::make_unique<contact::Detector>(world_, std::vector<contact::Pair>{{0, 0, law}}, options);
  solve_ = std::make_unique<dynamics::Dynamics>(world_, dynamics::Options());
  detector_->reserve(contacts_);
  steps_ = std::make_unique<dynamics::DividedSteps>(world_, *rod_, *detector_, *solve_, contacts_);
  for (const int end : {0, n_ - 1}) rod_->hold(end);
  if (!test.clamped) return;
  for (const int next : {1, n_ - 2}) rod_->hold(next);
  for (const int edge : {0, n_ - 2}) rod_->rod().hold_turn(edge);
}

void OpenKnot::step() {
  const toolkit::RodState s = rod_->state();
  rod_->fluid = {1000, std::max(kAir, kOil * std::exp(-time_ / kThins))};
  const auto friction = [&] {
    for (contact::Contact& c : contacts_.contact) c.law.friction = friction_;
  };
  steps_->step([&] { begin_part(); }, friction,
               [&] { passages_ += toolkit::passages(n_, before_.data(), s.x, [](int) { return true; }, boxes_); });
  time_ += world_.dt;
  bearing_ = 0, overlap_ = 0, pressing_ = 0;
  for (const contact::Contact& c : contacts_.contact) {
    const double f = c.f_a_W.norm();
    if (f > 0) ++bearing_, overlap_ = std::max(overlap_, -c.gap), pressing_ += f;
  }
}

void OpenKnot::begin_part() {
  const toolkit::RodState s = rod_->state();
  before_.assign(s.x, s.x + 3 * n_);
  for (int i = 0; i <= (test_.clamped ? 1 : 0); ++i)
    Eigen::Map<Vec3>(s.v + 3 * i) = Vec3(-speed_, 0, 0), Eigen::Map<Vec3>(s.v + 3 * (n_ - 1 - i)) = Vec3(speed_, 0, 0);
}

int OpenKnot::relax(int most, double share) {
  speed_ = 0;
  double before = pull();
  for (int k = 1; k <= most; ++k) {
    step();
    if (k % 50 != 0) continue;
    if (std::abs(pull() - before) < share * std::abs(before)) return k;
    before = pull();
  }
  return most;
}

void OpenKnot::draw(double each, double speed) {
  const int steps = std::max(1, static_cast<int>(std::lround(std::abs(each) / (speed * world_.dt))));
  speed_ = each / (steps * world_.dt);
  for (int k = 0; k < steps; ++k) step();
  speed_ = 0;
}

double OpenKnot::pull() const {
  const int held = test_.clamped ? 1 : 0;  // segments at an end that are held whole
  return 0.5 * (rod_->rod().linear_tension(held) + rod_->rod().linear_tension(n_ - 2 - held));
}
double OpenKnot::shortening() const {
  double length = 0;
  for (int j = 0; j + 1 < n_; ++j) length += rod_->rod().rest_length(j);
  return length - (node(n_ - 1) - node(0)).norm();
}
double OpenKnot::bending() const { return rod_->rod().section().bending; }
int OpenKnot::apex() const {
  int best = 1;
  double far = 0;
  for (int i = 1; i + 1 < n_; ++i) {
    const Vec3 p = node(i);
    const double d = std::hypot(p.y(), p.z());
    if (d > far) far = d, best = i;
  }
  return best;
}
double OpenKnot::from_an_end() const {
  const int middle = apex();
  double before = 0, behind = 0;
  for (int j = 0; j + 1 < n_; ++j) (j < middle ? before : behind) += rod_->rod().rest_length(j);
  return std::min(before, behind);
}
double OpenKnot::apex_curvature() const { return rod_->rod().curvature(rod_->state(), apex()); }
double OpenKnot::apex_tension() const {
  const int i = apex();
  return 0.5 * (rod_->rod().linear_tension(i - 1) + rod_->rod().linear_tension(i));
}

double OpenKnot::linking() const {
  constexpr double kFar = 1;  // m
  const toolkit::RodState s = const_cast<OpenKnot*>(this)->rod_->state();
  std::vector<double> node(s.x, s.x + 3 * n_);
  for (const auto& [x, y] : {std::pair{kFar, 0.0}, {kFar, -kFar}, {-kFar, -kFar}, {-kFar, 0.0}}) node.insert(node.end(), {x, y, 0});
  return rod_->rod().turns(s) + toolkit::writhe(node.data(), static_cast<int>(node.size() / 3), true);
}

}  // namespace swage::test
