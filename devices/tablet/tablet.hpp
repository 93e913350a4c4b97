// SPDX-License-Identifier: Apache-2.0
//
// swage.device.tablet: a pen on a tablet as a hand: position to some micrometres, the pen's tilt, pressure as jaws or depth. See tablet.md.
#pragma once

#include <swage/device.hpp>
#include <swage/units.hpp>

#include <functional>
#include <string>

#include "evdev_pen.hpp"
#include "toolkit/math.hpp"

namespace swage::tablet {

enum class Pressure : int32_t { kJaws, kDepth };

struct TabletParams {
  std::string device;
  Pressure pressure = Pressure::kJaws;
  double hover = 10e-3, depth = 5e-3, lift = 10e-3;  // m, m, m/s
  double soft = 0.05;
  double roll = 0;                      // rad
  double smoothing = 8e-3;              // s
  std::array<double, 2> size = {0.2, 0.12};  // m
};

inline constexpr const char* kPressures[] = {"jaws", "depth", nullptr};

class Tablet : public Device<TabletParams> {
 public:
  using P = TabletParams;
  static constexpr auto id = "swage.device.tablet";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Pen tablet";
  static constexpr auto summary =
      "A pen held like a needleholder: it moves the tips over the surface and tilts them; pressure closes the jaws or goes into depth.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr DeviceCard card{.rate_hz = 500};

  static constexpr std::array fields = {
      text<&P::device>("device", "Device", "Its node, /dev/input/by-id/...; empty: the first tablet that there is."),
      choice<&P::pressure>("pressure", "Pressure", kPressures,
                           "Jaws: pressing closes them, the pen's buttons go up and down. Depth: pressing goes down, the first button closes the jaws."),
      real<&P::hover>("hover", "Hover", "m", "mm", 0, 0.1, "Height of the tips where the pen is about to be lost; 0: hovering does not lift."),
      real<&P::depth>("depth", "Depth", "m", "mm", 0, 0.1, "Way down with full pressure, when pressure is depth."),
      real<&P::lift>("lift", "Lift", "m/s", "mm/s", 0, 0.2, "Speed up (second button) and down (first button), when pressure is jaws."),
      real<&P::soft>("soft", "Softest", "1", "%", 0, 0.5, "Share of the pressure that does nothing: what only holds the pen on the surface."),
      real<&P::roll>("roll", "Roll", "rad", "deg", -180 * kDegree, 180 * kDegree, "Of the instrument about the pen; 0: the jaws open to the right and left."),
      real<&P::smoothing>("smoothing", "Smoothing", "s", "ms", 0, 0.2, "Time constant of the low pass."),
      vector<&P::size>("size", "Size", "m", "mm", 0.02, 1, "Width and height of the active surface, where the kernel does not know it."),
  };

  void open() override;
  void close() override;
  void exchange(const swage_command& command, swage_sample& sample) override;

 protected:
  using Opener = std::function<std::string(const std::string& path, const std::string& like, OpenPen& out)>;
  /// Sets the source of pens; tests provide their own.
  void set_opener(Opener opener) { opener_ = std::move(opener); }

 private:
  bool hear();
  void follow(double dt);

  Opener opener_ = open_pen;
  OpenPen pen_;
  std::string found_;
  PenDecoder decoder_;
  toolkit::Vec3 p_ = toolkit::Vec3::Zero(), tilt_ = toolkit::Vec3::Zero();  // m; rotation vector
  double height_ = 0, closure_ = 0, last_s_ = 0, tried_s_ = 0;                // m, height set by the buttons
  double left_s_ = 0;  // time at which the pen was last away
  bool was_near_ = false;
};

}  // namespace swage::tablet
