// SPDX-License-Identifier: Apache-2.0
#include "engine.hpp"

namespace swage::bench {
namespace {

template <class Item>
std::vector<Item> joined(std::initializer_list<std::vector<Item>> lists) {
  std::vector<Item> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace

std::vector<Method> all_methods() {
  return joined<Method>({swage_methods(), ode_methods(), mujoco_methods(), bullet_methods()});
}

std::vector<Query> all_queries(const Needle& n) {
  return joined<Query>(
      {swage_queries(n), ode_queries(n), mujoco_queries(n), bullet_queries(n), fcl_queries(n)});
}

}  // namespace swage::bench
