// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact_space.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/dense.hpp"
#include "dynamics/row.hpp"

namespace swage::dynamics {
namespace {

using Line = Eigen::Map<Eigen::VectorXd>;
using ConstLine = Eigen::Map<const Eigen::VectorXd>;

Eigen::Index index(size_t n) { return static_cast<Eigen::Index>(n); }

Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }
Vec3 force(const Row& row) { return in_world(row, row.f.fn, row.f.f1, row.f.f2); }

}  // namespace

ContactSpace::ContactSpace(uint32_t max_rows, uint32_t max_hinges) {
  const size_t n = size_t{3} * max_rows + max_hinges;
  W_.resize(n * n), M_.resize(n * n);
  for (std::vector<double>* v : {&free_, &c_, &F_, &v_, &y_, &s_, &right_, &line_}) v->resize(n);
  lever_.resize(size_t{12} * max_rows), turn_.resize(size_t{12} * max_rows);
  arm_.reserve(size_t{2} * max_rows);
  factors_.resize(max_rows + max_hinges);
  drive_.resize(max_hinges);
  pivot_.resize(n);
  hinge_.reserve(max_hinges);
}

// --- points

bool ContactSpace::start(double* z) noexcept {
  std::fill_n(z, 2 * n_, 0.0);
  for (size_t i = 0; i < rows_; ++i) {
    const Row& row = island_->rows[i];
    put(in_world(row, row.at.g, row.at.s1, row.at.s2), z + 3 * i);
  }
  return false;
}

void ContactSpace::displace(const double* z) noexcept {
  for (size_t i = 0; i < rows_; ++i) {
    Row& row = island_->rows[i];
    const Vec3 v = vec3(z + 3 * i);
    row.u = {row.n.dot(v), row.t1.dot(v), row.t2.dot(v)};
  }
}

/// F = y - f.
void ContactSpace::residual(const double* z) noexcept {
  const double* y = z + n_;
  for (size_t i = 0; i < rows_; ++i) put(vec3(y + 3 * i) - force(island_->rows[i]), &F_[3 * i]);
  for (size_t i = 3 * rows_, h = 0; i < n_; ++i, ++h)
    F_[i] = y[i] - hinge_[h]->drive.torque(hinge_[h]->angle + z[i]);
}

double ContactSpace::merit() noexcept {
  std::fill_n(line_.begin(), n_, 0.0);
  work += n_ * n_;
  spread(F_.data(), line_.data());
  double sum = 0;
  for (size_t i = 0; i < n_; ++i) sum += F_[i] * line_[i];
  return sum;
}

/// v += W y.
void ContactSpace::spread(const double* y, double* v) const noexcept {
  const double* L = W_.data();
  Line all(v, index(n_));
  for (size_t i = 0; i < 3 * rows_; i += 3, L += 3 * n_) {
    if (y[i] == 0 && y[i + 1] == 0 && y[i + 2] == 0) continue;
    all += y[i] * ConstLine(L, index(n_)) + y[i + 1] * ConstLine(L + n_, index(n_)) +
           y[i + 2] * ConstLine(L + 2 * n_, index(n_));
  }
  for (size_t i = 3 * rows_; i < n_; ++i, L += n_) all += y[i] * ConstLine(L, index(n_));
}

// --- steps

/// Where neither D nor c is another than the last time, the step leads to where it led then.
bool ContactSpace::direction(const double* z, bool same, double* step) noexcept {
  const Kept kept = linearise(z);
  if (!(same && kept.stiffness && factored_)) {
    solved_ = false;
    factored_ = factor();
    if (!factored_) return false;
  }
  if (!(solved_ && kept.forces)) solve();
  solved_ = true;
  for (size_t i = 0; i < n_; ++i) step[i] = v_[i] - z[i], step[n_ + i] = y_[i] - z[n_ + i];
  return true;
}

/// c = f + D v, and the stiffness of the drives.
ContactSpace::Kept ContactSpace::linearise(const double* z) noexcept {
  Kept kept;
  const auto keep = [](double& old, double now, bool& same) {
    same = same && old == now;
    old = now;
  };
  for (size_t i = 0; i < rows_; ++i) {
    const Row& row = island_->rows[i];
    const Force& f = row.f;
    const Displacement& u = row.u;
    const Tangent& D = row.D;
    const Vec3 c = in_world(row, f.fn + D.nn * u.g, f.f1 + D.n1 * u.g + D.t11 * u.s1 + D.t12 * u.s2,
                            f.f2 + D.n2 * u.g + D.t12 * u.s1 + D.t22 * u.s2);
    for (size_t k = 0; k < 3; ++k) keep(c_[3 * i + k], c[index(k)], kept.forces);
  }
  for (size_t h = 0; h < hinge_.size(); ++h) {
    const Mover& hinge = *hinge_[h];
    const double angle = hinge.angle + z[3 * rows_ + h], k = hinge.drive.stiffness(angle);
    keep(drive_[h], k, kept.stiffness);
    keep(c_[3 * rows_ + h], hinge.drive.torque_at_zero(angle) - k * hinge.angle, kept.forces);
  }
  return kept;
}

