// SPDX-License-Identifier: Apache-2.0
//
// An object with a chain, in a scene: assembled from a lesson file, stepped by the engine, told where on its chain it is touched.
#include <gtest/gtest.h>

#include "../catalogue.hpp"
#include "assembly/assemble.hpp"
#include "scene/chain.hpp"
#include "step/step.hpp"
#include "test_places.hpp"

namespace {

using namespace swage;

const host::Catalogue& catalogue() {
  static const host::Catalogue& found =
      test::make_catalogue(SWAGE_BINARY_DIR "/plugins", {SWAGE_BINARY_DIR "/test_plugins"});
  return found;
}

/// Eleven beads of 10 ug, 0.2 mm apart, that start 30 um above a block of 10 mm, 1 mm high.
std::string lesson(const std::string& beads, const std::string& more_couplings = "") {
  return R"({"format": "swage-lesson/1", "id": "test.chain", "title": "T", "scene_length": "1 mm",
  "requires": {"test.object.beads": "^1", "swage.object.solids": "^1", "swage.coupling.contact": "^1",
               "swage.lesson.look": "^1"},
  "objects": [{"name": "beads", "plugin": "test.object.beads", "pose": {"p": ["-1 mm", 0, "1.055 mm"]},
               "params": {)" +
         beads + R"(}},
              {"name": "block", "plugin": "swage.object.solids",
               "params": {"form": "box", "fixed": true, "size": ["10 mm", "10 mm", "2 mm"]}}],
  "couplings": [{"plugin": "swage.coupling.contact", "between": ["beads", "block"],
                 "params": {"stiffness": "1e5 N/m", "friction": 0.3}})" +
         more_couplings + R"(],
  "lesson": {"plugin": "swage.lesson.look", "params": {"duration": "100 s"}}})";
}

struct Scene {
  std::unique_ptr<host::Rig> rig;
  std::unique_ptr<step::Engine> engine;

  explicit Scene(const std::string& text) {
    base::Problems problems;
    assembly::LessonFile file;
    assembly::parse_lesson(text, "test.json", file, problems);
    rig = assembly::assemble(file, catalogue(), {}, problems);
    for (const auto& p : problems) ADD_FAILURE() << p.where << ": " << p.message;
    if (!rig) return;
    engine = std::make_unique<step::Engine>(*rig, step::Options{});
    engine->reset();
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) engine->step();
    EXPECT_EQ(engine->quarantined(), 0u);
  }
  scene::ChainView chain() const { return {engine->world(), engine->world().chain[0]}; }
};

TEST(ChainInScene, starts_where_it_was_declared) {
  const Scene s(lesson(""));
  ASSERT_TRUE(s.engine);
  EXPECT_NEAR((s.chain().p(10) - toolkit::Vec3(1e-3, 0, 1.055e-3)).norm(), 0, 1e-15);
  EXPECT_NEAR(s.chain().s(10), 2e-3, 1e-15);
}

TEST(ChainInScene, lies_on_a_block_with_its_weight) {
  Scene s(lesson(""));
  ASSERT_TRUE(s.engine);
  s.run(500);
  for (uint32_t i = 0; i < 11; ++i) {
    EXPECT_NEAR(s.chain().p(i).z(), 1.025e-3, 0.1e-6) << "bead " << i;
    EXPECT_LT(s.chain().v(i).norm(), 1e-6);
  }
  EXPECT_NEAR(s.engine->world().signal.at(0), 11 * 1e-8 * 9.80665, 1e-11);
}

// pulled along by dampers, each with c speed; a bead of 98 nN weight is held up to 0.3 m g = 29.4 nN
TEST(ChainInScene, is_held_by_friction_and_slips_beyond_it) {
  for (const bool slips : {false, true}) {
    Scene s(lesson(slips ? R"("speed": "4 mm/s", "damping": 1e-5)"
                         : R"("speed": "2 mm/s", "damping": 1e-5)"));
    ASSERT_TRUE(s.engine);
    s.run(300);
    const double x = s.chain().p(5).x();
    s.run(1000);
    // m dv/dt = c (speed - v) - mu m g: at rest below c speed = mu m g = 29.4 nN (2.94 mm/s)
    const double speed = (s.chain().p(5).x() - x) / 1.0;
    if (slips)
      EXPECT_NEAR(speed, 4e-3 - 2.942e-3, 1e-6);
    else
      EXPECT_LT(std::abs(speed), 1e-9);
  }
}

TEST(ChainInScene, may_be_joined_with_itself) {
  Scene s(lesson("", R"(, {"plugin": "swage.coupling.contact", "between": ["beads", "beads"],
                         "params": {"stiffness": "1e4 N/m", "friction": 0.1}})"));
  ASSERT_TRUE(s.engine);
  s.run(200);
}

TEST(ChainInScene, is_saved_and_restored_with_the_rest) {
  Scene s(lesson(R"("speed": "4 mm/s")"));
  ASSERT_TRUE(s.engine);
  s.run(100);
  std::vector<std::byte> image(s.engine->image_size());
  ASSERT_TRUE(s.engine->save(image));
  s.run(50);
  const uint64_t hash = s.engine->hash();
  ASSERT_TRUE(s.engine->restore(image));
  s.run(50);
  EXPECT_EQ(s.engine->hash(), hash);
}

}  // namespace
