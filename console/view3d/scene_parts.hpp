// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The drawable parts of a scene card: triangles, body and role of each. Free of Qt3D.
#pragma once

#include <QQuaternion>
#include <QVector3D>
#include <map>
#include <optional>
#include <vector>

#include "console/view3d/mesh.hpp"
#include "console/view3d/thread_line.hpp"
#include "console/view3d/wire_chain.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

/// Tool: moved by the hand. Work: grasped or treated. Stage: fixed. Mark: shown by the lesson.
enum class Role { kTool, kWork, kStage, kOther, kMark };

/// Triangles that move as one body.
struct ScenePart {
  Role role = Role::kOther;
  uint32_t body = 0;        // body whose pose moves the part
  uint32_t object = 0;      // object whose cue colours the part
  uint32_t mark = 0;        // kMark: index of the mark
  bool wire = false;        // contains a bent wire: drawn as steel
  bool soft = false;        // tissue: shows dents and wounds
  Mesh mesh{};              // in the body's frame; of a chain in the world frame, in its start pose
  int chain = -1;           // >= 0: index into SceneParts::chains; rebuilt for each picture
  double from = 0, to = 1;  // range on the chain
  int thread = -1;          // >= 0: index into SceneParts::threads, likewise
  bool collar = false;      // kMark: one of the two bright ends of a region, visible on a wire of any colour

  /// Its mesh is in the world frame, not in its body's.
  bool in_world() const { return chain >= 0 || thread >= 0; }
};

/// A box along the axes, mm; radius() is that of its bounding sphere.
struct Bounds {
  QVector3D low{1e9F, 1e9F, 1e9F}, high{-1e9F, -1e9F, -1e9F};
  void add(const QVector3D& p);
  bool empty() const { return low.x() > high.x(); }
  QVector3D centre() const { return 0.5F * (low + high); }
  bool holds(const QVector3D& p) const;
  float radius() const { return empty() ? 0.F : 0.5F * (high - low).length(); }
};

/// The level of shadows and grid, mm: the top of the stage below the work, or a plane below everything.
struct Ground {
  float z = 0;
  bool on_stage = false;
  size_t part = 0;               // on a stage: the part that carries it, which casts no shadow on itself
  QVector3D centre;              // z = 0
  float half_x = 0, half_y = 0;  // on a stage: half its size
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
  Bounds work;   // the object that is worked on, at the start
  Bounds focus;  // the work, and the tool's point near it
  Ground ground;
  Ground shelf;  // level top of tissue; on_stage where there is one
  /// The single object that the view follows, if any: its body, and its middle in the body's frame, mm.
  int watched = -1;
  QVector3D watched_middle;
  QVector3D watched_on;  // a place on it near its middle, same frame
  std::vector<Spot> ends;  // the two places on it that are furthest apart
  /// The middle of the stitch in which a thread lies through tissue at the start, at the height of the tissue's top. World, mm.
  std::optional<QVector3D> stitch;
  /// The knot that a thread has at the start. World, mm.
  std::optional<QVector3D> knot;
  /// What the hand has to bring together: the tips of its tool; and the middle of the marked region, or of the watched object,
  /// or of each of several objects.
  std::vector<Spot> tips, aim;
  std::map<uint32_t, std::vector<Spot>> tips_of;  // of each tool, by its object; the trainee's tool comes first
};

SceneParts make_parts(const snapshot::SceneCard& card);

/// Triangles of a chain's part in these poses, world frame, mm.
Mesh chain_mesh(const SceneParts& parts, const ScenePart& part, std::span<const swage_pose> X_WB);

/// Triangles of a thread's part, whose vertices are at p_W [m]; drawn with a radius of at least `least` [m].
Mesh thread_mesh(const SceneParts& parts, const ScenePart& part, std::span<const double> p_W, double least);

/// Role of an object by its traits and by the motion type of its bodies.
Role role_of(const snapshot::SceneCard& card, uint32_t object);

QVector3D to_mm(const swage_vec3& p);
QQuaternion to_qt(const swage_quat& q);

}  // namespace swage::console
