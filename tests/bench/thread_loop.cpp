// SPDX-License-Identifier: Apache-2.0
#include "thread_loop.hpp"

#include <nlohmann/json.hpp>

#include "phases.hpp"
#include "test_places.hpp"

namespace swage::bench {
namespace {

void set(assembly::LessonFile& file, const char* object, const char* param, const nlohmann::json& value) {
  for (assembly::LessonObject& o : file.objects) {
    if (o.name != object) continue;
    auto params = nlohmann::json::parse(o.params);
    params[param] = value;
    o.params = params.dump();
  }
}

void leave_thread_alone(assembly::LessonFile& file) {
  std::erase_if(file.couplings, [](const auto& c) { return c.a == "tray" || (c.a == "tissue" && c.b == "suture"); });
  std::erase_if(file.objects, [](const auto& o) { return o.name == "tray"; });
}

}  // namespace

std::unique_ptr<stage::LessonRun> thread_loop(const std::string& level, bool alone) {
  return std::make_unique<stage::LessonRun>(SWAGE_SOURCE_DIR "/lessons/series/117_needle_with_thread.json", assembly::Overrides{"expert", ""},
                                            [&](assembly::LessonFile& file) {
                                              set(file, "needle", "level", level), set(file, "suture", "segments", 99);
                                              if (alone) leave_thread_alone(file);
                                            });
}

bool carried(const stage::LessonRun& run) { return in_jaws(run) && !inserted(run); }

}  // namespace swage::bench
