// SPDX-License-Identifier: Apache-2.0
//
// swage.device.inverse3: an Inverse3 arm of Haply with its stylus, through the manufacturer's service. See inverse3.md.
#pragma once

#include <swage/device_signals.hpp>

#include <string>

#include "haply.hpp"
#include "websocket.hpp"

namespace swage::inverse3 {

struct Inverse3Params {
  std::string host = "127.0.0.1";
  int32_t port = 10001;
  std::string arm, grip;
  swage_vec3 axis = {0, 0, -1}, closing = {-1, 0, 0};
  double max_force = 3;  // N
  bool jaws = true;
  double close_time = 1.5;  // s
};

class Inverse3 final : public TellingDevice<Inverse3Params> {
 public:
  using P = Inverse3Params;
  static constexpr auto id = "swage.device.inverse3";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Inverse3 (Haply)";
  static constexpr auto summary = "The stylus of an Inverse3 leads the instrument and gives forces back, through the Inverse Service of Haply.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr double kMostForce = 8;  // N; the manufacturer specifies 10 N for short times
  static constexpr DeviceCard card{.flags = SWAGE_DEVICE_FORCE, .rate_hz = 1000, .max_force = kMostForce};

  static constexpr std::array fields = {
      text<&P::host>("host", "Host", "On which the Inverse Service runs; this machine, unless its settings open it to others."),
      integer<&P::port>("port", "Port", 1, 65535, "Of the service's simulation channel."),
      text<&P::arm>("arm", "Arm", "Its device id, as swage doctor shows it; empty: the first one."),
      text<&P::grip>("grip", "Stylus", "Device id of the VerseGrip; empty: the first one."),
      vector<&P::axis>("axis", "Axis", "1", "1", -1, 1, "Direction from hinge to tips without a VerseGrip; need not have length 1."),
      vector<&P::closing>("closing", "Closing direction", "1", "1", -1, 1,
                          "Direction from the right jaw to the left one without a VerseGrip."),
      real<&P::max_force>("max_force", "Greatest force", "N", "N", 0, kMostForce, "That the arm is ever told, in size.").live(),
      boolean<&P::jaws>("jaws", "Jaws", "Button A closes the jaws and button B opens them; otherwise the jaws are another device's."),
      real<&P::close_time>("close_time", "Closing time", "s", "s", 0.05, 60, "From open to closed while the button is down.").live(),
  };

  void build(const P& params, DeviceBuilder& builder) override;
  void open() override;
  void close() override;
  void exchange(const swage_command& command, swage_sample& sample) override;

  static constexpr std::array told{DeviceSignal{"stylus.battery", "1", "Charge of the VerseGrip's battery."}};
  void tell(std::span<double> out) override { out[0] = grip_there_ ? grip_.battery.value_or(kNotKnown) : kNotKnown; }

 private:
  std::string reach();
  void hear(const std::string& text, double now);
  void answer(const swage_command& command, double now);
  Vec3 limited(const Vec3& force) const;

  WebSocket socket_;
  Quat fixed_;           // orientation of the tool where there is no stylus
  std::string arm_;      // id of the arm at the start of the lesson
  bool newer_ = false;   // see Arm
  bool asked_ = false;   // a message was sent and not yet answered
  bool fresh_ = false;   // the arm's state has arrived since the last sample
  bool grip_known_ = false, grip_there_ = false;
  bool battery_told_ = false;
  Arm now_;
  Grip grip_;
  double closure_ = 0, last_s_ = 0, heard_s_ = 0, tried_s_ = 0, asked_s_ = 0;
};

}  // namespace swage::inverse3
