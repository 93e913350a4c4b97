// SPDX-License-Identifier: Apache-2.0
//
// swage.object.thread as a host meets it: how it hangs and sinks, what it answers to contacts, that it is held without creep, breaks,
// and remembers nothing that the host does not keep.
#include <gtest/gtest.h>
#include <swage/testbed.hpp>

#include <Eigen/Dense>
#include <filesystem>

#include "plugins/thread/path.hpp"
#include "plugins/thread/thread.hpp"
#include "test_places.hpp"

namespace swage::thread {
namespace {

using toolkit::Vec3;

struct Bench {
  testbed::ObjectBench<Thread> bench;
  std::vector<swage_contact_point> point;
  std::vector<swage_chain_place> place;
  std::vector<double> v_free, W;
  double h = 1e-3;

  void start() {
    ASSERT_TRUE(bench.start(h));
    bench.step.gravity = {0, 0, -9.81};
    solver = bench.get<swage_solver_2>(SWAGE_EXT_SOLVER_2);
    n = bench.declared.shapes.size() == 1 ? bench.declared.n_state / 12 : 0;
  }
  void advance() { ASSERT_EQ(solver->advance(bench.raw, bench.fill()), SWAGE_OK); }
  /// A point on the middle of a segment, `up` from its centre line.
  void touch(uint32_t segment, double up = 0) {
    const Vec3 p = middle(segment) + up * Vec3::UnitZ();
    point.push_back({0, 0, toolkit::raw(p), {0, 0, 1}});
    place.push_back({segment, 0, 0.5, 0});
  }
  void clear() { point.clear(), place.clear(); }
  Vec3 node(uint32_t i) const { return Eigen::Map<const Vec3>(bench.state.data() + 3 * i); }
  Vec3 velocity(uint32_t i) const { return Eigen::Map<const Vec3>(bench.state.data() + 3 * (n + i)); }
  void ask() {
    v_free.assign(3 * point.size(), 0.0), W.assign(9 * point.size() * point.size(), 0.0);
    ASSERT_EQ(solver->compliance(bench.raw, bench.fill(), static_cast<uint32_t>(point.size()), point.data(),
                                 place.data(), v_free.data(), W.data()),
              SWAGE_OK);
  }
  void yield(const Eigen::VectorXd& impulse) {
    ASSERT_EQ(solver->yield(bench.raw, bench.fill(), static_cast<uint32_t>(point.size()), point.data(),
                            place.data(), impulse.data()),
              SWAGE_OK);
  }
  Vec3 middle(uint32_t segment) const { return 0.5 * (node(segment) + node(segment + 1)); }
  double signal(const char* id) {
    EXPECT_EQ(bench.finish(), SWAGE_OK);
    const char* const names[] = {"thread.tension_first", "thread.tension_last", "thread.tension_grip",
                                 "thread.tension",       "thread.bend_radius",  "thread.parted"};
    for (size_t i = 0; i < 6; ++i)
      if (std::string(id) == names[i]) return bench.signal[i];
    ADD_FAILURE() << id;
    return 0;
  }
  const swage_solver_2* solver = nullptr;
  uint32_t n = 0;  // vertices
};

/// Springs of 1e6 N/m hold the points at `anchor` in all directions: one step, implicit as the host's contacts are. Their forces [N].
Eigen::VectorXd hold(Bench& b, const std::vector<uint32_t>& segment, const std::vector<Vec3>& anchor,
                     const Vec3& load, uint32_t loaded) {
  constexpr double k = 1e6;
  std::vector<Vec3> x0;
  for (const uint32_t s : segment) x0.push_back(b.middle(s));
  b.advance();
  b.clear();
  for (const uint32_t s : segment) b.touch(s);
  b.touch(loaded);
  b.ask();
  const auto n = static_cast<Eigen::Index>(3 * segment.size()), all = n + 3;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::MatrixXd W = Eigen::Map<const Rows>(b.W.data(), all, all);
  Eigen::VectorXd gone(n), j(all);
  for (size_t i = 0; i < segment.size(); ++i)
    gone.segment<3>(static_cast<Eigen::Index>(3 * i)) = x0[i] - anchor[i];
  j.tail<3>() = b.h * load;
  // f = -k (gone + h (v_free + W j))
  const Eigen::VectorXd right = gone + b.h * (Eigen::Map<const Eigen::VectorXd>(b.v_free.data(), n) +
                                              W.topRightCorner(n, 3) * j.tail<3>());
  const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(n, n) / k + b.h * b.h * W.topLeftCorner(n, n);
  const Eigen::VectorXd f = -M.ldlt().solve(right);
  j.head(n) = b.h * f;
  b.yield(j);
  return f;
}

TEST(Thread, HangsAsAnElastica) {
  Bench b;
  b.bench.set("first", 1.0);
  b.bench.set("segments", 25);
  b.bench.set("length", 18.910e-3);
  b.start();
  for (int k = 0; k < 4000; ++k) b.advance();
  const Vec3 last = b.middle(24), before = b.middle(23), tip = last + 0.5 * (last - before);
  EXPECT_LT((tip / 18.910e-3 - Vec3(0.991246, 0, -0.123471)).norm(), 1e-3);
  EXPECT_NEAR(b.signal("thread.bend_radius"), 18.910e-3 / 0.5,
              0.1 * 18.910e-3 / 0.5);  // G/2 at the clamp, and its first node
}

/// A coil of its own memory lies as it was laid.
TEST(Thread, ACoilOfItsMemoryStays) {
  Bench b;
  b.bench.set("start", 2.0);
  b.bench.set("memory", 75);
  b.bench.set("coil_radius", 1.0 / 75);
  b.bench.set("first", 1.0);
  b.start();
  b.bench.step.gravity = {0, 0, 0};
  const Vec3 end = b.node(32);
  for (int k = 0; k < 300; ++k) b.advance();
  EXPECT_LT((b.node(32) - end).norm(), 20e-6);
}

TEST(Thread, SinksInWater) {
  Bench b;
  b.bench.set("around", 2.0);
  b.start();
  for (int k = 0; k < 100; ++k) b.advance();
  // 0.29 mm/s in water of 1000 kg/m3; the lighter 998 bears it less
  EXPECT_NEAR(-b.velocity(10).z(), 0.294e-3, 0.02 * 0.294e-3);
}

// the same by the environment of the lesson, which `around` overrules
TEST(Thread, TakesTheFluidOfTheLesson) {
  for (const bool overruled : {false, true}) {
    Bench b;
    b.bench.host.environment = kStillAir;
    b.bench.host.environment.medium = SWAGE_MEDIUM_WATER;
    b.bench.host.environment.density = 998, b.bench.host.environment.viscosity = 1.0e-3;
    if (overruled) b.bench.set("around", 1.0);  // air
    b.start();
    for (int k = 0; k < 100; ++k) b.advance();
    if (overruled)
      EXPECT_GT(-b.velocity(10).z(), 30e-3);
    else
      EXPECT_NEAR(-b.velocity(10).z(), 0.294e-3, 0.02 * 0.294e-3);
  }
}

/// Speed of a node after one step of 0.1 ms without weight and fluid, at a charge [C/m]; `plane`: height of an earthed plane, 1: none.
Vec3 pushed(double charge, const std::string& path, int segments, uint32_t node, double plane = 1) {
  Bench b;
  b.h = 1e-4;
  swage_environment& e = b.bench.host.environment;
  e.medium = SWAGE_MEDIUM_DRY, e.density = e.viscosity = 0, e.charge = charge;
  if (plane < 1) e.grounded = 1, e.ground_z = plane;
  b.bench.set("level", 1.0);  // catenary: nothing bends straight
  b.bench.set("start", path.empty() ? 0.0 : 3.0);
  b.bench.set_text("path", path);
  b.bench.set("segments", segments);
  b.bench.set("length", 0.5e-3 * segments);
  b.start();
  b.bench.step.gravity = {0, 0, 0};
  b.advance();
  return b.velocity(node);
}
constexpr double kLine = 1140 * M_PI * 11e-6 * 11e-6, kVacuum = 8.8541878128e-12;  // kg/m, F/m

// two strands of 10 mm at 1 mm: q^2 / (2 pi e0 d) per length, less by what is missing beyond their ends, L/2 / sqrt(d^2 + L^2/4)
TEST(Thread, StrandsOfOneChargePushEachOther) {
  constexpr double q = 0.5e-9, d = 1e-3, L = 10e-3;
  const char* u = "0 0 0, 10 0 0, 10 1 0, 0 1 0 mm";
  const double v = pushed(q, u, 42, 10).y();
  const double f = q * q / (2 * M_PI * kVacuum * d) * (0.5 * L) / std::hypot(d, 0.5 * L);
  EXPECT_NEAR(v, -f / kLine * 1e-4, 0.01 * f / kLine * 1e-4);
  EXPECT_EQ(pushed(0, u, 42, 10).y(), 0);
  EXPECT_NEAR(f, 4.4e-6, 0.05e-6);  // N/m: about its weight
}

// an earthed plane at 1 mm: q^2 / (4 pi e0 h), towards it, whatever the sign of the charge; none without a plane
TEST(Thread, IsDrawnToAnEarthedPlane) {
  constexpr double h = 1e-3, L = 20e-3;
  for (const double q : {0.5e-9, -0.5e-9}) {
    const double f = q * q / (4 * M_PI * kVacuum * h) * (0.5 * L) / std::hypot(2 * h, 0.5 * L);
    EXPECT_NEAR(pushed(q, "", 40, 20, -h).z(), -f / kLine * 1e-4, 0.01 * f / kLine * 1e-4);
    EXPECT_NEAR(pushed(q, "", 40, 20).norm(), 0, 1e-4 * f / kLine * 1e-4);
  }
}

/// Sag of a thread of 20 mm between two ends that are fixed 16 mm apart.
double sag(int level, double density) {
  Bench b;
  b.bench.set("level", level);
  b.bench.set("first", 1.0);
  b.bench.set("last", 1.0);
  b.bench.set("segments", 40);
  b.bench.set("density", density);
  b.bench.set("start", 3.0);
  b.bench.set_text("path", "0 0 0, 8 0 -6, 16 0 0 mm");  // two legs of 10 mm
  b.start();
  for (int k = 0; k < 4000; ++k) b.advance();
  double lowest = 0;
  for (uint32_t i = 0; i <= 40; ++i) lowest = std::min(lowest, b.node(i).z());
  return -lowest;
}

// a catenary: 2 a sinh(8 mm / a) = 20 mm, sag a (cosh(8 mm / a) - 1). A rod of 10-0 is far stiffer than its weight bends
TEST(Thread, AChainHangsAsACatenary) {
  double low = 1e-3, high = 100e-3;
  for (int i = 0; i < 100; ++i) {
    const double a = 0.5 * (low + high);
    (2 * a * std::sinh(8e-3 / a) > 20e-3 ? low : high) = a;
  }
  const double expected = low * (std::cosh(8e-3 / low) - 1);
  EXPECT_NEAR(sag(1, 1140), expected, 2e-3 * expected);
  EXPECT_GT(std::abs(sag(2, 1140) - expected), 0.02 * expected);
}

// a thread that hangs from its first end is pulled there by its weight; explicit springs swing about that, a tenth of it without damping
TEST(Thread, EveryLevelBearsItsWeight) {
  for (int level = 0; level < 4; ++level) {
    Bench b;
    b.bench.set("level", level);
    b.bench.set("start", 1.0);
    b.bench.set("first", 1.0);
    b.bench.set("segments", 8);
    b.bench.set("young", 0.5e9);
    b.start();
    double mean = 0;
    for (int k = 0; k < 200; ++k) {
      b.advance();
      if (k >= 100) mean += b.signal("thread.tension_first") / 100;
    }
    const double weight = kLine * 20e-3 * 9.81;
    EXPECT_NEAR(mean, weight, (level == 0 ? 0.1 : 0.07) * weight) << level;  // the first half segment hangs on the end itself
    EXPECT_LT(b.signal("thread.parted"), 1);
  }
}

// a push on a place of the level `thesis` moves the nodes beside it by their masses
TEST(Thread, MassesAnswerByTheirMasses) {
  Bench b;
  b.bench.set("level", 0.0);
  b.bench.set("segments", 8);
  b.bench.set("young", 0.5e9);
  b.start();
  b.bench.step.gravity = {0, 0, 0};
  b.advance();
  b.touch(3);
  b.ask();
  const double m = kLine * 20e-3 / 8;
  EXPECT_NEAR(b.W[0], 0.5 / m, 1e-9 / m);  // two halves of halves
  Eigen::VectorXd j(3);
  j << 0, 0, 1e-9;
  const Vec3 before = b.middle(3);
  b.yield(j);
  EXPECT_NEAR((b.middle(3) - before).z(), b.h * (b.v_free[2] + b.W[8] * 1e-9), 1e-12);
}

TEST(Thread, GoesAsItAnswered) {
  Bench b;
  b.bench.set("start", 2.0);
  b.bench.set("memory", 100);
  b.start();
  for (int k = 0; k < 20; ++k) b.advance();
  b.advance();
  for (const uint32_t s : {3u, 9u, 10u, 20u, 31u}) b.touch(s);
  b.touch(15, 11e-6);  // on its surface
  b.ask();
  const auto n = static_cast<Eigen::Index>(3 * b.point.size());
  const Eigen::MatrixXd W = Eigen::Map<const Eigen::MatrixXd>(b.W.data(), n, n);
  EXPECT_LT((W - W.transpose()).norm(), 1e-14 * W.norm());
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(W).eigenvalues().minCoeff(), -1e-12 * W.norm());
  // the centre line goes exactly where it said, however hard it is pushed
  Eigen::VectorXd j(n);
  for (Eigen::Index i = 0; i < n; ++i) j[i] = 1e-10 * std::sin(static_cast<double>(i));
  b.yield(j);
  const Eigen::VectorXd v = Eigen::Map<const Eigen::VectorXd>(b.v_free.data(), n) + W * j;
  double worst = 0, largest = 0;
  for (size_t i = 0; i + 1 < b.point.size(); ++i) {
    const uint32_t s = b.place[i].segment;
    const Vec3 gone = 0.5 * (b.velocity(s) + b.velocity(s + 1)),
               answered = v.segment<3>(static_cast<Eigen::Index>(3 * i));
    largest = std::max(largest, answered.norm());
    worst = std::max(worst, (gone - answered).norm());
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_LT(worst, 1e-9 * largest) << largest;
}

/// Held at two places and pulled at its free end: the held places stand to 0.1 um for 5 s, and bear what pulls.
TEST(Thread, IsHeldWithoutCreep) {
  for (const double pull : {1e-3, 0.1}) {
    Bench b;
    b.start();
    const std::vector<uint32_t> segment = {15, 16};
    std::vector<Vec3> anchor;
    for (const uint32_t s : segment) anchor.push_back(b.middle(s));
    const Vec3 load(pull, 0, 0);
    Eigen::VectorXd f;
    for (int k = 0; k < 200; ++k) f = hold(b, segment, anchor, k * load / 200, 31);
    for (int k = 0; k < 300; ++k) f = hold(b, segment, anchor, load, 31);
    const Vec3 settled = b.middle(16);
    for (int k = 0; k < 5000; ++k) f = hold(b, segment, anchor, load, 31);
    EXPECT_LT((b.middle(16) - settled).norm(), 0.1e-6) << pull;
    EXPECT_NEAR(f[0] + f[3], -pull, 1e-3 * pull);
    EXPECT_NEAR(f[2] + f[5], 4.33e-7 * 20e-3 * 9.81, 1e-8) << "its weight";
    EXPECT_NEAR(b.signal("thread.tension"), pull, 1e-3 * pull);
    EXPECT_EQ(b.signal("thread.parted"), 0);
  }
}

/// Held places that move at 30 mm/s take it along.
TEST(Thread, FollowsWhatHoldsIt) {
  Bench b;
  b.start();
  const std::vector<uint32_t> segment = {2, 3};
  std::vector<Vec3> anchor;
  for (const uint32_t s : segment) anchor.push_back(b.middle(s));
  Eigen::VectorXd f;
  double worst = 0;
  for (int k = 0; k < 400; ++k) {
    const double speed = k < 50 ? 0 : 30e-3;
    for (Vec3& a : anchor) a += Vec3(0, 0.6, 0.8) * speed * b.h;
    f = hold(b, segment, anchor, Vec3::Zero(), 31);
    if (k > 100) worst = std::max(worst, (b.middle(2) - anchor[0]).norm());
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_LT(f.cwiseAbs().maxCoeff(), 1e-3);
}

TEST(Thread, BreaksWhereItsStrengthIsPassed) {
  Bench b;
  b.bench.set("strength", 0.19);
  b.bench.set("first", 1.0);
  b.start();
  const auto pull = [&](double f) {
    b.advance();
    b.clear();
    b.touch(31);
    b.ask();
    b.yield(Eigen::Vector3d(b.h * f, 0, 0));
  };
  for (int k = 0; k < 180; ++k) pull(1e-3 * k);
  EXPECT_EQ(b.signal("thread.parted"), 0);
  EXPECT_NEAR(b.signal("thread.tension_first"), 0.179, 2e-3);
  for (int k = 180; k < 220; ++k) pull(1e-3 * k);
  EXPECT_EQ(b.signal("thread.parted"), 1) << "at one place, though the tension is the same all along";
  EXPECT_LT(b.signal("thread.tension_first"), 0.19);
  for (const double x : b.bench.state) EXPECT_TRUE(std::isfinite(x));
}

/// The host takes back a step: what follows is the same to the bit.
TEST(Thread, RemembersNothingOfItsOwn) {
  Bench b;
  b.bench.set("memory", 60);
  b.bench.set("first", 1.0);
  b.start();
  const auto go = [&](int steps) {
    for (int k = 0; k < steps; ++k) {
      b.advance();
      b.clear();
      b.touch(12), b.touch(20);
      b.ask();
      Eigen::VectorXd j(6);
      j << 1e-10, 0, 2e-10, 0, -1e-10, 0;
      b.yield(j);
    }
  };
  go(20);
  const std::vector<double> state = b.bench.state;
  const std::vector<swage_pose> pose = b.bench.pose;
  go(15);
  const std::vector<double> after = b.bench.state;
  b.bench.state = state, b.bench.pose = pose;
  go(15);
  EXPECT_EQ(after, b.bench.state);
}

/// The library: each suture is read, lies in its own band of diameters, and a parameter overrides it.
TEST(Thread, IsASutureOfTheLibrary) {
  int found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SWAGE_SOURCE_DIR "/resources/threads")) {
    Suture suture;
    EXPECT_EQ(read_suture(entry.path().string(), suture), "");
    EXPECT_EQ(fault(suture), "") << entry.path();
    ++found;
  }
  EXPECT_EQ(found, 12);
  Suture six;
  ASSERT_EQ(read_suture(SWAGE_SOURCE_DIR "/resources/threads/nylon_6_0.json", six), "");
  EXPECT_GT(six.diameter, 69e-6);
  EXPECT_EQ(six.memory, 75);
  // 60 um of 2.5 GPa at 5 mN: it is stretched by 5e-3 / 7.07
  Bench b;
  b.bench.set_text("suture", SWAGE_SOURCE_DIR "/resources/threads/nylon_6_0.json");
  b.bench.set("diameter", 60e-6);
  b.bench.set("memory", 0);
  b.bench.set("first", 1.0);
  b.start();
  for (int k = 0; k < 300; ++k) {
    b.advance();
    b.clear();
    b.touch(31);
    b.ask();
    b.yield(Eigen::Vector3d(1e-3 * 5e-3, 0, 0));
  }
  EXPECT_NEAR((b.node(31) - b.node(0)).norm(), 20e-3 * 31 / 32 * (1 + 5e-3 / 7.0686), 0.2e-6);
}

TEST(Thread, SaysWhatIsWrongWithASuture) {
  Bench b;
  b.bench.set_text("suture", SWAGE_SOURCE_DIR "/resources/needles/micro_100.json");
  EXPECT_FALSE(b.bench.start());
  ASSERT_EQ(b.bench.declared.errors.size(), 1u);
  EXPECT_NE(b.bench.declared.errors[0].find("is not a suture"), std::string::npos);
}

TEST(Thread, RefusesACoilNarrowerThanItsSegments) {
  Bench b;
  b.bench.set("start", 2.0);
  b.bench.set("coil_radius", 0.3e-3);
  b.bench.set("segments", 10);
  EXPECT_FALSE(b.bench.start());
}

// nodes lie on the path a segment apart, beyond its last point straight on: nothing is stretched before it begins, and in its first step
// it has moved by 0.2 um
TEST(Thread, StartsAlongAPath) {
  Bench b;
  b.bench.set("start", 3.0);
  b.bench.set("length", 10e-3);
  b.bench.set("segments", 20.0);
  b.bench.set_text("path", "0 0 1, 3 0 1, 3 2 1,3 2 3 mm");
  b.start();
  EXPECT_NEAR((b.node(0) - Vec3(0, 0, 1e-3)).norm(), 0, 1e-6);
  EXPECT_NEAR((b.node(6) - Vec3(3e-3, 0, 1e-3)).norm(), 0, 1e-6);
  EXPECT_NEAR((b.node(20) - Vec3(3e-3, 2e-3, 6e-3)).norm(), 0, 1e-6);
  for (uint32_t i = 0; i < 20; ++i) EXPECT_NEAR((b.node(i + 1) - b.node(i)).norm(), 0.5e-3, 1e-8) << i;
}

// round a corner an edge is the chord, as long as it is unloaded
TEST(Thread, CutsTheCornersOfItsPath) {
  std::vector<Vec3> nodes;
  ASSERT_EQ(nodes_along("0 0 0, 0.7 0 0, 0.7 5 0 mm", 0.5e-3, 8, nodes), "");
  for (size_t i = 0; i + 1 < nodes.size(); ++i) EXPECT_NEAR((nodes[i + 1] - nodes[i]).norm(), 0.5e-3, 1e-15) << i;
  EXPECT_NEAR(nodes[2].x(), 0.7e-3, 1e-15);
}

TEST(Thread, SaysWhatIsWrongWithAPath) {
  std::vector<Vec3> nodes;
  for (const auto& [path, wrong] : {std::pair{"", "at least two points"}, {"0 0 0 mm", "at least two points"}, {"0 0, 1 0 0", "three numbers"},
                                    {"0 0 0 1 0 0", "commas"}, {"0 0 0, 1 0 nan", "within"}, {"0 0 0, 0 0 0 mm", "differ"}, {"0 0 0, 1 0 0", "its unit"},
                                    {"0 0 0, 1 0 0 cm", "commas"}})
    EXPECT_NE(nodes_along(path, 0.5e-3, 8, nodes).find(wrong), std::string::npos) << path << ": " << nodes_along(path, 0.5e-3, 8, nodes);
}

}  // namespace
}  // namespace swage::thread
