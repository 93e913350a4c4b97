// SPDX-License-Identifier: Apache-2.0
//
// Lessons made from the shipped ones: one value replaced by a nasty one, several parameters at their bounds, parts moved about.
// Every one is named by its number. [main]
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/catalogue.hpp"

namespace swage::fuzz {

using Json = nlohmann::ordered_json;

struct Seed {
  std::string name;  // of the file
  Json lesson;       // whole
};

/// The lessons of the series, whole, by name.
std::vector<Seed> shipped_lessons(const std::string& folder);

struct Mutant {
  std::string from;    // the file it was made of
  std::string change;  // what was changed, for people
  Json lesson;
};

class Mutants {
 public:
  Mutants(std::vector<Seed> seeds, const host::Catalogue& catalogue);

  /// Every value of every lesson, each replaced by each of a list.
  uint64_t substitutions() const { return places_.size() * nasty_.size(); }
  Mutant substitution(uint64_t number) const;

  /// Two parameters of one lesson at their bounds; `number` is the seed.
  Mutant at_bounds(uint64_t number) const;

  /// Up to four of: a value replaced, a part lost, a part twice, a part of another lesson; `number` is the seed.
  Mutant mixed(uint64_t number) const;

 private:
  struct Place {
    std::size_t seed;
    Json::json_pointer pointer;
  };
  struct Bound {
    std::size_t seed;
    Json::json_pointer params;  // of the instance
    const host::Param* param;
  };
  void collect(std::size_t seed, const Json& at, const Json::json_pointer& pointer);
  void collect_bounds(std::size_t seed, const Json& use, const Json::json_pointer& pointer,
                      const host::Catalogue& catalogue);

  std::vector<Seed> seeds_;
  std::vector<Json> nasty_;
  std::vector<Place> places_;
  std::vector<std::vector<Json::json_pointer>> of_seed_;  // places of each lesson
  std::vector<Bound> bounds_;
  std::vector<std::vector<std::size_t>> bounds_of_;  // of each lesson
};

}  // namespace swage::fuzz
