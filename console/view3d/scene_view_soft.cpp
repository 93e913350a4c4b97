// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What SceneView draws of soft things: their surface where it is dented, and the wounds in it.
#include <algorithm>

#include "console/view3d/scene_view.hpp"
#include "console/view3d/soft_surface.hpp"

namespace swage::console {
namespace {

constexpr float kRim_mm = 0.012F;   // of dark around a wound, so that it is seen on any tissue by any eye
constexpr float kLift_mm = 0.004F;  // wounds lie so far above the surface, so that they do not flicker
constexpr float kHole = 0.8F;       // of the wound's half width
constexpr int kHoleDark = 800;      // per cent of darkness
constexpr float kFlat_mm = 2e-4F;   // a shallower dent is not seen

std::vector<Dent> dents_of(const snapshot::Snapshot& s, uint32_t object) {
  std::vector<Dent> out;
  for (uint32_t i = 0; i < s.n_dent; ++i) {
    const swage_dent& d = s.dent[i].dent;
    const Dent dent{to_mm(d.p_W), to_mm(d.u_W), static_cast<float>(d.radius * kMmPerM)};
    if (s.dent[i].object == object && dent.u.length() > kFlat_mm) out.push_back(dent);
  }
  return out;
}

std::vector<Tear> tears_of(const snapshot::Snapshot& s, uint32_t object) {
  std::vector<Tear> out;
  for (uint32_t i = 0; i < s.n_tear; ++i) {
    const swage_tear& t = s.tear[i].tear;
    const swage_vec3& n = t.normal_W;
    if (s.tear[i].object == object)
      out.push_back({to_mm(t.a_W),
                     to_mm(t.b_W),
                     {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)},
                     static_cast<float>(t.radius * kMmPerM)});
  }
  return out;
}

// the mouth of the track: where the needle is, or was last
std::vector<Tear> holes_of(std::vector<Tear> tears) {
  for (Tear& t : tears) {
    t.a = t.b;
    t.radius *= kHole;
  }
  return tears;
}

}  // namespace

void SceneView::add_wounds() {
  wound_rim_ = renderer_->add_part({}, {}, {});
  wound_ = renderer_->add_part({}, {}, {});
  hole_ = renderer_->add_part({}, {}, {});
}

void SceneView::colour_wounds() {
  const QColor red = cues_.style(QStringLiteral("tissue.tear")).colour;
  renderer_->set_surface(wound_, {red, 0, 40, Finish::kMoist});
  renderer_->set_surface(wound_rim_, {red.darker(320), 0, 10});
  renderer_->set_surface(hole_, {red.darker(kHoleDark), 0, 10});
}

void SceneView::place_soft() {
  Mesh wound, rim, hole;
  bool wounded = false;
  for (size_t i = 0; i < parts_.part.size(); ++i) {
    const ScenePart& part = parts_.part[i];
    if (!part.soft || part.body >= snapshot_->n_body) continue;
    const swage_pose& X = snapshot_->X_WB[part.body];
    QMatrix4x4 X_WB;
    X_WB.translate(to_mm(X.p));
    X_WB.rotate(to_qt(X.q));
    const std::vector<Dent> dents = dents_of(*snapshot_, part.object);
    if (!dents.empty() || dented_.contains(static_cast<int>(i))) {
      Mesh mesh;
      displace(refined(part.mesh, X_WB, dents), X_WB, dents, mesh);
      renderer_->set_mesh(static_cast<int>(i), mesh);
      if (dents.empty())
        dented_.erase(static_cast<int>(i));
      else
        dented_.insert(static_cast<int>(i));
    }
    const std::vector<Tear> tears = tears_of(*snapshot_, part.object);
    wounded |= !tears.empty();
    append_tears(tears, dents, kRim_mm, kLift_mm, rim);
    append_tears(tears, dents, 0, 2 * kLift_mm, wound);
    append_tears(holes_of(tears), dents, 0, 3 * kLift_mm, hole);
  }
  if (!wounded && !wounded_) return;
  wounded_ = wounded;
  renderer_->set_mesh(wound_rim_, rim);
  renderer_->set_mesh(wound_, wound);
  renderer_->set_mesh(hole_, hole);
}

}  // namespace swage::console
