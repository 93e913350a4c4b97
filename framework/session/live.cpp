// SPDX-License-Identifier: Apache-2.0
#include "session/live.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/nearest.hpp"
#include "session/sentences.hpp"

namespace swage::session {

using Json = nlohmann::ordered_json;

namespace {

// the parameters of a table that may change, none of them required
host::ParamTable live_part(const host::ParamTable& table, std::vector<uint32_t>& index) {
  host::ParamTable part;
  for (uint32_t i = 0; i < table.size(); ++i) {
    if (!table[i].live()) continue;
    part.push_back(table[i]);
    part.back().flags &= ~SWAGE_PARAM_REQUIRED;
    index.push_back(i);
  }
  return part;
}

std::vector<std::string> ids(const host::ParamTable& table) {
  std::vector<std::string> out;
  for (const host::Param& p : table) out.push_back(p.id);
  return out;
}

}  // namespace

bool live_commands(const host::Instance& instance, uint32_t ordinal, const host::ParamTable& table,
                   const std::string& params_json, std::vector<step::Command>& out,
                   base::Problems& problems) {
  std::vector<uint32_t> index;
  const host::ParamTable live = live_part(table, index);
  const Json json = Json::parse(params_json, nullptr, false);
  base::Problems found;

  // known parameters that are not live
  const Json object = json.is_object() ? json : Json::object();
  for (const auto& item : object.items()) {
    const auto same = [&](const host::Param& p) { return p.id == item.key(); };
    if (std::none_of(table.begin(), table.end(), same) || std::any_of(live.begin(), live.end(), same))
      continue;
    const std::string may = live.empty() ? say::kLiveNothing() : say::kLiveAre(host::join(ids(live)));
    found.push_back(
        {base::Severity::kError, instance.name + " #/" + item.key(),
         say::kNotLive(item.key(), instance.plugin_id, may)});
  }
  host::ParamValues values;
  host::ParamSource source;
  source.plugin_id = instance.plugin_id;
  source.where = [&](const std::string& pointer) { return instance.name + " #" + pointer; };
  if (found.empty()) host::check_params(params_json, live, source, values, found);
  const bool good = !base::failed(found);
  for (base::Problem& p : found) problems.push_back(std::move(p));
  if (!good) return false;

  for (uint32_t i = 0; i < live.size(); ++i) {
    if (!json.contains(live[i].id)) continue;
    step::Command command;
    command.kind = step::CommandKind::kLiveParameter;
    command.object = ordinal;
    command.parameter = index[i];
    std::copy(std::begin(values.value[i].number), std::end(values.value[i].number),
              std::begin(command.number));
    out.push_back(command);
  }
  return true;
}

}  // namespace swage::session
