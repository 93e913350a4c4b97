// SPDX-License-Identifier: Apache-2.0
//
// What does not change while a scene runs: names, shapes, marks. Handed over once, at activation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "judge/verdict.hpp"

namespace swage::snapshot {

/// Surface to draw; numbers as in scene::Shape, convex resolved to vertices and faces.
struct CardShape {
  int32_t kind = 0;
  uint32_t body = 0;
  uint32_t object = 0;
  uint32_t flags = 0;
  swage_pose X_BS{};
  double radius = 0, half_length = 0, arc_radius = 0, sweep = 0;  // m, m, m, rad
  std::vector<swage_vec3> vertex;                                 // in S, m
  std::vector<std::vector<uint32_t>> face;                        // counter-clockwise from outside
};

struct CardObject {
  std::string name, plugin, plugin_version;
  std::vector<std::string> traits;
  uint32_t first_body = 0, n_body = 0, first_particle = 0, n_particle = 0;
};

struct CardDevice {
  std::string name, plugin, plugin_version;
  uint32_t flags = 0;  // SWAGE_DEVICE_* of abi/device.h
};

/// What a lesson's card says about a metric of the script; zeros where it says nothing.
struct CardMetric {
  int32_t better = 0, evidence = 0;  // SWAGE_BETTER_*, SWAGE_EVIDENCE_* of abi/lesson_card.h
  std::string code, formula;
  std::string title;          // "" where the card has none
  int32_t show = 0, rank = 0;  // SWAGE_SHOW_*; place among what is shown first, 0: on demand
};

/// Views from which a trainee may look first: from the front, from the side, from above, close to the work.
inline constexpr const char* kViews[] = {"orbit", "side", "top", "near"};

struct SceneCard {
  std::string lesson_id, title, lesson_plugin;
  std::string mode;   // "practice", "test", "demo"
  uint32_t cues = 0;  // SWAGE_CHANNEL_* that cues may use; 0: a test is taken without help
  bool tips_only = false;  // of instruments only the tips are drawn
  std::string view;        // one of kViews, from where a trainee looks first; "" where the lesson does not say
  uint32_t medium = 0;  // SWAGE_MEDIUM_* of abi/environment.h
  double viscosity = 0;  // Pa s, of the medium
  double length = 0;  // m, characteristic
  double dt = 0;      // s
  uint64_t seed = 0;
  std::vector<CardObject> objects;
  std::vector<CardDevice> devices;
  std::vector<CardShape> shapes;
  std::vector<swage_pose> start;  // X_WB of every body
  std::vector<int32_t>
      motion;  // SWAGE_MOTION_* of every body: what stands still is stage, what moves is watched
  judge::Script script;
  std::vector<CardMetric> metrics;     // one per metric of the script
  std::vector<uint32_t> cue_channels;  // of each cue of the script: SWAGE_CHANNEL_* that suit it
};

}  // namespace swage::snapshot
