// SPDX-License-Identifier: Apache-2.0
//
// swage.device.skilled: a hand with eyes that carries out a plan in the present scene. See skilled.md.
#pragma once

#include <swage/sight.hpp>
#include <swage/strand.hpp>

#include <string>
#include <vector>

#include "hand/tremor.hpp"
#include "plan.hpp"
#include "wire.hpp"
#include "wrist.hpp"

namespace swage::skilled {

inline constexpr double kMaxLean = 1.4835298641951802;  // 85 deg
inline constexpr double kDegree = 0.017453292519943295;  // rad

enum class WhoseWrist : int { kNone, kRight, kLeft };

struct SkilledParams {
  std::string file;
  std::string gripper = "holder", needle = "needle", grasp;
  double speed = 1;
  double tremor = 0;               // m
  Interval tremor_band = {8, 12};  // Hz
  double spot_error = 0;           // m
  double aim_error = 0;            // m
  double lean = 0, side_lean = 0;  // rad
  double pivot_error = 0;          // m
  double angle_bias = 0;           // rad
  double angle_noise = 0;          // rad
  double guesses = 0;              // 1
  double steady = 0;               // s, time in which a drive corrects a needle that has moved from its place of entry; 0: no correction
  WhoseWrist wrist = WhoseWrist::kNone;
  std::array<double, 3> forearm = {-0.7, 0.7, 0};
  double swing = 60 * kDegree;  // rad
  double hold = 90 * kDegree;   // rad
  double ease = 0.65;           // 1
  Interval rotation = {-80 * kDegree, 80 * kDegree}, flexion = {-70 * kDegree, 80 * kDegree},
           deviation = {-20 * kDegree, 30 * kDegree};  // rad
};

class Skilled final : public SeeingDevice<SkilledParams> {
 public:
  static constexpr auto id = "swage.device.skilled";
  static constexpr auto version = "1.2.0";
  static constexpr auto name = "Skilled hand";
  static constexpr auto summary =
      "Carries out a plan (reach, close, aim, drive, wind ...) on the scene as it is; sees where needle and target "
      "are. "
      "Human flaws can be added.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";
  static constexpr DeviceCard card{.flags = SWAGE_DEVICE_LOCKSTEP | SWAGE_DEVICE_WORLD | SWAGE_DEVICE_SCRIPTED};

