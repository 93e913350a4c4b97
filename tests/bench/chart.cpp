// SPDX-License-Identifier: Apache-2.0
#include "chart.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>

#include "chart_frame.hpp"

namespace swage::bench {
namespace {

using namespace draw;

void save(const std::string& file, const std::string& content) {
  std::ofstream out(file);
  out << content;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + file);
}

void polyline(std::ostringstream& o, const std::vector<std::pair<double, double>>& pixels, const Entry& e,
              double width) {
  o << "<polyline fill='none' stroke='" << style(e.family).colour << "' stroke-width='" << width
    << "' stroke-dasharray='" << dashes(e.nth) << "' points='";
  for (const auto& [x, y] : pixels) o << number(x) << ',' << number(y) << ' ';
  o << "'/>\n";
}

/// A method of the chart with its places on the page.
struct Drawn {
  Entry entry;
  std::vector<std::pair<double, double>> pixels;
};

/// Marks of one name together, in the order of their first appearance.
std::vector<Drawn> gather(const Scatter& c) {
  std::vector<Drawn> all;
  std::map<std::string, int> of_family;
  for (const auto& m : c.marks) {
    auto same = std::find_if(all.begin(), all.end(), [&](const Drawn& d) { return d.entry.name == m.name; });
    if (same == all.end())
      same = all.insert(all.end(), Drawn{{m.family, m.name, of_family[m.family]++, false}, {}});
    same->pixels.push_back({x_pixel(c.x, m.x), y_pixel(c.y, m.y)});
    same->entry.line = same->pixels.size() > 1;
  }
  return all;
}

std::vector<Entry> entries(const std::vector<Drawn>& drawn) {
  std::vector<Entry> all;
  for (const Drawn& d : drawn) all.push_back(d.entry);
  return all;
}

void cross(std::ostringstream& o, double x, double y) {
  o << "<path d='M" << x - 7 << ' ' << y - 7 << 'L' << x + 7 << ' ' << y + 7 << 'M' << x - 7 << ' ' << y + 7
    << 'L' << x + 7 << ' ' << y - 7 << "' stroke='#a33' stroke-width='2.5'/>\n";
}

/// The pass mark and how far a lesson comes.
void bounds(std::ostringstream& o, const Sweep& c) {
  if (c.pass > 0) {
    const double py = y_pixel(c.y, c.pass);
    o << "<path d='M" << kLeft << ' ' << number(py) << 'H' << kWidth - kRight
      << "' stroke='#0b6e4f' stroke-dasharray='7 4'/>\n";
    text(o, kWidth - kRight - 4, py - 5, "pass", "text-anchor='end' fill='#0b6e4f'");
  }
  if (c.range > 0) {
    const double px = x_pixel(c.x, c.range);
    o << "<path d='M" << number(px) << ' ' << kTop << 'V' << kHeight - kBottom
      << "' stroke='#0b6e4f' stroke-dasharray='7 4'/>\n";
    text(o, px - 5, kTop + 16, "a lesson's range", "text-anchor='end' fill='#0b6e4f'");
  }
}

}  // namespace

std::string svg(const Scatter& c) {
  std::ostringstream o;
  frame(o, c.title, c.note, c.x, c.y);
  const std::vector<Drawn> drawn = gather(c);
  Labels labels;
  for (const Drawn& d : drawn) {
    if (d.pixels.size() > 1) polyline(o, d.pixels, d.entry, d.entry.family == "swage" ? 2.2 : 1.3);
    for (const auto& [x, y] : d.pixels) {
      const double r = d.pixels.size() > 1 ? 4.5 : d.entry.family == "swage" ? 7 : 5.5;
      mark(o, x, y, style(d.entry.family), r);
      labels.block(x, y, r);
    }
  }
  for (size_t i = 0; i < drawn.size(); ++i) {
    const auto& [x, y] = drawn[i].pixels.front();
    labels.put(o, x, y, std::to_string(i + 1));
  }
  legend(o, entries(drawn));
  o << "</svg>\n";
  return o.str();
}

std::string svg(const Sweep& c) {
  std::ostringstream o;
  frame(o, c.title, c.note, c.x, c.y);
  bounds(o, c);
  std::vector<Drawn> drawn;
  std::map<std::string, int> of_family;
  Labels labels;
  for (const auto& line : c.lines) {
    Drawn d{{line.family, line.name, of_family[line.family]++, true}, {}};
    for (const auto& [x, y] : line.points) d.pixels.push_back({x_pixel(c.x, x), y_pixel(c.y, y)});
    drawn.push_back(d);
  }
  // ours last, so that nothing lies over it
  for (const bool ours : {false, true})
    for (size_t i = 0; i < drawn.size(); ++i) {
      const Drawn& d = drawn[i];
      if ((d.entry.family == "swage") != ours || d.pixels.empty()) continue;
      polyline(o, d.pixels, d.entry, ours ? 2.6 : 1.5);
      for (const auto& [x, y] : d.pixels)
        mark(o, x, y, style(d.entry.family), ours ? 4.5 : 3.5), labels.block(x, y, 4);
      if (c.lines[i].broke) cross(o, d.pixels.back().first, d.pixels.back().second);
    }
  for (size_t i = 0; i < drawn.size(); ++i)
    if (!drawn[i].pixels.empty())
      labels.put(o, drawn[i].pixels.back().first, drawn[i].pixels.back().second, std::to_string(i + 1));
  legend(o, entries(drawn));
  o << "</svg>\n";
  return o.str();
}

namespace {

std::ostringstream csv_head(const std::string& title, const std::string& note, const Axis& x, const Axis& y,
                            const char* last) {
  std::ostringstream o;
  o.precision(9);
  o << "# " << title << " | " << note << "\nfamily,method,\"" << x.label << "\",\"" << y.label << "\","
    << last << "\n";
  return o;
}

template <class Chart>
void write_both(const std::string& folder, const std::string& name, const Chart& c) {
  save(folder + "/" + name + ".svg", svg(c));
  save(folder + "/" + name + ".csv", csv(c));
}

}  // namespace

std::string csv(const Scatter& c) {
  std::ostringstream o = csv_head(c.title, c.note, c.x, c.y, "setting");
  for (const auto& m : c.marks)
    o << m.family << ",\"" << m.name << "\"," << m.x << ',' << m.y << ",\"" << m.setting << "\"\n";
  return o.str();
}

std::string csv(const Sweep& c) {
  std::ostringstream o = csv_head(c.title, c.note, c.x, c.y, "broke");
  for (const auto& line : c.lines)
    for (size_t i = 0; i < line.points.size(); ++i)
      o << line.family << ",\"" << line.name << "\"," << line.points[i].first << ',' << line.points[i].second
        << ',' << (line.broke && i + 1 == line.points.size() ? 1 : 0) << '\n';
  return o.str();
}

void write(const std::string& folder, const std::string& name, const Scatter& c) {
  write_both(folder, name, c);
}
void write(const std::string& folder, const std::string& name, const Sweep& c) {
  write_both(folder, name, c);
}

}  // namespace swage::bench
