// SPDX-License-Identifier: Apache-2.0
//
// swage.object.thread: a suture that hangs, bends, twists, touches, is held and breaks. Model and limits: thread.md.
#pragma once

#include <swage/band.hpp>
#include <swage/cut.hpp>
#include <swage/environment.hpp>
#include <swage/strand.hpp>
#include <swage/units.hpp>

#include <string>
#include <utility>
#include <vector>

#include "lengths.hpp"
#include "masses.hpp"
#include "suture.hpp"
#include "toolkit/rod.hpp"

namespace swage::thread {

enum class Level : int { kThesis, kCatenary, kRod, kReference };
enum class Start : int { kStraight, kHanging, kCoil, kPath, kNodes };
enum class End : int { kFree, kFixed };
enum class Around : int { kLesson, kAir, kWater };

struct ThreadParams {
  std::string suture;
  Level level = Level::kRod;
  Start start = Start::kStraight;
  double length = 20e-3;  // m
  int segments = 32;
  double finer = 1, fine_from = 0, fine_to = 0;  // times; m
  double coil_radius = 3e-3;  // m
  std::string path, paths;
  int shape = 0;
  End first = End::kFree, last = End::kFree;
  Around around = Around::kLesson;
  // of the material; 0, of the memory below 0: as the suture says
  double diameter = 0;   // m
  double young = 0;      // Pa
  double poisson = -1;
  double density = 0;    // kg/m3
  double memory = -1;    // 1/m
  double strength = 0;   // N
  double pull_off = 0;   // N
  double yield = -1, hardening = -1;
};

class Thread final : public BandedObject<ThreadParams>, public Solid, public Graspable, public Strand, public StrandNodes, public StrandLine, public Cuttable {
 public:
  static constexpr auto id = "swage.object.thread";
  static constexpr auto version = "1.1.0";
  static constexpr auto name = "Thread";
  static constexpr auto summary =
      "A suture: a thin elastic rod that stretches, bends and twists, in air or under water; touches, is held, and "
      "breaks where it is pulled too hard.";
  static constexpr auto author = "Swage";
  static constexpr auto licence = "Apache-2.0";

  static constexpr const char* kLevels[] = {"thesis", "catenary", "rod", "reference", nullptr};
  static constexpr const char* kStarts[] = {"straight", "hanging", "coil", "path", "nodes", nullptr};
  static constexpr const char* kEnds[] = {"free", "fixed", nullptr};
  static constexpr const char* kAround[] = {"lesson", "air", "water", nullptr};
  static constexpr std::array fields = {
      file<&ThreadParams::suture>("suture", "Suture",
                                  "Suture of the library: \"nylon_10_0.json\" and others that come with the plugin, or a "
                                  "file of your own. Without one: 10-0 nylon that has lain straight."),
      choice<&ThreadParams::level>("level", "Level", kLevels,
                                   "Point masses and springs, moved explicitly and not in real time; a chain that stretches and does not "
                                   "bend; a rod that bends and twists; the same, four times as fine and not in real time."),
      choice<&ThreadParams::start>("start", "Start shape", kStarts,
                                   "Straight along x, hanging along -z, or a coil about z, from the origin; along a path; or with each node at its point of the path."),
      real<&ThreadParams::length>("length", "Length", "m", "mm", 1e-3, 0.3, "Unloaded."),
      integer<&ThreadParams::segments>("segments", "Segments", 4, 200, "Straight pieces."),
      real<&ThreadParams::finer>("finer", "Finer", "1", "1", 1, 20,
                                 "How many times shorter than elsewhere the segments of a part of the thread are, as of a knot or beside a swage. 1: all are of one length."),
      real<&ThreadParams::fine_from>("fine_from", "Finer from", "m", "mm", 0, 0.3, "Where that part begins, from the first end."),
      real<&ThreadParams::fine_to>("fine_to", "Finer to", "m", "mm", 0, 0.3, "Where it ends."),
      real<&ThreadParams::coil_radius>("coil_radius", "Coil radius", "m", "mm", 0.2e-3, 50e-3,
                                       "Of the start shape coil."),
      text<&ThreadParams::path>("path", "Path",
                                "Of the start shape path: points from the first end on, with their unit: \"0 0 0, 1 0 2, 5 0 2 mm\"; beyond "
                                "the last one the thread goes straight on. Of nodes: a point each; farther apart than a segment is long they "
                                "are under tension."),
      file<&ThreadParams::paths>("paths", "Paths", "File with several such paths, one a line, in the place of \"path\"; lines that begin with # say something."),
      integer<&ThreadParams::shape>("shape", "Shape", 0, 16, "Which of several paths it starts along, from 1 on; 0: one that is drawn at random."),
      choice<&ThreadParams::first>("first", "First end", kEnds, "Fixed: place and direction are kept."),
      choice<&ThreadParams::last>("last", "Last end", kEnds, "Fixed: place and direction are kept."),
      choice<&ThreadParams::around>("around", "Surroundings", kAround,
                                      "What drags on it and bears it up: the environment of the lesson, or air or water whatever that is."),
      real<&ThreadParams::diameter>("diameter", "Diameter", "m", "um", 0, 1e-3,
                                    "10-0: 20 to 29 um. 0: as the suture says.")
          .group("Material"),
      real<&ThreadParams::young>("young", "Young's modulus", "Pa", "GPa", 0, 1e12,
                                 "Nylon about 2.5 GPa. 0: as the suture says.")
          .group("Material"),
      real<&ThreadParams::poisson>("poisson", "Poisson's ratio", "1", "1", -1, 0.5,
                                   "Gives the stiffness against twisting. Below 0: as the suture says.")
          .group("Material"),
      real<&ThreadParams::density>("density", "Density", "kg/m3", "kg/m3", 0, 25000,
                                   "Nylon 1140. 0: as the suture says.")
          .group("Material"),
      real<&ThreadParams::memory>("memory", "Memory", "1/m", "1/m", -1, 1000,
                                  "Curvature to which it goes back unloaded; 0 is straight. Below 0: as the suture says.")
          .group("Material"),
      real<&ThreadParams::strength>("strength", "Strength", "N", "mN", 0, 100,
                                    "Tension at which it breaks. Knot-pull minimum of 10-0: about 190 mN. 0: as the suture "
                                    "says.")
          .group("Material"),
      real<&ThreadParams::pull_off>("pull_off", "Pull-off strength", "N", "mN", 0, 100,
                                    "Pull that draws it out of the needle to which it is swaged. 10-0: about 140 mN. 0: as the "
                                    "suture says.")
          .group("Material"),
      real<&ThreadParams::yield>("yield", "Yield strain", "1", "1", -1, 1,
                                 "Strain of its surface beyond which it stays bent. 0: it never does. Below 0: as the suture says.")
          .group("Material"),
      real<&ThreadParams::hardening>("hardening", "Hardening", "1", "1", -1, 0.95,
                                     "Share of its stiffness against bending that is left there. Below 0: as the suture says.")
          .group("Material"),
  };
  static constexpr std::array traits{SWAGE_TRAIT_STRAND, SWAGE_TRAIT_STRAND_NODES, SWAGE_TRAIT_STRAND_LINE, SWAGE_TRAIT_CUTTABLE};

