// SPDX-License-Identifier: Apache-2.0
//
// What leaves the step: plain data, fixed capacities, no pointers. Static things go once, in the scene card.
#pragma once

#include <swage/abi/device.h>
#include <swage/abi/visual.h>

#include <cstdint>

#include "base/drawing_health.hpp"
#include "base/solver_health.hpp"

namespace swage::snapshot {

// Capacities of a snapshot. A scene that declares more is refused when it is assembled, with these numbers in
// the message.
inline constexpr uint32_t kMaxBodies = 256;
inline constexpr uint32_t kMaxParticles = 1024;
inline constexpr uint32_t kMaxObjects = 32;
inline constexpr uint32_t kMaxSignals = 128;
inline constexpr uint32_t kMaxMetrics = 64;
inline constexpr uint32_t kMaxMarks = 32;
inline constexpr uint32_t kMaxDevices = 4;
inline constexpr uint32_t kMaxContacts = 64;
inline constexpr uint32_t kMaxVisuals = 128;
inline constexpr uint32_t kMaxVisualsOfOne = 80;  // of one object or coupling, so that others have room as well
inline constexpr uint32_t kPhases = 12;

/// Health of the loop, counted since the start of the run. Wall times include the rest of the
/// machine, processor times are those of this program alone.
struct LoopHealth {
  uint64_t executed = 0;  // steps
  uint64_t late = 0;      // woke more than half a period after the deadline
  uint64_t overrun = 0;   // were not ready at the next deadline
  uint64_t own_overrun =
      0;  // of these: the step's own processor time was longer than a period; the rest is the machine's
  uint64_t dropped = 0;                        // deadlines that passed without a step
  uint64_t lost_records = 0, lost_events = 0;  // a ring was full
  double worst_wake_s = 0, worst_step_s = 0;   // wall
  double mean_step_cpu_s = 0, p99_step_cpu_s = 0, p999_step_cpu_s = 0;  // of all, 99 and 99.9 % of them below that
  double phase_s[kPhases] = {};                // wall, smoothed, in the order of step::Phase
  uint32_t realtime = 0;                       // 1: SCHED_FIFO and locked memory
  uint32_t quarantined = 0;                    // number of instances
  base::SolverHealth solver;                   // all 0 in a sound scene
  base::DrawingHealth visuals;                 // the same of what plugins draw beside shapes
};

struct DeviceState {
  swage_pose X_WD{};
  double closure = 0, grip_force = 0;
  swage_vec3 force{};  // N sent, after the guard
  uint32_t valid = 0, stale = 0;
};

struct ContactMark {
  swage_vec3 p_W{}, f_W{};
};

/// Something drawn on an object beside its shapes (see the ABI for what the numbers mean); places and directions in the world.
/// Regions with the same number by different couplings are different ones.
struct VisualMark {
  swage_visual visual{};
  uint32_t object = 0, coupling = 0;  // coupling: that draws it; scene::kNone, the object itself does
};

struct Snapshot {
  uint64_t step = 0;
  double time_s = 0;
  uint64_t hash = 0;
  uint32_t n_body = 0, n_particle = 0, n_object = 0, n_signal = 0;
  uint32_t n_metric = 0, n_mark = 0, n_device = 0, n_contact = 0;
  uint32_t outcome = 0, reason = 0, phase = 0, paused = 0;
  uint32_t n_visual = 0, reserved = 0;
  double score = 0;
  LoopHealth health;
  swage_pose X_WB[kMaxBodies];
  uint32_t object_cue[kMaxObjects];
  uint32_t object_quarantined[kMaxObjects];
  double signal[kMaxSignals];
  double metric[kMaxMetrics];
  uint32_t mark_cue[kMaxMarks];
  swage_vec3 mark_p_W[kMaxMarks];
  DeviceState device[kMaxDevices];
  ContactMark contact[kMaxContacts];
  VisualMark visual[kMaxVisuals];
  double particle_p_W[3 * kMaxParticles];  // last: what a scene does not have is not copied (channel.hpp)
};

}  // namespace swage::snapshot
