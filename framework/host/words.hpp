// SPDX-License-Identifier: Apache-2.0
//
// What plugins and lessons say to people, and its translations. A translation is a file words.<language>.json (or
// words_<anything>.<language>.json) beside the plugin's library or the lesson, or there in a folder "words":
//
//     { "format": "swage-words/1", "language": "de",
//       "words": { "Hold it for {hold_time}.": "{hold_time} lang halten.", "grasp.taken": "Gegriffen" } }
//
// Keys are the words as the plugin or lesson says them; what has no words of its own (events, signals, names of objects) is keyed by
// its id. Records, results and exports keep ids and the words of the plugin: only what is shown is translated. [main]
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

/// The files of a folder, and of its folder "words", that hold words of a language ("de"), sorted.
std::vector<std::string> word_files(const std::string& folder, const std::string& language);

/// Adds the words of one file; of two translations of the same words the first stays. A word that is wrong by itself (empty, not a
/// text, other places in braces than its key) is left out with a problem, a file that is wrong as a whole likewise.
void read_words(const std::string& path, const std::string& language, Words& out, base::Problems& problems);
/// The same of a text; `path` is what problems call it.
void parse_words(const std::string& text, const std::string& path, const std::string& language, Words& out,
                 base::Problems& problems);

/// What an event means, without the clause that says what its value stands for.
std::string_view without_value(std::string_view doc);

/// What is to be translated, each once, in the order of the source. Of a plugin: labels, help and choices of the parameters that
/// people see, titles and meanings of metrics, criteria. Formulas are notation and stay as they are.
std::vector<std::string> words_of(const PluginInfo& plugin);
/// Of all plugins of a scene: signals, events, phases and metrics; not the host's own events, which the program translates.
std::vector<std::string> words_of(const snapshot::SceneCard& card);
/// Of a lesson file, whole: title, task, goal, the names of its objects, couplings, devices and hands.
std::vector<std::string> words_of(const nlohmann::ordered_json& lesson);

}  // namespace swage::host
