// SPDX-License-Identifier: Apache-2.0
//
// Bending beyond yield: moment against curvature of a round section under repeated bending in any direction and torsion.
//
// Elastic, perfectly plastic layers in parallel (Besseling 1958, Iwan 1967), each with its share of the stiffness and its own
// limit, follow the closed form of the round section (wire_section.hpp): elastic core, growing hinge, and when bent back
// Masing's doubled curve with its early yielding. The moment is right to 0.35 %, and the residual curvature to 6.5 %, from 1.02
// to 1.689 of the moment of first yield, 99.5 % of the plastic moment. That curvature grows as 1.92 (c - 1)^(5/2) at first, c the
// curvature over that of first yield: the layers are closest there. Below 1.02 the sum over an arm counts, whose moment falls to nothing:
// what the arm keeps is right to 7 % where it bears 1.02 or more at its clamp. In normalised form: curvatures in yield curvatures, moments in yield
// moments, so that stiffness is 1; three components, whose lengths as vectors decide about yield (von Mises). Torsion shares
// the shape of the law, whose plateau is then 1.69 instead of 4/3 of first yield.
//
// Header-only, [rt].
#pragma once

#include <algorithm>

#include "toolkit/math.hpp"

namespace swage::toolkit {

/// Memory of one section, plain numbers that a host can keep.
struct WireMemory {
  static constexpr int kLayers = 15;
  double plastic[kLayers][3] = {};  // curvature at which each layer is free of load, in yield curvatures
  double path = 0;                  // path length of the plastic curvature, in yield curvatures
};

class WireLaw {
 public:
  static constexpr int kLayers = WireMemory::kLayers;

  WireLaw() = default;
  /// `hardening`: WireMaterial::hardening.
  explicit WireLaw(double hardening) : hardening_(hardening) {}

  /// Moment at curvature `e` for the present memory, without flow.
  Vec3 moment(const Vec3& e, const WireMemory& memory) const {
    if (memory.path == 0) return e;
    Vec3 m = Vec3::Zero();
    for (int i = 0; i < kLayers; ++i) m += kLayer[i].share * (e - at(memory, i));
    return (1 - hardening_) * m + hardening_ * e;
  }

  /// True when nothing has flowed so far, nor does at curvature `e`: the moment is e.
  bool elastic(const Vec3& e, const WireMemory& memory) const { return never_flows(e, memory); }

  /// Bends to curvature `e`: layers beyond their limit flow back to it. Returns the moment.
  Vec3 bend(const Vec3& e, WireMemory& memory) const {
    if (never_flows(e, memory)) return e;
    const Vec3 before = kept(memory);
    bool flows = false;
    for (int i = 0; i < kLayers; ++i) {
      const Vec3 s = e - at(memory, i);
      const double size = s.norm();
      if (size <= kLayer[i].limit) continue;
      const Vec3 p = e - kLayer[i].limit / size * s;
      for (int k = 0; k < 3; ++k) memory.plastic[i][k] = p[k];
      flows = true;
    }
    if (flows) memory.path += (kept(memory) - before).norm();
    return moment(e, memory);
  }

  /// Residual curvature after unloading, unless that makes layers flow back: e - m, as stiffness is 1.
  Vec3 relaxed(const WireMemory& memory) const {
    return memory.path == 0 ? Vec3(Vec3::Zero()) : kept(memory);
  }

  /// d(moment)/d(curvature) of a section at curvature `e` under continued bending, at least kLeastSlope; false: elastic, the
  /// identity.
  bool tangent(const Vec3& e, const WireMemory& memory, Mat3& D) const {
    bool flows = false;
    const double lost = 1 - std::max(hardening_, kLeastSlope);
    D.setIdentity();
    if (never_flows(e, memory)) return false;
    for (int i = 0; i < kLayers; ++i) {
      const Vec3 s = e - at(memory, i);
      if (s.squaredNorm() < kAtLimit * kLayer[i].limit * kLayer[i].limit) continue;
      flows = true;
      const Vec3 n = s.normalized();
      D -= lost * kLayer[i].share * n * n.transpose();
    }
    return flows;
  }

 private:
  struct Layer {
    double limit, share;  // yield curvatures; of the stiffness
  };
  // Found by search: the least of the greatest relative error of the residual curvature, both at the same moment (1.02 to 1.689
  // of first yield) and at the same curvature (to 20 of first yield), of 18 times the error of the moment, and of 0.7 times that of what arms of
  // 12, 24 and 40 pieces keep (bent_wire.hpp) that bear 1.02 to 1.6 at the clamp. The shares add up to 1, limit times share to
  // 16/(3 pi), the plastic moment. 12 layers leave 9 % of the curvature and 11 % of an arm's angle.
  static constexpr Layer kLayer[kLayers] = {
      {1.002356, 0.0029744}, {1.013356, 0.0060587}, {1.019312, 0.0089424}, {1.032289, 0.0176848}, {1.052941, 0.0351631},
      {1.088720, 0.0678488}, {1.152270, 0.1224408}, {1.269050, 0.1868062}, {1.478641, 0.2150818}, {1.839438, 0.1677849},
      {2.418573, 0.1006703}, {3.416557, 0.0465166}, {5.189500, 0.0165491}, {8.562779, 0.0044130}, {18.198427, 0.0010651}};
  // Least slope of the tangent. Without hardening a section beyond its last layer has none, and its flexibility no bound; a
  // larger floor makes a Newton step towards a moment near the plastic one fall short.
  static constexpr double kLeastSlope = 1e-3;
  // a layer that flowed is at its limit up to rounding
  static constexpr double kAtLimit = 1 - 1e-9;

  Vec3 kept(const WireMemory& memory) const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < kLayers; ++i) sum += kLayer[i].share * at(memory, i);
    return (1 - hardening_) * sum;
  }
  /// True when nothing has flowed so far, nor does at this curvature: stiffness 1.
  static bool never_flows(const Vec3& e, const WireMemory& memory) {
    return memory.path == 0 && e.squaredNorm() < kAtLimit * kLayer[0].limit * kLayer[0].limit;
  }
  static Vec3 at(const WireMemory& memory, int i) {
    return {memory.plastic[i][0], memory.plastic[i][1], memory.plastic[i][2]};
  }
  double hardening_ = 0.01;
};

}  // namespace swage::toolkit
