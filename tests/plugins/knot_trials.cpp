// SPDX-License-Identifier: Apache-2.0
//
// Margins of a plan of two hands that tie a knot: plays a lesson of swage.lesson.knot with several seeds and with plans whose places are
// off by random distances, and prints how each attempt ended and what share of them passed. No test: a tool for whoever writes a plan.
//
//   knot_trials LESSON HAND [--seeds N] [--first SEED] [--off UM] [--max S] [--set OBJECT.PARAMETER=VALUE] [--log S] [--plans FOLDER]
//               [--pull FRICTION] [--copy FILE] [--nodes FILE] [--shape FILE S...]
//
//   --off    root mean square of the error [um] of each coordinate of each "at" and "by" of the plans, drawn anew for each attempt
//   --log    a line each so many simulated seconds: tips, turns, the knot that is foretold and the one that is tied, tensions, gap
//   --plans  a folder with holder.json and winder.json, in the place of the hand's plans
//   --pull   what is tied at the end is copied and pulled to 0.1 N with that friction of the thread on itself (pulled_knot.hpp); again for more
//   --copy   the settings of lesson 139 with which the last of them was pulled, a line each
//   --nodes  the places of the thread at the end of the last attempt, "x y z" a line [m]: what a reader of knots can be tried with.
//            With --log also at each of its lines, to FILE and "." and the time in seconds
//   --shape  a picture (SVG, three views) of thread and instruments at the times that follow
//
// The knot that is foretold is the one of the thread whose ends are led away along the shafts of the instruments that hold them: the throw
// that is tied once the turns have slid off the tips. It is known before anything is drawn down.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>
#include <vector>

#include "base/rng.hpp"
#include "pulled_knot.hpp"
#include "run_lesson.hpp"
#include "scene/chain.hpp"
#include "toolkit/knot/reader.hpp"

