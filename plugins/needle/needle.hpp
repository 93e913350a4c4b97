// SPDX-License-Identifier: Apache-2.0
//
// swage.object.needle: a circular-arc needle of true micro size, rigid or bending with plasticity. Model and limits are in
// needle.md.
#pragma once

#include <swage/environment.hpp>
#include <swage/object.hpp>
#include <swage/wire.hpp>

#include "bending.hpp"
#include "form.hpp"

namespace swage::needle {

enum class Level : int { kRigid, kBending, kReference };
enum class Circle : int { kModel, kQuarter, kThreeEighths, kHalf, kFiveEighths, kTwoEighths, kFourEighths, kStraight };
enum class SizeOf : int { kModel, kChord, kLength };

/// Parameters that are 0 or `kModel` take the model's value.
struct NeedleParams {
  std::string model;
  Level level = Level::kRigid;
  Circle arc = Circle::kModel;
  SizeOf size_of = SizeOf::kModel;
  double size = 0;            // m
  double wire_diameter = 0;   // m
  double taper_length = 0;    // m
  double flattening = 0;      // 1
  double swage_length = 0;    // m
  double density = 0;         // kg/m3
  double youngs_modulus = 0;  // Pa
  double yield_stress = 0;    // Pa
  double hardening = 0;       // 1
  double break_strain = 0;    // 1
  int pieces = 12;
};

class Needle final : public Object<NeedleParams>,
                     public Solid,
                     public Graspable,
                     public Piercing,
                     public Solver,
                     public Wire {
 public:
  static constexpr auto id = "swage.object.needle";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Suture needle";
  static constexpr auto summary =
      "Needle of round or flattened wire, straight or bent to a quarter to five eighths of a circle; rigid, or bending "
      "elastically, for good, and until it breaks.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr std::array traits = {SWAGE_TRAIT_WIRE};
  static constexpr const char* kLevels[] = {"rigid", "bending", "reference", nullptr};
  static constexpr const char* kCircles[] = {"model", "1/4", "3/8", "1/2", "5/8", "2/8", "4/8", "straight", nullptr};
  static constexpr const char* kSizes[] = {"model", "chord", "length", nullptr};
  static constexpr std::array fields = {
      file<&NeedleParams::model>(
          "model", "Model",
          "Needle of the library: \"micro_100.json\" and others that come with the plugin, or a file of your "
          "own. Without one: 3/8 of a circle, 5 mm chord, 100 um wire."),
      choice<&NeedleParams::level>("level", "Level", kLevels,
                                   "How much it bends: not at all; as a chain of arcs with plastic joints; "
                                   "the same, four times as fine "
                                   "and not in real time."),
      choice<&NeedleParams::arc>("arc", "Arc", kCircles, "Share of a full circle that the needle spans. Straight: the simplified needle to begin with."),
      choice<&NeedleParams::size_of>(
          "size_of", "Size is the", kSizes,
          "What the size measures: the chord from point to swage, or the length of the arc."),
      real<&NeedleParams::size>("size", "Size", "m", "mm", 0, 50e-3,
                                "Chord or length of the centre line. 0: as the model says."),
      real<&NeedleParams::wire_diameter>(
          "wire_diameter", "Wire diameter", "m", "um", 0, 1e-3,
          "Diameter of the body before flattening. Micro-needles have 50 to 150 um. 0: as the model says."),
      real<&NeedleParams::taper_length>(
          "taper_length", "Taper", "m", "mm", 0, 20e-3,
          "Length from the point over which the wire grows thicker. 0: as the model says.")
          .group("Wire"),
      real<&NeedleParams::flattening>(
          "flattening", "Flattening", "1", "1", 0, 1,
          "Thickness in the plane of the needle over its width; 1 is round. 0: as "
          "the model says.")
          .group("Wire"),
      real<&NeedleParams::swage_length>(
          "swage_length", "Swage", "m", "mm", 0, 5e-3,
          "Length at the end that is drilled for the thread. 0: as the model says.")
          .group("Wire"),
      real<&NeedleParams::density>(
          "density", "Density", "kg/m3", "kg/m3", 0, 25000,
          "Of the wire. Surgical steel has 7700 to 8000 kg/m3. 0: as the model says.")
          .group("Material")
          .hidden(),
      real<&NeedleParams::youngs_modulus>("youngs_modulus", "Young's modulus", "Pa", "GPa", 0, 1e12,
                                          "Of the wire. Steel has about 195 GPa. 0: as the model says.")
          .group("Material")
          .hidden(),
      real<&NeedleParams::yield_stress>("yield_stress", "Yield stress", "Pa", "MPa", 0, 10e9,
                                        "At which the outer fibre begins to flow: 800 MPa for soft, 2000 MPa "
                                        "for the hardest wire. 0: as the "
                                        "model says.")
          .group("Material"),
      real<&NeedleParams::hardening>(
          "hardening", "Hardening", "1", "1", 0, 0.5,
          "Slope of stress over strain beyond yield, as a share of Young's modulus. 0: as the model says.")
          .group("Material")
          .hidden(),
      real<&NeedleParams::break_strain>(
          "break_strain", "Strain to break", "1", "1", 0, 100,
          "Plastic strain of the outer fibre, summed over all bending to and fro, at which it breaks. 0: as "
          "the model says.")
          .group("Material")
          .hidden(),
      integer<&NeedleParams::pieces>("pieces", "Pieces", 2, 24, "Arcs that a bending needle is made of.")
          .group("Material")
          .hidden(),
  };

  void build(const NeedleParams& params, ObjectBuilder& builder) override;
  void reset(const Step& step) override;
  void forces(const Step& step) override;
  void advance(const Step& step) override;
  void mobility(const Step& step, std::span<const swage_contact_point> points, double* v_free,
                  double* W) override;
  void apply_impulses(const Step& step, std::span<const swage_contact_point> points, const double* impulse) override;
  void finish(const Step& step) override;
  void wire_end(const Step& step, swage_wire_end& out) override;
  const void* extension(std::string_view wanted) override;
  void locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) override;
  void place(const Step& step, double s, swage_piercing_place& out) override;
  void nearest(const Step& step, swage_vec3 p_W, swage_piercing_place& out) override;

