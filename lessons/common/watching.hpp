// SPDX-License-Identifier: Apache-2.0
//
// Finds the objects and signals that a grasping lesson watches, and reports those that are missing.
#pragma once

#include <swage/lesson.hpp>

#include <string>
#include <vector>

#include "common/sentences.hpp"

namespace swage::lessons {

/// Index of an enumerator in the tables of a lesson.
template <class Enum>
constexpr size_t index(Enum value) {
  return static_cast<size_t>(value);
}

/// Signals and events of one grasp coupling.
struct GraspSignals {
  Signal held, force, s, tip_reach, tilt_axis, tilt_plane, balance;
  Event touched, taken, released;
};

/// Names of all instances with signals of a grasp, in the order of the lesson file.
inline std::vector<std::string> grasp_owners(const Scene& scene) {
  std::vector<std::string> owners;
  for (uint32_t i = 0; i < scene->n_signal; ++i) {
    if (view(scene->signal[i].id) == "grasp.held") owners.emplace_back(view(scene->signal[i].owner));
  }
  return owners;
}

inline GraspSignals find_grasp(const Scene& scene, Binder& binder, const std::string& owner) {
  const auto signal = [&](const char* id) {
    const Signal found = scene.find_signal(owner, id);
    if (!found.valid()) binder.missing(scene, "signal", owner, id, say::kWatched());
    return found;
  };
  const auto event = [&](const char* id) {
    const Event found = scene.find_event(owner, id);
    if (!found.valid()) binder.missing(scene, "event", owner, id, say::kWatched());
    return found;
  };
  return {signal("grasp.held"),      signal("grasp.force"),     signal("grasp.s"),
          signal("grasp.tip_reach"), signal("grasp.tilt_axis"), signal("grasp.tilt_plane"),
          signal("grasp.balance"),   event("grasp.touched"),    event("grasp.taken"),
          event("grasp.released")};
}

/// Index of the object that a parameter names; kNone, with an error reported, where there is none.
inline uint32_t find_object(const Scene& scene, Binder& binder, const std::string& name) {
  const uint32_t index = scene.find_object(name);
  if (index != kNone) return index;
  std::string all;
  for (const swage_scene_object& object : scene.objects()) {
    all += (all.empty() ? "" : ", ") + std::string(view(object.name));
  }
  binder.error(say::kNoObject(name, all));
  return kNone;
}

/// The gripper that a parameter names: an object with the trait gripper.
inline Peer find_gripper(const Scene& scene, Binder& binder, const std::string& name, uint32_t& index) {
  index = find_object(scene, binder, name);
  if (index == kNone) return Peer();
  const Peer peer(scene->object[index].instance);
  if (!peer.gripper()) binder.error(say::kNoGripper(name));
  return peer;
}

}  // namespace swage::lessons
