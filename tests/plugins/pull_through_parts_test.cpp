// SPDX-License-Identifier: Apache-2.0
//
// The parts of swage.coupling.pull_through by themselves: where a thread of straight segments is at a hole through which a corner of it goes, and
// what is left of a passage whose two holes have been torn into one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "fake_objects.hpp"
#include "plugins/coupling_pull_through/passage.hpp"

namespace swage::coupling_pull_through {
namespace {

constexpr double kRadius = 11e-6;   // m, of 10-0
constexpr double kCorner = 3e-3;    // m, arc length of the corner
constexpr double kLength = 30e-3;   // m

/// Two straight pieces: the one that leads goes down from a corner, the tail lies at right angles to it, along -x.
struct Cornered {
  Cornered() {
    raw.self = this;
    raw.get_extension = [](swage_instance*, const char* id) -> const void* {
      static const swage_strand table{law, place, nearest};
      return std::strcmp(id, SWAGE_TRAIT_STRAND) == 0 ? &table : nullptr;
    };
  }
  static swage_result law(swage_instance*, const swage_object_step*, swage_strand_law* out) {
    *out = {kLength, kRadius, 1, 1};
    return SWAGE_OK;
  }
  static swage_result place(swage_instance* i, const swage_object_step*, double s, swage_strand_place* out) {
    const double past = s - kCorner, deep = static_cast<Cornered*>(i->self)->deep;
    *out = {};
    out->s = s;
    out->p_W = past > 0 ? swage_vec3{-past, 0, -deep} : swage_vec3{0, 0, past - deep};
    out->tangent_W = past > 0 ? swage_vec3{-1, 0, 0} : swage_vec3{0, 0, 1};
    return SWAGE_OK;
  }
  static swage_result nearest(swage_instance* i, const swage_object_step* step, swage_vec3, swage_strand_place* out) {
    return place(i, step, kCorner, out);
  }
  double deep = 0;  // m, of the corner below the surface
  swage_instance raw{};
};

struct Rig {
  Cornered thread;
  stage::FakeTissue tissue;
  swage_pose X_WB = kIdentity;
  swage_object_step of_tissue{}, of_thread{};
  StrandPeer strand{Peer(&thread.raw)};
  Peer wall{&tissue.raw};
  Rig() { of_tissue.X_WB = &X_WB, of_tissue.n_body = 1; }
  Site site() { return {strand, wall, Step(&of_thread), Step(&of_tissue), false}; }
};

/// The corner is drawn down through a hole at the origin, to 150 um, three times what the tissue of a lesson bears. What of the thread is at the hole moves on with it, steadily: nothing is left that
/// would have to be drawn across the thread.
TEST(Passage, ACornerGoesThroughAHole) {
  Rig rig;
  Hole hole{};
  hole.u = kCorner - 0.1e-3;
  double before = 0;
  for (int i = -20; i <= 30; ++i) {
    rig.thread.deep = i * 5e-6;
    const Site site = rig.site();
    ASSERT_TRUE(site.good);
    const Spot at = spot(site, hole);
    if (i > -20) {
      EXPECT_GT(at.at.u - before, 0.5e-6) << "m, of 5 um that the corner went, at " << i * 5 << " um";
      EXPECT_LT(at.at.u - before, 10e-6) << "m, at " << i * 5 << " um: it jumps";
    }
    before = hole.u = at.at.u;
    const Vec3 way = at.at.p_W - site.world(hole.p);
    EXPECT_LT(std::abs(at.at.advance_W.dot(way)), 0.01 * way.norm() + 0.1e-6) << "m: nearest across its way";
  }
  EXPECT_GT(hole.u, kCorner + 50e-6);
}

TEST(Passage, HolesThatWereTornIntoOneHaveNoLengthBetweenThem) {
  Rig rig;
  const Site site = rig.site();
  ASSERT_TRUE(site.good);
  Passage passage{};
  passage.count = 2, passage.out = 1;
  passage.hole[0].u = passage.hole[0].rest = 4.0e-3;
  passage.hole[1].u = passage.hole[1].rest = 4.4e-3;  // the exit behind the entry
  for (Hole& hole : passage.hole) hole.share = 2 * kRadius;
  EXPECT_EQ(passage.inside(), 0);
  const PassageLaw law{1, 0.2, 1e6, 420e3, 0.02};
  for (uint32_t i = 0; i < 2; ++i) {
    const swage_tie tie = tie_of(site, law, passage, i);
    EXPECT_GE(tie.forward_limit, 0) << "N: below zero the host puts the coupling in quarantine";
    EXPECT_GE(tie.backward_limit, 0);
  }
}

}  // namespace
}  // namespace swage::coupling_pull_through
