// SPDX-License-Identifier: Apache-2.0
//
// A plugin that only looks (a lesson, a coupling), called as the step calls it, but shown a world of random values. What it is shown
// in a step follows from the seed and the number of the step alone, so that the same steps can be repeated. [main]
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
  /// Everything that the host saves.
  struct Image {
    scene::World world;
    std::vector<uint64_t> random;
  };

  virtual ~FuzzHarness() = default;
  FuzzHarness(const FuzzHarness&) = delete;
  FuzzHarness& operator=(const FuzzHarness&) = delete;

  void reset();
  /// Shows step `number`; `poisoned`: with numbers that the host never sends (NaN, infinite), to see what stays of them.
  void step(uint64_t number, bool poisoned = false);
  Image save() const { return {world_, rig().world.random}; }
  void restore(const Image& image);

  /// Of what it said in the last step and of what it remembers.
  uint64_t hash() const { return hash_; }
  /// "" or its first fault.
  const std::string& fault() const { return fault_; }
  uint64_t allocations() const { return allocations_; }  // in its functions of the step

 protected:
  /// `scene` is taken after the other arguments, so that a caller may pass one of its instances in the same call.
  FuzzHarness(std::unique_ptr<Stepped>&& scene, host::Instance& instance, uint64_t seed);

  virtual void on_reset() = 0;
  virtual void on_step(base::Xoshiro256& random, bool poisoned) = 0;

  host::Rig& rig() const { return *scene_->rig; }
  /// Calls the plugin and says whether it behaved.
  template <class F>
  bool call(host::Call which, F&& f);
  /// A finite number of any size that a scene can have, often 0.
  static double wild(base::Xoshiro256& random);
  void report_fault(const std::string& what);

  scene::World world_;                   // what it is shown; its own state lies in it too
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

/// The plugin under test in a scene of its own; nullptr with `error` when there is none, or when it does not only look.
std::unique_ptr<FuzzHarness> make_fuzz_harness(const TestScene& scene, uint64_t seed, std::string& error);

/// The test `fuzz_values` of the validator: whatever it sees it behaves, remembers only what the host saves, forgets at a reset.
host::Finding fuzz_values(const TestScene& scene, uint64_t seed);

}  // namespace swage::tools
