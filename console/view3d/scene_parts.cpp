// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/scene_parts.hpp"

#include <swage/abi/lesson.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "console/view3d/region_look.hpp"
#include "console/view3d/scene_ground.hpp"
#include "console/view3d/tool_tips.hpp"

namespace swage::console {
namespace {

// radius of the first view, in radii of the work: places further away are pulled in to it
constexpr float kBeside = 1.8F;  // from the middle of the work
// length of a needle's point over the radius of its wire: 0.8 mm for a wire of 100 um diameter
constexpr double kTaper = 16;
// length of the collars at the ends of a region, m
constexpr double kCollar = 0.1e-3;
// vertices of a tool so many times further from the work than its foremost part belong to its handle, not to a tip
constexpr float kBehind = 1.6F;

bool has_trait(const snapshot::CardObject& object, const char* trait) {
  return std::any_of(object.traits.begin(), object.traits.end(),
                     [&](const std::string& t) { return t.find(trait) != std::string::npos; });
}

// Length of the drawn point of a needle, m: an object that pierces is pointed, though its shapes are not.
double taper_of(const snapshot::SceneCard& card, uint32_t object, double radius) {
  return object < card.objects.size() && has_trait(card.objects[object], "piercing") ? kTaper * radius : 0;
}

int chain_of(const SceneParts& parts, uint32_t object) {
  for (size_t i = 0; i < parts.chains.size(); ++i) {
    if (parts.chains[i].object == object) return static_cast<int>(i);
  }
  return -1;
}

void add_chain(const snapshot::SceneCard& card, int chain, const ScenePart& like, SceneParts& parts) {
  ScenePart part = like;
  part.chain = chain;
  part.wire = true;
  parts.chains[static_cast<size_t>(chain)].taper =
      taper_of(card, part.object, parts.chains[static_cast<size_t>(chain)].radius);
  part.mesh = chain_mesh(parts, part, card.start);
  parts.part.push_back(std::move(part));
}

// one part per body, as all shapes of a body move together; a wire of several bodies is one part
void add_bodies(const snapshot::SceneCard& card, SceneParts& parts) {
  std::vector<int> part_of_body(card.start.size(), -1);
  parts.chains = find_chains(card);
  for (int i = 0; i < static_cast<int>(parts.chains.size()); ++i) {
    const uint32_t object = parts.chains[static_cast<size_t>(i)].object;
    add_chain(card, i, {role_of(card, object), card.objects[object].first_body, object, 0, true}, parts);
  }
  parts.threads = find_threads(card);
  for (size_t i = 0; i < parts.threads.size(); ++i) {
    const ThreadLine& thread = parts.threads[i];
    ScenePart part{role_of(card, thread.object), thread.body, thread.object};
    part.thread = static_cast<int>(i);
    part.mesh = thread_mesh(parts, part, thread.start, 0);
    parts.part.push_back(std::move(part));
  }
  for (const snapshot::CardShape& shape : card.shapes) {
    if (shape.kind == SWAGE_SHAPE_CHAIN) continue;
    if (shape.kind == SWAGE_SHAPE_ARC && chain_of(parts, shape.object) >= 0) continue;
    if (!(shape.flags & SWAGE_SHAPE_DRAWN) || shape.body >= card.start.size()) continue;
    int& at = part_of_body[shape.body];
    if (at < 0) {
      at = static_cast<int>(parts.part.size());
      parts.part.push_back({role_of(card, shape.object), shape.body, shape.object});
      parts.part.back().soft =
          shape.object < card.objects.size() && has_trait(card.objects[shape.object], "pierceable");
    }
    parts.part[static_cast<size_t>(at)].wire |= shape.kind == SWAGE_SHAPE_ARC;
    append_shape(shape, parts.part[static_cast<size_t>(at)].mesh, taper_of(card, shape.object, shape.radius));
  }
}

// a stretch of a wire, on a chain or on a single shape
void add_stretch(const snapshot::SceneCard& card, const ScenePart& like, SceneParts& parts) {
  if (!(like.to > like.from)) return;
  if (const int chain = chain_of(parts, like.object); chain >= 0) return add_chain(card, chain, like, parts);
  for (size_t i = 0; i < parts.threads.size(); ++i) {
    if (parts.threads[i].object != like.object) continue;
    ScenePart part = like;
    part.body = parts.threads[i].body, part.thread = static_cast<int>(i);
    part.mesh = thread_mesh(parts, part, parts.threads[i].start, 0);
    parts.part.push_back(std::move(part));
    return;
  }
  for (const snapshot::CardShape& shape : card.shapes) {
    const bool wire = shape.kind == SWAGE_SHAPE_ARC || shape.kind == SWAGE_SHAPE_CAPSULE ||
                      shape.kind == SWAGE_SHAPE_CYLINDER;
    if (shape.object != like.object || !wire) continue;
    ScenePart part = like;
    part.body = shape.body;
    append_range(shape, like.from, like.to, like.collar ? kCollarGrow : kSleeve, part.mesh);
    parts.part.push_back(std::move(part));
    return;
  }
}

// length along a wire, m
double wire_length(const snapshot::SceneCard& card, uint32_t object) {
  double length = 0;
  for (const ThreadLine& thread : find_threads(card))
    if (thread.object == object) return thread.length();
  for (const snapshot::CardShape& s : card.shapes) {
    if (s.object == object) length += s.kind == SWAGE_SHAPE_ARC ? s.arc_radius * s.sweep : 2 * s.half_length;
  }
  return length;
}

// adds the regions that a lesson marks on a wire
void add_marks(const snapshot::SceneCard& card, SceneParts& parts) {
  for (uint32_t m = 0; m < card.script.marks.size(); ++m) {
    const swage_mark& mark = card.script.marks[m].mark;
    if (mark.kind != SWAGE_MARK_ARC_RANGE || mark.object >= card.objects.size()) continue;
    ScenePart part{Role::kMark, card.objects[mark.object].first_body, mark.object, m, true};
    part.from = mark.number[0];
    part.to = mark.number[1];
    add_stretch(card, part, parts);
    const double length = wire_length(card, mark.object), share = length > 0 ? kCollar / length : 0;
    part.collar = true;
    for (const auto& [from, to] :
         {std::pair{mark.number[0] - share, mark.number[0]}, {mark.number[1], mark.number[1] + share}}) {
      part.from = std::max(from, 0.0);
      part.to = std::min(to, 1.0);
      add_stretch(card, part, parts);
    }
  }
}

bool is_marked(const snapshot::SceneCard& card, uint32_t object) {
  return std::any_of(card.script.marks.begin(), card.script.marks.end(), [&](const judge::Script::Mark& m) {
    return m.mark.kind == SWAGE_MARK_ARC_RANGE && m.mark.object == object;
  });
}

// the vertex of a part nearest to `place`, both in the mesh's frame; returned in the body's frame
QVector3D nearest_vertex(const snapshot::SceneCard& card, const ScenePart& part, const QVector3D& place) {
  QVector3D best;
  float least = 1e30F;
  for (const Vertex& v : part.mesh.vertex) {
    const QVector3D p(v.p[0], v.p[1], v.p[2]);
    if ((p - place).lengthSquared() >= least) continue;
    least = (p - place).lengthSquared();
    best = p;
  }
  const swage_pose& X = card.start[part.body];
  return !part.in_world() ? best : to_qt(X.q).conjugated().rotatedVector(best - to_mm(X.p));
}

// The vertex of a part that is furthest from its middle, and the vertex furthest from that one.
std::vector<Spot> find_ends(const snapshot::SceneCard& card, const ScenePart& part, const QVector3D& middle) {
  const auto furthest = [&part](const QVector3D& from) {
    QVector3D best = from;
    for (const Vertex& v : part.mesh.vertex)
      if (const QVector3D p(v.p[0], v.p[1], v.p[2]); (p - from).lengthSquared() > (best - from).lengthSquared()) best = p;
    return best;
  };
  const QVector3D one = furthest(middle), other = furthest(one);
  return {{part.body, nearest_vertex(card, part, one)}, {part.body, nearest_vertex(card, part, other)}};
}

// chooses the marked object, or the only one that is worked on
void watch(const snapshot::SceneCard& card, SceneParts& parts) {
  int works = 0;
  for (const ScenePart& p : parts.part) {
    if (p.role != Role::kWork) continue;
    const bool marked = is_marked(card, p.object);
    if (!marked && only_follows(p, parts)) continue;
    if (++works > 1 && !marked) continue;
    Bounds own;
    for (const Vertex& v : p.mesh.vertex) own.add({v.p[0], v.p[1], v.p[2]});
    parts.watched = static_cast<int>(p.body);
    parts.watched_middle = own.centre();
    if (p.in_world()) {
      const swage_pose& X = card.start[p.body];
      parts.watched_middle = to_qt(X.q).conjugated().rotatedVector(own.centre() - to_mm(X.p));
    }
    parts.watched_on = nearest_vertex(card, p, own.centre());
    parts.ends = find_ends(card, p, own.centre());
    if (marked) return;
  }
  if (works == 1) return;
  parts.watched = -1;
  parts.ends.clear();
}

// the place of each jaw of a tool that is nearest to the work
std::vector<Spot> find_tips(const snapshot::SceneCard& card, const SceneParts& parts, uint32_t own) {
  const QVector3D c = parts.work.centre();
  std::vector<Spot> tips;
  std::vector<std::pair<float, Spot>> near;
  float least = 1e30F;
  for (const ScenePart& p : parts.part) {
    if (p.role != Role::kTool || p.object != own) continue;
    const swage_pose& X = card.start[p.body];
    const QVector3D c_B = to_qt(X.q).conjugated().rotatedVector(c - to_mm(X.p));
    const Spot spot{p.body, nearest_vertex(card, p, c_B)};
    near.push_back({(spot.p_B - c_B).length(), spot});
    least = std::min(least, near.back().first);
  }
  for (const auto& [distance, spot] : near) {
    if (distance <= kBehind * least) tips.push_back(spot);
  }
  return tips;
}

void find_aim(const snapshot::SceneCard& card, SceneParts& parts) {
  for (const ScenePart& p : parts.part) {
    if (p.role != Role::kMark || p.collar || p.mesh.vertex.empty()) continue;
    Bounds own;
    for (const Vertex& v : p.mesh.vertex) own.add({v.p[0], v.p[1], v.p[2]});
    parts.aim = {{p.body, nearest_vertex(card, p, own.centre())}};
    return;
  }
  if (parts.watched >= 0) {
    parts.aim = {{static_cast<uint32_t>(parts.watched), parts.watched_on}};
    return;
  }
  for (const ScenePart& p : parts.part) {
    if (p.role != Role::kWork || p.in_world()) continue;
    Bounds own;
    for (const Vertex& v : p.mesh.vertex) own.add({v.p[0], v.p[1], v.p[2]});
    parts.aim.push_back({p.body, own.centre()});
  }
}

// The vertices of a thread that lie in tissue at the start: there it is tied. Their middle in the level, as one side of a stitch may have more of
// them than the other.
std::optional<QVector3D> find_stitch(const snapshot::SceneCard& card, const SceneParts& parts) {
  Bounds soft, inside;
  for (const ScenePart& p : parts.part)
    if (p.soft) add_bounds(card, p, soft);
  if (soft.empty()) return {};
  for (const ThreadLine& thread : parts.threads)
    for (size_t i = 0; i + 2 < thread.start.size(); i += 3)
      if (const QVector3D p = to_mm({thread.start[i], thread.start[i + 1], thread.start[i + 2]}); soft.holds(p)) inside.add(p);
  if (inside.empty()) return {};
  const QVector3D c = inside.centre();
  return QVector3D(c.x(), c.y(), soft.high.z());
}

}  // namespace

void Bounds::add(const QVector3D& p) {
  low = QVector3D(std::min(low.x(), p.x()), std::min(low.y(), p.y()), std::min(low.z(), p.z()));
  high = QVector3D(std::max(high.x(), p.x()), std::max(high.y(), p.y()), std::max(high.z(), p.z()));
}

bool Bounds::holds(const QVector3D& p) const {
  return p.x() >= low.x() && p.x() <= high.x() && p.y() >= low.y() && p.y() <= high.y() && p.z() >= low.z() && p.z() <= high.z();
}

Role role_of(const snapshot::SceneCard& card, uint32_t object) {
  if (object >= card.objects.size()) return Role::kOther;
  const snapshot::CardObject& o = card.objects[object];
  if (has_trait(o, "gripper")) return Role::kTool;
  bool fixed = o.n_body > 0, followed = false;
  for (uint32_t b = o.first_body; b < o.first_body + o.n_body && b < card.motion.size(); ++b) {
    fixed &= card.motion[b] == SWAGE_MOTION_FIXED;
    followed |= card.motion[b] == SWAGE_MOTION_FOLLOWS;
  }
  if (fixed) return Role::kStage;
  if (followed) return Role::kTool;
  return has_trait(o, "graspable") ? Role::kWork : Role::kOther;
}

QVector3D to_mm(const swage_vec3& p) {
  return {static_cast<float>(p.x * kMmPerM), static_cast<float>(p.y * kMmPerM),
          static_cast<float>(p.z * kMmPerM)};
}

QQuaternion to_qt(const swage_quat& q) {
  return {static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
}

namespace {

/// Sphere of the first view: the work whole, of all other parts the places near it.
Bounds focus(const snapshot::SceneCard& card, const SceneParts& parts,
             const std::map<uint32_t, Bounds>& tools) {
  Bounds out = parts.work;
  const QVector3D c = parts.work.centre();
  // places further away are pulled in: a picture is wider than high and still shows them
  const float most = kBeside * std::max(parts.work.radius(), 0.3F);
  const auto add = [&](const QVector3D& p) {
    const float far = (p - c).length();
    out.add(far > most ? c + (p - c) * (most / far) : p);
  };
  // of a long tool only the place nearest to the work is included
  for (const auto& [object, b] : tools)
    add({std::clamp(c.x(), b.low.x(), b.high.x()), std::clamp(c.y(), b.low.y(), b.high.y()),
         std::clamp(c.z(), b.low.z(), b.high.z())});
  // tissue is included whole, as its mark may be anywhere
  Bounds soft;
  for (const ScenePart& p : parts.part) {
    if (p.soft) add_bounds(card, p, soft);
  }
  for (int i = 0; i < 8 && !soft.empty(); ++i)
    add({i & 1 ? soft.low.x() : soft.high.x(), i & 2 ? soft.low.y() : soft.high.y(),
         i & 4 ? soft.low.z() : soft.high.z()});
  // a fixed wire is a course to be followed: it is included whole, with the stage parts beside it
  const auto& all = parts.part;
  if (std::none_of(all.begin(), all.end(), [](const ScenePart& p) { return p.role == Role::kStage && p.wire; })) return out;
  for (size_t i = 0; i < all.size(); ++i)
    if (all[i].role == Role::kStage && !all[i].soft && !(parts.ground.on_stage && i == parts.ground.part)) add_bounds(card, all[i], out);
  return out;
}

}  // namespace

SceneParts make_parts(const snapshot::SceneCard& card) {
  SceneParts parts;
  add_bodies(card, parts);

  // the framed parts: the marked ones, else the work, else any
  Bounds marked, work, tools, rest;
  std::map<uint32_t, Bounds> tool;  // by object, as a helper's tool may stand beside the trainee's
  for (const ScenePart& p : parts.part) {
    if (p.role == Role::kWork && is_marked(card, p.object)) add_bounds(card, p, marked);
    const bool work_on = p.role == Role::kWork && !only_follows(p, parts);
    add_bounds(card, p, work_on ? work : p.role == Role::kTool ? tools : rest);
    if (p.role == Role::kTool) add_bounds(card, p, tool[p.object]);
  }
  for (const Bounds& b : {marked, work, rest, tools}) {
    if (parts.work.empty() && !b.empty()) parts.work = b;
  }
  if (parts.work.empty()) parts.work.add({0, 0, 0});
  parts.ground = find_ground(card, parts);
  parts.shelf = find_shelf(card, parts);
  watch(card, parts);

  parts.focus = focus(card, parts, tool);
  add_marks(card, parts);
  for (const ScenePart& p : parts.part)
    if (p.role == Role::kTool && !parts.tips_of.contains(p.object)) parts.tips_of[p.object] = find_tips(card, parts, p.object);
  if (!parts.tips_of.empty()) parts.tips = parts.tips_of.begin()->second;
  if (card.tips_only) keep_tips(card, parts);
  find_aim(card, parts);
  parts.stitch = find_stitch(card, parts);
  for (const ThreadLine& thread : parts.threads)
    if (!parts.knot) parts.knot = thread.crossing();
  return parts;
}

}  // namespace swage::console
