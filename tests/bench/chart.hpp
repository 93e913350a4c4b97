// SPDX-License-Identifier: Apache-2.0
//
// Charts out of figures: SVG for people, CSV beside it for machines. Nothing is drawn by hand.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace swage::bench {

struct Axis {
  std::string label;  // with unit: "error of the depth, um"
  double low = 1e-3, high = 1e3;
  bool logarithmic = true;
  std::string below, above;  // what values at or beyond the ends mean: "exact", "lost"
};

/// Error against cost: one mark per method and setting; marks of one name are joined in their order. Values outside an axis
/// are drawn at its end, with that end's name.
struct Scatter {
  std::string title, note;  // note: machine, hiccups, date: one line under the title
  Axis x, y;
  struct Mark {
    std::string family, name;
    double x = 0, y = 0;
    std::string setting;  // "dt 1 ms": in the CSV, and beside a joined mark
  };
  std::vector<Mark> marks;
};

/// A measure against a swept parameter: one line per method; it ends in a cross where the method broke.
struct Sweep {
  std::string title, note;
  Axis x, y;
  double pass = 0;   // the pass mark on y, drawn as a dashed line; 0: none
  double range = 0;  // up to where on x a lesson can come, drawn as a dashed line; 0: everywhere
  struct Line {
    std::string family, name;
    std::vector<std::pair<double, double>> points;
    bool broke = false;
  };
  std::vector<Line> lines;
};

std::string svg(const Scatter&);
std::string svg(const Sweep&);
std::string csv(const Scatter&);
std::string csv(const Sweep&);

/// Writes <folder>/<name>.svg and .csv; throws std::runtime_error naming the file that could not be written.
void write(const std::string& folder, const std::string& name, const Scatter&);
void write(const std::string& folder, const std::string& name, const Sweep&);

}  // namespace swage::bench
