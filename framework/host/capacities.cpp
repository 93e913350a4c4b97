// SPDX-License-Identifier: Apache-2.0
#include "host/builder.hpp"
#include "host/sentences.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::host {

struct CapacityCalls {
  static uint32_t reserve(swage_builder* raw, uint32_t points) {
    Builder& b = *static_cast<Builder*>(raw->host_data);
    if (!b.may(b.owner_.kind == SWAGE_KIND_OBJECT, "contact points")) return 0;
    if (points > scene::kLargest.points) {
      b.refuse(say::kManyPoints(scene::kLargest.points, points));
      return 0;
    }
    scene::make_room(b.world_.capacity, points);
    return b.world_.capacity.points;
  }
};

uint32_t reserve_points(swage_builder* builder, uint32_t points) {
  return CapacityCalls::reserve(builder, points);
}

swage_capacities capacities_of(const scene::World& world) {
  const scene::Capacities& room = world.capacity;
  return {sizeof(swage_capacities), room.contacts, room.ties, room.points, room.rows, snapshot::kMaxBodies};
}

}  // namespace swage::host
