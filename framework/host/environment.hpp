// SPDX-License-Identifier: Apache-2.0
//
// The keys of "environment" in a lesson file: one table for its reader, its schema and the instructor's form. Threads: [any], no state.
#pragma once

#include <swage/environment.hpp>

#include <numbers>

namespace swage::host {

/// Names of SWAGE_MEDIUM_DRY, _MOIST and _WATER, in that order.
inline constexpr const char* kMedia[] = {"dry", "moist", "water"};

/// One quantity. A value beyond [min, max] is a mistake of units.
struct EnvironmentKey {
  const char* key;
  const char* unit;
  double swage_environment::*member;
  double min, max;
  uint32_t media;  // media for which it has a meaning, 1 << index in kMedia
  const char* display_unit;
  const char* label;
  const char* doc;
};

inline constexpr uint32_t kInDry = 1, kInMoist = 2, kInAll = 7;

inline constexpr const char* kMediumLabel = "Medium";
inline constexpr const char* kMediumDoc =
    "What surrounds everything in the scene. Dry: a thread may be charged. Moist: surfaces carry a film of water. Water: everything "
    "is under water. The numbers below are the medium's own until they are changed. "
    "Not set: a thread is in still air, and bodies feel no fluid.";

// C/m: 26.5 uC/m2, the limit by breakdown of air, on a thread of 10-0 (circumference pi 22 um) is 1.83 nC/m
inline constexpr double kMostCharge = 2e-9;
inline constexpr EnvironmentKey kEnvironmentKeys[] = {
    {"density", "kg/m3", &swage_environment::density, 0, 2000, kInAll, "kg/m3", "Density of the fluid", "Drag and buoyancy of what moves in it."},
    {"viscosity", "Pa*s", &swage_environment::viscosity, 0, 1, kInAll, "mPa*s", "Viscosity of the fluid", "Drag of what moves in it."},
    {"surface_tension", "N/m", &swage_environment::surface_tension, 0, 0.2, kInMoist, "mN/m", "Surface tension of the film",
     "How strongly the film draws wet things together; 0: nothing is wet."},
    {"contact_angle", "rad", &swage_environment::contact_angle, 0, std::numbers::pi / 2, kInMoist, "deg", "Contact angle of the film",
     "How well the film spreads on what it wets; 0: fully."},
    {"film", "m", &swage_environment::film, 1e-6, 1e-3, kInMoist, "um", "Thickness of the film", "How much water surfaces carry."},
    {"charge", "C/m", &swage_environment::charge, -kMostCharge, kMostCharge, kInDry, "nC/m", "Charge of a thread",
     "Along its length, in dry surroundings only. At 1.83 nC/m air breaks down on a thread of 10-0."},
    {"earthed_plane", "m", &swage_environment::ground_z, -1, 1, kInDry, "mm", "Height of an earthed plane",
     "A horizontal metal plane that draws what is charged. None: there is no such plane."},
    {"linear_damping", "N*s/m", &swage_environment::linear_damping, 0, 1, kInAll, "uN*s/m", "Damping of motion",
     "Force against the motion of each free body, for each unit of its speed."},
    {"angular_damping", "N*m*s/rad", &swage_environment::angular_damping, 0, 1, kInAll, "nN*m*s/rad", "Damping of rotation",
     "Torque against the rotation of each free body, for each unit of its angular speed."},
};

/// The default values of a medium: air or water at 20 deg C; moist: a film of water 0.1 mm thick (assumed: rinsed tissue carries
/// some tens of micrometres to some tenths of a millimetre).
inline swage_environment medium(uint32_t medium) {
  swage_environment out = kStillAir;
  out.medium = medium;
  if (medium == SWAGE_MEDIUM_MOIST) out.surface_tension = 0.072, out.film = 0.1e-3;
  if (medium == SWAGE_MEDIUM_WATER) out.density = 998, out.viscosity = 1.0e-3;
  return out;
}

}  // namespace swage::host
