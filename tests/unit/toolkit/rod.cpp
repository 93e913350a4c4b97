// SPDX-License-Identifier: Apache-2.0
//
// The rod's derivatives against differences of its energy, and its band against a dense solve.
#include "toolkit/rod.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstring>
#include <numbers>
#include <random>

namespace swage::toolkit {
namespace {

// 10-0 nylon: 22 um, 2.5 GPa
const RodSection kNylon = RodSection::round(22e-6, 2.5e9, 0.39, 1140);

/// A bent, twisted and stretched rod of uneven edges, both ends clamped.
struct Tangled {
  Tangled(int n, const RodSection& section, double memory, unsigned seed)
      : random(seed), numbers(RodState::size(n)), s(n, numbers.data()) {
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<double> rest;
    Vec3 x = Vec3::Zero(), t = Vec3(1, 0.2, -0.3).normalized();
    for (int i = 0; i < n; ++i) {
      Eigen::Map<Vec3>(s.x + 3 * i) = x;
      const double l = 1e-3 * (1 + 0.4 * any(random));
      if (i < n - 1) rest.push_back(l);
      t = (t + 0.5 * Vec3(any(random), any(random), any(random))).normalized();
      x += l * (1 + 0.01 * any(random)) * t;
    }
    rod = Rod(section, rest, memory);
    for (int end = 0; end < 2; ++end) {
      RodClamp& c = rod.clamp(end);
      c.on = true;
      c.tangent = Vec3(1, any(random), any(random)).normalized();
      c.director = c.tangent.cross(Vec3(0.1, 0.3, 1)).normalized();
    }
    rod.start(s);
    std::vector<double> turn(static_cast<size_t>(rod.unknowns()), 0.0);
    for (int j = 0; j < n - 1; ++j) turn[static_cast<size_t>(4 * j + 3)] = 0.7 * any(random);
    rod.move(s, turn.data(), 1, s);
  }
  std::mt19937 random;
  std::vector<double> numbers;
  RodState s;
  Rod rod;
};

/// Fourth-order differences of the energy along unknowns of unlike size: lengths by l, angles by 1.
class Differences {
 public:
  Differences(Tangled& t) : t_(t), n_(t.rod.unknowns()), moved_(RodState::size(t.s.n)) {}
  double scale(int k) const { return k % 4 == 3 ? 1.0 : 1e-3; }
  double at(int i, double a, int j, double b) {
    std::vector<double> change(static_cast<size_t>(n_), 0.0);
    change[static_cast<size_t>(i)] += a * scale(i);
    change[static_cast<size_t>(j)] += b * scale(j);
    moved_ = t_.numbers;
    RodState to(t_.s.n, moved_.data());
    t_.rod.move(t_.s, change.data(), 1, to);
    return t_.rod.energy(to);
  }
  double first(int i) {
    const double h = 2e-4;
    return (8 * (at(i, h, i, 0) - at(i, -h, i, 0)) - (at(i, 2 * h, i, 0) - at(i, -2 * h, i, 0))) / (12 * h);
  }
  double second(int i, int j) {
    const double h = 2e-3;
    const auto mixed = [&](double d) {
      return (at(i, d, j, d) - at(i, d, j, -d) - at(i, -d, j, d) + at(i, -d, j, -d)) / (4 * d * d);
    };
    return (4 * mixed(h) - mixed(2 * h)) / 3;
  }

