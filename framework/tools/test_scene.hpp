// SPDX-License-Identifier: Apache-2.0
//
// The smallest scene in which a plugin can be stepped, for the validator. [main]
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "assembly/assemble.hpp"
#include "host/catalogue.hpp"
#include "host/guard.hpp"
#include "host/rig.hpp"
#include "host/validate.hpp"
#include "step/step.hpp"

namespace swage::tools {

/// A rig and the engine that steps it; in this order, because the engine must be destroyed first.
struct Stepped {
  std::unique_ptr<step::DevicePort> still;  // the default hand
  std::unique_ptr<host::Rig> rig;
  std::unique_ptr<step::Engine> engine;

  /// "" while no instance is in quarantine and every number of the world is finite, otherwise the fault.
  std::string fault() const;
  /// Runs steps; "" or the first fault.
  std::string run(uint64_t steps);
};

/// Options of a scene.
struct Wish {
  std::string params = "{}";         // of the plugin under test, JSON object
  swage_vec3 at{0, 0, 0};            // m, position of the object
  bool with_neighbour = false;       // a second instance of the object, far away and before the first
  step::DevicePort* hand = nullptr;  // moves the objects that follow a hand; nullptr: a hand at rest
};

class TestScene {
 public:
  /// A scene for `plugin`; `catalogue` has the other plugins that it needs. Both outlive this.
  TestScene(const host::PluginInfo& plugin, const host::Catalogue& catalogue);
  /// The scene of a lesson in which the plugin is used; `lesson` outlives this.
  TestScene(const host::PluginInfo& plugin, const host::Catalogue& catalogue, const assembly::LessonFile& lesson);

  /// Reason why this plugin cannot be stepped here, or "".
  const std::string& skipped() const { return skipped_; }

  /// Makes the scene; false with the first problem in `error`.
  bool make(const Wish& wish, Stepped& out, std::string& error) const;

  const host::PluginInfo& plugin() const { return plugin_; }
  /// True when an object of the scene follows a hand.
  bool is_led() const;
  /// Index of the object under test in a rig made with this wish.
  uint32_t subject(const Wish& wish) const;
  /// True for a device with a thread of its own.
  bool on_thread() const { return on_thread_; }
  /// True when the scene is that of a lesson file, which places the objects.
  bool of_lesson() const { return lesson_ != nullptr; }

 private:
  assembly::LessonFile file(const Wish& wish) const;
  assembly::LessonFile lesson_file(const Wish& wish) const;
  void find_thread();
  bool assembles(const assembly::LessonFile& file, std::string& error) const;
  bool follows(const std::string& object_plugin) const;
  void find_led();
  void find_pair();
  void find_stage();
  bool is_a(const std::string& object_plugin, const char* trait) const;
  std::string stage_params(const std::string& wished) const;
  void set_stage(assembly::LessonFile& f, const Wish& wish) const;

  const host::PluginInfo& plugin_;
  const host::Catalogue& catalogue_;
  const assembly::LessonFile* lesson_ = nullptr;
  bool on_thread_ = false;
  struct Actor {
    std::string name, plugin;
  };
  std::vector<Actor> stage_;                    // objects for a lesson
  std::map<std::string, std::string> casting_;  // parameters of the lesson that name them
  std::string between_[2];                      // object plugins for a coupling; the second is empty for an object with itself
  std::string finder_;            // coupling that detects the contacts for one that only observes, "" for none
  std::vector<std::string> led_;  // object plugins that follow a hand
  std::string hand_;              // a device plugin that can move an object, "" for none
  std::string skipped_;
};

}  // namespace swage::tools
