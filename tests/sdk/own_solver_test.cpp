// SPDX-License-Identifier: Apache-2.0
//
// The own-solver extension has the right shape: a ball on springs, loaded from its library and used through the C tables
// alone, moves, answers for its mobility and yields as its closed forms say.
//
// Closed forms (derivation in spring_mass.cpp; m mass, J = 2/5 m R^2, k, c spring, k_t, c_t torsion, h step):
//   a = m + h c + h^2 k,  b = J + h c_t + h^2 k_t
//   v_free = (m v0 + h (m g - k x0)) / a,  w_free = (J w0 - h k_t theta0) / b
//   W_ij = 1/a I - 1/b [r_i] [r_j], so that v_i = v_free_i + sum_j W_ij j_j exactly.
// W = G M^-1 G^T with rows G_i = (I, -[r_i]) and M = diag(a I, b I): symmetric and positive semi-definite, of rank 6 at most.
#include <gtest/gtest.h>
#include <swage/abi/object.h>
#include <swage/testbed/bench.hpp>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "loaded_plugin.hpp"
#include "toolkit/math.hpp"

namespace swage::test {
namespace {

using toolkit::Mat3;
using toolkit::Vec3;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// The ball, with the values of its six parameters.
struct Ball {
  double radius = 0.5e-3, mass = 1e-6, k = 1, c = 1e-4, k_t = 1e-7, c_t = 1e-11;
  double h = 1e-3;
  testbed::Host host;
  testbed::Declared builder;
  swage_instance* raw = nullptr;
  const swage_object* object = nullptr;
  const swage_solver* solver = nullptr;
  swage_pose pose{{1e-3, 2e-3, 3e-3}, {1, 0, 0, 0}};
  swage_twist twist{};
  swage_wrench wrench{};
  std::vector<double> state;
  double signal = 0;
  swage_object_step step{};

  void start() {
    static const swage_entry* entry = load_entry(SWAGE_SPRING_MASS);
    ASSERT_NE(entry, nullptr);
    raw = instances_of(*entry).create(&host.raw, "test.object.spring_mass");
    ASSERT_NE(raw, nullptr);
    swage_value value[6] = {};
    const double number[6] = {radius, mass, k, c, k_t, c_t};
    for (int i = 0; i < 6; ++i) value[i].number[0] = number[i];
    const swage_values values{sizeof(swage_values), 6, value, {"ball", 4}};
    ASSERT_EQ(raw->configure(raw, &values, &builder.raw), SWAGE_OK);
    ASSERT_EQ(builder.bodies.size(), 1u);
    ASSERT_EQ(builder.bodies[0].motion, SWAGE_MOTION_FLEXIBLE);
    object = static_cast<const swage_object*>(raw->get_extension(raw, SWAGE_EXT_OBJECT));
    solver = static_cast<const swage_solver*>(raw->get_extension(raw, SWAGE_EXT_SOLVER));
    ASSERT_TRUE(object != nullptr && solver != nullptr);
    ASSERT_EQ(raw->activate(raw, h), SWAGE_OK);

    state.assign(builder.n_state, 0);
    step.struct_size = sizeof step;
    step.dt_s = h;
    step.X_WB = &pose;
    step.V_WB = &twist;
    step.F_B_W = &wrench;
    step.state = state.data();
    step.signal = &signal;
    step.n_body = step.n_signal = 1;
    step.n_state = builder.n_state;
    host.role = SWAGE_THREAD_RT;
    object->reset(raw, &step);
  }
  ~Ball() {
    host.role = SWAGE_THREAD_MAIN;
    if (raw != nullptr) raw->deactivate(raw);
    if (raw != nullptr) raw->destroy(raw);
    EXPECT_TRUE(host.faults.empty());
  }

  double inertia() const { return 0.4 * mass * radius * radius; }
  double a() const { return mass + h * c + h * h * k; }
  double b() const { return inertia() + h * c_t + h * h * k_t; }
  Vec3 centre() const { return toolkit::vec(pose.p); }
  Vec3 velocity_at(const Vec3& r) const { return toolkit::vec(twist.v) + toolkit::vec(twist.w).cross(r); }

