// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The parameters of a lesson that may change while it runs: the LIVE rows of its plugins' tables, with the values of the lesson
// file. The form with its limits and units is made from the table alone.
#pragma once

#include <QString>
#include <QVector>
#include <array>
#include <string>
#include <vector>

#include "host/catalogue.hpp"
#include "snapshot/scene_card.hpp"

namespace swage::console {

struct LiveParam {
  std::string instance;  // name in the scene
  host::Param param;
  std::array<double, 4> start{};  // SI, value at the start of the lesson
  std::string folder = {};        // of the plugin's bundle, for its translations
  std::string follows = {};       // a choice of this instance on which the start value depends; "" for none
  std::vector<double> start_of = {};  // start values by that choice, SI; NaN where the parameter has no meaning
  std::string least_words = {};   // text shown instead of the least value; "" for what the documentation says of it

  /// From SI to the display unit: 1000 for a length in mm.
  double factor() const;
  QString unit() const;  // display unit, "" for a pure number
  /// Step of a spin box in the display unit: about a hundredth of the range or a twentieth of the value, rounded to 1, 2 or 5.
  double step() const;
  int decimals() const;
  /// What the least value stands for, to be shown in its place: of "... 0: as the model says." in the documentation "as the model says",
  /// in the language of the window. "" where it is a value like any other.
  QString least_text() const;
  /// Two numbers, as the parameter's table says: the ends of a range, or sizes along two axes.
  bool is_range() const;
  bool is_size() const;
  /// The choices for a list. Fractions of one value, such as 1/4 and 2/8, are one entry that names both.
  struct Entry {
    QString words;
    QVector<int> choices;  // indices; the first one is set by the entry
  };
  QVector<Entry> entries() const;
  /// The JSON object for session::Session::change; `value` SI.
  std::string json(const std::array<double, 4>& value) const;
};

/// What may be changed during an attempt, but for hidden parameters, as of a circle that the window tells itself. Order of the scene: objects,
/// couplings, devices, lesson. Values are those of the file, else the table's defaults.
QVector<LiveParam> live_params(const std::string& lesson_path, const snapshot::SceneCard& card,
                               const host::Catalogue& catalogue);
/// All numbers, switches and choices of objects, couplings, lesson and environment, for a lesson derived from this one. The lesson
/// need not be valid as an assembly.
QVector<LiveParam> lesson_params(const std::string& lesson_path, const host::Catalogue& catalogue);

}  // namespace swage::console
