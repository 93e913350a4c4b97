// SPDX-License-Identifier: Apache-2.0
//
// Attempts as they leave the store: with the lesson's version, the versions of what measured, class of input, timing, solver health
// and calibration. People are codes. [main]
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "record/store.hpp"

namespace swage::record {

/// A number that says how well an attempt was measured: "steps.late", "solver.not_converged".
struct Health {
  std::string id, unit;
  double value = 0;
};

struct Exported {
  AttemptRow attempt;
  std::string station, app_version;
  std::string input;          // "scripted", "force" (device with forces), "position"; "" when nobody kept it
  std::string plugins;        // "swage.object.needle 1.0.0; ..."
  std::string metric_version;  // of the lesson plugin that measured; "" when the recording does not say
  std::string calibration;    // JSON: sensor, day, residual, checksum of each calibration that was used; "[]" for none
  std::string display;        // how the scene was seen: "mono", "side, eyes swapped"; "" when nobody looked
  double dt_s = 0;
  bool realtime = false;
  std::vector<Health> health;
  std::vector<Grade> grades;  // what later versions of the lesson said
};

struct Selection {
  std::string person_id, lesson_id, attempt_id;  // "" for all
};
/// Oldest first. False with a sentence when the store could not be read.
bool read_for_export(const std::string& where, const Selection&, std::vector<Exported>& out, std::string& error);

/// One row per attempt and metric, and per metric of each later judging. RFC 4180, one line per row whatever a title holds; text
/// that a spreadsheet would calculate begins with an apostrophe.
std::string csv_long(const std::vector<Exported>&);
/// One row per attempt, one column per metric.
std::string csv_wide(const std::vector<Exported>&);
/// What an attempt is, for exports that hold numbers only: JSON.
std::string about_json(const Exported&);

/// One statement per attempt that has ended, as the Experience API 1.0.3 asks: a JSON array. The same attempt gives the same
/// statement, identifier included, so that sending it twice does no harm. `home`: IRI of the school, "https://school.example.org".
bool xapi_statements(const std::vector<Exported>&, const std::string& home, std::string& out, std::string& error);

/// A text as a field of CSV.
std::string csv_field(const std::string& text);

}  // namespace swage::record
