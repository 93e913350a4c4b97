// SPDX-License-Identifier: Apache-2.0
#include "snapshot/channel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

namespace swage::snapshot {
namespace {

std::unique_ptr<Snapshot> make(uint64_t step, uint32_t particles) {
  auto s = std::make_unique<Snapshot>();
  s->step = step;
  s->n_particle = particles;
  s->contact[kMaxContacts - 1].f_W.z = static_cast<double>(step);
  for (uint32_t i = 0; i < 3 * particles; ++i) s->particle_p_W[i] = static_cast<double>(step);
  return s;
}

TEST(Channel, CarriesExactlyTheParticlesOfTheScene) {
  Channel channel;
  auto out = std::make_unique<Snapshot>();
  EXPECT_FALSE(channel.latest(*out));
  channel.publish(*make(3, kMaxParticles));
  ASSERT_TRUE(channel.latest(*out));
  EXPECT_EQ(out->particle_p_W[3 * kMaxParticles - 1], 3);
  channel.publish(*make(4, 5));
  ASSERT_TRUE(channel.latest(*out));
  EXPECT_EQ(out->step, 4u);
  EXPECT_EQ(out->contact[kMaxContacts - 1].f_W.z, 4);
  EXPECT_EQ(out->particle_p_W[14], 4);
  EXPECT_EQ(channel.published(), 2u);
}

TEST(Channel, ReadersSeeWholeMoments) {
  Channel channel;
  std::atomic<bool> done{false};
  std::atomic<uint64_t> torn{0}, reads{0};
  std::thread reader([&] {
    auto s = std::make_unique<Snapshot>();
    while (!done.load()) {
      if (!channel.latest(*s)) continue;
      const auto step = static_cast<double>(s->step);
      torn += s->contact[kMaxContacts - 1].f_W.z != step;
      for (uint32_t i = 0; i < 3 * s->n_particle; ++i) torn += s->particle_p_W[i] != step;
      ++reads;
      std::this_thread::yield();
    }
  });
  for (uint64_t step = 1; step < 3000 || reads.load() < 20; ++step) {
    channel.publish(*make(step, 100));
    std::this_thread::yield();
  }
  done = true;
  reader.join();
  EXPECT_EQ(torn.load(), 0u);
}

}  // namespace
}  // namespace swage::snapshot
