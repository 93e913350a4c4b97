// SPDX-License-Identifier: Apache-2.0
//
// swage.coupling.pull_through: a thread behind its needle through a wall: where it is held, what it takes to draw it, that it makes no
// energy, cuts where it is pulled hard, and saws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pierce_scene.hpp"
#include "thread_scene.hpp"
#include "scene/chain.hpp"

namespace swage::test {
namespace {

constexpr double kWall = 1e-3;   // m, thickness of the wall, of which z = 0 is the top
constexpr double kTurned = 4.3;  // rad, after which its blunt end is beneath it
constexpr double kRound = 3;     // s, for a full turn

/// The half-circle needle of the rig turns about a centre c, down through the wall and round its rim, and is then led along `way`. 20 mm
/// of thread come straight from its blunt end, beside the wall at the start.
struct Drawn : PierceScene {
  std::function<Vec3(double t)> way = [](double) { return Vec3(0, 0, 0); };
  std::string pull, thread = R"("memory": 0)";
  double turn_s = 1.5, length = 20e-3, turned_to = kTurned, back_to = -1;  // s, m, rad; back_to: in half a second, if it is positive
  int rounds = 0;        // more about the same centre, through the wall again and round its rim
  double spacing = 0;    // m, along the rim, from one to the next

  void start() {
    const Vec3 c(-kRadius, 0, 0.8e-3);
    const Path path = [this, c](double t) {
      const double share = std::min(1.0, t / turn_s);
      const double back = back_to > 0 ? std::clamp((t - turn_s) / 0.5, 0.0, 1.0) * (turned_to - back_to) : 0;
      const double round = std::clamp((t - turn_s) / kRound, 0.0, static_cast<double>(rounds));
      Pose X = turned(c, turned_to * share - back + 2 * std::numbers::pi * round);
      X.p.y() += spacing * round;
      X.p += way(std::max(0.0, t - turn_s - rounds * kRound));
      return X;
    };
    tissue = R"("level": "plane", "stiffening": 0, "size": ["4 mm", "20 mm"], "thickness": "1 mm", "backing": 0, "puncture_force": "1 mN",
               "cutting_force": "1 mN", "drag": 1, "failure_stress": ")" + strength + "\"";
    pierce = R"("reaction": 0)";
    leash = R"("stiffness": "20000 N/m")";
    // the blunt end at the start, and the way out of it
    const Pose X0 = turned(c, 0);
    const Vec3 end = X0 * Vec3(-kRadius, kRadius, 0), out = X0.q * Vec3(-1, 0, 0);
    const Quat q = Quat::FromTwoVectors(Vec3::UnitX(), out);
    const Vec3 p = end - 0.25e-3 * out;
    char text[512];
    std::snprintf(text, sizeof text,
                  R"(, {"name": "thread", "plugin": "swage.object.thread", "pose": {"p": [%.12g, %.12g, %.12g], "q": [%.12g, %.12g, %.12g, %.12g]},
                       "params": {"length": %.12g, "segments": 40, %s}})",
                  p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(), length, thread.c_str());
    extra_objects = text;
    extra_couplings = R"(, {"name": "end", "plugin": "swage.coupling.swage", "between": ["needle", "thread"]},
      {"name": "pull", "plugin": "swage.coupling.pull_through", "between": ["thread", "tissue"], "params": {)" + pull + "}}";
    make(path);
  }
  std::string strength = "420 kPa";
  scene::ChainView chain() const { return {engine->world(), engine->world().chain[0]}; }
  std::string troubles() const { return base::text(engine->stats().health); }
};

TEST(PullThrough, follows_its_needle_in_and_out) {
  Drawn s;
  s.duration = 2.2;
  s.way = [](double t) { return Vec3(0, 0, -10e-3 * t); };
  s.start();
  ASSERT_NE(s.engine, nullptr);
  s.run_until(2.2);
  EXPECT_EQ(s.count("pull.went_in"), 1);
  EXPECT_EQ(s.count("pull.came_out"), 1);
  EXPECT_EQ(s.count("swage.pulled_off"), 0);
  EXPECT_EQ(s.signal("pull.state"), 2);
  // the chord of the needle's way: 1 mm down, 0.66 mm aside
  EXPECT_NEAR(s.signal("pull.inside"), 1.19 * kWall, 0.03 * kWall);
  EXPECT_NEAR(s.signal("pull.tail") + s.signal("pull.inside") + s.signal("pull.out"), s.length, 1e-6);
  EXPECT_LT(s.signal("pull.cut"), 30e-6);
  EXPECT_EQ(s.troubles(), "");
}

