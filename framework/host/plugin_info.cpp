// SPDX-License-Identifier: Apache-2.0
#include "host/plugin_info.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "base/text.hpp"
#include "host/c_values.hpp"
#include "host/elf_exports.hpp"
#include "host/guard.hpp"
#include "host/lesson_card.hpp"
#include "judge/pull_rule.hpp"
#include "host/library.hpp"
#include "host/params_json.hpp"
#include "host/sentences.hpp"
#include "host/version.hpp"
#include "toolkit/read_file.hpp"

namespace swage::host {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kFormat = "swage-plugin/1";
constexpr std::array kKinds = {"object", "coupling", "device", "lesson"};

bool is_id(const std::string& id) {
  // reverse domain, lower case: at least two words of a-z 0-9 _, each starting with a letter
  bool start = true, dotted = false;
  for (const char c : id) {
    const bool letter = c >= 'a' && c <= 'z';
    const bool inner = letter || (c >= '0' && c <= '9') || c == '_';
    if (c == '.' && !start) {
      start = dotted = true;
    } else if (start ? letter : inner) {
      start = false;
    } else {
      return false;
    }
  }
  return dotted && !start;
}

PluginInfo copy_descriptor(const swage_descriptor& d) {
  PluginInfo plugin;
  plugin.kind = d.kind;
  plugin.id = copy(d.id);
  plugin.version = copy(d.version);
  plugin.name = copy(d.name);
  plugin.summary = copy(d.summary);
  plugin.author = copy(d.author);
  plugin.licence = copy(d.licence);
  for (const char* const* trait = d.traits; trait != nullptr && *trait != nullptr; ++trait)
    plugin.traits.push_back(*trait);
  return plugin;
}

/// One sentence for each text with control characters, which would move a terminal's cursor.
void text_faults(const PluginInfo& plugin, std::vector<std::string>& faults) {
  const auto look = [&faults](const std::string& owner, std::initializer_list<const std::string*> texts) {
    if (std::any_of(texts.begin(), texts.end(), [](const std::string* t) { return base::has_control(*t); }))
      faults.push_back(say::kControl(base::printable(owner)));
  };
  look("It", {&plugin.id, &plugin.version, &plugin.name, &plugin.summary, &plugin.author, &plugin.licence,
              &plugin.build_info});
  for (const Param& p : plugin.params) {
    look("Parameter \"" + p.id + "\"", {&p.id, &p.label, &p.group, &p.unit, &p.display_unit, &p.doc, &p.default_text});
    for (const std::string& choice : p.choices) look("Parameter \"" + p.id + "\"", {&choice});
  }
  for (const MetricInfo& m : plugin.metrics)
    look("Metric \"" + m.id + "\"", {&m.id, &m.unit, &m.doc, &m.formula, &m.code, &m.title});
  for (const CriterionInfo& c : plugin.criteria) look("A criterion", {&c.text, &c.when});
  for (const CueInfo& c : plugin.cues) look("Cue \"" + c.id + "\"", {&c.id, &c.doc});
}

}  // namespace

const char* kind_text(int32_t kind) {
  return kind >= 1 && kind <= 4 ? kKinds[static_cast<std::size_t>(kind - 1)] : "unknown";
}

namespace {

// plugins of one library; a larger count is a fault
constexpr uint32_t kMostPlugins = 1000;

// calls the library; the caller catches its exceptions
bool read_descriptors(const Library& library, std::vector<PluginInfo>& out, std::string& error) {
  const uint32_t n = library.factory().count();
  for (uint32_t i = 0; i < n && i < kMostPlugins; ++i) {
    const swage_descriptor* d = library.factory().descriptor(i);
    if (d == nullptr) {
      error = say::kNullDescriptor(i, n);
      return false;
    }
    PluginInfo plugin = copy_descriptor(*d);
    uint32_t count = 0;
    const swage_param* table = library.params(plugin.id.c_str(), &count);
    plugin.params = copy_table(table, count);
    copy_card(library.entry(), plugin);
    plugin.bundle_dir = library.bundle_dir();
    plugin.library_path = library.path();
    plugin.build_info = copy(library.entry().build_info);
    plugin.abi_major = library.entry().abi_major;
    plugin.abi_minor = library.entry().abi_minor;
    out.push_back(std::move(plugin));
  }
  if (out.empty()) error = say::kHoldsNone();
  return !out.empty();
}

}  // namespace

