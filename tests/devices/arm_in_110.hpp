// SPDX-License-Identifier: Apache-2.0
//
// A lesson, 110 unless another is named, played by one of its hands that takes forces as an arm would.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "assembly/assemble.hpp"
#include "host/catalogue.hpp"
#include "session/device_ports.hpp"
#include "step/step.hpp"
#include "test_places.hpp"
#include "toolkit/math.hpp"

namespace swage::session {

using toolkit::Vec3;

inline constexpr double kMostForce = 3.3;  // N, of a Touch

/// The lesson with a hand that is led like its own and takes forces.
struct ArmIn110 {
  explicit ArmIn110(const host::Reaction& reaction, const std::string& lesson = "110_insertion", const std::string& hand = "expert") {
    assembly::LessonFile file;
    base::Problems problems;
    EXPECT_TRUE(assembly::read_lesson_file(SWAGE_SOURCE_DIR "/lessons/series/" + lesson + ".json", file, problems));
    scale = file.devices[0].force_scale;
    host::Catalogue::Options options;
    options.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
    options.use_environment = false;
    rig = assembly::assemble(file, host::Catalogue(options), assembly::Overrides{hand, ""}, problems);
    if (!rig) return;
    host::DeviceSlot& slot = rig->devices[0];
    led() = slot.device->exchange;
    table = *slot.device;
    table.exchange = [](swage_instance* raw, const swage_command* command, swage_sample* out) {
      given() = *command;
      return led()(raw, command, out);
    };
    table.flags |= SWAGE_DEVICE_FORCE;
    table.max_force = kMostForce;
    slot.device = &table;
    slot.force_scale = scale;
    slot.coupling = file.devices[0].coupling;
    slot.reaction = reaction;
    slot.device->open(slot.instance->raw);
    port = std::make_unique<StepPort>(slot, rig->world.dt, true);
    port->arm();
    engine = std::make_unique<step::Engine>(*rig, step::Options{}, std::vector<step::DevicePort*>{port.get()});
  }
  /// What the force guard has let through in the last step.
  static swage_command& given() {
    static swage_command one{};
    return one;
  }
  static swage_result (*&led())(swage_instance*, const swage_command*, swage_sample*) {
    static swage_result (*one)(swage_instance*, const swage_command*, swage_sample*) = nullptr;
    return one;
  }
  /// Sum of the contact forces on the tool, N.
  Vec3 scene() const {
    Vec3 f = Vec3::Zero();
    const host::ObjectSlot& tool = rig->objects[0];
    const auto own = [&](uint32_t body) { return body >= tool.body.first && body < tool.body.first + tool.body.count; };
    for (const contact::Contact& c : engine->contacts().contact) f += ((own(c.body_a) ? 1.0 : 0.0) - (own(c.body_b) ? 1.0 : 0.0)) * c.f_a_W;
    return f;
  }

  std::unique_ptr<host::Rig> rig;
  swage_device table{};
  std::unique_ptr<StepPort> port;
  std::unique_ptr<step::Engine> engine;
  double scale = 0;
};

// the formulas by themselves, apart from the code
inline double formula(const host::Reaction& r, double f) {
  switch (r.law) {
    case host::Law::kNullZone:
      return f > r.from ? f - r.from : 0;
    case host::Law::kThreshold:
      return f > r.from ? f : 0;
    case host::Law::kQuadratic:
      return f * f / r.from;
    case host::Law::kTable:
      return f < 0.02 ? 0.5 * f : 0.01 + 2 * (f - 0.02);
    default:
      return f;
  }
}

}  // namespace swage::session