  void advance() { ASSERT_EQ(solver->advance(raw, &step), SWAGE_OK); }
  void mobility(const std::vector<swage_contact_point>& points, Vector& v_free, Matrix& W) {
    const auto n = static_cast<uint32_t>(points.size());
    v_free = Vector::Constant(3 * n, NAN);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(3 * n, 3 * n);
    rows.setConstant(NAN);
    ASSERT_EQ(solver->mobility(raw, &step, n, points.data(), v_free.data(), rows.data()), SWAGE_OK);
    W = rows;
  }
  void apply_impulses(const std::vector<swage_contact_point>& points, const Vector& impulse) {
    ASSERT_EQ(solver->apply_impulses(raw, &step, static_cast<uint32_t>(points.size()), points.data(), impulse.data()),
              SWAGE_OK);
  }
};

/// Points on the surface of the ball, seeded.
std::vector<swage_contact_point> surface_points(const Ball& ball, int n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<swage_contact_point> points;
  for (int i = 0; i < n; ++i) {
    const Vec3 out = Vec3(normal(random), normal(random), normal(random)).normalized();
    points.push_back({0, 0, toolkit::raw(ball.centre() + ball.radius * out), toolkit::raw(Vec3(-out))});
  }
  return points;
}

/// Sum of the impulses of all points.
Vec3 impulse_sum(const Vector& impulse) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < impulse.size() / 3; ++i) sum += impulse.segment<3>(3 * i);
  return sum;
}

/// A ball that is stretched, turned and moving.
void stir(Ball& ball) {
  ball.wrench = {{2e-4, -1e-4, 3e-4}, {1e-9, 2e-9, -1e-9}};
  for (int i = 0; i < 20; ++i) ball.advance();
  ball.wrench = {};
}

TEST(OwnSolver, compliance_is_the_closed_form) {
  std::mt19937 random(1);
  Ball ball;
  ball.start();
  stir(ball);
  ball.advance();
  const auto points = surface_points(ball, 5, random);
  Vector v_free;
  Matrix W;
  ball.mobility(points, v_free, W);
  for (int i = 0; i < 5; ++i) {
    const Vec3 r_i = toolkit::vec(points[static_cast<size_t>(i)].p_W) - ball.centre();
    EXPECT_LT((v_free.segment<3>(3 * i) - ball.velocity_at(r_i)).norm(), 1e-14 * v_free.norm());
    for (int j = 0; j < 5; ++j) {
      const Vec3 r_j = toolkit::vec(points[static_cast<size_t>(j)].p_W) - ball.centre();
      const Mat3 block = Mat3::Identity() / ball.a() - toolkit::skew(r_i) * toolkit::skew(r_j) / ball.b();
      EXPECT_LT((W.block<3, 3>(3 * i, 3 * j) - block).norm(), 1e-13 * W.norm()) << i << " " << j;
    }
  }
}

TEST(OwnSolver, compliance_is_symmetric_and_positive_semi_definite) {
  std::mt19937 random(2);
  for (int n = 1; n <= 10; ++n) {
    Ball ball;
    ball.start();
    stir(ball);
    ball.advance();
    Vector v_free;
    Matrix W;
    ball.mobility(surface_points(ball, n, random), v_free, W);
    EXPECT_LT((W - W.transpose()).norm(), 1e-15 * W.norm());
    const Vector values = Eigen::SelfAdjointEigenSolver<Matrix>(W).eigenvalues();  // ascending
    EXPECT_GT(values[0], -1e-14 * values[3 * n - 1]);
    const int rank = static_cast<int>((values.array() > 1e-9 * values[3 * n - 1]).count());
    // one point moves in 3 ways; two in 6 less the one that would stretch the ball between them; more in all 6
    EXPECT_EQ(rank, n == 1 ? 3 : n == 2 ? 5 : 6) << n << " points";
  }
}

TEST(OwnSolver, it_moves_as_compliance_promised) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 1e-9);  // N s
  for (int trial = 0; trial < 50; ++trial) {
    Ball ball;
    ball.start();
    stir(ball);
    ball.advance();
    const int n = 1 + trial % 6;
    const auto points = surface_points(ball, n, random);
    const Vec3 centre = ball.centre();
    Vector v_free, impulse(3 * n);
    Matrix W;
    ball.mobility(points, v_free, W);
    for (double& j : impulse) j = normal(random);
    const Vector promised = v_free + W * impulse;
    ball.apply_impulses(points, impulse);
    for (int i = 0; i < n; ++i) {
      const Vec3 r = toolkit::vec(points[static_cast<size_t>(i)].p_W) - centre;
      EXPECT_LT((ball.velocity_at(r) - promised.segment<3>(3 * i)).norm(), 1e-13 * promised.norm());
    }
    // the place follows the velocity
    EXPECT_LT((ball.centre() - centre - ball.h * impulse_sum(impulse) / ball.a()).norm(),
              1e-13 * ball.radius);
  }
}

