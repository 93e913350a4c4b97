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

std::string circle_params(const std::optional<NeedleCircle>& circle) {
  const NeedleCircle about = circle.value_or(NeedleCircle{});
  // A component of a float unit vector may be 1 + 6e-8, which a parameter from -1 to 1 refuses: a needle that stands upright could then
  // not be driven.
  const auto within = [](float x) { return std::clamp(double{x}, -1.0, 1.0); };
  const QVector3D p = about.centre / static_cast<float>(kMmPerM), n = about.axis;
  return nlohmann::json{{kCircleCentre, {p.x(), p.y(), p.z()}}, {"circle_axis", {within(n.x()), within(n.y()), within(n.z())}}}.dump();
}

QString PointerHand::turn_about(const std::optional<NeedleCircle>& circle, bool mirrored_lesson) {
  const std::string change = circle_params(circle && mirrored_lesson ? mirrored(*circle) : circle);
  QString refused;
  for (const snapshot::CardDevice& d : control_->card().devices) {
    const host::PluginInfo* plugin = catalogue_.find(d.plugin);
    const bool asks = plugin == nullptr || std::any_of(plugin->params.begin(), plugin->params.end(),
                                                       [](const host::Param& p) { return p.id == kCircleCentre; });
    if (!asks || !is_pointer(d)) continue;
    if (const QString why = control_->change(d.name, change); !why.isEmpty()) refused = why;
  }
  return refused;
}

}  // namespace swage::console
