// SPDX-License-Identifier: Apache-2.0
//
// Finds all contacts of a step between the objects that may touch, and carries over the memory of each.
//
// Units: SI. Frames: W. Threads: built on [main], detect() on [rt].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/chain.hpp"
#include "contact/chain_spheres.hpp"
#include "contact/contact_memory.hpp"
#include "contact/contact_set.hpp"
#include "contact/narrow_phase.hpp"
#include "contact/solid.hpp"
#include "contact/sphere_tree.hpp"
#include "contact/sweep.hpp"
#include "scene/state_image.hpp"
#include "scene/world.hpp"

namespace swage::contact {

/// The surface that represents an arc.
enum class Level : uint8_t {
  kExact,   // the arc itself
  kThesis,  // a chain of spheres under a tree of bounding spheres (thesis 4.2.9, 4.2.10); for comparison
};

struct Options {
  Level level = Level::kExact;
  int chain_spheres = 100;  // per wire, kThesis only; 100 leaves bumps of 11.75 um on a 6.4 mm, 0.1 mm wire
  /// Contacts are reported while their gap is below margin * length plus the displacement of the bodies in one step.
  /// 0.02: 20 um for a 1 mm scene. Too small: a contact that the solve itself brings about is found one step late.
  double margin = 0.02;
  double flatness = 2e-3;   // see Query
  int line_points = 4;      // see Query
  uint32_t capacity = 256;  // contacts per step
};

/// One per scene. detect() neither allocates nor throws.
class Detector {
 public:
  /// [main] Throws std::invalid_argument for options outside their range.
  Detector(const scene::World& world, std::vector<Pair> pairs, const Options& options);

  /// [rt] Finds the contacts at the poses of `world`, the predicted end of the step; the twists give the poses at its start.
  /// Bodies that move farther than the thickness of their wires are swept; their contact is where they first touch. `set`
  /// holds last step's contacts on entry: bristle, force and slip of a contact that lasts are carried over, all else is
  /// written anew.
  void detect(const scene::World& world, ContactSet& set) noexcept;

  /// [main] Reserves room for every contact that detect() may write.
  void reserve(ContactSet& set) const;

  /// [rt] Forgets all contacts and their memory, as at the start of a lesson.
  void reset(ContactSet& set) noexcept;

  /// [rt] What the next detect() needs besides the world: last step's contacts and the remembered separations.
  /// save() writes up to image_size() bytes; restore() reads them back, false when they are not of this scene.
  void save(const ContactSet& set, scene::Writer& out) const noexcept;
  bool restore(ContactSet& set, scene::Reader& in) noexcept;
  size_t image_size() const;  // [main]

  const std::vector<Pair>& pairs() const { return pairs_; }

  // --- queries within the step, for bodies that fly and rebound in it (dynamics/rebound.hpp): detector_swept.cpp

  /// Two shapes, at least one of them on a DYNAMIC body and none on a body that its object moves. Indexed from 0 to swept_pairs() - 1.
  struct Shapes {
    uint32_t pair = 0, shape_a = 0, shape_b = 0;  // the object pair; global
    uint32_t body_a = 0, body_b = 0;              // global
  };
  /// A contact that must stay in the set, because an impulse acted there.
  struct Struck {
    uint32_t swept = 0;  // index of the two shapes
    Candidate candidate;
  };
  enum class Reach : uint8_t {
    kFar,   // cannot meet in this step
    kNear,  // may meet
    kFast,  // may meet, and move so far that one may pass through the other
  };
  size_t swept_pairs() const { return swept_.size(); }
  const Shapes& swept(uint32_t i) const { return swept_[i]; }
  /// [rt] Whether two shapes may meet under these motions of their bodies.
  Reach reach(const scene::World& world, uint32_t i, const Motion& a, const Motion& b) const noexcept;
  /// [rt] First time at which they overlap by more than `sunk` [m] plus a small tolerance that grows with the number of touches before, so
  /// that a present touch is not found again at once. Polyhedra cannot be made thinner and are found slightly before they touch.
  FirstTouch first_overlap(const scene::World& world, uint32_t i, const Motion& a, const Motion& b, double sunk,
                         uint32_t touches) noexcept;
  /// [rt] Their contacts at these poses with gaps up to `margin`; valid until the next query.
  const Manifold& touches(const scene::World& world, uint32_t i, const Frame& X_WA, const Frame& X_WB,
                          double margin) noexcept;
  /// [rt] Finds the contacts of the bodies marked in `moved` anew, at their present poses; the others stay. Laws, bristles and
  /// forces of lasting contacts are carried over; contacts with an impulse stay as long as there is room.
  void look_again(const scene::World& world, ContactSet& set, std::span<const uint8_t> moved,
                  std::span<const Struck> struck) noexcept;

 private:
  static constexpr uint32_t kNoGroup = UINT32_MAX;

  /// Two shapes that may touch.
  struct ShapePair {
    uint32_t pair = 0, shape_a = 0, shape_b = 0, group = kNoGroup;
    Separation memory;
    bool remembers = true;  // false for the segments of a chain, which are many and of which few are near
  };

