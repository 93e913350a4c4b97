// SPDX-License-Identifier: Apache-2.0
//
// Newton's direction of a thread of 100 nodes that touches itself, a needle and what stands: three ways to solve
// (A + J' D J) d = -F, for 20, 60 and 100 contacts, a third of each kind. All start from the thread's own band A.
//
//   blocks     sparse L D L' in blocks of a node, contacts in the pattern (dynamics/banded_blocks.hpp): what the host does
//   woodbury   contacts with what stands in the band, the needle as its border, contacts of the thread with itself as a low rank
//   delassus   W = J A^-1 J' by solves with the band, then D^-1 + W densely
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "dynamics/banded_assembly.hpp"
#include "dynamics/dense.hpp"
#include "toolkit/rod.hpp"

namespace swage::bench::direction {

using toolkit::Mat3;
using toolkit::Vec3;
using Band = toolkit::Rod::Matrix;

inline constexpr uint32_t kNodes = 100;
inline constexpr int kUnknowns = 4 * kNodes - 1, kBody = 6;

struct Contact {
  enum class With { kFixed, kNeedle, kSelf } with = With::kFixed;
  dynamics::BlockPoint a, b;
  Mat3 D;
};

/// 10-0 nylon whose two halves touch each other node by node, as in a throw. Only the Jacobians know it: the thread itself is straight,
/// so that its Hessian is definite.
struct Scene {
  explicit Scene(uint32_t contacts)
      : section(toolkit::RodSection::round(22e-6, 2.5e9, 0.39, 1140)),
        rod(section, std::vector<double>(kNodes - 1, 0.3e-3)),
        numbers(toolkit::RodState::size(kNodes)),
        s(kNodes, numbers.data()),
        H(kNodes + 2, 4000) {
    for (uint32_t i = 0; i < kNodes; ++i) Eigen::Map<Vec3>(s.x + 3 * i) = Vec3(0.3e-3 * i, 0, 0);
    rod.start(s);
    for (uint32_t k = 0; k < contacts; ++k) {
      Contact c;
      c.with = static_cast<Contact::With>(k % 3);
      const uint32_t node = 10 + k * 38 / contacts;
      const Vec3 arm(0, 11e-6, 0);
      c.a = dynamics::thread_point(0, node, 0.4, Vec3::UnitX(), arm);
      if (c.with == Contact::With::kNeedle) c.b = dynamics::body_point(kNodes, Vec3(1e-4 * k, 0, 5e-5));
      if (c.with == Contact::With::kSelf)
        c.b = dynamics::thread_point(0, kNodes - 2 - node, 0.6, Vec3::UnitX(), -arm);
      c.D = Vec3(8e3, 1e4, 8e3).asDiagonal();
      all.push_back(c);
    }
    pairs();
    ok = H.analyse(kNodes + 2, coupled);
    load.h = 1e-3;
    rod.take_tension(s);
    A = Band(kUnknowns);
    gradient.resize(kUnknowns);
    assemble();
    right = Eigen::VectorXd::LinSpaced(4 * kNodes + 8, -1e-3, 2e-3);
    for (const int idle : {4 * static_cast<int>(kNodes) - 1, 4 * static_cast<int>(kNodes) + 3,
                           4 * static_cast<int>(kNodes) + 7})
      right[idle] = 0;
  }
  void pairs() {
    for (uint32_t i = 0; i < kNodes; ++i)
      for (uint32_t k = 1; k < 3 && i + k < kNodes; ++k) coupled.push_back({i + k, i});
    coupled.push_back({kNodes + 1, kNodes});
    for (const Contact& c : all)
      for (uint32_t i = 0; i < 2; ++i)
        for (uint32_t j = 0; j < c.b.size; ++j) coupled.push_back({c.a.block[i], c.b.block[j]});
  }
  void assemble() {
    rod.differentiate(s, gradient.data(), &A);
    for (uint32_t i = 0; i < kNodes; ++i)
      for (int r = 0; r < 3; ++r)
        A.at(static_cast<int>(4 * i) + r, static_cast<int>(4 * i) + r) +=
            rod.node_mass(static_cast<int>(i)) * 1e6;
    for (int j = 0; j < static_cast<int>(kNodes) - 1; ++j)
      A.at(4 * j + 3, 4 * j + 3) += 0.5 * rod.node_mass(j) * section.radius * section.radius * 1e6;
  }
  /// Of the needle: 0.4 mg over h^2, its moments of inertia.
  static Eigen::Matrix<double, kBody, 1> body() {
    Eigen::Matrix<double, kBody, 1> m;
    m << 0.4, 0.4, 0.4, 1.3e-6, 1e-7, 1.3e-6;
    return m;
  }

