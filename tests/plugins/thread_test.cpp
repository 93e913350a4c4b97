// SPDX-License-Identifier: Apache-2.0
//
// swage.object.thread as a host meets it: how it hangs and sinks, what it answers to contacts, that it is held without creep, breaks,
// and remembers nothing that the host does not keep.
#include "thread_bench.hpp"

#include <Eigen/Dense>
#include <filesystem>
#include <fstream>

#include "plugins/thread/path.hpp"
#include "test_places.hpp"

namespace swage::thread {
namespace {

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
  b.apply_impulses(j);
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
  b.apply_impulses(j);
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

/// Jaws that have drawn a thread out between them hold a tension there. A hand feels what draws outside: nothing here, and 2 mN there.
TEST(Thread, ItsGripTellsTheTensionOutsideOfTheJaws) {
  for (const double pull : {0.0, 2e-3}) {
    Bench b;
    b.start();
    const std::vector<uint32_t> segment = {14, 15, 16, 17};
    std::vector<Vec3> anchor;
    for (const uint32_t s : segment) anchor.push_back(b.middle(s));
    constexpr double kStrain = 5e-3;  // of 10-0 nylon, whose EA is 0.95 N: 5 mN
    const double apart = (anchor[3] - anchor[0]).norm();
    for (size_t i = 0; i < anchor.size(); ++i) anchor[i].x() += kStrain * (static_cast<double>(i) / 3 - 0.5) * apart;
    for (int k = 0; k < 500; ++k) hold(b, segment, anchor, Vec3(pull, 0, 0), 31);
    EXPECT_GT(b.signal("thread.tension"), 3e-3) << "between the jaws";
    EXPECT_NEAR(b.signal("thread.tension_grip"), pull, 0.1e-3);
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
    b.apply_impulses(Eigen::Vector3d(b.h * f, 0, 0));
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
      b.apply_impulses(j);
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
    b.apply_impulses(Eigen::Vector3d(1e-3 * 5e-3, 0, 0));
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

// a yield strain of less than a thousandth is a mistake of units, and one with all of its stiffness left would never stay bent
TEST(Thread, RefusesAYieldThatIsNone) {
  for (const auto& [yield, hardening, sound] : {std::tuple{0.0005, 0.3, false}, {0.001, 0.3, true}, {0.0, 0.0, true}, {0.05, 0.96, false}, {0.05, 0.95, true}}) {
    Bench b;
    b.bench.set("yield", yield), b.bench.set("hardening", hardening);
    EXPECT_EQ(b.bench.start(), sound) << yield << " " << hardening;
  }
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
  ASSERT_EQ(nodes_along("0 0 0, 0.7 0 0, 0.7 5 0 mm", std::vector<double>(7, 0.5e-3), nodes), "");
  for (size_t i = 0; i + 1 < nodes.size(); ++i) EXPECT_NEAR((nodes[i + 1] - nodes[i]).norm(), 0.5e-3, 1e-15) << i;
  EXPECT_NEAR(nodes[2].x(), 0.7e-3, 1e-15);
}

TEST(Thread, SaysWhatIsWrongWithAPath) {
  std::vector<Vec3> nodes;
  for (const auto& [path, wrong] : {std::pair{"", "at least two points"}, {"0 0 0 mm", "at least two points"}, {"0 0, 1 0 0", "three numbers"},
                                    {"0 0 0 1 0 0", "commas"}, {"0 0 0, 1 0 nan", "within"}, {"0 0 0, 0 0 0 mm", "differ"}, {"0 0 0, 1 0 0", "its unit"},
                                    {"0 0 0, 1 0 0 cm", "commas"}})
    EXPECT_NE(nodes_along(path, std::vector<double>(7, 0.5e-3), nodes).find(wrong), std::string::npos) << path << ": " << nodes_along(path, std::vector<double>(7, 0.5e-3), nodes);
}

// node by node, as it lay: stretched by a hundredth it is under a hundredth of its stiffness
TEST(Thread, StartsWithItsNodesWhereTheyAreSaidToBe) {
  Bench b;
  b.bench.set("start", 4.0);
  b.bench.set("length", 4e-3);
  b.bench.set("segments", 4.0);
  b.bench.set_text("path", "0 0 0, 1.01 0 0, 2.02 0 0, 3.03 0 0, 4.04 0 0 mm");
  b.start();
  for (uint32_t i = 0; i <= 4; ++i) EXPECT_NEAR((b.node(i) - Vec3(1.01e-3 * i, 0, 0)).norm(), 0, 1e-15) << i;
  std::vector<Vec3> nodes;
  EXPECT_NE(nodes_at("0 0 0, 1 0 0 mm", 3, 3, nodes).find("2 segments has 3 nodes, not 2"), std::string::npos);
  EXPECT_EQ(nodes_at("0 0 0, 1 0 0, 1 1 0 mm", 3, 5, nodes), "") << "a finer level has nodes between";
  EXPECT_NEAR((nodes[3] - Vec3(1e-3, 0.5e-3, 0)).norm(), 0, 1e-15);
}

// one of several, drawn at random or named
TEST(Thread, DrawsOneOfThePathsOfAFile) {
  const std::string file = testing::TempDir() + "swage_paths.txt";
  std::ofstream(file) << "# straight\n0 0 0, 1 0 0 mm\n\n# up\n0 0 0, 0 0 1 mm\n# aside\n0 0 0, 0 1 0 mm\n";
  for (const int shape : {0, 1, 2, 3, 4}) {
    Bench b;
    b.bench.set("start", 3.0);
    b.bench.set("length", 4e-3);
    b.bench.set("segments", 4.0);
    b.bench.set_text("paths", file.c_str());
    b.bench.set("shape", static_cast<double>(shape));
    if (shape == 4) {
      EXPECT_FALSE(b.bench.start(1e-3)) << "there are three";
      continue;
    }
    b.start();
    const Vec3 end = b.node(4);
    const Vec3 ends[] = {Vec3(4e-3, 0, 0), Vec3(0, 0, 4e-3), Vec3(0, 4e-3, 0)};
    if (shape > 0) {
      EXPECT_NEAR((end - ends[shape - 1]).norm(), 0, 1e-6) << shape;
    } else {
      EXPECT_NEAR(end.norm(), 4e-3, 1e-6);
    }
  }
}

}  // namespace
}  // namespace swage::thread
