// SPDX-License-Identifier: Apache-2.0
//
// The keys of "environment" in a lesson file: one table for who reads the file and for its schema. Threads: [any], no state.
#pragma once

#include <swage/environment.hpp>

#include <numbers>

namespace swage::host {

/// Names of SWAGE_MEDIUM_DRY, _MOIST and _WATER, in that order.
inline constexpr const char* kMedia[] = {"dry", "moist", "water"};

/// One quantity. Beyond [min, max] a value is a mistake of units.
struct EnvironmentKey {
  const char* key;
  const char* unit;
  double swage_environment::*member;
  double min, max;
};

// C/m: 26.5 uC/m2, at which air breaks down, on a thread of 10-0 (pi 22 um around) is 1.83 nC/m
inline constexpr double kMostCharge = 2e-9;
inline constexpr EnvironmentKey kEnvironmentKeys[] = {
    {"density", "kg/m3", &swage_environment::density, 0, 2000},
    {"viscosity", "Pa*s", &swage_environment::viscosity, 0, 1},
    {"surface_tension", "N/m", &swage_environment::surface_tension, 0, 0.2},
    {"contact_angle", "rad", &swage_environment::contact_angle, 0, std::numbers::pi / 2},
    {"film", "m", &swage_environment::film, 1e-6, 1e-3},
    {"charge", "C/m", &swage_environment::charge, -kMostCharge, kMostCharge},
    {"earthed_plane", "m", &swage_environment::ground_z, -1, 1},
    {"linear_damping", "N*s/m", &swage_environment::linear_damping, 0, 1},
    {"angular_damping", "N*m*s/rad", &swage_environment::angular_damping, 0, 1},
};

/// What a medium is without further words: air or water at 20 deg C; moist: a film of water 0.1 mm thick (assumed: tissue that is
/// rinsed carries some tens of micrometres to some tenths of a millimetre).
inline swage_environment medium(uint32_t medium) {
  swage_environment out = kStillAir;
  out.medium = medium;
  if (medium == SWAGE_MEDIUM_MOIST) out.surface_tension = 0.072, out.film = 0.1e-3;
  if (medium == SWAGE_MEDIUM_WATER) out.density = 998, out.viscosity = 1.0e-3;
  return out;
}

}  // namespace swage::host
