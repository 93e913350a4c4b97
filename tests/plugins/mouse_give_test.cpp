// SPDX-License-Identifier: Apache-2.0
//
// The hand of the mouse gives way while it closes: aside to the jaw that pushes, and about the jaw axis to a wire that lies obliquely.
#include <swage/abi/sight.h>

#include <cstring>
#include <numbers>

#include "mouse/mouse_hand.hpp"
#include "stage.hpp"

namespace swage::mouse {
namespace {

swage_pointer closing_pointer() {
  swage_pointer p{};
  p.camera = toolkit::raw(Quat::Identity());
  p.keys = kSpace;
  return p;
}

swage_pointer g_closing;

TEST(MouseHand, GivesWayToTheJawThatPushesWhileItCloses) {
  // the left jaw is at +z of the tool
  for (const int jaw : {1, -1, 0}) {
    MouseHand hand(Speeds{}, Pose());
    swage_pointer p = closing_pointer();
    for (int i = 0; i < 100; ++i) hand.step(p, 1e-3, {0.05, jaw, 0});
    EXPECT_LT((hand.pose().p - Vec3(0, 0, jaw * 0.1 * Speeds{}.give)).norm(), 1e-9) << jaw;
    p.keys = 0;
    const Vec3 there = hand.pose().p;
    for (int i = 0; i < 100; ++i) hand.step(p, 1e-3, {0.05, jaw, 0});
    EXPECT_LT((hand.pose().p - there).norm(), 1e-9) << "a needle that is held does not lead the hand";
  }
}

TEST(MouseHand, RollsWithTheWireOnWhichItsJawsCloseObliquely) {
  // jaws of 0.6 mm width on a wire that lies `off` from their faces: they press at their edges until the wire lies along them within 1 deg
  const auto lever = [](double off) { return 0.3e-3 * std::clamp(off / (std::numbers::pi / 180), -1.0, 1.0); };
  const auto off_after = [&](double give_turn, double off, uint64_t key) {
    Speeds speeds;
    speeds.give_turn = give_turn;
    const Pose start({1e-3, 2e-3, 3e-3}, toolkit::exp_rotation({0.3, -0.5, 0.8}));
    MouseHand hand(speeds, start);
    swage_pointer p = closing_pointer();
    p.keys = key;
    const auto rolled = [&] { return toolkit::log_rotation(start.q.conjugate() * hand.pose().q).x(); };
    for (int i = 0; i < 100; ++i) hand.step(p, 1e-3, {0.05, 0, lever(off - rolled())});
    EXPECT_LT((hand.pose().p - start.p).norm(), 1e-12) << "about the tips";
    return off - rolled();
  };
  for (const double off : {0.35, -0.35, 0.5}) {
    EXPECT_LT(std::abs(off_after(Speeds{}.give_turn, off, kSpace)), 0.01) << off;
    EXPECT_EQ(off_after(0, off, kSpace), off) << "it never does";
    EXPECT_EQ(off_after(Speeds{}.give_turn, off, 0), off) << "a needle that is held does not lead the hand";
  }
}

// The grasp's signals: its jaws press with 0.5 N each, at places along their width that differ by 0.4 mm.
swage_sample closed_on_an_oblique_wire(const stage::Params& params) {
  stage::Stage stage("swage.device.mouse");
  const swage_host_pointer table{[](const swage_host*) -> const swage_pointer* { return &g_closing; }};
  stage.pointer_table = &table;
  EXPECT_EQ(stage.configure(params), SWAGE_OK);
  const auto text = [](const char* s) { return swage_str{s, std::strlen(s)}; };
  std::vector<swage_scene_signal> signals;
  for (const char* id : {"grasp.force", "grasp.left", "grasp.right", "grasp.roll_moment"}) signals.push_back({text("grasp"), text(id), text("N")});
  swage_scene_card scene{};
  scene.struct_size = sizeof scene;
  scene.n_signal = static_cast<uint32_t>(signals.size());
  scene.signal = signals.data();
  const swage_sight_card card{sizeof card, 0, &scene, nullptr};
  const auto& sight = stage.table<swage_device_sight>(SWAGE_EXT_SIGHT);
  EXPECT_EQ(sight.bind(stage.raw(), &card), SWAGE_OK);
  EXPECT_EQ(stage.activate(), SWAGE_OK);
  const auto& device = stage.table<swage_device>(SWAGE_EXT_DEVICE);
  EXPECT_EQ(device.open(stage.raw()), SWAGE_OK);
  stage.on_rt();
  g_closing = closing_pointer();
  const double values[] = {0.5, 0.5, 0.5, 0.5 * 0.4e-3};
  swage_view view{};
  view.struct_size = sizeof view;
  view.n_signal = 4;
  view.signal = values;
  const swage_sight seen{sizeof seen, 0, &view, nullptr};
  swage_command command{};
  swage_sample sample{};
  for (int i = 0; i < 20; ++i) {
    command.time_s = i * 1e-3;
    EXPECT_EQ(sight.look(stage.raw(), &seen), SWAGE_OK);
    EXPECT_EQ(device.exchange(stage.raw(), &command, &sample), SWAGE_OK);
  }
  return sample;
}

TEST(Mouse, GivesWayToItsOwnGraspAlone) {
  const auto rolled = [](const swage_sample& s, const swage_sample& without) {
    return toolkit::log_rotation(toolkit::quat(without.pose.q).conjugate() * toolkit::quat(s.pose.q)).x();
  };
  const swage_sample alone = closed_on_an_oblique_wire({}), never = closed_on_an_oblique_wire({{"give_turn", 0}});
  EXPECT_NEAR(rolled(alone, never), 19e-3 * Speeds{}.give_turn, 1e-9) << "full speed from a lever of 0.1 mm on";
  EXPECT_EQ(rolled(never, never), 0);
  EXPECT_NEAR(rolled(closed_on_an_oblique_wire({{"hands", 2}, {"grasp", std::string("grasp")}}), never), 19e-3 * Speeds{}.give_turn, 1e-9);
  EXPECT_EQ(rolled(closed_on_an_oblique_wire({{"hands", 2}}), never), 0) << "scissors beside a holder that grips";
}

}  // namespace
}  // namespace swage::mouse
