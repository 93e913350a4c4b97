// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The language of the window, and with it the form of its numbers and dates. English is in the sources; other languages are in
// console/translations and travel inside the program.
#pragma once

#include <QString>
#include <QStringList>

#include "console/app/settings.hpp"

namespace swage::console {

/// "en" first.
QStringList languages();

/// The value of --language among the arguments; "" where it is not given. Read before the command line is: its help is translated, too.
QString language_in(const QStringList& arguments);

/// What a language calls itself.
QString language_name(const QString& code);

/// That of the command line, else the one chosen on the Setup page; "" for that of the system. A picture for the documentation does not
/// depend on what somebody chose.
QString wanted_language(const QStringList& arguments, const Settings& settings);

/// Before the first widget. "": the system's language where there is a translation, else English, with the system's numbers.
/// False for a language that there is not; nothing has changed then.
bool use_language(const QString& code);

}  // namespace swage::console
