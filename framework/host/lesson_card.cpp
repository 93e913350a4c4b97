// SPDX-License-Identifier: Apache-2.0
#include "host/lesson_card.hpp"

#include <algorithm>
#include <array>

#include "host/c_values.hpp"
#include "host/sentences.hpp"

namespace swage::host {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::array kBetter = {"", "lower", "higher", "inside"};
constexpr std::array kChannels = {"colour", "shape", "sound", "force"};
constexpr std::array kCueRoles = {"", "good", "warning", "bad", "target"};
constexpr uint32_t kMaxRows = 1000;  // of one table: more rows are a broken table

/// Calls take(row) for each row of a table; `rows`: a function of the ABI, may be NULL.
template <class Row, class Take>
void each_row(const Row* (*rows)(const char*, uint32_t*), const std::string& id, Take take) {
  uint32_t count = 0;
  const Row* row = rows != nullptr ? rows(id.c_str(), &count) : nullptr;
  for (uint32_t i = 0; row != nullptr && i < std::min(count, kMaxRows); ++i) take(row[i]);
}

MetricInfo* find_metric(PluginInfo& plugin, const std::string& id) {
  const auto found = std::find_if(plugin.metrics.begin(), plugin.metrics.end(),
                                  [&](const MetricInfo& m) { return m.id == id; });
  return found == plugin.metrics.end() ? nullptr : &*found;
}

bool has_param(const PluginInfo& plugin, const std::string& id) {
  return std::any_of(plugin.params.begin(), plugin.params.end(), [&](const Param& p) { return p.id == id; });
}

/// The parameters that a text names in braces.
std::vector<std::string> named_params(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    out.push_back(close == std::string::npos ? text.substr(open) : text.substr(open + 1, close - open - 1));
  }
  return out;
}

void metric_faults(const PluginInfo& plugin, const MetricInfo& m, std::vector<std::string>& faults) {
  const bool known = m.better >= SWAGE_BETTER_NONE && m.better <= SWAGE_BETTER_INSIDE &&
                     m.evidence >= SWAGE_EVIDENCE_NONE && m.evidence <= SWAGE_EVIDENCE_D &&
                     m.show >= SWAGE_SHOW_QUANTITY && m.show <= SWAGE_SHOW_POINTS && m.rank >= 0;
  if (!known) faults.push_back("Metric \"" + m.id + "\" has an unknown direction, evidence, look or rank.");
  if (m.id.empty() || m.unit.empty() || m.doc.empty() || m.formula.empty())
    faults.push_back("Metric \"" + m.id + "\" needs an id, a unit, a sentence and a formula.");
  for (const std::string& id : {m.least, m.most})
    if (!id.empty() && !has_param(plugin, id))
      faults.push_back("Metric \"" + m.id + "\" has a target \"" + id + "\", which is no parameter.");
}

void criterion_faults(const PluginInfo& plugin, const CriterionInfo& c, std::vector<std::string>& faults) {
  if (c.text.empty() || c.kind < SWAGE_CRITERION_PASS || c.kind > SWAGE_CRITERION_ENDS)
    faults.push_back("A criterion needs a sentence and a known kind: \"" + c.text + "\".");
  std::vector<std::string> named = named_params(c.text);
  if (!c.when.empty()) {
    const std::string id = c.when.front() == '!' ? c.when.substr(1) : c.when;
    named.push_back(id.substr(0, id.find('=')));
  }
  for (const std::string& id : named)
    if (!has_param(plugin, id))
      faults.push_back("The criterion \"" + c.text + "\" names \"" + id + "\", which is no parameter.");
}

void read_metric(const Json& row, PluginInfo& plugin) {
  MetricInfo m;
  row.at("id").get_to(m.id);
  row.at("unit").get_to(m.unit);
  row.at("doc").get_to(m.doc);
  row.at("formula").get_to(m.formula);
  row.at("code").get_to(m.code);
  const std::string better = row.at("better"), evidence = row.at("evidence");
  for (int32_t b = 0; b <= SWAGE_BETTER_INSIDE; ++b)
    if (better == better_text(b)) m.better = b;
  for (int32_t e = 0; e <= SWAGE_EVIDENCE_D; ++e)
    if (evidence == evidence_text(e)) m.evidence = e;
  m.title = row.value("title", "");
  m.show = row.value("show", SWAGE_SHOW_QUANTITY);
  m.rank = row.value("rank", 0);
  m.least = row.value("least", "");
  m.most = row.value("most", "");
  plugin.metrics.push_back(std::move(m));
}

}  // namespace

const char* better_text(int32_t better) {
  return better >= 0 && better <= SWAGE_BETTER_INSIDE ? kBetter[static_cast<std::size_t>(better)] : "";
}

