// SPDX-License-Identifier: Apache-2.0
//
// Knots with known invariants; the moves that reduce a diagram keep what libhomfly says of it; writhe and passages.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "ties.hpp"
#include "toolkit/knot/form.hpp"
#include "toolkit/knot/passage.hpp"
#include "toolkit/knot/reader.hpp"
#include "toolkit/knot/writhe.hpp"

namespace swage::test {
namespace {

using namespace toolkit;

KnotName read(const double* node, int n) {
  KnotThread thread;
  KnotReader reader;
  KnotName name;
  EXPECT_TRUE(thread.begin(node, n));
  while (!reader.read(thread, 500, name)) {
  }
  return name;
}

KnotName read(const Word& word, TieShape shape = {}) {
  shape.nodes = 300;
  const auto tie = make_tie(word, shape, 1);
  EXPECT_TRUE(tie.has_value());
  return read(tie->data(), tie->nodes());
}

TEST(Knots, GoldenInvariants) {
  const struct {
    Word word;
    int determinant, signature;
  } knots[] = {{{}, 1, 0},         {{1}, 3, -2},       {{-1}, 3, 2},           {{1, -1}, 9, 0},
               {{1, 1}, 9, -4},    {{-1, -1}, 9, 4},   {{2, -1, 1}, 45, -4},   {{-2, 1, -1}, 45, 4},
               {{2, 1}, 15, -6},   {{3, -1, 1}, 63, -6}, {{1, -1, 1, -1}, 81, 0}};
  for (const auto& k : knots) {
    const KnotName name = read(k.word);
    EXPECT_TRUE(name.certain) << text(k.word);
    EXPECT_TRUE(name.word.invariants.known);
    EXPECT_EQ(name.word.invariants.determinant, k.determinant) << text(k.word);
    EXPECT_EQ(name.word.invariants.signature, k.signature) << text(k.word);
  }
}

/// From tables: 4_1 has determinant 5 and signature 0. It is no throw, and is not taken for one.
TEST(Knots, AFigureEightIsNoThrow) {
  std::vector<Vec3> p;
  for (int i = 0; i <= 200; ++i) {
    const double t = 2 * std::numbers::pi * (i + 0.5) / 201.5;
    p.push_back({(2 + std::cos(2 * t)) * std::cos(3 * t), (2 + std::cos(2 * t)) * std::sin(3 * t), std::sin(4 * t)});
  }
  // its ends lie on the outside, side by side: t = 0 is where it is widest
  const KnotName name = read(p.front().data(), 201);
  EXPECT_FALSE(name.certain);
  EXPECT_TRUE(name.tangled) << "no throws have its invariants";
  EXPECT_EQ(name.word.throws, 0);
  EXPECT_EQ(name.word.others, 1);
  EXPECT_EQ(name.word.invariants.determinant, 5);
  EXPECT_EQ(name.word.invariants.signature, 0);
}

TEST(Knots, TheStrandsOfAThrowAreWhereItIs) {
  TieShape shape;
  shape.nodes = 300;
  const auto tie = make_tie({2, -1, 1}, shape, 1);
  const KnotName name = read(tie->data(), tie->nodes());
  ASSERT_EQ(name.word.throws, 3);
  const auto z = [&](double s) { return tie->node[static_cast<size_t>(s)].z(); };
  for (size_t i = 0; i < 3; ++i)
    for (const auto& strand : name.word.tied[i].strand) {
      EXPECT_LE(strand.first, strand.last);
      EXPECT_NEAR(z(0.5 * (strand.first + strand.last)), shape.spacing * static_cast<double>(i), 0.5 * shape.spacing) << i;
    }
}

/// In a flat throw both strands turn alike; around a straight core one of them turns little. Shape only: the word is the same.
TEST(Knots, FlatAndSlidingThrowsAreToldApart) {
  int flat = 0, sliding = 0;
  for (const Word& word : {Word{1}, Word{1, -1}, Word{1, 1}, Word{2, -1, 1}, Word{3, -1}})
    for (const double core : {0.0, 1.0})
      for (uint64_t seed = 0; seed < 10; ++seed) {
        TieShape shape;
        shape.core = core, shape.nodes = 400, shape.pitch = 2.5, shape.shears = seed < 5 ? 0 : 3, shape.shear = 0.4;  // more would bend the core
        const auto tie = make_tie(word, shape, seed);
        if (!tie) continue;
        const KnotName name = read(tie->data(), tie->nodes());
        ASSERT_TRUE(name.certain);
        for (int i = 0; i < name.word.throws; ++i) {
          const int found = KnotForm(tie->data(), tie->nodes(), name.word.tied[static_cast<size_t>(i)]).core();
          EXPECT_EQ(found, core > 0 ? 0 : -1) << text(word) << " seed " << seed << " throw " << i;
          ++(core > 0 ? sliding : flat);
        }
      }
  EXPECT_GT(flat, 40);
  EXPECT_GT(sliding, 20);
}

/// An overhand knot in each tail is not one knot of two throws.
TEST(Knots, TwoKnotsInARowAreTwo) {
  const auto one = make_tie({1}, {}, 1), two = make_tie({2}, {}, 1);
  std::vector<Vec3> p = one->node;
  const Vec3 step = Vec3(60, 0, 0);
  for (const Vec3& v : two->node) p.push_back(v + step);
  const KnotName name = read(p.front().data(), static_cast<int>(p.size()));
  EXPECT_TRUE(name.certain);
  EXPECT_EQ(name.word.throws, 2);
  EXPECT_EQ(name.word.knots, 2);
  EXPECT_EQ(name.word.tied[0].knot, 0);
  EXPECT_EQ(name.word.tied[1].knot, 1);
}

TEST(Knots, FlatAndDegenerateThreadsAreRead) {
  std::vector<Vec3> line, plane, still;
  for (int i = 0; i < 100; ++i) {
    line.push_back({0.1 * i, 0, 0});
    plane.push_back({std::cos(0.1 * i) * (1 + 0.01 * i), std::sin(0.1 * i) * (1 + 0.01 * i), 0});
    still.push_back({0, 0, 0});
  }
  EXPECT_TRUE(read(line.front().data(), 100).certain);
  EXPECT_TRUE(read(plane.front().data(), 100).certain);
  KnotThread thread;
  EXPECT_FALSE(thread.begin(still.front().data(), 100));
  EXPECT_FALSE(thread.begin(line.front().data(), 1));
  line[5].x() = NAN;
  EXPECT_FALSE(thread.begin(line.front().data(), 100));
}

TEST(Knots, ScaleDoesNotMatterAndAMirrorTurnsTheSigns) {
  const auto tie = make_tie({2, -1, 1}, {}, 1);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    std::vector<Vec3> p;
    for (const Vec3& v : tie->node) p.push_back(scale * Vec3(v.x(), v.y(), -v.z()));
    const KnotName name = read(p.front().data(), tie->nodes());
    ASSERT_EQ(name.word.throws, 3);
    for (size_t i = 0; i < 3; ++i) EXPECT_EQ(name.word.tied[i].sign, i == 1 ? 1 : -1);
  }
}

/// Random polygons are knotted in any way: whatever a diagram is reduced to, it is the same knot.
TEST(Knots, ReducedDiagramsAreTheSameKnot) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  int knotted = 0;
  for (int round = 0; round < 400; ++round) {
    std::vector<Vec3> p;
    for (int i = 0; i < 22; ++i) p.push_back({normal(random), normal(random), normal(random)});
    KnotThread thread;
    ASSERT_TRUE(thread.begin(p.front().data(), 22));
    // far ends joined around the outside: the polygon for libhomfly has them joined far away
    std::vector<Vec3> whole;
    for (int i = 0; i < thread.vertices(); ++i) {
      const KnotVertex& v = thread.vertex[static_cast<size_t>(i)];
      whole.push_back(Vec3(v.x, v.y, v.z) / KnotThread::kHalfCube);
    }
    const Vec3 a = whole.front(), b = whole.back();
    const Vec3 side = (a + b).norm() > 1 ? Vec3(a + b).normalized() : a.cross(Vec3(0.3, 0.5, 0.8)).normalized();
    whole.push_back(10 * b + 40 * side), whole.push_back(10 * a + 40 * side);
    const std::string before = homfly(whole, 90, 1);
    if (before.empty()) continue;
    KnotReader reader;
    KnotName name;
    while (!reader.read(thread, 500, name)) {
    }
    const std::string after = homfly(reader.diagram());
    EXPECT_EQ(before, after) << round;
    knotted += after != "1";
  }
  EXPECT_GT(knotted, 60);
}

