// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

namespace swage::console {

/// Asks where to save a file, `name` first, with filters in QFileDialog's form; "" when cancelled. A name typed without an
/// extension gets that of the chosen filter. Main thread; waits for the person.
QString ask_save(QWidget* parent, const QString& title, const QString& name, const QString& filters);

}  // namespace swage::console
