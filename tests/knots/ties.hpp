// SPDX-License-Identifier: Apache-2.0
//
// Ties whose word is known because of how they are made: two strands wound about each other, throw above throw, their ends led far
// away and joined there. Then the space around them is bent at random (shears, which take no strand through another), so that the same
// knot lies in ever new shapes; some are drawn tight.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "toolkit/knot/diagram.hpp"
#include "toolkit/math.hpp"

namespace swage::test {

using toolkit::Vec3;

/// Turns of each throw, with its sign; the first throw first.
using Word = std::vector<int>;

struct Tie {
  Word word;
  std::vector<Vec3> node;    // the thread
  std::vector<Vec3> beyond;  // from its last end, far away, back to its first end
  const double* data() const { return node.front().data(); }
  int nodes() const { return static_cast<int>(node.size()); }
  std::vector<Vec3> closed() const;
};

struct TieShape {
  double core = 0;       // 0: both strands are bent alike (flat); 1: one of them runs straight through (sliding)
  bool core_swaps = false;  // in the next throw the other strand is the straight one
  double radius = 1;     // of the winding
  double pitch = 2;      // along its axis, a half turn
  double spacing = 6;    // from throw to throw
  double tail = 10;      // length
  int tail_turns = 0;    // half turns of the two tails about each other, which are no knot
  double coil = 0;       // radius of a tail that curls
  int shears = 0;
  double shear = 1;      // most that one displaces
  int nodes = 200;
  int tighten = 0;       // rounds of drawing tight
};

/// Nothing where a polygon of so few nodes cannot have that shape.
std::optional<Tie> make_tie(const Word& word, const TieShape& shape, uint64_t seed);
/// A random word of up to `throws` throws in a random shape.
Tie random_tie(uint64_t seed, int throws = 5);
/// The shape that random_tie takes.
TieShape random_shape(std::mt19937_64& random, int throws);

std::string text(const Word& word);

/// HOMFLY polynomial of the closed polygon by libhomfly, from a picture of our own in plain doubles; empty where every picture tried has
/// more than `crossings` crossings.
std::string homfly(const std::vector<Vec3>& closed, int crossings, uint64_t seed);
std::string homfly(const toolkit::KnotDiagram& diagram);
/// Of the plainest diagram with this word.
std::string homfly(const Word& word);

}  // namespace swage::test