TEST(Writhe, OfWhatIsKnown) {
  // a closed curve in a plane has none; of two linked rings the linking number is 1
  std::vector<Vec3> ring, other;
  for (int i = 0; i < 40; ++i) {
    const double t = 2 * std::numbers::pi * i / 40;
    ring.push_back({std::cos(t), std::sin(t), 0});
    other.push_back({1 + std::cos(t), 0, std::sin(t)});
  }
  EXPECT_NEAR(writhe(ring.front().data(), 40, true), 0, 1e-12);
  EXPECT_NEAR(std::abs(linking(ring.front().data(), 40, other.front().data(), 40)), 1, 1e-12);
  // of the ideal trefoil 3.42; of this one, flat and wide, near 3, its crossings
  std::vector<Vec3> knot;
  for (int i = 0; i < 200; ++i) {
    const double t = 2 * std::numbers::pi * i / 200;
    knot.push_back({(2 + std::cos(3 * t)) * std::cos(2 * t), (2 + std::cos(3 * t)) * std::sin(2 * t), 0.05 * std::sin(3 * t)});
  }
  EXPECT_NEAR(std::abs(writhe(knot.front().data(), 200, true)), 3, 0.15);
}

/// A positive knot that lies loosely has a positive writhe.
TEST(Writhe, HasTheSignOfTheThrow) {
  for (const int turns : {1, -1, 2}) {
    const auto tie = make_tie({turns}, {}, 1);
    const double w = writhe(tie->data(), tie->nodes(), false);
    EXPECT_GT(w * turns, 2) << turns;
  }
}