  static constexpr const char* kWrists[] = {"none", "right", "left", nullptr};
  static constexpr std::array fields = {
      file<&SkilledParams::file>("file", "Plan", "File of acts, format swage-plan/1.").required(),
      text<&SkilledParams::gripper>("gripper", "Gripper", "The object that this hand leads."),
      text<&SkilledParams::needle>("needle", "Needle", "What it grasps: anything graspable."),
      text<&SkilledParams::grasp>("grasp", "Grasp", "Name of the grasp coupling whose force it feels; empty: the first one."),
      real<&SkilledParams::speed>("speed", "Speed", "1", "1", 0.05, 20,
                                  "1 takes the times of the plan, 2 half of them."),
      real<&SkilledParams::steady>(
          "steady", "Steady", "s", "s", 0, 10,
          "In this time a drive brings back a needle that it sees leave the place where it went in; eyes and "
          "hand take 0.2 s. 0: it does not look."),
      real<&SkilledParams::tremor>(
          "tremor", "Tremor", "m", "um", 0, 2e-3,
          "Root mean square of the shaking, as a length in the scene. Eye surgeons at work: "
          "about 38 um.")
          .group("Flaws"),
      interval<&SkilledParams::tremor_band>("tremor_band", "Tremor band", "Hz", "Hz", 0.1, 100,
                                            "Lowest and highest frequency of the shaking.")
          .group("Flaws"),
      real<&SkilledParams::spot_error>(
          "spot_error", "Spot error", "m", "um", 0, 5e-3,
          "Root mean square of a distance along the needle by which each grasp misses its "
          "place; drawn anew for each.")
          .group("Flaws"),
      real<&SkilledParams::aim_error>(
          "aim_error", "Aim error", "m", "um", 0, 5e-3,
          "Root mean square of the distance by which the point misses its mark, across the "
          "way in; drawn anew for each aim.")
          .group("Flaws"),
      real<&SkilledParams::lean>(
          "lean", "Lean", "rad", "deg", -kMaxLean, kMaxLean,
          "Every aim is off by this angle, in the plane of the needle: how wrongly it judges angles.")
          .group("Flaws"),
      real<&SkilledParams::side_lean>(
          "side_lean", "Sideways lean", "rad", "deg", -kMaxLean, kMaxLean,
          "Every aim is off by this angle, out of the plane of the needle: what presses on the point then twists the needle in loose jaws.")
          .group("Flaws"),
      real<&SkilledParams::pivot_error>(
          "pivot_error", "Pivot error", "m", "um", -5e-3, 5e-3,
          "It drives the needle about a centre that is this much too far from the needle: "
          "how wrongly it judges the curve.")
          .group("Flaws"),
      real<&SkilledParams::angle_bias>(
          "angle_bias", "Angle bias", "rad", "deg", -kMaxLean, kMaxLean,
          "What it sees as upright leans by this angle the other way, in each answer.")
          .group("Flaws"),
      real<&SkilledParams::angle_noise>(
          "angle_noise", "Angle noise", "rad", "deg", 0, kMaxLean,
          "Root mean square of the angle by which it misjudges a lean; drawn anew for each answer.")
          .group("Flaws"),
      real<&SkilledParams::guesses>("guesses", "Guesses", "1", "%", 0, 1, "Share of its choices that are made at random.").group("Flaws"),
      choice<&SkilledParams::wrist>("wrist", "Wrist", kWrists,
                                    "Whose arm leads the tool while it aims and drives; none: it turns as far as it likes.")
          .group("Wrist"),
      vector<&SkilledParams::forearm>("forearm", "Forearm", "1", "1", -1, 1,
                                      "Direction from elbow to hand where the arm rests, in the world.")
          .group("Wrist"),
      real<&SkilledParams::swing>("swing", "Swing", "rad", "deg", 0, 120 * kDegree,
                                  "The shoulder turns the forearm about the vertical by so much to either side, free of cost.")
          .group("Wrist"),
      real<&SkilledParams::hold>(
          "hold", "Hold", "rad", "deg", -180 * kDegree, 180 * kDegree,
          "How the tool lies in the fingers: from the thumb's side of the hand to the closing direction, as a supination.")
          .group("Wrist"),
      real<&SkilledParams::ease>("ease", "Ease", "1", "%", 0.05, 1,
                                 "Share of each range within which a posture costs nothing; 100 %: up to its end.")
          .group("Wrist"),
      interval<&SkilledParams::rotation>("rotation", "Forearm rotation", "rad", "deg", -180 * kDegree, 180 * kDegree,
                                         "Greatest pronation (negative) and supination.")
          .group("Wrist"),
      interval<&SkilledParams::flexion>("flexion", "Flexion", "rad", "deg", -120 * kDegree, 120 * kDegree,
                                        "Greatest extension (negative) and flexion.")
          .group("Wrist"),
      interval<&SkilledParams::deviation>("deviation", "Deviation", "rad", "deg", -90 * kDegree, 90 * kDegree,
                                          "Greatest radial (negative) and ulnar deviation.")
          .group("Wrist"),
  };

  void build(const SkilledParams& params, DeviceBuilder& builder) override;
  void bind(const Scene& scene, std::span<const swage_scene_mark> marks) override;
  void look(const Sight& sight) SWAGE_RT override;
  void exchange(const swage_command& command, swage_sample& sample) override;

