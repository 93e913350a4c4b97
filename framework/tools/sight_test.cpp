// SPDX-License-Identifier: Apache-2.0
//
// Test of a device that observes the scene (abi/sight.h), in its own scene and in scenes with every body moved. Its samples are
// tested, as a replay repeats the samples and shows no scene.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/hash.hpp"
#include "base/rng.hpp"
#include "host/malloc_guard.hpp"
#include "scene/view.hpp"
#include "tools/extension_tests.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using host::Finding;
using host::Mark;

constexpr uint64_t kSightSteps = 500;     // in its own scene
constexpr uint64_t kLooks = 500;          // in scenes with every body moved

/// "" or the fault of a sample of a LOCKSTEP device.
std::string sample_fault(const swage_sample& s, const swage_sample& last) {
  if (!host::finite(&s.time_s, 16)) return say::kSampleNotFinite();
  const swage_quat& q = s.pose.q;
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if ((s.valid & SWAGE_VALID_POSE) != 0 && !(std::abs(norm - 1) < 1e-3)) return say::kQuaternion(format("%g", norm));
  if ((s.valid & SWAGE_VALID_CLOSURE) != 0 && !(s.closure >= 0 && s.closure <= 1)) return say::kClosure(format("%g", s.closure));
  if (s.sequence < last.sequence) return say::kBackwards();
  return "";
}

/// Port between the engine and the device that tests each sample.
class JudgedPort final : public step::DevicePort {
 public:
  void set_slot(host::DeviceSlot& slot) { slot_ = &slot; }
  void look(uint64_t step, const swage_sight& sight) noexcept override {
    if (slot_ == nullptr) return;
    const uint64_t before = host::thread_allocations();
    step::show(*slot_, step, sight);
    allocations_ += host::thread_allocations() - before;
  }
  void read(uint64_t step, double time_s, swage_sample& sample) noexcept override {
    if (slot_ == nullptr) return;
    const uint64_t before = host::thread_allocations();
    step::exchange(*slot_, step, step::no_force(time_s), sample);
    allocations_ += host::thread_allocations() - before;
    judge(step, sample);
  }
  void send(const step::ToolForce&) noexcept override {}

  void judge(uint64_t step, const swage_sample& sample) {
    said_.add(&sample, sizeof sample);
    if (std::string wrong = sample_fault(sample, last_); fault_.empty() && !wrong.empty()) fault_ = wrong + say::kExchange(step);
    last_ = sample;
  }
  const std::string& fault() const { return fault_; }
  uint64_t allocations() const { return allocations_; }
  uint64_t said() const { return said_.value(); }
  const swage_sample& last() const { return last_; }

 private:
  host::DeviceSlot* slot_ = nullptr;
  swage_sample last_{};
  base::Hash said_;
  std::string fault_;
  uint64_t allocations_ = 0;
};

/// The scene with every body and mark moved by up to ten lengths of the scene, and bodies turned, at random.
class ShiftedScene {
 public:
  explicit ShiftedScene(const host::Rig& rig) : rig_(rig), world_(rig.world) {
    for (const judge::Script::Mark& m : rig.script.marks) mark_.push_back(m.mark.p_W);
  }
  swage_sight show(base::Xoshiro256& random) {
    ++world_.step;
    const double reach = 10 * world_.length;
    for (swage_pose& X_WB : world_.X_WB) {
      move(X_WB.p, reach, random);
      X_WB.q = turned(random);
    }
    for (swage_twist& V_WB : world_.V_WB) move(V_WB.v, reach, random);
    for (swage_vec3& p : mark_) move(p, reach, random);
    object_.clear();
    for (const host::ObjectSlot& o : rig_.objects)
      object_.push_back(scene::view(world_, {o.body, o.particle, o.shape, o.hinge, o.state, o.signal}, &input_));
    view_ = scene::view(world_, object_, {});
    return {sizeof(swage_sight), static_cast<uint32_t>(mark_.size()), &view_, mark_.data()};
  }
  double time() const { return world_.time(); }
  uint64_t step() const { return world_.step; }

 private:
  static void move(swage_vec3& p, double reach, base::Xoshiro256& random) {
    p = {reach * random.uniform(-1, 1), reach * random.uniform(-1, 1), reach * random.uniform(-1, 1)};
  }
  static swage_quat turned(base::Xoshiro256& random) {
    const double half = 1.5 * random.uniform(-1, 1);  // rad
    return {std::cos(half), std::sin(half), 0, 0};
  }

  const host::Rig& rig_;
  scene::World world_;
  std::vector<swage_vec3> mark_;
  std::vector<swage_object_step> object_;
  swage_input input_{{{0, 0, 0}, {1, 0, 0, 0}}, 0, 0, 0, 0};
  swage_view view_{};
};

/// A device in its scene.
struct SightScene {
  JudgedPort port;
  Stepped scene;
  host::DeviceSlot* slot = nullptr;
};

std::string make_sight(const TestScene& scene, SightScene& out) {
  Wish wish;
  wish.hand = &out.port;
  std::string error;
  if (!scene.make(wish, out.scene, error)) return error;
  for (host::DeviceSlot& slot : out.scene.rig->devices)
    if (out.slot == nullptr && slot.instance->plugin_id == scene.plugin().id) out.slot = &slot;
  out.port.set_slot(*out.slot);
  return "";
}

std::string run_sight(SightScene& seen) {
  for (uint64_t i = 0; i < kSightSteps; ++i) {
    seen.scene.engine->step();
    if (!seen.port.fault().empty()) return seen.port.fault();
    if (std::string wrong = seen.scene.fault(); !wrong.empty()) return wrong;
  }
  return seen.port.allocations() > 0 ? say::kAllocates(seen.port.allocations(), kSightSteps) : "";
}

std::string look_elsewhere(SightScene& seen, uint64_t seed) {
  base::Xoshiro256 random(seed);
  ShiftedScene world(*seen.scene.rig);
  for (uint64_t i = 0; i < kLooks; ++i) {
    const host::ScopedRole rt(SWAGE_THREAD_RT);
    const swage_sight sight = world.show(random);
    step::show(*seen.slot, world.step(), sight);
    swage_sample sample = seen.port.last();
    step::exchange(*seen.slot, world.step(), step::no_force(world.time()), sample);
    if (seen.slot->instance->quarantined.load() != 0) return host::quarantine_text(*seen.slot->instance);
    seen.port.judge(world.step(), sample);
    if (!seen.port.fault().empty()) return seen.port.fault();
  }
  return "";
}

}  // namespace

Finding sight(const TestScene& scene, uint64_t seed) {
  SightScene one, other;
  if (std::string wrong = make_sight(scene, one); !wrong.empty()) return {Mark::kFailed, wrong};
  if (one.slot->sight == nullptr) return {Mark::kSkipped, say::kNoSight()};
  if (std::string wrong = run_sight(one); !wrong.empty()) return {Mark::kFailed, wrong};
  // the same scene from the start, for another instance
  if (std::string wrong = make_sight(scene, other); !wrong.empty()) return {Mark::kFailed, wrong};
  if (std::string wrong = run_sight(other); !wrong.empty()) return {Mark::kFailed, wrong};
  if (one.port.said() != other.port.said()) return {Mark::kFailed, say::kSeesOtherwise()};
  if (std::string wrong = look_elsewhere(one, seed); !wrong.empty()) return {Mark::kFailed, wrong + say::kSeed(seed)};
  return {};
}

}  // namespace swage::tools
