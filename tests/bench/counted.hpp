// SPDX-License-Identifier: Apache-2.0
//
// swage-bench count: the work of the steps of one scene, in numbers that do not depend on the machine.
#pragma once

#include <string>

namespace swage::bench {

struct CountWanted {
  std::string scene;  // one of count_scenes()
  int every = 10;     // of so many steps one goes through counted_step()
  std::string list;   // file with a line a step; "": none
  int most = 0;       // search directions allowed in a step; 0: any number
};

std::string count_scenes();

/// Runs the scene and prints how many search directions, passes, contacts and multiply-adds its steps take, and a hash of all of them, which
/// is equal where the same bits were computed. 1 where a step takes more directions than allowed, else 0. Throws std::runtime_error where there is no such scene or a file cannot be written.
///
/// Instructions function by function: valgrind --tool=callgrind --collect-atstart=no --toggle-collect='*counted_step*' swage-bench count ...
int run_count(const CountWanted& wanted);

}  // namespace swage::bench
