// SPDX-License-Identifier: Apache-2.0
//
// What all charts share: page, axes, marks, legend, and labels that keep clear of each other. Room-internal.
#pragma once

#include <sstream>
#include <vector>

#include "chart.hpp"

namespace swage::bench::draw {

inline constexpr double kWidth = 960, kHeight = 580, kLeft = 92, kRight = 330, kTop = 70, kBottom = 84;

/// Colour and mark of a family: distinct for colour-blind readers, and no two share a mark.
struct Style {
  const char* family;
  const char* colour;
  char mark;
};
Style style(const std::string& family);

double x_pixel(const Axis& a, double v);
double y_pixel(const Axis& a, double v);

std::string number(double v);
void text(std::ostringstream& o, double x, double y, const std::string& s, const char* extra = "");
void mark(std::ostringstream& o, double x, double y, const Style& s, double r);
/// Page, title, note, grid, ticks and names of the axes and of their ends.
void frame(std::ostringstream& o, const std::string& title, const std::string& note, const Axis& x,
           const Axis& y);
/// Dashes of the n-th line of a family, "" for the first.
const char* dashes(int n);

/// One row of the legend.
struct Entry {
  std::string family, name;
  int nth = 0;        // of its family
  bool line = false;  // with a piece of its line
};
void legend(std::ostringstream& o, const std::vector<Entry>& entries);

/// Small numbers beside marks: each goes to the nearest free place and is tied to its mark when that is far.
class Labels {
 public:
  void block(double x, double y, double r) { taken_.push_back({x - r, y - r, x + r, y + r}); }
  void put(std::ostringstream& o, double x, double y, const std::string& s);

 private:
  struct Box {
    double x0, y0, x1, y1;
    bool meets(const Box& b) const { return x0 < b.x1 && b.x0 < x1 && y0 < b.y1 && b.y0 < y1; }
  };
  std::vector<Box> taken_;
};

}  // namespace swage::bench::draw
