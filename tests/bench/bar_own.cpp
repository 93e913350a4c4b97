// SPDX-License-Identifier: Apache-2.0
//
// Shots at thin things, and couples on light needles: what S46 and S47 of the stability catalogue sweep.
#include "bar.hpp"
#include "couple.hpp"
#include "own.hpp"
#include "shots.hpp"

namespace swage::bench {

std::vector<Line> bar_shots(const Effort& effort) {
  const int shots = effort.hold_seconds < 10 ? 4 : 24;
  std::vector<Line> lines;
  for (const auto& [target, size, name] : {std::tuple{Target::kPlate, 0.1e-3, "plate of 0.1 mm"},
                                           {Target::kPlate, 0.3e-3, "plate of 0.3 mm"},
                                           {Target::kRod, 0.1e-3, "rod"},
                                           {Target::kMovingRod, 0.1e-3, "rod that comes"},
                                           {Target::kNeedle, 0.1e-3, "needle"}}) {
    ShotCounts all;
    for (const double restitution : {0.0, 0.5})
      for (const double speed : {0.05, 0.15, 0.3, 0.7, 1.7, 5.0}) {
        ShotSetup s;
        s.target = target, s.size = size, s.speed = speed, s.restitution = restitution;
        all += shoot(s, 0, shots);
      }
    const std::string at = std::string("needles at a ") + name + ", 0.05 to 5 m/s: ";
    const std::string of = "of " + std::to_string(all.shots) + ", " + std::to_string(all.hit) + " hit";
    lines.push_back(none("S46", at + "gone through", all.passed, of));
    lines.push_back(none("S46", at + "stuck", all.stuck, of));
    lines.push_back(none("S46", at + "with more energy", all.gained, of));
  }
  return lines;
}

std::vector<Line> bar_couple(const Effort&) {
  int cases = 0, stay = 0, early = 0;
  uint64_t not_converged = 0;
  double off = 0;
  for (const double share : {0.25, 0.375, 0.5, 0.625})
    for (const double times : {0.95, 1.05, 1.5, 3.0}) {
      WringSetup s;
      s.share = share, s.times = times, s.dt = 3e-5;
      const double fine = wring(s).turned;
      s.dt = 1e-3;
      for (const double radius : {25e-6, 50e-6}) {
        s.wire_radius = radius;
        const WringResult r = wring(s);
        not_converged += r.not_converged;
        early += times < 1 && r.turned > 0.02;
        if (times < 1) continue;
        ++cases, stay += r.turned < 0.2;
        off = std::max(off, std::abs(r.turned - fine));
      }
    }
  const std::string of = "of " + std::to_string(cases) + " light needles", wrung = "wrung by 1.05 to 3 times the limit: ";
  return {none("S47", "wrung by 0.95 times what the pinch bears: turned", early, "of 8 light needles"),
          none("S47", wrung + "not turned", stay, of),
          none("S47", wrung + "steps that did not converge", static_cast<double>(not_converged), of),
          at_most("S47", wrung + "turn off that in steps of 0.03 ms", "rad", off, 0.02)};
}

}  // namespace swage::bench
