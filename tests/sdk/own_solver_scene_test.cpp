// SPDX-License-Identifier: Apache-2.0
//
// An object with mechanics of its own, in a scene: assembled from a lesson file, stepped by the engine, in contact with the
// host's bodies, all solved together.
//
// Statics, along z (r radius, k spring, z0 rest place of the centre, m mass, K stiffness of the contact, top of the block):
//   K (r - (z - top)) - k (z - z0) - m g = 0   =>   z = (K (r + top) + k z0 - m g) / (K + k)
#include <gtest/gtest.h>

#include <cmath>

#include "../catalogue.hpp"
#include "assembly/assemble.hpp"
#include "step/step.hpp"
#include "test_places.hpp"

namespace {

using namespace swage;

constexpr double kRadius = 0.5e-3, kMass = 1e-6, kSpring = 1, kContact = 1e3, kGravity = 9.80665, kTop = 1e-3;

const host::Catalogue& catalogue() {
  static const host::Catalogue& found =
      test::make_catalogue(SWAGE_BINARY_DIR "/plugins", {SWAGE_BINARY_DIR "/test_plugins"});
  return found;
}

std::string lesson(const std::string& objects, const std::string& couplings) {
  return R"({"format": "swage-lesson/1", "id": "test.own_solver", "title": "T", "scene_length": "1 mm",
  "requires": {"test.object.spring_mass": "^1", "swage.object.solids": "^1", "swage.coupling.contact": "^1",
               "swage.lesson.look": "^1"},
  "objects": [)" +
         objects + R"(], "couplings": [)" + couplings +
         R"(], "lesson": {"plugin": "swage.lesson.look", "params": {"duration": "100 s"}}})";
}

/// A critically damped ball whose spring is at rest at height z [m].
std::string ball_at(double z) {
  return R"({"name": "ball", "plugin": "test.object.spring_mass", "pose": {"p": [0, 0, )" +
         std::to_string(z) +
         R"(]}, "params": {"radius": "0.5 mm", "mass": "1e-6 kg", "stiffness": "1 N/m", "damping": 2e-3}})";
}

const char* const kBlock =
    R"(, {"name": "block", "plugin": "swage.object.solids",
          "params": {"form": "box", "fixed": true, "size": ["10 mm", "10 mm", "2 mm"]}})";
const char* const kTouch =
    R"({"plugin": "swage.coupling.contact", "between": ["ball", "block"],
        "params": {"stiffness": "1000 N/m", "friction": 0.5}})";

struct Scene {
  std::unique_ptr<host::Rig> rig;
  std::unique_ptr<step::Engine> engine;

  void make(const std::string& text) {
    base::Problems problems;
    assembly::LessonFile file;
    assembly::parse_lesson(text, "test.json", file, problems);
    rig = assembly::assemble(file, catalogue(), {}, problems);
    for (const auto& p : problems) ADD_FAILURE() << p.where << ": " << p.message;
    ASSERT_NE(rig, nullptr);
    engine = std::make_unique<step::Engine>(*rig, step::Options{});
    engine->reset();
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) engine->step();
    EXPECT_EQ(engine->quarantined(), 0u);
  }
  const swage_vec3& ball() const { return engine->world().X_WB[0].p; }
};

TEST(OwnSolverInScene, hangs_on_its_spring) {
  Scene scene;
  scene.make(lesson(ball_at(5e-3) + kBlock, kTouch));
  scene.run(500);
  const double sag = kMass * kGravity / kSpring;
  EXPECT_NEAR(scene.ball().z, 5e-3 - sag, 1e-9 * sag);
  EXPECT_NEAR(scene.engine->world().signal[0], sag, 1e-9 * sag) << "its signal";
}

TEST(OwnSolverInScene, rests_on_a_block_where_the_forces_balance) {
  Scene scene;
  const double z0 = kTop + kRadius - 0.2e-3;  // the spring pulls it 0.2 mm into the block
  scene.make(lesson(ball_at(z0) + kBlock, kTouch));
  scene.run(2000);
  const double z = (kContact * (kRadius + kTop) + kSpring * z0 - kMass * kGravity) / (kContact + kSpring);
  EXPECT_NEAR(scene.ball().z, z, 1e-6 * kRadius);
  // the points of the patch that a ball presses into a face carry the load together
  double carried = 0;
  for (const contact::Contact& c : scene.engine->contacts().contact) carried += c.f_a_W.z();
  const double force = kMass * kGravity + kSpring * (z - z0);
  EXPECT_NEAR(std::abs(carried), force, 1e-4 * force);
}

TEST(OwnSolverInScene, carries_a_dynamic_ball_that_falls_on_it) {
  Scene scene;
  const std::string falling =
      R"(, {"name": "bead", "plugin": "swage.object.solids", "pose": {"p": [0, 0, "6.1 mm"]},
      "params": {"form": "sphere", "diameter": "1 mm", "density": 1000}})";
  scene.make(
      lesson(ball_at(5e-3) + falling, R"({"plugin": "swage.coupling.contact", "between": ["bead", "ball"],
      "params": {"stiffness": "1000 N/m", "friction": 0}})"));
  scene.run(3000);
  // both hang on the spring: it carries the weight of two
  const double bead = 1000 * 4.0 / 3 * M_PI * std::pow(0.5e-3, 3);
  const double sag = (kMass + bead) * kGravity / kSpring;
  EXPECT_NEAR(scene.ball().z, 5e-3 - sag, 1e-4 * sag);
}

TEST(OwnSolverInScene, is_saved_and_restored_with_the_rest) {
  Scene scene;
  scene.make(lesson(ball_at(kTop + kRadius - 0.2e-3) + kBlock, kTouch));
  scene.run(7);
  std::vector<std::byte> image(scene.engine->image_size());
  ASSERT_TRUE(scene.engine->save(image));
  scene.run(50);
  const uint64_t hash = scene.engine->hash();
  ASSERT_TRUE(scene.engine->restore(image));
  scene.run(50);
  EXPECT_EQ(scene.engine->hash(), hash);
}

}  // namespace
