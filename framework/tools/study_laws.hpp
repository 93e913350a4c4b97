// SPDX-License-Identifier: Apache-2.0
//
// A study of reaction laws over one recorded hand: the scene is stepped once on its samples, and each law makes of the same contact
// forces what a hand would be given, through a force guard of its own. Format "swage-laws/1":
//
//   { "format": "swage-laws/1", "title": "...", "lesson": "../series/110_insertion.json", "hand": "expert", "seed": 1,
//     "device": "hand", "force_scale": 20, "max_force": "3.3 N",
//     "laws": [ { "name": "as it is", "reaction": { "law": "proportional" } },
//               { "name": "null zone", "reaction": { "law": "null zone", "from": "5 mN" } } ],
//     "file": "reactions.svg" }
//
// Instead of lesson, hand and seed, "attempt" names a file that `swage attempts export` wrote. [main]
#pragma once

#include <string>
#include <vector>

#include "base/problem.hpp"
#include "host/hand_shaping.hpp"

namespace swage::tools {

struct LawsPlan {
  struct Law {
    std::string name;
    host::Reaction reaction;
  };
  std::string title, lesson, hand, attempt, device, file;  // lesson, attempt: paths
  uint64_t seed = 1;
  double force_scale = 1, max_force = 3.3;  // max_force: N, that the arm bears
  std::vector<Law> laws;                    // two to five; all are compared with the first
};

/// What a hand was given under one law.
struct LawRun {
  std::vector<double> wanted, given;  // N, size, of each step
  double peak = 0;                    // N
  double impulse = 0;                 // N s
  double steepest = 0;                // N/s
  double silent = 0;                  // share of the contact's time in which the law gives no force
  double cut = 0;                     // share of it in which the guard gave less than 99 % of what was wanted
  double off = 0;                     // N, root mean square difference from the first law's force, over the contact's time
};

struct LawsResult {
  double dt = 1e-3;           // s
  std::vector<double> scene;  // N, size of the contact forces on the tool
  std::vector<LawRun> laws;
};

/// Whether a file says that it is one.
bool is_laws_plan(const std::string& text);
bool read_laws(const std::string& path, LawsPlan& out, base::Problems& problems);
/// False and `problems`: the hand could not be played or read, or what is stepped is not what was recorded.
bool run_laws(const LawsPlan& plan, const std::vector<std::string>& plugin_dirs, LawsResult& out, base::Problems& problems);
std::string laws_csv(const LawsPlan& plan, const LawsResult& result);
/// The laws themselves, and what they gave over the time.
std::string laws_svg(const LawsPlan& plan, const LawsResult& result);

}  // namespace swage::tools
