// SPDX-License-Identifier: Apache-2.0
//
// Where the small pictures in the corners are and when they move: as long as a hand moves the tips in one of them it stands still.
#include "console/view3d/panels.hpp"
#include "console/view3d/scene_state.hpp"
#include "console/view3d/view_point.hpp"
#include "window_fixture.hpp"

namespace swage::test {
namespace {

/// The fake session's scene in a picture of 800 by 600 with its second view.
class Insets : public testing::Test {
 protected:
  Insets() {
    scene.set_card(session->card());
    panels.set_area({800, 600}, 1);
    panels.show_second(true);
  }

  FakeScript script;
  base::Problems none;
  std::unique_ptr<session::Session> session = open_fake({}, none, script, std::make_shared<FakeLog>());
  console::SceneState scene;
  console::ViewPoint point{scene};
  console::PanelLayout panels{scene, point};
  snapshot::Snapshot now;
};

// During a drag in it an inset neither moves nor zooms: equal mouse motions are equal tip motions.
TEST_F(Insets, KeepTheirZoomInADrag) {
  panels.show_loupe(true);
  const auto go_to = [&](double time_s, float wound_mm) {
    fake_state(script, time_s, now);
    scene.take(now, false);
    console::WoundPlace wound;
    wound.radius = wound_mm;
    panels.set_wound(wound);
    for (int i = 0; i < 20; ++i) panels.advance(0.1);
  };
  const auto span = [&](console::Inset which) {
    for (const console::Panel& p : panels.panels())
      if (p.inset == which) return std::pair{p.at, p.view.eye.mm_per_pixel(p.size.height())};
    return std::pair{QRectF(), 0.0};
  };
  go_to(0, 0.1F);
  for (const console::Inset inset : {console::Inset::kDepth, console::Inset::kWound}) {
    go_to(0, 0.1F);
    const auto before = span(inset);
    ASSERT_GT(before.second, 0);
    panels.hold(inset);
    go_to(3, 1);
    EXPECT_EQ(span(inset), before);
    panels.hold({});
    go_to(3, 1);
    EXPECT_NE(span(inset).second, before.second) << "afterwards it shows what there is to see";
  }
}

// Keys are held for long, and a picture that turns or grows under them cannot be steered by.
TEST_F(Insets, TheSecondViewStandsStillWhileAKeyMovesTheTipsInIt) {
  const auto go_to = [&](double time_s, double aside_m = 0) {
    fake_state(script, time_s, now);
    for (int jaw = 0; jaw < 2; ++jaw) now.X_WB[jaw].p.x += aside_m;
    scene.take(now, false);
    for (int i = 0; i < 20; ++i) panels.advance(0.1);
  };
  const auto inset = [&] {
    for (const console::Panel& p : panels.panels())
      if (p.inset == console::Inset::kDepth) return std::pair{p.at, p.view.eye.view()};
    return std::pair{QRectF(), QMatrix4x4()};
  };
  go_to(0);
  const auto before = inset();
  ASSERT_FALSE(before.first.isEmpty());
  panels.set_keys_down(true);
  go_to(0.05);
  EXPECT_EQ(inset(), before);
  go_to(3, 10e-3);
  EXPECT_NE(inset(), before) << "the tips have left it";
  panels.set_keys_down(false);
}

// The whole needle must be visible: its ends as well as its marked region.
TEST(TraineePicture, AnInsetCoversNoEndOfTheNeedle) {
  FakeScript script;
  script.with_grasp = true;
  base::Problems none;
  const auto session = open_fake({}, none, script, std::make_shared<FakeLog>());
  console::SceneState scene;
  console::ViewPoint point(scene);
  console::PanelLayout panels(scene, point);
  scene.set_card(session->card());
  ASSERT_EQ(scene.parts().ends.size(), 2U);
  EXPECT_GT((scene.place_of(scene.parts().ends[0]) - scene.place_of(scene.parts().ends[1])).length(), 4) << "of an arc of 2.6 mm";
  point.frame(console::CameraPreset::kOrbit);
  auto now = std::make_unique<snapshot::Snapshot>();
  for (const QSize& size : {QSize(670, 485), QSize(490, 450)}) {
    panels.set_area(size, 1);
    panels.show_second(true);
    for (const double t : {0.2, 2.0, 4.5}) {
      fake_state(script, t, *now);
      scene.take(*now, false);
      EXPECT_EQ(scene.taken(), t > 4);
      for (int i = 0; i < 5; ++i) panels.advance(0.1);
      const std::vector<console::Panel> all = panels.panels();
      ASSERT_EQ(all.size(), 2U);
      EXPECT_LT(all[1].at.width(), 0.45 * size.width());
      for (const console::Spot& end : scene.parts().ends)
        EXPECT_FALSE(all[1].at.contains(all[0].view.eye.project(scene.place_of(end), size))) << t << " s, " << size.width();
    }
    panels.show_second(false);
  }
}

}  // namespace
}  // namespace swage::test
