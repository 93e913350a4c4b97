// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What plugins and lessons say, in the language of the window: from the files words.<language>.json beside them (host/words.hpp), a
// stranger's like ours. What nobody has translated is shown as it was said. Only what is shown is translated: nothing here goes into
// a record. GUI thread.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "base/problem.hpp"
#include "judge/verdict.hpp"

namespace swage::console {

/// Forgets all words; those of `language` ("de") are read from then on, and in any language the English names of events and signals.
void set_words_language(const QString& language);
const QString& words_language();
/// Reads the translations of a folder, once. Of two translations of the same words the first stays.
void learn_words(const QString& folder);
/// What was wrong with the files that were read.
const base::Problems& problems_of_words();

QString said(const std::string& words);
QString said(const QString& words);
/// The same of a plugin's own words: two plugins may mean different things by "Drag". `folder`: that of its bundle.
QString said(const std::string& words, const std::string& folder);
/// "grasp.force" -> its name in this language, else in English, else "Grasp force".
QString said_id(const std::string& id);
/// The same of one signal or event of a scene; where another instance has one of that id, it says whose it is.
QString said_name(const judge::Name& one, const std::vector<judge::Name>& all);
/// What an event means, without what its value stands for.
QString said_event(const std::string& doc);

}  // namespace swage::console
