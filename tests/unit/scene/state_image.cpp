// SPDX-License-Identifier: Apache-2.0
#include "scene/state_image.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "scene/kinematics.hpp"

namespace swage::scene {
namespace {

World small_world() {
  World w;
  w.body.resize(3);
  for (auto& body : w.body) body.start.q.w = 1;
  w.particle_mass.assign(2, 1e-9);
  w.plugin_state.assign(4, 0.25);
  w.signal.assign(2, 0.5);
  w.random.assign(1, 42);
  reset(w);
  w.step = 7;
  w.X_WB[1].p = {1e-3, -0.0, 3e-300};
  w.V_WB[2].w = {0.1, 0.2, 0.3};
  w.particle_p_W = {1, 2, 3, 4, 5, 6};
  return w;
}

std::vector<std::byte> image_of(const World& w) {
  std::vector<std::byte> image(image_size(w));
  Writer out(image);
  save(w, out);
  EXPECT_TRUE(out.ok());
  EXPECT_EQ(out.size(), image.size());
  EXPECT_EQ(out.hash(), hash(w));
  return image;
}

TEST(StateImage, RestoresEveryByte) {
  const World original = small_world();
  const auto image = image_of(original);

  World other = small_world();
  other.step = 0;
  other.X_WB[1].p = {9, 9, 9};
  other.random[0] = 1;
  other.plugin_state[3] = -1;
  ASSERT_NE(hash(other), hash(original));

  Reader in(image);
  ASSERT_TRUE(restore(other, in));
  EXPECT_EQ(hash(other), hash(original));
  EXPECT_EQ(image_of(other), image);
  EXPECT_TRUE(std::signbit(other.X_WB[1].p.y));
}

TEST(StateImage, RefusesAnotherSceneAndLeavesTheWorldAlone) {
  const auto image = image_of(small_world());
  World other = small_world();
  other.signal.push_back(1);
  const uint64_t before = hash(other);
  Reader in(image);
  EXPECT_FALSE(restore(other, in));
  EXPECT_EQ(hash(other), before);
}

TEST(StateImage, RefusesAnotherVersionAndShortImages) {
  auto image = image_of(small_world());
  World other = small_world();

  Reader short_image(std::span<const std::byte>(image).first(image.size() - 8));
  EXPECT_FALSE(restore(other, short_image));

  const uint64_t version = kImageVersion + 1;
  std::memcpy(image.data(), &version, sizeof version);
  Reader newer(image);
  EXPECT_FALSE(restore(other, newer));
}

TEST(StateImage, WriterNeverWritesPastItsBuffer) {
  const World w = small_world();
  std::vector<std::byte> image(image_size(w) - 8);
  Writer out(image);
  save(w, out);
  EXPECT_FALSE(out.ok());
  EXPECT_LE(out.size(), image.size());
}

TEST(StateImage, RoomsAppendTheirMemory) {
  const World w = small_world();
  const std::vector<double> bristles = {1e-7, -2e-7};
  std::vector<std::byte> image(image_size(w) + 2 * sizeof(double));
  Writer out(image);
  save(w, out);
  out.put(bristles);
  ASSERT_TRUE(out.ok());
  EXPECT_NE(out.hash(), hash(w));

  World back = small_world();
  std::vector<double> back_bristles(2);
  Reader in(image);
  ASSERT_TRUE(restore(back, in));
  in.get(back_bristles);
  EXPECT_TRUE(in.ok());
  EXPECT_EQ(back_bristles, bristles);
}

TEST(StateHash, EveryBitAndTheOrderCount) {
  for (int bit = 0; bit < 64; ++bit) {
    World w = small_world();
    const uint64_t before = hash(w);
    uint64_t word;
    std::memcpy(&word, &w.particle_p_W[3], 8);
    word ^= uint64_t{1} << bit;
    std::memcpy(&w.particle_p_W[3], &word, 8);
    EXPECT_NE(hash(w), before) << bit;
  }
  World w = small_world();
  const uint64_t before = hash(w);
  std::swap(w.particle_p_W[0], w.particle_p_W[1]);
  EXPECT_NE(hash(w), before);
  std::swap(w.particle_p_W[0], w.particle_p_W[1]);
  std::swap(w.particle_p_W[0], w.particle_p_W[4]);  // four apart: the same lane
  EXPECT_NE(hash(w), before);
}

// golden: the same bytes give the same hash with every compiler and optimisation level
TEST(StateHash, Golden) { EXPECT_EQ(hash(small_world()), 16197564882989833041u); }

}  // namespace
}  // namespace swage::scene