  toolkit::RodSection section;
  toolkit::Rod rod;
  std::vector<double> numbers, gradient;
  toolkit::RodState s;
  toolkit::RodLoad load;
  std::vector<Contact> all;
  std::vector<dynamics::BandedBlocks::Pair> coupled;
  dynamics::BandedBlocks H;
  Band A;
  Eigen::VectorXd right;  // in blocks: 4 numbers a node, then the body's
  bool ok = false;
};

inline Eigen::VectorXd by_blocks(Scene& k) {
  k.H.set_zero(true);
  dynamics::add_band(k.H, 0, k.A, true);
  dynamics::BandedBlocks::Block M = dynamics::BandedBlocks::Block::Identity();
  for (int half = 0; half < 2; ++half) {
    for (int r = 0; r < 3; ++r) M(r, r) = Scene::body()[3 * half + r];
    k.H.add(kNodes + static_cast<uint32_t>(half), kNodes + static_cast<uint32_t>(half), M);
  }
  for (const Contact& c : k.all) dynamics::add_contact(k.H, c.a, c.b, c.D, true);
  Eigen::VectorXd x = k.right;
  if (!k.H.factor()) x.setConstant(std::nan(""));
  k.H.solve(x.data());
  return x;
}

/// Columns of J' of a contact: its three rows, over the thread's unknowns (`line` apart) and the body's.
inline void spread(const dynamics::BlockPoint& p, double sign, int row, double* thread, int line, double* body) {
  for (uint32_t k = 0; k < p.size; ++k)
    for (int c = 0; c < 4; ++c) {
      const double J = sign * p.J[k](row, c);
      const int unknown = static_cast<int>(4 * p.block[k]) + c;
      if (p.block[k] < kNodes) {
        if (unknown < kUnknowns) thread[unknown * line] += J;
      } else if (c < 3) {
        body[3 * static_cast<int>(p.block[k] - kNodes) + c] += J;
      }
    }
}

/// X = A^-1 U, six sides at a time; U is kUnknowns x columns, column by column.
inline Eigen::MatrixXd solved(const Band& A, const Eigen::MatrixXd& U) {
  Eigen::MatrixXd X(U.rows(), U.cols());
  std::vector<double> six(static_cast<size_t>(6 * kUnknowns));
  for (Eigen::Index first = 0; first < U.cols(); first += 6) {
    const Eigen::Index last = std::min<Eigen::Index>(first + 6, U.cols());
    std::fill(six.begin(), six.end(), 0.0);
    for (Eigen::Index c = first; c < last; ++c)
      for (int i = 0; i < kUnknowns; ++i)
        six[static_cast<size_t>(6 * i + static_cast<int>(c - first))] = U(i, c);
    A.solve<6>(six.data());
    for (Eigen::Index c = first; c < last; ++c)
      for (int i = 0; i < kUnknowns; ++i)
        X(i, c) = six[static_cast<size_t>(6 * i + static_cast<int>(c - first))];
  }
  return X;
}

/// x of the dense, symmetric system, the engine's own factor.
inline Eigen::VectorXd dense_solve(const Eigen::MatrixXd& M, const Eigen::VectorXd& b) {
  std::vector<double> a(static_cast<size_t>(M.size()));
  Eigen::Map<Eigen::MatrixXd>(a.data(), M.rows(), M.cols()) = M;
  Eigen::VectorXd x(b.size());
  const auto n = static_cast<size_t>(b.size());
  if (!dynamics::ldl_factor(n, a.data())) return Eigen::VectorXd::Constant(b.size(), std::nan(""));
  dynamics::ldl_solve(n, a.data(), b.data(), x.data());
  return x;
}

/// Unknowns of the direction from those of the thread and of the body.
inline Eigen::VectorXd joined(const Eigen::VectorXd& thread, const Eigen::VectorXd& body) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(4 * kNodes + 8);
  x.head(kUnknowns) = thread;
  x.segment<3>(4 * kNodes) = body.head<3>();
  x.segment<3>(4 * kNodes + 4) = body.tail<3>();
  return x;
}

inline Eigen::VectorXd right_of_body(const Scene& k) {
  Eigen::VectorXd b(kBody);
  b << k.right.segment<3>(4 * kNodes), k.right.segment<3>(4 * kNodes + 4);
  return b;
}

