// SPDX-License-Identifier: Apache-2.0
//
// A lesson with one cue, whose role is ROLE. ID names the plugin.
#include <swage/lesson.hpp>

namespace bad_roles {

class Lamp final : public swage::Lesson<> {
 public:
  static constexpr auto id = ID, version = "1.0.0", name = "Lamp", summary = "Shows one cue.", author = "Swage",
                        licence = "Apache-2.0";
  static constexpr swage_cue_info cues[] = {
      {"lamp.lit", "The lamp is lit.", SWAGE_CHANNEL_COLOUR | SWAGE_CHANNEL_SHAPE, ROLE}};

  void build(const swage::NoParams&, swage::LessonBuilder& builder) override {
    builder.cue(cues[0]);
    phase_ = builder.phase("look", "Looks.");
  }
  void observe(const swage::View&, const swage::Verdict& verdict, std::span<double>) override { verdict.phase(phase_); }

 private:
  swage::Phase phase_;
};

}  // namespace bad_roles

SWAGE_EXPORT(bad_roles::Lamp)