/// D = S R' of a row: along the normal and what friction does with it, then across.
void ContactSpace::split(const Row& row, Factors& f) noexcept {
  const Tangent& D = row.D;
  f.rank = 0;
  f.symmetric = D.n1 == 0 && D.n2 == 0;
  const auto add = [&f](const Vec3& R) { f.R[f.rank] = f.S[f.rank] = R, ++f.rank; };
  if (D.nn > 0) {
    const double root = std::sqrt(D.nn);
    add(root * row.n);
    if (!f.symmetric) f.S[0] += (D.n1 * row.t1 + D.n2 * row.t2) / root;
  }
  if (D.t12 == 0 && D.t11 == D.t22) {
    if (!(D.t11 > 0)) return;
    const double root = std::sqrt(D.t11);
    add(root * row.t1);
    add(root * row.t2);
  } else if (D.t11 >= D.t22) {  // of rank one, as laws are that push across a direction only
    const double root = std::sqrt(D.t11);
    add(root * row.t1 + D.t12 / root * row.t2);
  } else {
    const double root = std::sqrt(D.t22);
    add(D.t12 / root * row.t1 + root * row.t2);
  }
}

/// Factors of I + R' W S.
bool ContactSpace::factor() noexcept {
  rank_ = 0;
  symmetric_ = true;
  for (size_t i = 0; i < rows_; ++i) {
    Factors& f = factors_[i];
    split(island_->rows[i], f);
    f.first = rank_;
    rank_ += f.rank;
    symmetric_ = symmetric_ && f.symmetric;
  }
  for (size_t h = 0; h < hinge_.size(); ++h) {
    Factors& f = factors_[rows_ + h];
    f.first = rank_;
    f.rank = drive_[h] > 0 ? 1 : 0;
    f.R[0].x() = std::sqrt(drive_[h]);
    rank_ += f.rank;
  }
  for (size_t i = 0; i < rows_ + hinge_.size(); ++i) fill(i);
  work += 3 * rank_ * n_ + rank_ * rank_ * rank_ / (symmetric_ ? 6 : 3);
  return symmetric_ ? ldl_factor(rank_, M_.data()) : lu_factor(rank_, M_.data(), pivot_.data());
}

/// Lines of the system that belong to a row or a drive; from the diagonal on where it is symmetric.
void ContactSpace::fill(size_t row) noexcept {
  const Factors& f = factors_[row];
  const size_t from = symmetric_ ? place(row) : 0;
  for (uint32_t a = 0; a < f.rank; ++a) {
    const double* L = line(place(row)) + from;
    const Eigen::Index length = index(n_ - from);
    Line RW(line_.data() + from, length);
    if (row < rows_)
      RW = f.R[a].x() * ConstLine(L, length) + f.R[a].y() * ConstLine(L + n_, length) +
           f.R[a].z() * ConstLine(L + 2 * n_, length);
    else
      RW = f.R[a].x() * ConstLine(L, length);
    double* M = M_.data() + (f.first + a) * rank_;
    for (size_t j = symmetric_ ? row : 0; j < rows_; ++j) {
      const Factors& g = factors_[j];
      const double* w = &line_[3 * j];
      for (uint32_t b = 0; b < g.rank; ++b)
        M[g.first + b] = w[0] * g.S[b].x() + w[1] * g.S[b].y() + w[2] * g.S[b].z();
    }
    for (size_t j = std::max(symmetric_ ? row : 0, rows_); j < rows_ + hinge_.size(); ++j)
      if (factors_[j].rank > 0) M[factors_[j].first] = line_[place(j)] * factors_[j].R[0].x();
    M[f.first + a] += 1;
  }
}

