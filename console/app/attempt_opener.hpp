// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Opens attempts on the Review page: of the store, or of a file. [main]
#pragma once

#include <QObject>
#include <optional>

#include "console/app/window_pages.hpp"

namespace swage::console {

class AttemptOpener : public QObject {
  Q_OBJECT
 public:
  /// `window`: parent of the file dialog. All outlive it.
  AttemptOpener(const WindowPages* pages, StoreLink* store, QWidget* window);
  void open(const QString& attempt_id);
  /// An attempt of the store, "latest" for the newest, at a time of it, s.
  void open_at(const QString& attempt_id, std::optional<double> time_s);
  /// Asks for a file with an attempt.
  void ask_file();
  void open_file(const QString& file);

 private:
  const WindowPages* pages_;
  StoreLink* store_;
  QWidget* window_;
};

}  // namespace swage::console
