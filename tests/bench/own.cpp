// SPDX-License-Identifier: Apache-2.0
#include "own.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "couple.hpp"
#include "shots.hpp"

namespace swage::bench {
namespace {

/// Share of the shots that pass, stick or come back faster, half of them with restitution 0.5.
double shots_lost(Target target, double speed, int shots, bool swept) {
  ShotCounts all;
  for (const double size : {0.1e-3, 0.3e-3}) {
    if (target != Target::kPlate && size > 0.1e-3) continue;
    for (const double restitution : {0.0, 0.5}) {
      ShotSetup s;
      s.target = target, s.size = size, s.speed = speed, s.restitution = restitution, s.swept = swept;
      all += shoot(s, 0, shots);
    }
  }
  return static_cast<double>(all.failed()) / all.shots;
}

/// How far the turn of needles under 1.5 times the limit is off that in steps of 0.03 ms [rad]. `way`: how far the couple at the limit
/// would turn the lightest of them in a step of 1 ms where nothing holds it [rad], by a density that is not that of steel.
double couple_off(double way, double dt, bool impulse) {
  double worst = 0;
  for (const double share : {0.25, 0.375, 0.5}) {
    WringSetup s;
    s.share = share;
    s.density *= free_turn(WringSetup{}) / way;
    s.dt = 3e-5;
    const double converged = wring(s).turned;
    s.dt = dt, s.impulse = impulse;
    worst = std::max(worst, std::abs(wring(s).turned - converged));
  }
  return worst;
}

std::vector<OwnMethod> shot_methods(Target target) {
  const auto with = [target](bool swept) {
    return [=](double speed, int shots) { return shots_lost(target, speed, shots, swept); };
  };
  return {{"swage", "swage", with(true)}, {"swage", "swage, without swept query", with(false)}};
}

std::vector<OwnMethod> couple_methods() {
  const auto with = [](double dt, bool impulse) {
    return [=](double way, int) { return couple_off(way, dt, impulse); };
  };
  return {{"swage", "swage", with(1e-3, false)},
          {"swage", "swage, steps of 0.1 ms", with(1e-4, false)},
          {"thesis", "swage, impulse method of the thesis", with(1e-3, true)}};
}

}  // namespace

bool is_own(const std::string& scenario) { return scenario.rfind("shots_", 0) == 0 || scenario == "couple"; }

std::vector<OwnMethod> own_methods(const std::string& scenario) {
  if (scenario == "shots_plate") return shot_methods(Target::kPlate);
  if (scenario == "shots_rod") return shot_methods(Target::kRod);
  if (scenario == "shots_moving_rod") return shot_methods(Target::kMovingRod);
  if (scenario == "shots_needle") return shot_methods(Target::kNeedle);
  if (scenario == "couple") return couple_methods();
  throw std::runtime_error("/scenario: \"" + scenario + "\" is unknown");
}

}  // namespace swage::bench
