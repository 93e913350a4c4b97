// SPDX-License-Identifier: Apache-2.0
//
// Couplings that look at places of a thread take as many as it has nodes: between fewer of them a narrow bend is cut off, and what it goes
// round is gone through.
#include <swage/abi/strand.h>

#include <algorithm>
#include <cmath>

#include "stage.hpp"

namespace swage::coupling_knot {
namespace {

constexpr double kLength = 20e-3, kHalf = 10e-3, kTurn = 1e-3;  // m
constexpr uint32_t kNodes = 101, kPlaces = 51;

/// A thread that lies along x for half of its length, turns back beside it, and crosses over itself in a hump of one node, 0.3 mm high, between
/// two of the places that are looked at.
struct HumpedThread {
  explicit HumpedThread(bool tells_nodes) {
    raw.self = this;
    tells = tells_nodes;
    raw.get_extension = [](swage_instance* i, const char* id) -> const void* {
      static const swage_strand strand{law, place, nullptr};
      static const swage_strand_nodes nodes{[](swage_instance*, const swage_object_step*, uint32_t* out) { return *out = kNodes, swage_result{SWAGE_OK}; }};
      if (std::strcmp(id, SWAGE_TRAIT_STRAND) == 0) return &strand;
      const bool told = static_cast<HumpedThread*>(i->self)->tells && std::strcmp(id, SWAGE_TRAIT_STRAND_NODES) == 0;
      return told ? &nodes : nullptr;
    };
  }
  static swage_result law(swage_instance*, const swage_object_step*, swage_strand_law* out) {
    *out = {kLength, 22e-6, 0.5, 0.5};
    return SWAGE_OK;
  }
  static swage_result place(swage_instance* i, const swage_object_step*, double s, swage_strand_place* out) {
    const double foot = static_cast<HumpedThread*>(i->self)->foot, turned = s - kHalf + kTurn, back = s - kHalf - kTurn;
    constexpr double kOver = 4e-3, kCrossing = 4.03e-3;  // m back: node 75, at the top of the hump, and where the thread crosses itself
    const double hump = std::max(0.0, 1 - std::abs(back - kOver) / (kLength / (kNodes - 1)));
    *out = {};
    out->s = s;
    if (turned < 0)
      out->p_W = {s, 0, 0};
    else if (back < 0)
      out->p_W = {kHalf - kTurn, turned, 0.5 * turned / kTurn * foot};
    else
      out->p_W = {kHalf - kTurn - 0.8 * back, 2 * kTurn * (1 - back / kCrossing), foot + 0.3e-3 * hump};
    return SWAGE_OK;
  }
  swage_instance raw{};
  double foot = 0;  // m, height of the second half beside its hump
  bool tells = false;
};

/// Passages that the coupling counts while the thread comes down beside its hump, which stays above the strand below.
double passages(bool tells_nodes) {
  stage::Stage stage("swage.coupling.knot");
  HumpedThread thread(tells_nodes);
  EXPECT_EQ(stage.configure({{"places", kPlaces}}), SWAGE_OK);
  const auto& table = stage.table<swage_coupling>(SWAGE_EXT_COUPLING);
  EXPECT_EQ(table.bind(stage.raw(), &thread.raw, &thread.raw), SWAGE_OK);
  EXPECT_EQ(stage.activate(), SWAGE_OK);
  stage.on_rt();
  std::vector<double> state(stage.n_state), signal(stage.declared[SWAGE_DECLARE_SIGNAL].size());
  swage_coupling_step s{};
  swage_object_step a{}, b{};
  s.struct_size = sizeof(s), s.dt_s = 1e-3, s.a = &a, s.b = &b;
  s.state = state.data(), s.n_state = static_cast<uint32_t>(state.size());
  s.signal = signal.data(), s.n_signal = static_cast<uint32_t>(signal.size());
  s.event = [](const swage_coupling_step*, uint32_t, double) {};
  table.reset(stage.raw(), &s);
  for (const double foot : {100e-6, -50e-6}) {
    thread.foot = foot;
    EXPECT_EQ(table.resolve(stage.raw(), &s), SWAGE_OK);
    EXPECT_EQ(table.finish(stage.raw(), &s), SWAGE_OK);
  }
  return signal[stage.index_of(SWAGE_DECLARE_SIGNAL, "knot.passages")];
}

TEST(StrandNodes, AFinerThreadIsLookedAtAtAllOfThem) { EXPECT_EQ(passages(true), 0); }

// of a thread that does not tell its nodes a chord over the hump goes down through the strand
TEST(StrandNodes, BetweenFewerPlacesItGoesThroughItself) { EXPECT_EQ(passages(false), 1); }

}  // namespace
}  // namespace swage::coupling_knot
