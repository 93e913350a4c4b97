// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The colours of the window and the look of the cues, on every page; remembered between launches. [main]
#pragma once

#include <QObject>

#include "console/app/command_line.hpp"
#include "console/app/settings.hpp"
#include "console/app/window_pages.hpp"

namespace swage::console {

class WindowTheme : public QObject {
  Q_OBJECT
 public:
  /// Both outlive it.
  WindowTheme(const WindowPages* pages, Settings& settings);
  /// As the launch says, else as remembered. After the plugins are known, as it names their cues.
  void restore(const Launch& launch);
  void remember() const;
  void set(const QString& ui, const QString& cues);
  const QString& ui() const { return ui_; }
  /// The cues as they are shown now.
  CueTheme cues() const;

 private:
  CueTheme cue_theme(const QString& id, bool dark) const;

  const WindowPages* pages_;
  Settings& settings_;
  QString ui_, cues_;  // ids
};

}  // namespace swage::console