  /// Bounding sphere of a shape in W, and a bound on the displacement of the shape's points in the step [m].
  struct Ball {
    Vec3 centre = Vec3::Zero();
    double radius = 0, moves = 0;
  };
  /// The arcs of one wire (chain_line.hpp) in one bounding sphere; and the pair of such a wire and one shape.
  struct Chain {
    uint32_t first = 0, shapes = 0;
    Ball ball;
  };
  struct Group {
    uint32_t pair = 0, chain = 0, other = 0;
    bool far = false;
  };
  struct KnownMotion {
    bool known = false;
    Motion motion;
  };

  void lay_spheres(const scene::World& world);
  uint32_t group_of(uint32_t pair, uint32_t a, uint32_t b);
  void look_around(const scene::World& world) noexcept;
  bool far_apart(const Ball& ball, uint32_t other, double margin) const noexcept;
  const Motion& motion(const scene::World& world, uint32_t body) noexcept;
  Query query_of(const scene::World& world, const ShapePair& pair, double margin) const noexcept;
  void detect_shapes(const scene::World& world, ShapePair& pair, ContactSet& set) noexcept;
  void detect_chain(const scene::World& world, const ShapePair& pair, const Query& query,
                    ContactSet& set) noexcept;
  void append(const scene::World& world, const ShapePair& pair, uint64_t part, ContactSet& set) noexcept;
  void keep(const scene::World& world, const ShapePair& pair, const Candidate& found, uint64_t part,
            Contact contact, ContactSet& set) noexcept;

  // chains: detector_chain.cpp
  struct Part;
  bool is_chain(uint32_t shape) const noexcept { return tree_of_[shape] != scene::kNone; }
  void refit_chain(const scene::World& world, uint32_t shape) noexcept;
  Part whole(const scene::World& world, uint32_t shape) noexcept;
  Part piece(const scene::World& world, uint32_t shape, uint32_t segment, Solid& solid) const noexcept;
  void detect_with_chain(const scene::World& world, const ShapePair& pair, ContactSet& set) noexcept;
  // chains of spheres
  bool is_spheres(uint32_t shape) const noexcept { return is_chain(shape) && spheres_of_[tree_of_[shape]] != scene::kNone; }
  const ChainSpheres& spheres(uint32_t shape) const noexcept { return spheres_[spheres_of_[tree_of_[shape]]]; }
  Part sphere(const scene::World& world, uint32_t shape, uint32_t vertex, Solid& solid) const noexcept;
  void detect_spheres(const scene::World& world, const ShapePair& pair, ContactSet& set) noexcept;
  void detect_spheres_with(const scene::World& world, const ShapePair& pair, bool first, ContactSet& set) noexcept;
  void detect_parts(const scene::World& world, const ShapePair& pair, const Part& a, const Part& b,
                    ContactSet& set) noexcept;
  bool collide_parts(const Part& a, const Part& b, double moves, const Query& query, double length) noexcept;
  void weigh_lines(double radius) noexcept;
  void find_swept(const scene::World& world);
  void look_again(const scene::World& world, ShapePair& pair, ContactSet& set, std::span<const uint8_t> moved,
                  std::span<const Struck> struck) noexcept;
  void keep(const scene::World& world, const ShapePair& pair, ContactSet& set, bool moved) noexcept;
  void add_struck(const scene::World& world, const ShapePair& pair, ContactSet& set,
                  std::span<const Struck> struck) noexcept;

  std::vector<Pair> pairs_;
  Options options_;
  ContactMemory memory_;             // while the new contacts are written
  std::vector<Solid> solids_;        // one per shape of the world
  std::vector<SphereTree> chains_;   // one per shape; empty except for arcs at Level::kThesis
  std::vector<uint32_t> bodies_;     // bodies with a shape in any pair
  std::vector<uint32_t> body_;       // of each shape
  std::vector<uint8_t> in_pair_;     // per shape: 1 when it is in any pair
  std::vector<Frame> X_WB_;          // of those bodies, indexed by body
  std::vector<KnownMotion> motion_;  // of those bodies, indexed by body
  std::vector<Ball> ball_;           // one per shape
  std::vector<uint8_t> goes_on_;     // per shape: another arc of the same wire ends at its start
  std::vector<Chain> chain_;
  std::vector<Group> group_;
  std::vector<ShapePair> shape_pairs_;  // in the order of evaluation
  std::vector<Shapes> swept_;
  Manifold manifold_;
  Solid sphere_;  // one sphere of a chain
  std::vector<ChainTree> tree_;    // one per shape of kind CHAIN
  std::vector<uint32_t> tree_of_;  // per shape: index into tree_, or kNone
  Solid piece_a_, piece_b_;        // one piece of a chain each
  std::vector<ChainSpheres> spheres_;  // one per chain that is touched at its vertices only
  std::vector<uint32_t> spheres_of_;   // per chain: index into spheres_, or kNone
  Solid ball_a_, ball_b_;              // one sphere of a chain each
};

}  // namespace swage::contact
