// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/scene_meshes.hpp"

#include <algorithm>
#include <span>

namespace swage::console {
namespace {

constexpr double kLeastThread_px = 2.2;  // a 10-0 suture is one pixel wide in a picture of 15 mm: it would flicker
constexpr float kLift_mm = 0.004F;       // height of the grid above its stage, against flicker

// steel up to half the stress of first yield, orange at first yield, red at 1.5 times that stress
QColor stressed(const QColor& steel, double share) {
  const QColor yields(0xff, 0x8c, 0x1a), ruined(0xd4, 0x07, 0x06);
  const auto mix = [](const QColor& a, const QColor& b, double u) {
    const auto f = static_cast<float>(std::clamp(u, 0.0, 1.0));
    return QColor::fromRgbF(a.redF() + f * (b.redF() - a.redF()), a.greenF() + f * (b.greenF() - a.greenF()),
                            a.blueF() + f * (b.blueF() - a.blueF()));
  };
  return share <= 1 ? mix(steel, yields, 2 * share - 1) : mix(yields, ruined, 2 * share - 2);
}

// the top of the tissue: shadows only, which show the height of the needle point
Floor shelf_of(const Ground& level) {
  Floor floor;
  floor.shown = level.on_stage;
  floor.z = level.z + kLift_mm;
  floor.centre = level.centre;
  floor.half_x = level.half_x;
  floor.half_y = level.half_y;
  floor.radius = 4 * std::max(level.half_x, level.half_y);
  floor.reach = 2;
  return floor;
}

}  // namespace

void SceneMeshes::build(double mm_per_pixel) {
  renderer_.clear();
  const SceneParts& parts = scene_.parts();
  for (size_t i = 0; i < parts.part.size(); ++i) {
    const ScenePart& part = parts.part[i];
    const bool carries = parts.ground.on_stage && i == parts.ground.part;
    const bool casts = part.role != Role::kMark && !carries;
    const bool moves = casts && !part.soft && part.role != Role::kStage;
    renderer_.add_part(part.mesh, surface_of(part), {casts, moves});
  }
  soft_.add();
  colour();
  place(mm_per_pixel);
}

Surface SceneMeshes::surface_of(const ScenePart& part) const {
  const UiTheme& ui = shown_.ui;
  if (part.soft) return {ui["tissue"], 0, 60, Finish::kMoist};
  switch (part.role) {
    case Role::kTool:
      return {ui["tool"], 0.7F, 60, Finish::kBrushed};
    case Role::kStage:
      return {ui["stage"], 0, 12};
    case Role::kMark: {
      if (part.collar) return {Qt::white, 0, 30};
      const judge::Script::Mark& mark = scene_.card().script.marks[part.mark];
      return {shown_.cues.style(QString::fromStdString(mark.meaning)).colour, 0, 30};
    }
    case Role::kWork:
    case Role::kOther:
      break;
  }
  if (part.thread >= 0) return {ui["thread"], 0.1F, 60};
  return part.wire ? Surface{ui["steel"], 0.7F, 40} : Surface{ui["other"], 0, 20};
}

void SceneMeshes::colour() {
  const SceneParts& parts = scene_.parts();
  for (size_t i = 0; i < parts.part.size(); ++i) {
    const ScenePart& part = parts.part[i];
    Surface surface = surface_of(part);
    const QString cue = cue_of(scene_, shown_, part.object);
    if (part.role == Role::kWork && part.chain >= 0 && shown_.stress) surface.colour = stressed(surface.colour, scene_.stress());
    // a wound needs the tissue's own colour as background
    if (part.role != Role::kMark && !part.soft && !cue.isEmpty())
      surface = {shown_.cues.style(cue).colour, 0.25F, 40, surface.finish};
    renderer_.set_surface(static_cast<int>(i), surface);
  }
  soft_.colour(shown_.ui);
  lay_floor();
}

void SceneMeshes::lay_floor() {
  const SceneParts& parts = scene_.parts();
  const Ground& ground = parts.ground;
  const float size = std::max(parts.focus.radius(), 0.5F);
  Floor floor;
  floor.shown = scene_.have_card();
  floor.z = ground.z + (ground.on_stage ? kLift_mm : 0);
  floor.centre = ground.centre;
  floor.radius = 8 * size;
  floor.reach = size;
  if (ground.on_stage) {
    floor.half_x = ground.half_x;
    floor.half_y = ground.half_y;
    floor.radius = 4 * std::max(ground.half_x, ground.half_y);
    floor.fill = 0;
  }
  const MediumLook look = medium_look(scene_.card().medium, size);
  renderer_.set_medium(look);
  floor.colour = veiled(shown_.ui["floor"], look);
  floor.line = veiled(shown_.ui["floor_line"], look);
  renderer_.set_floor(floor);
  renderer_.set_shelf(shelf_of(parts.shelf));
}

void SceneMeshes::place(double mm_per_pixel) {
  const std::vector<ScenePart>& parts = scene_.parts().part;
  for (size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].thread >= 0) {
      place_thread(i, mm_per_pixel);
      continue;
    }
    if (parts[i].chain >= 0) {
      if (scene_.have_snapshot()) renderer_.set_mesh(static_cast<int>(i), chain_mesh(scene_.parts(), parts[i], scene_.X_WB()));
      continue;
    }
    const swage_pose& X = scene_.pose(parts[i].body);
    QMatrix4x4 m;
    m.translate(to_mm(X.p));
    m.rotate(to_qt(X.q));
    renderer_.set_pose(static_cast<int>(i), m);
  }
  if (scene_.have_snapshot()) soft_.place(scene_, mm_per_pixel);
}

void SceneMeshes::place_threads(double mm_per_pixel) {
  for (size_t i = 0; i < scene_.parts().part.size(); ++i)
    if (scene_.parts().part[i].thread >= 0) place_thread(i, mm_per_pixel);
}

// Draws the thread at its true thickness, or at the smallest visible one.
void SceneMeshes::place_thread(size_t part, double mm_per_pixel) {
  const ScenePart& of = scene_.parts().part[part];
  const ThreadLine& thread = scene_.parts().threads[static_cast<size_t>(of.thread)];
  const uint32_t last = thread.first + thread.vertices();
  const bool there = scene_.have_snapshot() && last <= scene_.now().n_particle;
  const std::span<const double> p_W =
      there ? std::span(scene_.now().particle_p_W + 3 * thread.first, thread.start.size()) : std::span(thread.start);
  renderer_.set_mesh(static_cast<int>(part), thread_mesh(scene_.parts(), of, p_W, 0.5 * kLeastThread_px * mm_per_pixel / kMmPerM));
}

}  // namespace swage::console
