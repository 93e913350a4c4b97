// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/soft_meshes.hpp"

#include <algorithm>
#include <utility>

#include "console/view3d/visual_marks.hpp"

namespace swage::console {
namespace {

constexpr float kFlat_mm = 2e-4F;  // a shallower dent is not visible
constexpr uint32_t kApart = 1000;  // difference between the wound numbers of two couplings

/// Each primitive of one kind, on one object.
template <class F>
void each(const snapshot::Snapshot& s, uint32_t object, uint32_t kind, const F& take) {
  for (uint32_t i = 0; i < s.n_visual; ++i)
    if (s.visual[i].object == object && s.visual[i].visual.kind == kind) take(s.visual[i].visual, s.visual[i].coupling * kApart + s.visual[i].visual.group);
}

float mm(double metres) { return static_cast<float>(metres * kMmPerM); }

std::vector<Dent> dents_of(const snapshot::Snapshot& s, uint32_t object) {
  std::vector<Dent> out;
  each(s, object, SWAGE_VISUAL_DENT, [&](const swage_visual& v, uint32_t) {
    const Dent dent{to_mm(v.a), to_mm({v.b.x - v.a.x, v.b.y - v.a.y, v.b.z - v.a.z}), mm(v.radius)};
    if (dent.u.length() > kFlat_mm) out.push_back(dent);
  });
  return out;
}

constexpr int kMostSteps = 24;     // largest number of steps along a tear; the triangles towards its rim are a little coarser
QVector3D direction(const swage_vec3& n) {
  return {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
}

// The last tear of each wound is the present or last place of the needle, where the wound gapes.
std::vector<Tear> tears_of(const snapshot::Snapshot& s, uint32_t object) {
  std::vector<Tear> out;
  each(s, object, SWAGE_VISUAL_TEAR, [&](const swage_visual& v, uint32_t number) {
    out.push_back({to_mm(v.a), to_mm(v.b), direction(v.direction), mm(v.radius), number});
  });
  each(s, object, SWAGE_VISUAL_WOUND, [&](const swage_visual& v, uint32_t number) {
    const auto own = std::find_if(out.begin(), out.end(), [&](const Tear& t) { return t.wound == number; });
    if (own == out.end()) return;
    Tear needle = *own;
    needle.a = needle.b = to_mm(v.a);
    out.push_back(needle);
  });
  return out;
}

// The last entry and exit of a coupling that pierces, from signals of these names.
Punctures punctures_of(const SceneState& scene) {
  const std::vector<judge::Name>& names = scene.card().script.signals;
  const auto value = [&](const std::string& owner, const std::string& id) {
    const auto at = std::find_if(names.begin(), names.end(), [&](const judge::Name& n) { return n.owner == owner && n.id == id; });
    const auto i = static_cast<uint32_t>(at - names.begin());
    return at == names.end() || i >= scene.now().n_signal ? 0.0 : scene.now().signal[i];
  };
  Punctures out;
  for (const judge::Name& name : names) {
    const bool entry = name.id == "pierce.wound";
    if ((!entry && name.id != "pierce.exit_wound") || value(name.owner, name.id) <= 0) continue;
    const std::string at = entry ? "pierce.entry_" : "pierce.exit_";
    const QVector3D p = to_mm(swage_vec3{value(name.owner, at + "x"), value(name.owner, at + "y"), value(name.owner, at + "z")});
    (entry ? out.entries : out.exits).push_back(p);
  }
  return out;
}

// The places where the surface mesh is refined: its dents, and its wounds, which coarse triangles would cover.
std::vector<Dent> with_wounds(const std::vector<Dent>& dents, const std::vector<Tear>& tears) {
  std::vector<Dent> out = dents;
  for (const Tear& t : tears) {
    const int steps = std::min(kMostSteps, static_cast<int>((t.b - t.a).length() / (2 * t.radius)) + 1);
    for (int k = 0; k <= steps; ++k) {
      const QVector3D p = t.a + (t.b - t.a) * (static_cast<float>(k) / static_cast<float>(steps));
      out.push_back({at_rest(dents, p, t.normal), {}, t.radius});
    }
  }
  return out;
}

}  // namespace

void SoftMeshes::add() {
  for (int& part : part_) part = renderer_.add_part({}, {}, {});
  dented_.clear();
  wound_ = {};
  drawn_ = false;
}

// the red of anatomy, not a cue: the same in every theme
void SoftMeshes::colour(const UiTheme& ui) {
  renderer_.set_surface(part_[kLip], {ui["wound_lip"], 0, 60, Finish::kMoist});
  renderer_.set_surface(part_[kFlesh], {ui["wound_flesh"], 0, 70, Finish::kMoist});
  renderer_.set_surface(part_[kDepth], {ui["wound_depth"], 0, 30});
  renderer_.set_surface(part_[kInk], {ui["ink"], 0, 12});
}

void SoftMeshes::place(const SceneState& scene, double mm_per_pixel) {
  WoundMeshes wounds;
  wound_ = {};
  const std::vector<ScenePart>& parts = scene.parts().part;
  for (size_t i = 0; i < parts.size(); ++i) {
    const ScenePart& part = parts[i];
    if (!part.soft || part.body >= scene.now().n_body) continue;
    const swage_pose& X = scene.pose(part.body);
    QMatrix4x4 X_WB;
    X_WB.translate(to_mm(X.p));
    X_WB.rotate(to_qt(X.q));
    const std::vector<Dent> dents = dents_of(scene.now(), part.object);
    const std::vector<Tear> tears = tears_of(scene.now(), part.object);
    if (!dents.empty() || dented_.contains(static_cast<int>(i))) {
      Mesh mesh;
      displace(refined(part.mesh, X_WB, with_wounds(dents, tears)), X_WB, dents, mesh);
      renderer_.set_mesh(static_cast<int>(i), mesh);
      if (dents.empty())
        dented_.erase(static_cast<int>(i));
      else
        dented_.insert(static_cast<int>(i));
    }
    append_wounds(tears, dents, wounds);
    if (const WoundPlace place = greatest_wound(tears, dents, punctures_of(scene)); place.ratio > wound_.ratio) {
      wound_ = place;
      wound_.kind = kind_of_wound(wound_.puncture, punctures_of(scene));
      wounded_object_ = part.object;
    }
  }
  Mesh ink;
  Mesh* const by_tone[SWAGE_TONES] = {&ink, &wounds.flesh, &wounds.depth};
  const bool marked = append_marks(scene.now(), mm_per_pixel, by_tone);
  const bool there = marked || wound_.there();
  if (!std::exchange(drawn_, there) && !drawn_) return;
  renderer_.set_mesh(part_[kLip], wounds.lip);
  renderer_.set_mesh(part_[kFlesh], wounds.flesh);
  renderer_.set_mesh(part_[kDepth], wounds.depth);
  renderer_.set_mesh(part_[kInk], ink);
}

}  // namespace swage::console