/// With `tells` stitches: how much thread has gone in, in the place of loops.
TEST(PullThrough, tells_what_was_drawn_in_where_stitches_are_single) {
  Drawn s;
  s.duration = 2.2;
  s.way = [](double t) { return Vec3(0, 0, -10e-3 * t); };
  s.pull = R"("tells": "stitches")";
  s.start();
  ASSERT_NE(s.engine, nullptr);
  s.run_until(2.2);
  EXPECT_EQ(s.signal("pull.state"), 2);
  EXPECT_GT(s.signal("pull.drawn"), 1.19 * kWall);
  EXPECT_NEAR(s.signal("pull.drawn"), s.signal("pull.inside") + s.signal("pull.out"), 1e-9);
  EXPECT_NEAR(s.signal("pull.drawn"), s.length - s.signal("pull.tail"), 1e-9);
}

/// Drawn on at a steady pace: what it takes is the drag of the length inside; the tail hangs slack.
TEST(PullThrough, drags_by_its_length_inside) {
  Drawn s;
  s.duration = 2.6;
  s.way = [](double t) { return Vec3(0, 0, -10e-3 * t); };
  s.pull = R"("drag": 2, "friction": 0)";
  s.start();
  ASSERT_NE(s.engine, nullptr);
  s.run_until(2.3);
  double drag = 0, tension = 0, lateral = 0;
  int n = 0;
  s.run_until(2.6, [&] {
    drag += s.signal("pull.drag"), tension += s.signal("swage.tension"), lateral += s.signal("pull.lateral"), ++n;
  });
  const double law = 2 * s.signal("pull.inside");
  EXPECT_NEAR(drag / n, law, 0.02 * law);
  EXPECT_NEAR(tension / n, law, 0.03 * law);
}

/// Drawn across: over the edge of its exit the thread bears on the side, and friction takes mu of that at each of two holes, and no more.
TEST(PullThrough, rubs_at_the_edge_over_which_it_is_drawn) {
  double drag[2], side = 0;
  for (const double mu : {0.0, 0.3}) {
    Drawn s;
    s.duration = 3.0;
    // down first, then aside
    s.way = [](double t) { return Vec3(8e-3 * std::max(0.0, t - 0.5), 0, -10e-3 * std::min(t, 0.5)); };
    s.pull = mu > 0 ? R"("drag": 2, "friction": 0.3, "saw": 0)" : R"("drag": 2, "friction": 0, "saw": 0)";
    s.strength = "100 MPa";
    s.start();
    ASSERT_NE(s.engine, nullptr);
    s.run_until(2.5);
    double sum = 0, lateral = 0, limit = HUGE_VAL;
    int n = 0;
    s.run_until(3.0, [&] {
      const double now = s.signal("pull.drag");
      // the limit is that of the side force of the step before
      EXPECT_LE(now, limit * (1 + 1e-6));
      limit = 2 * s.signal("pull.inside") + 2 * mu * s.signal("pull.lateral");
      sum += now, lateral += s.signal("pull.lateral"), ++n;
    });
    drag[mu > 0] = sum / n, side = lateral / n;
    EXPECT_LT(s.signal("pull.cut"), 1e-12);
  }
  EXPECT_GT(drag[1], drag[0] + 0.3 * 0.5 * side);
  EXPECT_LT(drag[1], drag[0] + 0.3 * 2.5 * side);
}

/// What the hand puts in is at least what the tissue takes: a thread let go in its passage stays, and nothing begins to move.
TEST(PullThrough, makes_no_energy) {
  Drawn s;
  s.duration = 2.5;
  s.way = [](double t) { return Vec3(0, 3e-3 * std::min(t, 0.4), -10e-3 * std::min(t, 0.4)); };
  s.start();
  ASSERT_NE(s.engine, nullptr);
  s.run_until(2.1);
  // the hand stands: what the thread stores runs out into friction and air, and its fastest node gets ever slower
  const auto fastest = [&] {
    double v = 0;
    for (uint32_t i = 0; i < s.chain().vertices(); ++i) v = std::max(v, s.chain().v(i).norm());
    return v;
  };
  const double before = fastest();
  s.run_until(2.5);
  EXPECT_LT(fastest(), std::max(1e-3, before));
  EXPECT_LT(s.signal("pull.force"), 5e-3);
  EXPECT_EQ(s.troubles(), "");
}

