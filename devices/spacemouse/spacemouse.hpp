// SPDX-License-Identifier: Apache-2.0
//
// swage.device.spacemouse: a 3D mouse as a hand: six velocity axes, two buttons for the jaws. See spacemouse.md.
#pragma once

#include <swage/device.hpp>
#include <swage/units.hpp>

#include <string>

#include "rate/rate_hand.hpp"
#include "spnav.hpp"

namespace swage::spacemouse {

struct SpacemouseParams {
  std::string socket;
  bool jaws = true;
  swage_vec3 start = {0, 0, 0};  // m
  swage_vec3 start_axis = {1, 0, 0}, start_closing = {0, 1, 0};
  double full = 350;
  double move = 20e-3, turn = 1.2;                     // m/s, rad/s
  double dead = 0.03, exponent = 2, smoothing = 0.03;  // s
  double close_time = 1.5;                             // s
};

class Spacemouse final : public Device<SpacemouseParams> {
 public:
  using P = SpacemouseParams;
  static constexpr auto id = "swage.device.spacemouse";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "3D mouse";
  static constexpr auto summary = "The cap of a 3D mouse moves and turns the instrument along six axes; its buttons close and open the jaws.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr DeviceCard card{.rate_hz = 500};

  static constexpr std::array fields = {
      text<&P::socket>("socket", "Socket", "Of spacenavd; empty: what SPNAV_SOCKET says, or /var/run/spnav.sock."),
      boolean<&P::jaws>("jaws", "Jaws", "The first button closes the jaws and the second opens them; otherwise the jaws are another device's."),
      vector<&P::start>("start", "Start at", "m", "mm", -1, 1, "Where the tips are at the start, in the device's frame."),
      vector<&P::start_axis>("start_axis", "Start axis", "1", "1", -1, 1,
                             "Direction from hinge to tips at the start; need not have length 1."),
      vector<&P::start_closing>("start_closing", "Start closing direction", "1", "1", -1, 1,
                                "Direction from the right jaw to the left one at the start."),
      real<&P::full>("full", "Full", "1", "1", 10, 10000, "What spacenavd says of an axis at its end, with a sensitivity of 1."),
      real<&P::move>("move", "Move", "m/s", "mm/s", 1e-4, 1, "Speed with the cap at its end, of the hand; the scene's is this over its motion scale.")
          .live(),
      real<&P::turn>("turn", "Turn", "rad/s", "deg/s", 1 * kDegree, 720 * kDegree, "Turning speed at the end.").live(),
      real<&P::dead>("dead", "Dead zone", "1", "%", 0, 0.9, "Share of an axis' way that does nothing.").live(),
      real<&P::exponent>("exponent", "Exponent", "1", "1", 1, 5, "Of the way beyond it: 1 is even, 2 is slow near the middle.").live(),
      real<&P::smoothing>("smoothing", "Smoothing", "s", "ms", 0, 1, "Time constant of the speeds.").live(),
      real<&P::close_time>("close_time", "Closing time", "s", "s", 0.05, 60, "From open to closed while the button is down.").live(),
  };

  void build(const P& params, DeviceBuilder& builder) override;
  void open() override;
  void close() override { socket_.close(); }
  void exchange(const swage_command& command, swage_sample& sample) override;

 private:
  void hear(double now);
  SpnavSocket socket_;
  rate::RateHand hand_;
  toolkit::Vec3 move_ = toolkit::Vec3::Zero(), turn_ = toolkit::Vec3::Zero();  // -1..1
  uint32_t buttons_ = 0;
  double closure_ = 0, last_s_ = 0, heard_s_ = 0, tried_s_ = 0;
};

}  // namespace swage::spacemouse
