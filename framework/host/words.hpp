// SPDX-License-Identifier: Apache-2.0
//
// Texts of plugins and lessons, and their translations. A translation is a file words.<language>.json (or
// words_<anything>.<language>.json) beside the plugin's library or the lesson, or there in a folder "words":
//
//     { "format": "swage-words/1", "language": "de",
//       "words": { "Hold it for {hold_time}.": "{hold_time} lang halten.", "grasp.taken": "Gegriffen" } }
//
// Keys are the texts as the plugin or lesson has them; items without a text (events, signals, names of objects) have their id
// as key. Records, results and exports keep ids and the original texts: only displayed text is translated. [main]
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/problem.hpp"
#include "host/plugin_info.hpp"
#include "snapshot/scene_card.hpp"

namespace swage::host {

using Words = std::map<std::string, std::string, std::less<>>;

/// The files of a folder, and of its folder "words", with translations to a language ("de"), sorted.
std::vector<std::string> word_files(const std::string& folder, const std::string& language);

/// Adds the translations of one file; of two translations of a text the first is kept. A faulty entry (empty, not a
/// text, other placeholders in braces than its key) is omitted with a problem, and so is a faulty file.
void read_words(const std::string& path, const std::string& language, Words& out, base::Problems& problems);
/// The same for a text; `path` names it in problems.
void parse_words(const std::string& text, const std::string& path, const std::string& language, Words& out,
                 base::Problems& problems);

/// The meaning of an event, without the clause that explains its value.
std::string_view without_value(std::string_view doc);

/// The texts to translate, each once, in the order of the source. Of a plugin: its name, its summary but for a lesson's; labels, help,
/// groups and choices of the visible parameters; titles and meanings of metrics; criteria. Formulas are notation and are not translated.
std::vector<std::string> words_of(const PluginInfo& plugin);
/// Of all plugins of a scene: signals, events, phases and metrics; not the host's own events, which the program translates.
std::vector<std::string> words_of(const snapshot::SceneCard& card);
/// Of a complete lesson file: title, task, goal, words of its reset, the names of its objects, couplings, devices and hands.
std::vector<std::string> words_of(const nlohmann::ordered_json& lesson);

}  // namespace swage::host
