// SPDX-License-Identifier: Apache-2.0
//
// A ghost in the picture: visible, translucent, and completely removed.
#include "gl_fixture.hpp"

namespace swage::test {
namespace {

class GhostGl : public Gl {
 protected:
  /// Poses of the fake scene `t` seconds after its start.
  std::vector<swage_pose> poses(double t) {
    auto s = std::make_unique<snapshot::Snapshot>();
    fake_state(script, t, *s);
    return {s->X_WB, s->X_WB + s->n_body};
  }
  snapshot::SceneCard card() {
    base::Problems none;
    return open_fake({}, none, script, std::make_shared<FakeLog>())->card();
  }
  const snapshot::SceneCard* new_card() {
    given_ = card();
    return &given_;
  }
  QImage scene() {
    settle();
    return view()->image();
  }

 private:
  snapshot::SceneCard given_;
};

TEST_F(GhostGl, IsSeenAndSeenThroughAndLeavesNoTrace) {
  launch.theme = "dark";
  open_ready();
  if (IsSkipped()) return;
  const QImage before = scene();
  const int marked = count(before, red);
  ASSERT_GT(marked, 300);
  view()->set_ghost(nullptr);
  view()->set_ghost(new_card(), "Expert");
  EXPECT_EQ(changed(before, scene()), 0) << "nowhere yet";
  view()->show_ghost(poses(4));  // closed on the marked region
  const QImage with = scene();
  EXPECT_TRUE(view()->ghost_shown());
  EXPECT_GT(changed(before, with), 0.002);
  EXPECT_GT(count(with, red), marked / 3) << "what is behind it is still seen";
  view()->show_ghost({});
  EXPECT_EQ(changed(before, scene()), 0);
  view()->show_ghost(poses(4));
  view()->set_ghost(new_card(), "Bea");
  view()->show_ghost(poses(2));
  EXPECT_GT(changed(with, scene()), 0.001) << "elsewhere";
  view()->set_ghost(nullptr);
  EXPECT_FALSE(view()->ghost_shown());
  EXPECT_EQ(changed(before, scene()), 0);
}

TEST_F(GhostGl, GoesWithTheSceneThatItStandsIn) {
  open_ready();
  if (IsSkipped()) return;
  view()->set_ghost(new_card(), "Expert");
  view()->show_ghost(poses(4));
  settle();
  view()->set_card(card());
  EXPECT_FALSE(view()->ghost_shown());
  view()->show_ghost(poses(4));
  EXPECT_FALSE(view()->ghost_shown()) << "whose it was is gone";
}

TEST_F(GhostGl, EitherEyeSeesIt) {
  open_ready();
  if (IsSkipped()) return;
  for (const auto layout : {console::StereoLayout::kLeftEye, console::StereoLayout::kRightEye}) {
    console::StereoLook look;
    look.layout = layout;
    view()->set_stereo(look);
    view()->set_ghost(nullptr);
    const QImage without = scene();
    view()->set_ghost(new_card(), "Expert");
    view()->show_ghost(poses(4));
    EXPECT_GT(changed(without, scene()), 0.002);
  }
}

}  // namespace
}  // namespace swage::test
