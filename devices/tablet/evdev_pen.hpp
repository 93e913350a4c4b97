// SPDX-License-Identifier: Apache-2.0
//
// Where a pen's events come from: a node below /dev/input. Never waits. [main or io]
#pragma once

#include <string>
#include <vector>

#include "pen.hpp"

namespace swage::tablet {

/// A pen's node, opened.
struct OpenPen {
  int file = -1;  // to be closed
  std::string name;
  PenRanges ranges;
};

/// The pen at `path`, or, if it is empty, the first that there is, or that is called `like`. "" or why not, with what to do.
std::string open_pen(const std::string& path, const std::string& like, OpenPen& out);

}  // namespace swage::tablet