 private:
  /// Objects, marks and signals of an act, by index.
  struct Seeks {
    uint32_t mark = kNone, other = kNone, tissue = kNone, thing = kNone;
    std::vector<uint32_t> among;
    Peer tissue_peer, thing_peer;
    Signal signal;
  };
  /// Observed values of this step.
  struct Seen {
    Wire wire;
    bool wire_good = false;
    Vec3 strand_W = Vec3::Zero();  // m, place of the thread that the hand reaches for
    bool strand_good = false;
    double force = 0;              // N
    double signal = 0;             // awaited signal, SI
    Vec3 aside_W = Vec3::Zero();   // m, from the place of entry of the needle to its present crossing
    Vec3 mark_W = Vec3::Zero();    // m, mark of the act in progress
    Vec3 other_W = Vec3::Zero();   // m
    std::vector<Vec3> among_W;     // m, marks of a choice in progress
    Vec3 up_W = Vec3::UnitZ();     // unit, of the object to be judged: from its point or tips to its other end
    Vec3 into_W = -Vec3::UnitZ();  // unit
    Vec3 tip_W = Vec3::Zero(), axis_W = Vec3::UnitX();  // m, tips of the other gripper; unit, its direction from hinge to tips
  };

  void look_at_needle(const View& scene);
  void look_at_hole(const View& scene);
  void look_at_strand(const View& scene, const Act& act);
  void restart();
  void begin_act(double time_s);
  Vec3 answer();
  Vec3 choose();
  void set_goal(const Act& act);
  Pose reach_goal(const Act& act) const;
  Pose lead(const Act& act, const Vec3& target_W, const Vec3& into_W);
  Pose show_goal(const Act& act);
  Pose driven(double u) const;
  Pose wound(const Act& act, double u) const;
  void feel(const Act& act, double dt);
  void draw(const Act& act, double share);
  Vec3 side(const Act& act, const Vec3& into_W) const;
  Quat turned_to(const Vec3& into_W, const Vec3& across_W) const;
  bool has_wrist() const { return params_.wrist != WhoseWrist::kNone; }
  void build_wrist(DeviceBuilder& builder);
  uint32_t find_mark(std::span<const swage_scene_mark> marks, const std::string& meaning) const;
  bool cannot_see(const std::string& meaning, const std::string& where);
  bool find_marks(std::span<const swage_scene_mark> marks, size_t i, const std::string& where);
  bool find_things(const Scene& scene, size_t i, const std::string& where);
  bool find_signals(const Scene& scene, size_t i, const std::string& where);
  bool waits(const Act& act) const;
  bool has_come(const Act& act) const;
  void follow_act(const Act& act, double share, double rate, double dt);
  double normal();

  SkilledParams params_;
  Plan plan_;
  std::vector<Seeks> seeks_;
  hand::Tremor tremor_;
  uint32_t gripper_ = kNone, needle_ = kNone;
  Peer needle_peer_;
  StrandPeer strand_;  // the needle object, where it is a thread
  Signal force_;
  struct Hole {
    Signal s, entry[3],
        at[3];  // of a coupling that pierces: present crossing of the needle with the surface, and place of entry
    bool valid() const { return s.valid(); }
  } hole_;

  Seen seen_;
  size_t act_ = 0;
  double last_s_ = -1, act_began_s_ = 0;  // s, simulated
  bool drawn_ = false, fresh_ = true;     // fresh: the act in progress has not set its goal yet
  Pose from_, goal_, now_;                // X_WT
  Wrist wrist_;
  Quat asked_ = Quat::Identity();  // q_WT that the wrist was asked for when the act in progress began
  double from_closure_ = 0, closure_ = 0;
  Vec3 turn_centre_W_ = Vec3::Zero(), turn_W_ = Vec3::Zero();
  Vec3 lift_W_ = Vec3::Zero();     // m, height of the last aim above its mark
  double lowered_ = 0;             // share of a drive's path after which the lift is zero
  Vec3 brought_W_ = Vec3::Zero();  // m, by how much this drive has brought the needle back
  Vec3 about_W_ = Vec3::Zero(), about_axis_W_ = Vec3::UnitX();  // m, unit: axis of this winding
  double radius_ = 0;              // m, of this winding
  double outwards_ = 0, way_ = 0, pace_ = 1;  // m/s, its change; the way that it went last, 1 outwards; share of its speed
  double drawn_share_ = 0;         // share of the path of this draw
  Vec3 shown_W_ = Vec3::Zero();    // m, the mark that was last shown
  double missed_m_ = 0;            // m, error along the needle, of this reach
  Vec3 missed_W_ = Vec3::Zero();   // m, error of this aim
};

}  // namespace swage::skilled
