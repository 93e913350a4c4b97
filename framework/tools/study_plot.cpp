// SPDX-License-Identifier: Apache-2.0
//
// Figures and tables of a study.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "tools/print.hpp"
#include "tools/study.hpp"
#include "tools/svg.hpp"

namespace swage::tools {
namespace {

constexpr double kPlotWidth = 900, kPlotHeight = 480, kLeft = 80, kRight = 30, kPlotTop = 84, kPlotBottom = 80;

using svg::escape;
using svg::style;

class Figure {
 public:
  Figure(const Study& study, const StudyFigure& figure, const std::vector<StudyRow>& rows)
      : study_(study), figure_(figure), rows_(rows) {
    double most = 0;
    for (const StudyRow& row : rows) {
      const double v = value(row);
      if (std::isfinite(v)) most = std::max(most, v);
    }
    tick_ = svg::round_up(std::max(most, 1e-12) / 6);
    top_ = tick_ * std::ceil(std::max(most, 1e-12) / tick_);
    inner_ = study.factors.back().levels.size();
    outer_ = study.factors.size() > 1 ? study.factors[0].levels.size() : 1;
  }

  std::string draw() {
    o_ << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << kPlotWidth << ' ' << kPlotHeight
       << "' font-family='DejaVu Sans, Arial, sans-serif' font-size='13' fill='#222'>\n<rect width='100%' "
          "height='100%' "
          "fill='white'/>\n";
    text(kLeft, 28, figure_.title, "font-size='17' font-weight='bold'");
    axes();
    legend();
    for (const StudyRow& row : rows_) dot(row);
    for (std::size_t i = 0; i < outer_ * inner_; ++i)
      for (std::size_t hand = 0; hand < study_.hands.size(); ++hand) mean(i / inner_, i % inner_, hand);
    o_ << "</svg>\n";
    return o_.str();
  }

 private:
  double value(const StudyRow& row) const {
    const auto found = row.metric.find(figure_.metric);
    return found == row.metric.end() ? NAN : figure_.scale * found->second;
  }
  // cells are grouped by the first factor and placed in each group by the second
  double cell_width() const {
    return (kPlotWidth - kLeft - kRight) / (static_cast<double>(outer_) * (static_cast<double>(inner_) + 0.6));
  }
  double cell_x(std::size_t outer, std::size_t inner) const {
    return kLeft + cell_width() * ((static_cast<double>(inner_) + 0.6) * static_cast<double>(outer) +
                                   static_cast<double>(inner) + 0.8);
  }
  double hand_x(std::size_t outer, std::size_t inner, std::size_t hand) const {
    const double n = static_cast<double>(study_.hands.size());
    return cell_x(outer, inner) + cell_width() * 0.7 * ((static_cast<double>(hand) + 0.5) / n - 0.5);
  }
  double y(double v) const { return kPlotHeight - kPlotBottom - v / top_ * (kPlotHeight - kPlotTop - kPlotBottom); }

