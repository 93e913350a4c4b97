// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/insertion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swage::console {
namespace {

constexpr double kMm = 1000;        // per m
constexpr double kLeast_mm = 1e-4;  // a point nearer to the last one is skipped: a tenth of a micrometre
constexpr double kPierced = 1.5;    // threshold for pierce.state: 2 in the tissue, 3 with the point out again

class Columns {
 public:
  explicit Columns(const record::Recording& r) : r_(r) {}
  int find(const char* id) const {
    const auto& signals = r_.info.script.signals;
    const auto it =
        std::find_if(signals.begin(), signals.end(), [&](const judge::Name& s) { return s.id == id; });
    return it == signals.end() ? -1 : static_cast<int>(it - signals.begin());
  }
  double at(size_t step, int column) const {
    const size_t n = r_.info.script.signals.size();
    return static_cast<double>(r_.signal[step * n + static_cast<size_t>(column)]);
  }

 private:
  const record::Recording& r_;
};

// cosine over time while the needle is in the tissue; one line for each stay
void add_cosine(const record::Recording& r, const Columns& c, int state, EntryTrack& out) {
  const int cosine = c.find("pierce.cosine");
  bool inside = false;
  size_t n = 0;
  for (size_t i = 0; cosine >= 0 && i < r.step.size(); ++i) {
    const bool was = inside;
    inside = c.at(i, state) > kPierced && std::isfinite(c.at(i, cosine));
    if (!inside) continue;
    if (!was) out.cosine.append(QPolygonF());
    out.cosine.last() << QPointF(static_cast<double>(r.step[i] + 1) * r.info.dt, c.at(i, cosine));
    out.mean_cosine += (c.at(i, cosine) - out.mean_cosine) / static_cast<double>(++n);
  }
}

struct Place {
  double x, y, z, time_s;
  bool first;  // first of a pass
};

// least-squares slopes of the plane z = a x + b y through the first puncture
void fit_plane(const std::vector<Place>& places, double& a, double& b) {
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for (const Place& p : places)
    xx += p.x * p.x, xy += p.x * p.y, yy += p.y * p.y, xz += p.x * p.z, yz += p.y * p.z;
  const double det = xx * yy - xy * xy, size = xx + yy;
  a = b = 0;
  if (size <= 0) return;
  if (det > 1e-6 * size * size) {
    a = (xz * yy - yz * xy) / det;
    b = (yz * xx - xz * xy) / det;
  } else {  // a straight track determines only the slope along it
    a = xz / size;
    b = yz / size;
  }
}

}  // namespace

std::optional<EntryTrack> entry_track(const record::Recording& r) {
  const Columns c(r);
  const int state = c.find("pierce.state"), entries = c.find("pierce.entries");
  const int at[] = {c.find("pierce.at_x"), c.find("pierce.at_y"), c.find("pierce.at_z")};
  const int entry[] = {c.find("pierce.entry_x"), c.find("pierce.entry_y"), c.find("pierce.entry_z")};
  if (state < 0 || entries < 0 || std::min({at[0], at[1], at[2], entry[0], entry[1], entry[2]}) < 0)
    return {};

  std::vector<Place> places;
  double pass = -1;
  for (size_t i = 0; i < r.step.size(); ++i) {
    if (!(c.at(i, state) > kPierced)) continue;
    const auto from_entry = [&](int k) { return kMm * (c.at(i, at[k]) - c.at(i, entry[k])); };
    const double n = c.at(i, entries);
    const Place p{from_entry(0), from_entry(1), from_entry(2), static_cast<double>(r.step[i] + 1) * r.info.dt,
                  n != pass};
    const bool same = !p.first && std::hypot(p.x - places.back().x, p.y - places.back().y,
                                             p.z - places.back().z) < kLeast_mm;
    if (same || !std::isfinite(p.x + p.y + p.z)) continue;
    pass = n;
    places.push_back(p);
  }
  if (places.empty()) return {};

  double a = 0, b = 0;
  fit_plane(places, a, b);
  EntryTrack out;
  for (const Place& p : places) {
    if (p.first) out.passes.append(QPolygonF()), out.time_s.append(QVector<double>());
    // x along the surface, and the part of y perpendicular to it
    const double ex = std::sqrt(1 + a * a), u = (p.x + a * p.z) / ex;
    const double v2 = p.x * p.x + p.y * p.y + p.z * p.z - u * u;
    out.passes.last() << QPointF(u, std::copysign(std::sqrt(std::max(0.0, v2)), p.y + b * p.z));
    out.time_s.last() += p.time_s;
  }
  add_cosine(r, c, state, out);
  const int area = c.find("pierce.area"), ratio = c.find("pierce.area_ratio"), wound = c.find("pierce.wound");
  for (size_t i = 0; i < r.step.size(); ++i) {
    if (wound >= 0) out.wound = std::max(out.wound, c.at(i, wound));
    // the ratio is torn area over the cross-section of the wire
    if (area >= 0 && ratio >= 0 && c.at(i, ratio) > 0)
      out.radius_mm = kMm * std::sqrt(c.at(i, area) / c.at(i, ratio) / std::numbers::pi);
  }
  return out;
}

}  // namespace swage::console