/// A band along a trefoil, with some turns of its own: its two edges are linked by Lk = Tw + Wr, a whole number.
TEST(Writhe, LinkingIsTwistAndWrithe) {
  constexpr int n = 600;
  std::vector<Vec3> middle, edge;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n;
    middle.push_back({(2 + std::cos(3 * t)) * std::cos(2 * t), (2 + std::cos(3 * t)) * std::sin(2 * t), std::sin(3 * t)});
  }
  const auto tangent = [&](int i) {
    return Vec3((middle[static_cast<size_t>((i + 1) % n)] - middle[static_cast<size_t>((i + n - 1) % n)]).normalized());
  };
  // a direction carried along without twist comes back turned
  std::vector<Vec3> carried{tangent(0).cross(Vec3(0.3, 0.5, 0.8)).normalized()};
  for (int i = 1; i <= n; ++i) carried.push_back(Quat::FromTwoVectors(tangent(i - 1), tangent(i)) * carried.back());
  const double turned = std::atan2(carried[0].cross(carried[n]).dot(tangent(0)), carried[0].dot(carried[n]));
  for (const int turns : {-3, 0, 2}) {
    const double twist = turns - turned / (2 * std::numbers::pi);
    edge.clear();
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * twist * i / n;
      edge.push_back(middle[static_cast<size_t>(i)] + 0.05 * (Eigen::AngleAxisd(angle, tangent(i)) * carried[static_cast<size_t>(i)]));
    }
    const double linked = linking(middle.front().data(), n, edge.front().data(), n);
    EXPECT_NEAR(linked, std::round(linked), 1e-9);
    EXPECT_NEAR(linked, twist + writhe(middle.front().data(), n, true), 0.01) << turns;
  }
}

/// Whatever random motion a thread makes, the writhe it jumps by is that of the passages found.
TEST(Passages, AreTheJumpsOfTheWrithe) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  KnotPassages passages;
  int seen = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec3> then, now;
    for (int i = 0; i < 30; ++i) {
      then.push_back({normal(random), normal(random), normal(random)});
      now.push_back(then.back() + 0.15 * Vec3(normal(random), normal(random), normal(random)));
    }
    KnotPassages::Found found;
    const int all = passages.find(then.front().data(), now.front().data(), 30, found);
    EXPECT_EQ(found.size(), std::min(all, KnotPassages::kMost));
    if (all > KnotPassages::kMost) continue;
    int jump = 0;
    for (const KnotPassage& p : found) jump += p.jump;
    // the writhe along the way: what jumps, and what does not, is told apart by small steps
    const auto counted = [&](int steps) {
      std::vector<Vec3> q = then;
      double before = writhe(then.front().data(), 30, false);
      int sum = 0;
      for (int k = 1; k <= steps; ++k) {
        for (size_t i = 0; i < 30; ++i) q[i] = then[i] + (now[i] - then[i]) * (static_cast<double>(k) / steps);
        const double w = writhe(q.front().data(), 30, false);
        sum += 2 * static_cast<int>(std::lround((w - before) / 2));
        before = w;
      }
      return sum;
    };
    if (counted(300) != jump) {
      EXPECT_EQ(counted(20000), jump) << round;
    }
    seen += found.size();
  }
  EXPECT_GT(seen, 300);
}

TEST(Passages, MotionWithoutAPassageHasNone) {
  // a tie that is drawn along, turned and swollen
  const auto tie = make_tie({2, -1, 1}, {}, 1);
  KnotPassages passages;
  KnotPassages::Found found;
  std::vector<Vec3> now;
  const Quat q(Eigen::AngleAxisd(0.02, Vec3(1, 2, 3).normalized()));
  for (const Vec3& v : tie->node) now.push_back(1.01 * (q * v) + Vec3(0.3, -0.2, 0.1));
  passages.find(tie->data(), now.front().data(), tie->nodes(), found);
  EXPECT_EQ(found.size(), 0);
}

}  // namespace
}  // namespace swage::test