/// v and y where the step ends.
void ContactSpace::solve() noexcept {
  work += 2 * n_ * n_ + rank_ * rank_;
  std::copy_n(free_.begin(), n_, v_.begin());
  spread(c_.data(), v_.data());
  for (size_t i = 0; i < rows_ + hinge_.size(); ++i) {
    const Factors& f = factors_[i];
    for (uint32_t a = 0; a < f.rank; ++a)
      right_[f.first + a] = i < rows_ ? f.R[a].dot(vec3(&v_[3 * i])) : f.R[a].x() * v_[place(i)];
  }
  if (symmetric_)
    ldl_solve(rank_, M_.data(), right_.data(), s_.data());
  else
    lu_solve(rank_, M_.data(), pivot_.data(), right_.data(), s_.data());
  std::copy_n(c_.begin(), n_, y_.begin());
  for (size_t i = 0; i < rows_ + hinge_.size(); ++i) {
    const Factors& f = factors_[i];
    for (uint32_t a = 0; a < f.rank; ++a) {
      const double s = s_[f.first + a];
      if (i >= rows_)
        y_[place(i)] -= f.R[a].x() * s;
      else
        for (size_t k = 0; k < 3; ++k) y_[3 * i + k] -= f.S[a][index(k)] * s;
    }
  }
  std::copy_n(free_.begin(), n_, v_.begin());
  spread(y_.data(), v_.data());
}

int ContactSpace::sign() const noexcept {
  return symmetric_ ? 1 : determinant_sign(rank_, M_.data(), pivot_.data());
}

void ContactSpace::aim(const double* step) noexcept {
  for (size_t i = 0; i < rows_; ++i) {
    Row& row = island_->rows[i];
    const Vec3 v = vec3(step + 3 * i);
    row.way = {row.n.dot(v), row.t1.dot(v), row.t2.dot(v)};
  }
}

double ContactSpace::slope(const double* z, const double* step) noexcept {
  const double* y = z + n_;
  double sum = 0;
  for (size_t i = 0; i < 3 * rows_; ++i) sum += y[i] * step[i];
  for (size_t i = 3 * rows_, h = 0; i < n_; ++i, ++h)
    sum += (y[i] - hinge_[h]->drive.torque(hinge_[h]->angle + z[i])) * step[i];
  return sum;
}

/// What the forces y move a body or particle by.
void ContactSpace::respond(uint32_t mover, const double* y, double* d) const noexcept {
  const Mover& m = *island_->movers[mover];
  double F[6] = {};
  for (size_t i = 0; i < rows_; ++i) {
    const Row& row = island_->rows[i];
    const uint32_t stride = row.size_a + row.size_b;
    const Vec3 v = vec3(y + 3 * i), f(row.n.dot(v), row.t1.dot(v), row.t2.dot(v));
    const auto add = [&](const double* J) {
      for (uint32_t u = 0; u < m.size; ++u)
        F[u] += J[u] * f[0] + J[stride + u] * f[1] + J[2 * stride + u] * f[2];
    };
    if (row.mover_a == mover) add(row.J);
    if (row.mover_b == mover) add(row.J + row.size_a);
  }
  m.respond(F, d);
}

double ContactSpace::length(const double* step) noexcept {
  double longest = 0, d[6];
  for (size_t i = 0; i < rows_; ++i) longest = std::max(longest, vec3(step + 3 * i).norm());
  for (uint32_t m = 0; m < island_->movers.size(); ++m) {
    const Mover& mover = *island_->movers[m];
    if (mover.kind != Mover::Kind::kBody && mover.kind != Mover::Kind::kParticle) continue;
    respond(m, step + n_, d);
    longest = std::max(longest, mover.length(d));
  }
  return longest;
}

double ContactSpace::moved(const double* z) noexcept {
  double longest = 0, d[6];
  for (size_t i = 0; i < rows_; ++i) {
    const Row& row = island_->rows[i];
    longest = std::max(longest, (vec3(z + 3 * i) - in_world(row, row.at.g, row.at.s1, row.at.s2)).norm());
  }
  for (uint32_t m = 0; m < island_->movers.size(); ++m) {
    const Mover& mover = *island_->movers[m];
    if (mover.kind != Mover::Kind::kBody && mover.kind != Mover::Kind::kParticle) continue;
    go(m, z, d);
    longest = std::max(longest, mover.length(d));
  }
  return longest;
}

/// From the pose of the linearisation to z.
void ContactSpace::go(uint32_t mover, const double* z, double* d) const noexcept {
  const Mover& m = *island_->movers[mover];
  double way[6];
  m.way(way);
  respond(mover, z + n_, d);
  for (uint32_t u = 0; u < m.size; ++u) d[u] += way[u];
}

void ContactSpace::finish(const double* z, double* d) noexcept {
  for (size_t i = 0; i < rows_; ++i) island_->rows[i].y = vec3(z + n_ + 3 * i);
  uint32_t hinge = 0;
  for (uint32_t m = 0; m < island_->movers.size(); ++m) {
    const Mover& mover = *island_->movers[m];
    if (mover.kind == Mover::Kind::kSelf) continue;
    if (mover.kind == Mover::Kind::kHinge)
      d[mover.offset] = z[3 * rows_ + hinge++];
    else
      go(m, z, d + mover.offset);
  }
}

}  // namespace swage::dynamics
