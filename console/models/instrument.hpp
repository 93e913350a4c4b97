// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A person's own instrument in any lesson: the pose from one device, the jaws from another, the clutch from a third; and its
// placement. Expressed as settings of the session, so that they are in the attempt's record. No widgets.
#pragma once

#include <swage/abi/base.h>

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "console/app/settings.hpp"
#include "host/catalogue.hpp"

namespace swage::console {

/// The devices that drive the first instrument of a lesson.
struct Binding {
  std::string pose;  // id of a device plugin; "": the lesson's device
  std::string jaws;  // likewise; "" or the same: the device of the pose
  int clutch = -1;   // button, 0 to 31, that decouples the tool while pressed; -1: none
  std::string pedal = {};  // id of the device plugin of that button; "": the device of the pose
  bool any() const { return !pose.empty(); }
  bool operator==(const Binding&) const = default;
};
/// The choice that stands for the person's own instrument, among the devices of a lesson.
inline constexpr const char* kOwnInstrument = "@own";

/// Kept at this station for each person.
Binding read_binding(const Settings& settings, const QString& person);
void remember(const Binding& binding, const QString& person, Settings& settings);

/// Devices for a person's hand: all but those that play a file.
std::vector<const host::PluginInfo*> held_devices(const host::Catalogue& catalogue);

/// Placement of the first instrument of a lesson.
struct Placement {
  swage_pose X_WD{{0, 0, 0}, {1, 0, 0, 0}};
  double motion_scale = 1;
  bool force = true;  // false: the device renders no force
};

/// "devices=[...]" with related settings; empty when the lesson has no device or cannot be read. A device with a parameter for the start
/// position of its tips gets that of the lesson's device.
std::vector<std::string> instrument_settings(const std::string& lesson_path, const Binding& binding,
                                             const std::optional<Placement>& placement, const host::Catalogue& catalogue);

}  // namespace swage::console
