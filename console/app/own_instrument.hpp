// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Each person's own instrument, taken up with the person's name and remembered at this station. [main]
#pragma once

#include <QObject>

#include "console/app/settings.hpp"
#include "console/app/window_pages.hpp"

namespace swage::console {

class OwnInstrument : public QObject {
  Q_OBJECT
 public:
  /// Both outlive it.
  OwnInstrument(const WindowPages* pages, Settings& settings);

 private:
  void take();

  const WindowPages* pages_;
  Settings& settings_;
};

}  // namespace swage::console
