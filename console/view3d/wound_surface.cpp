// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/wound_surface.hpp"

#include <QVector2D>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace swage::console {
namespace {

// shares of the wire's radius, but for the lift
constexpr float kLip =
    1.1F;  // width of the lip; swelling reaches about a wire's thickness around a fresh hole
constexpr float kHigh = 0.35F;     // of its crest over the surface
constexpr float kWall = 0.5F;      // way from the crest down into the wound
constexpr float kOpen = 0.85F;     // half width of the opening where the needle is
constexpr float kShut = 0.4F;      // and where it has long gone
constexpr float kCloses = 3;       // way along the wound in which it closes
constexpr float kOver = 0.03F;     // by which the opening is drawn over the flesh
constexpr float kCell = 0.25F;     // side of a cell
constexpr int kTile = 8;           // cells along a side of a tile
constexpr int kRounds = 6;         // a sixty-fourth of the way is left: 2 um of 0.1 mm
constexpr float kLift_mm = 8e-3F;  // over the surface, so that it does not flicker

/// Where a place of a wound is now: told as it is along the surface, at rest across it.
QVector3D pressed(const std::vector<Dent>& dents, const QVector3D& p, const QVector3D& normal) {
  return p + QVector3D::dotProduct(displacement(dents, at_rest(dents, p, normal)), normal) * normal;
}

/// A place in the plane of a wound and what is there.
struct Place {
  QVector2D p;
  float wound = 0, opening = 0;  // distances from their edges, inside negative
  QVector2D away;                // unit, the way in which `wound` grows
};

/// The plane of a wound, in which it is a union of capsules.
class Field {
 public:
  explicit Field(const std::vector<Tear>& tears)
      : origin_(tears[0].a), normal_(tears[0].normal), radius_(tears[0].radius) {
    const QVector3D any = std::abs(normal_.x()) < 0.9F ? QVector3D(1, 0, 0) : QVector3D(0, 1, 0);
    e1_ = QVector3D::crossProduct(normal_, any).normalized();
    e2_ = QVector3D::crossProduct(normal_, e1_);
    for (const Tear& t : tears) lines_.push_back({flat(t.a), flat(t.b) - flat(t.a)});
    needle_ = flat(tears.back().b);
  }

  float radius() const { return radius_; }
  const QVector3D& normal() const { return normal_; }
  QVector3D world(const QVector2D& p) const { return origin_ + p.x() * e1_ + p.y() * e2_; }
  QVector3D along(const QVector2D& p) const { return p.x() * e1_ + p.y() * e2_; }

  Place at(const QVector2D& p) const {
    Place out{p, 1e9F, 1e9F, {}};
    for (const Line& line : lines_) {
      const float length2 = line.along.lengthSquared();
      const float t = length2 > 0
                          ? std::clamp(QVector2D::dotProduct(p - line.from, line.along) / length2, 0.F, 1.F)
                          : 0.F;
      const QVector2D nearest = line.from + t * line.along, off = p - nearest;
      const float far = off.length();
      if (far - radius_ < out.wound) {
        out.wound = far - radius_;
        out.away = far > 0 ? off / far : QVector2D();
      }
      const float near_needle = std::max(0.F, 1 - (nearest - needle_).length() / (kCloses * radius_));
      out.opening = std::min(out.opening, far - radius_ * (kShut + (kOpen - kShut) * near_needle));
    }
    return out;
  }

  /// Squares of the plane, `side` wide, that hold the wound and its lip.
  std::set<std::pair<int, int>> tiles(float side) const {
    std::set<std::pair<int, int>> out;
    const float reach = (1 + kLip) * radius_;
    const auto index = [&](float x) { return static_cast<int>(std::floor(x / side)); };
    for (const Line& line : lines_) {
      const int steps = 1 + static_cast<int>(line.along.length() / radius_);
      for (int k = 0; k <= steps; ++k) {
        const QVector2D p = line.from + line.along * (static_cast<float>(k) / static_cast<float>(steps));
        for (int i = index(p.x() - reach); i <= index(p.x() + reach); ++i)
          for (int j = index(p.y() - reach); j <= index(p.y() + reach); ++j) out.insert({i, j});
      }
    }
    return out;
  }

