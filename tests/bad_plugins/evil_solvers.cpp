// SPDX-License-Identifier: Apache-2.0
//
// Flexible objects with one fault each, for the validator: ID = org.example.bad.solver.<fault>, compiled once per FAULT. A ball on a
// spring that cannot turn: v = v_free + sum j / m, so that W is I / m in every block. Through the wrapper, which such faults pass.
#include <swage/abi/band.h>
#include <swage/object.hpp>

#include <cstdlib>
#include <limits>
#include <type_traits>

namespace {

enum Fault {
  kGood, kSkew, kPulls, kUnsteady, kPart, kUnwritten, kForgets, kDoubles, kStands, kInfinite, kAborts, kDents, kUnseen, kMany, kMeddles, kNearest,
  kSurface, kUnsteadySurface, kBandless
};

constexpr double kMass = 1e-6, kStiffness = 1;  // kg, N/m
struct State {
  swage_vec3 rest;
};

/// Of a fault that has no surface of its own.
struct NoSurface {
  virtual ~NoSurface() = default;
  virtual void displacement(const swage::Step&, std::span<const swage_contact_point>, double*) {}
};
template <Fault F>
using Skin = std::conditional_t<F == kSurface || F == kUnsteadySurface, swage::Surface, NoSurface>;

template <Fault F>
class Ball final : public swage::Object<>, public swage::Solid, public swage::Solver, public swage::Drawing, public swage::Graspable,
                   public Skin<F> {
 public:
  static constexpr auto id = ID, version = "1.0.0", name = "Ball on a spring", summary = "A flexible object with a fault.",
                        author = "Swage", licence = "Apache-2.0";

  void build(const swage::NoParams&, Builder& b) override {
    body_ = b.flexible_body("ball");
    b.sphere(body_, {0, 0, 0}, 1e-3);
    b.state<State>();
  }
  void reset(const swage::Step& step) override { step.state<State>().rest = step.pose(body_).p; }

  void advance(const swage::Step& step) override {
    const swage_vec3 &rest = step.state<State>().rest, &p = step.pose(body_).p, &g = step.gravity();
    swage_vec3& v = step.twist(body_).v;
    const double h = step.dt(), a = kMass + h * h * kStiffness;
    const auto next = [&](double v0, double x, double gravity) { return (kMass * (v0 + h * gravity) - h * kStiffness * x) / a; };
    v = {next(v.x, p.x - rest.x, g.x), next(v.y, p.y - rest.y, g.y), next(v.z, p.z - rest.z, g.z)};
    free_ = v;
    start_ = p;
    move(step, v);
  }

  void mobility(const swage::Step& step, std::span<const swage_contact_point> points, double* v_free, double* W) override {
    if (F == kAborts) std::abort();
    const double h = step.dt(), per = 1 / (kMass + h * h * kStiffness);
    const size_t n = 3 * points.size();
    ++asked_;
    for (size_t i = 0; i < n; ++i) {
      const double v[] = {free_.x, free_.y, free_.z};
      v_free[i] = F == kStands ? 0.5 : v[i % 3];
      for (size_t k = 0; k < n && !(F == kUnwritten && i + 1 == n); ++k) {
        double w = i % 3 == k % 3 ? per : 0;
        if (F == kPulls) w = -w;
        if (F == kUnsteady) w *= 1 + 1e-6 * static_cast<double>(asked_ % 2);
        if (F == kPart) w /= static_cast<double>(n);
        if (F == kSkew && i == 0 && k == 1) w = 0.3 * per;
        W[i * n + k] = w;
      }
    }
  }

  void apply_impulses(const swage::Step& step, std::span<const swage_contact_point> points, const double* impulse) override {
    const double h = step.dt();
    const double scale = F == kForgets ? 0 : F == kDoubles ? 2 : 1;
    const double per = scale / (kMass + h * h * kStiffness);
    swage_vec3 v = free_;
    for (size_t i = 0; i < points.size(); ++i)
      v = {v.x + per * impulse[3 * i], v.y + per * impulse[3 * i + 1], v.z + per * impulse[3 * i + 2]};
    if (F == kInfinite) v.x = std::numeric_limits<double>::infinity();
    move(step, v);
  }

  void displacement(const swage::Step&, std::span<const swage_contact_point> points, double* u_W) override {
    ++asked_;
    for (size_t i = 0; i < 3 * points.size() && !(F == kSurface && i > 0); ++i)
      u_W[i] = F == kUnsteadySurface ? 1e-6 * static_cast<double>(asked_ % 2) : 0;
  }

  // a chain is what a band is about, and a ball has none
  const void* extension(std::string_view wanted) override {
    static constexpr swage_band band{
        [](swage_instance*, const swage_object_step*, uint32_t, double*, double*) -> swage_result { return SWAGE_OK; },
        [](swage_instance*, const swage_object_step*, const double*, uint32_t, const swage_contact_point*, const swage_chain_place*,
           const double*) -> swage_result { return SWAGE_OK; }};
    return F == kBandless && wanted == SWAGE_EXT_BAND ? &band : nullptr;
  }

  void draw(const swage::Step& step, swage::Visuals& out) override {
    if (F == kDents) out.dent({0, 0, 0}, {0, 0, std::numeric_limits<double>::quiet_NaN()}, 1e-3);
    if (F == kUnseen) out.dent({0, 0, 0}, {0, 0, 1e-4}, 1e-3);
    for (int i = 0; F == kMany && i < 200; ++i) out.line({0, 0, 0}, {0, 0, 1e-3}, 0);
    if (F == kMeddles) step.state<State>().rest.x += 1e-6;
  }
  void locate(const swage::Step& step, swage_vec3, swage_graspable_place& out) override {
    out = {0.5, 1e-3, step.pose(body_).p, {1, 0, 0}, {0, 1, 0}};
    if (F == kNearest) out.tangent_W = {2, 0, 0};
  }

 private:
  void move(const swage::Step& step, const swage_vec3& v) {
    const double h = step.dt();
    step.twist(body_) = {v, {0, 0, 0}};
    step.pose(body_).p = {start_.x + h * v.x, start_.y + h * v.y, start_.z + h * v.z};
  }

  swage::Body body_;
  swage_vec3 free_{}, start_{};  // of this step, from advance() on
  uint64_t asked_ = 0;
};

}  // namespace

SWAGE_EXPORT(Ball<FAULT>)
