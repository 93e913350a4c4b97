// SPDX-License-Identifier: Apache-2.0
//
// swage doctor about devices: what is missing, by kind of lack, and the one command that mends it. Hardware stands in a folder of the
// test's own (SWAGE_DEVICE_ROOT); a node without permission is a file that nobody may read, and root asks as nobody.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "devices/fake_spnav.hpp"
#include "gamepad/sentences.hpp"
#include "inverse3/sentences.hpp"
#include "jaw_sensor/sentences.hpp"
#include "openhaptics/sentences.hpp"
#include "openxr/sentences.hpp"
#include "program.hpp"
#include "sensor/sentences.hpp"
#include "spacemouse/sentences.hpp"
#include "tablet/sentences.hpp"
#include "test_places.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kPenBit = "1";           // bit 320, BTN_TOOL_PEN: the sixth word of 64
constexpr const char* kPadBit = "1000000000000";  // bit 304, BTN_GAMEPAD: the fifth

class Doctor : public Program {
 protected:
  Doctor() {
    chmod(folder().c_str(), 0777);
    setenv("SWAGE_DEVICE_ROOT", folder().c_str(), 1);
  }
  ~Doctor() override {
    for (const char* name : {"SWAGE_DEVICE_ROOT", "SPNAV_SOCKET", "LD_LIBRARY_PATH", "XR_RUNTIME_JSON"}) unsetenv(name);
  }
  void file(const std::string& name, const std::string& text, mode_t mode = 0644) {
    fs::create_directories(fs::path(path(name)).parent_path());
    write(name, text);
    chmod(path(name).c_str(), mode);
  }
  /// An input device as /sys shows it; `words`: its keys above those of `below` words of none.
  void input(const std::string& node, const std::string& name, const std::string& word, int below, mode_t mode) {
    std::string words = word;
    for (int i = 0; i < below; ++i) words += " 0";
    file("sys/class/input/" + node + "/device/name", name + "\n");
    file("sys/class/input/" + node + "/device/capabilities/key", words + "\n");
    file("dev/input/" + node, "", mode);
  }
  void hidraw(const std::string& node, const std::string& id, const std::string& name, mode_t mode) {
    file("sys/class/hidraw/" + node + "/device/uevent", "DRIVER=hid-generic\nHID_ID=" + id + "\nHID_NAME=" + name + "\n");
    file("dev/" + node, "", mode);
  }
  /// What it says, by somebody who is not root.
  static Said ask(const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments = {"doctor"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    if (geteuid() != 0) return swage(arguments);
    arguments.insert(arguments.begin(), {"--reuid=65534", "--regid=65534", "--clear-groups", SWAGE_PROGRAM});
    return swage(arguments, "/usr/bin/setpriv");
  }
  static nlohmann::json of(const std::string& kind, const nlohmann::json& list) {
    for (const auto& f : list)
      if (f["name"] == "device swage.device." + kind) return f;
    ADD_FAILURE() << "nothing of " << kind;
    return {};
  }
  /// What the driver has said: what is missing, and what to do about it.
  static std::string told(const nlohmann::json& finding) { return finding["text"].get<std::string>() + ". " + finding["remedy"].get<std::string>(); }
  static void expect_rule(const nlohmann::json& finding, const std::string& kind) {
    const std::string rule = source("resources/udev/70-swage.device." + kind + ".rules"), command = finding["command"];
    EXPECT_TRUE(fs::exists(rule)) << rule;
    EXPECT_EQ(command, "sudo install -m 644 '" + fs::canonical(rule).string() + "' /etc/udev/rules.d/ && sudo udevadm control --reload && sudo udevadm trigger");
    EXPECT_THAT(finding["remedy"].get<std::string>(), HasSubstr("70-swage.device." + kind + ".rules"));
  }
};

TEST_F(Doctor, NamesEveryKindAndWhatIsMissing) {
  const nlohmann::json list = ask({"--json"}).json();
  for (const char* kind : {"mouse", "scripted", "skilled", "replay"}) {
    EXPECT_EQ(of(kind, list)["state"], "good");
    EXPECT_EQ(of(kind, list)["text"], tools::say::kReadyAnd(tools::say::kNoHardware()));
  }
  struct Kind {
    std::string id;
    testing::Matcher<std::string> said;
    std::string command;  // an expression
  };
  const auto with = [](const std::string& before, const std::string& after) { return testing::AllOf(StartsWith(before), testing::EndsWith(after)); };
  std::vector<Kind> kinds = {
      {"gamepad", gamepad::say::kNoPad(), "^$"},
      {"inverse3", with(inverse3::say::kNoService.words(0), inverse3::say::kNoService.words(2)), "^sudo systemctl enable --now haply-inverse-service$"},
      {"jaw_sensor", jaw_sensor::say::kNoAdapter(), "^$"},
      {"openhaptics", with(openhaptics::say::kNoLibrary.words(0), openhaptics::say::kNoLibrary.words(1)), "^$"},
      {"spacemouse", with(spacemouse::say::kNoDaemon.words(0), spacemouse::say::kNoDaemon.words(1)),
       "^sudo apt install spacenavd; sudo systemctl enable --now spacenavd$"},
      {"tablet", tablet::say::kNoTablet(""), "^$"}};
  if (fs::exists(SWAGE_BINARY_DIR "/plugins/swage.device.openxr"))  // where its headers are
    kinds.push_back({"openxr", testing::AnyOf(testing::EndsWith(openxr::say::kNoLoader.words(1)), StartsWith(openxr::say::kNoRuntime())),
                     "^$|^sudo apt install libopenxr-loader1$"});
  for (const Kind& kind : kinds) {
    const nlohmann::json f = of(kind.id, list);
    if (f["state"] == "good") continue;  // what stands outside /dev and /sys may be here
    EXPECT_THAT(told(f), kind.said);
    EXPECT_THAT(f["command"].get<std::string>(), ContainsRegex(kind.command));
  }
}

TEST_F(Doctor, ALibraryThatIsMissingIsAPackage) {
  file("none/libSDL2-2.0.so.0", "no library");
  setenv("LD_LIBRARY_PATH", path("none").c_str(), 1);
  const nlohmann::json f = of("gamepad", ask({"--json"}).json());
  EXPECT_EQ(f["state"], "poor");
  EXPECT_EQ(told(f), gamepad::say::kNoLibrary("libSDL2-2.0.so.0"));
  EXPECT_EQ(f["command"], "sudo apt install libsdl2-2.0-0");
}

TEST_F(Doctor, WhatIsThereWithoutPermissionHasItsUdevRule) {
  input("event3", "Keyboard", "fffffffffffffffe", 0, 0);  // closed as well, and nobody's business
  input("event7", "Intuos Pro", kPenBit, 5, 0);
  input("event8", "Racing Wheel Pad", kPadBit, 4, 0);
  hidraw("hidraw2", "0003:00002988:00000304", "3D Systems Touch", 0);
  file("dev/serial/by-id/usb-Arduino_A1-if00", "", 0);
  setenv("LD_LIBRARY_PATH", SWAGE_BINARY_DIR "/tests/fake_hd", 1);
  setenv("SWAGE_FAKE_HD_ABSENT", "1", 1);
  const nlohmann::json list = ask({"--json"}).json();
  unsetenv("SWAGE_FAKE_HD_ABSENT");
  EXPECT_EQ(told(of("tablet", list)), tablet::say::kClosed("Intuos Pro (" + path("dev/input/event7") + ")", tablet::say::kRights()));
  EXPECT_EQ(told(of("gamepad", list)), gamepad::say::kMayNotRead("Racing Wheel Pad (" + path("dev/input/event8") + ")"));
  EXPECT_EQ(told(of("jaw_sensor", list)), sensor::say::kMayNotOpen(path("dev/serial/by-id/usb-Arduino_A1-if00")));
  EXPECT_EQ(told(of("openhaptics", list)), openhaptics::say::kMayNotOpen("3D Systems Touch (" + path("dev/hidraw2") + ")"));
  for (const char* kind : {"tablet", "gamepad", "jaw_sensor", "openhaptics"}) expect_rule(of(kind, list), kind);
  // in words, too
  EXPECT_THAT(ask().out, ContainsRegex("poor  device swage.device.tablet Intuos Pro.*\n.*70-swage.*\n +sudo install -m 644 .*udevadm trigger\n"));
}

TEST_F(Doctor, APadByHidrawIsFoundByItsMaker) {
  hidraw("hidraw0", "0003:0000046D:0000C52B", "Receiver", 0);
  hidraw("hidraw1", "0005:0000054C:00000CE6", "DualSense", 0);
  const nlohmann::json f = of("gamepad", ask({"--json"}).json());
  EXPECT_EQ(told(f), gamepad::say::kMayNotRead("DualSense (" + path("dev/hidraw1") + ")"));
  expect_rule(f, "gamepad");
}

TEST_F(Doctor, WhatIsThereAndOpenIsReady) {
  fs::create_directories(path("dev/serial/by-id"));
  Running sensor({"simulate-sensor", "--link", path("dev/serial/by-id/usb-Swage_SIM1-if00")}, folder());
  for (int i = 0; i < 500 && access(path("dev/serial/by-id/usb-Swage_SIM1-if00").c_str(), F_OK) != 0; ++i) usleep(10'000);
  chmod(path("dev/serial/by-id/usb-Swage_SIM1-if00").c_str(), 0666);
  swage::test::Daemon spacenavd(path("spnav.sock"));
  chmod(path("spnav.sock").c_str(), 0666);
  setenv("SPNAV_SOCKET", path("spnav.sock").c_str(), 1);
  setenv("LD_LIBRARY_PATH", SWAGE_BINARY_DIR "/tests/fake_hd", 1);
  setenv("XR_RUNTIME_JSON", SWAGE_BINARY_DIR "/tests/fake_xr/runtime.json", 1);
  const nlohmann::json list = ask({"--json"}).json();
  std::vector<std::string> kinds = {"jaw_sensor", "spacemouse", "openhaptics"};
  if (fs::exists(SWAGE_BINARY_DIR "/plugins/swage.device.openxr")) kinds.push_back("openxr");
  for (const std::string& kind : kinds) {
    const nlohmann::json f = of(kind, list);
    EXPECT_EQ(f["state"], "good") << f;
    EXPECT_THAT(f["text"].get<std::string>(), testing::StartsWith("ready"));
    EXPECT_EQ(f["remedy"], "");
    EXPECT_EQ(f["command"], "");
  }
  EXPECT_THAT(of("jaw_sensor", list)["text"].get<std::string>(), HasSubstr(jaw_sensor::say::kNotCalibrated.words(1)));
  sensor.signal(SIGTERM);
  sensor.end();
}

}  // namespace
}  // namespace swage::tools::test
