// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.angles: to which side does it tilt? Trains and measures the eye for angles. See angles.md.
#pragma once

#include <swage/display.hpp>
#include <swage/lesson.hpp>

#include <string>

#include "card.hpp"
#include "common/watching.hpp"
#include "judge.hpp"

namespace swage::lesson_angles {

enum class Between : int { kSurface, kJaws };
inline constexpr const char* kBetween[] = {"surface", "jaws", nullptr};

struct AnglesParams {
  std::string gripper = "holder", assistant = "assistant", needle = "needle", tissue = "tissue";
  Between between = Between::kSurface;
  swage_vec3 place = {0, 0, 3.3e-3};           // m, W
  swage_vec3 sight = {0, 1, 0};                // W
  swage_vec3 answer_place = {0, -4e-3, 3e-3};  // m, W
  double answer_reach = 2e-3;                  // m
  int questions = Rules{}.questions;
  double start = Rules{}.start, least = Rules{}.least;                  // rad
  double show_time = Rules{}.show_time, tell_time = Rules{}.tell_time;  // s
  bool stereo = false;
  double max_bias = Rules{}.max_bias, max_jnd = Rules{}.max_jnd;    // rad
  double par_time = Rules{}.par_time, max_time = Rules{}.max_time;  // s
};

class AnglesLesson final : public Lesson<AnglesParams> {
 public:
  static constexpr auto id = "swage.lesson.angles";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Judge angles";
  static constexpr auto summary =
      "An assistant holds up a needle over a surface, or jaws before a needle: say to which side it tilts. "
      "Finds the smallest tilt that the eye can tell, and its bias.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr std::span<const swage_metric_info> metrics{kMetrics};
  static constexpr std::span<const swage_cue_info> cues{kCues};
  static constexpr std::span<const swage_metric_label> labels{kLabels};
  static constexpr std::span<const swage_criterion> criteria{kCriteria};

  static constexpr std::array fields = {
      text<&AnglesParams::gripper>("gripper", "Gripper", "Name of the object that answers."),
      text<&AnglesParams::assistant>("assistant", "Assistant", "Name of the gripper that shows."),
      text<&AnglesParams::needle>("needle", "Needle", "Name of the needle."),
      text<&AnglesParams::tissue>("tissue", "Tissue", "Name of the surface; not needed for jaws."),
      choice<&AnglesParams::between>(
          "between", "Angle to", kBetween,
          "Surface: the needle's point against the tissue. Jaws: the assistant's jaws against the needle."),
      vector<&AnglesParams::place>("place", "Place", "m", "mm", -1, 1,
                                   "Where the needle's point, or the tips of the jaws, are shown, in the "
                                   "world; the assistant's plan has the same."),
      vector<&AnglesParams::sight>("sight", "Line of sight", "1", "1", -1, 1,
                                   "Direction in which the trainee looks; need not have length 1."),
      vector<&AnglesParams::answer_place>("answer_place", "Answers", "m", "mm", -1, 1,
                                          "Middle between the two places where answers are given."),
      real<&AnglesParams::answer_reach>("answer_reach", "Reach", "m", "mm", 1e-4, 0.1,
                                        "Distance of each of the two places from that middle."),
      integer<&AnglesParams::questions>("questions", "Questions", 4, 120,
                                        "Number of questions; each of the four staircases gets a quarter of them."),
      real<&AnglesParams::start>("start", "First tilt", "rad", "deg", 1 * kDegree, 40 * kDegree,
                                 "First tilt of each staircase; the widest tilt shown is twice this."),
      real<&AnglesParams::least>("least", "Least step", "rad", "deg", 0.05 * kDegree, 10 * kDegree,
                                 "The steps of a staircase are halved down to this."),
      real<&AnglesParams::show_time>("show_time", "Viewing time", "s", "s", 0.05, 60,
                                     "Time from the movement of needle or jaws to the question."),
      real<&AnglesParams::tell_time>("tell_time", "Feedback time", "s", "s", 0.05, 60,
                                     "Time for which the cue says whether the answer was right."),
      boolean<&AnglesParams::stereo>(
          "stereo", "Stereo",
          "Whether the view has stereo, where the host does not say; told with the metrics, changes nothing else."),
      real<&AnglesParams::max_bias>("max_bias", "Bias", "rad", "deg", 0.5 * kDegree, 60 * kDegree,
                                    "The attempt fails when the bias is greater than this on either axis.")
          .group("Limits"),
      real<&AnglesParams::max_jnd>("max_jnd", "Just-noticeable difference", "rad", "deg", 0.5 * kDegree, 60 * kDegree,
                                   "The attempt fails when the just-noticeable difference is greater than this on either axis.")
          .group("Limits"),
      real<&AnglesParams::par_time>(
          "par_time", "Par time", "s", "s", 0.1, 3600,
          "Up to here no points are lost for time; twice this costs all that time can cost.")
          .group("Limits"),
      real<&AnglesParams::max_time>("max_time", "Time limit", "s", "s", 1, 36000,
                                    "The attempt fails when it is over.")
          .group("Limits"),
  };

  void build(const AnglesParams& params, LessonBuilder& builder) override;
  void bind(const Scene& scene, Binder& binder) override;
  void activate(double dt_s) override;
  void observe(const View& view, const Verdict& verdict, std::span<double> state) override;
  void reset(std::span<double> state) override { as<Memory>(state) = {}; }

 private:
  /// Normal of the reference, and the two axes of a lean; unit, W.
  struct Frame {
    Vec3 square = Vec3::UnitZ(), axis[kAxes];
  };
  bool see(const View& view, Frame& frame, Vec3& up_W) const;
  void show(const Memory& memory, const Finding& finding, const Frame& frame, const Verdict& verdict) const;
  void say(const Memory& memory, const Finding& finding, const Verdict& verdict) const;
  void report(const Memory& memory, const Finding& finding, double time_s, const Verdict& verdict) const;

  AnglesParams params_;
  Judge judge_;
  bool stereo_ = false;  // from the host, or from the lesson file where the host does not know
  Peer gripper_, assistant_, needle_, tissue_;
  uint32_t gripper_object_ = kNone, assistant_object_ = kNone, needle_object_ = kNone, tissue_object_ = kNone;
  Mark point_, one_, other_;
  Metric metric_[static_cast<size_t>(Measure::kCount)];
  Cue cue_[static_cast<size_t>(Sign::kCount)];
  Phase phase_[4];   // by Stage
  Event failed_[5];  // by End
  Event answered_;
};

}  // namespace swage::lesson_angles
