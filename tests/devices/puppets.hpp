// SPDX-License-Identifier: Apache-2.0
//
// Fakes of every driver's hardware with one face: moved by a test, pulled out and put back.
#pragma once

#include <dlfcn.h>
#include <linux/input.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>

#include "fake_inverse.hpp"
#include "fake_spnav.hpp"
#include "live_lesson.hpp"
#include "lost_hand_law.hpp"
#include "sensor_thread.hpp"
#include "virtual_pad.hpp"

namespace swage::test {

constexpr double kToAndFro = 1.5e-3;  // m of the tool, to either side
constexpr double kBeat = 2 * M_PI * 0.5;  // rad/s
inline double swing(double t) { return std::sin(kBeat * t); }

class Puppet {
 public:
  virtual ~Puppet() = default;
  virtual Json devices() = 0;                        // of a lesson
  virtual std::string closure() { return "hand"; }   // which of them has the jaws
  virtual double scale() const { return 1; }         // hand over tool
  /// m/s of the tool at the end of an axis, of a hand that is led by speeds; 0 of one that is where it is.
  virtual double top_speed() const { return 0; }
  /// Where a hand that is where it is was led, `t` seconds after the start; its closure is NaN where a button moves it.
  virtual LedPoint led(double t) const { return {0, kToAndFro * swing(t), std::nan("")}; }
  /// What the person does `t` seconds after the start: to and fro. x: of the tool, from where it began.
  virtual void move(double t, double x) = 0;
  virtual void plug() = 0;
  virtual void unplug() = 0;
  /// Closure in the moment in which it is plugged in; NaN where it is that of the person.
  virtual double closure_when_plugged() const { return std::nan(""); }
  virtual void check() {}  // at the end
};

inline Json placed(Json device, std::initializer_list<const char*> p, std::initializer_list<const char*> rpy, double scale) {
  device["name"] = "hand";
  device["pose"] = {{"p", Json(std::vector<std::string>(p.begin(), p.end()))}, {"rpy", Json(std::vector<std::string>(rpy.begin(), rpy.end()))}};
  device["motion_scale"] = scale;
  return device;
}
inline Json rate_start() { return {{"start", {"6 mm", "3.4 mm", "0 mm"}}, {"start_axis", {-1, 0, 0}}, {"start_closing", {0, 0.7730, 0.6344}}}; }

class PadPuppet : public Puppet {
 public:
  Json devices() override {
    return Json::array({placed({{"plugin", "swage.device.gamepad"}, {"params", rate_start()}}, {"0 mm", "0 mm", "0 mm"}, {"90 deg", "0 deg", "0 deg"}, 1)});
  }
  double top_speed() const override { return 20e-3 * std::sqrt(2.0); }
  // SDL's -1 to 1 of a trigger is its way from 0 to 1; a pad that comes back is let go until its axes are told
  LedPoint led(double t) const override { return {0, 0, 0.5 + 0.25 * swing(t)}; }
  double closure_when_plugged() const override { return 0; }
  void move(double t, double x) override {
    last_t_ = t;
    pad_.axis(gamepad::kLeftX, std::clamp(600 * (kToAndFro * swing(t) - x), -1.0, 1.0));
    pad_.axis(gamepad::kRightTrigger, 0.5 * swing(t));
  }
  void plug() override {
    pad_.plug();
    pad_.axis(gamepad::kRightTrigger, 0.5 * swing(last_t_));  // as the kernel knows it when a pad comes back
  }
  void unplug() override { pad_.unplug(); }

 private:
  VirtualPad pad_;
  double last_t_ = 0;
};

/// The jaws alone are pulled out; the pose stays.
class JawPuppet final : public PadPuppet {
 public:
  explicit JawPuppet(const TempFolder& folder) {
    sensor::SimulatedSensor::Options options;
    options.rate_hz = 500;
    sensor_ = std::make_unique<SensorThread>(
        options, [this](double) { return sensor::SimulatedSensor::Measured{volts_, 0, 0}; }, folder / "port");
  }
  Json devices() override {
    Json out = PadPuppet::devices();
    out.push_back({{"name", "handle"}, {"plugin", "swage.device.jaw_sensor"}, {"params", {{"port", sensor_->port()}}}});
    return out;
  }
  std::string closure() override { return "handle"; }
  double closure_when_plugged() const override { return std::nan(""); }
  // open at 2 V, closed at -1 V and 0.6 of the closure, and squeezed a little
  static double volts(double t) { return 0.5 + 1.8 * swing(t); }
  LedPoint led(double t) const override {
    const double v = volts(t);
    return {0, 0, std::clamp(v >= -1 ? 0.6 * (2 - v) / 3 : 0.6 - 0.4 * (v + 1), 0.0, 1.0)};
  }
  void move(double t, double x) override {
    PadPuppet::move(t, x);
    volts_ = volts(t);
  }
  void plug() override { sensor_->plug(); }
  void unplug() override { sensor_->unplug(); }

