// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The options of a session: the common ones, the choices on the Run page, the placement of the instrument. [main]
#pragma once

#include <QString>
#include <functional>
#include <optional>

#include "console/cues/cue_theme.hpp"
#include "console/models/instrument.hpp"
#include "console/pages/setup_panel.hpp"
#include "host/catalogue.hpp"
#include "session/session.hpp"

namespace swage::console {

/// The placement of the device with this name; no value: the lesson's.
using Placing = std::function<std::optional<Placement>(const std::string& device)>;

class AttemptOptions {
 public:
  explicit AttemptOptions(const SetupPanel& setup) : setup_(setup) {}
  /// Options common to all sessions: plugins, store, pace.
  void set_base(const session::Options& base);
  const host::Catalogue& catalogue() const { return catalogue_; }
  void set_placing(Placing placing) { placing_ = std::move(placing); }
  /// Sets the person's own instrument; returns whether it changed.
  bool set_binding(const Binding& binding);
  /// The name of that instrument; "" when there is none.
  QString instrument_title() const;
  /// True for a demonstration, which is nobody's attempt, in any mode.
  void set_show(bool show) { show_ = show; }

  /// Options of a lesson with no device chosen.
  session::Options of(const QString& lesson_path) const;
  /// Options of the chosen lesson, without the device.
  session::Options lesson(const record::Display& display) const;
  /// Options of the chosen lesson with the chosen device. `cues`: their force pulses on force-feedback devices.
  session::Options attempt(const record::Display& display, const CueTheme& cues) const;
  /// Options that read the chosen device: placed at the origin, without forces.
  session::Options reader() const;

 private:
  void take_instrument(session::Options& o, const std::optional<Placement>& place) const;

  const SetupPanel& setup_;
  session::Options base_;
  host::Catalogue catalogue_;
  Placing placing_;
  Binding binding_;
  bool show_ = false;
};

}  // namespace swage::console