/// Contacts with the thread itself as new unknowns, their forces; the needle as six more.
inline Eigen::VectorXd by_woodbury(Scene& k) {
  Band A = k.A;
  Eigen::MatrixXd C = Scene::body().asDiagonal(), B = Eigen::MatrixXd::Zero(kUnknowns, kBody);
  std::vector<const Contact*> self;
  for (const Contact& c : k.all) {
    if (c.with == Contact::With::kSelf) {
      self.push_back(&c);
      continue;
    }
    const uint32_t node = c.a.block[0];
    Eigen::Matrix<double, 3, 8> Ja;
    Ja << c.a.J[0], c.a.J[1];
    const Eigen::Matrix<double, 8, 8> K = Ja.transpose() * c.D * Ja;
    for (int j = 0; j < 7; ++j)
      for (int i = j; i < 7; ++i)
        A.at(static_cast<int>(4 * node) + i, static_cast<int>(4 * node) + j) += K(i, j);
    if (c.with != Contact::With::kNeedle) continue;
    Eigen::Matrix<double, 3, 6> Jb;
    Jb << c.b.J[0].leftCols<3>(), c.b.J[1].leftCols<3>();
    C += Jb.transpose() * c.D * Jb;
    const Eigen::Matrix<double, 8, 6> K_ab = -Ja.transpose() * c.D * Jb;
    for (int i = 0; i < 7; ++i) B.row(static_cast<int>(4 * node) + i) += K_ab.row(i);
  }
  if (!A.factor()) return Eigen::VectorXd::Constant(4 * kNodes + 8, std::nan(""));
  const auto s = static_cast<Eigen::Index>(3 * self.size());
  Eigen::MatrixXd U(kUnknowns, kBody + s + 1);
  U.setZero();
  U.leftCols(kBody) = B;
  double none[kBody] = {};
  for (size_t i = 0; i < self.size(); ++i)
    for (int r = 0; r < 3; ++r) {
      double* column = U.col(static_cast<Eigen::Index>(kBody + 3 * static_cast<int>(i) + r)).data();
      spread(self[i]->a, 1, r, column, 1, none);
      spread(self[i]->b, -1, r, column, 1, none);
    }
  U.rightCols(1) = k.right.head(kUnknowns);
  const Eigen::MatrixXd X = solved(A, U);
  // [C - B'A^-1 B, B'A^-1 U; U'A^-1 B, -(D^-1 + U'A^-1 U)], with the sign of the forces turned so that it is definite
  Eigen::MatrixXd S = U.leftCols(kBody + s).transpose() * X.leftCols(kBody + s);
  S.topLeftCorner(kBody, kBody) = C - S.topLeftCorner(kBody, kBody).eval();
  for (size_t i = 0; i < self.size(); ++i)
    for (int r = 0; r < 3; ++r)
      S(kBody + 3 * static_cast<int>(i) + r, kBody + 3 * static_cast<int>(i) + r) += 1 / self[i]->D(r, r);
  Eigen::VectorXd b = U.leftCols(kBody + s).transpose() * X.col(kBody + s);
  b.head(kBody) = right_of_body(k) - b.head(kBody);
  // forces first, by elimination of the body: K = S_ss + S_sb S_bb^-1 S_bs
  const Eigen::MatrixXd S_sb = S.bottomLeftCorner(s, kBody);
  Eigen::MatrixXd solved_b(kBody, s + 1);
  const Eigen::MatrixXd S_bb = S.topLeftCorner(kBody, kBody);
  for (Eigen::Index c = 0; c < s; ++c) solved_b.col(c) = dense_solve(S_bb, S_sb.row(c).transpose());
  solved_b.col(s) = dense_solve(S_bb, b.head(kBody));
  Eigen::VectorXd force(0), body = solved_b.col(s);
  if (s > 0) {
    const Eigen::MatrixXd K = S.bottomRightCorner(s, s) + S_sb * solved_b.leftCols(s);
    force = dense_solve(K, b.tail(s) - S_sb * solved_b.col(s));
    body += solved_b.leftCols(s) * force;
  }
  Eigen::VectorXd thread = X.col(kBody + s) - X.leftCols(kBody) * body;
  if (s > 0) thread -= X.middleCols(kBody, s) * force;
  return joined(thread, body);
}

/// Over the forces of all contacts: (D^-1 + W) f = J d*.
inline Eigen::VectorXd by_delassus(Scene& k) {
  Band A = k.A;
  if (!A.factor()) return Eigen::VectorXd::Constant(4 * kNodes + 8, std::nan(""));
  const auto rows = static_cast<Eigen::Index>(3 * k.all.size());
  Eigen::MatrixXd U = Eigen::MatrixXd::Zero(kUnknowns, rows + 1), Ub = Eigen::MatrixXd::Zero(kBody, rows);
  for (size_t i = 0; i < k.all.size(); ++i)
    for (int r = 0; r < 3; ++r) {
      const auto column = static_cast<Eigen::Index>(3 * static_cast<int>(i) + r);
      spread(k.all[i].a, 1, r, U.col(column).data(), 1, Ub.col(column).data());
      spread(k.all[i].b, -1, r, U.col(column).data(), 1, Ub.col(column).data());
    }
  U.rightCols(1) = k.right.head(kUnknowns);
  const Eigen::MatrixXd X = solved(A, U);
  const Eigen::VectorXd light = Scene::body().cwiseInverse();
  const Eigen::VectorXd body = light.asDiagonal() * right_of_body(k);
  Eigen::MatrixXd W =
      U.leftCols(rows).transpose() * X.leftCols(rows) + Ub.transpose() * (light.asDiagonal() * Ub);
  for (Eigen::Index i = 0; i < rows; ++i) W(i, i) += 1 / k.all[static_cast<size_t>(i / 3)].D(i % 3, i % 3);
  const Eigen::VectorXd f =
      dense_solve(W, U.leftCols(rows).transpose() * X.col(rows) + Ub.transpose() * body);
  return joined(X.col(rows) - X.leftCols(rows) * f, body - light.asDiagonal() * (Ub * f));
}

using Way = Eigen::VectorXd (*)(Scene&);

}  // namespace swage::bench::direction
