// SPDX-License-Identifier: Apache-2.0
//
// Whoever closes the jaws for the first time, by mouse or key, holds with a force that the lesson asks for: the mouse rests at a force
// inside the lesson's band, a fifth below its upper end, as a held needle is turned and lifted.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "mouse/mouse_hand.hpp"
#include "test_places.hpp"

namespace swage::mouse {
namespace {

constexpr double kOfLimit = 0.8;  // of the upper end of the band

/// N, of "0.3 N".
double newtons(const nlohmann::json& quantity) {
  const std::string text = quantity.get<std::string>();
  EXPECT_TRUE(text.ends_with(" N")) << text;
  return std::stod(text);
}

/// Whether the instrument of a device is a pair of scissors, which grips nothing.
bool cuts(const nlohmann::json& lesson, const std::string& device) {
  for (const nlohmann::json& object : lesson.value("objects", nlohmann::json::array()))
    if (object.value("/follows/closure"_json_pointer, "") == device) return object.value("/params/blades"_json_pointer, false);
  return false;
}

/// What is wrong with the first grip of a lesson file; "" where nothing is, or nobody grips by mouse.
std::string wrong_with(const nlohmann::json& lesson) {
  const nlohmann::json judge = lesson.value("/lesson/params"_json_pointer, nlohmann::json::object());
  if (!judge.contains("force")) return "";
  const double low = newtons(judge["force"][0]), high = newtons(judge["force"][1]);
  for (const nlohmann::json& device : lesson.value("devices", nlohmann::json::array())) {
    if (device.value("as", "") != "mouse" || cuts(lesson, device.value("name", ""))) continue;
    const nlohmann::json params = device.value("params", nlohmann::json::object());
    const double rest = params.contains("rest_force") ? newtons(params["rest_force"]) : Speeds{}.rest_force;
    if (!(rest > low && rest <= kOfLimit * high))
      return device.value("name", "") + " rests at " + std::to_string(rest) + " N, the band is " + std::to_string(low) + " to " + std::to_string(high) + " N";
  }
  return "";
}

TEST(FirstGrip, RestsInsideTheBandOfEachLesson) {
  int bands = 0;
  for (const auto& file : std::filesystem::directory_iterator(SWAGE_SOURCE_DIR "/lessons/series")) {
    if (file.path().extension() != ".json") continue;
    std::ifstream in(file.path());
    const nlohmann::json lesson = nlohmann::json::parse(in);
    bands += lesson.contains("/lesson/params/force"_json_pointer);
    EXPECT_EQ(wrong_with(lesson), "") << file.path();
  }
  EXPECT_GE(bands, 15) << "lessons with a band of force";
}

TEST(FirstGrip, AtTheLimitIsFound) {
  const char* text = R"({ "devices": [ { "name": "hand", "as": "mouse" } ], "lesson": { "params": { "force": ["0.05 N", "0.6 N"] } } })";
  EXPECT_NE(wrong_with(nlohmann::json::parse(text)), "");
}

}  // namespace
}  // namespace swage::mouse
