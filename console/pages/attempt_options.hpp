// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What an attempt is opened with: what holds for every session here, what is chosen on the Run page, where the instrument stands. [main]
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

/// Where the instrument stands that is called so; nothing: as the lesson says.
using Placing = std::function<std::optional<Placement>(const std::string& device)>;

class AttemptOptions {
 public:
  explicit AttemptOptions(const SetupPanel& setup) : setup_(setup) {}
  /// What every session is opened with: plugins, store, pace.
  void set_base(const session::Options& base);
  const host::Catalogue& catalogue() const { return catalogue_; }
  void set_placing(Placing placing) { placing_ = std::move(placing); }
  /// A person's own instrument; whether it is another than before.
  bool set_binding(const Binding& binding);
  /// What it is called; "" when there is none.
  QString instrument_title() const;
  /// A demonstration is nobody's attempt, whatever mode is chosen.
  void set_show(bool show) { show_ = show; }

  /// A lesson by itself, with no hand chosen.
  session::Options of(const QString& lesson_path) const;
  /// The lesson as it is chosen, whoever plays it.
  session::Options lesson(const record::Display& display) const;
  /// And with the chosen hand. `cues`: how they feel on a device that takes forces.
  session::Options attempt(const record::Display& display, const CueTheme& cues) const;
  /// The chosen instrument at the origin, without forces: to read it.
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
