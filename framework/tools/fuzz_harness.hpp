// SPDX-License-Identifier: Apache-2.0
//
// Fuzz harness for a plugin that only observes (a lesson, a coupling): calls it as the step does, in a world of random values. The values
// of a step follow from the seed and the number of the step alone, so that the same steps can be repeated. [main]
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/hash.hpp"
#include "base/rng.hpp"
#include "tools/test_scene.hpp"

namespace swage::tools {

class FuzzHarness {
 public:
  /// The state that the host saves.
  struct Image {
    scene::World world;
    std::vector<uint64_t> random;
  };

  virtual ~FuzzHarness() = default;
  FuzzHarness(const FuzzHarness&) = delete;
  FuzzHarness& operator=(const FuzzHarness&) = delete;

  void reset();
  /// Runs step `number`; `poisoned`: with values that the host never sends (NaN, infinite), to test that they leave no trace.
  void step(uint64_t number, bool poisoned = false);
  Image save() const { return {world_, rig().world.random}; }
  void restore(const Image& image);

  /// Hash of the outputs of the last step and of the private state.
  uint64_t hash() const { return hash_; }
  /// The first fault, or "".
  const std::string& fault() const { return fault_; }
  uint64_t allocations() const { return allocations_; }  // in its functions of the step

 protected:
  /// `scene` is taken after the other arguments, so that a caller may pass one of its instances in the same call.
  FuzzHarness(std::unique_ptr<Stepped>&& scene, host::Instance& instance, uint64_t seed);

  virtual void on_reset() = 0;
  virtual void on_step(base::Xoshiro256& random, bool poisoned) = 0;

  host::Rig& rig() const { return *scene_->rig; }
  /// Calls the plugin; false with a fault reported.
  template <class F>
  bool call(host::Call which, F&& f);
  /// A finite number of any size that a scene can have, often 0.
  static double wild(base::Xoshiro256& random);
  void report_fault(const std::string& what);

  scene::World world_;                   // fuzz values, and the plugin's private state
  std::vector<swage_object_step> view_;  // of each object, into world_
  base::Hash said_;

 private:
  void show(base::Xoshiro256& random);

  std::unique_ptr<Stepped> scene_;
  host::Instance& instance_;
  const uint64_t seed_;
  const Image start_;
  swage_input input_{};
  uint64_t hash_ = 0, allocations_ = 0;
  std::string fault_;
};

/// The plugin under test in a scene of its own; nullptr with `error` when there is no scene, or when it does more than observe.
std::unique_ptr<FuzzHarness> make_fuzz_harness(const TestScene& scene, uint64_t seed, std::string& error);

/// The test `fuzz_values` of the validator: no fault for any values, no state besides that which the host saves, none after a reset.
host::Finding fuzz_values(const TestScene& scene, uint64_t seed);

}  // namespace swage::tools
