// SPDX-License-Identifier: Apache-2.0
//
// swage.object.tissue: shape of the wall, compliance against closed forms, relaxation, and the tables that the host calls.
#include "plugins/tissue/tissue.hpp"

#include <gtest/gtest.h>
#include <swage/testbed.hpp>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>

#include "pressed_tissue.hpp"
#include "test_places.hpp"

namespace swage::tissue {
namespace {

constexpr double kPi = M_PI, kDeg = M_PI / 180;

// Boussinesq and Cerruti for nu = 1/2, r from the point of load: u_n = F / (4 pi G r), along the load 2 F / (4 pi G r), beside it half
// of that (Johnson, Contact Mechanics, 3.2 and 3.6)
TEST(Compliance, FarAwayIsThatOfAPointOnAHalfSpace) {
  const double G = 3e5, r = 5e-3;
  const Compliance c({G, 20e-6, 0, 0});
  const Mat3 C = c.between(r, 0);
  const double unit = 1 / (4 * kPi * G * r);
  EXPECT_NEAR(C(0, 0), unit, 1e-4 * unit);
  EXPECT_NEAR(C(1, 1), 2 * unit, 1e-2 * unit);
  EXPECT_NEAR(C(2, 2), unit, 1e-2 * unit);
  EXPECT_EQ(C(0, 1), 0);
}

// a flat punch of radius a: u = (1 - nu) F / (4 G a)
TEST(Compliance, UnderTheTouchIsThatOfAFlatPunch) {
  const double G = 3e5, a = 50e-6;
  const Compliance c({G, a, 0, 0});
  EXPECT_NEAR(c.normal(0), 0.5 / (4 * G * a), 1e-12 * c.normal(0));
}

// A thin plate on a half space that resists with c k: w(0) = F / (3 sqrt 3 c^(2/3) D^(1/3)) (Hogg 1938; integral of
// dk / (2 pi (c + D k^3))). The touch is spread over a hundredth of the plate's length, which takes off 1.2 %.
TEST(Compliance, WithASkinIsThatOfAPlateOnAHalfSpace) {
  const double G = 1e4, t = 0.3e-3, E = 5e6, D = E * t * t * t / 9, length = std::cbrt(D / (2 * G));
  const double w0 = 1 / (3 * std::sqrt(3.0) * std::pow(2 * G, 2.0 / 3) * std::cbrt(D));
  double error[2];
  for (int i = 0; i < 2; ++i) {
    const Compliance c({G, (i == 0 ? 0.02 : 0.01) * length * kPi / 2, t, E});
    error[i] = std::abs(c.normal(0) - w0) / w0;
    EXPECT_NEAR(c.normal(25 * length), 1 / (4 * kPi * G * 25 * length), 0.01 / (4 * kPi * G * 25 * length));
    for (double r = 0; r < 40 * length; r += 0.37 * length)
      EXPECT_GE(c.normal(r) * 1.0001, c.normal(r + 0.37 * length)) << "it falls off with distance";
  }
  EXPECT_LT(error[1], 0.013);
  EXPECT_LT(error[1], 0.7 * error[0]) << "and comes nearer as the touch gets smaller";
}

TEST(Compliance, IsPositiveWhateverTouchesWhere) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const double skin : {0.0, 0.1e-3}) {
    const Compliance c({2e5, 50e-6, skin, 5e6});
    for (int trial = 0; trial < 50; ++trial) {
      constexpr int n = 12;
      Eigen::Matrix<double, 3 * n, 3 * n> W;
      double p[n][2];
      for (auto& q : p) q[0] = 1e-3 * any(random) * any(random), q[1] = 1e-3 * any(random) * any(random);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          W.block<3, 3>(3 * i, 3 * j) = c.between(p[i][0] - p[j][0], p[i][1] - p[j][1]);
      EXPECT_LT((W - W.transpose()).norm(), 1e-12 * W.norm());
      W.diagonal().array() += (skin > 0 ? 2e-4 : 1e-9) * c.normal(0);  // the table is interpolated
      EXPECT_EQ((Eigen::LLT<decltype(W)>(W).info()), Eigen::Success);
    }
  }
}

