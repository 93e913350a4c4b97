// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A person's own instrument in any lesson: the pose from one device, the jaws from another, the clutch from a third; and where it
// stands. As settings of the session, so that the attempt says what it was. No widgets.
#pragma once

#include <swage/abi/base.h>

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "console/app/settings.hpp"
#include "host/catalogue.hpp"

namespace swage::console {

/// What leads the first instrument of a lesson.
struct Binding {
  std::string pose;  // id of a device plugin; "": what the lesson says
  std::string jaws;  // likewise; "" or the same: the device of the pose
  int clutch = -1;   // button, 0 to 31, that lets the tool stay while it is down; -1: none
  std::string pedal = {};  // id of the device plugin whose button that is; "": the device of the pose
  bool any() const { return !pose.empty(); }
  bool operator==(const Binding&) const = default;
};
/// The choice of an instrument that stands for it, where others are devices of a lesson.
inline constexpr const char* kOwnInstrument = "@own";

/// Remembered at this station for each person.
Binding read_binding(const Settings& settings, const QString& person);
void remember(const Binding& binding, const QString& person, Settings& settings);

/// Devices that a person can hold: all but those that play a file.
std::vector<const host::PluginInfo*> held_devices(const host::Catalogue& catalogue);

/// Where the first instrument of a lesson stands.
struct Placement {
  swage_pose X_WD{{0, 0, 0}, {1, 0, 0, 0}};
  double motion_scale = 1;
  bool force = true;  // false: nothing may push the hand
};

/// "devices=[...]" and what belongs to it; none when the lesson has no device or cannot be read. A device that is told where its tips
/// are at the start is told as the lesson's own is.
std::vector<std::string> instrument_settings(const std::string& lesson_path, const Binding& binding,
                                             const std::optional<Placement>& placement, const host::Catalogue& catalogue);

}  // namespace swage::console
