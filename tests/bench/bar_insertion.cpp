// SPDX-License-Identifier: Apache-2.0
//
// Insertion: a needle let go stays for a minute, no energy is made, what a whole scene costs, and what a hand feels of it.
#include "bar.hpp"
#include "phases.hpp"
#include "pierce_feats.hpp"
#include "run_lesson.hpp"
#include "session/force_guard.hpp"
#include "test_places.hpp"

namespace swage::bench {
namespace {

/// How far a needle comes that hangs in tissue by itself, once what the tissue had given has come back [m].
double way_when_let_go(double seconds) {
  constexpr double R = test::PierceRig::kRadius;
  test::PierceRig s;
  s.tissue = R"("level": "compliant", "thickness": "4 mm")";
  s.duration = 1;
  if (!s.build([](double t) { return test::about(std::min(-0.12 + t, 0.6)); }, test::feat_file("stays"))
           .empty())
    return kInfinity;
  s.rig->world.gravity = {0, 0, -9.80665};
  while (s.time() < 1) s.step();
  if (s.signal("pierce.state") != 2) return kInfinity;
  s.hold(0);
  while (s.time() < 8) s.step();
  const Pose rest = s.needle_pose();
  double worst = 0;
  while (s.time() < 8 + seconds) {
    s.step();
    const Pose now = s.needle_pose();
    worst = std::max({worst, (now.p - rest.p).norm(), (now * Vec3(0, R, 0) - rest * Vec3(0, R, 0)).norm()});
  }
  return worst;
}

std::vector<Line> stays(const Effort& effort) {
  const std::string time = std::to_string(static_cast<int>(effort.hold_seconds)) + " s";
  return {at_most("insertion", "let go in the middle: way in " + time + ", 1 % of its diameter", "um",
                  way_when_let_go(effort.hold_seconds) * kMicro, 1.0)};
}

std::vector<Line> balance() {
  std::vector<Line> lines;
  const auto line = [&](const char* name, const test::Feat& feat) {
    lines.push_back(at_most("insertion", std::string(name) + ": energy made in a step over the most stored",
                            "%", 100 * feat.error(), 1.2));
  };
  line("driven in and back at 5 mm/s, let go", test::drive({}, 5e-3));
  line("at 86 deg", test::graze({}, 86 * std::numbers::pi / 180));
  line("torn to the rim", test::tear_to_rim({}, 5e-3));
  line("taken again by a hand at 5 mm/s", test::regrasp({}, 5e-3, false));
  line("held still in tissue that is elastic", test::elastic({}, 0));
  return lines;
}

/// Steps of a lesson by a hand while `counts` says so: processor time [ns]; and the force on the tool [N].
struct Played {
  std::vector<double> ns;
  std::vector<Vec3> force_W;
};
Played play(const char* lesson, const char* hand, const char* level,
            bool (*counts)(const stage::LessonRun&)) {
  Played played;
  stage::LessonRun run(std::string(SWAGE_SOURCE_DIR "/lessons/series/") + lesson, hand,
                       {std::string("needle.level=") + level});
  if (!run.ready()) return played;
  uint32_t tool = 0;
  while (run.rig().objects[tool].instance->name != "holder") ++tool;
  const scene::Range bodies = run.rig().objects[tool].body;
  const auto of_tool = [&](uint32_t body) {
    return body >= bodies.first && body < bodies.first + bodies.count;
  };
  while (run.verdict().outcome == judge::Outcome::kRunning && run.world().time() < 60) {
    const double begin = cpu_ns();
    run.step();
    const double took = cpu_ns() - begin;
    Vec3 f = Vec3::Zero();
    for (const contact::Contact& c : run.engine().contacts().contact) {
      if (of_tool(c.body_a)) f += c.f_a_W;
      if (of_tool(c.body_b)) f -= c.f_a_W;
    }
    played.force_W.push_back(f);
    if (counts(run)) played.ns.push_back(took);
  }
  return played;
}

/// Largest change of the force in a millisecond that a device would get [N], with so many N at the hand per N in the scene.
double felt_jump(const std::vector<Vec3>& force_W, double scale) {
  session::ForceGuard guard;
  guard.arm();
  double now = 0, worst = 0;
  Vec3 before = Vec3::Zero();
  for (const Vec3& f : force_W) {
    session::ForceRequest want;
    want.force = toolkit::raw(Vec3(scale * f));
    const swage_command out = guard.tick(want, {}, 1e-3, now += 1e-3);
    worst = std::max(worst, (toolkit::vec(out.force) - before).norm());
    before = toolkit::vec(out.force);
  }
  return worst;
}

/// A run that is the same every time: medians step by step leave out what the machine does meanwhile.
struct Steps {
  Played last;
  std::vector<std::vector<double>> ns;

  void add(Played played) {
    ns.resize(played.ns.size());
    for (size_t k = 0; k < played.ns.size(); ++k) ns[k].push_back(played.ns[k]);
    last = std::move(played);
  }
  Times whole() const {
    std::vector<double> medians;
    for (const auto& step : ns) medians.push_back(times(step).median);
    Times none;
    none.median = none.p99 = kInfinity;
    return medians.empty() ? none : times(medians);
  }
  Line p99(const char* name) const {
    return at_most("insertion", name, "us", whole().p99 * 1e-3, 200, "n = " + std::to_string(ns.size()));
  }
};

}  // namespace

std::vector<Line> bar_insertion(const Effort& effort) {
  std::vector<Line> lines = stays(effort);
  for (Line& line : balance()) lines.push_back(std::move(line));

  // runs in turn
  std::vector<double> grasp;
  Steps expert, novice;
  for (int i = 0; i < effort.passes; ++i) {
    grasp.push_back(times(play("020_grasp_basic.json", "expert", "rigid", in_jaws).ns).median);
    expert.add(play("110_insertion.json", "expert", "bending", inserted));
    novice.add(play("110_insertion.json", "novice", "bending", inserted));
  }
  const Played& insertion = expert.last;
  const bool there = !insertion.ns.empty();
  lines.push_back(ratio("insertion", "bending needle, jaws, compliant tissue: step over a rigid grasp's",
                        expert.whole().median, times(grasp).median, 4));
  lines.push_back(expert.p99("the same: p99 of a step, a fifth of a tick"));
  lines.push_back(novice.p99("the same by a novice, who tears: p99 of a step"));
  const double slew = 1e-3 * session::ForceLimits{}.slew;
  for (const double scale : {1.0, 20.0})
    lines.push_back(at_most("insertion",
                            "change of the force at the hand in 1 ms, " +
                                std::to_string(static_cast<int>(scale)) + " N per N in the scene",
                            "N", there ? felt_jump(insertion.force_W, scale) : kInfinity, slew * (1 + 1e-9)));
  return lines;
}

}  // namespace swage::bench
