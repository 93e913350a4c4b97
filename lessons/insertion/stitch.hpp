// SPDX-License-Identifier: Apache-2.0
//
// Surgeons' measures of finished stitches: bite, symmetry, obliquity, even spacing (M42 to M45). Pure arithmetic on entries and
// exits; the edge is that of a slit, or the rim where it is nearer.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "toolkit/math.hpp"

namespace swage::lesson_insertion {

using toolkit::Vec3;

/// Hole where the point passed through a surface.
struct Hole {
  Vec3 p_W = Vec3::Zero();        // m
  Vec3 edge_W = Vec3::Zero();     // unit, along the surface towards the nearest edge; 0: unknown
  Vec3 normal_W = Vec3::UnitZ();  // unit, out of the tissue
  double edge = 0;                // m, distance of that edge
  double wall = 0;                // m, thickness of the tissue there; 0: unknown
};

/// The last stitch, and the places of all stitches. Doubles only.
struct StitchState {
  static constexpr size_t kMost = 8;
  double count = 0;                    // finished stitches
  double in = 0, out = 0;              // 0 or 1: the present stitch has its entry, its exit
  double bite_in = 0, bite_out = 0;    // m
  double entry[3] = {}, edge[3] = {};  // m, unit; W
  double oblique = -1;                 // rad; -1: unknown
  double most_oblique = 0;             // rad, of all stitches with an exit
  double least = 0, most = 0, sum = 0, bites = 0;  // m, of the bites of finished stitches, two each; their number
  double first[3] = {};                // m, middle of the first stitch
  double place[kMost] = {};            // m, middles of the stitches along the edge, from the first one
};

class Stitches {
 public:
  static void enter(StitchState& s, const Hole& hole) noexcept {
    s.in = 1;
    s.out = 0;
    s.bite_in = hole.edge;
    Eigen::Map<Vec3>(s.entry) = hole.p_W;
    Eigen::Map<Vec3>(s.edge) = hole.edge_W;
    s.oblique = -1;
  }
  /// Adds the exit of the present stitch. `least` [m]: a shorter stitch has no direction.
  static void exit(StitchState& s, const Hole& hole, double least) noexcept {
    if (s.in == 0) return;
    s.out = 1;
    s.bite_out = hole.edge;
    const Vec3 entry = Eigen::Map<const Vec3>(s.entry), edge = Eigen::Map<const Vec3>(s.edge);
    const Vec3 way = hole.p_W - entry;
    if (way.norm() > least && edge.norm() > 0)
      s.oblique = std::asin(std::min(1.0, std::abs(way.dot(hole.normal_W.cross(edge))) / way.norm()));
    s.most_oblique = std::max(s.most_oblique, s.oblique);
    const auto n = static_cast<size_t>(s.count);
    if (n >= StitchState::kMost) return;
    const Vec3 middle = entry + 0.5 * way;
    if (n == 0) Eigen::Map<Vec3>(s.first) = middle;
    s.place[n] = (middle - Eigen::Map<const Vec3>(s.first)).dot(hole.normal_W.cross(edge));
  }
  /// Finishes the present stitch.
  static void finish(StitchState& s) noexcept {
    s.count += 1;
    for (const double bite : {s.bite_in, s.bite_out}) {
      s.least = s.bites > 0 ? std::min(s.least, bite) : bite;
      s.most = std::max(s.most, bite);
      s.sum += bite, s.bites += 1;
    }
    s.in = s.out = 0;
  }

  /// abs(b1 - b2) / mean(b1, b2) of the last stitch (M43).
  static double asymmetry(const StitchState& s) noexcept {
    const double mean = 0.5 * (s.bite_in + s.bite_out);
    return mean > 0 ? std::abs(s.bite_in - s.bite_out) / mean : 0;
  }
  /// (greatest - least) / mean of all bites of finished stitches.
  static double unequal(const StitchState& s) noexcept { return s.sum > 0 ? (s.most - s.least) * s.bites / s.sum : 0; }
  /// Standard deviation over mean of the distances between neighbours (M45); -1 with fewer than three stitches.
  static double unevenness(const StitchState& s) noexcept {
    const size_t n = std::min(StitchState::kMost, static_cast<size_t>(s.count));
    if (n < 3) return -1;
    double place[StitchState::kMost], sum = 0, square = 0;
    std::copy_n(s.place, n, place);
    std::sort(place, place + n);
    for (size_t i = 1; i < n; ++i) sum += place[i] - place[i - 1];
    const double mean = sum / static_cast<double>(n - 1);
    for (size_t i = 1; i < n; ++i) square += std::pow(place[i] - place[i - 1] - mean, 2);
    return mean > 0 ? std::sqrt(square / static_cast<double>(n - 2)) / mean : 0;
  }
};

}  // namespace swage::lesson_insertion
