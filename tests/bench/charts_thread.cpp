// SPDX-License-Identifier: Apache-2.0
//
// The thread against textbook methods: 18.9 mm of 10-0 nylon held level by one end (heavy elastica, length^3 = EI / weight per length).
// How far the free end hangs from the exact place, and what a simulated millisecond costs.
//
//   rod          toolkit/rod.hpp, one step of 1 ms
//   chain        the same without bending
//   springs      point masses on springs, explicit, at half of the longest step that is stable: 800 a millisecond with 5 segments, 6300 with 40
//   positions    the same by position-based dynamics (XPBD), Gauss-Seidel, one step of 1 ms with so many iterations
//   direct       the same constraints, all at once by their band (Deul et al. 2018), two iterations a step
//   MuJoCo, Bullet  their ropes (peers/*_rope.cpp), one step of 1 ms
//
// The textbook's first two points are held, as their clamp has no half cell.
#include <array>
#include <cmath>
#include <functional>

#include "charts.hpp"
#include "peers/rope.hpp"
#include "timing.hpp"
#include "toolkit/band.hpp"
#include "toolkit/rod.hpp"

namespace swage::bench {
namespace {

using toolkit::Vec3;

constexpr double kGravity = 9.80665, kStep = 1e-3;  // m/s2, s

toolkit::RodSection thread_section() { return toolkit::RodSection::round(22e-6, 2.5e9, 0.39, 1140); }
double hanging_length() { return std::cbrt(thread_section().bending / (thread_section().mass * kGravity)); }

/// Off the exact place, over the length, and cost of a millisecond [ns].
struct Figures {
  double error = 0, ns = 0;
};
double off(const Vec3& end) { return (end / hanging_length() - Vec3(0.991246, 0, -0.123471)).norm(); }

/// Settles for `settle` milliseconds, then times some.
template <class Millisecond, class End>
Figures figures(int settle, int timed, Millisecond&& millisecond, End&& end) {
  for (int i = 0; i < settle; ++i) millisecond();
  std::vector<double> ns;
  for (int i = 0; i < timed; ++i) {
    const double begin = cpu_ns();
    millisecond();
    ns.push_back(cpu_ns() - begin);
  }
  const double error = off(end());
  return {std::isfinite(error) ? error : HUGE_VAL, times(ns).median};
}

Figures hang_rod(int edges, bool bends) {
  toolkit::RodSection section = thread_section();
  if (!bends) section.bending = section.twisting = 0;
  const double length = hanging_length();
  toolkit::Rod rod(section, std::vector<double>(static_cast<size_t>(edges), length / edges));
  std::vector<double> numbers(toolkit::RodState::size(edges + 1));
  toolkit::RodState s(edges + 1, numbers.data());
  for (int i = 0; i <= edges; ++i) s.x[3 * i] = length / edges * i;
  rod.hold(0);
  rod.clamp(0) = {true, Vec3::UnitX(), Vec3::UnitY()};
  rod.start(s);
  toolkit::RodLoad load;
  load.h = kStep;
  load.gravity = {0, 0, -kGravity};
  return figures(4000, 500, [&] { rod.step(s, load, 6, 1e-9 * length); }, [&] { return s.node(edges); });
}

/// Points of mass m on springs of k along each segment, and b |x0 - 2 x1 + x2|^2 / 2 at each joint.
struct Points {
  explicit Points(int segments) : n(static_cast<size_t>(segments) + 1), l(hanging_length() / segments), x(n), v(n, Vec3::Zero()), f(n) {
    const toolkit::RodSection s = thread_section();
    m = s.mass * l, k = s.stretching / l, b = s.bending / (l * l * l);
    for (size_t i = 0; i < n; ++i) x[i] = l * static_cast<double>(i) * Vec3::UnitX();
  }
  double mass(size_t i) const { return i + 1 < n ? m : 0.5 * m; }