/// Round the rim and through the wall again, 1 mm beside the first bite. A single stitch ignores that, a running one has two bites and
/// their holes; the thread is as long as before.
TEST(PullThrough, takes_two_bites_of_one_thread) {
  for (const int most : {1, 4}) {
    Drawn s;
    s.rounds = 1, s.spacing = 1e-3, s.length = 40e-3;
    s.duration = 8;
    s.pull = most > 1 ? R"("bites": 4, "friction": 0.05)" : R"("friction": 0.05)";
    s.strength = "100 MPa";
    s.start();
    ASSERT_NE(s.engine, nullptr);
    s.run_until(1.5 + kRound + 0.2);
    EXPECT_EQ(s.count("swage.pulled_off"), 0);
    EXPECT_EQ(s.signal("pull.bites"), most > 1 ? 2 : 1);
    EXPECT_EQ(s.count("pull.went_in"), most > 1 ? 2 : 1);
    EXPECT_EQ(s.count("pull.came_out"), most > 1 ? 2 : 1);
    EXPECT_EQ(s.count("pull.went_back") + s.count("pull.went_through"), 0);
    if (most == 1) continue;
    EXPECT_NEAR(s.signal("pull.inside"), 2 * 1.19 * kWall, 0.2 * kWall);
    // what is neither tail, nor inside, nor out beyond the last bite runs round the rim between the bites
    const double between = s.length - s.signal("pull.tail") - s.signal("pull.inside") - s.signal("pull.out");
    EXPECT_GT(between, 1e-3) << "m, round the rim";
    EXPECT_EQ(s.troubles(), "");
  }
}

/// Led back before it has come out it leaves the tissue by the way it came; that is counted as drawn back.
TEST(PullThrough, goes_back_the_way_it_came) {
  Drawn s;
  s.duration = 2.2, s.turned_to = 3.7, s.back_to = 3.2;
  s.start();
  ASSERT_NE(s.engine, nullptr);
  s.run_until(1.5);
  EXPECT_EQ(s.signal("pull.state"), 1);
  EXPECT_EQ(s.signal("pull.back"), 0);
  s.run_until(2.2);
  EXPECT_EQ(s.signal("pull.state"), 0);
  EXPECT_EQ(s.count("pull.went_back"), 1);
  EXPECT_EQ(s.count("pull.came_out"), 0);
  EXPECT_GT(s.signal("pull.back"), 0.3e-3);
  EXPECT_EQ(s.troubles(), "");
}

/// Pulled aside with more than the tissue bears it cuts; where it bears that, sliding saws.
TEST(PullThrough, cuts_and_saws) {
  const auto cut = [](const std::string& strength, const std::string& saw) {
    Drawn s;
    s.duration = 3.0;
    s.strength = strength;
    s.pull = R"("drag": 2, "friction": 0.2, "saw": )" + saw;
    s.way = [](double t) { return Vec3(8e-3 * std::max(0.0, t - 0.5), 0, -10e-3 * std::min(t, 0.5)); };
    s.start();
    EXPECT_NE(s.engine, nullptr);
    if (!s.engine) return 0.0;
    s.run_until(3.0);
    return s.signal("pull.cut");
  };
  EXPECT_LT(cut("100 MPa", "0"), 1e-9);
  EXPECT_GT(cut("20 kPa", "0"), 100e-6);
  EXPECT_GT(cut("100 MPa", "1"), 5e-6);
}

