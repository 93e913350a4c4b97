// SPDX-License-Identifier: Apache-2.0
//
// Failures of a solver: counters, all zero in a well-posed scene. One table has their names for every
// display: console, `swage run`, record of an attempt.
#pragma once

#include <cstdint>
#include <string>

namespace swage::base {

/// Counted since the start of the run.
struct SolverHealth {
  uint64_t steps = 0;             // steps in which any other counter increased
  uint64_t not_converged = 0;     // islands left at the best point found
  uint64_t over_budget = 0;       // steps that reached their work budget
  uint64_t dropped_contacts = 0;  // contacts without a force, for lack of room
  uint64_t dropped_ties = 0;      // the same for ties
  uint64_t shared_points = 0;     // contacts of flexible bodies solved at the nearest point, for lack of room
  uint64_t unanswered = 0;        // contact points for which a flexible body gave no valid mobility: it was fixed there

  uint64_t total() const {
    return not_converged + over_budget + dropped_contacts + dropped_ties + shared_points + unanswered;
  }
};

struct SolverHealthField {
  uint64_t SolverHealth::*count;
  const char* id;   // in JSON
  const char* doc;  // after a number: "3 islands not converged"
};

inline constexpr SolverHealthField kSolverHealthFields[] = {
    {&SolverHealth::not_converged, "not_converged", "islands not converged"},
    {&SolverHealth::over_budget, "over_budget", "steps over the work budget"},
    {&SolverHealth::dropped_contacts, "dropped_contacts", "contacts dropped for lack of room"},
    {&SolverHealth::dropped_ties, "dropped_ties", "ties dropped for lack of room"},
    {&SolverHealth::shared_points, "shared_points", "contacts that share a point for lack of room"},
    {&SolverHealth::unanswered, "unanswered", "contact points without an answer"},
};

/// "3 islands not converged, 1 contacts dropped ..."; "" when all counters are zero. [main]
inline std::string text(const SolverHealth& health) {
  std::string out;
  for (const SolverHealthField& field : kSolverHealthFields) {
    if (health.*field.count == 0) continue;
    out += (out.empty() ? "" : ", ") + std::to_string(health.*field.count) + " " + field.doc;
  }
  return out;
}

}  // namespace swage::base
