// SPDX-License-Identifier: Apache-2.0
//
// @ID@: an object has to come to a place and stay there for a while.
#pragma once

#include <swage/lesson.hpp>

struct @NAME@Params {
  std::string object = "ball";
  swage_vec3 target = {0, 0, 0};  // m
  double tolerance = 0.5e-3;      // m
  double hold_time = 0.5;         // s
  double max_time = 60;           // s
};

class @NAME@ final : public swage::Lesson<@NAME@Params> {
 public:
  static constexpr auto id = "@ID@";
  static constexpr auto version = "0.1.0";
  static constexpr auto name = "@TITLE@";
  static constexpr auto summary = "An object has to come to a place and stay there for a while.";
  static constexpr auto author = "Somebody";
  static constexpr auto licence = "Apache-2.0";

  static constexpr std::array fields = {
      swage::text<&@NAME@Params::object>("object", "Object", "Name of the object in the lesson file."),
      swage::vector<&@NAME@Params::target>("target", "Target", "m", "mm", -1, 1, "Where it has to come to."),
      swage::real<&@NAME@Params::tolerance>("tolerance", "Tolerance", "m", "mm", 1e-6, 1, "Distance that counts as there."),
      swage::real<&@NAME@Params::hold_time>("hold_time", "Hold", "s", "s", 0, 600, "For how long it has to stay."),
      swage::real<&@NAME@Params::max_time>("max_time", "Time limit", "s", "s", 1, 36000, "The attempt fails after it."),
  };

  // the cues; where the console's theme does not know an id, the role gives colour, shape and sound
  static constexpr swage_cue_info cues[] = {
      {"reach.there", "The object is at the target.", SWAGE_CHANNEL_COLOUR | SWAGE_CHANNEL_SHAPE | SWAGE_CHANNEL_SOUND, SWAGE_CUE_GOOD},
      {"reach.away", "The object is away from the target.", SWAGE_CHANNEL_COLOUR | SWAGE_CHANNEL_SHAPE, SWAGE_CUE_TARGET},
  };

  void build(const @NAME@Params& params, Builder& builder) override;
  void bind(const swage::Scene& scene, swage::Binder& binder) override;
  void observe(const swage::View& view, const swage::Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override;

 private:
  // private numbers of the lesson: doubles that the host keeps, saves and restores
  struct State {
    double held;     // s
    double nearest;  // m
  };

  uint32_t object_ = swage::kNone, body_ = swage::kNone;
  swage::Mark target_;
  swage::Metric time_, nearest_;
  swage::Cue there_, away_;
  swage::Event late_;
  swage::Phase reach_, hold_;
};
