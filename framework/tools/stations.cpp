// SPDX-License-Identifier: Apache-2.0
//
// swage stations: the present state of every station of the school.
#include "record/stations.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/school_verbs.hpp"

namespace swage::tools {
namespace {

using Json = nlohmann::ordered_json;
using record::StationNow;

std::string state_of(const StationNow& n) {
  if (n.lost()) return "lost";
  constexpr const char* kWords[] = {"ready", "runs", "paused", "finished", "closed"};
  return kWords[static_cast<int>(n.state)];
}

Json to_json(const StationNow& n) {
  return {{"station", n.station},
          {"state", state_of(n)},
          {"silent_s", number(n.silent_s)},
          {"person", n.person},
          {"lesson", n.lesson_id},
          {"title", n.lesson_title},
          {"mode", n.mode},
          {"phase", n.phase},
          {"cues", n.cues},
          {"attempt", n.attempt_id},
          {"time_s", number(n.time_s)},
          {"score", number(n.score)},
          {"force_N", number(n.force_N)},
          {"late", n.late},
          {"dropped", n.dropped},
          {"solver_short", n.solver},
          {"parts_stopped", n.stopped},
          {"devices_silent", n.silent_devices},
          {"recorded", n.recorded},
          {"version", n.app_version}};
}

void print_line(const StationNow& n) {
  const std::string state = n.lost() ? format("lost for %.0f s", n.silent_s) : state_of(n);
  const std::string force = std::isfinite(n.force_N) ? format("%.2f N", n.force_N) : "";
  std::printf("%-20s %-16s %-24s %-32s %6.1f s %8s  %s\n", printable(n.station).c_str(), state.c_str(), printable(n.person).c_str(),
              printable(n.lesson_title).c_str(), n.time_s, force.c_str(), printable(n.phase).c_str());
}

}  // namespace

int list_stations(const StationsOptions& o) {
  std::string error;
  const auto stations = record::Stations::open(store_place(o.store), error);
  if (!stations) return problem(error);
  std::vector<StationNow> all;
  if (!stations->all(all)) return problem(stations->error());
  Json list = Json::array();
  for (const StationNow& n : all) o.json ? list.push_back(to_json(n)) : print_line(n);
  if (o.json) print(list);
  if (!o.json && all.empty()) std::printf("no station yet: swage-console --store %s on each\n", "postgresql://user@host/database");
  return kPassed;
}

}  // namespace swage::tools
