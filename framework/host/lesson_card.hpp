// SPDX-License-Identifier: Apache-2.0
//
// The card of a lesson plugin (abi/lesson_card.h): read from the library, written to and read from plugin.json, and its faults.
// All [main].
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/plugin_info.hpp"

namespace swage::host {

/// Copies the rows of the tables that the library offers for plugin.id; nothing where it offers none. May throw what the plugin throws.
void copy_card(const swage_entry& entry, PluginInfo& plugin);

bool has_card(const PluginInfo& plugin);

/// One sentence for each row that is incomplete or names something unknown.
void card_faults(const PluginInfo& plugin, std::vector<std::string>& faults);

/// The members "metrics", "cues" and "criteria" of plugin.json.
nlohmann::ordered_json card_json(const PluginInfo& plugin);

/// The inverse of card_json. Throws std::exception where the text is malformed.
void read_card(const nlohmann::ordered_json& item, PluginInfo& plugin);

}  // namespace swage::host