bool describe(const Library& library, std::vector<PluginInfo>& out, std::string& error) {
  out.clear();
  Instance described;
  described.name = described.plugin_id = library.path();
  bool good = false;
  FaultKind changed = FaultKind::kNone;
  const swage_result result = detail::contained(
      described, Call::kDescribe, 0, [&] { good = read_descriptors(library, out, error); }, &changed);
  if (result < 0) error = say::kDescribeThrew();
  if (result >= 0 && changed != FaultKind::kNone) error = say::kDescribeDid(text(changed));
  return good && result >= 0 && changed == FaultKind::kNone;
}

std::vector<std::string> plugin_faults(const PluginInfo& plugin) {
  std::vector<std::string> faults;
  if (!is_id(plugin.id))
    faults.push_back(say::kNoId(plugin.id));
  Version version;
  if (!parse_version(plugin.version, version))
    faults.push_back(say::kNoVersion(plugin.version));
  if (plugin.kind < SWAGE_KIND_OBJECT || plugin.kind > SWAGE_KIND_LESSON)
    faults.push_back(say::kNoKind(plugin.kind));
  if (plugin.kind != SWAGE_KIND_OBJECT && !plugin.traits.empty())
    faults.push_back(say::kTraitsOfObjects());
  const std::array<std::pair<const char*, const std::string*>, 4> texts = {{{"name", &plugin.name},
                                                                            {"summary", &plugin.summary},
                                                                            {"author", &plugin.author},
                                                                            {"licence", &plugin.licence}}};
  for (const auto& [what, text] : texts)
    if (text->empty()) faults.push_back(say::kHasNoText(what));
  text_faults(plugin, faults);
  for (std::string& fault : table_faults(plugin.params)) faults.push_back(std::move(fault));
  card_faults(plugin, faults);
  return faults;
}

std::string content_hash(const std::string& path) {
  std::string bytes, why;
  if (!toolkit::read_file(path, kMostLibraryBytes, bytes, why)) return "";
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash_of_kept(bytes)));
  return text.data();
}

std::string write_sidecar(const std::string& library_path, const std::string& hash,
                          const std::vector<PluginInfo>& plugins) {
  Json json;
  json["format"] = kFormat;
  json["library"] = library_path.substr(library_path.rfind('/') + 1);
  json["hash"] = hash;
  if (!plugins.empty()) {
    json["abi"] = {plugins[0].abi_major, plugins[0].abi_minor};
    json["build_info"] = plugins[0].build_info;
  }
  Json& list = json["plugins"] = Json::array();
  for (const PluginInfo& plugin : plugins) {
    list.push_back({{"kind", kind_text(plugin.kind)},
                    {"id", plugin.id},
                    {"version", plugin.version},
                    {"name", plugin.name},
                    {"summary", plugin.summary},
                    {"author", plugin.author},
                    {"licence", plugin.licence},
                    {"traits", plugin.traits},
                    {"params", table_to_json(plugin.params)}});
    if (has_card(plugin)) list.back().update(card_json(plugin));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool read_sidecar(const std::string& text, std::string& hash, std::vector<PluginInfo>& out,
                  std::string& error) {
  out.clear();
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != kFormat) throw std::runtime_error("another format");
    hash = json.at("hash").get<std::string>();
    for (const Json& item : json.at("plugins")) {
      PluginInfo plugin;
      const std::string kind = item.at("kind");
      for (int32_t k = SWAGE_KIND_OBJECT; k <= SWAGE_KIND_LESSON; ++k)
        if (kind == kind_text(k)) plugin.kind = k;
      item.at("id").get_to(plugin.id);
      item.at("version").get_to(plugin.version);
      item.at("name").get_to(plugin.name);
      item.at("summary").get_to(plugin.summary);
      item.at("author").get_to(plugin.author);
      item.at("licence").get_to(plugin.licence);
      item.at("traits").get_to(plugin.traits);
      json.at("abi").at(0).get_to(plugin.abi_major);
      json.at("abi").at(1).get_to(plugin.abi_minor);
      json.at("build_info").get_to(plugin.build_info);
      if (!table_from_json(item.at("params"), plugin.params)) throw std::runtime_error("a parameter table");
      read_card(item, plugin);
      out.push_back(std::move(plugin));
    }
  } catch (const std::exception& e) {
    error = say::kOtherFile(kFormat, e.what());
    return false;
  }
  return true;
}

const std::vector<MetricInfo>& pull_metrics() {
  static const std::vector<MetricInfo> all = [] {
    std::vector<MetricInfo> out;
    for (const judge::PullMetric& m : judge::kPullMetrics)
      out.push_back({m.id, m.unit, m.doc, m.formula, "", m.better, SWAGE_EVIDENCE_D, m.title, m.show, m.rank, "", ""});
    return out;
  }();
  return all;
}

}  // namespace swage::host
