// SPDX-License-Identifier: Apache-2.0
#include "counted.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <vector>

#include "base/hash.hpp"
#include "../knots/pull.hpp"
#include "lesson_step.hpp"
#include "phases.hpp"
#include "thread_loop.hpp"

namespace swage::bench {
namespace {

using stage::LessonRun;

/// The steps of `counts` are counted, until `over`.
struct CountScene {
  const char* name;
  std::function<std::unique_ptr<LessonRun>()> make;
  bool (*counts)(const LessonRun&);
  bool (*over)(const LessonRun&);
};

bool ended(const LessonRun& run) { return run.verdict().outcome != judge::Outcome::kRunning || run.world().time() > 60; }
bool in_tissue(const LessonRun& run) { return inserted(run); }
bool lifted(const LessonRun& run) { return run.world().time() > kHeldFrom; }
bool put_down(const LessonRun& run) { return run.world().time() > kHeldUntil; }

const CountScene kScenes[] = {
    {"thread", [] { return thread_loop("rigid", true); }, carried, ended},
    {"tray", [] { return thread_loop("rigid", false); }, carried, ended},
    {"tissue", [] { return thread_loop("bending", false); }, in_tissue, ended},
    {"needle_rigid", [] { return held_lesson("rigid", 12); }, lifted, put_down},
    {"needle_8", [] { return held_lesson("bending", 8); }, lifted, put_down},
    {"needle_12", [] { return held_lesson("bending", 12); }, lifted, put_down},
};

/// What one step took.
struct Counted {
  double time = 0;  // s
  uint64_t directions = 0, refreshed = 0, fallbacks = 0, divided = 0, work = 0, contacts = 0;
};

/// A name that callgrind finds.
[[gnu::noinline]] void counted_step(LessonRun& run) {
  run.step();
  asm volatile("" ::: "memory");
}

template <class Of>
void print(const char* name, const std::vector<Counted>& all, const Of& of) {
  std::vector<double> x;
  double sum = 0;
  for (const Counted& c : all) x.push_back(static_cast<double>(of(c))), sum += x.back();
  std::sort(x.begin(), x.end());
  const auto at = [&](double q) { return x[std::min(x.size() - 1, static_cast<size_t>(q * static_cast<double>(x.size())))]; };
  std::printf("%-22s mean %10.4g  median %9.4g  p99 %9.4g  p99.9 %9.4g  most %9.4g\n", name, sum / static_cast<double>(x.size()), at(0.5),
              at(0.99), at(0.999), x.back());
}

void write_list(const std::string& path, const std::vector<Counted>& all) {
  std::ofstream out(path);
  out << "time_s,directions,passes_more,fallbacks,divided,work,contacts\n";
  for (const Counted& c : all)
    out << c.time << ',' << c.directions << ',' << c.refreshed << ',' << c.fallbacks << ',' << c.divided << ',' << c.work << ',' << c.contacts << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

Counted count(LessonRun& run, bool one_of_those_counted) {
  const dynamics::Stats before = run.engine().stats();
  const uint64_t divided = run.engine().divided();
  one_of_those_counted ? counted_step(run) : run.step();
  const dynamics::Stats& now = run.engine().stats();
  return {run.world().time(),           now.newton - before.newton, now.refreshed - before.refreshed, now.fallbacks - before.fallbacks,
          run.engine().divided() - divided, now.work - before.work,     run.engine().contacts().contact.size()};
}

/// Knots that are pulled; what a step took is told phase by phase.
struct CountKnot {
  const char* name;
  test::Word word;
  double pretension;  // N
  double keep = 0.2;  // s, under the load
};
const CountKnot kCountKnots[] = {{"knot_square", {1, -1}, 30e-3}, {"knot_surgeon", {2, -1, 1}, 100e-3}, {"knot_kept", {2, -1, 1}, 100e-3, 2}};

void count_knot(const CountKnot& knot) {
  test::PullTest wanted;
  wanted.word = knot.word, wanted.pretension = knot.pretension, wanted.keep = knot.keep;
  const test::PullResult r = test::pull(wanted);
  std::printf("%s: %s, most %.6f mN, slip %.6f and %.6f um\n", knot.name, test::text(r.end), 1e3 * r.most, 1e6 * r.slip[0], 1e6 * r.slip[1]);
  const std::pair<const char*, const test::PullPhase*> phases[] = {{"tighten", &r.tighten}, {"rest", &r.rest}, {"pull", &r.pull}};
  for (const auto& [name, p] : phases)
    std::printf("%-10s %6d steps, %6.2f search directions a step, %llu not converged, %d passages, %zu contacts that bear, a step %.3g ms, p99.9 %.3g, most %.3g\n",
                name, p->steps, static_cast<double>(p->directions) / std::max(1, p->steps), static_cast<unsigned long long>(p->not_converged),
                p->passages, p->bearing, 1e-3 * p->median_us, 1e-3 * p->p999_us, 1e-3 * p->most_us);
}

}  // namespace

std::string count_scenes() {
  std::string all;
  for (const CountKnot& k : kCountKnots) all += std::string(k.name) + ", ";
  bool first = true;
  for (const CountScene& s : kScenes) all += (first ? "" : ", ") + std::string(s.name), first = false;
  return all;
}

int run_count(const CountWanted& wanted) {
  for (const CountKnot& k : kCountKnots)
    if (k.name == wanted.scene) return count_knot(k), 0;
  const auto scene = std::find_if(std::begin(kScenes), std::end(kScenes), [&](const CountScene& s) { return s.name == wanted.scene; });
  if (scene == std::end(kScenes)) throw std::runtime_error("no scene \"" + wanted.scene + "\"; there are " + count_scenes());
  const auto run = scene->make();
  if (!run->ready()) throw std::runtime_error(run->problems());
  std::vector<Counted> all;
  base::Hash hash;
  bool counts = false;  // the step to come, by the state before it
  for (int k = 0; !scene->over(*run);) {
    const Counted c = count(*run, counts && k++ % std::max(1, wanted.every) == 0);
    hash.add(run->engine().hash());
    counts = scene->counts(*run);
    if (counts) all.push_back(c);
  }
  if (all.empty()) throw std::runtime_error("no step of the scene counts");
  std::printf("%s: %zu steps that count, hash of all %016llx\n", scene->name, all.size(), static_cast<unsigned long long>(hash.value()));
  print("search directions", all, [](const Counted& c) { return c.directions; });
  print("passes after the first", all, [](const Counted& c) { return c.refreshed; });
  print("islands fallen back", all, [](const Counted& c) { return c.fallbacks; });
  print("divisions", all, [](const Counted& c) { return c.divided; });
  print("contacts", all, [](const Counted& c) { return c.contacts; });
  print("multiply-adds, solver", all, [](const Counted& c) { return c.work; });
  if (!wanted.list.empty()) write_list(wanted.list, all);
  const bool more = std::any_of(all.begin(), all.end(), [&](const Counted& c) { return wanted.most > 0 && c.directions > static_cast<uint64_t>(wanted.most); });
  if (more) std::printf("a step takes more than %d search directions\n", wanted.most);
  return more ? 1 : 0;
}

}  // namespace swage::bench
