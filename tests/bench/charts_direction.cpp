// SPDX-License-Identifier: Apache-2.0
//
// What Newton's direction of a thread of 100 nodes costs over the number of its contacts (thread_direction.hpp), as a share of ODE's exact grasp step.
#include "charts.hpp"
#include "dynamics/dense.hpp"
#include "ode_grasp_step.hpp"
#include "thread_direction.hpp"
#include "timing.hpp"

namespace swage::bench {
namespace {

constexpr double kPromised = 6;  // times ODE's exact grasp step, with 60 contacts

/// Median of so many calls [ns].
template <class F>
double median_ns(int calls, F&& f) {
  std::vector<double> ns;
  for (int i = 0; i < calls; ++i) {
    const double begin = cpu_ns();
    f();
    ns.push_back(cpu_ns() - begin);
  }
  return times(ns).median;
}

/// A direction: rod assembled, then solved.
double way_ns(direction::Way way, uint32_t contacts) {
  direction::Scene k(contacts);
  return median_ns(100, [&] { k.assemble(), way(k); });
}
/// The dense factor of 3 m rows: no way over the forces of contacts costs less.
double dense_ns(uint32_t contacts) {
  const size_t n = size_t{3} * contacts;
  std::vector<double> W(n * n, 0.1), a;
  for (size_t i = 0; i < n; ++i) W[i * n + i] = static_cast<double>(n);
  return median_ns(100, [&] { a = W, dynamics::ldl_factor(n, a.data()); });
}

}  // namespace

Sweep chart_directions(bool quick) {
  Sweep c;
  c.title = "Newton's direction of a thread of 100 nodes";
  c.x = {"contacts, a third each with itself, with a needle and with what stands", 0, 120, false, "", ""};
  c.y = {"time over that of ODE's exact grasp step", 0.1, 1000, true, "", ""};
  c.pass = kPromised;
  struct Case {
    const char *family, *name;
    double (*ns)(uint32_t);
  };
  const Case cases[] = {{"swage", "swage, sparse blocks of a node", [](uint32_t m) { return way_ns(direction::by_blocks, m); }},
                        {"textbook", "band with a border and a low rank", [](uint32_t m) { return way_ns(direction::by_woodbury, m); }},
                        {"textbook", "Delassus operator by the band", [](uint32_t m) { return way_ns(direction::by_delassus, m); }},
                        {"textbook", "its dense factor alone (Green's function)", dense_ns}};
  for (const Case& one : cases) c.lines.push_back({one.family, one.name, {}, false});
  for (const uint32_t m : {20u, 60u, 100u}) {
    std::vector<double> ode;
    std::vector<std::vector<double>> ns(std::size(cases));
    for (int round = 0; round < (quick ? 1 : 5); ++round) {
      ode.push_back(ode_grasp_step());
      for (size_t i = 0; i < std::size(cases); ++i) ns[i].push_back(cases[i].ns(m));
    }
    for (size_t i = 0; i < std::size(cases); ++i) c.lines[i].points.emplace_back(m, times(ns[i]).median / times(ode).median);
  }
  return c;
}

}  // namespace swage::bench
