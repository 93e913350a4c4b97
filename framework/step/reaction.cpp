// SPDX-License-Identifier: Apache-2.0
#include "step/reaction.hpp"

#include <algorithm>

namespace swage::step {
namespace {

double from_table(const std::vector<host::Reaction::Point>& table, double f) noexcept {
  std::size_t i = 0;
  while (i + 2 < table.size() && f > table[i + 1].scene) ++i;
  const auto &a = table[i], &b = table[i + 1];
  return a.hand + (f - a.scene) * (b.hand - a.hand) / (b.scene - a.scene);
}

}  // namespace

double felt_force(const host::Reaction& reaction, double f) noexcept {
  switch (reaction.law) {
    case host::Law::kNullZone:
      return std::max(0.0, f - reaction.from);
    case host::Law::kThreshold:
      return f > reaction.from ? f : 0;
    case host::Law::kQuadratic:
      return f * f / reaction.from;
    case host::Law::kTable:
      return from_table(reaction.table, f);
    case host::Law::kProportional:
      break;
  }
  return f;
}

}  // namespace swage::step