/// A thread that lies through the two edges of a wound from the beginning: four holes, where its start shape goes through the surfaces.
TEST(PullThrough, starts_in_the_tissue_where_the_thread_lies) {
  const auto edge = [](const char* name, double x, double turn) {
    char text[400];
    std::snprintf(text, sizeof text,
                  R"(, {"name": "%s", "plugin": "swage.object.tissue", "pose": {"p": [%g, 0, 0], "rpy": [0, 0, %g]},
                       "params": {"size": ["2 mm", "4 mm"], "thickness": "1 mm", "backing": 0, "mount_stiffness": "20 N/m"}})",
                  name, x, turn);
    return std::string(text);
  };
  const std::string through = R"("params": {"starts": "through"}})";
  ThreadScene s(R"({"name": "thread", "plugin": "swage.object.thread",
                    "params": {"start": "path", "path": "-8 0 -0.5, 8 0 -0.5 mm", "length": "16 mm", "segments": 40}})" +
                    edge("left", -1.2e-3, 0) + edge("right", 1.2e-3, M_PI),
                R"({"plugin": "swage.coupling.pull_through", "between": ["thread", "left"], )" + through +
                    R"(, {"plugin": "swage.coupling.pull_through", "between": ["thread", "right"], )" + through);
  ASSERT_NE(s.engine, nullptr);
  for (const int steps : {1, 500}) {
    s.run(steps);
    EXPECT_EQ(s.signal("pull.state"), 2);
    EXPECT_NEAR(s.signal("pull.inside"), 2e-3, 2e-6);
    EXPECT_NEAR(s.signal("pull.out"), 5.8e-3, 5e-6);
    EXPECT_NEAR(s.signal("pull.tail"), 8.2e-3, 5e-6);
    EXPECT_NEAR(s.signal("tissue.shift"), 0, 1e-6) << "nothing draws at it";
  }
  EXPECT_EQ(s.troubles(), "");
}

/// A thread that lies bent through weak tissue springs as it is let go, 0.1 mm in 2 ms, before anybody touches it.
TEST(PullThrough, counts_no_cut_while_the_thread_comes_to_rest) {
  const std::string through = R"({"plugin": "swage.coupling.pull_through", "params": {"starts": "through"}, )";
  const std::string edge = R"("params": {"level": "plane", "size": ["5 mm", "9 mm"], "thickness": "1.5 mm", "backing": 0, "failure_stress": "1.5 MPa"}})";
  ThreadScene s(R"({"name": "thread", "plugin": "swage.object.thread",
                    "params": {"suture": "nylon_8_0.json", "memory": "0 1/m", "start": "path", "length": "55.333 mm", "segments": 138,
                               "path": "1 0 33.7, 1 0 1.5, 0.966 0 1.241, 0.866 0 1, 0.707 0 0.793, 0.5 0 0.634, 0.259 0 0.534, 0 0 0.5, -0.259 0 0.534, -0.5 0 0.634, -0.707 0 0.793, -0.866 0 1, -0.966 0 1.241, -1 0 1.5, -1 0 21.5 mm"}},
                   {"name": "left", "plugin": "swage.object.tissue", "pose": {"p": ["-2.6 mm", 0, "1.5 mm"]}, )" + edge +
                    R"(, {"name": "right", "plugin": "swage.object.tissue", "pose": {"p": ["2.6 mm", 0, "1.5 mm"], "rpy": [0, 0, "180 deg"]}, )" + edge,
                through + R"("between": ["thread", "left"]}, )" + through + R"("between": ["thread", "right"]})");
  ASSERT_NE(s.engine, nullptr);
  for (const bool again : {false, true}) {
    step::Command put_back;
    put_back.kind = step::CommandKind::kResetObject;
    put_back.object = 0;
    if (again) s.engine->push(put_back);
    double most = 0;
    for (int i = 0; i < 300; ++i) {
      s.run(1);
      most = std::max(most, s.signal("pull.lateral"));
    }
    EXPECT_GT(most, 20e-3) << "the thread has not sprung, and nothing is tested";
    EXPECT_LT(s.signal("pull.cut"), 5e-6) << (again ? "put back" : "at the start");
  }
}

/// A thread that is torn upwards, sideways and back through weak tissue: its ties stay sound, so that nothing is put in quarantine.
TEST(PullThrough, may_be_torn_through_all_of_the_tissue) {
  for (const Vec3& pull : {Vec3(0, 0, 30e-3), Vec3(30e-3, 0, 0), Vec3(-30e-3, 0, 10e-3), Vec3(0, 30e-3, 5e-3)}) {
    Drawn s;
    s.duration = 3.2;
    s.strength = "5 kPa";
    s.way = [pull](double t) { return Vec3(Vec3(0, 0, -4e-3 * std::min(t, 0.5)) + std::max(0.0, t - 0.5) * pull); };
    s.start();
    ASSERT_NE(s.engine, nullptr);
    s.run_until(3.2, [&] { EXPECT_GE(s.signal("pull.inside"), 0); });
    EXPECT_EQ(s.engine->quarantined(), 0u) << pull.transpose();
  }
}

}  // namespace
}  // namespace swage::test
