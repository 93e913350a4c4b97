// SPDX-License-Identifier: Apache-2.0
//
// What a pierce scene with a rigid needle and a flat tissue stores, and what its hand puts in. All from what the step tells: forces of
// contacts and ties, the tissue's memory.
//
//   stored = motion of the needle + contacts + ties + tissue
//     contact: level plane k d^2 / 2 + k_2 d^3 / 3 for stiffness k + k_2 d, else f_n^2 / 2 k; and its bristle k_t s^2 / 2
//     tie:     f_along^2 / (2 k_along) + f_across^2 / (2 k_across)
//     tissue:  a standard linear solid is a spring under a spring beside a damper: f'Cf / 2 + v'Cv / (2 (1/relaxed - 1))
//   a step dissipates work of the hand - change of what is stored, which must not be negative
//
// [main]
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

#include "dynamics/contact_law.hpp"
#include "pierce_rig.hpp"
#include "plugins/tissue/tissue.hpp"

namespace swage::test {

class Ledger {
 public:
  /// A tissue of the scene: its object, its parameters.
  struct Wall {
    uint32_t object = 2;
    tissue::TissueParams params;
    tissue::Compliance compliance;
    std::shared_ptr<const tissue::Mesh> mesh;  // level mesh

    Wall(uint32_t which, const tissue::TissueParams& p)
        : object(which), params(p), compliance({p.young / 3, p.spread, p.skin, p.skin_young}) {
      if (p.level == tissue::Level::kMesh)
        mesh = std::make_shared<const tissue::Mesh>(tissue::MeshSpec{p.size, p.thickness, p.slit, p.young,
                                                                     p.spread, p.skin, p.skin_young,
                                                                     p.underside, p.cells, p.refinement});
    }
    bool plane() const { return params.level == tissue::Level::kPlane; }
    /// Displacement of a by a force at b, places in O.
    toolkit::Mat3 between(const double* a, const double* b) const {
      if (mesh) return mesh->between(mesh->place(a[0], a[1]), mesh->place(b[0], b[1]));
      return compliance.between(a[0] - b[0], a[1] - b[1]);
    }
  };

  Ledger(const PierceRig& scene, std::vector<Wall> walls)
      : scene_(scene), walls_(std::move(walls)), holder_(scene.rig->objects[0].body.first) {
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

  double stored() const {
    double sum = scene_.needle_energy() + of_contacts() + of_ties();
    for (const Wall& wall : walls_) sum += of_wall(wall);
    return sum;
  }
  double of_contacts() const {
    double sum = 0;
    for (const contact::Contact& c : scene_.engine->contacts().contact) {
      const double k = c.law.stiffness * c.weight, f = c.n_W.dot(c.f_a_W), d = std::max(0.0, -c.gap);
      if (!(f > 0) || !(k > 0)) continue;
      const Wall* wall = wall_of(c.shape_b);
      sum += wall && wall->plane()
                 ? c.weight * d * d * (wall->params.stiffness / 2 + wall->params.stiffening * d / 3)
                 : 0.5 * f * f / k;
      sum += 0.5 * dynamics::kTangentRatio * k * c.bristle_W.squaredNorm();
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
  double of_wall(const Wall& wall) const {
    if (wall.plane()) return 0;
    const auto sources = memory(wall);
    const double kept = 1 / wall.params.relaxed - 1;
    const auto product = [&](const double* at_a, const double* a, const double* at_b, const double* b) {
      return vec(a).dot(wall.between(at_a, at_b) * vec(b));
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
  const Wall* wall_of(uint32_t shape) const {
    for (const Wall& wall : walls_) {
      const scene::Range range = scene_.rig->objects[wall.object].shape;
      if (shape >= range.first && shape < range.first + range.count) return &wall;
    }
    return nullptr;
  }
  std::vector<tissue::Source> memory(const Wall& wall) const {
    const scene::Range range = scene_.rig->objects[wall.object].state;
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
  std::vector<Wall> walls_;
  uint32_t holder_;
  double before_ = 0;
  Pose X_before_;
};

}  // namespace swage::test
