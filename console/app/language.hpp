// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The language of the window and the format of its numbers and dates. English is in the sources; other languages are in
// console/translations and are compiled into the program.
#pragma once

#include <QString>
#include <QStringList>

#include "console/app/settings.hpp"

namespace swage::console {

/// Codes of all languages, "en" first.
QStringList languages();

/// The value of --language among the arguments, "" where absent. It is read before the command line, whose help is translated, too.
QString language_in(const QStringList& arguments);

/// The name of a language in that language.
QString language_name(const QString& code);

/// The language of the command line, else the one chosen on the Setup page; "" for the system's. Screenshots for the documentation ignore
/// the choice on the Setup page.
QString wanted_language(const QStringList& arguments, const Settings& settings);

/// To be called before the first widget. "": the system's language if translated, else English, with the system's number format.
/// Returns false for an unknown language and changes nothing then.
bool use_language(const QString& code);

}  // namespace swage::console