  /// Explicit: speeds first, then places.
  void springs(double h, double damping) {
    for (size_t i = 0; i < n; ++i) f[i] = -mass(i) * kGravity * Vec3::UnitZ();
    for (size_t j = 0; j + 1 < n; ++j) {
      const Vec3 e = x[j + 1] - x[j];
      const double length = e.norm();
      const Vec3 pull = k * (length - l) / length * e;
      f[j] += pull, f[j + 1] -= pull;
    }
    for (size_t i = 1; i + 1 < n; ++i) {
      const Vec3 bow = b * (x[i - 1] - 2 * x[i] + x[i + 1]);
      f[i - 1] -= bow, f[i] += 2 * bow, f[i + 1] -= bow;
    }
    for (size_t i = 2; i < n; ++i) {
      v[i] = (v[i] + h / mass(i) * f[i]) / (1 + h * damping);
      x[i] += h * v[i];
    }
  }
  /// Steps of half of what is stable for the highest wave, 2 sqrt(k / m).
  int steps() const { return static_cast<int>(std::ceil(kStep / (0.5 * std::sqrt(m / k)))); }

  void positions(double h, double damping, int iterations) {
    begun = x;
    along.assign(n, 0.0), across.assign(n, Vec3::Zero());
    for (size_t i = 2; i < n; ++i) x[i] += h / (1 + h * damping) * (v[i] - h * kGravity * Vec3::UnitZ());
    for (int it = 0; it < iterations; ++it) {
      for (size_t j = 1; j + 1 < n; ++j) {
        const Vec3 e = x[j + 1] - x[j];
        const double length = e.norm(), soft = 1 / (k * h * h), w0 = weight(j), w1 = weight(j + 1);
        const double more = (-(length - l) - soft * along[j]) / (w0 + w1 + soft);
        along[j] += more;
        x[j] -= w0 * more / length * e, x[j + 1] += w1 * more / length * e;
      }
      for (size_t i = 1; i + 1 < n; ++i) {
        const Vec3 bow = x[i - 1] - 2 * x[i] + x[i + 1];
        const double soft = 1 / (b * h * h), w[3] = {weight(i - 1), weight(i), weight(i + 1)};
        const Vec3 more = (-bow - soft * across[i]) / (w[0] + 4 * w[1] + w[2] + soft);
        across[i] += more;
        x[i - 1] += w[0] * more, x[i] -= 2 * w[1] * more, x[i + 1] += w[2] * more;
      }
    }
    for (size_t i = 2; i < n; ++i) v[i] = (x[i] - begun[i]) / h;
  }
  double weight(size_t i) const { return i < 2 ? 0 : 1 / mass(i); }

  /// Joint i and the segment after it are unknowns 4 (i - 1) to 4 (i - 1) + 3: what shares a point is 10 of them apart at most.
  void direct(double h, double damping, int iterations) {
    begun = x;
    const size_t joints = n - 2, unknowns = 4 * joints;
    std::vector<double> gone(unknowns, 0.0), more(unknowns);
    std::vector<Row> row(unknowns);
    toolkit::Band<10> A(static_cast<int>(unknowns));
    for (size_t i = 2; i < n; ++i) x[i] += h / (1 + h * damping) * (v[i] - h * kGravity * Vec3::UnitZ());
    for (int it = 0; it < iterations; ++it) {
      A.set_zero();
      for (size_t c = 0; c < unknowns; ++c) row[c] = constraint(c);
      for (size_t c = 0; c < unknowns; ++c) {
        const double soft = 1 / ((c % 4 == 3 ? k : b) * h * h);
        more[c] = -row[c].value - soft * gone[c];
        for (size_t d = c; d < std::min(unknowns, c + 11); ++d)
          if (c % 4 == d % 4 || c % 4 == 3 || d % 4 == 3) A.at(static_cast<int>(d), static_cast<int>(c)) = row[c].coupled(row[d], *this);
        A.at(static_cast<int>(c), static_cast<int>(c)) += soft;
      }
      if (!A.factor()) return;
      A.solve(more.data());
      for (size_t c = 0; c < unknowns; ++c) {
        gone[c] += more[c];
        for (size_t p = 0; p < row[c].points; ++p) x[row[c].first + p] += weight(row[c].first + p) * more[c] * row[c].gradient[p];
      }
    }
    for (size_t i = 2; i < n; ++i) v[i] = (x[i] - begun[i]) / h;
  }
  /// One constraint: its value and gradient at two or three points.
  struct Row {
    size_t first = 0, points = 0;
    double value = 0;
    std::array<Vec3, 3> gradient{};
    double coupled(const Row& later, const Points& of) const {
      double sum = 0;
      for (size_t p = later.first; p < std::min(first + points, later.first + later.points); ++p)
        if (p >= first) sum += of.weight(p) * gradient[p - first].dot(later.gradient[p - later.first]);
      return sum;
    }
  };
  Row constraint(size_t c) const {
    const size_t i = c / 4 + 1;
    Row row;
    if (c % 4 == 3) {
      const Vec3 e = x[i + 1] - x[i];
      row.first = i, row.points = 2, row.value = e.norm() - l;
      row.gradient = {-e.normalized(), e.normalized(), Vec3::Zero()};
    } else {
      const auto r = static_cast<int>(c % 4);
      row.first = i - 1, row.points = 3, row.value = (x[i - 1] - 2 * x[i] + x[i + 1])[r];
      row.gradient = {Vec3::Unit(r), -2 * Vec3::Unit(r), Vec3::Unit(r)};
    }
    return row;
  }