 private:
  struct Line {
    QVector2D from, along;
  };
  QVector2D flat(const QVector3D& p) const {
    return {QVector3D::dotProduct(p - origin_, e1_), QVector3D::dotProduct(p - origin_, e2_)};
  }
  QVector3D origin_, normal_, e1_, e2_;
  float radius_;
  std::vector<Line> lines_;
  QVector2D needle_;
};

/// Height over the surface in radii and its slope, `d` radii from the wound's edge.
std::pair<float, float> profile(float d) {
  if (d >= kLip) return {0.F, 0.F};
  if (d >= 0) {
    const float s = d / kLip;
    return {kHigh * (1 - s * s * (3 - 2 * s)), -kHigh * 6 * s * (1 - s) / kLip};
  }
  const float s = std::min(1.F, -d / kWall);
  return {kHigh * (1 - s) * (1 - s), 2 * kHigh * (1 - s) / kWall};
}

/// What of a triangle lies where a field is at least `sign` times `level`, the field being linear on it.
std::vector<Place> clipped(const std::vector<Place>& corners, float Place::*field, float sign, float level) {
  std::vector<Place> out;
  const auto inside = [&](const Place& q) { return sign * (q.*field - level); };
  for (size_t i = 0; i < corners.size(); ++i) {
    const Place &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const float at_a = inside(a), at_b = inside(b);
    if (at_a >= 0) out.push_back(a);
    if ((at_a >= 0) == (at_b >= 0)) continue;
    const float t = at_a / (at_a - at_b);
    const QVector2D away = (1 - t) * a.away + t * b.away;
    out.push_back({(1 - t) * a.p + t * b.p, (1 - t) * a.wound + t * b.wound,
                   (1 - t) * a.opening + t * b.opening, away.normalized()});
  }
  return out;
}

/// Puts pieces of one wound onto the dented surface.
class Builder {
 public:
  Builder(const Field& field, const std::vector<Dent>& dents) : field_(field), dents_(dents) {}

  void triangle(const std::array<Place, 3>& corner, WoundMeshes& out) const {
    const std::vector<Place> all(corner.begin(), corner.end());
    fan(clipped(clipped(all, &Place::wound, 1, 0), &Place::wound, -1, kLip * field_.radius()), 0, out.lip);
    fan(clipped(all, &Place::wound, -1, 0), 0, out.flesh);
    fan(clipped(all, &Place::opening, -1, 0), kOver, out.depth);
  }

 private:
  void fan(const std::vector<Place>& corners, float over, Mesh& out) const {
    if (corners.size() < 3) return;
    const auto first = static_cast<uint32_t>(out.vertex.size());
    for (const Place& q : corners) {
      const auto [height, slope] = profile(q.wound / field_.radius());
      const QVector3D p = field_.world(q.p);
      const QVector3D at = pressed(dents_, p, field_.normal()) +
                           (kLift_mm + (height + over) * field_.radius()) * field_.normal();
      const QVector3D n = (field_.normal() - slope * field_.along(q.away)).normalized();
      out.vertex.push_back({{at.x(), at.y(), at.z()}, {n.x(), n.y(), n.z()}});
    }
    for (uint32_t k = 1; k + 1 < corners.size(); ++k)
      out.index.insert(out.index.end(), {first, first + k, first + k + 1});
  }
  const Field& field_;
  const std::vector<Dent>& dents_;
};

/// Capsules of each wound, in the order in which they are told.
std::vector<std::vector<Tear>> wounds_of(const std::vector<Tear>& tears) {
  std::vector<std::vector<Tear>> out;
  for (const Tear& t : tears) {
    if (t.radius <= 0) continue;
    const auto same =
        std::find_if(out.begin(), out.end(), [&](const auto& w) { return w[0].wound == t.wound; });
    if (same == out.end())
      out.push_back({t});
    else
      same->push_back(t);
  }
  return out;
}

}  // namespace

