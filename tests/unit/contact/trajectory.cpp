// SPDX-License-Identifier: Apache-2.0
//
// S01 and S02: the needle against two jaws over 10,000 poses, judged by a search that shares no code with the room.
#include "trajectory.hpp"

#include <gtest/gtest.h>

#include "contact/narrow_phase.hpp"
#include "solids.hpp"

namespace swage::contact {
namespace trajectory_test {

using bench::Jaw;
using bench::Needle;
using bench::TrajectoryPose;

double least_gap(const Manifold& m) {
  double least = 1;
  for (int i = 0; i < m.count; ++i) least = std::min(least, m.candidate[static_cast<size_t>(i)].touch.gap);
  return least;
}

/// Needle and jaws in some unit, with what is remembered between queries.
struct Scene {
  Scene(const Needle& n, const Jaw& upper, const Jaw& lower, double unit_per_m)
      : unit(unit_per_m),
        needle(bench::contact_solid(n, unit)),
        jaws{bench::contact_solid(upper, unit), bench::contact_solid(lower, unit)} {
    query.length = 1e-3 * unit;
    query.margin = 20e-6 * unit;
  }
  const Manifold& find(const TrajectoryPose& pose, size_t jaw) {
    collide(needle, Frame(bench::scaled(pose.X_WN, unit)), jaws[jaw],
            Frame(bench::scaled(pose.X_WJ[jaw], unit)), query, memory[jaw], found);
    return found;
  }

  double unit;
  Solid needle, jaws[2];
  Query query;
  Separation memory[2];
  Manifold found;
};

struct Verdict {
  int missed = 0, invented = 0, touching = 0;
  double worst = 0;  // m, error of the gap while overlapping
};

Verdict judge(const Needle& n, const Jaw& upper, const Jaw& lower, int poses, double shift = 0) {
  const bench::Solid reference[2] = {bench::Solid(upper), bench::Solid(lower)};
  Scene scene(n, upper, lower, 1);
  Verdict v;
  for (TrajectoryPose pose : bench::trajectory(n, upper, lower, poses))
    for (size_t k = 0; k < 2; ++k) {
      const double exact = bench::exact_gap(n, reference[k], pose.X_WJ[k].inverse() * pose.X_WN);
      pose.X_WN.p.z() += shift;
      const double ours = least_gap(scene.find(pose, k));
      pose.X_WN.p.z() -= shift;
      v.missed += exact < -1e-7 && !(ours < 0);
      v.invented += exact > 1e-7 && ours < 0;
      if (exact >= 0) continue;
      ++v.touching;
      v.worst = std::max(v.worst, std::abs(ours - exact));
    }
  return v;
}

TEST(Trajectory, NeedleAgainstPrismJawsMissesAndInventsNothing) {
  const Verdict v = judge({}, bench::jaw(1), bench::jaw(-1), 10000);
  EXPECT_GT(v.touching, 4000);
  EXPECT_EQ(v.missed, 0);
  EXPECT_EQ(v.invented, 0);
  EXPECT_LT(v.worst, 1e-11);
}

TEST(Trajectory, TheJudgeSeesAnErrorOfAThousandthOfTheWire) {
  const Verdict v = judge({}, bench::jaw(1), bench::jaw(-1), 1000, 0.1e-6);
  EXPECT_GT(v.worst, 1e-8);
}

TEST(Trajectory, NeedleAgainstTetrahedraMissesAndInventsNothing) {
  const Verdict v = judge({}, bench::tetra_jaw(1), bench::tetra_jaw(-1), 2000);
  EXPECT_GT(v.touching, 700);
  EXPECT_EQ(v.missed, 0);
  EXPECT_EQ(v.invented, 0);
  EXPECT_LT(v.worst, 1e-11);
}

TEST(Trajectory, OtherNeedlesBehaveAlike) {
  for (const double eighths : {2, 3, 4, 5})
    for (const double diameter : {50e-6, 100e-6, 150e-6}) {
      Needle n;
      n.arc = eighths / 4 * std::numbers::pi;
      n.wire_diameter = diameter;
      const Verdict v = judge(n, bench::jaw(1), bench::jaw(-1), 200);
      SCOPED_TRACE(testing::Message() << eighths << "/8 circle, wire " << diameter * 1e6 << " um");
      EXPECT_GT(v.touching, 60);
      EXPECT_EQ(v.missed, 0);
      EXPECT_EQ(v.invented, 0);
      EXPECT_LT(v.worst, 1e-11);
    }
}

TEST(Trajectory, ContactSetsDoNotDependOnTheUnit) {
  // a power of two scales without rounding: m against 1/1024 m, where every bit must agree; and against mm and 0.1 mm
  const Needle n;
  const Jaw upper = bench::jaw(1), lower = bench::jaw(-1);
  const auto poses = bench::trajectory(n, upper, lower, 1000);
  for (const double unit : {1024.0, 1e3, 1e4}) {
    Scene in_m(n, upper, lower, 1), in_unit(n, upper, lower, unit);
    for (const TrajectoryPose& pose : poses)
      for (size_t k = 0; k < 2; ++k) {
        const Manifold &a = in_m.find(pose, k), &b = in_unit.find(pose, k);
        ASSERT_EQ(a.count, b.count) << "unit " << unit;
        for (int i = 0; i < a.count; ++i) {
          const Candidate &x = a.candidate[static_cast<size_t>(i)], &y = b.candidate[static_cast<size_t>(i)];
          ASSERT_EQ(x.feature, y.feature);
          ASSERT_NEAR(x.weight, y.weight, 1e-6);
          ASSERT_NEAR(x.touch.gap, y.touch.gap / unit, 1e-12);
          ASSERT_TRUE(unit != 1024 || x.touch.gap * unit == y.touch.gap);
        }
      }
  }
}

}  // namespace trajectory_test
}  // namespace swage::contact