  size_t n;
  double l, m = 0, k = 0, b = 0;
  std::vector<Vec3> x, v, f, begun;
  std::vector<double> along;  // multipliers of the segments, and of the joints
  std::vector<Vec3> across;
};

constexpr double kDamping = 30;  // 1/s: at rest after half a second; the rod has that of its step

Figures hang_springs(int segments) {
  Points p(segments);
  const int steps = p.steps();
  return figures(600, 20, [&] { for (int i = 0; i < steps; ++i) p.springs(kStep / steps, kDamping); }, [&] { return p.x.back(); });
}
Figures hang_positions(int segments, int iterations) {
  Points p(segments);
  return figures(2000, 200, [&] { p.positions(kStep, kDamping, iterations); }, [&] { return p.x.back(); });
}
Figures hang_direct(int segments) {
  Points p(segments);
  return figures(2000, 200, [&] { p.direct(kStep, kDamping, 2); }, [&] { return p.x.back(); });
}
Figures hang_rope(std::unique_ptr<Rope> (*make)(const RopeSetup&), int segments, int iterations) {
  const toolkit::RodSection section = thread_section();
  const auto rope = make({segments, hanging_length(), section.mass, section.bending, 2 * section.radius, iterations});
  return figures(2000, 200, [&] { rope->step(); }, [&] { return rope->end(); });
}

}  // namespace

Scatter chart_thread(bool quick) {
  Scatter c;
  c.title = "Thread held level by one end: 18.9 mm of 10-0 nylon";
  c.x = {"error of the free end over the length, against the exact elastica", 1e-6, 1, true, "", "falls"};
  c.y = {"time per simulated ms, ns", 1e3, 1e8, true, "", ""};
  struct Case {
    const char *family, *name;
    std::string setting;
    std::function<Figures()> hang;
  };
  std::vector<Case> cases;
  for (const int n : {5, 10, 20, 50, 99})
    cases.push_back({"swage", "rod, 5 to 99 segments", std::to_string(n), [n] { return hang_rod(n, true); }});
  cases.push_back({"swage", "chain without bending, 20 segments", "", [] { return hang_rod(20, false); }});
  for (const int n : quick ? std::vector<int>{5, 10} : std::vector<int>{5, 10, 20, 40})
    cases.push_back({"textbook", "springs, explicit", std::to_string(n), [n] { return hang_springs(n); }});
  for (const int n : {1, 10, 100, 1000})
    cases.push_back({"textbook", "positions (XPBD), 20 segments", std::to_string(n), [n] { return hang_positions(20, n); }});
  for (const int n : {5, 10, 20, 50})
    cases.push_back({"textbook", "positions, all at once by their band", std::to_string(n), [n] { return hang_direct(n); }});
  for (const int n : {5, 10, 20, 50})
    if (mujoco_rope({})) cases.push_back({"MuJoCo", "MuJoCo, rods with springs in their joints", std::to_string(n), [n] { return hang_rope(mujoco_rope, n, 0); }});
  for (const int n : {1, 10, 100})
    if (bullet_rope({})) cases.push_back({"Bullet", "Bullet, soft body rope, 20 segments", std::to_string(n), [n] { return hang_rope(bullet_rope, 20, n); }});
  std::vector<std::vector<double>> ns(cases.size());
  std::vector<double> error(cases.size());
  for (int round = 0; round < (quick ? 1 : 3); ++round)
    for (size_t i = 0; i < cases.size(); ++i) {
      const Figures f = cases[i].hang();
      ns[i].push_back(f.ns), error[i] = f.error;
    }
  for (size_t i = 0; i < cases.size(); ++i)
    c.marks.push_back({cases[i].family, cases[i].name, error[i], times(ns[i]).median, cases[i].setting});
  return c;
}

}  // namespace swage::bench
