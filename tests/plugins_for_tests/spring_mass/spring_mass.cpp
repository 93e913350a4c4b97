// SPDX-License-Identifier: Apache-2.0
//
// A ball held at a rest pose by a spring and by a torsion spring; it yields to contact. The smallest object with mechanics
// of its own.
//
// Motion of the centre, x from the rest place, by backward Euler over h (and likewise, with inertia J, for the rotation
// vector theta from the rest attitude, small angles):
//
//   m (v1 - v0) = h (m g + f - k x1 - c v1) + sum j,    x1 = x0 + h v1
//   =>  a v1 = m v0 + h (m g + f - k x0) + sum j,       a = m + h c + h^2 k
//
// So v1 = v_free + sum j / a, and with the arms r_i from the centre to the points, u_i = v + w x r_i gives
//
//   W_ij = 1/a I - 1/b [r_i] [r_j],                     b = J + h c_t + h^2 k_t,   [r] y = r x y
#include <swage/object.hpp>

#include "toolkit/math.hpp"

namespace swage::test {

using toolkit::Vec3;

struct SpringMassParams {
  double radius = 0.5e-3;           // m
  double mass = 1e-6;               // kg
  double stiffness = 1;             // N/m
  double damping = 1e-4;            // N s/m
  double torsion_stiffness = 1e-7;  // N m / rad
  double torsion_damping = 1e-11;   // N m s / rad
};

class SpringMass final : public Object<SpringMassParams>, public Solid, public Solver {
 public:
  static constexpr auto id = "test.object.spring_mass", version = "1.0.0", name = "Ball on springs",
                        summary = "Rigid ball held by a spring and a torsion spring; small angles.",
                        author = "Swage", licence = "Apache-2.0";
  using P = SpringMassParams;
  static constexpr std::array fields{
      real<&P::radius>("radius", "Radius", "m", "mm", 1e-5, 1e-2, "Of the ball."),
      real<&P::mass>("mass", "Mass", "kg", "g", 1e-9, 1e-2, "Of the ball, evenly spread."),
      real<&P::stiffness>("stiffness", "Stiffness", "N/m", "N/m", 0, 1e5,
                          "Of the spring, in every direction."),
      real<&P::damping>("damping", "Damping", "N*s/m", "N*s/m", 0, 10, "Of the spring."),
      real<&P::torsion_stiffness>("torsion_stiffness", "Torsion stiffness", "N*m/rad", "N*m/rad", 0, 1,
                                  "Of the torsion spring, about every axis."),
      real<&P::torsion_damping>("torsion_damping", "Torsion damping", "N*m*s/rad", "N*m*s/rad", 0, 1,
                                "Of the torsion spring."),
  };

  struct State {
    swage_pose rest;  // X_WB without load
    swage_vec3 x, v, theta, w;
  };

  void build(const P& p, Builder& b) override {
    body_ = b.flexible_body("ball");
    b.sphere(body_, {0, 0, 0}, p.radius);
    b.state<State>();
    stretch_ = b.signal("stretch", "m", "Distance from the rest place.");
  }

  void reset(const Step& step) override {
    step.state<State>() = {};
    step.state<State>().rest = step.pose(body_);
  }

  void advance(const Step& step) override {
    const P& p = params();
    const double h = step.dt();
    State& s = step.state<State>();
    const swage_wrench& load = step.wrench(body_);
    const Vec3 f =
        p.mass * toolkit::vec(step.gravity()) + toolkit::vec(load.f) - p.stiffness * toolkit::vec(s.x);
    const Vec3 t = toolkit::vec(load.t) - p.torsion_stiffness * toolkit::vec(s.theta);
    const Vec3 v = (p.mass * toolkit::vec(s.v) + h * f) / a(h);
    const Vec3 w = (inertia() * toolkit::vec(s.w) + h * t) / b(h);
    move(step, v - toolkit::vec(s.v), w - toolkit::vec(s.w), h * v, h * w);
  }

  void mobility(const Step& step, std::span<const swage_contact_point> points, double* v_free,
                  double* W) override {
    const double per_a = 1 / a(step.dt()), per_b = 1 / b(step.dt());
    const size_t n = points.size();
    for (size_t i = 0; i < n; ++i) {
      const Vec3 r_i = arm(step, points[i]);
      const Vec3 u = toolkit::vec(step.twist(body_).v) + toolkit::vec(step.twist(body_).w).cross(r_i);
      for (size_t k = 0; k < 3; ++k) v_free[3 * i + k] = u[static_cast<int>(k)];
      for (size_t j = 0; j < n; ++j) {
        const Vec3 r_j = arm(step, points[j]);
        const toolkit::Mat3 block =
            per_a * toolkit::Mat3::Identity() - per_b * toolkit::skew(r_i) * toolkit::skew(r_j);
        for (size_t row = 0; row < 3; ++row)
          for (size_t column = 0; column < 3; ++column)
            W[(3 * i + row) * 3 * n + 3 * j + column] =
                block(static_cast<int>(row), static_cast<int>(column));
      }
    }
  }

  void apply_impulses(const Step& step, std::span<const swage_contact_point> points, const double* impulse) override {
    const double h = step.dt();
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec3 j(impulse[3 * i], impulse[3 * i + 1], impulse[3 * i + 2]);
      sum += j;
      moment += arm(step, points[i]).cross(j);
    }
    move(step, sum / a(h), moment / b(h), h * sum / a(h), h * moment / b(h));
  }

  void finish(const Step& step) override {
    step.signal(stretch_, toolkit::vec(step.state<State>().x).norm());
  }

 private:
  double inertia() const { return 0.4 * params().mass * params().radius * params().radius; }  // kg m2
  double a(double h) const { return params().mass + h * params().damping + h * h * params().stiffness; }
  double b(double h) const {
    return inertia() + h * params().torsion_damping + h * h * params().torsion_stiffness;
  }

  // contacts are found after advance(), so arms count from where it has put the centre
  Vec3 arm(const Step& step, const swage_contact_point& point) const {
    return toolkit::vec(point.p_W) - toolkit::vec(step.pose(body_).p);
  }

  void move(const Step& step, const Vec3& dv, const Vec3& dw, const Vec3& dx, const Vec3& dtheta) {
    State& s = step.state<State>();
    s.v = toolkit::raw(toolkit::vec(s.v) + dv);
    s.w = toolkit::raw(toolkit::vec(s.w) + dw);
    s.x = toolkit::raw(toolkit::vec(s.x) + dx);
    s.theta = toolkit::raw(toolkit::vec(s.theta) + dtheta);
    const toolkit::Quat turn = toolkit::exp_rotation(toolkit::vec(s.theta));
    step.pose(body_) = {toolkit::raw(toolkit::vec(s.rest.p) + toolkit::vec(s.x)),
                        toolkit::raw(turn * toolkit::quat(s.rest.q))};
    step.twist(body_) = {s.v, s.w};
  }

  Body body_;
  Signal stretch_;
};

}  // namespace swage::test

SWAGE_EXPORT(swage::test::SpringMass)