// 8.14: under a constant force a standard linear solid creeps as J(t) = 1 + (1/relaxed - 1)(1 - exp(-t relaxed/time)), exactly at any dt
TEST(Creep, IsExactAtAnyStep) {
  const double relaxed = 0.4, time = 0.3, f = 5e-3;
  for (const double dt : {1e-4, 1e-3, 0.05, 0.3}) {
    const Creep creep(relaxed, time, dt);
    double v = 0;
    for (int i = 1; i <= 40; ++i) {
      v = creep.keep * v + creep.gain * f;
      const double expected = f * (1 + (1 / relaxed - 1) * -std::expm1(-i * dt * relaxed / time));
      EXPECT_NEAR(f + v, expected, 1e-12 * expected) << dt;
    }
  }
}

Wall wall(Form form, double slit = 0) {
  WallShape s;
  s.form = form, s.slope = 30 * kDeg, s.wave_height = 1e-3, s.wave_length = 8e-3, s.radius = 8e-3,
  s.slit = slit;
  return Wall(s);
}

TEST(WallShape, KnowsDepthAndNormalOfEachForm) {
  EXPECT_NEAR(wall(Form::kFlat).locate({1e-3, 2e-3, -0.4e-3}).depth, 0.4e-3, 1e-15);
  // a right slope rises with x: along its normal by 1 mm from a place on it
  const Vec3 n(-std::sin(30 * kDeg), 0, std::cos(30 * kDeg)), on(2e-3, 1e-3, 2e-3 * std::tan(30 * kDeg));
  const WallPlace slope = wall(Form::kRightSlope).locate(on + 1e-3 * n);
  EXPECT_NEAR(slope.depth, -1e-3, 1e-12);
  EXPECT_LT((slope.normal - n).norm(), 1e-9);
  EXPECT_LT((slope.foot - on).norm(), 1e-9);
  EXPECT_GT(wall(Form::kLeftSlope).locate({-1e-3, 0, 0}).depth, 0);
  const WallPlace flap = wall(Form::kCylinder).locate({7e-3 * std::sin(0.3), 0, 7e-3 * std::cos(0.3) - 8e-3});
  EXPECT_NEAR(flap.depth, 1e-3, 1e-12);
  EXPECT_NEAR(flap.normal.x(), std::sin(0.3), 1e-9);
  const Wall waves = wall(Form::kWaves);
  for (double x = -5e-3; x < 5e-3; x += 0.7e-3) {
    const Vec3 s(x, 0, waves.height(x, 0));
    const WallPlace place = waves.locate(s - 0.2e-3 * waves.normal(x, 0));
    EXPECT_NEAR(place.depth, 0.2e-3, 2e-6) << x;
  }
}

TEST(WallShape, HasARimAndASlit) {
  const Wall w = wall(Form::kFlat, 0.4e-3);
  EXPECT_NEAR(w.locate({1e-3, 0, 0}).edge, 0.8e-3, 1e-12);
  EXPECT_LT(w.locate({0.1e-3, 0, 0}).edge, 0);
  EXPECT_NEAR(w.locate({5.9e-3, 0, 0}).edge, 0.1e-3, 1e-12);
  EXPECT_EQ(w.pieces(1e-3).size(), 2u);
  EXPECT_EQ(wall(Form::kFlat).pieces(1e-3).size(), 1u);
  EXPECT_GT(wall(Form::kWaves).pieces(1e-3).size(), 10u);
}

