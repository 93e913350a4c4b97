// SPDX-License-Identifier: Apache-2.0
#include "charts.hpp"

#include "queries.hpp"
#include "scenario.hpp"
#include "top_reference.hpp"

namespace swage::bench {
namespace {

std::vector<Method> those_that_differ(Method::Differs where) {
  std::vector<Method> some;
  for (Method& m : all_methods())
    if (m.differs == Method::Differs::kEverywhere || m.differs == where) some.push_back(std::move(m));
  return some;
}

/// Costs of all, `rounds` times in turn: median of each one's medians, ns.
template <class Cost>
std::vector<double> interleaved(const std::vector<Method>& methods, int rounds, Cost&& cost) {
  std::vector<std::vector<double>> ns(methods.size());
  for (int round = 0; round < rounds; ++round)
    for (size_t i = 0; i < methods.size(); ++i) ns[i].push_back(cost(methods[i]));
  std::vector<double> medians;
  for (auto& each : ns) medians.push_back(times(std::move(each)).median);
  return medians;
}

std::string seconds_text(double seconds) { return std::to_string(static_cast<int>(seconds)) + " s"; }

constexpr int kRounds = 5;

}  // namespace

Scatter chart_queries(bool quick) {
  Scatter c;
  c.title = "Needle against jaws: one query, 10,000 poses";
  c.x = {"worst error of a depth against the exact arc, um", 1e-13, 100, true, "rounding", "misses contacts"};
  c.y = {"mean time of a query, ns", 100, 1e6, true, "", ""};
  for (const QueryFigures& f : measure_queries(Needle{}, quick ? 3 : 5, quick ? 1000 : 10000))
    c.marks.push_back({f.family, f.name, std::max(f.worst_error * 1e6, 1e-13), f.all.mean, ""});
  return c;
}

Scatter chart_free(bool quick) {
  const double seconds = quick ? 5 : 60;
  const Vec3 I{1e-12, 2e-12, 3e-12}, w0 = 30 * Vec3(0.01, 1, 0.01).normalized();
  const Quat exact = top_reference(I, w0, seconds);
  Scatter c;
  c.title = "Free rigid body: asymmetric top at 30 rad/s, steps of 4, 2, 1 and 0.5 ms";
  c.x = {"error of the attitude after " + seconds_text(seconds) + ", rad", 1e-10, 10, true, "", "lost"};
  c.y = {"time per simulated ms, ns", 10, 1e5, true, "", ""};
  const std::vector<Method> methods = those_that_differ(Method::Differs::kFree);
  for (double dt : {4e-3, 2e-3, 1e-3, 0.5e-3}) {
    Setup s;
    s.dt = dt;
    const std::vector<double> cost =
        interleaved(methods, kRounds, [&](const Method& m) { return top(m, s, I, w0, 0.5).step.median; });
    for (size_t i = 0; i < methods.size(); ++i) {
      const TopResult r = top(methods[i], s, I, w0, seconds);
      const bool lost = r.diverged_at >= 0 || !r.end.coeffs().allFinite();
      const double error = lost ? 10 : r.end.normalized().angularDistance(exact);
      c.marks.push_back({methods[i].family, methods[i].name, std::max(error, 1e-10), cost[i] / (dt / 1e-3),
                         "step of " + std::to_string(dt * 1e3).substr(0, 3) + " ms"});
    }
  }
  return c;
}

Scatter chart_grasp(bool quick) {
  const double seconds = quick ? 2 : 60;
  Scatter c;
  c.title = "Grasp: curved needle held under gravity, overlap 1 um";
  c.x = {"slip after " + seconds_text(seconds) + ", um", 1e-7, 1e3, true, "none measurable", "lost"};
  c.y = {"median time of a step of 1 ms, ns", 100, 1e6, true, "", ""};
  const std::vector<Method> methods = those_that_differ(Method::Differs::kInContact);
  const std::vector<double> cost =
      interleaved(methods, kRounds, [](const Method& m) { return hold(m, {}, 1e-6, 0.2).step.median; });
  for (size_t i = 0; i < methods.size(); ++i) {
    const HoldResult r = hold(methods[i], {}, 1e-6, seconds);
    c.marks.push_back({methods[i].family, methods[i].name,
                       r.lost_at < 0 ? std::max(r.worst * 1e6, 1e-7) : 1e9, cost[i], ""});
  }
  return c;
}

Scatter chart_slip(bool) {
  Scatter c;
  c.title = "Friction: straight wire pinched with 0.1 N and pulled, where it begins to slip";
  c.x = {"|pull at first slip / Coulomb limit - 1|", 1e-4, 1, true, "exact", "lost or never"};
  c.y = {"median time of a step of 1 ms, ns", 100, 1e6, true, "", ""};
  Setup s;
  s.needle.straight = true;
  for (const Method& m : those_that_differ(Method::Differs::kInContact)) {
    if (m.name == "MuJoCo tuned, welded tool") continue;  // has no jaw on a hinge under a torque
    const PullResult r = pull(m, s, 0.1, Pull::kAxial);
    const bool lost = !(r.onset > 0) || !std::isfinite(r.onset);
    // who lost the wire before the pull is shown with what a held needle costs it
    const double cost = r.step.median > 0 ? r.step.median : hold(m, s, 1e-6, 0.2).step.median;
    c.marks.push_back({m.family, m.name, lost ? 10 : std::max(std::abs(r.onset - 1), 1e-4), cost, ""});
  }
  return c;
}

}  // namespace swage::bench
