// SPDX-License-Identifier: Apache-2.0
//
// A plugin that takes the language of the user for the whole process, as libraries of windows do, when it is loaded and made.
#include <swage/object.hpp>

#include <clocale>
#include <locale>

namespace {

void take_language() {
  std::setlocale(LC_ALL, "");
  try {
    std::locale::global(std::locale(""));
  } catch (const std::exception&) {
    // a machine without it
  }
}

const bool kOnLoad = (take_language(), true);

class Pebble final : public swage::Object<>, public swage::Solid {
 public:
  static constexpr auto id = "org.example.sets_locale";
  static constexpr auto version = "1.0.0", name = "Pebble";
  static constexpr auto summary = "Changes the language of the process.";
  static constexpr auto author = "Swage", licence = "Apache-2.0";

  void build(const swage::NoParams&, swage::ObjectBuilder& b) override {
    take_language();
    b.sphere(b.fixed_body("pebble"), {0, 0, 0}, kOnLoad ? 1e-3 : 2e-3);
  }
};

}  // namespace

SWAGE_EXPORT(Pebble)
