// SPDX-License-Identifier: Apache-2.0
#include "bar.hpp"

namespace swage::bench {

Line ratio(const char* goal, std::string name, double ours, double theirs, double high) {
  return at_most(
      goal, std::move(name), "x", ours / theirs, high,
      std::to_string(std::lround(ours)) + " ns against " + std::to_string(std::lround(theirs)) + " ns");
}

const std::vector<Goal>& goals() {
  static const std::vector<Goal> all = {{"G1", bar_queries},
                                        {"G2", bar_grasp},
                                        {"G3", bar_pinch},
                                        {"G3-slip", bar_slip},
                                        {"G6", bar_free},
                                        {"G7", bar_tunnel},
                                        {"G7-speed", bar_swept},
                                        {"table-6-1", bar_table_61},
                                        {"table-6-2", bar_table_62},
                                        {"S01", bar_units},
                                        {"grasp", bar_creep},
                                        {"S46", bar_shots},
                                        {"S47", bar_couple},
                                        {"insertion", bar_insertion},
                                        {"tissue", bar_tissue},
                                        {"needle", bar_needle},
                                        {"thread", bar_thread}};
  return all;
}

}  // namespace swage::bench
