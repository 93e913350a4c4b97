// SPDX-License-Identifier: Apache-2.0
//
// What a pierce scene with a rigid needle and a flat tissue stores, and what its hand puts in. All from what the step tells: forces of
// contacts and ties, the tissue's memory.
//
//   stored = motion of the needle + contacts + ties + tissue
//     contact: k d^2 / 2 + k_2 d^3 / 3 for stiffness k + k_2 d, and its bristle k_t s^2 / 2
//     tie:     f_along^2 / (2 k_along) + f_across^2 / (2 k_across)
//     tissue:  a standard linear solid is a spring under a spring beside a damper: f'Cf / 2 + v'Cv / (2 (1/relaxed - 1))
//   a step dissipates work of the hand - change of what is stored, which must not be negative
//
// [main]
#pragma once

#include <algorithm>
#include <cstring>

#include "dynamics/contact_law.hpp"
#include "pierce_rig.hpp"
#include "plugins/tissue/tissue.hpp"

namespace swage::test {

class Ledger {
 public:
  /// `tissue`: what its parameters are; level plane: of no account but for the stiffening of what touches.
  Ledger(const PierceRig& scene, const tissue::TissueParams& tissue)
      : scene_(scene),
        params_(tissue),
        compliance_({tissue.young / 3, tissue.spread, tissue.skin, tissue.skin_young}) {
    holder_ = scene.rig->objects[0].body.first;
    before_ = stored();
    X_before_ = Pose(scene.engine->world().X_WB[holder_]);
  }

  /// After each step.
  void look() {
    const double now = stored(), work = work_of_hand();
    dissipated = work - (now - before_);
    put_in += work;
    lost += dissipated;
    worst = std::min(worst, dissipated);
    deepest = std::min(deepest, lost);
    most_stored = std::max(most_stored, now);
    before_ = now;
  }

  double dissipated = 0;        // J, in the last step
  double put_in = 0, lost = 0;  // J, so far
  double worst = 0;             // J, least dissipation of a step so far: negative when a step made energy
  double deepest = 0;           // J, the least that `lost` has been
  double most_stored = 0;       // J

  double stored() const { return scene_.needle_energy() + of_contacts() + of_ties() + of_tissue(); }
  double of_contacts() const {
    double sum = 0;
    for (const contact::Contact& c : scene_.engine->contacts().contact) {
      const double d = std::max(0.0, -c.gap), k = c.law.stiffness * c.weight;
      if (!(d > 0) || !(k > 0) || c.f_a_W.isZero(0)) continue;
      const double k2 = plane() ? params_.stiffening * c.weight : 0,
                   k1 = plane() ? params_.stiffness * c.weight : k;
      sum += d * d * (k1 / 2 + k2 * d / 3) + 0.5 * dynamics::kTangentRatio * k * c.bristle_W.squaredNorm();
    }
    return sum;
  }
  double of_ties() const {
    double sum = 0;
    for (const dynamics::Tie& tie : scene_.engine->ties()) {
      const double along = tie.axis_W.dot(tie.f_a_W);
      const double across = (tie.f_a_W - along * tie.axis_W).squaredNorm();
      if (tie.law.k_along > 0) sum += 0.5 * along * along / tie.law.k_along;
      if (tie.law.k_across > 0) sum += 0.5 * across / tie.law.k_across;
    }
    return sum;
  }
  double of_tissue() const {
    if (plane()) return 0;
    const auto sources = memory();
    const double kept = 1 / params_.relaxed - 1;
    const auto product = [&](const double* at_a, const double* a, const double* at_b, const double* b) {
      return vec(a).dot(compliance_.between(at_a[0] - at_b[0], at_a[1] - at_b[1]) * vec(b));
    };
    double sum = 0;
    for (const tissue::Source& a : sources)
      for (const tissue::Source& b : sources) {
        sum += 0.5 * product(a.q, a.f, b.q, b.f);
        if (kept > 0) sum += 0.5 / kept * product(a.p, a.v, b.p, b.v);
      }
    return sum;
  }

 private:
  static Vec3 vec(const double* a) { return {a[0], a[1], a[2]}; }
  bool plane() const { return params_.level == tissue::Level::kPlane; }
  std::vector<tissue::Source> memory() const {
    const scene::Range range = scene_.rig->objects[2].state;
    std::vector<tissue::Source> all(range.count * sizeof(double) / sizeof(tissue::Source));
    std::memcpy(all.data(), scene_.engine->world().plugin_state.data() + range.first,
                all.size() * sizeof(tissue::Source));
    std::erase_if(all, [](const tissue::Source& s) { return vec(s.f).isZero(0) && vec(s.v).isZero(0); });
    return all;
  }
  /// Ties of the leash pull at the holder, which goes where the path says.
  double work_of_hand() {
    const Pose X(scene_.engine->world().X_WB[holder_]);
    double work = 0;
    for (const dynamics::Tie& tie : scene_.engine->ties()) {
      if (tie.body_a != holder_) continue;
      const Vec3 p_H = X.inverse() * tie.p_W;
      work -= tie.f_a_W.dot(X * p_H - X_before_ * p_H);
    }
    X_before_ = X;
    return work;
  }

  const PierceRig& scene_;
  tissue::TissueParams params_;
  tissue::Compliance compliance_;
  uint32_t holder_;
  double before_;
  Pose X_before_;
};

}  // namespace swage::test