TEST(OwnSolver, a_step_with_an_impulse_solves_backward_euler) {
  std::mt19937 random(4);
  Ball ball;
  ball.start();
  stir(ball);
  const Vec3 rest(1e-3, 2e-3, 3e-3), x0 = ball.centre() - rest, v0 = toolkit::vec(ball.twist.v);
  ball.step.gravity = {0, 0, -9.80665};
  ball.advance();
  const auto points = surface_points(ball, 2, random);
  Vector impulse(6);
  impulse << 1e-9, 2e-9, -3e-9, 5e-10, 0, 1e-9;
  ball.apply_impulses(points, impulse);
  const Vec3 x1 = ball.centre() - rest, v1 = toolkit::vec(ball.twist.v);
  const Vec3 force = ball.mass * Vec3(0, 0, -9.80665) - ball.k * x1 - ball.c * v1;
  const Vec3 momentum = ball.mass * (v1 - v0), pushed = ball.h * force + impulse_sum(impulse);
  EXPECT_LT((momentum - pushed).norm(), 1e-12 * momentum.norm());
  EXPECT_LT((x1 - x0 - ball.h * v1).norm(), 1e-12 * x1.norm());
}

TEST(OwnSolver, hangs_where_the_spring_balances_gravity) {
  Ball ball;
  ball.c = 2e-3;  // critically damped: 2 sqrt(k m)
  ball.start();
  ball.step.gravity = {0, 0, -9.80665};
  for (int i = 0; i < 1000; ++i) ball.advance();
  const double sag = ball.mass * 9.80665 / ball.k;
  EXPECT_NEAR(ball.pose.p.z, 3e-3 - sag, 1e-12 * sag);
  ASSERT_EQ(ball.object->finish(ball.raw, &ball.step), SWAGE_OK);
  EXPECT_NEAR(ball.signal, sag, 1e-12 * sag);
}

/// Undamped and pushed to the speed v: x = v / omega sin(omega t) is v / omega a quarter of a period later. Backward Euler
/// shrinks the amplitude by a factor 1 - h omega^2 t / 2, so its error is of first order there.
double error_after_a_quarter(int steps) {
  Ball ball;
  ball.c = 0;
  const double omega = std::sqrt(ball.k / ball.mass);
  ball.h = 0.5 * M_PI / omega / steps;
  ball.start();
  ball.advance();  // at rest: nothing moves
  const swage_contact_point top{0, 0, ball.pose.p, {0, 0, -1}};
  Vector impulse(3);
  impulse << ball.a() * 1e-2, 0, 0;  // leaves it at 1 cm/s
  ball.apply_impulses({top}, impulse);
  for (int i = 1; i < steps; ++i) ball.advance();
  return std::abs((ball.pose.p.x - 1e-3) / (1e-2 / omega) - 1);
}

TEST(OwnSolver, converges_to_the_harmonic_motion_at_first_order) {
  const double coarse = error_after_a_quarter(1000), fine = error_after_a_quarter(2000);
  EXPECT_NEAR(fine, 0.5 * (0.5 * M_PI) * (0.5 * M_PI) / 2000, 0.05 * fine);
  EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.05);
}

TEST(OwnSolver, the_host_holds_its_whole_state) {
  Ball ball;
  ball.start();
  stir(ball);
  const auto saved = ball.state;
  const swage_pose pose = ball.pose;
  const swage_twist twist = ball.twist;
  for (int i = 0; i < 50; ++i) ball.advance();
  const auto once = ball.state;
  ball.state = saved;
  ball.step.state = ball.state.data();
  ball.pose = pose;
  ball.twist = twist;
  for (int i = 0; i < 50; ++i) ball.advance();
  EXPECT_EQ(ball.state, once);  // to the bit
  ball.object->reset(ball.raw, &ball.step);
  EXPECT_EQ(ball.state[7], 0);
}

}  // namespace
}  // namespace swage::test
