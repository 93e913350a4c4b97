// SPDX-License-Identifier: Apache-2.0
//
// swage.device.gamepad: a game pad as a hand. Sticks set velocities, triggers the jaws; one instrument with both halves, or one with each.
// See gamepad.md.
#pragma once

#include <swage/device_signals.hpp>
#include <swage/units.hpp>

#include <string>

#include "rate/rate_hand.hpp"
#include "sdl.hpp"

namespace swage::gamepad {

enum class Half : int32_t { kBoth, kLeft, kRight };
enum class Trigger : int32_t { kPosition, kRate };

struct GamepadParams {
  std::string pad;
  Half half = Half::kBoth;
  Trigger trigger = Trigger::kPosition;
  swage_vec3 start = {0, 0, 0};  // m
  swage_vec3 start_axis = {1, 0, 0}, start_closing = {0, 1, 0};
  double move = 20e-3, turn = 1.2;                    // m/s, rad/s
  double dead = 0.1, exponent = 2, smoothing = 0.05;  // s
  double close_time = 1.5;                            // s
  double fine = 0.25;
};

inline constexpr const char* kHalves[] = {"both", "left", "right", nullptr};
inline constexpr const char* kTriggers[] = {"position", "rate", nullptr};

class Gamepad final : public TellingDevice<GamepadParams> {
 public:
  using P = GamepadParams;
  static constexpr auto id = "swage.device.gamepad";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Game pad";
  static constexpr auto summary =
      "Sticks move and turn the instrument, triggers close the jaws; one instrument with the whole pad, or one with each half.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr DeviceCard card{.rate_hz = 500};

  static constexpr std::array fields = {
      text<&P::pad>("pad", "Pad", "Part of the pad's name, as swage doctor shows it; empty: the first one."),
      choice<&P::half>("half", "Half", kHalves, "Of the pad that leads this instrument; left and right make two instruments of one pad."),
      choice<&P::trigger>("trigger", "Trigger", kTriggers,
                          "Position: the jaws are closed as far as the trigger. Rate: the trigger closes, the other one (of a half: back or start) "
                          "opens, and the jaws stay."),
      vector<&P::start>("start", "Start at", "m", "mm", -1, 1, "Where the tips are at the start, in the device's frame."),
      vector<&P::start_axis>("start_axis", "Start axis", "1", "1", -1, 1,
                             "Direction from hinge to tips at the start; need not have length 1."),
      vector<&P::start_closing>("start_closing", "Start closing direction", "1", "1", -1, 1,
                                "Direction from the right jaw to the left one at the start."),
      real<&P::move>("move", "Move", "m/s", "mm/s", 1e-4, 1, "Speed with the stick at its end, of the hand; the scene's is this over its motion scale.")
          .live(),
      real<&P::turn>("turn", "Turn", "rad/s", "deg/s", 1 * kDegree, 720 * kDegree, "Turning speed at the end.").live(),
      real<&P::dead>("dead", "Dead zone", "1", "%", 0, 0.9, "Share of a stick's way that does nothing.").live(),
      real<&P::exponent>("exponent", "Exponent", "1", "1", 1, 5, "Of the way beyond it: 1 is even, 2 is slow near the middle.").live(),
      real<&P::smoothing>("smoothing", "Smoothing", "s", "ms", 0, 1, "Time constant of the speeds.").live(),
      real<&P::close_time>("close_time", "Closing time", "s", "s", 0.05, 60, "From open to closed with the trigger at its end, by rate.").live(),
      real<&P::fine>("fine", "Fine", "1", "1", 0.01, 1, "Factor of the speeds while the stick is pressed down.").live(),
  };

  void build(const P& params, DeviceBuilder& builder) override;
  void open() override;
  void close() override;
  void exchange(const swage_command& command, swage_sample& sample) override;

  static constexpr std::array told{DeviceSignal{"pad.battery", "1", "Charge of the pad's battery; not known of a pad on a wire."}};
  void tell(std::span<double> out) override { out[0] = battery_; }

 private:
  bool find();
  void look_at_battery(double now);
  double axis(Axis a) const;
  double key(Button plus, Button minus) const;
  bool down(Button b) const { return sdl_->GameControllerGetButton(pad_, b) != 0; }
  void lead(double dt);
  void squeeze(double dt);

  const Sdl* sdl_ = nullptr;
  SdlController* pad_ = nullptr;
  std::string found_;  // name of the first pad found: only a pad of that name replaces it
  rate::RateHand hand_;
  double closure_ = 0, last_s_ = 0, tried_s_ = 0;
  double battery_ = kNotKnown, battery_s_ = 0;
  bool battery_told_ = false;
};

}  // namespace swage::gamepad