 private:
  std::atomic<double> volts_{volts(0)};
  std::unique_ptr<SensorThread> sensor_;
};

class CapPuppet final : public Puppet {
 public:
  explicit CapPuppet(const TempFolder& folder) : socket_(folder / "spnav.sock"), daemon_(socket_) {}
  Json devices() override {
    Json params = rate_start();
    params["socket"] = socket_;
    return Json::array({placed({{"plugin", "swage.device.spacemouse"}, {"params", params}}, {"0 mm", "0 mm", "0 mm"}, {"90 deg", "0 deg", "0 deg"}, 1)});
  }
  double top_speed() const override { return 20e-3; }
  void move(double t, double x) override {
    if (there_) daemon_.tell(0, {static_cast<int32_t>(350 * std::clamp(600 * (kToAndFro * swing(t) - x), -1.0, 1.0)), 0, 0, 0, 0, 0, 16});
  }
  void plug() override { daemon_.start(), there_ = true; }
  void unplug() override { daemon_.stop(), there_ = false; }

 private:
  const std::string socket_;
  Daemon daemon_;
  bool there_ = true;
};

/// An arm: it is where it is, also while it is away.
class ArmPuppet final : public Puppet {
 public:
  ArmPuppet() { fake<void>("fake_reset"); }
  Json devices() override {
    // the fake's tip is at (x, 20, 30) mm: a quarter of that from the frame, the tool well above everything
    Json out = placed({{"plugin", "swage.device.openhaptics"}, {"params", {{"library", kLibrary}}}}, {"6 mm", "7.5 mm", "15 mm"}, {"90 deg", "0 deg", "0 deg"}, 4);
    out["force_scale"] = 10;
    return Json::array({out});
  }
  double scale() const override { return 4; }
  void move(double t, double) override {
    fake<void>("fake_move", 4e3 * kToAndFro * swing(t));
    fake<void>("fake_press", swing(t) > 0 ? 1 : 2);
  }
  void plug() override { fake<void>("fake_plug", 1); }
  void unplug() override { fake<void>("fake_plug", 0); }
  void check() override {
    EXPECT_STREQ(fake<const char*>("fake_wrong"), "");
    EXPECT_LE(fake<double>("fake_most"), 3.3 + 1e-9) << "N";
    EXPECT_LE(fake<double>("fake_jump"), 300 * 5e-3 + 1e-9) << "N in a tick: 300 N/s, after a gap of 5 ms";
  }

 private:
  template <class R, class... A>
  static R fake(const char* name, A... arguments) {
    static void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
    return reinterpret_cast<R (*)(A...)>(dlsym(library, name))(arguments...);
  }
  static constexpr const char* kLibrary = SWAGE_BINARY_DIR "/tests/fake_hd/libHD.so";
};

/// An Inverse3: now its service ends, now the arm alone is away. It is where it is, also while it is away.
class InversePuppet final : public Puppet {
 public:
  Json devices() override {
    Json out = placed({{"plugin", "swage.device.inverse3"}, {"params", {{"port", service_.port()}}}}, {"6 mm", "0 mm", "6 mm"}, {"90 deg", "0 deg", "0 deg"}, 4);
    out["force_scale"] = 10;
    return Json::array({out});
  }
  double scale() const override { return 4; }
  void move(double t, double) override {
    service_.x = 4 * kToAndFro * swing(t);
    service_.buttons = swing(t) > 0 ? 1 : 2;
  }
  void plug() override {
    if (!service_.running()) service_.start();
    service_.arm = true;
  }
  void unplug() override {
    if (++pulled_ % 3 == 0)
      service_.stop();
    else
      service_.arm = false;
  }
  void check() override {
    EXPECT_EQ(service_.wrong(), "");
    EXPECT_LE(service_.most, 3 + 1e-9) << "N";
    EXPECT_LE(service_.jump, 300 * 0.1 + 1e-9) << "N between two messages: 300 N/s, after an answer that was waited for 0.1 s";
  }

