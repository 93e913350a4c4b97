// SPDX-License-Identifier: Apache-2.0
#include "chart_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace swage::bench::draw {
namespace {

// after Okabe and Ito: told apart in all common kinds of colour blindness
constexpr Style kStyles[] = {{"swage", "#0b6e4f", 'c'},  {"thesis", "#7a5195", 't'}, {"ODE", "#d95f02", 's'},
                             {"MuJoCo", "#1f66b4", 'd'}, {"Bullet", "#a6761d", 'v'}, {"FCL", "#c2185b", 'p'}};

std::string escape(const std::string& s) {
  std::string out;
  for (char c : s) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

/// Place of a value along an axis, 0..1, held inside.
double place(const Axis& a, double v) {
  if (!std::isfinite(v)) return 1;
  const double t = a.logarithmic ? (std::log10(std::max(v, 1e-300)) - std::log10(a.low)) /
                                       (std::log10(a.high) - std::log10(a.low))
                                 : (v - a.low) / (a.high - a.low);
  return std::clamp(t, 0.0, 1.0);
}

std::vector<double> ticks(const Axis& a) {
  std::vector<double> t;
  if (!a.logarithmic) {
    for (int i = 0; i <= 5; ++i) t.push_back(a.low + (a.high - a.low) * i / 5);
    return t;
  }
  const int step = std::log10(a.high / a.low) > 9 ? 2 : 1;
  for (int e = static_cast<int>(std::ceil(std::log10(a.low) - 1e-9)); std::pow(10.0, e) <= a.high * 1.0001;
       e += step)
    t.push_back(std::pow(10.0, e));
  return t;
}

/// 0.01 to 1000 as they are, powers of ten beyond with a raised exponent.
void tick(std::ostringstream& o, double x, double y, double v, bool logarithmic, const char* anchor) {
  const int e = v > 0 ? static_cast<int>(std::lround(std::log10(v))) : 0;
  if (!logarithmic || (e >= -2 && e <= 3)) return text(o, x, y, number(v), anchor);
  o << "<text x='" << number(x) << "' y='" << number(y) << "' " << anchor
    << ">10<tspan dy='-5' font-size='9'>" << e << "</tspan></text>\n";
}

}  // namespace

Style style(const std::string& family) {
  for (const Style& s : kStyles)
    if (family == s.family) return s;
  return {"", "#444444", 's'};
}

double x_pixel(const Axis& a, double v) { return kLeft + place(a, v) * (kWidth - kLeft - kRight); }
double y_pixel(const Axis& a, double v) {
  return kHeight - kBottom - place(a, v) * (kHeight - kTop - kBottom);
}

std::string number(double v) {
  char out[32];
  std::snprintf(out, sizeof out, "%.4g", v);
  return out;
}

void text(std::ostringstream& o, double x, double y, const std::string& s, const char* extra) {
  o << "<text x='" << number(x) << "' y='" << number(y) << "' " << extra << ">" << escape(s) << "</text>\n";
}

void mark(std::ostringstream& o, double x, double y, const Style& s, double r) {
  o << "<g transform='translate(" << number(x) << ' ' << number(y) << ")' fill='" << s.colour
    << "' stroke='white' stroke-width='1'>";
  const double d = 1.3 * r;
  switch (s.mark) {
    case 'c':
      o << "<circle r='" << r << "'/>";
      break;
    case 's':
      o << "<rect x='" << -r << "' y='" << -r << "' width='" << 2 * r << "' height='" << 2 * r << "'/>";
      break;
    case 'd':
      o << "<path d='M0 " << -d << "L" << d << " 0L0 " << d << "L" << -d << " 0Z'/>";
      break;
    case 't':
      o << "<path d='M0 " << -d << "L" << d << ' ' << r << "L" << -d << ' ' << r << "Z'/>";
      break;
    case 'v':
      o << "<path d='M0 " << d << "L" << d << ' ' << -r << "L" << -d << ' ' << -r << "Z'/>";
      break;
    default:
      o << "<path d='M" << -r << ' ' << -r << "L" << d << " 0L" << -r << ' ' << r << "Z'/>";
  }
  o << "</g>\n";
}

namespace {

void names(std::ostringstream& o, const Axis& x, const Axis& y) {
  text(o, kLeft + (kWidth - kLeft - kRight) / 2, kHeight - kBottom + 58, x.label,
       "text-anchor='middle' font-size='13'");
  o << "<g transform='translate(22 " << kTop + (kHeight - kTop - kBottom) / 2 << ") rotate(-90)'>";
  text(o, 0, 0, y.label, "text-anchor='middle' font-size='13'");
  o << "</g>\n";
  const auto end = [&](const std::string& s, double px, double py, const char* anchor) {
    const std::string extra = std::string("font-style='italic' fill='#a33' text-anchor='") + anchor + "'";
    if (!s.empty()) text(o, px, py, s, extra.c_str());
  };
  end(x.below, kLeft, kHeight - kBottom + 36, "start");
  end(x.above, kWidth - kRight, kHeight - kBottom + 36, "end");
  end(y.above, kLeft + 6, kTop + 14, "start");
  end(y.below, kLeft + 6, kHeight - kBottom - 6, "start");
}

}  // namespace

void frame(std::ostringstream& o, const std::string& title, const std::string& note, const Axis& x,
           const Axis& y) {
  o << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << kWidth << ' ' << kHeight
    << "' font-family='DejaVu Sans, Arial, sans-serif' font-size='12' fill='#222'>\n<rect width='" << kWidth
    << "' height='" << kHeight << "' fill='white'/>\n";
  text(o, kLeft, 28, title, "font-size='17' font-weight='bold'");
  text(o, kLeft, 48, note, "font-size='11' fill='#666'");
  for (double t : ticks(x)) {
    const double px = x_pixel(x, t);
    o << "<path d='M" << number(px) << ' ' << kTop << 'V' << kHeight - kBottom << "' stroke='#e3e3e3'/>\n";
    tick(o, px, kHeight - kBottom + 18, t, x.logarithmic, "text-anchor='middle'");
  }
  for (double t : ticks(y)) {
    const double py = y_pixel(y, t);
    o << "<path d='M" << kLeft << ' ' << number(py) << 'H' << kWidth - kRight << "' stroke='#e3e3e3'/>\n";
    tick(o, kLeft - 8, py + 4, t, y.logarithmic, "text-anchor='end'");
  }
  o << "<rect x='" << kLeft << "' y='" << kTop << "' width='" << kWidth - kLeft - kRight << "' height='"
    << kHeight - kTop - kBottom << "' fill='none' stroke='#888'/>\n";
  names(o, x, y);
}

const char* dashes(int n) {
  static constexpr const char* kDashes[] = {"", "7 4", "2 3", "9 3 2 3", "1 5"};
  return kDashes[std::min(n, 4)];
}

void legend(std::ostringstream& o, const std::vector<Entry>& entries) {
  double y = kTop + 8;
  const double x = kWidth - kRight + 40;
  int index = 0;
  for (const Entry& e : entries) {
    const Style s = style(e.family);
    if (e.line)
      o << "<path d='M" << x - 15 << ' ' << y << "h30' fill='none' stroke='" << s.colour
        << "' stroke-dasharray='" << dashes(e.nth) << "' stroke-width='1.6'/>\n";
    mark(o, x, y, s, 5);
    text(o, x + 20, y + 4, std::to_string(++index) + "  " + e.name,
         e.family == "swage" ? "font-weight='bold'" : "");
    y += 20;
  }
}

void Labels::put(std::ostringstream& o, double x, double y, const std::string& s) {
  const double w = 7.0 * static_cast<double>(s.size()) + 2, h = 11;
  const Box page{kLeft + 1, kTop + 1, kWidth - kRight + 24, kHeight - kBottom - 1};
  for (double far = 13; far < 90; far += 9)
    for (int k = 0; k < 12; ++k) {
      const double angle = -std::numbers::pi / 4 + k * std::numbers::pi / 6;
      const double cx = x + far * std::cos(angle), cy = y + far * std::sin(angle);
      const Box box{cx - w / 2, cy - h / 2, cx + w / 2, cy + h / 2};
      const bool inside = box.x0 > page.x0 && box.x1 < page.x1 && box.y0 > page.y0 && box.y1 < page.y1;
      if (!inside || std::any_of(taken_.begin(), taken_.end(), [&](const Box& b) { return b.meets(box); }))
        continue;
      taken_.push_back(box);
      if (far > 20)
        o << "<path d='M" << number(x) << ' ' << number(y) << 'L' << number(cx) << ' ' << number(cy)
          << "' stroke='#999' stroke-width='0.7'/>\n";
      return text(o, cx, cy + 4, s,
                  "font-size='11' text-anchor='middle' stroke='white' stroke-width='3' paint-order='stroke'");
    }
}

}  // namespace swage::bench::draw
