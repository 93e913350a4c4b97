// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

namespace swage::console {

/// Writes a plot: .png at twice its screen size, .svg and .pdf as vector graphics. Returns "" or the error.
QString save_plot(QWidget& plot, const QString& file);
/// Adds "Save picture…" to a plot's context menu, with Ctrl+Shift+P while it has the focus. `name`: of the file, without extension.
void offer_picture(QWidget* plot, const QString& name);

}  // namespace swage::console
