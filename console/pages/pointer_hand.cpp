// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/pointer_hand.hpp"

#include <swage/abi/device.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "console/view3d/mesh.hpp"

namespace swage::console {
namespace {

// the live parameter of a pointer device for the centre of the circle along which it rotates a needle
constexpr char kCircleCentre[] = "circle_centre";

bool is_pointer(const snapshot::CardDevice& device) { return (device.flags & SWAGE_DEVICE_POINTER) != 0; }

}  // namespace

bool PointerHand::is_led() const {
  const std::vector<snapshot::CardDevice>& devices = control_->card().devices;
  return std::any_of(devices.begin(), devices.end(), is_pointer);
}

void PointerHand::turn_about(const std::optional<NeedleCircle>& circle, bool mirrored_lesson) {
  NeedleCircle about = circle.value_or(NeedleCircle{});
  if (mirrored_lesson) about = mirrored(about);
  const auto list = [](const QVector3D& v) { return nlohmann::json{v.x(), v.y(), v.z()}; };
  const nlohmann::json change = {{kCircleCentre, list(about.centre / static_cast<float>(kMmPerM))},
                                 {"circle_axis", list(about.axis)}};
  for (const snapshot::CardDevice& d : control_->card().devices) {
    const host::PluginInfo* plugin = catalogue_.find(d.plugin);
    const bool asks = plugin == nullptr || std::any_of(plugin->params.begin(), plugin->params.end(),
                                                       [](const host::Param& p) { return p.id == kCircleCentre; });
    if (asks && is_pointer(d)) control_->change(d.name, change.dump());
  }
}

}  // namespace swage::console
