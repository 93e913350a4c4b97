// SPDX-License-Identifier: Apache-2.0
//
// A trait of one's own with a table: the functions find the object's class behind the instance (swage::self), and a coupling that
// knows only the trait gets its answer.
#include <gtest/gtest.h>
#include <swage/abi/visual.h>
#include <swage/testbed.hpp>

#include <algorithm>
#include <array>

#include "../plugins_for_tests/sticky/sticky.hpp"
#include "loaded_plugin.hpp"

namespace swage::test {
namespace {

TEST(OwnTrait, a_coupling_asks_a_class_it_has_never_heard_of) {
  const swage_entry* entry = load_entry(SWAGE_STICKY);
  ASSERT_NE(entry, nullptr);
  testbed::Host host;
  testbed::Declared pad_builder, peel_builder;
  const auto& factory = instances_of(*entry);
  swage_instance* pad = factory.create(&host.raw, Pad::id);
  swage_instance* peel = factory.create(&host.raw, Peel::id);
  ASSERT_TRUE(pad != nullptr && peel != nullptr);
  const swage_value strength{{5e3, 0, 0, 0}, {}};
  const swage_values of_pad{sizeof(swage_values), 1, &strength, {"pad", 3}}, none{sizeof(swage_values), 0, nullptr, {"peel", 4}};
  ASSERT_EQ(pad->configure(pad, &of_pad, &pad_builder.raw), SWAGE_OK);
  ASSERT_EQ(peel->configure(peel, &none, &peel_builder.raw), SWAGE_OK);
  const auto* coupling = static_cast<const swage_coupling*>(peel->get_extension(peel, SWAGE_EXT_COUPLING));
  ASSERT_NE(coupling, nullptr);
  ASSERT_EQ(coupling->bind(peel, pad, pad), SWAGE_OK);
  ASSERT_EQ(pad->activate(pad, 1e-3), SWAGE_OK);
  ASSERT_EQ(peel->activate(peel, 1e-3), SWAGE_OK);

  swage_object_step object{};
  double signal = 0;
  swage_coupling_step step{};
  step.a = step.b = &object;
  step.signal = &signal;
  step.n_signal = 1;
  host.role = SWAGE_THREAD_RT;
  EXPECT_EQ(coupling->finish(peel, &step), SWAGE_OK);
  EXPECT_DOUBLE_EQ(signal, 5e3 * 293 / 310);

  // what it draws keeps within the room that there is
  const auto* visuals = static_cast<const swage_visuals*>(pad->get_extension(pad, SWAGE_EXT_VISUAL));
  ASSERT_NE(visuals, nullptr);
  EXPECT_EQ(peel->get_extension(peel, SWAGE_EXT_VISUAL), nullptr);
  for (uint32_t room = 0; room <= 3; ++room) {
    swage_visual drawn[3] = {};
    uint32_t n = 99;
    EXPECT_EQ(visuals->draw(pad, &object, nullptr, room, drawn, &n), SWAGE_OK);
    EXPECT_EQ(n, room < 2 ? room : 2u);
    if (room == 0) continue;
    EXPECT_EQ(drawn[0].kind, uint32_t{SWAGE_VISUAL_DISC});
    EXPECT_EQ(drawn[0].body, 0u);
    EXPECT_EQ(drawn[0].direction.z, 1);
    EXPECT_EQ(drawn[1].kind, room < 2 ? 0u : uint32_t{SWAGE_VISUAL_LINE});
  }
  host.role = SWAGE_THREAD_MAIN;
  for (swage_instance* i : {peel, pad}) {
    i->deactivate(i);
    i->destroy(i);
  }
  EXPECT_TRUE(host.faults.empty());
}

/// Lines along x, of 0 mm, 1 mm and so on.
void lines(double n, Visuals& out) {
  for (int i = 0; i < n; ++i) out.line({0, 0, 0}, {1e-3 * i, 0, 0}, 0);
}
struct Count {
  double lines = 2;
};
constexpr auto kLines = real<&Count::lines>("lines", "Lines", "1", "1", 0, 1000, "How many are drawn.");

class DrawnObject final : public Object<Count>, public Drawing {
 public:
  static constexpr auto id = "org.example.drawn", version = "1.0.0", name = "Drawn", summary = "Lines.", author = "Swage", licence = "Apache-2.0";
  static constexpr std::array fields = {kLines};
  void build(const Count&, Builder& builder) override { builder.fixed_body("stand"); }
  void draw(const Step&, Visuals& out) override { lines(params().lines, out); }
};

class DrawnCoupling final : public Coupling<Count>, public DrawingOnB {
 public:
  static constexpr auto id = "org.example.drawing", version = "1.0.0", name = "Drawing", summary = "Lines.", author = "Swage", licence = "Apache-2.0";
  static constexpr std::array<const char*, 0> needs_a{}, needs_b{};
  static constexpr bool detects = false;
  static constexpr std::array fields = {kLines};
  void draw(const CouplingStep&, Visuals& out) override { lines(params().lines, out); }
};

/// The bench tells what is drawn, and reports what a host has no room for.
template <class Bench, class... Objects>
void expect_drawn(uint32_t lines, bool content, Objects... objects) {
  Bench bench;
  ASSERT_TRUE(bench.set("lines", lines));
  ASSERT_TRUE(bench.start(objects...));
  EXPECT_EQ(bench.draw(), SWAGE_OK);
  ASSERT_EQ(bench.drawn.size(), std::min(lines, 80u));
  for (std::size_t i = 0; i < bench.drawn.size(); ++i) EXPECT_DOUBLE_EQ(bench.drawn[i].b.x, 1e-3 * static_cast<double>(i));
  EXPECT_EQ(bench.content(), content) << lines;
}

TEST(Bench, asks_what_is_drawn) {
  for (const uint32_t lines : {0u, 2u, 80u, 81u, 200u}) {
    expect_drawn<testbed::ObjectBench<DrawnObject>>(lines, lines <= 80);
    expect_drawn<testbed::CouplingBench<DrawnCoupling>>(lines, lines <= 80, nullptr, nullptr);
  }
}

}  // namespace
}  // namespace swage::test
