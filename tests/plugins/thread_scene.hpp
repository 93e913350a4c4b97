// SPDX-License-Identifier: Apache-2.0
//
// A scene with a thread, assembled from the text of its objects and couplings.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>

#include "assembly/assemble.hpp"
#include "scene/chain.hpp"
#include "step/step.hpp"
#include "test_places.hpp"
#include "tests/catalogue.hpp"

namespace swage::test {

struct ThreadScene {
  std::unique_ptr<host::Rig> rig;
  std::unique_ptr<step::Engine> engine;

  /// The first chain is the thread.
  /// `top`: keys of the lesson file itself, each with a comma behind it.
  ThreadScene(const std::string& objects, const std::string& couplings, const std::string& devices = "", const std::string& top = "") {
    const std::string scene = R"("devices": [)" + devices + R"(], "objects": [)" + objects + R"(], "couplings": [)" +
                              couplings + R"(], "lesson": {"plugin": "swage.lesson.look", "params": {"duration": "1000 s"}}})";
    std::string used;
    for (const char* id : {"swage.object.thread", "swage.object.solids", "swage.object.jaws", "swage.object.needle", "swage.object.tissue", "swage.coupling.pull_through",
                           "swage.coupling.contact", "swage.coupling.grasp", "swage.coupling.swage", "swage.coupling.knot", "swage.coupling.winding", "swage.coupling.cut", "swage.coupling.meniscus", "test.coupling.leash",
                           "swage.device.scripted", "swage.lesson.look"})
      if (scene.find(std::string("\"") + id + "\"") != std::string::npos)
        used += (used.empty() ? "\"" : ", \"") + std::string(id) + R"(": "^1")";
    const std::string text =
        R"({"format": "swage-lesson/1", "id": "test.thread", "title": "T", "scene_length": "1 mm", )" + top + R"("requires": {)" + used +
        "}, " + scene;
    base::Problems problems;
    assembly::LessonFile file;
    assembly::parse_lesson(text, SWAGE_SOURCE_DIR "/lessons/series/test.json", file, problems);
    rig = assembly::assemble(file, catalogue(), {}, problems);
    for (const auto& p : problems) ADD_FAILURE() << p.where << ": " << p.message;
    if (!rig) return;
    engine = std::make_unique<step::Engine>(*rig, step::Options{});
    engine->reset();
  }

  static const host::Catalogue& catalogue() {
    static const host::Catalogue& found =
        make_catalogue(SWAGE_BINARY_DIR "/plugins", {SWAGE_BINARY_DIR "/test_plugins"});
    return found;
  }

  void run(int steps) {
    for (int i = 0; i < steps; ++i) engine->step();
    EXPECT_EQ(engine->quarantined(), 0u);
  }
  scene::ChainView chain() const { return {engine->world(), engine->world().chain[0]}; }
  double signal(const std::string& id) const {
    const auto& all = rig->bound.signals;
    for (size_t i = 0; i < all.size(); ++i)
      if (std::string_view(all[i].id.data, all[i].id.size) == id) return engine->world().signal[i];
    ADD_FAILURE() << "no signal " << id;
    return 0;
  }
  /// What the solver could not do, "" in a sound scene.
  std::string troubles() const {
    return base::text(engine->stats().health);
  }
};

}  // namespace swage::test
