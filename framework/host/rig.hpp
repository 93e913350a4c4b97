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
#include <swage/abi/visual.h>

#include <memory>
#include <string>
#include <vector>

#include "contact/contact_set.hpp"
#include "host/hand_shaping.hpp"
#include "host/instance.hpp"
#include "judge/pull_rule.hpp"
#include "judge/verdict.hpp"
#include "scene/world.hpp"
#include "snapshot/scene_card.hpp"

namespace swage::host {

using scene::kNone;
using scene::Range;

/// The devices that drive an object.
struct Follow {
  uint32_t pose_device = kNone;     // index into Rig::devices
  uint32_t closure_device = kNone;  // may be another device than pose_device
};

struct ObjectSlot {
  std::unique_ptr<Instance> instance;
  const swage_object* object = nullptr;
  const swage_solver* solver = nullptr;    // flexible body, or nullptr
  const swage_solver_2* solver_2 = nullptr;  // the same for an object with chains, instead of solver
  const swage_surface* surface = nullptr;  // its free surface, or nullptr
  const swage_visuals* visuals = nullptr;  // what it draws beside its shapes, or nullptr
  Range body, particle, shape, hinge, state, signal;
  Follow follow;
  swage_pose X_WO{};  // pose of the object's frame, by the lesson

  bool moves_itself() const { return solver != nullptr || solver_2 != nullptr; }
};

struct CouplingSlot {
  std::unique_ptr<Instance> instance;
  const swage_coupling* coupling = nullptr;
  const swage_ties* ties = nullptr;      // ties that it makes, or nullptr
  const swage_visuals* visuals = nullptr;  // what it draws on object b, or nullptr
  uint32_t object_a = kNone, object_b = kNone;
  uint32_t pair = kNone;       // index into Rig::pairs; couplings that only observe share the pair that detects
  Range state, signal, event;  // event: into Script::events
};

struct DeviceSlot {
  std::unique_ptr<Instance> instance;
  const swage_device* device = nullptr;
  const swage_device_sight* sight = nullptr;  // of a device that takes the scene
  double motion_scale = 1;                    // hand movement over scene movement: 10 under a x10 microscope
  double force_scale = 0;                     // N at the hand per N in the scene; 0: no force is sent
  swage_pose X_WD0{};                         // device frame in the world; identity for SWAGE_DEVICE_WORLD
  HandFilters filters;                        // none for SWAGE_DEVICE_WORLD
  Reaction reaction;                          // law of the force at the hand over the force in the scene
  HandCoupling coupling;                      // zero for a device that takes no forces
  std::string choice, params;  // "as" name and parameters given by the lesson, for the record
};

struct LessonSlot {
  std::unique_ptr<Instance> instance;
  const swage_lesson* lesson = nullptr;
  Range state;
  Range metric, cue, event, phase;  // into the Script
};

/// The scene as shown to the lesson in bind(); the lesson may keep pointers to it, so it lives as long as the rig.
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
  std::vector<GivenFile> files;  // files that the lesson names, each once

  double max_time_s = 0;    // simulated; 0: until the lesson finishes
  judge::PullRule pull;                // of the knot of a passed attempt
  uint32_t first_pull_metric = kNone;  // into Script::metrics, kPullMeasureCount of them; kNone: it is not pulled
  Attempt attempt;
  Shared shared;         // of the instances' services; points into this rig

  Rig();
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;
  ~Rig();
};

/// Every instance of the rig, in the order of evaluation: objects, couplings, devices, lesson.
std::vector<Instance*> instances(const Rig& rig);

/// Activates every instance for steps of World::dt; reports refusals. [main]
bool activate(Rig& rig, base::Problems& problems);

/// Own processor time that each instance may use per step before the step counts as late; 0: untimed, as in
/// runs that must not depend on the clock. Usual: 200e-6 s of a 1 ms step. [main]
void set_budgets(Rig& rig, double seconds);

/// For a step that the host repeats in substeps: objects and couplings have a whole budget for each substep. [rt]
void renew_budgets(Rig& rig) noexcept;

}  // namespace swage::host
