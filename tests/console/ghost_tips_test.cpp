// SPDX-License-Identifier: Apache-2.0
//
// The words beside the instruments of a ghost.
#include <gtest/gtest.h>
#include <swage/abi/builder.h>

#include "console/models/said.hpp"
#include "console/view3d/ghost_tools.hpp"
#include "test_places.hpp"

namespace swage::console {
namespace ghost_tips_test {

// A gripper with a shaft of 40 mm, led by a hand.
void add_tool(const char* name, snapshot::SceneCard& card) {
  const auto i = static_cast<uint32_t>(card.objects.size());
  card.objects.push_back({name, "x", "1", {SWAGE_TRAIT_GRIPPER}, i, 1, 0, 0});
  snapshot::CardShape shaft;
  shaft.kind = SWAGE_SHAPE_CONVEX;
  shaft.flags = SWAGE_SHAPE_USUAL;
  shaft.body = shaft.object = i;
  shaft.X_BS.q = {1, 0, 0, 0};
  for (int c = 0; c < 8; ++c) shaft.vertex.push_back({c & 1 ? 40e-3 : 0, c & 2 ? 1e-3 : -1e-3, c & 4 ? 1e-3 : 0});
  shaft.face = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  card.shapes.push_back(shaft);
  card.start.push_back({{6e-3, 5e-3 * i, 2e-3}, {1, 0, 0, 0}});
  card.motion.push_back(SWAGE_MOTION_FOLLOWS);
}

std::vector<QString> words(const snapshot::SceneCard& card) {
  std::vector<QString> out;
  for (const GhostTips& tool : ghost_tips(card, make_parts(card), "Expert")) out.push_back(tool.words);
  return out;
}

TEST(GhostTips, EachOfSeveralInstrumentsHasItsOwnName) {
  snapshot::SceneCard card;
  add_tool("holder", card);
  EXPECT_EQ(words(card), std::vector<QString>{"Expert"}) << "one needs no name of its own";
  add_tool("forceps", card);
  EXPECT_EQ(words(card), (std::vector<QString>{"Expert: Holder", "Expert: Forceps"}));
  set_words_language("de");
  learn_words(SWAGE_SOURCE_DIR "/lessons/series/words");
  EXPECT_EQ(words(card), (std::vector<QString>{"Expert: Nadelhalter", "Expert: Pinzette"}));
  set_words_language("en");
}

}  // namespace ghost_tips_test
}  // namespace swage::console
