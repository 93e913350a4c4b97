// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a scene card looks like: which triangles, on which body, in which role. Free of Qt3D.
#pragma once

#include <QQuaternion>
#include <QVector3D>
#include <map>
#include <vector>

#include "console/view3d/mesh.hpp"
#include "console/view3d/thread_line.hpp"
#include "console/view3d/wire_chain.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

/// Tool: what the hand moves. Work: what it takes. Stage: what stands still. Mark: shown by the lesson.
enum class Role { kTool, kWork, kStage, kOther, kMark };

/// Triangles that move together.
struct ScenePart {
  Role role = Role::kOther;
  uint32_t body = 0;        // its pose moves the part
  uint32_t object = 0;      // whose cue colours it
  uint32_t mark = 0;        // kMark: which
  bool wire = false;        // has a bent wire: steel
  bool soft = false;        // tissue: bears dents and wounds
  Mesh mesh{};              // in the body's frame; of a chain in the world, as it stands at the start
  int chain = -1;           // >= 0: of SceneParts::chains, made anew for each picture
  double from = 0, to = 1;  // which part of the chain
  int thread = -1;          // >= 0: of SceneParts::threads, likewise
  bool collar = false;      // kMark: one of the two bright ends of a region, seen on a wire of any colour

  /// Its mesh stands in the world, not in its body's frame.
  bool in_world() const { return chain >= 0 || thread >= 0; }
};

/// A sphere that holds something, mm.
struct Bounds {
  QVector3D low{1e9F, 1e9F, 1e9F}, high{-1e9F, -1e9F, -1e9F};
  void add(const QVector3D& p);
  bool empty() const { return low.x() > high.x(); }
  QVector3D centre() const { return 0.5F * (low + high); }
  float radius() const { return empty() ? 0.F : 0.5F * (high - low).length(); }
};

/// Where shadows fall and the grid lies, mm: the top of the stage below the work, or a plane under everything.
struct Ground {
  float z = 0;
  bool on_stage = false;
  size_t part = 0;               // on a stage: which part carries it; it casts no shadow on itself
  QVector3D centre;              // z = 0
  float half_x = 0, half_y = 0;  // on a stage: its size
};

/// A place on a body, mm, in the body's frame.
struct Spot {
  uint32_t body = 0;
  QVector3D p_B;
};

struct SceneParts {
  std::vector<ScenePart> part;
  std::vector<WireChain> chains;
  std::vector<ThreadLine> threads;
  Bounds work;   // what is worked on, at the start
  Bounds focus;  // that, and the point of the tool near it
  Ground ground;
  Ground shelf;  // level top of something soft, on_stage where there is one
  /// The one thing that is watched, when there is one: its body, and its middle in the body's frame, mm.
  int watched = -1;
  QVector3D watched_middle;
  QVector3D watched_on;  // a place on it near that, same frame
  std::vector<Spot> ends;  // its two places that are furthest apart
  /// What the hand has to bring together: the tips of its tool, and the middle of the marked region, or of what is watched,
  /// or of any of the things that there are.
  std::vector<Spot> tips, aim;
  std::map<uint32_t, std::vector<Spot>> tips_of;  // of each tool by its object; the tool of one's own comes first
};

SceneParts make_parts(const snapshot::SceneCard& card);

/// Triangles of a chain's part for these poses, world, mm.
Mesh chain_mesh(const SceneParts& parts, const ScenePart& part, std::span<const swage_pose> X_WB);

/// The same of a thread's part, whose vertices are at p_W [m]; nothing thinner than `least` [m].
Mesh thread_mesh(const SceneParts& parts, const ScenePart& part, std::span<const double> p_W, double least);

/// Role of an object by its traits and by how its bodies move.
Role role_of(const snapshot::SceneCard& card, uint32_t object);

QVector3D to_mm(const swage_vec3& p);
QQuaternion to_qt(const swage_quat& q);

}  // namespace swage::console
