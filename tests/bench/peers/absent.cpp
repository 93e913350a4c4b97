// SPDX-License-Identifier: Apache-2.0
//
// Peers that were not installed when this was built have nothing to show.
#include "engine.hpp"
#include "peers/rope.hpp"

namespace swage::bench {

#ifndef SWAGE_HAVE_ODE
std::vector<Method> ode_methods() { return {}; }
std::vector<Query> ode_queries(const Needle&) { return {}; }
#endif
#ifndef SWAGE_HAVE_MUJOCO
std::vector<Method> mujoco_methods() { return {}; }
std::vector<Query> mujoco_queries(const Needle&) { return {}; }
std::unique_ptr<Rope> mujoco_rope(const RopeSetup&) { return nullptr; }
#endif
#ifndef SWAGE_HAVE_BULLET
std::vector<Method> bullet_methods() { return {}; }
std::vector<Query> bullet_queries(const Needle&) { return {}; }
std::unique_ptr<Rope> bullet_rope(const RopeSetup&) { return nullptr; }
#endif
#ifndef SWAGE_HAVE_FCL
std::vector<Query> fcl_queries(const Needle&) { return {}; }
#endif

}  // namespace swage::bench
