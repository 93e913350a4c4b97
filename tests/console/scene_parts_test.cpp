// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/scene_parts.hpp"

#include <gtest/gtest.h>
#include <swage/abi/lesson.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "console/view3d/scene_state.hpp"
#include "console/view3d/tool_tips.hpp"
#include "console/view3d/view_point.hpp"

namespace swage::console {
namespace scene_parts_test {

snapshot::CardShape block(uint32_t body, uint32_t object, swage_vec3 low, swage_vec3 high) {
  snapshot::CardShape s;
  s.kind = SWAGE_SHAPE_CONVEX;
  s.flags = SWAGE_SHAPE_USUAL;
  s.body = body;
  s.object = object;
  s.X_BS.q = {1, 0, 0, 0};
  for (int i = 0; i < 8; ++i) {
    s.vertex.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  }
  s.face = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return s;
}

// a tray of 20 x 10 mm with its floor at z = 0, a block on it, a needle above, jaws beside
snapshot::SceneCard scene() {
  snapshot::SceneCard card;
  card.objects = {{"tray", "x", "1", {SWAGE_TRAIT_SOLID, SWAGE_TRAIT_GRASPABLE}, 0, 1, 0, 0},
                  {"pad", "x", "1", {SWAGE_TRAIT_SOLID}, 1, 1, 0, 0},
                  {"needle", "x", "1", {SWAGE_TRAIT_GRASPABLE}, 2, 1, 0, 0},
                  {"holder", "x", "1", {SWAGE_TRAIT_GRIPPER}, 3, 1, 0, 0},
                  {"ball", "x", "1", {SWAGE_TRAIT_GRASPABLE}, 4, 1, 0, 0}};
  card.shapes = {block(0, 0, {-10e-3, -5e-3, -1e-3}, {10e-3, 5e-3, 0}),
                 block(0, 0, {9e-3, -5e-3, 0}, {10e-3, 5e-3, 1e-3}),  // a wall
                 block(1, 1, {-1e-3, -1e-3, 0}, {1e-3, 1e-3, 1e-3}),
                 block(3, 3, {0, -1e-3, 0}, {40e-3, 1e-3, 1e-3})};
  snapshot::CardShape arc;
  arc.kind = SWAGE_SHAPE_ARC;
  arc.flags = SWAGE_SHAPE_USUAL;
  arc.body = 2;
  arc.object = 2;
  arc.X_BS.q = {1, 0, 0, 0};
  arc.radius = 0.05e-3;
  arc.arc_radius = 2e-3;
  arc.sweep = 2;
  card.shapes.push_back(arc);
  snapshot::CardShape ball;
  ball.kind = SWAGE_SHAPE_SPHERE;
  ball.flags = SWAGE_SHAPE_USUAL;
  ball.body = 4;
  ball.object = 4;
  ball.X_BS.q = {1, 0, 0, 0};
  ball.radius = 0.5e-3;
  card.shapes.push_back(ball);
  const swage_quat one{1, 0, 0, 0};
  card.start = {{{0, 0, 0}, one}, {{0, 0, 0}, one}, {{0, 0, 2e-3}, one}, {{6e-3, 0, 2e-3}, one}, {{-8e-3, 0, 0.5e-3}, one}};
  card.motion = {SWAGE_MOTION_FIXED, SWAGE_MOTION_FIXED, SWAGE_MOTION_DYNAMIC, SWAGE_MOTION_FOLLOWS,
                 SWAGE_MOTION_DYNAMIC};
  judge::Script::Mark region;
  region.mark = {};
  region.mark.kind = SWAGE_MARK_ARC_RANGE;
  region.mark.object = 2;
  region.mark.number[1] = 0.5;
  region.meaning = "region.target";
  card.script.marks = {region};
  return card;
}

TEST(SceneParts, RolesFollowTraitsAndMotion) {
  snapshot::SceneCard card = scene();
  EXPECT_EQ(role_of(card, 0), Role::kStage) << "graspable, but it never moves";
  EXPECT_EQ(role_of(card, 2), Role::kWork);
  EXPECT_EQ(role_of(card, 3), Role::kTool);
  EXPECT_EQ(role_of(card, 99), Role::kOther);
  card.objects[3].traits.clear();
  EXPECT_EQ(role_of(card, 3), Role::kTool) << "it follows a device";
}

TEST(SceneParts, OneMeshPerBodyAndOneSleevePerMark) {
  const SceneParts parts = make_parts(scene());
  ASSERT_EQ(parts.part.size(), 7U);
  EXPECT_EQ(parts.part[0].mesh.index.size(), 2 * 36U);  // both blocks of the tray
  EXPECT_EQ(parts.part[5].role, Role::kMark);
  EXPECT_FALSE(parts.part[5].collar);
  // a collar at the end of the region; its start is the needle's point, where there is none
  EXPECT_TRUE(parts.part.back().collar);
  EXPECT_DOUBLE_EQ(parts.part.back().from, 0.5);
  EXPECT_NEAR(parts.part.back().to, 0.5 + 0.1e-3 / 4e-3, 1e-9);
  EXPECT_EQ(parts.part.back().body, 2U);
  // hidden shapes are not drawn
  snapshot::SceneCard card = scene();
  for (auto& s : card.shapes) s.flags = SWAGE_SHAPE_COLLIDES;
  EXPECT_EQ(make_parts(card).part.size(), 2U);  // the mark and its collar
}

TEST(SceneParts, TheHandBringsItsTipsToTheMarkedRegion) {
  const SceneParts parts = make_parts(scene());
  ASSERT_EQ(parts.tips.size(), 1U);
  EXPECT_EQ(parts.tips[0].body, 3U);
  EXPECT_NEAR(parts.tips[0].p_B.x(), 0, 1e-4F) << "the end that is near the work, of 40 mm";
  ASSERT_EQ(parts.aim.size(), 1U);
  EXPECT_EQ(parts.aim[0].body, 2U);
  // somewhere on the first half of an arc of 2 mm and 2 rad
  EXPECT_NEAR(parts.aim[0].p_B.length(), 2, 0.06F);
  const float angle = std::atan2(parts.aim[0].p_B.y(), parts.aim[0].p_B.x());
  EXPECT_NEAR(angle, 0.5F, 0.3F);
  // a handle far behind the jaws is no tip
  snapshot::SceneCard card = scene();
  card.objects[3].n_body = 2;
  card.shapes.push_back(block(5, 3, {80e-3, -1e-3, 0}, {90e-3, 1e-3, 1e-3}));
  card.start.push_back(card.start[3]);
  card.motion.push_back(SWAGE_MOTION_FOLLOWS);
  EXPECT_EQ(make_parts(card).tips.size(), 1U);
  // without a mark the object itself is the target
  card = scene();
  card.script.marks.clear();
  card.objects.pop_back();
  card.shapes.pop_back();
  ASSERT_EQ(make_parts(card).aim.size(), 1U);
  EXPECT_EQ(make_parts(card).aim[0].body, 2U);
}

TEST(SceneParts, GroundIsTheLargestLevelFaceBelowTheWork) {
  const SceneParts parts = make_parts(scene());
  EXPECT_TRUE(parts.ground.on_stage);
  EXPECT_NEAR(parts.ground.z, 0, 1e-4);
  EXPECT_NEAR(parts.ground.half_x, 10, 1e-3);
  EXPECT_NEAR(parts.ground.half_y, 5, 1e-3);
  EXPECT_EQ(parts.part[parts.ground.part].object, 0U);
  // without a stage: right below the work
  snapshot::SceneCard card = scene();
  card.shapes.erase(card.shapes.begin(), card.shapes.begin() + 3);
  EXPECT_FALSE(make_parts(card).ground.on_stage);
  EXPECT_NEAR(make_parts(card).ground.z, 1.95, 0.01);
}

TEST(SceneParts, TheGridStaysOnATrayInWhoseFloorAnotherThingBegins) {
  snapshot::SceneCard card = scene();
  card.script.marks.clear();    // all that can be grasped is the work
  card.start[4].p = {0, 0, 0};  // the ball, half in the floor
  const SceneParts parts = make_parts(card);
  ASSERT_TRUE(parts.ground.on_stage);
  EXPECT_EQ(parts.part[parts.ground.part].object, 0U);
  EXPECT_NEAR(parts.ground.half_x, 10, 1e-3);
}

TEST(SceneParts, ShadowsFallOnTissueToo) {
  EXPECT_FALSE(make_parts(scene()).shelf.on_stage);
  snapshot::SceneCard card = scene();
  card.objects[1].traits = {SWAGE_TRAIT_SOLID, "swage.trait.pierceable/1"};
  const SceneParts parts = make_parts(card);
  ASSERT_TRUE(parts.shelf.on_stage);
  EXPECT_TRUE(parts.part[parts.shelf.part].soft);
  EXPECT_NEAR(parts.shelf.z, 1, 1e-4);
  EXPECT_NEAR(parts.shelf.half_x, 1, 1e-3);
  EXPECT_NEAR(parts.ground.z, 0, 1e-4) << "what stands on the tray still throws its shadow there";
  // tissue without a stage lies above the plane that replaces the stage
  card.shapes.erase(card.shapes.begin(), card.shapes.begin() + 2);
  EXPECT_FALSE(make_parts(card).ground.on_stage);
  EXPECT_NEAR(make_parts(card).ground.z, 0, 1e-4);
}

TEST(SceneParts, TheMarkedThingIsFramedAndWatched) {
  const SceneParts parts = make_parts(scene());
  EXPECT_EQ(parts.watched, 2);
  EXPECT_LT((parts.work.centre() - QVector3D(0.6F, 1, 2)).length(), 0.6F);
  // the first view extends towards the tool, whose nearest point is at 6 mm, but only so far that the work stays large
  EXPECT_GT(parts.focus.high.x(), 1.3F * parts.work.high.x());
  EXPECT_LT(parts.focus.high.x(), 6);
  // a helper's tool on the other side is included, too
  snapshot::SceneCard helped = scene();
  helped.objects.push_back({"helper", "x", "1", {SWAGE_TRAIT_GRIPPER}, 5, 1, 0, 0});
  helped.shapes.push_back(block(5, 5, {-40e-3, -1e-3, 0}, {-6e-3, 1e-3, 1e-3}));
  helped.start.push_back({{0, 0, 2e-3}, {1, 0, 0, 0}});
  helped.motion.push_back(SWAGE_MOTION_FOLLOWS);
  EXPECT_LT(make_parts(helped).focus.low.x(), parts.focus.low.x() - 1);
  // tissue is included, with its mark anywhere, however high its slope rises; but not all of an infinite wall
  snapshot::SceneCard sloping = scene();
  sloping.objects[1].traits = {SWAGE_TRAIT_SOLID, "swage.trait.pierceable/1"};
  sloping.shapes[2] = block(1, 1, {-1e-3, -1e-3, 0}, {1e-3, 1e-3, 4.2e-3});
  EXPECT_NEAR(make_parts(sloping).focus.high.z(), 4.2, 1e-3);
  sloping.shapes[2] = block(1, 1, {-1e-3, -1e-3, 0}, {1e-3, 1e-3, 0.1});
  EXPECT_LT(make_parts(sloping).focus.high.z(), 7);
  // without a mark both graspable objects are framed, and none is followed
  snapshot::SceneCard card = scene();
  card.script.marks.clear();
  EXPECT_EQ(make_parts(card).watched, -1);
  EXPECT_LT(make_parts(card).work.low.x(), -8);
}

snapshot::CardShape thread_of(uint32_t body, uint32_t object, double length) {
  snapshot::CardShape s;
  s.kind = SWAGE_SHAPE_CHAIN;
  s.flags = SWAGE_SHAPE_USUAL;
  s.body = body;
  s.object = object;
  s.X_BS.q = {1, 0, 0, 0};
  s.radius = 11e-6;
  for (int i = 0; i <= 10; ++i) s.vertex.push_back({0, 0.1 * i * length, 0});
  return s;
}

TEST(SceneParts, AThreadThatTrailsBehindTheNeedleDoesNotMakeThePictureSmall) {
  snapshot::SceneCard card = scene();
  card.script.marks.clear();
  card.objects.pop_back(), card.shapes.pop_back();
  const SceneParts before = make_parts(card);
  card.objects.push_back({"suture", "x", "1", {SWAGE_TRAIT_GRASPABLE}, 4, 1, 0, 0});
  card.shapes.push_back(thread_of(4, 4, 30e-3));
  const SceneParts parts = make_parts(card);
  ASSERT_EQ(parts.threads.size(), 1U);
  EXPECT_NEAR(parts.focus.radius(), before.focus.radius(), 1e-4F);
  EXPECT_EQ(parts.watched, 2) << "the needle";
  // a thread alone is the work
  card.objects[2].traits = {SWAGE_TRAIT_SOLID};
  EXPECT_NEAR(make_parts(card).work.high.y() - make_parts(card).work.low.y(), 30, 0.1F);
}

// while the thread is drawn through, the wound is seen, to which the mark on the thread is to come
TEST(SceneParts, WhileANeedleWithAThreadIsHeldTheWoundIsSeenBesideIt) {
  snapshot::SceneCard card = scene();
  card.objects.pop_back(), card.shapes.pop_back();
  card.objects.push_back({"suture", "x", "1", {SWAGE_TRAIT_GRASPABLE}, 4, 1, 0, 0});
  card.shapes.push_back(thread_of(4, 4, 30e-3));
  judge::Script::Mark entry;
  entry.mark = {};
  entry.mark.kind = SWAGE_MARK_POINT;
  entry.meaning = "target.point";
  card.script.marks = {entry};
  card.script.signals = {{"grasp", "grasp.held", "1", ""}};
  SceneState state;
  state.set_card(card);
  const auto now = std::make_unique<snapshot::Snapshot>();
  now->step = 1;
  now->n_body = static_cast<uint32_t>(card.start.size());
  std::copy(card.start.begin(), card.start.end(), now->X_WB);
  now->n_mark = now->n_signal = 1;
  now->mark_p_W[0] = {15e-3, 0, 1e-3};
  state.take(*now, false);
  const QVector3D tips = state.middle_of_tips();
  EXPECT_EQ(state.beside_watched(), tips) << "nothing is held";
  now->signal[0] = 1;
  now->step = 2;
  state.take(*now, false);
  EXPECT_EQ(state.beside_watched(), QVector3D(15, 0, 1));
  now->X_WB[3].p.x += 20e-3, now->step = 3;
  state.take(*now, false);
  EXPECT_EQ(state.beside_watched(), state.middle_of_tips()) << "another instrument holds it: these tips are away";
}

// The view near looks at the stitch that is to be tied: where the thread lies in the tissue, and not at the middle of a long thread.
TEST(SceneParts, AKnotIsTiedWhereTheThreadLiesInTheTissue) {
  snapshot::SceneCard card = scene();
  card.objects.pop_back(), card.shapes.pop_back();
  card.objects[1].traits.push_back(SWAGE_TRAIT_PIERCEABLE);  // from -1 to 1 mm, 1 mm high
  card.objects[2].traits = {SWAGE_TRAIT_SOLID};
  card.script.marks.clear();
  card.objects.push_back({"suture", "x", "1", {SWAGE_TRAIT_GRASPABLE}, 4, 1, 0, 0});
  snapshot::CardShape thread = thread_of(4, 4, 30e-3);
  thread.vertex = {{0.6e-3, 0.2e-3, 20e-3}, {0.6e-3, 0.2e-3, 0.9e-3}, {0.5e-3, 0.2e-3, 0.5e-3}, {0, 0.2e-3, 0.5e-3}, {-0.2e-3, 0.2e-3, 0.9e-3}, {-0.2e-3, 0.2e-3, 5e-3}};
  card.shapes.push_back(thread);
  card.start[4] = {{0, 0, 0}, {1, 0, 0, 0}};
  SceneState state;
  state.set_card(card);
  ASSERT_TRUE(state.subject().has_value());
  EXPECT_LT((*state.subject() - QVector3D(0.2F, 0.2F, 1)).length(), 1e-4F);
  ViewPoint point(state);
  point.look(CameraPreset::kNear);
  point.camera.jump();
  EXPECT_LT((point.camera.focus() - QVector3D(0.2F, 0.2F, 1)).length(), 1e-4F);
  EXPECT_TRUE(state.ties());
  EXPECT_TRUE(state.tied_at(1) == state.subject() && !state.tied_at(2)) << "the tissue's cue stands there";
  const float with_hands_mm = point.camera.distance();
  point.look_close(), point.camera.jump();
  EXPECT_LT(point.camera.distance(), 0.5F * with_hands_mm) << "the wound alone";
  card.objects[1].traits.pop_back();
  state.set_card(card);
  EXPECT_FALSE(state.ties());
  EXPECT_FALSE(state.subject().has_value()) << "no tissue, and no mark";
}

// Where the knot is there from the start, as in the test that pulls it, and no point is marked.
TEST(SceneParts, AKnotThatIsThereIsLookedAt) {
  snapshot::SceneCard card = scene();
  card.objects.pop_back(), card.shapes.pop_back();
  card.objects[2].traits = {SWAGE_TRAIT_SOLID};
  card.script.marks.clear();
  card.objects.push_back({"suture", "x", "1", {SWAGE_TRAIT_GRASPABLE}, 4, 1, 0, 0});
  snapshot::CardShape thread = thread_of(4, 41, 40e-3);
  card.start[4] = {{0, 0, 0}, {1, 0, 0, 0}};
  // out and back by the same place at (10, 0, 5) mm, in a loop of 12 mm
  thread.vertex.clear();
  for (int i = 0; i <= 10; ++i) thread.vertex.push_back({1e-3 * i, 0, 5e-3});
  for (int i = 1; i < 12; ++i) thread.vertex.push_back({(10 + 2 * std::sin(i * std::numbers::pi / 6)) * 1e-3, 2e-3 * (1 - std::cos(i * std::numbers::pi / 6)), 5e-3});
  for (int i = 0; i <= 10; ++i) thread.vertex.push_back({10e-3, -1e-3 * i, 5e-3});
  card.shapes.push_back(thread);
  SceneState state;
  state.set_card(card);
  EXPECT_FALSE(state.ties());
  EXPECT_TRUE(state.has_knot());
  ASSERT_TRUE(state.subject().has_value());
  EXPECT_LT((*state.subject() - QVector3D(10, 0, 5)).length(), 0.7F);
  card.shapes.back().vertex = {{0, 0, 5e-3}, {10e-3, 0, 5e-3}, {20e-3, 0, 5e-3}};
  state.set_card(card);
  EXPECT_FALSE(state.has_knot()) << "a straight thread";
}

// marks belong to what a picture shows, which on a slow machine is some snapshots old
TEST(SceneParts, AnEarlierMomentIsSeenOnlyWhileItsPictureIsPainted) {
  SceneState state;
  state.set_card(scene());
  EXPECT_EQ(state.moment(), nullptr);
  const auto now = std::make_unique<snapshot::Snapshot>();
  now->step = 1;
  now->n_body = 5;
  std::copy(state.card().start.begin(), state.card().start.end(), now->X_WB);
  state.take(*now, false);
  const auto drawn = state.moment();
  const QVector3D then = state.middle_of_tips();
  now->X_WB[3].p.x += 2e-3, now->step = 2;
  state.take(*now, false);
  const QVector3D newest = state.middle_of_tips();
  ASSERT_NE(newest, then);
  {
    const SceneState::At shown(state, drawn);
    EXPECT_EQ(state.middle_of_tips(), then);
  }
  EXPECT_EQ(state.middle_of_tips(), newest);
  {
    const SceneState::At shown(state, nullptr);
    EXPECT_EQ(state.middle_of_tips(), newest) << "there is no picture yet";
  }
  EXPECT_EQ(state.now().step, 2U);
}

// of a thread between two instruments the middle of their grasps is in the air
TEST(ThreadLines, TheNearestPointIsOnTheThread) {
  const std::vector<double> line = {0, 0, 0, 1e-3, 0, 0, 1e-3, 2e-3, 0};
  const auto expect = [&](const Vec& from, const Vec& to) { EXPECT_LT(norm(nearest_on(line, from) - to), 1e-12) << from.x << ' ' << from.y; };
  expect({0.5e-3, 0.3e-3, 1e-3}, {0.5e-3, 0, 0});
  expect({0.8e-3, 1.5e-3, 0}, {1e-3, 1.5e-3, 0});
  expect({-1e-3, -1e-3, 0}, {0, 0, 0});
  expect({2e-3, 5e-3, 0}, {1e-3, 2e-3, 0});
  EXPECT_LT(norm(nearest_on({}, {1, 2, 3}) - Vec(1, 2, 3)), 1e-12) << "without a line the place itself";
}

TEST(SceneParts, ACourseIsShownWhole) {
  snapshot::SceneCard card = scene();
  card.script.marks.clear();
  const float near = make_parts(card).focus.radius();
  snapshot::CardShape wire = card.shapes[4];
  wire.arc_radius = 7e-3, wire.body = wire.object = 1;
  card.shapes.push_back(wire);
  const SceneParts parts = make_parts(card);
  EXPECT_GT(parts.focus.radius(), near);
  EXPECT_NEAR(parts.focus.high.x(), 7.05, 0.1F) << "its far end";
  EXPECT_LT(parts.focus.high.x(), 9) << "but not the tray";
}

// The thesis: the body of an instrument hides the work from the eye.
TEST(SceneParts, OfInstrumentsOnlyTheTipsAreDrawnWhereTheLessonSaysSo) {
  snapshot::SceneCard card = scene();
  const auto holder = [&] {
    const SceneParts parts = make_parts(card);
    const auto found = std::find_if(parts.part.begin(), parts.part.end(), [](const ScenePart& p) { return p.role == Role::kTool; });
    EXPECT_NE(found, parts.part.end());
    return found->mesh;
  };
  const auto bounds = [](const Mesh& mesh) {
    Bounds b;
    for (const Vertex& v : mesh.vertex) b.add({v.p[0], v.p[1], v.p[2]});
    return b;
  };
  EXPECT_NEAR(bounds(holder()).high.x(), 40, 1e-3);
  card.tips_only = true;
  const Mesh tips = holder();
  EXPECT_NEAR(bounds(tips).low.x(), 0, 1e-3);
  EXPECT_NEAR(bounds(tips).high.x(), kTips_mm, 0.6) << "square to the way from the tip at an edge to the middle";
  EXPECT_GT(bounds(tips).high.x(), 5);
  // the mesh is closed at the cut
  float area = 0;
  for (size_t i = 0; i + 2 < tips.index.size(); i += 3) {
    QVector3D p[3];
    for (size_t k = 0; k < 3; ++k) p[k] = {tips.vertex[tips.index[i + k]].p[0], tips.vertex[tips.index[i + k]].p[1], tips.vertex[tips.index[i + k]].p[2]};
    const QVector3D n = QVector3D::crossProduct(p[1] - p[0], p[2] - p[0]);
    if (n.x() > 0.9F * n.length() && p[0].x() > 5) area += 0.5F * n.length();
  }
  EXPECT_NEAR(area, 2 * 1, 0.1) << "mm2 of the section, seen from behind";
}

}  // namespace scene_parts_test
}  // namespace swage::console