// the grid of a smooth wall lies on its surface inside a band along the rim; the frame has the band and the floor
TEST(WallShape, HasASmoothSurfaceInAFrame) {
  for (const Form form : {Form::kWaves, Form::kCylinder}) {
    const Wall w = wall(form);
    const Wall::Grid grid = w.grid(2e-3, 0.5e-3);
    ASSERT_EQ(grid.height.size(), size_t{grid.nx} * grid.ny);
    EXPECT_NEAR(grid.below, 1.5e-3, 1e-15);
    const double band = 0.5 * w.shape().size[0] + grid.x0;
    EXPECT_NEAR(grid.x0 + (grid.nx - 1) * grid.dx, -grid.x0, 1e-12);
    EXPECT_NEAR(grid.y0 + (grid.ny - 1) * grid.dy, -grid.y0, 1e-12);
    for (uint32_t i = 0; i < grid.nx; ++i) {
      EXPECT_NEAR(grid.height[i], w.height(grid.x0 + i * grid.dx, 0), 1e-12);
      // facets that differ by less than 0.03 rad are one face without a ridge (contact/README.md)
      if (i == 0 || i + 1 == grid.nx) continue;
      const double before = std::atan2(grid.height[i] - grid.height[i - 1], grid.dx);
      const double after = std::atan2(grid.height[i + 1] - grid.height[i], grid.dx);
      EXPECT_LT(std::abs(after - before), 0.03) << i;
    }
    size_t in_band = 0;
    for (const Wall::Piece& piece : grid.frame) {
      const Vec3 top = 0.25 * (piece[0] + piece[1] + piece[2] + piece[3]);
      const WallPlace place = w.locate(top);
      const bool beside = std::abs(place.foot.x()) > -grid.x0 || std::abs(place.foot.y()) > -grid.y0;
      in_band += beside;
      EXPECT_NEAR(place.depth, beside ? 0 : 1.5e-3, 0.1 * band) << top.transpose();
    }
    EXPECT_GT(in_band, 10u);
    EXPECT_GT(grid.frame.size(), in_band + 10);
  }
}

TEST(Tissue, IsTouchedSmoothlyWhereItIsCurved) {
  const auto shapes = [](double form, double slit, double backing, std::vector<std::string>* errors) {
    testbed::ObjectBench<Tissue> bench;
    bench.set("form", form);
    bench.set("touched", 1);
    bench.set("slit", slit);
    bench.set("backing", backing);
    bench.start();
    *errors = bench.declared.errors;
    return std::count(bench.declared.shapes.begin(), bench.declared.shapes.end(), SWAGE_SHAPE_HEIGHT_FIELD);
  };
  std::vector<std::string> errors;
  EXPECT_EQ(shapes(4, 0, 1e-3, &errors), 1) << "cylinder";
  EXPECT_TRUE(errors.empty());
  EXPECT_EQ(shapes(3, 0, 1e-3, &errors), 1) << "waves";
  EXPECT_EQ(shapes(0, 0.4e-3, 1e-3, &errors), 0) << "a flat one is smooth as it is";
  EXPECT_TRUE(errors.empty());
  shapes(4, 0.4e-3, 1e-3, &errors);
  EXPECT_EQ(errors.size(), 1u) << "a slit";
  shapes(4, 0, 0, &errors);
  EXPECT_EQ(errors.size(), 1u) << "no backing";
}

TEST(Tissue, ReadsAnyHeightsFromATable) {
  const std::string path = SWAGE_BINARY_DIR "/heights.txt";
  std::ofstream(path) << "3 2\n0 0.001 0\n0 0.001 0\n";
  testbed::ObjectBench<Tissue> bench;
  bench.set("form", 5);
  bench.set_text("heights", path);
  ASSERT_TRUE(bench.start());
  const auto* table = bench.get<swage_pierceable>(SWAGE_TRAIT_PIERCEABLE);
  swage_pierceable_place place{};
  // half way up the roof: x from -6 to 0 mm rises by 1 mm
  ASSERT_EQ(table->locate(bench.raw, &bench.step, {-3e-3, 0, 0.5e-3}, &place), SWAGE_OK);
  EXPECT_NEAR(place.depth, 0, 1e-9);
  EXPECT_NEAR(place.normal_W.x, -std::sin(std::atan(1.0 / 6)), 1e-6);
  for (const char* text : {"", "1 2\n", "3 2\n0 0 0 0 0\n", "3 2\n0 x 0 0 0 0\n"}) {
    std::ofstream(path) << text;
    testbed::ObjectBench<Tissue> wrong;
    wrong.set("form", 5);
    wrong.set_text("heights", path);
    EXPECT_FALSE(wrong.start()) << text;
    EXPECT_FALSE(wrong.declared.errors.empty());
  }
}

