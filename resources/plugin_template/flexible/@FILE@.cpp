// SPDX-License-Identifier: Apache-2.0
#include "@FILE@.hpp"

#include <swage/eigen.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using Step = swage::Step;

namespace {
constexpr int kIterations = 3;       // Newton iterations of a step without contacts
constexpr double kMostStrain = 0.05;  // change of strain in a step up to which a pushed strand continues; above it, it stops for a step
}  // namespace

// [main] Declares one flexible body, one chain on it, and the private numbers, of which the chain's come first.
void @NAME@::build(const P& p, Builder& builder) {
  n_ = static_cast<size_t>(p.segments) + 1;
  piece_ = p.length / p.segments;
  const double area = 0.25 * std::numbers::pi * p.diameter * p.diameter;
  mass_ = p.density * area * piece_;
  stretch_ = p.modulus * area / piece_;
  bend_ = p.modulus * area * p.diameter * p.diameter / 16 / (piece_ * piece_ * piece_);  // E I / l^3
  if (piece_ < 0.5 * p.diameter) builder.error("segments", "a segment is at least half as long as the strand is thick: take fewer");

  body_ = builder.flexible_body("strand");
  builder.state(swage::ChainState::doubles(vertices()) + 1);
  std::vector<double> p_B(3 * n_), radius(n_ - 1, 0.5 * p.diameter);
  for (size_t i = 0; i < n_; ++i) p_B[3 * i] = piece_ * static_cast<double>(i);
  builder.chain(host_extension<swage_host_chain>(SWAGE_HOST_CHAIN), body_,
                {SWAGE_CHAIN_SEGMENTS, vertices(), p_B.data(), nullptr, radius.data(), std::max(p.diameter, piece_), 0, 0});
  elongation_ = builder.signal("strand.stretch", "1", "Length over that without load, less 1.");

  A_ = Matrix(static_cast<int>(kOf * n_));
  gradient_.resize(kOf * n_), right_.resize(kOf * n_);
  for (auto* numbers : {&x0_, &v0_, &base_}) numbers->resize(3 * n_);
}

// [rt] The host has put the chain back to its declared positions, at rest.
void @NAME@::reset(const Step& step) { held(step) = 0; }

void @NAME@::finish(const Step& step) {
  const double* x = chain(step).p_W.data();
  double length = 0;
  for (size_t j = 0; j + 1 < n_; ++j) length += (swage::vec(x, j + 1) - swage::vec(x, j)).norm();
  step.signal(elongation_, length / params().length - 1);
}

// [rt] Free motion. After a step in which contacts pushed, the strand continues at its velocity instead: the host finds contacts at
// the positions written here, and a strand that its tension drew out of the jaws would not be found between them.
void @NAME@::advance(const Step& step) {
  const swage::ChainState c = chain(step);
  std::copy(c.p_W.begin(), c.p_W.end(), x0_.begin());
  std::copy(c.v_W.begin(), c.v_W.end(), v0_.begin());
  if (held(step) == 0) {
    for (int i = 0; i < kIterations; ++i) {
      set_up(step, c.p_W.data());
      for (size_t k = 0; k < right_.size(); ++k) right_[k] = -gradient_[k];
      A_.factor();
      solve(right_.data());
      std::copy(c.p_W.begin(), c.p_W.end(), base_.begin());
      go(step, base_.data(), right_.data());
    }
  } else {
    const double h = goes_on(step) ? step.dt() : 0;
    for (size_t k = 0; k < 3 * n_; ++k) c.p_W[k] += h * v0_[k], c.v_W[k] = h > 0 ? v0_[k] : 0;
  }
  std::copy(c.p_W.begin(), c.p_W.end(), base_.begin());
  held(step) = 0;
}

bool @NAME@::goes_on(const Step& step) const {
  for (size_t j = 0; j + 1 < n_; ++j) {
    const Vec3 e = swage::vec(x0_.data(), j + 1) - swage::vec(x0_.data(), j),
               more = step.dt() * (swage::vec(v0_.data(), j + 1) - swage::vec(v0_.data(), j));
    if (std::abs((e + more).norm() - e.norm()) > kMostStrain * piece_) return false;
  }
  return true;
}

// [rt] Linearises one implicit step of length h from x0 at x: A q + gradient = forces of contacts, with
//   A = M (1/h^2 + c/h) + K      gradient = M ((x - x0 - h v0)/h^2 + c (x - x0)/h - g) + dE/dx
void @NAME@::set_up(const Step& step, const double* x) {
  const double h = step.dt(), c = params().damping;
  const Vec3 g = swage::vec(step->gravity);
  A_.set_zero();
  std::fill(gradient_.begin(), gradient_.end(), 0.0);
  for (size_t i = 0; i < n_; ++i) {
    const Vec3 way = swage::vec(x, i) - swage::vec(x0_.data(), i);
    const Vec3 F = mass(i) * (way / (h * h) - swage::vec(v0_.data(), i) / h + c / h * way - g);
    add_square(i, i, mass(i) * (1 / (h * h) + c / h) * Eigen::Matrix3d::Identity());
    swage::vec(gradient_.data() + kOf * i) += F;
  }
  for (size_t j = 0; j + 1 < n_; ++j) add_segment(j, x);
  for (size_t i = 1; i + 1 < n_; ++i) add_joint(i, x);
  for (size_t k = 0; k < gradient_.size(); ++k)
    if (stays(k)) A_.hold(static_cast<int>(k)), gradient_[k] = 0;
}