std::string evidence_text(int32_t evidence) {
  return evidence >= SWAGE_EVIDENCE_A && evidence <= SWAGE_EVIDENCE_D
             ? std::string(1, static_cast<char>('A' + evidence - SWAGE_EVIDENCE_A))
             : "";
}

std::string channels_text(uint32_t channels) {
  std::string out;
  for (std::size_t i = 0; i < kChannels.size(); ++i)
    if ((channels & 1u << i) != 0) out += (out.empty() ? "" : ", ") + std::string(kChannels[i]);
  return out;
}

const char* cue_role_text(uint32_t role) { return role < kCueRoles.size() ? kCueRoles[role] : ""; }

void copy_card(const swage_entry& entry, PluginInfo& plugin) {
  const auto* card = static_cast<const swage_lesson_card_factory*>(entry.get_factory(SWAGE_FACTORY_LESSON_CARD));
  const auto* labels =
      static_cast<const swage_lesson_labels_factory*>(entry.get_factory(SWAGE_FACTORY_LESSON_LABELS));
  if (card != nullptr) {
    each_row(card->metrics, plugin.id, [&](const swage_metric_info& m) {
      MetricInfo& info = plugin.metrics.emplace_back();
      info.id = copy(m.id), info.unit = copy(m.unit), info.doc = copy(m.doc);
      info.formula = copy(m.formula), info.code = copy(m.code);
      info.better = m.better, info.evidence = m.evidence;
    });
    each_row(card->cues, plugin.id, [&](const swage_cue_info& c) {
      plugin.cues.push_back({copy(c.id), copy(c.doc), c.channels, c.role});
    });
  }
  if (labels == nullptr) return;
  each_row(labels->labels, plugin.id, [&](const swage_metric_label& l) {
    MetricInfo* m = find_metric(plugin, copy(l.id));
    if (m == nullptr) return;  // a label for an unknown metric is ignored
    m->title = copy(l.title), m->show = l.show, m->rank = l.rank;
    m->least = copy(l.least), m->most = copy(l.most);
  });
  each_row(labels->criteria, plugin.id, [&](const swage_criterion& c) {
    plugin.criteria.push_back({copy(c.text), copy(c.when), c.kind});
  });
}

bool has_card(const PluginInfo& plugin) {
  return !plugin.metrics.empty() || !plugin.cues.empty() || !plugin.criteria.empty();
}

void card_faults(const PluginInfo& plugin, std::vector<std::string>& faults) {
  for (const MetricInfo& m : plugin.metrics) metric_faults(plugin, m, faults);
  for (const CueInfo& c : plugin.cues) {
    if (c.id.empty() || c.doc.empty() || c.channels == 0 || c.channels >= 1u << kChannels.size())
      faults.push_back("Cue \"" + c.id + "\" needs an id, a sentence and channels that are known.");
    if (c.role >= kCueRoles.size()) faults.push_back(say::kNoCueRole(c.id, c.role));
  }
  for (const CriterionInfo& c : plugin.criteria) criterion_faults(plugin, c, faults);
}

Json card_json(const PluginInfo& plugin) {
  Json out = {{"metrics", Json::array()}, {"cues", Json::array()}, {"criteria", Json::array()}};
  for (const MetricInfo& m : plugin.metrics)
    out["metrics"].push_back({{"id", m.id},
                              {"unit", m.unit},
                              {"doc", m.doc},
                              {"formula", m.formula},
                              {"code", m.code},
                              {"better", better_text(m.better)},
                              {"evidence", evidence_text(m.evidence)},
                              {"title", m.title},
                              {"show", m.show},
                              {"rank", m.rank},
                              {"least", m.least},
                              {"most", m.most}});
  for (const CueInfo& c : plugin.cues) {
    Json& row = out["cues"].emplace_back(Json{{"id", c.id}, {"doc", c.doc}, {"channels", c.channels}});
    if (c.role != SWAGE_CUE_NEUTRAL) row["role"] = c.role;  // else the text stays that of a host without roles
  }
  for (const CriterionInfo& c : plugin.criteria)
    out["criteria"].push_back({{"text", c.text}, {"when", c.when}, {"kind", c.kind}});
  return out;
}

void read_card(const Json& item, PluginInfo& plugin) {
  if (!item.contains("metrics")) return;  // not a lesson, or one without a card
  for (const Json& row : item.at("metrics")) read_metric(row, plugin);
  for (const Json& row : item.at("cues"))
    // a text without a role was written before cues had one
    plugin.cues.push_back({row.at("id"), row.at("doc"), row.at("channels").get<uint32_t>(), row.value("role", SWAGE_CUE_NEUTRAL)});
  if (!item.contains("criteria")) return;  // written before criteria existed
  for (const Json& row : item.at("criteria"))
    plugin.criteria.push_back({row.at("text"), row.at("when"), row.at("kind").get<int32_t>()});
}

}  // namespace swage::host
