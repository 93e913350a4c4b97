// SPDX-License-Identifier: Apache-2.0
//
// What of an engine is state: saved, stepped, put back, stepped again, byte for byte.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/rng.hpp"
#include "fake_scene.hpp"

namespace swage::step {
namespace {

// a hand that beats against the ball, a ball with private numbers and a force of its own, a coupling that remembers
void lively(FakeScene& s) {
  s.device_.exchange = [](const swage_command* c, swage_sample* out) {
    const double t = c->time_s;
    out->pose = {{1e-4 * std::sin(9 * t), 0, 4.0e-3 + 2e-4 * std::sin(40 * t)}, {1, 0, 0, 0}};
    out->valid = SWAGE_VALID_POSE;
    return swage_result{SWAGE_OK};
  };
  s.ball_.forces = [](const swage_object_step* step) {
    step->state[0] += step->V_WB[0].v.z;
    step->F_B_W[0].f.z = -1e-4 * (step->X_WB[0].p.z / 5e-3) - 1e-6 * step->state[0];
    step->F_B_W[0].f.x = -1e-3 * step->X_WB[0].p.x;
    return swage_result{SWAGE_OK};
  };
  s.coupling_.resolve = [](const swage_coupling_step* step) {
    step->state[0] += step->n_contact;
    for (uint32_t i = 0; i < step->n_contact; ++i)
      step->contact[i].friction = step->contact[i].f_a_W.z < -1e-4 ? 0.1 : 0.5;
    return swage_result{SWAGE_OK};
  };
  s.lesson_.observe = [](const swage_view* view, const swage_verdict* say, double* state) {
    state[0] += view->X_WB[1].p.z;
    say->metric(say, 0, state[0]);
    return swage_result{SWAGE_OK};
  };
}

TEST(Rewind, SaveStepRestoreStepGivesTheSameBytes) {
  base::Xoshiro256 random(4);
  FakeScene s;
  lively(s);
  std::vector<std::byte> image(s.engine().image_size());
  for (int round = 0; round < 10; ++round) {
    s.run(static_cast<int>(random() % 200));
    image.assign(s.engine().image_size(), std::byte{0});
    ASSERT_TRUE(s.engine().save(image));
    const uint64_t now = s.engine().hash();
    s.run(50);
    const uint64_t later = s.engine().hash();
    const double metric = s.engine().verdict().metric[0];
    ASSERT_NE(now, later);
    ASSERT_TRUE(s.engine().restore(image));
    EXPECT_EQ(s.engine().hash(), now);
    s.run(50);
    EXPECT_EQ(s.engine().hash(), later);
    EXPECT_EQ(s.engine().verdict().metric[0], metric);
  }
  EXPECT_GT(s.rig.world.plugin_state[2], 50);  // there were contacts: 69, before the ball has bounced away
}

TEST(Rewind, TwoEnginesOfTheSameSceneAgreeAtEveryStep) {
  FakeScene a, b;
  lively(a);
  lively(b);
  for (int i = 0; i < 1000; ++i) {
    a.run(1);
    b.run(1);
    ASSERT_EQ(a.engine().hash(), b.engine().hash()) << "step " << i;
  }
}

TEST(Rewind, ResetIsTheStart) {
  FakeScene s;
  lively(s);
  const uint64_t start = s.engine().hash();
  std::vector<uint64_t> first;
  for (int i = 0; i < 300; ++i) {
    s.run(1);
    first.push_back(s.engine().hash());
  }
  s.engine().reset();
  EXPECT_EQ(s.engine().hash(), start);
  for (int i = 0; i < 300; ++i) {
    s.run(1);
    ASSERT_EQ(s.engine().hash(), first[static_cast<std::size_t>(i)]) << "step " << i;
  }
}

// the smallest change of anything that counts changes the hash of the step, and of the object it belongs to
TEST(Rewind, HashesSeeTheLastBit) {
  FakeScene s;
  lively(s);
  s.run(450);
  const uint64_t tool = s.engine().object_hash(0), ball = s.engine().object_hash(1);
  double& number = s.rig.world.V_WB[1].w.y;
  number = std::nextafter(number, 1.0);
  EXPECT_EQ(s.engine().object_hash(0), tool);
  EXPECT_NE(s.engine().object_hash(1), ball);
}

TEST(Rewind, ImagesOfOtherScenesAreRefused) {
  FakeScene s;
  std::vector<std::byte> image(s.engine().image_size());
  ASSERT_TRUE(s.engine().save(image));
  std::vector<std::byte> small(200);
  EXPECT_FALSE(s.engine().save(small));
  EXPECT_FALSE(s.engine().restore({image.data(), 200}));
  FakeScene other;
  other.rig.world.signal.push_back(0);
  other.rig.world.plugin_state.push_back(0);
  EXPECT_FALSE(other.engine().restore(image));
}

}  // namespace
}  // namespace swage::step
