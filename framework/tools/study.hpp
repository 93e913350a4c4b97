// SPDX-License-Identifier: Apache-2.0
//
// A study: one lesson over a matrix of variants and hands, as in the thesis's appendix D. Format "swage-study/1":
//
//   { "format": "swage-study/1", "title": "...", "lesson": "../series/x.json", "repeats": 3, "seed": 1,
//     "factors": [ { "name": "Needle", "levels": [ { "name": "2/8", "set": { "needle.arc": "2/8" } }, ... ] }, ... ],
//     "hands":   [ { "name": "expert", "device": "expert", "params": { } }, ... ],
//     "figures": [ { "metric": "wound.size", "title": "...", "unit": "%", "scale": 100, "file": "wound.svg" } ] }
//
// A level may name another "lesson", so that a study can cover several; "score" is a metric of every lesson.
//
// [main]
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/problem.hpp"

namespace swage::tools {

struct StudyLevel {
  std::string name;
  std::vector<std::string> settings;  // "needle.arc=2/8"
  std::string lesson;                 // path; "": the lesson of the study
};
struct StudyFactor {
  std::string name;
  std::vector<StudyLevel> levels;
};
struct StudyHand {
  std::string name, device, params;  // params: JSON object or ""
};
struct StudyFigure {
  std::string metric, title, unit, file;
  double scale = 1;  // factor from the metric's value to the value shown
};
struct Study {
  std::string title, lesson;  // lesson: path
  uint64_t repeats = 1, seed = 1;
  std::vector<StudyFactor> factors;  // one or two
  std::vector<StudyHand> hands;
  std::vector<StudyFigure> figures;
};

/// One attempt of a study.
struct StudyRow {
  std::size_t level[2] = {0, 0};  // of each factor
  std::size_t hand = 0;
  uint64_t seed = 0;
  bool passed = false;
  std::string reason;
  double score = 0;
  std::map<std::string, double> metric;
};

/// False and `problems` when the file is no study.
bool read_study(const std::string& path, Study& out, base::Problems& problems);
/// A metric over the repeats of a cell, of passed and failed attempts alike; NaN when no attempt has it.
struct Cell {
  double mean = 0, least = 0, most = 0;
  std::size_t passed = 0, of = 0;
};
Cell cell_of(const std::vector<StudyRow>& rows, std::size_t level0, std::size_t level1, std::size_t hand,
             const std::string& metric);
std::string study_csv(const Study& study, const std::vector<StudyRow>& rows);
/// Figure with a dot for every attempt, hollow where it was not passed, and the mean of each cell.
std::string study_svg(const Study& study, const StudyFigure& figure, const std::vector<StudyRow>& rows);

}  // namespace swage::tools
