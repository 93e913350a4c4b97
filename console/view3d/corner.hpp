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
  const auto covers_must = [&](int corner) {
    return std::any_of(must.begin(), must.end(), [&](const QPointF& p) { return corners[static_cast<std::size_t>(corner)].contains(p); });
  };
  if (now >= 0 && !covers_must(now)) return now;
  int best = std::max(now, 0);
  for (int corner = 0; corner < 3; ++corner)
    if (covered(corner) < covered(best)) best = corner;
  return best;
}

}  // namespace swage::console
