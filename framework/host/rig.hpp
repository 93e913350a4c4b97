// SPDX-License-Identifier: Apache-2.0
//
// The rig: every plugin instance of one lesson, with the part of the world that each declared. Built by
// `assembly` on [main], stepped by `step` on [rt]. Destroying it deactivates and destroys the instances in
// reverse order.
#pragma once

#include <swage/abi/coupling.h>
#include <swage/abi/device.h>
#include <swage/abi/lesson.h>
#include <swage/abi/sight.h>

#include <memory>
#include <string>
#include <vector>

#include "contact/contact_set.hpp"
#include "host/hand_shaping.hpp"
#include "host/instance.hpp"
#include "judge/verdict.hpp"
#include "scene/world.hpp"
#include "snapshot/scene_card.hpp"

namespace swage::host {

using scene::kNone;
using scene::Range;

/// Which device drives an object, and how hand space maps to the scene.
struct Follow {
  uint32_t pose_device = kNone;     // index into Rig::devices
  uint32_t closure_device = kNone;  // may be another device
};

struct ObjectSlot {
  std::unique_ptr<Instance> instance;
  const swage_object* object = nullptr;
  const swage_solver* solver = nullptr;    // own mechanics, or nullptr
  const swage_solver_2* solver_2 = nullptr;  // the same of an object with chains, instead
  const swage_surface* surface = nullptr;  // where its free surface is, or nullptr
  const swage_dents* dents = nullptr;      // what is drawn of it, or nullptr
  Range body, particle, shape, hinge, state, signal;
  Follow follow;
  swage_pose X_WO{};  // where the lesson placed the object's frame

  bool moves_itself() const { return solver != nullptr || solver_2 != nullptr; }
};

struct CouplingSlot {
  std::unique_ptr<Instance> instance;
  const swage_coupling* coupling = nullptr;
  const swage_ties* ties = nullptr;      // links that it makes, or nullptr
  const swage_tears* tears = nullptr;    // what is drawn of it, or nullptr
  const swage_wounds* wounds = nullptr;  // and what more is known of that, or nullptr
  uint32_t object_a = kNone, object_b = kNone;
  uint32_t pair = kNone;       // index into Rig::pairs; couplings that only look share the pair that detects
  Range state, signal, event;  // event: into Script::events
};

struct DeviceSlot {
  std::unique_ptr<Instance> instance;
  const swage_device* device = nullptr;
  const swage_device_sight* sight = nullptr;  // of a device that sees the scene
  double motion_scale = 1;                    // hand movement over scene movement: 10 under a x10 microscope
  double force_scale = 0;                     // N at the hand per N in the scene; 0: no force is sent
  swage_pose X_WD0{};                         // device frame in the world; identity for SWAGE_DEVICE_WORLD
  HandFilters filters;                        // nothing for SWAGE_DEVICE_WORLD
  Reaction reaction;                          // how the scene's force grows into the hand's
  HandCoupling coupling;                      // nothing for a device that takes no forces
  std::string choice, params;  // "as" name and parameters that the lesson gave it, for the record
};

struct LessonSlot {
  std::unique_ptr<Instance> instance;
  const swage_lesson* lesson = nullptr;
  Range state;
  Range metric, cue, event, phase;  // into the Script
};

/// What the lesson was shown in bind(); static while bound, so it lives as long as the rig.
struct BoundScene {
  std::vector<swage_scene_object> objects;
  std::vector<swage_scene_signal> signals;
  std::vector<swage_scene_event> events;
  swage_scene_card card{};
};

struct Rig {
  scene::World world;
  std::vector<contact::Pair> pairs;
  std::vector<ObjectSlot> objects;  // in the order of the lesson file, which is the order of evaluation
  std::vector<CouplingSlot> couplings;
  std::vector<DeviceSlot> devices;
  LessonSlot lesson;
  judge::Script script;
  snapshot::SceneCard card;
  BoundScene bound;
  uint64_t seed = 0;
  bool mirror = false;          // hands, pointer, card and snapshot are reflected (toolkit/mirror.hpp)
  std::string descriptor_text;  // the lesson file as read, kept for the record
  std::string descriptor_path;
  std::vector<GivenFile> files;  // that the lesson names, each once

  double max_time_s = 0;    // simulated; 0: until the lesson finishes
  Attempt attempt;
  Shared shared;         // of the instances' services; points into this rig

  Rig();
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;
  ~Rig();
};

/// Every instance of the rig, in the order of evaluation: objects, couplings, devices, lesson.
std::vector<Instance*> instances(const Rig& rig);

/// Activates every instance for steps of World::dt; names who refused. [main]
bool activate(Rig& rig, base::Problems& problems);

/// Own processor time that each instance may use per step before it counts as late; 0: nobody is timed, as in
/// runs that must not depend on the clock. Normal: 200e-6 s of a 1 ms step. [main]
void set_budgets(Rig& rig, double seconds);

/// The host does a step again in smaller parts: objects and couplings have the budget of a step for each of them. [rt]
void renew_budgets(Rig& rig) noexcept;

}  // namespace swage::host
