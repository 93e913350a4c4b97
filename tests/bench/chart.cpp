// SPDX-License-Identifier: Apache-2.0
#include "chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace swage::bench {
namespace {

constexpr double kWidth = 960, kHeight = 560, kLeft = 88, kRight = 330, kTop = 70, kBottom = 66;

// colour of a family; distinct for colour-blind readers, and each family has a mark of its own
struct Style {
  const char* family;
  const char* colour;
  char mark;
};
constexpr Style kStyles[] = {{"swage", "#0b6e4f", 'c'},  {"thesis", "#7a5195", 't'}, {"ODE", "#d95f02", 's'},
                             {"MuJoCo", "#1f66b4", 'd'}, {"Bullet", "#a6761d", 'v'}, {"FCL", "#c2185b", 'p'}};

Style style(const std::string& family) {
  for (const Style& s : kStyles)
    if (family == s.family) return s;
  return {"", "#444444", 's'};
}

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", v);
  return text;
}

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

double x_pixel(const Axis& a, double v) { return kLeft + place(a, v) * (kWidth - kLeft - kRight); }
double y_pixel(const Axis& a, double v) {
  return kHeight - kBottom - place(a, v) * (kHeight - kTop - kBottom);
}

std::vector<double> ticks(const Axis& a) {
  std::vector<double> t;
  if (a.logarithmic) {
    const int step = std::log10(a.high / a.low) > 9 ? 2 : 1;
    for (int e = static_cast<int>(std::ceil(std::log10(a.low) - 1e-9)); std::pow(10.0, e) <= a.high * 1.0001;
         e += step)
      t.push_back(std::pow(10.0, e));
  } else {
    for (int i = 0; i <= 5; ++i) t.push_back(a.low + (a.high - a.low) * i / 5);
  }
  return t;
}

void text(std::ostringstream& o, double x, double y, const std::string& s, const char* extra = "") {
  o << "<text x='" << number(x) << "' y='" << number(y) << "' " << extra << ">" << escape(s) << "</text>\n";
}

void mark(std::ostringstream& o, double x, double y, const Style& s, double r) {
  o << "<g transform='translate(" << number(x) << ' ' << number(y) << ")' fill='" << s.colour
    << "' stroke='white' stroke-width='1'>";
  if (s.mark == 'c') o << "<circle r='" << r << "'/>";
  if (s.mark == 's')
    o << "<rect x='" << -r << "' y='" << -r << "' width='" << 2 * r << "' height='" << 2 * r << "'/>";
  const double d = 1.3 * r;
  if (s.mark == 'd') o << "<path d='M0 " << -d << "L" << d << " 0L0 " << d << "L" << -d << " 0Z'/>";
  if (s.mark == 't') o << "<path d='M0 " << -d << "L" << d << ' ' << r << "L" << -d << ' ' << r << "Z'/>";
  if (s.mark == 'v') o << "<path d='M0 " << d << "L" << d << ' ' << -r << "L" << -d << ' ' << -r << "Z'/>";
  if (s.mark == 'p') o << "<path d='M" << -r << ' ' << -r << "L" << d << " 0L" << -r << ' ' << r << "Z'/>";
  o << "</g>\n";
}

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
    text(o, px, kHeight - kBottom + 18, number(t), "text-anchor='middle'");
  }
  for (double t : ticks(y)) {
    const double py = y_pixel(y, t);
    o << "<path d='M" << kLeft << ' ' << number(py) << 'H' << kWidth - kRight << "' stroke='#e3e3e3'/>\n";
    text(o, kLeft - 8, py + 4, number(t), "text-anchor='end'");
  }
  o << "<rect x='" << kLeft << "' y='" << kTop << "' width='" << kWidth - kLeft - kRight << "' height='"
    << kHeight - kTop - kBottom << "' fill='none' stroke='#888'/>\n";
  text(o, kLeft + (kWidth - kLeft - kRight) / 2, kHeight - 22, x.label,
       "text-anchor='middle' font-size='13'");
  o << "<g transform='translate(22 " << kTop + (kHeight - kTop - kBottom) / 2 << ") rotate(-90)'>";
  text(o, 0, 0, y.label, "text-anchor='middle' font-size='13'");
  o << "</g>\n";
  const auto end = [&](const std::string& s, double px, double py, const char* anchor) {
    if (!s.empty())
      text(o, px, py, s,
           (std::string("font-style='italic' fill='#a33' text-anchor='") + anchor + "'").c_str());
  };
  end(x.below, kLeft + 4, kHeight - kBottom + 34, "start");
  end(x.above, kWidth - kRight - 4, kHeight - kBottom + 34, "end");
  end(y.above, kLeft + 6, kTop + 14, "start");
  end(y.below, kLeft + 6, kHeight - kBottom - 6, "start");
}

