// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Translations of the texts of plugins and lessons into the language of the window: from the files words.<language>.json beside them
// (host/words.hpp), of any author. Untranslated texts are shown as they are. Only displayed text is translated, never a
// record. GUI thread.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "base/problem.hpp"
#include "judge/verdict.hpp"

namespace swage::console {

/// Forgets all translations; those of `language` ("de") are read from then on, and in any language the English names of events and signals.
void set_words_language(const QString& language);
const QString& words_language();
/// Reads the translations of a folder, once. Of two translations of one text the first is used.
void learn_words(const QString& folder);
/// Errors in the files read so far.
const base::Problems& problems_of_words();

QString said(const std::string& words);
QString said(const QString& words);
/// A message of the host, its values kept: one sentence or several (models/sentence_words.hpp). As it is where nobody has translated it.
QString said_message(const std::string& message);
/// The same of a message that may begin with the path of its file: the path stays.
QString said_of_file(const std::string& path, const std::string& message);
/// Translation of a plugin's text by its own file: two plugins may use "Drag" in different senses. `folder`: that of its bundle.
QString said(const std::string& words, const std::string& folder);
/// "grasp.force" -> its name in this language, else in English, else "Grasp force".
QString said_id(const std::string& id);
/// The name of a signal or event of a scene; where several instances have the same id, with the name of the instance.
QString said_name(const judge::Name& one, const std::vector<judge::Name>& all);
/// The meaning of an event, without the explanation of its value.
QString said_event(const std::string& doc);

}  // namespace swage::console