  void build(const ThreadParams& params, ObjectBuilder& builder) override;
  void activate(double dt_s) override;
  void reset(const Step& step) override;
  void finish(const Step& step) override;
  void locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) override;
  const void* extension(std::string_view wanted) override;
  void strand_law(const Step& step, swage_strand_law& out) override;
  void strand_place(const Step& step, double s, swage_strand_place& out) override;
  void strand_nearest(const Step& step, swage_vec3 p_W, swage_strand_place& out) override;
  uint32_t strand_nodes(const Step&) override { return static_cast<uint32_t>(nodes()); }
  void strand_line(const Step& step, std::span<double> p_W, std::span<uint32_t> parted) override;
  void cut(const Step& step, double s) override;

  void advance(const Step& step) override;
  void mobility(const Step& step, std::span<const swage_contact_point> points,
                  std::span<const swage_chain_place> place, double* v_free, double* W) override;
  void apply_impulses(const Step& step, std::span<const swage_contact_point> points,
             std::span<const swage_chain_place> place, const double* impulse) override;
  void linearise(const Step& step, uint32_t stiffer, double* stiffness, double* gradient) override;
  void displace(const Step& step, const double* change, std::span<const swage_contact_point> points,
                std::span<const swage_chain_place> place, const double* impulse) override;

 private:
  // contacts that it asks room for beyond one a segment: lying flat it has two a segment, a tight throw 60 to 100
  static constexpr uint32_t kPoints = 32;
  static constexpr int kSides = 6;         // right-hand sides that are solved together

  /// A point of contact as the rod has it.
  struct Point {
    int edge = 0;
    double s = 0;          // share of the edge from its first node
    toolkit::Vec3 t, arm;  // unit; m, from the centre line
  };
  static size_t at(int i) { return static_cast<size_t>(i); }
  int nodes() const { return params_.segments + 1; }
  uint32_t vertices() const { return static_cast<uint32_t>(nodes()); }
  /// Nodes and velocities are those of the chain.
  toolkit::RodState state(const Step& step) const {
    double* all = step.state().data();
    return {nodes(), all, all + ChainState::doubles(vertices())};
  }
  bool stays_bent() const { return yield_.curvature > 0; }
  /// Natural curvatures of the nodes, where it stays bent.
  double* set(const Step& step) const { return step.state().data() + ChainState::doubles(vertices()) + toolkit::RodState::frames(nodes()); }
  /// How often it has passed through itself.
  double& passed(const Step& step) const { return step.state()[step.state().size() - 4]; }
  /// What lasts beside: whether contacts pushed in the last step, and the first and last of the neighbouring edges that were pressed
  /// around the one that was pressed hardest; the last is before the first where none was.
  double& held(const Step& step) const { return step.state()[step.state().size() - 3]; }
  double* grip(const Step& step) const { return &step.state()[step.state().size() - 2]; }

