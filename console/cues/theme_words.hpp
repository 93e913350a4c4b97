// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Titles, texts and sound names of the themes in the language of the window. Themes are data files: translatable texts are listed here.
#pragma once

#include <QString>
#include <QStringList>

namespace swage::console {

QString theme_word(const QString& text);
/// All translatable texts.
QStringList theme_words();

}  // namespace swage::console
