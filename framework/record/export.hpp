// SPDX-License-Identifier: Apache-2.0
//
// Export of attempts: with the lesson's version, the versions of the measuring plugins, class of input, timing, solver health
// and calibration. People are identified by codes. [main]
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "record/store.hpp"

namespace swage::record {

/// A number on the quality of an attempt's data: "steps.late", "solver.not_converged".
struct Health {
  std::string id, unit;
  double value = 0;
};

struct Exported {
  AttemptRow attempt;
  std::string station, app_version;
  std::string input;          // "scripted", "force" (device with forces), "position"; "" where unknown
  std::string plugins;        // "swage.object.needle 1.0.0; ..."
  std::string metric_version;  // of the lesson plugin that computed the metrics; "" where the recording has none
  std::string calibration;    // JSON: sensor, date, residual, checksum of each calibration that was used; "[]" for none
  std::string display;        // "mono", "side, eyes swapped"; "" without a viewer
  double dt_s = 0;
  bool realtime = false;
  std::vector<Health> health;
  std::vector<Grade> grades;  // results by later versions of the lesson
};

struct Selection {
  std::string person_id, lesson_id, attempt_id;  // "" for all
};
/// Oldest first. False with a sentence when the store could not be read.
bool read_for_export(const std::string& where, const Selection&, std::vector<Exported>& out, std::string& error);

/// One row per attempt and metric, and per metric of each later grading. RFC 4180, one line per row for any title; text
/// that a spreadsheet would evaluate begins with an apostrophe.
std::string csv_long(const std::vector<Exported>&);
/// One row per attempt, one column per metric.
std::string csv_wide(const std::vector<Exported>&);
/// Description of an attempt, for exports of numbers only: JSON.
std::string about_json(const Exported&);

/// One statement per ended attempt, as in the Experience API 1.0.3: a JSON array. The same attempt gives the same
/// statement with the same identifier, so that it may be sent twice. `home`: IRI of the school, "https://school.example.org".
bool xapi_statements(const std::vector<Exported>&, const std::string& home, std::string& out, std::string& error);

/// A text as a field of CSV.
std::string csv_field(const std::string& text);

}  // namespace swage::record