 private:
  FakeInverse service_;
  int pulled_ = 0;
};

#ifdef SWAGE_FAKE_XR
/// A VR controller: now it is out of sight, now its runtime ends. It is where it is, also while it is away.
class ControllerPuppet final : public Puppet {
 public:
  ControllerPuppet() {
    setenv("XR_RUNTIME_JSON", SWAGE_BINARY_DIR "/tests/fake_xr/runtime.json", 1);
    fake<void>("fake_reset");
  }
  Json devices() override {
    return Json::array({placed({{"plugin", "swage.device.openxr"}}, {"6 mm", "0 mm", "6 mm"}, {"90 deg", "0 deg", "0 deg"}, 4)});
  }
  double scale() const override { return 4; }
  LedPoint led(double t) const override { return {0, kToAndFro * swing(t), 0.5 + 0.5 * swing(t)}; }
  void move(double t, double) override {
    fake<void>("fake_place", 1, 4 * kToAndFro * swing(t), 0.0, 0.0);
    fake<void>("fake_squeeze", 1, 0.5 + 0.5 * swing(t), 0u);
  }
  void plug() override {
    fake<void>("fake_plug", 1);
    fake<void>("fake_flags", 1, 15u);
  }
  void unplug() override {
    if (++pulled_ % 10 == 0)
      fake<void>("fake_plug", 0);
    else
      fake<void>("fake_flags", 1, 0u);
  }
  void check() override { EXPECT_STREQ(fake<const char*>("fake_wrong"), ""); }

 private:
  template <class R, class... A>
  static R fake(const char* name, A... arguments) {
    static void* const library = dlopen(SWAGE_BINARY_DIR "/tests/fake_xr/fake_xr.so", RTLD_NOW | RTLD_LOCAL);
    return reinterpret_cast<R (*)(A...)>(dlsym(library, name))(arguments...);
  }
  int pulled_ = 0;
};
#endif

/// A pen that hovers to and fro: it is where it is, also while its tablet is away.
class PenPuppet final : public Puppet {
 public:
  explicit PenPuppet(const TempFolder& folder) : path_(folder / "pen.sock") { plug(); }
  ~PenPuppet() override { unplug(); }
  Json devices() override {
    return Json::array({placed({{"plugin", "swage.device.tablet"}, {"params", {{"device", path_}}}}, {"6 mm", "0 mm", "12 mm"}, {"0 deg", "0 deg", "0 deg"}, 4)});
  }
  double scale() const override { return 4; }
  // the softest 5 % hold the pen on the surface
  LedPoint led(double t) const override {
    return {0, kToAndFro * swing(t), std::clamp((pressure(t) / 8191 - 0.05) / 0.95, 0.0, 1.0)};
  }
  static double pressure(double t) { return 3000 + 2000 * swing(t); }
  void move(double t, double) override {
    if (const int next = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC); next >= 0) {
      if (client_ >= 0) ::close(client_);
      client_ = next;
    }
    if (client_ < 0) return;
    std::string bytes = event(EV_KEY, BTN_TOOL_PEN, 1) + event(EV_KEY, BTN_TOUCH, 1);
    bytes += event(EV_ABS, ABS_X, 21600 + static_cast<int>(200e3 * 4 * kToAndFro * swing(t))) + event(EV_ABS, ABS_Y, 13500);
    bytes += event(EV_ABS, ABS_PRESSURE, static_cast<int>(pressure(t))) + event(EV_SYN, SYN_REPORT, 0);
    if (::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) return;  // the driver has let go
  }
  void plug() override {
    listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, path_.c_str(), path_.size());
    EXPECT_EQ(bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(listener_, 4), 0);
  }
  void unplug() override {
    for (int* file : {&client_, &listener_}) {
      if (*file >= 0) ::close(*file);
      *file = -1;
    }
    ::unlink(path_.c_str());
  }

 private:
  static std::string event(int type, int code, int value) {
    input_event e{};
    e.type = static_cast<uint16_t>(type), e.code = static_cast<uint16_t>(code), e.value = value;
    return {reinterpret_cast<const char*>(&e), sizeof e};
  }
  const std::string path_;
  int listener_ = -1, client_ = -1;
};

}  // namespace swage::test
