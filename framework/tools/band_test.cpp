// SPDX-License-Identifier: Apache-2.0
#include "tools/band_test.hpp"

#include <algorithm>
#include <cmath>

#include "base/rng.hpp"
#include "scene/chain.hpp"
#include "toolkit/band.hpp"
#include "toolkit/math.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using toolkit::Vec3;
using BandMatrix = toolkit::Band<SWAGE_BAND_REACH>;

// relative: rounding of a factor of a thread that is 1e5 times stiffer along than across
constexpr double kBandRounding = 1e-6;
// m, size of the tested change: so small that nothing yields or breaks and rotations stay linear
constexpr double kTriedChange = 1e-9;
// relative to the change: largest error of a displacement; rotations enter in second order
constexpr double kGoesWithin = 1e-3;

/// Calls linearise() with rising `stiffer` until the matrix can be factored. Held unknowns have the reciprocal pivot 0.
std::string factor_band(BandAsk& ask, BandMatrix& A, Eigen::VectorXd& gradient) {
  for (uint32_t stiffer = 0; stiffer <= SWAGE_BAND_STIFFER; ++stiffer) {
    A.set_zero();
    gradient.setZero();
    std::string wrong = ask.call(host::Call::kLinearise, [&] {
      return ask.table.linearise(ask.raw(), ask.view(), stiffer, A.column(0), gradient.data());
    });
    if (!wrong.empty()) return wrong;
    bool finite = gradient.allFinite();
    for (int k = 0; k < SWAGE_BAND_COLUMN * A.size(); ++k) finite &= std::isfinite(A.column(0)[k]);
    if (!finite) return say::kBandNotFinite();
    std::vector<int> held;
    for (int k = 0; k < A.size(); ++k)
      if (A.at(k, k) == 0) A.hold(k), gradient[k] = 0, held.push_back(k);
    if (!A.factor()) continue;
    for (const int k : held) A.column(k)[0] = 0;
    return "";
  }
  return say::kBandNotDefinite();
}

/// "" where the linear step of the band gives the v_free and W of the solver.
std::string same_as_solver(const BandAsk& ask, BandMatrix& A, const Eigen::VectorXd& gradient) {
  const scene::ChainView chain(ask.world, ask.world.chain[ask.chain]);
  const Eigen::Index n = gradient.size(), rows = ask.all.v_free.size();
  Eigen::VectorXd v_free(rows), free = -gradient;
  A.solve(free.data());
  const auto at = [](const swage_chain_place& p, const Eigen::VectorXd& q) {
    return Vec3((1 - p.share) * q.segment<3>(4 * p.segment) + p.share * q.segment<3>(4 * p.segment + 4));
  };
  SolverAnswer::Matrix W(rows, rows);
  const double h = ask.world.dt;
  for (Eigen::Index c = 0; c < rows; ++c) {
    const swage_chain_place& p = ask.points.place[static_cast<size_t>(c / 3)];
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    x[4 * p.segment + c % 3] = 1 - p.share, x[4 * p.segment + 4 + c % 3] = p.share;
    for (int k = 0; k < static_cast<int>(n); ++k)
      if (A.column(k)[0] == 0) x[k] = 0;
    A.solve(x.data());
    for (Eigen::Index i = 0; i < rows / 3; ++i)
      W.col(c).segment<3>(3 * i) = at(ask.points.place[static_cast<size_t>(i)], x) / (h * h);
  }
  for (Eigen::Index i = 0; i < rows / 3; ++i) {
    const swage_chain_place& p = ask.points.place[static_cast<size_t>(i)];
    v_free.segment<3>(3 * i) = (1 - p.share) * chain.v(p.segment) + p.share * chain.v(p.segment + 1) + at(p, free) / h;
  }
  if (!((W - ask.all.W).cwiseAbs().maxCoeff() <= kBandRounding * ask.all.W.cwiseAbs().maxCoeff())) return say::kBandMobility();
  const double speed = std::max(ask.all.v_free.cwiseAbs().maxCoeff(), 1e-6);
  return (v_free - ask.all.v_free).cwiseAbs().maxCoeff() <= kBandRounding * speed ? "" : say::kBandFree();
}

/// "" where displace() with a random change moves each vertex by it, and gives the velocity of that motion.
std::string goes_by_change(BandAsk& ask, BandMatrix& A) {
  const scene::World saved = ask.world;
  const scene::ChainView before(saved, saved.chain[ask.chain]);
  base::Xoshiro256 random(ask.seed);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(A.size());
  for (int k = 0; k < A.size(); ++k)
    if (k % SWAGE_BAND_UNKNOWNS < 3 && A.column(k)[0] != 0) q[k] = kTriedChange * random.uniform(-1, 1);
  const std::vector<double> none(size_t{3} * ask.points.size(), 0.0);
  std::string wrong = ask.call(host::Call::kDisplace, [&] {
    return ask.table.displace(ask.raw(), ask.view(), q.data(), ask.points.size(), ask.points.point.data(), ask.points.place.data(),
                              none.data());
  });
  double off = 0, faster = 0;
  const scene::ChainView after(ask.world, ask.world.chain[ask.chain]);
  for (uint32_t i = 0; i < after.vertices() && wrong.empty(); ++i) {
    const Vec3 change = q.segment<3>(SWAGE_BAND_UNKNOWNS * i);
    const Vec3 way = after.p(i) - before.p(i) - change, speed = after.v(i) - before.v(i) - change / ask.world.dt;
    if (!way.allFinite() || !speed.allFinite()) wrong = say::kDisplaceNotFinite();
    off = std::max(off, way.norm()), faster = std::max(faster, speed.norm() * ask.world.dt);
  }
  ask.world = saved;
  if (!wrong.empty()) return wrong;
  if (off > kGoesWithin * kTriedChange) return say::kDisplaceOff();
  return faster > kGoesWithin * kTriedChange ? say::kDisplaceSpeed() : "";
}

}  // namespace

std::string check_band(BandAsk& ask) {
  const int n = SWAGE_BAND_UNKNOWNS * static_cast<int>(scene::ChainView(ask.world, ask.world.chain[ask.chain]).vertices());
  BandMatrix A(n);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
  if (std::string wrong = factor_band(ask, A, gradient); !wrong.empty()) return wrong;
  if (std::string wrong = same_as_solver(ask, A, gradient); !wrong.empty()) return wrong;
  return goes_by_change(ask, A);
}

}  // namespace swage::tools
