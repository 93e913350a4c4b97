// SPDX-License-Identifier: Apache-2.0
#include "lesson_step.hpp"

#include <nlohmann/json.hpp>

#include "timing.hpp"
#include "test_places.hpp"

namespace swage::bench {

std::unique_ptr<stage::LessonRun> held_lesson(const std::string& level, int pieces) {
  return std::make_unique<stage::LessonRun>(SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json", assembly::Overrides{"expert", ""},
                                            [&](assembly::LessonFile& file) {
                                              for (assembly::LessonObject& o : file.objects) {
                                                if (o.name != "needle") continue;
                                                auto params = nlohmann::json::parse(o.params);
                                                params["level"] = level, params["pieces"] = pieces;
                                                o.params = params.dump();
                                              }
                                            });
}

HeldSteps held_steps(const std::string& level, int pieces) {
  const auto lesson = held_lesson(level, pieces);
  stage::LessonRun& run = *lesson;
  HeldSteps out;
  if (!run.ready()) {
    out.problem = run.problems();
    return out;
  }
  while (run.world().time() < kHeldFrom) run.step();
  while (run.world().time() < kHeldUntil) {
    const double begin = cpu_ns();
    run.step();
    out.ns.push_back(cpu_ns() - begin);
  }
  out.hash = run.engine().hash();
  if (run.signal("grasp", "grasp.held") != 1) out.problem = "the needle is not held";
  return out;
}

}  // namespace swage::bench
