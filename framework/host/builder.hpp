// SPDX-License-Identifier: Apache-2.0
//
// The host's side of swage_builder: declarations of an instance during configure are checked and stored in the world
// and the script. One Builder per configure call. Threads: [main].
#pragma once

#include <swage/abi/builder.h>

#include <functional>
#include <string>
#include <vector>

#include "base/problem.hpp"
#include "judge/verdict.hpp"
#include "scene/world.hpp"

namespace swage::host {

class Builder {
 public:
  /// The instance that declares. Bodies and shapes get this object index and are placed by X_WO.
  struct Owner {
    int32_t kind = SWAGE_KIND_OBJECT;  // SWAGE_KIND_*
    std::string name;                  // of the instance
    uint32_t object = scene::kNone;    // OBJECT: its index in the rig
    swage_pose X_WO{{0, 0, 0}, {1, 0, 0, 0}};
    /// Problem::where for a parameter ("" is the whole instance); where empty: the instance's
    /// name.
    std::function<std::string(const std::string& param_id)> where;
  };

  Builder(Owner owner, scene::World& world, judge::Script& script, base::Problems& problems);

  swage_builder* abi() { return &abi_; }
  bool failed() const { return failed_; }
  /// Checks that need all declarations: a hinge for each hinged body. Instance::configure calls it.
  void finish();

  // the declarations, as ranges of the world's and the script's arrays
  scene::Range body, particle, shape, hinge, state, signal, metric, cue, event, phase;

 private:
  friend struct BuilderCalls;
  friend struct HeightFieldCalls;
  friend struct CapacityCalls;
  friend struct ChainCalls;
  uint32_t refuse(const std::string& message, const std::string& param_id = "");
  bool may(bool allowed, const char* what);  // false, with a refusal, when this kind of plugin may not declare `what`
  bool fits(std::size_t n, uint32_t capacity, const char* what);
  bool owns_body(uint32_t index, const char* shape);
  uint32_t add_shape(uint32_t body, scene::Shape shape, uint32_t flags);
  uint32_t add_name(std::vector<judge::Name>& list, scene::Range& range, judge::Name name);

  Owner owner_;
  scene::World& world_;
  judge::Script& script_;
  base::Problems& problems_;
  bool failed_ = false;
  uint32_t refusals_ = 0;
  swage_builder abi_{};
};

/// The table of SWAGE_HOST_HEIGHT_FIELD.
const swage_host_height_field& height_field_table();
/// For SWAGE_HOST_CAPACITIES: reserves contact points in the world; and the capacities of a scene as plugins see them.
uint32_t reserve_points(swage_builder* builder, uint32_t points);
swage_capacities capacities_of(const scene::World& world);
/// The table of SWAGE_HOST_CHAIN.
const swage_host_chain& chain_table();

}  // namespace swage::host
