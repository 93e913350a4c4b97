// SPDX-License-Identifier: Apache-2.0
//
// A scene of plugins that live in this program, built directly on the C ABI: a tool led by a device, a ball, a coupling
// between them and a lesson. Each call can be taken over by a test.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/rig.hpp"
#include "step/step.hpp"

namespace swage::step {

/// One plugin: its tables call the functions below when they are set.
struct Fake {
  swage_instance raw{};
  swage_object object{};
  swage_solver solver{};
  swage_coupling coupling{};
  swage_device device{};
  swage_lesson lesson{};
  swage_live live{};
  bool has_live = false;

  std::function<swage_result(const swage_object_step*)> forces, finish, advance;
  std::function<void(const swage_object_step*)> reset;
  std::function<swage_result(const swage_coupling_step*)> resolve, coupling_finish;
  std::function<void(const swage_coupling_step*)> coupling_reset;
  std::function<swage_result(const swage_command*, swage_sample*)> exchange;
  std::function<swage_result(const swage_view*, const swage_verdict*, double*)> observe;
  std::function<swage_result(uint32_t, const swage_value*)> change;

  Fake();
  Fake(const Fake&) = delete;
  static Fake& of(swage_instance* raw) { return *static_cast<Fake*>(raw->self); }
  std::unique_ptr<host::Instance> instance(const std::string& name);
};

/// Bodies: 0 the tool (FOLLOWS, a sphere of 0.5 mm), 1 the ball (DYNAMIC, a sphere of 0.5 mm, 1 mg, 5 mm above the origin).
/// Signals: tool 0, ball 1, coupling 2. Private doubles: ball 2, coupling 1, lesson 1. No gravity.
class FakeScene {
 public:
  FakeScene();
  Engine& engine();  // made at the first use
  void run(int steps) {
    for (int i = 0; i < steps; ++i) engine().step();
  }
  const swage_pose& tool() { return rig.world.X_WB[0]; }
  const swage_pose& ball() { return rig.world.X_WB[1]; }

  host::Rig rig;
  Fake tool_, ball_, coupling_, device_, lesson_;

 private:
  void add_objects();
  void add_contact();
  void add_body(int32_t motion, uint32_t object, swage_vec3 p);
  std::unique_ptr<Engine> engine_;
};

}  // namespace swage::step
