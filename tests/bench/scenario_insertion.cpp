// SPDX-License-Identifier: Apache-2.0
#include "insertion.hpp"

#include <map>
#include <stdexcept>

#include "pierce_feats.hpp"

namespace swage::bench {
namespace {

using test::Feat;
using test::FeatMethod;

const std::map<std::string, FeatMethod>& methods() {
  static const std::map<std::string, FeatMethod> all = [] {
    std::map<std::string, FeatMethod> m;
    m["swage"] = {};
    m["swage, level plane"].level = tissue::Level::kPlane;
    m["swage, level mesh"].level = tissue::Level::kMesh;
    m["swage, steps of 10 ms"].rate_hz = 100;
    m["swage, impulse method of the thesis"].options.dynamics.response = dynamics::Response::kImpulse;
    FeatMethod& penalty = m["swage, penalty forces"];
    penalty.explicit_ties = true;
    penalty.options.dynamics.response = dynamics::Response::kImpulse;
    return m;
  }();
  return all;
}

using Run = Feat (*)(const FeatMethod&, double);
const std::map<std::string, Run>& runs() {
  static const std::map<std::string, Run> all = {
      {"pierce_drive", test::drive},
      {"pierce_graze", [](const FeatMethod& m, double angle) { return test::graze(m, angle); }},
      {"pierce_two_tissues", test::two_tissues},
      {"pierce_tear_to_rim", test::tear_to_rim},
      {"pierce_regrasp_behind", [](const FeatMethod& m, double v) { return test::regrasp(m, v, false); }},
      {"pierce_regrasp_by_point", [](const FeatMethod& m, double v) { return test::regrasp(m, v, true); }},
      {"pierce_stiffness", test::stiffness},
      {"pierce_elastic", test::elastic}};
  return all;
}

}  // namespace

const std::vector<InsertionMethod>& insertion_methods() {
  static const std::vector<InsertionMethod> all = {{"swage", "swage"},
                                                   {"swage", "swage, level plane"},
                                                   {"swage", "swage, level mesh"},
                                                   {"swage", "swage, steps of 10 ms"},
                                                   {"thesis", "swage, impulse method of the thesis"},
                                                   {"thesis", "swage, penalty forces"}};
  return all;
}

bool is_insertion(const std::string& scenario) { return scenario.rfind("pierce_", 0) == 0; }

double insertion_error(const std::string& scenario, const std::string& method, double value) {
  const auto run = runs().find(scenario);
  if (run == runs().end()) throw std::runtime_error("/scenario: \"" + scenario + "\" is unknown");
  return run->second(methods().at(method), value).error();
}

}  // namespace swage::bench