 private:
  /// A piece of the wire that is one arc: its circle frame in W, and the share of the wire that it covers.
  struct Stretch {
    toolkit::Frame X_WA;
    Vec3 middle_W = Vec3::Zero();  // m; of the middle, if it bends
    swage_pose known{};            // pose of its body to which these two belong
    Arc arc;
    double s0 = 0, s1 = 1;
    uint32_t body = 0;
  };
  /// A place of the wire, relative to its stretch.
  struct Found {
    const Stretch* wire = nullptr;
    ArcPlace place;
    double s() const { return wire->s0 + (wire->s1 - wire->s0) * place.s; }
    Vec3 p_W() const { return wire->X_WA * place.p; }
    Vec3 tangent_W() const { return wire->X_WA.turn(place.tangent); }
  };
  void divide();
  const Stretch& stretch(const Step& step, int piece);
  static Found nearest_on(const Stretch& wire, const Vec3& p_W);
  Found find_nearest(const Step& step, const Vec3& p_W);
  void tell(const Found& found, swage_piercing_place& out) const;
  bool read_form(const NeedleParams& params, ObjectBuilder& builder);
  void build_bending(int pieces, const toolkit::Pose& X_OB, ObjectBuilder& builder);
  bool bends() const { return bending_.pieces() > 0; }

  Form form_;
  double mass_ = 0;                  // kg
  Vec3 inertia_ = Vec3::Zero();      // kg m2, about the centre of mass, in B
  swage_environment environment_{};  // medium of the lesson
  Arc arc_;
  Vec3 centre_B_ = Vec3::Zero();                      // of the circle, m
  toolkit::Quat turn_B_ = toolkit::Quat::Identity();  // of the circle frame
  Body body_;
  Bending bending_;
  std::array<Stretch, toolkit::BentWire::kMaxPieces> wire_;  // only the first of a rigid needle
  Signal stress_, bend_, damage_, broken_;
};

}  // namespace swage::needle