// Adds a spring. Its negative transverse stiffness under compression is left out, so that A is positive definite in any shape.
void @NAME@::add_segment(size_t j, const double* x) {
  const Vec3 e = swage::vec(x, j + 1) - swage::vec(x, j);
  const double length = std::max(e.norm(), 1e-6 * piece_), tension = stretch_ * (length - piece_);
  const Vec3 t = e / length;
  const double across = std::max(tension, 0.0) / length;
  const Eigen::Matrix3d K = across * Eigen::Matrix3d::Identity() + (stretch_ - across) * t * t.transpose();
  swage::vec(gradient_.data() + kOf * j) -= tension * t;
  swage::vec(gradient_.data() + kOf * (j + 1)) += tension * t;
  add_square(j, j, K), add_square(j + 1, j + 1, K), add_square(j + 1, j, -K);
}

// Adds the bending energy bend/2 |a - 2 b + c|^2 of three neighbours: within a tenth while a joint bends by less than 1 rad.
void @NAME@::add_joint(size_t i, const double* x) {
  constexpr double w[3] = {1, -2, 1};
  const Vec3 bow = swage::vec(x, i - 1) - 2 * swage::vec(x, i) + swage::vec(x, i + 1);
  for (size_t a = 0; a < 3; ++a) {
    swage::vec(gradient_.data() + kOf * (i - 1 + a)) += bend_ * w[a] * bow;
    for (size_t b = 0; b <= a; ++b) add_square(i - 1 + a, i - 1 + b, bend_ * w[a] * w[b] * Eigen::Matrix3d::Identity());
  }
}

// Adds a 3 x 3 block to the lower half of A: i >= j.
void @NAME@::add_square(size_t i, size_t j, const Eigen::Matrix3d& K) {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < (i == j ? r + 1 : 3); ++c)
      A_.at(static_cast<int>(kOf * i) + r, static_cast<int>(kOf * j) + c) += K(r, c);
}

// right = A^-1 right; the unknowns that are held stay 0.
void @NAME@::solve(double* right) {
  for (size_t k = 0; k < kOf * n_; ++k)
    if (stays(k)) right[k] = 0;
  A_.solve(right);
}

// Moves the vertices to `from` + change, with the velocities that lead there from x0.
void @NAME@::go(const Step& step, const double* from, const double* change) const {
  const swage::ChainState c = chain(step);
  for (size_t i = 0; i < n_; ++i)
    for (size_t r = 0; r < 3; ++r) {
      const size_t k = 3 * i + r;
      c.p_W[k] = from[k] + change[kOf * i + r];
      c.v_W[k] = (c.p_W[k] - x0_[k]) / step.dt();
    }
}

// [rt] The host solves A q + gradient = forces together with all bodies in contact. A held unknown has 0 on the diagonal.
void @NAME@::linearise(const Step& step, uint32_t, double* stiffness, double* gradient) {
  set_up(step, base_.data());
  std::copy_n(A_.column(0), kOf * n_ * Matrix::kStride, stiffness);
  std::copy(gradient_.begin(), gradient_.end(), gradient);
  for (size_t k = 0; k < kOf * n_; ++k)
    if (stays(k)) stiffness[k * Matrix::kStride] = 0;
}

void @NAME@::displace(const Step& step, const double* change, std::span<const swage_contact_point> points,
                      std::span<const swage_chain_place>, const double* impulse) {
  go(step, base_.data(), change);
  for (size_t i = 0; i < 3 * points.size(); ++i)
    if (impulse[i] != 0) held(step) = 1;
}

// --- the same for a host without the band extension: v = v_free + W j of points on the chain

// Interpolates numbers of two vertices with the weights of a place.
@NAME@::Vec3 @NAME@::at(const swage_chain_place& p, const double* numbers, size_t per_vertex) {
  const double* a = numbers + per_vertex * p.segment;
  return (1 - p.share) * swage::vec(a) + p.share * swage::vec(a + per_vertex);
}

void @NAME@::push(const swage_chain_place& p, const Vec3& force, double* unknowns) {
  double* a = unknowns + kOf * p.segment;
  swage::vec(a) += (1 - p.share) * force;
  swage::vec(a + kOf) += p.share * force;
}

void @NAME@::mobility(const Step& step, std::span<const swage_contact_point>,
                        std::span<const swage_chain_place> place, double* v_free, double* W) {
  const double h = step.dt();
  const size_t rows = 3 * place.size();
  set_up(step, base_.data());
  A_.factor();
  for (size_t k = 0; k < right_.size(); ++k) right_[k] = -gradient_[k];
  solve(right_.data());
  for (size_t i = 0; i < place.size(); ++i)
    swage::vec(v_free, i) = (at(place[i], base_.data(), 3) - at(place[i], x0_.data(), 3) + at(place[i], right_.data(), kOf)) / h;
  for (size_t c = 0; c < rows; ++c) {
    std::fill(right_.begin(), right_.end(), 0.0);
    push(place[c / 3], Vec3::Unit(static_cast<Eigen::Index>(c % 3)), right_.data());
    solve(right_.data());
    for (size_t i = c / 3; i < place.size(); ++i) {
      const Vec3 w = at(place[i], right_.data(), kOf) / (h * h);
      for (size_t r = 0; r < 3; ++r) W[(3 * i + r) * rows + c] = W[c * rows + 3 * i + r] = w[static_cast<Eigen::Index>(r)];
    }
  }
}

void @NAME@::apply_impulses(const Step& step, std::span<const swage_contact_point>, std::span<const swage_chain_place> place,
                   const double* impulse) {
  for (size_t k = 0; k < right_.size(); ++k) right_[k] = -gradient_[k];
  for (size_t i = 0; i < place.size(); ++i) {
    const Vec3 j = swage::vec(impulse, i);
    push(place[i], j / step.dt(), right_.data());
    if (!j.isZero(0)) held(step) = 1;
  }
  solve(right_.data());
  go(step, base_.data(), right_.data());
}

SWAGE_EXPORT(@NAME@)
