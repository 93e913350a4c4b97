// SPDX-License-Identifier: Apache-2.0
//
// swage.object.tissue: a patch of wall that can be touched, dented and pierced. Model, levels and limits: tissue.md.
#pragma once

#include <swage/object.hpp>
#include <swage/units.hpp>

#include "compliance.hpp"
#include "mesh.hpp"
#include "slit_edges.hpp"
#include "wall.hpp"

namespace swage::tissue {

enum class Level : int { kPlane, kCompliant, kMesh };
enum class Touched : int { kStrips, kSmooth };

struct TissueParams {
  Level level = Level::kPlane;
  Form form = Form::kFlat;
  std::array<double, 2> size{12e-3, 10e-3};  // m
  double thickness = 1e-3;                   // m
  double backing = 1e-3;                     // m
  double slope = 30 * kDegree;               // rad
  double wave_height = 1e-3;                 // m
  double wave_length = 8e-3;                 // m
  double radius = 8e-3;                      // m
  std::string heights;
  Touched touched = Touched::kStrips;
  double slit = 0;           // m
  double edge_stiffness = 0;  // N/m
  double mount_stiffness = 0;    // N/m
  double mount_travel = 0.2e-3;  // m
  double mount_mass = 50e-6;     // kg
  double stiffness = 100;    // N/m
  double stiffening = 5000;  // N/m2
  double young = 1e6;        // Pa
  double relaxed = 0.6;
  double relaxation_time = 0.5;  // s
  double spread = 50e-6;         // m
  double skin = 0;               // m
  double skin_young = 5e6;       // Pa
  Underside underside = Underside::kFree;
  int cells = 16;
  int refinement = 5;
  double friction = 0.2;
  double puncture_force = 20e-3;   // N
  double cutting_force = 8e-3;     // N
  double drag = 5;                 // N/m
  double side_stiffness = 1e6;     // N/m2
  double failure_stress = 0.42e6;  // Pa
};

/// A source of displacement of the wall: a place that bears or bore a force. Places in O, on the surface; components along
/// n, 1, 2 there.
struct Source {
  double p[3];            // m, place to which the creep memory belongs
  double v[3];            // N, creep memory: displacement is C (f + v)
  double q[3], f[3];      // m, N, place and force of this step: the place moves with the contact
  double q_old[3], w[3];  // m, N, place and force of the step before
};

class Tissue final : public Object<TissueParams>,
                     public Solid,
                     public Pierceable,
                     public Solver,
                     public Surface,
                     public Drawing {
 public:
  static constexpr auto id = "swage.object.tissue";
  static constexpr auto version = "1.0.0";
  static constexpr auto name = "Tissue";
  static constexpr auto summary =
      "Patch of wall to be pierced: flat, sloping, wavy, cylindrical or from a table; rigid, a "
      "viscoelastic half space or finite elements, small strains.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const char* kLevels[] = {"plane", "compliant", "mesh", nullptr};
  static constexpr const char* kTouched[] = {"strips", "smooth", nullptr};
  static constexpr const char* kUndersides[] = {"free", "held", nullptr};
  static constexpr const char* kForms[] = {"flat",     "left slope", "right slope", "waves",
                                           "cylinder", "table",      nullptr};
  static constexpr std::array fields = {
      choice<&TissueParams::level>(
          "level", "Level", kLevels,
          "Plane: the surface stands still. Compliant: it yields and relaxes as if the "
          "wall had no end. Mesh: as this wall does, with its rim and underside."),
      choice<&TissueParams::form>("form", "Form", kForms, "Of the entry surface."),
      vector<&TissueParams::size>("size", "Size", "m", "mm", 1e-3, 100e-3, "Of the patch along x and y."),
      real<&TissueParams::thickness>("thickness", "Thickness", "m", "mm", 0.05e-3, 20e-3, "Of the wall."),
      real<&TissueParams::backing>("backing", "Backing", "m", "mm", 0, 20e-3,
                                   "How much deeper than the wall things that press on it are held. With 0 "
                                   "its far side can be reached, and "
                                   "what is pressed in by half the thickness falls through."),
      real<&TissueParams::slope>("slope", "Slope", "rad", "deg", 0, 60 * kDegree, "Of the sloping forms."),
      real<&TissueParams::wave_height>("wave_height", "Wave height", "m", "mm", 0, 10e-3, "Crest to trough."),
      real<&TissueParams::wave_length>("wave_length", "Wave length", "m", "mm", 1e-3, 100e-3,
                                       "Crest to crest."),
      real<&TissueParams::radius>("radius", "Radius", "m", "mm", 1e-3, 1, "Of the cylinder."),
      file<&TissueParams::heights>(
          "heights", "Table of heights",
          "Text file for the form table: nx ny, then ny rows of nx heights in metres."),
      choice<&TissueParams::touched>("touched", "Touched as", kTouched,
                                     "Curved forms. Strips: anything touches them, and what dents the wall beside a border between two may slide away. Smooth: for "
                                     "needles and threads; rigid bodies go through down to half the backing. Not with a slit, nor without a backing."),
      real<&TissueParams::slit>("slit", "Slit", "m", "mm", 0, 5e-3,
                                "Width of a gap along y through the middle: two wound edges; 0 for none."),
      real<&TissueParams::edge_stiffness>("edge_stiffness", "Edge stiffness", "N/m", "N/m", 0, 1e5,
                                          "Of each edge of the slit against being drawn to the other one, levels compliant and mesh; 0: the "
                                          "edges stand still."),
      real<&TissueParams::mount_stiffness>("mount_stiffness", "Mount stiffness", "N/m", "N/m", 0, 1e5,
                                           "Of the whole patch against being drawn along x, as one edge of a wound towards the other, level "
                                           "plane; 0: it stands still.")
          .group("Mount"),
      real<&TissueParams::mount_travel>("mount_travel", "Mount travel", "m", "mm", 1e-6, 5e-3,
                                        "How far the patch goes along +x, to where it meets the other one.")
          .group("Mount"),
      real<&TissueParams::mount_mass>("mount_mass", "Mount mass", "kg", "g", 1e-7, 0.1, "Of what moves.").group("Mount").hidden(),
      real<&TissueParams::stiffness>("stiffness", "Stiffness", "N/m", "N/m", 1, 1e6,
                                     "Force per overlap of one touching place, level plane.")
          .group("Touch"),
      real<&TissueParams::stiffening>("stiffening", "Stiffening", "Pa", "Pa", 0, 1e9,
                                      "How that stiffness grows with the overlap.")
          .group("Touch"),
      real<&TissueParams::friction>("friction", "Friction", "1", "1", 0, 3,
                                    "Coulomb coefficient, on the surface and inside.")
          .group("Touch"),
      real<&TissueParams::young>("young", "Young's modulus", "Pa", "kPa", 1e3, 1e8,
                                 "At once, levels compliant and mesh. Arteries have 27 to 2700 kPa.")
          .group("Elasticity"),
      real<&TissueParams::relaxed>("relaxed", "Share left", "1", "1", 0.05, 1,
                                   "Of the modulus after relaxation; 1 is purely elastic.")
          .group("Elasticity"),
      real<&TissueParams::relaxation_time>("relaxation_time", "Relaxation time", "s", "s", 1e-3, 1e3,
                                           "Of the standard linear solid.")
          .group("Elasticity"),
      real<&TissueParams::spread>("spread", "Spread", "m", "um", 1e-6, 5e-3,
                                  "Radius over which a touch spreads: that of the wire.")
          .group("Elasticity"),
      real<&TissueParams::skin>("skin", "Skin", "m", "um", 0, 2e-3,
                                "Thickness of a stiffer layer on top; 0 for none.")
          .group("Elasticity"),
      real<&TissueParams::skin_young>("skin_young", "Young's modulus of the skin", "Pa", "kPa", 1e3, 1e9,
                                      "Of that layer.")
          .group("Elasticity"),
      choice<&TissueParams::underside>(
          "underside", "Underside", kUndersides,
          "Of the wall, level mesh: free as a flap's, or held as by what it lies on.")
          .group("Mesh"),
      integer<&TissueParams::cells>(
          "cells", "Cells", 8, 24,
          "Coarse ones along the longer side, level mesh; evened, so that they are the "
          "same on both sides of the middle.")
          .group("Mesh"),
      integer<&TissueParams::refinement>(
          "refinement", "Refinement", 3,
          6, "How often the cells around a touch are halved, level mesh. Costs nothing in a step.")
          .group("Mesh"),
      real<&TissueParams::puncture_force>(
          "puncture_force", "Puncture force", "N", "mN", 0, 10,
          "Normal force at which a sharp point goes in perpendicular to the surface.")
          .group("Piercing"),
      real<&TissueParams::cutting_force>("cutting_force", "Cutting force", "N", "mN", 0, 10,
                                         "Against a point that goes on through tissue.")
          .group("Piercing"),
      real<&TissueParams::drag>("drag", "Drag", "N/m", "N/m", 0, 1e4,
                                "Against the needle, per inserted length.")
          .group("Piercing"),
      real<&TissueParams::side_stiffness>("side_stiffness", "Side stiffness", "Pa", "kPa", 1e2, 1e9,
                                          "Across the needle, per inserted length.")
          .group("Piercing"),
      real<&TissueParams::failure_stress>("failure_stress", "Failure stress", "Pa", "kPa", 1e2, 1e9,
                                          "Mean pressure of the needle's side at which the tissue tears. "
                                          "Arteries of the brain have 420 kPa and more.")
          .group("Piercing"),
  };

  void build(const TissueParams& params, ObjectBuilder& builder) override;
  void activate(double dt_s) override;
  void forces(const Step& step) override;
  void finish(const Step& step) override;
  void reset(const Step& step) override;

  void law(const Step& step, swage_pierceable_law& out) override;
  void locate(const Step& step, swage_vec3 p_W, swage_pierceable_place& out) override;

  void advance(const Step& step) override;
  void mobility(const Step& step, std::span<const swage_contact_point> points, double* v_free,
                  double* W) override;
  void displacement(const Step& step, std::span<const swage_contact_point> points, double* u_W) override;
  void apply_impulses(const Step& step, std::span<const swage_contact_point> points, const double* impulse) override;
  void draw(const Step& step, Visuals& out) override;

 private:
  static constexpr uint32_t kSources = 32;  // largest number of sources; when full, the weakest is replaced
  static constexpr uint32_t kPoints = 64;   // contact points of one step that are cached from mobility() to apply_impulses()
  struct State {
    Source source[kSources];
  };
  /// State of a slit whose edges move: forces on each along O's x axis, in this step and in the one before.
  struct SlitState {
    State sources;         // first member: the state is also read as a State
    SlitEdges::Pair f, w;  // N
  };
  /// A place on the surface, in O, and its axes n, 1, 2 in W.
  struct Spot {
    Vec3 foot_O = Vec3::Zero();
    Mat3 axes_W = Mat3::Identity();
  };
  /// Cache of the last query: the same points are queried about three times in a step, and those of a track stay
  /// where they are from step to step. Results do not depend on the cache.
  struct Asked {
    uint32_t n = 0;
    toolkit::Pose X_WO;
    toolkit::Frame F_WO;
    std::array<swage_vec3, kPoints> p_W{};
    std::array<Spot, kPoints> spot;
    std::array<Mesh::Place, kPoints> place;       // level mesh
    std::array<bool, kPoints> related{}, felt{};  // whether C_W, and creep and gone, are valid for this point
    std::vector<Mat3> C_W;                        // kPoints x kPoints, m/N
    std::array<Vec3, kPoints> creep;              // m, along n, 1, 2: displacement by the creep memory
    std::array<Vec3, kPoints> gone;               // m, displacement by the forces of the step before
    std::vector<Mat3> response;                   // compliances of the mesh
    std::vector<Mesh::Load> load;
  };

  bool yields() const { return params_.level != Level::kPlane; }
  // m, depth of the hinge below a patch that moves as a whole: it moves almost straight, with 4 mrad of tilt for 0.2 mm
  static constexpr double kMountArm = 50e-3;
  bool mounted() const { return params_.mount_stiffness > 0; }
  void build_body(const TissueParams& params, ObjectBuilder& builder);
  /// Half of the wall in which a spot lies: 0 left of the slit, 1 right of it.
  static size_t half(const Spot& spot) { return spot.foot_O.x() < 0 ? 0 : 1; }
  void add_surface(const TissueParams& params, ObjectBuilder& builder);
  bool smooth() const { return params_.touched == Touched::kSmooth && params_.form > Form::kRightSlope && params_.slit == 0; }
  void add_smooth_surface(const TissueParams& params, ObjectBuilder& builder);
  void add_piece(const Wall::Piece& piece, uint32_t flags, ObjectBuilder& builder);
  MeshSpec mesh_spec(const TissueParams& params) const;
  Spot spot(const toolkit::Frame& X_WO, const Vec3& foot_O) const;
  Mesh::Place place(const Vec3& foot_O) const { return mesh_.place(wall_.laid_flat(foot_O.x()), foot_O.y()); }
  uint32_t look_up(const Step& step, std::span<const swage_contact_point> points);
  void relate(uint32_t n);
  void feel(const State& state, uint32_t n);
  void feel_mesh(const State& state, uint32_t n);
  Vec3 displaced(const State& state, const Vec3& foot_O);
  Mat3 own(const Vec3& foot_O) const;
  void add_edges(const Step& step, uint32_t n, size_t stride, double* v_free, double* W);
  uint32_t source_at(State& state, const std::array<double, kSources>& size, const Vec3& foot_O) const;
  void creep_in(double dt);
  /// Frame of the wall; when it has changed, the cache is cleared.
  const toolkit::Frame& frame(const Step& step);

  TissueParams params_;
  Wall wall_;
  Compliance compliance_;
  Mesh mesh_;
  Creep creep_;
  double creep_dt_ = 0;  // s, step or substep for which creep_ holds
  Asked asked_;
  Body body_;
  Hinge mount_;
  SlitEdges edges_;
  Signal dimple_, force_, gap_, shift_;
};

}  // namespace swage::tissue