 private:
  Tangled& t_;
  int n_;
  std::vector<double> moved_;
};

// curvature that it keeps, and by how much it is softer against stretching: bending then is as large as stretching. Many nodes are added up
// four at a time, but beside a piece that was cut
struct Kind {
  double memory, softer;
  int nodes = 6, cut = -1;
  bool stays_bent = false;  // natural curvatures of its own at every node, in any direction
};
class RodDerivatives : public testing::TestWithParam<Kind> {};

TEST_P(RodDerivatives, AreThoseOfItsEnergy) {
  RodSection section = kNylon;
  section.stretching *= GetParam().softer;
  Tangled t(GetParam().nodes, section, GetParam().memory, 7);
  if (GetParam().cut >= 0) t.rod.cut(GetParam().cut);
  std::vector<double> set(static_cast<size_t>(2 * GetParam().nodes));
  for (double& k : set) k = std::uniform_real_distribution<double>(-0.2, 0.2)(t.random);
  if (GetParam().stays_bent) t.rod.remember(set.data());
  std::vector<double> gradient(static_cast<size_t>(t.rod.unknowns()));
  t.rod.take_tension(t.s);
  Rod::Matrix H(t.rod.unknowns());
  t.rod.differentiate(t.s, gradient.data(), &H);
  Differences differences(t);
  double most = 0, largest = 0;
  for (int i = 0; i < t.rod.unknowns(); ++i)
    most = std::max(most, std::abs(gradient[static_cast<size_t>(i)]) * differences.scale(i));
  for (int i = 0; i < t.rod.unknowns(); ++i)
    EXPECT_NEAR(gradient[static_cast<size_t>(i)] * differences.scale(i), differences.first(i), 1e-8 * most)
        << i;
  const auto scaled = [&](int i, int j) { return H.at(i, j) * differences.scale(i) * differences.scale(j); };
  for (int j = 0; j < t.rod.unknowns(); ++j) largest = std::max(largest, scaled(j, j));
  for (int j = 0; j < t.rod.unknowns(); ++j)
    for (int i = j; i < std::min(t.rod.unknowns(), j + 11); ++i)
      EXPECT_NEAR(scaled(i, j), differences.second(i, j), 1e-7 * largest + 1e-5 * std::abs(scaled(i, j)))
          << i << " " << j;
}
INSTANTIATE_TEST_SUITE_P(Memory, RodDerivatives,
                         testing::Values(Kind{0, 1}, Kind{80, 1}, Kind{0, 3e-5}, Kind{80, 3e-5}, Kind{80, 3e-5, 19}, Kind{80, 3e-5, 19, 13},
                                         Kind{0, 3e-5, 19, -1, true}, Kind{80, 3e-5, 19, 13, true}));

TEST(RodCurvature, IsGreatestWhereItIsGreatest) {
  Tangled t(12, kNylon, 0, 3);
  double most = 0;
  for (int i = 1; i < 11; ++i) most = std::max(most, t.rod.curvature(t.s, i));
  EXPECT_EQ(t.rod.most_curvature(t.s), most);
}

TEST(RodJoint, HasTheBitsSideBySideThatItHasAlone) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return Vec3(any(random), any(random), any(random)); };
  RodJoint<Twos> both;
  RodJoint<Ones> one[2];
  const auto put = [&](int k, const Vec3& v, Three<Twos> RodJoint<Twos>::*to, Three<Ones> RodJoint<Ones>::*alone) {
    for (int r = 0; r < 3; ++r) (both.*to)[r].x[k] = (one[k].*alone)[r].x = v[r];
  };
  for (int k = 0; k < 2; ++k) {
    put(k, vector().normalized(), &RodJoint<Twos>::te, &RodJoint<Ones>::te);
    put(k, vector().normalized(), &RodJoint<Twos>::tf, &RodJoint<Ones>::tf);
    put(k, vector(), &RodJoint<Twos>::Ke, &RodJoint<Ones>::Ke);
    put(k, vector(), &RodJoint<Twos>::Kf, &RodJoint<Ones>::Kf);
    both.inv_e.x[k] = one[k].inv_e.x = 2 + any(random), both.inv_f.x[k] = one[k].inv_f.x = 2 + any(random);
    both.twist.x[k] = one[k].twist.x = any(random);
    both.bend.x[k] = one[k].bend.x = 2 + any(random), both.turn.x[k] = one[k].turn.x = 2 + any(random);
  }
  JointDerivatives<Twos> d;
  JointDerivatives<Ones> alone;
  RodAssembly together{}, apart{};
  both.differentiate(true, true, d);
  RodAssembly::set(d, 1, true, together.joint);
  for (int k = 0; k < 2; ++k) {
    one[k].differentiate(true, true, alone);
    RodAssembly::set(alone, 1 + k, true, apart.joint);
  }
  EXPECT_EQ(std::memcmp(&together, &apart, sizeof apart), 0);
}

