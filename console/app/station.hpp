// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The measurements of a station, kept in its settings: screen, eyes, mirror, and the registration of an arm to the picture.
#pragma once

#include <QPointF>
#include <QString>
#include <array>

#include "console/app/settings.hpp"
#include "console/view3d/true_size.hpp"
#include "session/registration.hpp"

namespace swage::console {

struct Station {
  TrueSize size;
  bool registered = false;
  QString device;  // registered device, named as sessions name it
  QString date;    // of the registration, 2026-11-22
  session::Registration arm;
};

Station read_station(const Settings& settings);
void remember(const Station& station, Settings& settings);

/// The four marks of a registration, mm from the middle of the window, +y up: upper left, upper right, lower right, lower left. They fit
/// into either half of the screen, for displays that give each eye one.
std::array<QPointF, 4> station_marks(const TrueSize& size);

}  // namespace swage::console
