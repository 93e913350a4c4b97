// SPDX-License-Identifier: Apache-2.0
//
// A flexible object with a chain (swage.object.solver/2 and swage.object.band/1) and one fault, the value of its parameter `fault`: what
// only the validator finds. Point masses on springs: of a vertex, a v1 = m v0 + h (m g - k x0) + sum w j with a = m + h^2 k.
#include <swage/band.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace {

enum Fault { kGood, kSkew, kPart, kUnwritten, kUnsteady, kForgets, kElsewhere, kBandStiff, kBandFree, kBandIndefinite,
             kBandNan, kBandAborts, kGoesTwice, kGoesStill, kGoesNowhere, kFaults };

constexpr uint32_t kVertices = 9;
constexpr double kMass = 1e-8, kStiffness = 1;  // kg and N/m, of a vertex

struct Params {
  int fault = kGood;
};

class Chain final : public swage::BandedObject<Params>, public swage::Solid {
 public:
  static constexpr auto id = "org.example.bad.chain", version = "1.0.0", name = "Beads on springs",
                        summary = "A flexible object with a chain and a fault.", author = "Swage", licence = "Apache-2.0";
  static constexpr std::array fields{swage::integer<&Params::fault>("fault", "Fault", 0, kFaults - 1, "Which one; 0 is none.")};

  void build(const Params&, Builder& b) override {
    std::array<double, 3 * kVertices> p_B{};
    std::array<double, kVertices - 1> radius{};
    radius.fill(25e-6);
    for (uint32_t i = 0; i < kVertices; ++i) p_B[3 * i] = 2e-4 * i;
    body_ = b.flexible_body("beads");
    b.state(swage::ChainState::doubles(kVertices));
    rest_ = b.n_state();
    b.state(3 * kVertices);
    b.chain(host_extension<swage_host_chain>(SWAGE_HOST_CHAIN), body_,
            {SWAGE_CHAIN_SEGMENTS, kVertices, p_B.data(), nullptr, radius.data(), 5e-5, 0, 0});
  }

  void reset(const swage::Step& step) override {
    const swage::ChainState chain = step.chain(0, kVertices);
    std::copy(chain.p_W.begin(), chain.p_W.end(), step.state().begin() + rest_);
  }

  void advance(const swage::Step& step) override {
    const swage::ChainState chain = step.chain(0, kVertices);
    const swage_vec3& gravity = step.gravity();
    const double g[] = {gravity.x, gravity.y, gravity.z}, h = step.dt();
    for (uint32_t i = 0; i < 3 * kVertices; ++i) {
      const double x = chain.p_W[i] - step.state()[rest_ + i];
      chain.v_W[i] = (kMass * (chain.v_W[i] + h * g[i % 3]) - h * kStiffness * x) / a(h);
      chain.p_W[i] += h * chain.v_W[i];
    }
  }

  void mobility(const swage::Step& step, std::span<const swage_contact_point> points, std::span<const swage_chain_place> place,
                  double* v_free, double* W) override {
    const swage::ChainState chain = step.chain(0, kVertices);
    const size_t n = 3 * points.size();
    ++asked_;
    for (size_t i = 0; i < n; ++i) {
      const swage_chain_place& p = place[i / 3];
      const size_t at = 3 * p.segment + i % 3;
      v_free[i] = (1 - p.share) * chain.v_W[at] + p.share * chain.v_W[at + 3];
      for (size_t k = 0; k < n && !(is(kUnwritten) && i + 1 == n); ++k) {
        double w = i % 3 == k % 3 ? shared(p, place[k / 3]) / a(step.dt()) : 0;
        if (is(kSkew) && i == 0 && k == 1) w = 0.3 / a(step.dt());
        if (is(kPart)) w /= static_cast<double>(n);
        if (is(kUnsteady)) w *= 1 + 1e-6 * static_cast<double>(asked_ % 2);
        W[i * n + k] = w;
      }
    }
  }

  void apply_impulses(const swage::Step& step, std::span<const swage_contact_point> points, std::span<const swage_chain_place> place,
             const double* impulse) override {
    const swage::ChainState chain = step.chain(0, kVertices);
    for (size_t i = 0; i < 3 * points.size() && !is(kForgets); ++i) {
      swage_chain_place p = place[i / 3];
      if (is(kElsewhere)) p.share = 0;
      const size_t at = 3 * p.segment + i % 3;
      const double dv = impulse[i] / a(step.dt());
      push(step, chain, at, (1 - p.share) * dv);
      push(step, chain, at + 3, p.share * dv);
    }
  }

  // a step of beads is linear: at its end the gradient is 0. Beads do not turn: the diagonal of a rotation stays 0
  void linearise(const swage::Step& step, uint32_t, double* stiffness, double* gradient) override {
    if (is(kBandAborts)) std::abort();
    const double h = step.dt(), sign = is(kBandIndefinite) ? -1 : is(kBandStiff) ? 2 : 1;
    for (uint32_t i = 0; i < kVertices; ++i)
      for (uint32_t k = 0; k < 3; ++k) {
        stiffness[(SWAGE_BAND_UNKNOWNS * i + k) * SWAGE_BAND_COLUMN] = sign * a(h) / (h * h);
        if (is(kBandFree)) gradient[SWAGE_BAND_UNKNOWNS * i + k] = 1e-3;  // N
        if (is(kBandNan)) gradient[SWAGE_BAND_UNKNOWNS * i + k] = std::numeric_limits<double>::quiet_NaN();
      }
  }
  void displace(const swage::Step& step, const double* change, std::span<const swage_contact_point>, std::span<const swage_chain_place>,
                const double*) override {
    const swage::ChainState chain = step.chain(0, kVertices);
    for (uint32_t i = 0; i < 3 * kVertices; ++i) {
      const double way = change[SWAGE_BAND_UNKNOWNS * (i / 3) + i % 3] * (is(kGoesTwice) ? 2 : is(kGoesNowhere) ? HUGE_VAL : 1);
      push(step, chain, i, way / step.dt());
      if (is(kGoesStill)) chain.v_W[i] = 0;
    }
  }

 private:
  bool is(Fault fault) const { return params().fault == fault; }
  static double a(double h) { return kMass + h * h * kStiffness; }
  static void push(const swage::Step& step, const swage::ChainState& chain, size_t at, double dv) {
    chain.v_W[at] += dv;
    chain.p_W[at] += step.dt() * dv;
  }
  // sum over the vertices of the weights of both places
  static double shared(const swage_chain_place& p, const swage_chain_place& q) {
    const double of_p[] = {1 - p.share, p.share}, of_q[] = {1 - q.share, q.share};
    double sum = 0;
    for (uint32_t i = 0; i < 2; ++i)
      for (uint32_t k = 0; k < 2; ++k)
        if (p.segment + i == q.segment + k) sum += of_p[i] * of_q[k];
    return sum;
  }

  swage::Body body_;
  uint32_t rest_ = 0;
  uint64_t asked_ = 0;
};

}  // namespace

SWAGE_EXPORT(Chain)