TEST(Tissue, YieldsRelaxesAndRemembers) {
  Pressed p;
  const double G = 1e6 / 3, C = 0.5 / (4 * G * 50e-6), F = 5e-3, relaxed = 0.6, time = 0.5;
  Vec3 before = Vec3::Zero();
  for (int i = 1; i <= 3000; ++i) {
    const Vec3 u = p.step({0, 0, -F});
    const double expected = -C * F * (1 + (1 / relaxed - 1) * -std::expm1(-i * 1e-3 * relaxed / time));
    ASSERT_NEAR(u.z(), expected, 1e-9 * C * F) << i;
    ASSERT_NEAR(p.moved.z(), u.z() - before.z(), 1e-9 * C * F) << "the motion of a step is the difference";
    before = u;
  }
  EXPECT_NEAR(p.bench.signal[0], -before.z(), 1e-9 * C * F);
  EXPECT_NEAR(p.bench.signal[1], F, 1e-12);
  // let go: what creep gave comes back with the same time
  const double left = before.z() + C * F;
  double u = 0;
  for (int i = 1; i <= 400; ++i) u = p.step({0, 0, 0}).z();
  EXPECT_NEAR(u, left * std::exp(-0.4 * relaxed / time), 1e-6 * C * F);
  swage_visual dent[4];
  uint32_t n = 0;
  p.bench.get<swage_visuals>(SWAGE_EXT_VISUAL)->draw(p.bench.raw, &p.bench.step, nullptr, 4, dent, &n);
  ASSERT_EQ(n, 1u);
  EXPECT_NEAR(dent[0].b.z - dent[0].a.z, u, 1e-9 * C * F) << "the dent that is drawn is the one that is there";
}

// Elastic tissue remembers nothing but the touch of the step before, and that where it was: a touch that slides finds the same dimple
// everywhere, and the motion of a step is that of the place that is touched now.
TEST(Tissue, ATouchThatSlidesTakesItsDimpleWithIt) {
  Pressed p(1);
  const double G = 1e6 / 3, e = 2 * 50e-6 / kPi, F = 5e-3, C = 1 / (4 * kPi * G * e), step = 3e-6;
  for (int i = 0; i < 30; ++i) {
    p.point.p_W.x = step * i;
    const Vec3 u = p.step({0, 0, -F});
    ASSERT_NEAR(u.z(), -C * F, 1e-9 * C * F) << i;
    const double was = i == 0 ? 0 : 1 / (4 * kPi * G * std::sqrt(step * step + e * e));
    ASSERT_NEAR(p.moved.z(), -(C - was) * F, 1e-9 * C * F) << i;
  }
}

TEST(Tissue, ForgetsTheLeastWhenItsMemoryIsFull) {
  Pressed p;
  for (int i = 0; i < 200; ++i) {
    p.point.p_W.x = 40e-6 * i;
    const Vec3 u = p.step({0, 0, -5e-3});
    ASSERT_TRUE(u.allFinite());
    ASSERT_LT(u.z(), 0);
    ASSERT_GT(u.z(), -3 * 5e-3 * 0.5 / (4 * 1e6 / 3 * 50e-6));
  }
}

/// Two places, one on each side of a slit, that are pulled together as a stitch pulls them.
struct Slit {
  static constexpr double kSlit = 0.3e-3, kStiff = 20;  // m, N/m
  testbed::ObjectBench<Tissue> bench;
  swage_contact_point point[2] = {{0, SWAGE_NONE, {-0.6e-3, 0, -0.2e-3}, {1, 0, 0}}, {0, SWAGE_NONE, {0.6e-3, 0, -0.2e-3}, {1, 0, 0}}};
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> W;
  Eigen::Matrix<double, 6, 1> v_free, u;

