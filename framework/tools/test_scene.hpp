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

/// A rig and the engine that steps it; in this order, because the engine goes first.
struct Stepped {
  std::unique_ptr<step::DevicePort> still;  // the hand, when nobody wished another
  std::unique_ptr<host::Rig> rig;
  std::unique_ptr<step::Engine> engine;

  /// "" as long as all is well: nobody in quarantine, every number of the world finite.
  std::string fault() const;
  /// "" or the first fault on the way.
  std::string run(uint64_t steps);
};

/// What a scene is to be.
struct Wish {
  std::string params = "{}";         // of the plugin under test, JSON object
  swage_vec3 at{0, 0, 0};            // m, where the object stands
  bool with_neighbour = false;       // a second instance of the object, far away and before the first
  step::DevicePort* hand = nullptr;  // leads the objects that follow a hand; nullptr: one that rests
};

class TestScene {
 public:
  /// A scene for `plugin`; `catalogue` lends what it needs. Both outlive this.
  TestScene(const host::PluginInfo& plugin, const host::Catalogue& catalogue);
  /// The scene of a lesson in which the plugin is used; `lesson` outlives this.
  TestScene(const host::PluginInfo& plugin, const host::Catalogue& catalogue, const assembly::LessonFile& lesson);

  /// Why this plugin cannot be stepped here, or "".
  const std::string& skipped() const { return skipped_; }

  /// False: `error` has the first problem.
  bool make(const Wish& wish, Stepped& out, std::string& error) const;

  const host::PluginInfo& plugin() const { return plugin_; }
  /// True when something in the scene follows a hand.
  bool is_led() const;
  /// Index of the object under test in a rig made with this wish.
  uint32_t subject(const Wish& wish) const;
  /// True for a device that is asked on a thread of its own.
  bool on_thread() const { return on_thread_; }
  /// True when the scene is a lesson's: things stand where it puts them.
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
  std::map<std::string, std::string> casting_;  // its parameters that name them
  std::string between_[2];                      // object plugins for a coupling; the second empty: one with itself
  std::string finder_;            // coupling that finds contacts for one that only looks, "" for none
  std::vector<std::string> led_;  // object plugins that follow a hand
  std::string hand_;              // a device plugin that can lead an object, "" for none
  std::string skipped_;
};

}  // namespace swage::tools