// edges that are found together are found by two or four at a time
TEST(RodEdges, HaveTheBitsThatEachHasAlone) {
  constexpr size_t kEdges = 23;
  std::vector<double> x(3 * (kEdges + 1)), y(x), d(3 * kEdges), carried(d), sine(kEdges), cosine(kEdges);
  for (size_t k = 0; k < x.size(); ++k) {
    x[k] = std::sin(1.7 * static_cast<double>(k)) + 0.3 * static_cast<double>(k);
    y[k] = x[k] + 0.01 * std::cos(2.3 * static_cast<double>(k));
  }
  RodEdges before(kEdges), after(kEdges);
  before.find(x.data()), after.find(y.data());
  for (size_t j = 0; j < kEdges; ++j) {
    const Vec3 across = before.t(j).cross(Vec3::UnitX()).normalized();
    for (size_t r = 0; r < 3; ++r) d[3 * j + r] = across[static_cast<int>(r)];
  }
  before.carry(after, d.data(), carried.data());
  after.twists(carried.data(), sine.data(), cosine.data());
  for (size_t j = 0; j < kEdges; ++j) {
    RodEdges from(1), to(1), pair(2);
    from.find(&x[3 * j]), to.find(&y[3 * j]);
    EXPECT_EQ(from.t(0), before.t(j));
    EXPECT_EQ(from.length(0), before.length(j));
    EXPECT_EQ(from.inverse(0), before.inverse(j));
    double alone[3];
    from.carry(to, &d[3 * j], alone);
    for (size_t r = 0; r < 3; ++r) EXPECT_EQ(alone[r], carried[3 * j + r]);
    if (j + 1 == kEdges) continue;
    double sine_alone, cosine_alone;
    pair.find(&y[3 * j]);
    pair.twists(&carried[3 * j], &sine_alone, &cosine_alone);
    EXPECT_EQ(sine_alone, sine[j]);
    EXPECT_EQ(cosine_alone, cosine[j]);
  }
}


// At a top of its energy: an arc of 10 mm that is bent to a radius of 1.25 mm against the 10 mm that it remembers. All of its edges would
// turn together, and hardly anything but their own inertia holds them.
TEST(Rod, BentSharplyAgainstWhatItRemembersHasALinearStep) {
  constexpr int n = 17;
  constexpr double radius = 1.25e-3, l = 0.625e-3;  // m
  std::vector<double> numbers(RodState::size(n));
  RodState s(n, numbers.data());
  for (const double memory : {100.0, -100.0}) {
    Rod rod(kNylon, std::vector<double>(n - 1, l), memory);
    for (int i = 0; i < n; ++i) {
      const double a = l / radius * i;
      Eigen::Map<Vec3>(s.x + 3 * i) = radius * Vec3(std::sin(a), 1 - std::cos(a), 0);
    }
    rod.start(s);
    RodLoad load;
    load.h = 1e-3;
    for (const double turn : {0.0, 0.5, 1.0, 1.5}) {  // of half a turn: for two of them it lies against what it remembers
      std::vector<double> change(static_cast<size_t>(rod.unknowns()), 0.0), moved(numbers);
      RodState to(n, moved.data());
      for (int j = 0; j < n - 1; ++j) change[static_cast<size_t>(4 * j + 3)] = turn * std::numbers::pi;
      rod.move(s, change.data(), 1, to);
      rod.prepare(to, load);
      EXPECT_TRUE(rod.linearise(to, load)) << memory << " 1/m, turned by " << turn << " pi";
    }
  }
}

}  // namespace
}  // namespace swage::toolkit
