// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The corner of a picture in which an inset covers least.
#pragma once

#include <QPointF>
#include <QRectF>
#include <algorithm>
#include <array>
#include <vector>

namespace swage::console {

inline bool covers_any(const QRectF& at, const std::vector<QPointF>& places) {
  return std::any_of(places.begin(), places.end(), [&](const QPointF& p) { return at.contains(p); });
}

/// The index of the corner in which an inset covers least. `must`: places that it may cover only if every corner has one
/// (the tips, their target). `rather`: places of lower priority (other objects that can be grasped). The present
/// corner `now` stays until it covers one of `must`, so that an inset does not jump during aiming; -1: no corner yet.
inline int least_covered(const std::array<QRectF, 3>& corners, int now, const std::vector<QPointF>& must,
                         const std::vector<QPointF>& rather) {
  const auto covered = [&](int corner) {
    std::size_t most = 0, some = 0;
    for (const QPointF& p : must) most += corners[static_cast<std::size_t>(corner)].contains(p);
    for (const QPointF& p : rather) some += corners[static_cast<std::size_t>(corner)].contains(p);
    return most * (rather.size() + 1) + some;
  };
  if (now >= 0 && !covers_any(corners[static_cast<std::size_t>(now)], must)) return now;
  int best = std::max(now, 0);
  for (int corner = 0; corner < 3; ++corner)
    if (covered(corner) < covered(best)) best = corner;
  return best;
}

/// Where an inset stands: its corner, and whether it is small.
struct CornerPlace {
  int corner = 0;
  bool small = false;
  bool operator==(const CornerPlace&) const = default;
};

/// The place of an inset of two sizes: as least_covered(), and small where at the full size every corner covers one of `must`. It grows again
/// only where even `wide`, the full size with more room about it, covers none: a place at its edge must not make it jump between both sizes.
inline CornerPlace least_covered(const std::array<QRectF, 3>& full, const std::array<QRectF, 3>& small, const std::array<QRectF, 3>& wide,
                                 CornerPlace now, bool fresh, const std::vector<QPointF>& must, const std::vector<QPointF>& rather) {
  const auto at = [](const std::array<QRectF, 3>& corners, int corner) { return corners[static_cast<std::size_t>(corner)]; };
  const int of_full = least_covered(full, fresh || now.small ? -1 : now.corner, must, rather);
  if (!covers_any(at(now.small ? wide : full, of_full), must)) return {of_full, false};
  const int of_small = least_covered(small, fresh ? -1 : now.corner, must, rather);
  if (covers_any(at(small, of_small), must) && !now.small) return {of_full, false};  // no size is clear
  return {of_small, true};
}

}  // namespace swage::console
