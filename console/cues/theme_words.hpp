// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Titles, words and names of sounds of the themes, in the language of the window. Themes are data, so the words are listed here too.
#pragma once

#include <QString>
#include <QStringList>

namespace swage::console {

QString theme_word(const QString& text);
/// All that can be translated.
QStringList theme_words();

}  // namespace swage::console