  explicit Slit(Level level = Level::kCompliant, double stiffness = kStiff) {
    W.setZero(), v_free.setZero(), u.setZero();
    bench.set("level", static_cast<double>(level)), bench.set("cells", 8), bench.set("relaxed", 1);
    bench.set("slit", kSlit), bench.set("edge_stiffness", stiffness);
    EXPECT_TRUE(bench.start());
  }
  /// One step under forces along x [N].
  void step(double left, double right) {
    const auto* s = bench.get<swage_solver>(SWAGE_EXT_SOLVER);
    const auto* surface = bench.get<swage_surface>(SWAGE_EXT_SURFACE);
    EXPECT_EQ(s->advance(bench.raw, &bench.step), SWAGE_OK);
    EXPECT_EQ(s->mobility(bench.raw, &bench.step, 2, point, v_free.data(), W.data()), SWAGE_OK);
    EXPECT_EQ(surface->displacement(bench.raw, &bench.step, 2, point, u.data()), SWAGE_OK);
    Eigen::Matrix<double, 6, 1> j = Eigen::Matrix<double, 6, 1>::Zero();
    j[0] = left * bench.step.dt_s, j[3] = right * bench.step.dt_s;
    EXPECT_EQ(s->apply_impulses(bench.raw, &bench.step, 2, point, j.data()), SWAGE_OK);
    EXPECT_EQ(bench.finish(), SWAGE_OK);
  }
  double width() const { return bench.step.signal[2]; }
};

// gap = slit - 2 T / k, and 0 from T = k slit / 2 on
TEST(SlitEdges, ComeTogetherAsTheTensionAcrossSays) {
  for (const Level level : {Level::kCompliant, Level::kMesh}) {
    Slit s(level);
    for (const double T : {0.0, 0.5e-3, 1e-3, 2e-3, 2.9e-3, 3e-3, 5e-3, 2e-3, 0.0}) {
      s.step(T, -T);
      EXPECT_NEAR(s.width(), std::max(0.0, Slit::kSlit - 2 * T / Slit::kStiff), 1e-12) << T;
    }
    // one of them alone, and both the same way: then the gap stays
    s.step(1e-3, 0);
    EXPECT_NEAR(s.width(), Slit::kSlit - 1e-3 / Slit::kStiff, 1e-12);
    s.step(1e-3, 1e-3);
    EXPECT_NEAR(s.width(), Slit::kSlit, 1e-12);
    // pulled apart it gapes
    s.step(-1e-3, 1e-3);
    EXPECT_NEAR(s.width(), Slit::kSlit + 2e-3 / Slit::kStiff, 1e-12);
  }
}

// what the solve is told is what then happens: u = displacement + h^2 W f, open and shut, also when they go aside together
TEST(SlitEdges, TellTheSolveHowTheyGive) {
  for (const double T : {1e-3, 5e-3}) {
    Slit s, still(Level::kCompliant, 0);
    const double h = s.bench.step.dt_s, aside = 0.4e-3;
    s.step(T, -T);
    s.step(T + aside, -T);
    EXPECT_LT((s.W - s.W.transpose()).norm(), 1e-12 * s.W.norm());
    EXPECT_EQ((Eigen::LLT<Eigen::Matrix<double, 6, 6>>(Eigen::Matrix<double, 6, 6>(s.W)).info()), Eigen::Success);
    for (int i = 0; i < 2; ++i) still.step(T + (i == 1 ? aside : 0), -T);
    // of the edges alone: without what the half space gives
    const Eigen::Matrix<double, 6, 6> W = s.W - still.W;
    const double left = s.u[0] + h * h * (W(0, 0) * (T + aside) - W(0, 3) * T), right = s.u[3] + h * h * (W(3, 0) * (T + aside) - W(3, 3) * T);
    EXPECT_NEAR(Slit::kSlit + right - left, s.width(), 1e-12);
    const bool meet = T > 3e-3;
    EXPECT_NEAR(0.5 * (left + right), aside / (2 * Slit::kStiff), 1e-12) << "the middle goes with what is left over, shut or open";
    EXPECT_EQ(s.width() < 1e-12, meet);
  }
}

TEST(Tissue, RefusesWhatDoesNotFit) {
  testbed::ObjectBench<Tissue> bench;
  bench.set("form", 4);
  bench.set("radius", 2e-3);
  EXPECT_FALSE(bench.start());
  testbed::ObjectBench<Tissue> slit;
  slit.set("slit", 4e-3);
  slit.set("size", 6e-3, 6e-3);
  EXPECT_FALSE(slit.start());
  testbed::ObjectBench<Tissue> edges;
  edges.set("level", 1), edges.set("edge_stiffness", 20);
  EXPECT_FALSE(edges.start()) << "edges of no slit";
}

}  // namespace
}  // namespace swage::tissue
