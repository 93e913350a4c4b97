// SPDX-License-Identifier: Apache-2.0
//
// Source of a pen's events: a node below /dev/input. Never blocks. [main or io]
#pragma once

#include <string>
#include <vector>

#include "pen.hpp"

namespace swage::tablet {

/// An opened pen device.
struct OpenPen {
  int file = -1;  // owned by the caller, who closes it
  std::string name;
  PenRanges ranges;
};

/// Opens the pen at `path`, or, if it is empty, the first one, or the first with the name `like`. "" or the reason, with the remedy.
std::string open_pen(const std::string& path, const std::string& like, OpenPen& out);

}  // namespace swage::tablet
