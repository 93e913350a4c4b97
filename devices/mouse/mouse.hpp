// SPDX-License-Identifier: Apache-2.0
//
// swage.device.mouse: pointer and keyboard as a hand with six axes and a jaw. Keys: mouse.md.
#pragma once

#include <swage/sight.hpp>
#include <swage/units.hpp>

#include <string>
#include <vector>

#include "mouse_hand.hpp"

namespace swage::mouse {

struct MouseParams {
  swage_vec3 start = {-8e-3, 0, 4e-3};  // m
  swage_vec3 start_axis = {1, 0, 0};
  swage_vec3 start_closing = {0, 1, 0};
  double drag = Speeds{}.drag;
  double wheel = Speeds{}.wheel;
  double turn = Speeds{}.turn;
  double key_move = Speeds{}.key_move;
  double key_turn = Speeds{}.key_turn;
  double close_time = 1.5;  // s
  double tap = Speeds{}.tap;  // s
  double fine = Speeds{}.fine;
  double smoothing = Speeds{}.smoothing;
  double rest_force = Speeds{}.rest_force;  // N
  double give = Speeds{}.give;              // m/s
  double give_turn = Speeds{}.give_turn;    // rad/s
  bool latch = Speeds{}.latch;
  swage_vec3 circle_centre = {0, 0, 0};  // m
  swage_vec3 circle_axis = {0, 0, 0};
  int hand = 1, hands = 1;
  std::string grasp;
};

class Mouse final : public SeeingDevice<MouseParams> {
 public:
  static constexpr auto id = "swage.device.mouse";
  static constexpr auto version = "1.5.0";
  static constexpr auto name = "Mouse and keyboard";
  static constexpr auto summary =
      "Moves, turns and closes the instrument with one hand on the mouse or on the keys; teaches procedure, "
      "not dexterity.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr DeviceCard card{.flags = SWAGE_DEVICE_LOCKSTEP | SWAGE_DEVICE_WORLD | SWAGE_DEVICE_POINTER};

  static constexpr std::array fields = {
      vector<&MouseParams::start>("start", "Start at", "m", "mm", -1, 1,
                                  "Where the tips are at the start, in the world."),
      vector<&MouseParams::start_axis>("start_axis", "Start axis", "1", "1", -1, 1,
                                       "Direction from hinge to tips at the start; need not have length 1."),
      vector<&MouseParams::start_closing>("start_closing", "Start closing direction", "1", "1", -1, 1,
                                          "Direction from the right jaw to the left one at the start."),
      real<&MouseParams::drag>(
          "drag", "Drag", "m", "mm", 1e-5, 1,
          "How far the tips move for a drag over 10 mm of what is seen: 10 mm keeps them under the pointer.")
          .group("Speed")
          .live(),
      real<&MouseParams::wheel>("wheel", "Wheel", "m", "mm", 1e-6, 0.1,
                                "How far the tips move along the line of sight for one notch.")
          .group("Speed")
          .live(),
      real<&MouseParams::turn>("turn", "Turn", "rad", "deg", 1 * kDegree, 3600 * kDegree,
                               "Turn for a drag over 10 mm of what is seen.")
          .group("Speed")
          .live(),
      real<&MouseParams::key_move>("key_move", "Keys, move", "m/s", "mm/s", 1e-5, 1,
                                   "Speed while a key is down.")
          .group("Speed")
          .live(),
      real<&MouseParams::key_turn>("key_turn", "Keys, turn", "rad/s", "deg/s", 1 * kDegree, 3600 * kDegree,
                                   "Turning speed while a key is down.")
          .group("Speed")
          .live(),
      real<&MouseParams::close_time>("close_time", "Closing time", "s", "s", 0.05, 60,
                                     "From open to closed while the closing key is down.")
          .group("Speed")
          .live(),
      real<&MouseParams::fine>("fine", "Fine", "1", "1", 0.001, 1,
                               "Factor of all speeds while shift is down.")
          .group("Speed")
          .live(),
      real<&MouseParams::smoothing>("smoothing", "Smoothing", "s", "ms", 0, 1,
                                    "Time constant that takes the steps out of the mouse's reports.")
          .group("Speed")
          .hidden(),
      real<&MouseParams::rest_force>("rest_force", "Resting force", "N", "N", 0, 100,
                                     "Closing rests at this grip force until the closing key is pressed "
                                     "again; 0 N: it never rests.")
          .live(),
      boolean<&MouseParams::latch>("latch", "Jaws stay",
                                   "The jaws stay where they are when the key is let go; otherwise "
                                   "they open again."),
      vector<&MouseParams::circle_centre>(
          "circle_centre", "Circle's centre", "m", "mm", -1, 1,
          "Centre of the circle of the needle that is held, in the world; the window tells it.")
          .live()
          .hidden(),
      vector<&MouseParams::circle_axis>(
          "circle_axis", "Circle's axis", "1", "1", -1, 1,
          "About which the needle's point goes first; 0 0 0: no needle is held.")
          .live()
          .hidden(),
      integer<&MouseParams::hand>("hand", "Hand", 1, 8, "Which of the instruments that share mouse and keys this is. The first is led at the start.")
          .group("Two hands"),
      integer<&MouseParams::hands>("hands", "Hands", 1, 8, "How many instruments share mouse and keys: Tab hands over to the next, the others stay and hold.")
          .group("Two hands"),
      text<&MouseParams::grasp>("grasp", "Grasp", "Name of the grasp coupling whose force closing rests at; empty: the hardest grip of all.")
          .group("Two hands"),
      real<&MouseParams::give>("give", "Yields", "m/s", "mm/s", 0, 1,
                               "Speed at which the hand gives way while one jaw presses more than the other as it closes; 0: it never does.")
          .live()
          .hidden(),
      real<&MouseParams::give_turn>("give_turn", "Yields, turning", "rad/s", "deg/s", 0, 3600 * kDegree,
                                    "Greatest speed at which the hand rolls with the wire on which the jaws close obliquely; 0: it never does.")
          .live()
          .hidden(),
      real<&MouseParams::tap>("tap", "Shortest stroke", "s", "ms", 0, 1,
                              "Least time for which a key that is pressed moves, turns or drives: the smallest step of the keys is the speed times this.")
          .group("Speed")
          .hidden(),
  };

  void build(const MouseParams& params, DeviceBuilder& builder) override;
  void bind(const Scene& scene, std::span<const swage_scene_mark> marks) override;
  void look(const Sight& sight) override;
  void open() override;
  void exchange(const swage_command& command, swage_sample& sample) override;

 protected:
  void changed() override;

 private:
  swage_pointer taken_over(const swage_pointer& pointer);

  const swage_host_pointer* pointer_ = nullptr;
  MouseHand hand_;
  /// Signals of one grasp: the grip force, the force of each jaw, and their moment about the jaw axis.
  struct Grasp {
    Signal force, left, right, roll_moment;
  };
  std::vector<Grasp> grasps_;  // of one coupling, or of every coupling that grasps
  Felt felt_;
  double last_s_ = 0;
  int leads_ = 1;  // number of the hand that is controlled now
  bool tab_ = false;
  uint64_t old_keys_ = 0;  // keys and buttons down since the hand-over: they belong to the other hand
  uint32_t old_buttons_ = 0;
};

}  // namespace swage::mouse
