// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

namespace swage::console {

/// Asks where to save a file, `name` first, with filters as QFileDialog has them; "" when it is left. A name that is typed without an
/// ending gets that of the chosen filter. Main thread; waits for the person.
QString ask_save(QWidget* parent, const QString& title, const QString& name, const QString& filters);

}  // namespace swage::console
