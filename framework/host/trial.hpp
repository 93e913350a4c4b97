// SPDX-License-Identifier: Apache-2.0
//
// One instance alone in its own world, called as the step calls it but without contacts and integration:
// bodies move on a given path, hands and drives are given. The validator and the tests of bad plugins step
// it by hand. Threads: [main], which takes the role [rt] for each step.
#pragma once

#include <swage/abi/device.h>
#include <swage/abi/object.h>

#include <memory>
#include <string>

#include "host/builder.hpp"
#include "host/guard.hpp"
#include "host/library.hpp"
#include "host/plugin_info.hpp"

namespace swage::host {

class Trial {
 public:
  /// Creates, configures and activates. Where ready() is false, error() has the reason, problems() may have more.
  Trial(const Library& library, const PluginInfo& plugin, ParamValues values);
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial();

  bool configured() const { return configured_; }
  bool ready() const { return ready_; }
  /// True for kinds that can be stepped alone: objects, and devices that open.
  bool steps() const { return object_ != nullptr || device_ != nullptr; }
  const std::string& error() const { return error_; }
  const base::Problems& problems() const { return problems_; }
  Instance* instance() { return instance_.get(); }

  /// One step; false when its output was discarded (quarantine, or the plugin said DISCARD).
  bool step();
  /// Steps until an output is discarded, at most n times. Returns the number of that step, 0 when there was none.
  uint64_t run(uint64_t n);
  /// Resets to the start, as the step does.
  void reset();
  uint64_t steps_done() const { return world_.step; }
  /// Heap allocations inside the plugin's [rt] functions so far, when the program counts them.
  uint64_t allocations() const { return allocations_; }

  /// Fault of its chains after the last step, or "".
  std::string chain_fault() const;
  /// Hash of its output in the last step and of its state.
  uint64_t hash() const;
  /// The whole state, for a later restore().
  const scene::World& world() const { return world_; }
  void restore(const scene::World& saved) { world_ = saved; }

 private:
  void open_device();
  void move();
  bool step_object();
  bool step_device();
  template <class F>
  bool call(Call which, F&& f);

  scene::World world_;
  judge::Script script_;
  base::Problems problems_;
  std::string error_;
  std::unique_ptr<Instance> instance_;
  std::unique_ptr<Builder> builder_;
  const swage_object* object_ = nullptr;
  const swage_solver* solver_ = nullptr;
  const swage_solver_2* solver_2_ = nullptr;
  const swage_device* device_ = nullptr;
  swage_input input_{};
  swage_sample sample_{};
  std::vector<double> chain_before_;  // private doubles before advance()
  bool configured_ = false, ready_ = false;
  uint64_t allocations_ = 0, random_start_ = 0;
};

}  // namespace swage::host
