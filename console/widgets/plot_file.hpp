// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

namespace swage::console {

/// Writes what a plot shows: .png in twice its size on the screen, .svg and .pdf as lines and letters. "" or what went wrong.
QString save_plot(QWidget& plot, const QString& file);
/// Gives a plot "Save picture…" in its context menu and as Ctrl+Shift+P while it has the keyboard. `name`: of the file, without ending.
void offer_picture(QWidget* plot, const QString& name);

}  // namespace swage::console
