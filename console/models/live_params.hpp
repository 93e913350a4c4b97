// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What of a lesson may change while it runs: the LIVE rows of its plugins' parameter tables, with the values that the lesson
// file gives. The form, the limits and the units follow from the table alone.
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
  std::string instance;  // as the scene names it
  host::Param param;
  std::array<double, 4> start{};  // SI, as the lesson begins
  std::string folder = {};        // of the plugin's bundle, whose words these are
  std::string follows = {};       // the choice of this instance that gives the start; "" for none
  std::vector<double> start_of = {};  // by that choice, SI; NaN where the value means nothing
  std::string least_words = {};   // said in the place of the least value; "" for none

  /// From SI to what is shown: 1000 for a length in mm.
  double factor() const;
  QString unit() const;  // as shown, "" for a pure number
  /// A sensible step of a spin box, as shown: about a hundredth of the range or a twentieth of the value, rounded to 1, 2 or 5.
  double step() const;
  int decimals() const;
  /// The JSON object for session::Session::change; `value` SI.
  std::string json(const std::array<double, 4>& value) const;
};

/// In the order of the scene: objects, couplings, devices, lesson. Values are those of the file, else the table's.
QVector<LiveParam> live_params(const std::string& lesson_path, const snapshot::SceneCard& card,
                               const host::Catalogue& catalogue);
/// All numbers, switches and choices of objects, couplings, lesson and environment, for a lesson that is based on this one. Whether
/// the lesson can be assembled does not matter.
QVector<LiveParam> lesson_params(const std::string& lesson_path, const host::Catalogue& catalogue);

}  // namespace swage::console
