// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The corner of a picture in which an inset covers least.
#pragma once

#include <QPointF>
#include <QRectF>
#include <array>
#include <vector>

namespace swage::console {

/// The index of the corner in which an inset covers least. `must` are places that it may cover only if there is no corner without
/// one (the tips, what they go for), `rather` are those that it had better leave free (whatever else can be taken). The present
/// corner `now` stays unless another covers less, so that an inset does not jump.
inline int least_covered(const std::array<QRectF, 3>& corners, int now, const std::vector<QPointF>& must,
                         const std::vector<QPointF>& rather) {
  const auto covered = [&](int corner) {
    std::size_t most = 0, some = 0;
    for (const QPointF& p : must) most += corners[static_cast<std::size_t>(corner)].contains(p);
    for (const QPointF& p : rather) some += corners[static_cast<std::size_t>(corner)].contains(p);
    return most * (rather.size() + 1) + some;
  };
  int best = now;
  for (int corner = 0; corner < 3; ++corner)
    if (covered(corner) < covered(best)) best = corner;
  return best;
}

}  // namespace swage::console