// solves q + the part of its displacement along the surface = p, half a step at a time: where tissue is drawn along by more than
// a dent's radius a whole one goes back and forth
QVector3D at_rest(const std::vector<Dent>& dents, const QVector3D& p, const QVector3D& normal) {
  QVector3D q = p;
  for (int round = 0; !dents.empty() && round < kRounds; ++round) {
    const QVector3D u = displacement(dents, q);
    q += 0.5F * (p - (u - QVector3D::dotProduct(u, normal) * normal) - q);
  }
  return q;
}

void append_wounds(const std::vector<Tear>& tears, const std::vector<Dent>& dents, WoundMeshes& out) {
  for (const std::vector<Tear>& wound : wounds_of(tears)) {
    const Field field(wound);
    const Builder builder(field, dents);
    const float cell = kCell * field.radius(), side = kTile * cell;
    for (const auto& [i, j] : field.tiles(side)) {
      Place at[kTile + 1][kTile + 1];
      for (int x = 0; x <= kTile; ++x)
        for (int y = 0; y <= kTile; ++y)
          at[x][y] =
              field.at({static_cast<float>(i * kTile + x) * cell, static_cast<float>(j * kTile + y) * cell});
      for (int x = 0; x < kTile; ++x)
        for (int y = 0; y < kTile; ++y) {
          builder.triangle({at[x][y], at[x + 1][y], at[x + 1][y + 1]}, out);
          builder.triangle({at[x][y], at[x + 1][y + 1], at[x][y + 1]}, out);
        }
    }
  }
}

namespace {

// Tissue is drawn along by the needle, and a wound with it: by less than this, mm. The bites of a running suture lie farther apart.
constexpr float kDrawn_mm = 0.6F;

/// Whether a wound is the nearest one to a place where the needle last went in or out.
bool of_last_bite(const std::vector<Tear>& wound, const std::vector<std::vector<Tear>>& all, const Punctures& last) {
  const auto is_nearest = [&](const QVector3D& place) {
    const float own = (wound[0].a - place).length();
    return own < kDrawn_mm &&
           std::all_of(all.begin(), all.end(), [&](const auto& other) { return (other[0].a - place).length() >= own; });
  };
  return std::any_of(last.entries.begin(), last.entries.end(), is_nearest) ||
         std::any_of(last.exits.begin(), last.exits.end(), is_nearest);
}

}  // namespace

WoundKind kind_of_wound(const QVector3D& puncture, const Punctures& last) {
  const auto nearest = [&](const std::vector<QVector3D>& places) {
    float least = 2 * kDrawn_mm;
    for (const QVector3D& p : places) least = std::min(least, (p - puncture).length());
    return least;
  };
  const float from_entry = nearest(last.entries), from_exit = nearest(last.exits);
  if (std::min(from_entry, from_exit) > kDrawn_mm) return WoundKind::kUnknown;
  return from_entry <= from_exit ? WoundKind::kEntry : WoundKind::kExit;
}

WoundPlace greatest_wound(const std::vector<Tear>& tears, const std::vector<Dent>& dents, const Punctures& last) {
  WoundPlace out;
  const std::vector<std::vector<Tear>> wounds = wounds_of(tears);
  const bool any_last =
      std::any_of(wounds.begin(), wounds.end(), [&](const auto& wound) { return of_last_bite(wound, wounds, last); });
  for (const std::vector<Tear>& wound : wounds) {
    if (any_last && !of_last_bite(wound, wounds, last)) continue;
    const float r = wound[0].radius;
    QVector3D low = wound[0].a, high = low;
    float reach = r;
    for (const Tear& t : wound)
      for (const QVector3D& p : {t.a, t.b}) {
        reach = std::max(reach, (p - wound[0].a).length() + r);
        for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
      }
    const double ratio = static_cast<double>(reach / r);
    if (ratio <= out.ratio) continue;
    const QVector3D middle = 0.5F * (low + high);
    out = {pressed(dents, middle, wound[0].normal), wound[0].normal, wound[0].a,      0.5F * (high - low).length() + r,
           ratio,                                   static_cast<int>(wounds.size())};
  }
  return out;
}

}  // namespace swage::console
