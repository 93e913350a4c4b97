// SPDX-License-Identifier: Apache-2.0
#include "record/display.hpp"

#include <nlohmann/json.hpp>

namespace swage::record {

namespace {
constexpr const char* kFormat = "swage-display/1";
}

std::string to_json(const Display& d) {
  return nlohmann::ordered_json{{"format", kFormat}, {"mode", d.mode},     {"stereo", d.stereo}, {"eyes_swapped", d.eyes_swapped},
                                {"mirror", d.mirror}, {"scale", d.scale}}
      .dump();
}

bool from_json(const std::string& text, Display& out) {
  const nlohmann::json j = nlohmann::json::parse(text, nullptr, false);
  if (!j.is_object() || !j.contains("format") || j["format"] != kFormat) return false;
  try {
    out = {j.at("mode"), j.at("stereo"), j.at("eyes_swapped"), j.at("mirror"), j.at("scale")};
  } catch (const nlohmann::json::exception&) {
    return false;
  }
  return true;
}

}  // namespace swage::record
