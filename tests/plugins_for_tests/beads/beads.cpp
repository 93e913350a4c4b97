// SPDX-License-Identifier: Apache-2.0
//
// Beads on springs, joined by a chain that only shows where they are: the smallest object with a chain. Each bead is a point mass,
// held at a place that moves at a steady speed; a contact on a piece moves the two beads at its ends.
//
// Motion of bead v, x from its rest place, by backward Euler over h:
//
//   a v1 = m v0 + h (m g - k x0 + c v_rest) + sum w j,    a = m + h c + h^2 k
//
// A point on piece i at share t has the weights w = 1 - t on bead i and t on bead i + 1, so W_pq = sum_v w_pv w_qv / a.
#include <swage/object.hpp>

#include <algorithm>
#include <array>

#include "toolkit/math.hpp"

namespace swage::test {

using toolkit::Vec3;

struct BeadsParams {
  int vertices = 11;
  double length = 2e-3;      // m
  double radius = 25e-6;     // m
  double mass = 1e-8;        // kg, of a bead
  double stiffness = 0;      // N/m
  double damping = 1e-5;     // N s/m
  double speed = 0;          // m/s, of the rest places along x
};

class Beads final : public Object<BeadsParams>, public Solid, public ChainSolver {
 public:
  static constexpr auto id = "test.object.beads", version = "1.0.0", name = "Beads on springs",
                        summary = "Point masses on springs, joined by a chain.", author = "Swage",
                        licence = "Apache-2.0";
  using P = BeadsParams;
  static constexpr std::array fields{
      integer<&P::vertices>("vertices", "Vertices", 2, 60, "Of the chain."),
      real<&P::length>("length", "Length", "m", "mm", 1e-4, 1e-1, "Along x."),
      real<&P::radius>("radius", "Radius", "m", "um", 1e-6, 1e-3, "Of the chain."),
      real<&P::mass>("mass", "Mass", "kg", "mg", 1e-12, 1e-3, "Of a bead."),
      real<&P::stiffness>("stiffness", "Stiffness", "N/m", "N/m", 0, 1e5, "Of the spring of a bead."),
      real<&P::damping>("damping", "Damping", "N*s/m", "N*s/m", 0, 10, "Of a bead against its rest place."),
      real<&P::speed>("speed", "Speed", "m/s", "mm/s", -1, 1, "Of the rest places, along x."),
  };

  void build(const P& p, Builder& b) override {
    n_ = static_cast<uint32_t>(p.vertices);
    std::vector<double> p_B(3 * n_), radius(n_ - 1, p.radius);
    for (uint32_t i = 0; i < n_; ++i) p_B[3 * i] = p.length * i / (n_ - 1);
    body_ = b.flexible_body("beads");
    first_ = b.n_state();
    b.state(ChainState::doubles(n_));
    rest_ = b.n_state();
    b.state(3 * n_);
    b.chain(host_extension<swage_host_chain>(SWAGE_HOST_CHAIN), body_,
            {SWAGE_CHAIN_SEGMENTS, n_, p_B.data(), nullptr, radius.data(), 2 * p.radius, first_, 0});
  }

  void reset(const Step& step) override {
    const ChainState chain = step.chain(first_, n_);
    std::copy(chain.p_W.begin(), chain.p_W.end(), step.state().begin() + rest_);
  }

  void advance(const Step& step) override {
    const P& p = params();
    const double h = step.dt(), per_a = 1 / a(h);
    const ChainState chain = step.chain(first_, n_);
    double* rest = step.state().data() + rest_;
    const Vec3 g = toolkit::vec(step.gravity()), drive(p.speed, 0, 0);
    for (uint32_t i = 0; i < n_; ++i) {
      Eigen::Map<Vec3> x(chain.p_W.data() + 3 * i), v(chain.v_W.data() + 3 * i), x_rest(rest + 3 * i);
      x_rest += h * drive;
      const Vec3 load = p.mass * g - p.stiffness * (x - x_rest) + p.damping * drive;
      v = per_a * (p.mass * v + h * load).eval();
      x += h * v;
    }
  }

  void mobility(const Step& step, std::span<const swage_contact_point> points,
                  std::span<const swage_chain_place> place, double* v_free, double* W) override {
    const ChainState chain = step.chain(first_, n_);
    const size_t n = points.size();
    const double per_a = 1 / a(step.dt());
    std::fill_n(W, 9 * n * n, 0.0);
    for (size_t i = 0; i < n; ++i) {
      const auto w_i = weights(place[i]);
      for (size_t k = 0; k < 3; ++k)
        v_free[3 * i + k] = w_i[0] * chain.v_W[3 * place[i].segment + k] +
                            w_i[1] * chain.v_W[3 * place[i].segment + 3 + k];
      for (size_t j = 0; j < n; ++j) {
        const auto w_j = weights(place[j]);
        double sum = 0;
        for (uint32_t p = 0; p < 2; ++p)
          for (uint32_t q = 0; q < 2; ++q)
            if (place[i].segment + p == place[j].segment + q) sum += w_i[p] * w_j[q];
        for (size_t k = 0; k < 3; ++k) W[(3 * i + k) * 3 * n + 3 * j + k] = per_a * sum;
      }
    }
  }

  void apply_impulses(const Step& step, std::span<const swage_contact_point> points,
             std::span<const swage_chain_place> place, const double* impulse) override {
    const ChainState chain = step.chain(first_, n_);
    const double h = step.dt(), per_a = 1 / a(h);
    for (size_t i = 0; i < points.size(); ++i) {
      const auto w = weights(place[i]);
      for (uint32_t p = 0; p < 2; ++p)
        for (size_t k = 0; k < 3; ++k) {
          const size_t at = 3 * (place[i].segment + p) + k;
          const double dv = w[p] * per_a * impulse[3 * i + k];
          chain.v_W[at] += dv;
          chain.p_W[at] += h * dv;
        }
    }
  }

 private:
  double a(double h) const {
    return params().mass + h * params().damping + h * h * params().stiffness;
  }
  static std::array<double, 2> weights(const swage_chain_place& place) {
    return {1 - place.share, place.share};
  }

  uint32_t n_ = 0, first_ = 0, rest_ = 0;
  Body body_;
};

}  // namespace swage::test

SWAGE_EXPORT(swage::test::Beads)