/// Names to the right of the plot, in the order given.
template <class Items>
void legend(std::ostringstream& o, const Items& items) {
  double y = kTop + 8;
  int number_of = 0;
  for (const auto& item : items) {
    const Style s = style(item.family);
    mark(o, kWidth - kRight + 44, y, s, 5);
    text(o, kWidth - kRight + 56, y + 4, std::to_string(++number_of) + "  " + item.name,
         item.family == "swage" ? "font-weight='bold'" : "");
    y += 20;
  }
}

void save(const std::string& file, const std::string& content) {
  std::ofstream out(file);
  out << content;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file);
}

}  // namespace

std::string svg(const Scatter& c) {
  std::ostringstream o;
  frame(o, c.title, c.note, c.x, c.y);
  int index = 0;
  for (const auto& m : c.marks) {
    const double px = x_pixel(c.x, m.x), py = y_pixel(c.y, m.y);
    mark(o, px, py, style(m.family), m.family == "swage" ? 7 : 5.5);
    text(o, px + 9, py - 6, std::to_string(++index), "font-size='11'");
  }
  legend(o, c.marks);
  o << "</svg>\n";
  return o.str();
}

std::string svg(const Sweep& c) {
  std::ostringstream o;
  frame(o, c.title, c.note, c.x, c.y);
  if (c.pass > 0) {
    const double py = y_pixel(c.y, c.pass);
    o << "<path d='M" << kLeft << ' ' << number(py) << 'H' << kWidth - kRight
      << "' stroke='#0b6e4f' stroke-dasharray='7 4'/>\n";
    text(o, kWidth - kRight - 4, py - 5, "pass", "text-anchor='end' fill='#0b6e4f'");
  }
  int index = 0;
  for (const auto& line : c.lines) {
    const Style s = style(line.family);
    ++index;
    if (line.points.empty()) continue;
    o << "<polyline fill='none' stroke='" << s.colour << "' stroke-width='"
      << (line.family == "swage" ? 2.6 : 1.5) << "' points='";
    for (const auto& [x, y] : line.points)
      o << number(x_pixel(c.x, x)) << ',' << number(y_pixel(c.y, y)) << ' ';
    o << "'/>\n";
    for (const auto& [x, y] : line.points) mark(o, x_pixel(c.x, x), y_pixel(c.y, y), s, 3.5);
    const auto& [x, y] = line.points.back();
    const double px = x_pixel(c.x, x), py = y_pixel(c.y, y);
    text(o, px + 8, py - 5, std::to_string(index), "font-size='11'");
    if (line.broke)
      o << "<path d='M" << px - 7 << ' ' << py - 7 << 'L' << px + 7 << ' ' << py + 7 << 'M' << px - 7 << ' '
        << py + 7 << 'L' << px + 7 << ' ' << py - 7 << "' stroke='#a33' stroke-width='2.5'/>\n";
  }
  legend(o, c.lines);
  o << "</svg>\n";
  return o.str();
}

std::string csv(const Scatter& c) {
  std::ostringstream o;
  o.precision(9);
  o << "# " << c.title << " | " << c.note << "\nfamily,method,\"" << c.x.label << "\",\"" << c.y.label
    << "\"\n";
  for (const auto& m : c.marks) o << m.family << ",\"" << m.name << "\"," << m.x << ',' << m.y << '\n';
  return o.str();
}

std::string csv(const Sweep& c) {
  std::ostringstream o;
  o.precision(9);
  o << "# " << c.title << " | " << c.note << "\nfamily,method,\"" << c.x.label << "\",\"" << c.y.label
    << "\",broke\n";
  for (const auto& line : c.lines)
    for (size_t i = 0; i < line.points.size(); ++i)
      o << line.family << ",\"" << line.name << "\"," << line.points[i].first << ',' << line.points[i].second
        << ',' << (line.broke && i + 1 == line.points.size() ? 1 : 0) << '\n';
  return o.str();
}

void write(const std::string& folder, const std::string& name, const Scatter& c) {
  save(folder + "/" + name + ".svg", svg(c));
  save(folder + "/" + name + ".csv", csv(c));
}
void write(const std::string& folder, const std::string& name, const Sweep& c) {
  save(folder + "/" + name + ".svg", svg(c));
  save(folder + "/" + name + ".csv", csv(c));
}

}  // namespace swage::bench
