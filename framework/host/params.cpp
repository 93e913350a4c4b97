// SPDX-License-Identifier: Apache-2.0
#include "host/params.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "host/c_values.hpp"
#include "host/params_json.hpp"
#include "host/sentences.hpp"
#include "host/units.hpp"

namespace swage::host {

using Json = nlohmann::ordered_json;

namespace {

std::vector<std::string> copy_list(const char* const* list) {
  std::vector<std::string> out;
  for (; list != nullptr && *list != nullptr; ++list) out.push_back(*list);
  return out;
}

bool is_snake_case(const std::string& id) {
  const auto good = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return !id.empty() && id[0] >= 'a' && id[0] <= 'z' && std::all_of(id.begin(), id.end(), good);
}

bool numeric(const Param& p) {
  return p.type == SWAGE_PARAM_REAL || p.type == SWAGE_PARAM_INTEGER || p.type == SWAGE_PARAM_VECTOR;
}

// units, range and default of a number
void number_faults(const Param& p, const std::function<void(const std::string&)>& fault) {
  const Unit* unit = find_unit(p.unit);
  if (unit == nullptr || std::string(unit->si) != p.unit)
    fault(say::kNoSiUnit(p.unit, unit_list()));
  const Unit* shown = find_unit(p.display_unit);
  if (shown == nullptr || (unit != nullptr && std::string(shown->si) != unit->si))
    fault(say::kOtherDisplayUnit(p.display_unit, p.unit));
  if (!(p.min <= p.max)) fault(say::kEmptyRange());
  for (uint32_t i = 0; i < std::min(p.dimension, 4u); ++i) {
    const double d = p.default_number[i];
    if (!(d >= p.min && d <= p.max)) fault(say::kDefaultOutOfRange());
    if (p.type == SWAGE_PARAM_INTEGER && d != std::floor(d))
      fault(say::kDefaultNotWhole());
  }
  const bool vector = p.type == SWAGE_PARAM_VECTOR;
  if (vector ? (p.dimension < 2 || p.dimension > 4) : p.dimension != 1)
    fault(say::kDimension(vector ? "2 to 4" : "1"));
}

Json number_text(const Param& p, double v) {
  const Unit* unit = find_unit(p.display_unit);
  if (p.type == SWAGE_PARAM_INTEGER) return static_cast<int64_t>(v);
  // numbers without unit stay JSON numbers
  if (unit == nullptr || std::string(unit->symbol) == "1") return v;
  return format_quantity(v, p.display_unit);
}

}  // namespace

void ParamValues::point_to_texts() {
  text.resize(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) value[i].text = {text[i].data(), text[i].size()};
}

ParamTable copy_table(const swage_param* table, uint32_t count) {
  ParamTable out;
  for (uint32_t i = 0; i < count; ++i) {
    const swage_param& p = table[i];
    Param q;
    q.type = p.type;
    q.flags = p.flags;
    q.dimension = p.dimension;
    q.id = copy(p.id);
    q.label = copy(p.label);
    q.group = copy(p.group);
    q.unit = copy(p.unit);
    q.display_unit = copy(p.display_unit);
    q.doc = copy(p.doc);
    q.choices = copy_list(p.choices);
    q.aliases = copy_list(p.aliases);
    q.default_text = copy(p.default_text);
    q.min = p.min;
    q.max = p.max;
    std::copy(std::begin(p.default_number), std::end(p.default_number), q.default_number.begin());
    out.push_back(std::move(q));
  }
  return out;
}

std::vector<std::string> table_faults(const ParamTable& table) {
  std::vector<std::string> faults;
  std::set<std::string> names;
  for (const Param& p : table) {
    const auto fault = [&](const std::string& what) { faults.push_back(say::kOfParam(p.id, what)); };
    if (!is_snake_case(p.id)) fault(say::kNotSnakeCase());
    if (!names.insert(p.id).second) fault(say::kIdTwice());
    for (const std::string& alias : p.aliases)
      if (!names.insert(alias).second)
        fault(say::kAliasTwice(alias));
    if (p.label.empty()) fault(say::kNoLabel());
    if (p.doc.empty()) fault(say::kNoDoc());
    if (p.type < SWAGE_PARAM_REAL || p.type > SWAGE_PARAM_FILE)
      fault(say::kNoSuchType(p.type));
    if (numeric(p)) number_faults(p, fault);
    if (p.type != SWAGE_PARAM_CHOICE) continue;
    if (p.choices.empty()) fault(say::kNoChoices());
    if (!(p.default_number[0] >= 0 && p.default_number[0] < static_cast<double>(p.choices.size())))
      fault(say::kDefaultNoChoice());
  }
  return faults;
}

ParamValues default_values(const ParamTable& table, const std::string& bundle_folder) {
  ParamValues out;
  for (const Param& p : table) {
    swage_value value{};
    std::copy(p.default_number.begin(), p.default_number.end(), std::begin(value.number));
    out.value.push_back(value);
    const bool relative = p.type == SWAGE_PARAM_FILE && !p.default_text.empty() && p.default_text[0] != '/';
    out.text.push_back(relative && !bundle_folder.empty() ? bundle_folder + "/" + p.default_text
                                                          : p.default_text);
  }
  out.point_to_texts();
  return out;
}

std::string value_text(const Param& p, const swage_value& value) {
  switch (p.type) {
    case SWAGE_PARAM_BOOL:
      return value.number[0] != 0 ? "true" : "false";
    case SWAGE_PARAM_CHOICE: {
      const auto i = static_cast<std::size_t>(value.number[0]);
      return i < p.choices.size() ? Json(p.choices[i]).dump() : "null";
    }
    case SWAGE_PARAM_TEXT:
    case SWAGE_PARAM_FILE:
      return Json(std::string(value.text.data, value.text.size))
          .dump(-1, ' ', false, Json::error_handler_t::replace);
    case SWAGE_PARAM_VECTOR: {
      Json list = Json::array();
      for (uint32_t i = 0; i < std::min(p.dimension, 4u); ++i)
        list.push_back(number_text(p, value.number[i]));
      return list.dump();
    }
    default:
      return number_text(p, value.number[0]).dump();
  }
}

}  // namespace swage::host