  // level thesis (thread_masses.cpp)
  bool masses() const { return params_.level == Level::kThesis; }
  Springs springs() const;
  double mass(int i) const;  // kg
  bool stays(int i) const;
  void advance_masses(const Step& step, const toolkit::RodState& begun, toolkit::RodState& s);
  void answer_masses(std::span<const swage_contact_point> points, std::span<const swage_chain_place> place,
                     double* v_free, double* W);
  void linearise_masses(const Step& step, double* columns) const;
  void go_masses(const Step& step, const double* change, toolkit::RodState& s);

  bool lay_nodes(ObjectBuilder& builder);
  double shortest() const;  // m, segment
  bool take_suture(const ThreadParams& params, ObjectBuilder& builder);
  void declare(ObjectBuilder& builder);
  bool lay_start(const ThreadParams& params, ObjectBuilder& builder);
  bool written() const { return params_.start == Start::kPath || params_.start == Start::kNodes; }
  bool tells_shape() const { return several() || params_.start == Start::kNodes; }
  bool several() const { return starts_.size() > 1; }
  double& shape(const Step& step) const { return step.state()[step.state().size() - 5]; }  // from 1 on, where there are several
  bool lay_written(const ThreadParams& params, ObjectBuilder& builder);
  /// From where it starts, in O.
  void start_frames(toolkit::RodState& s, const std::vector<toolkit::Vec3>& start_O, const toolkit::Quat& q_WO);
  toolkit::Pose middle(const toolkit::RodState& s) const;
  /// The edge nearest to a point, and the share of it from its first node.
  std::pair<int, double> nearest_edge(const toolkit::RodState& s, const toolkit::Vec3& p_W) const;
  /// The edge on which the arc length s [m] lies.
  int edge_at(const Step& step, double s) const;
  void tell(const Step& step, int edge, double share, swage_strand_place& out) const;
  toolkit::RodLoad load(const Step& step) const;
  toolkit::RodFluid fluid() const;
  void set_up_surroundings();
  bool charged() const { return environment_.charge != 0; }
  void push_edge(int edge, const toolkit::Vec3& f, double stiff, const toolkit::Vec3& n);
  void feel_charge(const Step& step);
  void take_parted(const Step& step);
  void part(const Step& step) const;
  void count_passages(const Step& step);
  void write(const Step& step, const toolkit::RodState& before, const toolkit::RodState& now) const;
  Point point(const swage_contact_point& c, const swage_chain_place& place) const;
  /// Velocity-like numbers of all unknowns (`line` apart) at a point.
  toolkit::Vec3 at_point(const Point& p, const double* unknowns, int line) const;
  void push(const Point& p, const toolkit::Vec3& f, double* unknowns, int line) const;
  void hold_sides();
  void press(const Step& step, std::span<const swage_chain_place> place, const double* impulse);
  void find_grip(const Step& step, int hardest) const;

  ThreadParams params_;
  Suture suture_;
  toolkit::Rod rod_;
  toolkit::RodYield yield_;
  toolkit::Pose X_OB0_;
  std::vector<std::vector<toolkit::Vec3>> starts_;  // m, O: nodes of each start shape; of the first but where there are several
  std::vector<double> s_, lengths_;  // m, arc lengths of the nodes, and what is between them
  int given_nodes_ = 0;  // that a lesson speaks of, and not a finer level
  Body body_;
  Signal tension_first_, tension_last_, tension_grip_, tension_, bend_radius_, parted_, passed_, shape_told_;

  swage_environment environment_{};  // of the lesson

  // of the present step
  std::vector<double> charge_force_, charge_spring_;  // N, 3 a node; N/m, 6 a node; empty where it has no charge
  std::vector<double> begun_, base_;  // states: at its start, and about which it is linear
  std::vector<double> sides_;         // kSides right-hand sides
  std::vector<double> drag_;   // N s/m, a node
  std::vector<Point> point_;
  std::vector<char> pressed_;  // per edge
  std::vector<double> boxes_;  // room to look for passages
  double advanced_at_ = -1;    // s
  bool linear_ = false;  // there is a linear step
};

}  // namespace swage::thread
