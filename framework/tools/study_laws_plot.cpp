// SPDX-License-Identifier: Apache-2.0
//
// The figure of a study of reaction laws: left the laws, right the forces for the hand.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "step/reaction.hpp"
#include "tools/print.hpp"
#include "tools/study_laws.hpp"
#include "tools/svg.hpp"

namespace swage::tools {
namespace {

constexpr double kWidth = 1100, kHeight = 460, kTop = 96, kBottom = 60;
constexpr std::size_t kColumns = 700;  // points of a curve over time, each the greatest value in its interval

/// Axes that begin at 0, with curves.
class Panel {
 public:
  Panel(std::ostringstream& out, double left, double right, double most_x, double most_y)
      : o_(out), left_(left), right_(right), tick_x_(svg::round_up(most_x / 5)), tick_y_(svg::round_up(most_y / 5)) {
    top_x_ = most_x;
    top_y_ = tick_y_ * std::ceil(most_y / tick_y_ - 1e-9);
  }
  void axes(const char* x_name, const char* y_name) {
    for (double v = 0; v <= top_y_ * 1.0001; v += tick_y_) {
      o_ << format("<path d='M%.1f %.1fH%.1f' stroke='#e3e3e3'/>\n", left_, y(v), right_);
      text(left_ - 8, y(v) + 4, format("%.4g", v), "text-anchor='end'");
    }
    for (double v = 0; v <= top_x_ * 1.0001; v += tick_x_) text(x(v), kHeight - kBottom + 18, format("%.4g", v), "text-anchor='middle'");
    o_ << format("<path d='M%.1f %.1fV%.1fH%.1f' fill='none' stroke='#888'/>\n", left_, kTop, kHeight - kBottom, right_);
    text(0.5 * (left_ + right_), kHeight - 16, x_name, "text-anchor='middle'");
    o_ << format("<g transform='translate(%.1f %.1f) rotate(-90)'>", left_ - 52, 0.5 * (kTop + kHeight - kBottom));
    text(0, 0, y_name, "text-anchor='middle'");
    o_ << "</g>\n";
  }
  void curve(const std::vector<std::pair<double, double>>& points, std::size_t which) {
    o_ << format("<path fill='none' stroke='%s' stroke-width='1.6' stroke-dasharray='%s' d='", svg::style(which).colour, dashes(which));
    for (std::size_t i = 0; i < points.size(); ++i) o_ << format("%c%.1f %.1f", i == 0 ? 'M' : 'L', x(points[i].first), y(points[i].second));
    o_ << "'/>\n";
  }
  void text(double at_x, double at_y, const std::string& s, const std::string& extra) {
    o_ << format("<text x='%.1f' y='%.1f' ", at_x, at_y) << extra << ">" << svg::escape(s) << "</text>\n";
  }
  // dashes distinguish the laws without colours, too
  static const char* dashes(std::size_t which) {
    static constexpr const char* kDashes[] = {"none", "7 4", "2 3", "10 3 2 3", "4 2"};
    return kDashes[which % 5];
  }

 private:
  double x(double v) const { return left_ + v / top_x_ * (right_ - left_); }
  double y(double v) const { return kHeight - kBottom - v / top_y_ * (kHeight - kTop - kBottom); }

  std::ostringstream& o_;
  double left_, right_, tick_x_, tick_y_, top_x_ = 1, top_y_ = 1;
};

std::vector<std::pair<double, double>> over_time(const std::vector<double>& values, double dt) {
  std::vector<std::pair<double, double>> out;
  const std::size_t each = std::max<std::size_t>(1, values.size() / kColumns);
  for (std::size_t i = 0; i < values.size(); i += each)
    out.emplace_back(dt * static_cast<double>(i), *std::max_element(values.begin() + static_cast<std::ptrdiff_t>(i),
                                                                    values.begin() + static_cast<std::ptrdiff_t>(std::min(i + each, values.size()))));
  return out;
}

}  // namespace

std::string laws_svg(const LawsPlan& plan, const LawsResult& result) {
  std::ostringstream o = plain_stream();
  o << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << kWidth << ' ' << kHeight
    << "' font-family='DejaVu Sans, Arial, sans-serif' font-size='13' fill='#222'>\n<rect width='100%' height='100%' fill='white'/>\n";
  // the axis ends at the 99.9 % quantile of the contact force, so that single spikes do not stretch it
  std::vector<double> sorted = result.scene;
  std::sort(sorted.begin(), sorted.end());
  const double most_f = sorted.empty() ? 0 : sorted[static_cast<std::size_t>(0.999 * static_cast<double>(sorted.size() - 1))];
  double most_law = 0, most_given = 0;
  for (std::size_t k = 0; k < plan.laws.size(); ++k) {
    most_law = std::max(most_law, plan.force_scale * step::felt_force(plan.laws[k].reaction, most_f));
    most_given = std::max(most_given, result.laws[k].peak);
  }
  const double length = result.dt * static_cast<double>(result.scene.size());
  Panel laws(o, 80, 410, std::max(1e3 * most_f, 1e-6), std::max(most_law, 1e-6));
  Panel given(o, 500, kWidth - 30, std::max(length, result.dt), std::max(most_given, 1e-6));
  laws.text(80, 28, plan.title, "font-size='17' font-weight='bold'");
  laws.axes("force in the scene (mN)", "force at the hand by the law (N)");
  given.axes("time (s)", "force given (N)");
  double x = 80;
  for (std::size_t k = 0; k < plan.laws.size(); ++k) {
    o << format("<path d='M%.1f 56h30' stroke='%s' stroke-width='2.5' stroke-dasharray='%s'/>\n", x, svg::style(k).colour, Panel::dashes(k));
    laws.text(x + 38, 60, plan.laws[k].name, "");
    x += 70 + 8.5 * static_cast<double>(plan.laws[k].name.size());
    std::vector<std::pair<double, double>> law;
    for (int i = 0; i <= 200; ++i) {
      const double f = most_f * i / 200;
      law.emplace_back(1e3 * f, plan.force_scale * step::felt_force(plan.laws[k].reaction, f));
    }
    laws.curve(law, k);
    given.curve(over_time(result.laws[k].given, result.dt), k);
  }
  laws.text(80, 82, "right: through the force guard, on the same recorded hand", "fill='#666'");
  o << "</svg>\n";
  return o.str();
}

}  // namespace swage::tools