namespace swage::stage {
namespace {

using Json = nlohmann::ordered_json;
using toolkit::Pose;
using toolkit::Vec3;

constexpr double kShaft = 40e-3;  // m, of an instrument: far outside of all throws

struct Options {
  std::string lesson, hand, shape, plans, nodes, copy;
  int seeds = 1;
  uint64_t first = 0;
  double off = 0, max_s = 240, log_s = 0;  // m, s, s
  std::vector<std::string> settings;
  std::vector<double> times;  // s, of the pictures
  std::vector<double> frictions;  // of the pulls
};

/// Of the thread in W; from its first end on.
std::vector<Vec3> nodes(const LessonRun& run) {
  const scene::World& world = run.world();
  const scene::ChainView chain(world, world.chain[0]);
  std::vector<Vec3> out;
  for (uint32_t i = 0; i < chain.vertices(); ++i) out.push_back(chain.p(i));
  return out;
}

Pose tool(const LessonRun& run, const char* name) { return Pose(run.world().X_WB[run.body(name)]); }

/// Where the tail is held the thread ends, and its instrument goes on.
std::string foretold(const LessonRun& run) {
  std::vector<Vec3> line = nodes(run);
  const double n = static_cast<double>(line.size() - 1);
  const bool long_end = run.signal("grasp", "grasp.held") != 0, tail = run.signal("tail_grasp", "grasp.held") != 0;
  if (tail) {
    const auto at = static_cast<size_t>(std::clamp(std::ceil(n * run.signal("tail_grasp", "grasp.s")), 1.0, n));
    const Pose X = tool(run, "holder");
    line.resize(at);
    line.push_back(X.p);
    line.emplace_back(X * Vec3(-kShaft, 0, 0));
  }
  if (long_end) {
    const auto at = static_cast<long>(std::clamp(std::floor(n * run.signal("grasp", "grasp.s")) + 1, 1.0, n - 1));
    const Pose X = tool(run, "forceps");
    line.erase(line.begin(), line.begin() + at);
    line.insert(line.begin(), X.p);
    line.insert(line.begin(), X * Vec3(-kShaft, 0, 0));
  }
  toolkit::KnotThread thread;
  toolkit::KnotReader reader;
  toolkit::KnotName name;
  if (!thread.begin(line.front().data(), static_cast<int>(line.size()))) return "?";
  while (!reader.read(thread, 100000, name)) {}
  std::string word = name.certain ? "" : "?";
  for (int i = 0; i < name.word.throws; ++i) {
    const toolkit::KnotThrow& t = name.word.tied[static_cast<size_t>(i)];
    word += (word.empty() || word == "?" ? "" : ",") + std::to_string(t.sign * t.turns);
  }
  return word.empty() ? "-" : word;
}

std::string tied(const LessonRun& run) {
  std::string word;
  for (int i = 1; i <= std::min(6, static_cast<int>(run.signal("knot", "knot.throws"))); ++i)
    word += (word.empty() ? "" : ",") + std::to_string(static_cast<int>(run.signal("knot", "knot.throw_" + std::to_string(i))));
  if (run.signal("knot", "knot.kind") == 5) word += "tangled";
  return word.empty() ? "-" : word;
}

double gap(const LessonRun& run) {
  return run.signal("left_edge", "tissue.shift") + run.signal("right_edge", "tissue.shift");
}

/// `stitch` is the greatest tension at the stitch since the line before [N].
void log(const LessonRun& run, double stitch) {
  const Vec3 h = 1e3 * tool(run, "holder").p, f = 1e3 * tool(run, "forceps").p;
  std::printf("%6.2f %-5s H %6.2f %6.2f %6.2f  F %6.2f %6.2f %6.2f  turns %5.2f behind %5.2f  foretold %-7s tied %-7s  held %.2f %.2f N"
              "  T %5.2f L %5.2f stitch %5.2f grip %5.2f most %6.2f mN  closed %.3f loop %5.2f knot %5.2f to %5.2f loosest %5.2f mm  passages %g %g %g  cut %.3f mm  sliding %g\n",
              run.world().time(), run.phase().c_str(), h.x(), h.y(), h.z(), f.x(), f.y(), f.z(), run.signal("winding", "winding.turns"),
              1e3 * run.signal("winding", "winding.behind"), foretold(run).c_str(), tied(run).c_str(), run.signal("grasp", "grasp.force"),
              run.signal("tail_grasp", "grasp.force"), 1e3 * run.signal("left_stitch", "pull.tension_tail"),
              1e3 * run.signal("right_stitch", "pull.tension_out"), 1e3 * stitch, 1e3 * run.signal("suture", "thread.tension_grip"), 1e3 * run.signal("suture", "thread.tension"), 1e3 * gap(run),
              1e3 * run.signal("knot", "knot.loop"), 1e3 * run.signal("knot", "knot.from"), 1e3 * run.signal("knot", "knot.to"), 1e3 * run.signal("knot", "knot.loosest"),
              run.signal("suture", "thread.passed"), run.signal("winding", "winding.passages"),
              run.signal("knot", "knot.passages"), 1e3 * run.metric("tissue.cut"), run.signal("knot", "knot.sliding"));
  std::fflush(stdout);
}

/// Views from -y, from -x and from above, 40 pixels a millimetre; the long end blue, the tail red.
void draw(const LessonRun& run, const std::string& path) {
  constexpr int axes[3][2] = {{0, 2}, {1, 2}, {0, 1}};
  const std::vector<Vec3> line = nodes(run);
  std::ofstream file(path);
  file << R"(<svg xmlns="http://www.w3.org/2000/svg" width="1800" height="800"><rect width="1800" height="800" fill="white"/>)";
  for (int v = 0; v < 3; ++v) {
    const auto at = [&](const Vec3& p) {
      const double low = axes[v][1] == 2 ? 760 : 400;
      return std::pair{300 + 600 * v + 40e3 * p[axes[v][0]], low - 40e3 * p[axes[v][1]]};
    };
    const auto stroke = [&](const Vec3& a, const Vec3& b, const char* colour, double width) {
      const auto [x, y] = at(a);
      const auto [u, w] = at(b);
      file << "<line x1=\"" << x << "\" y1=\"" << y << "\" x2=\"" << u << "\" y2=\"" << w << "\" stroke=\"" << colour << "\" stroke-width=\"" << width << "\"/>\n";
    };
    for (const auto& [name, colour] : {std::pair{"holder", "#c0a0a0"}, {"forceps", "#a0a0c0"}}) {
      const Pose X = tool(run, name);
      stroke(X.p, X * Vec3(-10e-3, 0, 0), colour, 12);
    }
    for (size_t i = 1; i < line.size(); ++i) {
      char colour[8];
      const int red = static_cast<int>(255 * i / line.size());
      std::snprintf(colour, sizeof colour, "#%02x00%02x", red, 255 - red);
      stroke(line[i - 1], line[i], colour, 2);
    }
    stroke({-9e-3, 0, 1.5e-3}, {9e-3, 0, 1.5e-3}, "#888888", 0.5);
  }
  file << "</svg>\n";
}

void write_nodes(const LessonRun& run, const std::string& path) {
  std::ofstream file(path);
  file.precision(17);
  for (const Vec3& p : nodes(run)) file << p.x() << " " << p.y() << " " << p.z() << "\n";
}

/// The same plan, each coordinate of its places and ways off by as much.
std::string off_plan(const std::string& path, double off, base::Xoshiro256& random, const std::string& to) {
  std::ifstream file(path);
  Json plan = Json::parse(file);
  const auto normal = [&] {  // a sum of twelve
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random.uniform();
    return sum;
  };
  for (Json& act : plan["acts"])
    for (const char* key : {"at", "by"})
      if (act.contains(key) && act[key].is_array())
        for (Json& x : act[key]) x = std::to_string(1e-3 * std::strtod(x.get<std::string>().c_str(), nullptr) + off * normal()) + " m";
  std::ofstream(to) << plan.dump(1);
  return to;
}

/// The plans of that hand from another folder.
void take_plans(assembly::LessonFile& file, const Options& o) {
  for (assembly::LessonDevice& device : file.devices)
    for (assembly::DeviceChoice& choice : device.choices) {
      if (choice.as != o.hand) continue;
      Json params = Json::parse(choice.params);
      params["file"] = (std::filesystem::absolute(o.plans) / (params["gripper"] == "holder" ? "holder.json" : "winder.json")).string();
      choice.params = params.dump();
    }
}

void put_off(assembly::LessonFile& file, const Options& o, uint64_t seed) {
  base::Xoshiro256 random(977 * seed + 1);
  const std::filesystem::path folder = std::filesystem::absolute(o.lesson).parent_path();
  for (assembly::LessonDevice& device : file.devices)
    for (assembly::DeviceChoice& choice : device.choices) {
      Json params = choice.params.empty() ? Json::object() : Json::parse(choice.params);
      if (choice.as != o.hand || !params.contains("file")) continue;
      const std::string to = std::filesystem::temp_directory_path() / ("knot_trials_" + std::to_string(getpid()) + "_" + device.name + ".json");
      params["file"] = off_plan(folder / params["file"].get<std::string>(), o.off, random, to);
      choice.params = params.dump();
    }
}

/// OBJECT.PARAMETER=VALUE of an object or a coupling.
void set(assembly::LessonFile& file, const std::string& setting) {
  const size_t dot = setting.find('.'), is = setting.find('=');
  if (dot == std::string::npos || is == std::string::npos) std::printf("%s is no setting\n", setting.c_str()), std::exit(2);
  const std::string name = setting.substr(0, dot), key = setting.substr(dot + 1, is - dot - 1), value = setting.substr(is + 1);
  const auto put = [&](auto& all) {
    for (auto& one : all)
      if (one.name == name) {
        Json params = one.params.empty() ? Json::object() : Json::parse(one.params), parsed = Json::parse(value, nullptr, false);
        params[key] = parsed.is_discarded() ? Json(value) : parsed;
        one.params = params.dump();
      }
  };
  put(file.objects), put(file.couplings);
}

bool try_it(const Options& o, uint64_t seed) {
  LessonRun run(o.lesson, {o.hand, ""}, [&](assembly::LessonFile& file) {
    file.seed = seed;
    for (const std::string& setting : o.settings) set(file, setting);
    if (!o.plans.empty()) take_plans(file, o);
    if (o.off > 0) put_off(file, o, seed);
  });
  if (!run.ready() || !run.problems().empty()) {
    std::printf("%s\n", run.problems().c_str());
    std::exit(1);
  }
  double next_log = o.log_s, pull = 0, stitch = 0, logged = 0;  // s, N, N, N
  size_t picture = 0;
  while (run.outcome() == "running" && run.world().time() < o.max_s && !run.engine().hand_gone()) {
    run.step();
    pull = std::max(pull, run.signal("suture", "thread.tension"));
    const double now = std::max(run.signal("left_stitch", "pull.tension_tail"), run.signal("right_stitch", "pull.tension_out"));
    stitch = std::max(stitch, now), logged = std::max(logged, now);
    if (o.log_s > 0 && run.world().time() >= next_log) {
      log(run, logged);
      logged = 0;
      if (!o.nodes.empty()) write_nodes(run, o.nodes + "." + std::to_string(std::lround(run.world().time())));
      next_log += o.log_s;
    }
    if (picture < o.times.size() && run.world().time() >= o.times[picture])
      draw(run, o.shape + std::to_string(picture) + ".svg"), ++picture;
  }
  std::printf("seed %3llu %-7s %-18s %5.1f points %6.2f s  tied %-8s passages %g  closed by %.3f mm  most tension %.1f, at the stitch %.1f mN  cut %.3f"
              "  loop %.2f  loosest %.2f mm  sliding %g  drops %g  late: %s\n",
              static_cast<unsigned long long>(seed), run.outcome().c_str(), run.reason().c_str(), run.verdict().score, run.world().time(), tied(run).c_str(),
              run.signal("suture", "thread.passed") + run.signal("winding", "winding.passages") + run.signal("knot", "knot.passages"), 1e3 * gap(run), 1e3 * pull, 1e3 * stitch, 1e3 * run.metric("tissue.cut"),
              1e3 * run.signal("knot", "knot.loop"), 1e3 * run.signal("knot", "knot.loosest"), run.signal("knot", "knot.sliding"), run.metric("thread.drops"),
              base::text(run.engine().stats().health).c_str());
  for (const char* what : {"undone", "drops", "tension", "force", "cut", "time"})
    if (const double points = run.metric(std::string("points.") + what); points > 0) std::printf("  lost for %s: %.1f points\n", what, points);
  std::fflush(stdout);
  if (!o.nodes.empty()) write_nodes(run, o.nodes);
  for (const double friction : o.frictions) {
    const PulledKnot pulled = pull_apart(run, friction, 0.1);
    std::printf("  pulled with friction %.2f: %s, bears %.1f mN, slips %.2f mm %s%s\n", friction, pulled.copy.word.c_str(), 1e3 * pulled.bears, 1e3 * pulled.slip,
                pulled.problems.c_str(), pulled.health.c_str());
    if (std::ofstream file(o.copy); file)
      for (const std::string& setting : pulled.copy.settings) file << setting << "\n";
    std::fflush(stdout);
  }
  return run.outcome() == "passed";
}

Options options(int argc, char** argv) {
  Options o;
  o.lesson = argv[1], o.hand = argv[2];
  for (int i = 3; i + 1 < argc; i += 2) {
    const std::string key = argv[i];
    const char* const value = argv[i + 1];
    if (key == "--seeds") o.seeds = std::atoi(value);
    else if (key == "--first") o.first = std::strtoull(value, nullptr, 10);
    else if (key == "--off") o.off = 1e-6 * std::strtod(value, nullptr);
    else if (key == "--max") o.max_s = std::strtod(value, nullptr);
    else if (key == "--log") o.log_s = std::strtod(value, nullptr);
    else if (key == "--set") o.settings.emplace_back(value);
    else if (key == "--plans") o.plans = value;
    else if (key == "--nodes") o.nodes = value;
    else if (key == "--copy") o.copy = value;
    else if (key == "--pull") o.frictions.push_back(std::strtod(value, nullptr));
    else if (key == "--shape") {
      o.shape = value;
      for (i += 2; i < argc; ++i) o.times.push_back(std::strtod(argv[i], nullptr));
    } else std::printf("%s is not known\n", key.c_str()), std::exit(2);
  }
  return o;
}

}  // namespace
}  // namespace swage::stage

int main(int argc, char** argv) {
  using namespace swage::stage;
  if (argc < 3) return std::printf("knot_trials LESSON HAND [options]\n"), 2;
  const Options o = options(argc, argv);
  int passed = 0;
  for (int i = 0; i < o.seeds; ++i) passed += try_it(o, o.first + static_cast<uint64_t>(i));
  std::printf("%d of %d passed\n", passed, o.seeds);
  return 0;
}
