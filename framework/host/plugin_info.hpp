// SPDX-License-Identifier: Apache-2.0
//
// Description of a plugin, readable without loading it: the sidecar plugin.json, generated from the binary by
// swage-describe.
#pragma once

#include <swage/abi/lesson_card.h>
#include <swage/abi/plugin.h>

#include <string>
#include <vector>

#include "host/params.hpp"

namespace swage::host {

class Library;

/// A row of a lesson's card (abi/lesson_card.h).
struct MetricInfo {
  std::string id, unit, doc, formula, code;
  int32_t better = 0, evidence = 0;  // SWAGE_BETTER_*, SWAGE_EVIDENCE_*
  std::string title;                 // "" where the card has no label for it
  int32_t show = 0, rank = 0;        // SWAGE_SHOW_*; position among the values shown first, 0: on demand
  std::string least, most;           // parameters that hold its required limits, "" for none
};
/// The metrics of the pull of a knot (judge/pull_rule.hpp) in the form of a card, in the order of judge::PullMeasure. [main]
const std::vector<MetricInfo>& pull_metrics();
struct CueInfo {
  std::string id, doc;
  uint32_t channels = 0;              // SWAGE_CHANNEL_*
  uint32_t role = SWAGE_CUE_NEUTRAL;  // SWAGE_CUE_*
};
struct CriterionInfo {
  std::string text, when;
  int32_t kind = 0;  // SWAGE_CRITERION_*
};

struct PluginInfo {
  int32_t kind = 0;  // SWAGE_KIND_*
  std::string id, version, name, summary, author, licence;
  std::vector<std::string> traits;
  ParamTable params;
  std::vector<MetricInfo> metrics;  // of a lesson; empty when it has no card
  std::vector<CueInfo> cues;
  std::vector<CriterionInfo> criteria;
  std::string bundle_dir, library_path;
  std::string build_info;  // compiler and flags, for reports only
  uint32_t abi_major = 0, abi_minor = 0;
  bool stock = false;  // found in the install's own folder
};

const char* kind_text(int32_t kind);  // "object", "coupling", "device", "lesson"

const char* better_text(int32_t better);       // "", "lower", "higher", "inside"
std::string evidence_text(int32_t evidence);   // "", "A" to "D"
std::string channels_text(uint32_t channels);  // "colour, shape, sound, force"
const char* cue_role_text(uint32_t role);      // "", "good", "warning", "bad", "target"; "" for an unknown one

/// Reads every descriptor and table of a loaded library. False: `error` names the malformed one.
bool describe(const Library& library, std::vector<PluginInfo>& out, std::string& error);

/// Faults of a descriptor and its table, one sentence each; empty for a good plugin.
std::vector<std::string> plugin_faults(const PluginInfo& plugin);

/// Largest plugin.json that is read; usual are some tens of kilobytes.
inline constexpr std::size_t kMostSidecarBytes = std::size_t{8} << 20;

/// Hash of what installation preserves of a library (elf_exports.hpp), "" when it cannot be read.
std::string content_hash(const std::string& path);

/// Text of plugin.json for a library and its plugins (format "swage-plugin/1").
std::string write_sidecar(const std::string& library_path, const std::string& hash,
                          const std::vector<PluginInfo>& plugins);

/// The inverse; `hash` as written. False: `error` has the reason.
bool read_sidecar(const std::string& text, std::string& hash, std::vector<PluginInfo>& out,
                  std::string& error);

}  // namespace swage::host
