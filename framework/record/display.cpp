// SPDX-License-Identifier: Apache-2.0
#include "record/display.hpp"

#include <charconv>
#include <nlohmann/json.hpp>

namespace swage::record {

namespace {
constexpr const char* kDisplayFormat = "swage-display/1";
}

std::string to_json(const Display& d) {
  return nlohmann::ordered_json{{"format", kDisplayFormat}, {"mode", d.mode},     {"stereo", d.stereo}, {"eyes_swapped", d.eyes_swapped},
                                {"mirror", d.mirror}, {"scale", d.scale}, {"guided", d.guided}}
      .dump();
}

bool from_json(const std::string& text, Display& out) {
  const nlohmann::json j = nlohmann::json::parse(text, nullptr, false);
  if (!j.is_object() || !j.contains("format") || j["format"] != kDisplayFormat) return false;
  try {
    out = {j.at("mode"), j.at("stereo"), j.at("eyes_swapped"), j.at("mirror"), j.at("scale"),
           j.value("guided", false)};  // older attempts had no guide
  } catch (const nlohmann::json::exception&) {
    return false;
  }
  return true;
}

std::string words(const Display& d) {
  std::string out = d.mode;
  if (out.empty()) return out;
  if (d.eyes_swapped) out += ", eyes swapped";
  if (!d.mirror.empty()) out += ", mirrored " + d.mirror;
  if (d.scale > 0) {
    char scale[32];  // with a decimal point in every locale
    const auto end = std::to_chars(scale, scale + sizeof scale, d.scale, std::chars_format::general, 4).ptr;
    out += ", scale " + std::string(scale, end);
  }
  return d.guided ? out + ", guided" : out;
}

}  // namespace swage::record