  void text(double x, double y, const std::string& s, const std::string& extra) {
    o_ << "<text x='" << format("%.1f", x) << "' y='" << format("%.1f", y) << "' " << extra << ">"
       << escape(s) << "</text>\n";
  }
  void axes() {
    for (double v = 0; v <= top_ * 1.0001; v += tick_) {
      o_ << format("<path d='M%.1f %.1fH%.1f' stroke='#e3e3e3'/>\n", kLeft, y(v), kPlotWidth - kRight);
      text(kLeft - 8, y(v) + 4, format("%.4g", v), "text-anchor='end'");
    }
    o_ << format("<path d='M%.1f %.1fV%.1fH%.1f' fill='none' stroke='#888'/>\n", kLeft, kPlotTop,
                 kPlotHeight - kPlotBottom, kPlotWidth - kRight);
    o_ << format("<g transform='translate(22 %.1f) rotate(-90)'>", 0.5 * (kPlotTop + kPlotHeight - kPlotBottom));
    text(0, 0, figure_.metric + (figure_.unit.empty() ? "" : " (" + figure_.unit + ")"),
         "text-anchor='middle'");
    o_ << "</g>\n";
    for (std::size_t a = 0; a < outer_; ++a) {
      for (std::size_t b = 0; b < inner_; ++b)
        text(cell_x(a, b), kPlotHeight - kPlotBottom + 20, study_.factors.back().levels[b].name,
             "text-anchor='middle'");
      if (study_.factors.size() > 1)
        text(0.5 * (cell_x(a, 0) + cell_x(a, inner_ - 1)), kPlotHeight - kPlotBottom + 42,
             study_.factors[0].name + " " + study_.factors[0].levels[a].name,
             "text-anchor='middle' font-weight='bold'");
    }
    text(0.5 * (kLeft + kPlotWidth - kRight), kPlotHeight - 12, study_.factors.back().name, "text-anchor='middle'");
  }
  void legend() {
    double x = kLeft;
    for (std::size_t hand = 0; hand < study_.hands.size(); ++hand) {
      o_ << format("<path transform='translate(%.1f 52)' d='%s' fill='%s'/>\n", x + 6, style(hand).path,
                   style(hand).colour);
      text(x + 18, 57, study_.hands[hand].name, "");
      x += 40 + 8.5 * static_cast<double>(study_.hands[hand].name.size());
    }
    text(kLeft, 77, "filled: passed, hollow: not; bar: mean", "fill='#666'");
  }
  void dot(const StudyRow& row) {
    const double v = value(row);
    if (!std::isfinite(v)) return;
    // repeats side by side, so that equal values do not hide each other
    const double spread = (static_cast<double>((row.seed - study_.seed) % 7) - 3) * 0.01 * cell_width();
    o_ << format(
        "<path transform='translate(%.1f %.1f)' d='%s' fill='%s' stroke='%s' stroke-width='1.5' "
        "fill-opacity='%s'/>\n",
        hand_x(row.level[0], row.level[1], row.hand) + spread, y(v), style(row.hand).path,
        style(row.hand).colour, style(row.hand).colour, row.passed ? "0.75" : "0");
  }
  void mean(std::size_t outer, std::size_t inner, std::size_t hand) {
    const double v = figure_.scale * cell_of(rows_, outer, inner, hand, figure_.metric).mean;
    if (!std::isfinite(v)) return;
    const double x = hand_x(outer, inner, hand), w = 0.1 * cell_width();
    o_ << format("<path d='M%.1f %.1fH%.1f' stroke='%s' stroke-width='3'/>\n", x - w, y(v), x + w,
                 style(hand).colour);
  }

  const Study& study_;
  const StudyFigure& figure_;
  const std::vector<StudyRow>& rows_;
  std::size_t inner_ = 1, outer_ = 1;
  double tick_ = 1, top_ = 1;
  std::ostringstream o_ = plain_stream();
};

}  // namespace

Cell cell_of(const std::vector<StudyRow>& rows, std::size_t level0, std::size_t level1, std::size_t hand,
             const std::string& metric) {
  Cell cell{0, INFINITY, -INFINITY, 0, 0};
  std::size_t n = 0;
  for (const StudyRow& row : rows) {
    if (row.level[0] != level0 || row.level[1] != level1 || row.hand != hand) continue;
    ++cell.of;
    cell.passed += row.passed;
    const auto found = row.metric.find(metric);
    if (found == row.metric.end() || !std::isfinite(found->second)) continue;
    cell.mean += found->second;
    cell.least = std::min(cell.least, found->second);
    cell.most = std::max(cell.most, found->second);
    ++n;
  }
  if (n == 0) cell.mean = cell.least = cell.most = NAN;
  if (n > 0) cell.mean /= static_cast<double>(n);
  return cell;
}

std::string study_csv(const Study& study, const std::vector<StudyRow>& rows) {
  std::string out;
  for (const StudyFactor& factor : study.factors) out += factor.name + ",";
  out += "hand,seed,passed,reason,score";
  std::map<std::string, double> all;
  for (const StudyRow& row : rows) all.insert(row.metric.begin(), row.metric.end());
  all.erase("score");  // has its own column
  for (const auto& [id, value] : all) out += "," + id;
  out += "\n";
  for (const StudyRow& row : rows) {
    const std::size_t skipped = 2 - study.factors.size();
    for (std::size_t i = 0; i < study.factors.size(); ++i)
      out += study.factors[i].levels[row.level[skipped + i]].name + ",";
    out += study.hands[row.hand].name +
           format(",%llu,%d,", static_cast<unsigned long long>(row.seed), row.passed) + row.reason +
           format(",%.17g", row.score);
    for (const auto& [id, value] : all) {
      const auto found = row.metric.find(id);
      out +=
          found != row.metric.end() && std::isfinite(found->second) ? format(",%.17g", found->second) : ",";
    }
    out += "\n";
  }
  return out;
}

std::string study_svg(const Study& study, const StudyFigure& figure, const std::vector<StudyRow>& rows) {
  return Figure(study, figure, rows).draw();
}

}  // namespace swage::tools
