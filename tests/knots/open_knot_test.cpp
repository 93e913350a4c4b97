// SPDX-License-Identifier: Apache-2.0
//
// Open knots in 10-0 nylon against the theory of Audoly, Clauvelin and Neukirch (Phys. Rev. Lett. 99, 164301, 2007) for the trefoil,
//     F h^2 / B = e^4 / 2 +- 0.492 mu e^3,   e = sqrt(h / R),   h radius of the thread, B = EI, R of the loop (its length over 2 pi),
// the leading terms for a thin thread, e -> 0.
#include "open_knot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace swage::test {
namespace {

struct Loose {
  double e = 0, pull = 0, pressing = 0, kept = 0;  // pull over B / 2 R^2; contact forces over e^3 B / h^2; first integral over the pull
};

OpenKnotTest trefoil(double loop) {
  OpenKnotTest t;
  t.loop = loop, t.tail = 6 * loop, t.coarse = loop / 8;
  t.fine = 0.3 * std::sqrt(0.5 * t.diameter * loop);
  return t;
}

Loose loose(double loop) {
  const OpenKnotTest t = trefoil(loop);
  OpenKnot knot(t);
  knot.relax(400, 0);
  knot.relax(2500, 1e-6);
  EXPECT_EQ(knot.passages(), 0);
  EXPECT_EQ(knot.not_converged(), 0u);
  const double h = 0.5 * t.diameter, R = knot.shortening() / (2 * M_PI), B = knot.bending(), k = knot.apex_curvature();
  Loose out;
  out.e = std::sqrt(h / R);
  out.pull = knot.pull() * 2 * R * R / B;
  out.kept = (0.5 * B * k * k + knot.apex_tension()) / knot.pull();
  for (int i = 0; i < 50; ++i) knot.step(), out.pressing += knot.pressing() / 50;
  out.pressing *= h * h / B / (out.e * out.e * out.e);
  return out;
}

// Without friction B k^2 / 2 + T is the same all along the thread, in the loop as in the tails: exact for any e, 3 % for what segments of
// 0.3 sqrt(h R) are off it. The pull differs from the leading term by a share of about 1.2 e (13 % at R = 1 mm) and meets it for e -> 0.
// By virtual work the force of friction is mu times the sum of the contact forces, which is 0.492 e^3 B / h^2 for e -> 0.
TEST(Trefoil, MeetsTheTheoryOfThinThreads) {
  std::array<Loose, 3> r;
  for (size_t i = 0; i < 3; ++i) {
    r[i] = loose(std::array{1e-3, 4e-3, 16e-3}[i]);
    EXPECT_NEAR(r[i].kept, 1, 0.03) << "e " << r[i].e;
  }
  // straight through the two thinnest
  const auto limit = [&](double Loose::*what) {
    return r[2].*what - r[2].e * (r[1].*what - r[2].*what) / (r[1].e - r[2].e);
  };
  EXPECT_NEAR(limit(&Loose::pull), 1, 0.05);
  EXPECT_NEAR(limit(&Loose::pressing), 0.492, 0.1 * 0.492);
  EXPECT_GT(r[0].pull, 1.08) << "the leading term alone is not enough at R = 1 mm";
}

// A braid of several turns that is drawn tight and loosened: 180 to 320 contacts with themselves, which stick and slip in turns over
// cones of 0.03 nm. Every step converges.
TEST(Braid, ConvergesWithFrictionAtHundredsOfContacts) {
  for (const int turns : {2, 3}) {
    OpenKnotTest t;
    t.turns = turns, t.loop = 2e-3, t.braid = 1e-3, t.tail = 12e-3, t.fine = 25e-6, t.stiffness = 5e4;
    OpenKnot knot(t);
    knot.relax(400, 0);
    EXPECT_EQ(knot.not_converged(), 0u) << turns << " turns, laid";
    knot.set_friction(0.119);
    size_t most = 0;
    double pull[2];
    for (const int way : {1, -1}) {
      for (int i = 0; i < 30; ++i) knot.draw(way * 1e-6, 1e-3), most = std::max(most, knot.contacts());
      EXPECT_EQ(knot.not_converged(), 0u) << turns << " turns, way " << way;
      pull[way < 0] = knot.pull();
    }
    EXPECT_GT(most, 90u * static_cast<unsigned>(turns));
    EXPECT_EQ(knot.passages(), 0);
    EXPECT_GT(pull[0], 1.3 * pull[1]) << "friction holds it against being tightened";
  }
}

}  // namespace
}  // namespace swage::test
