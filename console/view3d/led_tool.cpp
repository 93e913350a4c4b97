// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/led_tool.hpp"

#include <swage/abi/device.h>

#include <algorithm>
#include <cmath>

#include "console/view3d/scene_parts.hpp"

namespace swage::console {
namespace {

bool by_pointer(const snapshot::CardDevice& device) { return (device.flags & SWAGE_DEVICE_POINTER) != 0; }

double distance(const swage_vec3& a, const swage_vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

}  // namespace

int mouse_hands(const snapshot::SceneCard& card) {
  return static_cast<int>(std::count_if(card.devices.begin(), card.devices.end(), by_pointer));
}

uint32_t led_tool(const snapshot::SceneCard& card, const snapshot::Snapshot& now) {
  if (mouse_hands(card) < 2) return SWAGE_NONE;
  uint32_t led = SWAGE_NONE;
  double least = 1e30;
  for (uint32_t d = 0; d < now.n_device && d < card.devices.size(); ++d) {
    const bool buttons = (now.device[d].valid & SWAGE_VALID_BUTTONS) != 0;
    if (!by_pointer(card.devices[d]) || !buttons) continue;
    for (uint32_t o = 0; o < card.objects.size(); ++o) {
      const uint32_t body = card.objects[o].first_body;
      if (role_of(card, o) != Role::kTool || body >= now.n_body) continue;
      const double off = distance(now.X_WB[body].p, now.device[d].X_WD.p);
      if (off < least) least = off, led = o;
    }
  }
  return led;
}

}  // namespace swage::console
