// SPDX-License-Identifier: Apache-2.0
//
// Checks that a plugin's table has all its functions: the step calls them without a check.
#pragma once

#include <swage/abi/band.h>
#include <swage/abi/coupling.h>
#include <swage/abi/device.h>
#include <swage/abi/lesson.h>
#include <swage/abi/sight.h>
#include <swage/abi/visual.h>

#include <string>

#include "host/instance.hpp"
#include "host/sentences.hpp"

namespace swage::host {

inline bool complete(const swage_object& t) { return t.forces && t.finish && t.reset; }
inline bool complete(const swage_solver& t) { return t.advance && t.mobility && t.apply_impulses; }
inline bool complete(const swage_solver_2& t) { return t.advance && t.mobility && t.apply_impulses; }
inline bool complete(const swage_band& t) { return t.linearise && t.displace; }
inline bool complete(const swage_coupling& t) { return t.bind && t.resolve && t.finish && t.reset; }
inline bool complete(const swage_surface& t) { return t.displacement; }
inline bool complete(const swage_ties& t) { return t.ties && t.on_solved; }
inline bool complete(const swage_visuals& t) { return t.draw; }
inline bool complete(const swage_device& t) { return t.open && t.close && t.exchange; }
inline bool complete(const swage_device_sight& t) { return t.bind && t.look; }
inline bool complete(const swage_lesson& t) { return t.bind && t.observe && t.reset; }

/// The table `id` of an instance. nullptr: it is not offered, or a function is missing; `error` then has a sentence,
/// unless the table is not `needed` and not offered. [main]
template <class Table>
const Table* find_table(Instance& instance, const char* id, bool needed, std::string& error) {
  const auto* found = static_cast<const Table*>(instance.extension(id));
  if (found != nullptr && complete(*found)) return found;
  if (found != nullptr) {
    error = say::kGaps(id, instance.plugin_id);
  } else if (needed) {
    error = say::kNotOffered(instance.plugin_id, id);
  }
  return nullptr;
}

}  // namespace swage::host
