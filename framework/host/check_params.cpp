// SPDX-License-Identifier: Apache-2.0
//
// The checker: checks JSON values against a parameter table, with messages for people.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "host/nearest.hpp"
#include "host/params_json.hpp"
#include "host/sentences.hpp"
#include "host/units.hpp"
#include "toolkit/read_file.hpp"

namespace swage::host {

using Json = nlohmann::ordered_json;
using base::Severity;

namespace {

constexpr std::size_t kMostTold = 50;  // problems of one plugin's parameters

std::string dump(const Json& json) {
  return base::shortened(json.dump(-1, ' ', false, Json::error_handler_t::replace), 57);
}

// expected type of a parameter, for "is ..., not ..."
std::string expected(const Param& p) {
  const Unit* unit = find_unit(p.unit);
  const std::string units = unit != nullptr && p.unit != "1" ? " (" + units_like(p.unit) + ")" : "";
  switch (p.type) {
    case SWAGE_PARAM_INTEGER:
      return say::kWhole();
    case SWAGE_PARAM_BOOL:
      return say::kFlag();
    case SWAGE_PARAM_CHOICE:
      return say::kOneOf(join(p.choices, true));
    case SWAGE_PARAM_TEXT:
      return say::kText();
    case SWAGE_PARAM_FILE:
      return say::kFileName();
    case SWAGE_PARAM_VECTOR:
      return say::kNumbers(p.dimension, unit != nullptr && p.unit != "1" ? ", each " + std::string(unit->dimension) + units : "");
    default:
      return (unit != nullptr ? unit->dimension : say::kNumber()) + units;
  }
}

class Checker {
 public:
  Checker(const ParamTable& table, const ParamSource& source, ParamValues& out, base::Problems& problems)
      : table_(table), source_(source), out_(out), problems_(problems) {}

  bool run(const Json& object) {
    out_ = default_values(table_, source_.bundle_folder);
    std::vector<bool> given(table_.size(), false);
    if (!object.is_object()) {
      error("", say::kParamsNoObject(dump(object)));
      return false;
    }
    std::size_t left = object.size();
    for (const auto& [key, value] : object.items()) {
      if (errors_ >= kMostTold) {
        error("", say::kParamsLeft(left));
        break;
      }
      take(key, value, given);
      --left;
    }
    for (std::size_t i = 0; i < table_.size(); ++i) {
      if (table_[i].required() && !given[i])
        error("", say::kNeedsParam(source_.plugin_id, table_[i].id, expected(table_[i]), table_[i].doc));
    }
    out_.point_to_texts();
    return errors_ == 0;
  }

 private:
  void say(Severity severity, const std::string& pointer, const std::string& message) {
    problems_.push_back({severity, source_.where ? source_.where(pointer) : source_.plugin_id, message});
    errors_ += severity == Severity::kError ? 1 : 0;
  }
  void error(const std::string& pointer, const std::string& message) {
    say(Severity::kError, pointer, message);
  }

  // JSON pointers escape these two characters
  static std::string pointer_to(const std::string& key) {
    std::string out = "/";
    for (const char c : key) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return out;
  }

  void take(const std::string& key, const Json& value, std::vector<bool>& given) {
    const std::string pointer = pointer_to(key);
    if (key.starts_with("x-")) return;  // notes for people
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < table_.size(); ++i) {
      const Param& p = table_[i];
      ids.push_back(p.id);
      const bool former = std::find(p.aliases.begin(), p.aliases.end(), key) != p.aliases.end();
      if (p.id != key && !former) continue;
      if (former) {
        say(Severity::kWarning, pointer,
            say::kFormerName(key, p.id, p.id, dump(value)));
      }
      if (given[i]) return error(pointer, say::kGivenTwice(p.id));
      given[i] = true;
      return check(p, pointer, value, i);
    }
    const std::string has = ids.empty() ? say::kHasNone() : say::kHas(join(ids));
    error(pointer, say::kNoSuchParam(source_.plugin_id, did_you_mean(key, ids), has));
  }

  void check(const Param& p, const std::string& pointer, const Json& json, std::size_t i) {
    swage_value& value = out_.value[i];
    const auto refuse = [&] {
      error(pointer, say::kOtherType(p.label, expected(p), dump(json)));
    };
    switch (p.type) {
      case SWAGE_PARAM_BOOL:
        if (!json.is_boolean()) return refuse();
        value.number[0] = json.get<bool>() ? 1 : 0;
        return;
      case SWAGE_PARAM_CHOICE:
        return choice(p, pointer, json, value);
      case SWAGE_PARAM_TEXT:
        if (!json.is_string()) return refuse();
        out_.text[i] = json.get<std::string>();
        return;
      case SWAGE_PARAM_FILE:
        if (!json.is_string()) return refuse();
        return file(p, pointer, json.get<std::string>(), out_.text[i]);
      case SWAGE_PARAM_VECTOR:
        if (!json.is_array() || json.size() != p.dimension) return refuse();
        for (std::size_t k = 0; k < json.size(); ++k)
          number(p, pointer + "/" + std::to_string(k), json[k], value.number[k]);
        return;
      default:
        number(p, pointer, json, value.number[0]);
    }
  }

  void choice(const Param& p, const std::string& pointer, const Json& json, swage_value& value) {
    const std::string typed = json.is_string() ? json.get<std::string>() : "";
    const auto found = std::find(p.choices.begin(), p.choices.end(), typed);
    if (json.is_string() && found != p.choices.end()) {
      value.number[0] = static_cast<double>(found - p.choices.begin());
      return;
    }
    error(pointer, say::kOtherType(p.label, expected(p), dump(json)) + (json.is_string() ? did_you_mean(typed, p.choices) : ""));
  }

  void file(const Param& p, const std::string& pointer, const std::string& name, std::string& text) {
    namespace fs = std::filesystem;
    text = name;
    if (name.empty()) return;
    std::error_code failed;
    fs::path path = fs::absolute(fs::path(source_.folder) / name, failed).lexically_normal();
    if (source_.files != nullptr && source_.files->contains(name)) path = source_.files->at(name);
    const std::string why = toolkit::file_refusal(path.string(), toolkit::kMostFileBytes);
    if (!failed && why.empty()) {
      text = path.string();
      out_.files.push_back({name, text});
      return;
    }
    // a file of the plugin's bundle
    const fs::path brought = fs::path(source_.bundle_folder) / name;
    if (!source_.bundle_folder.empty() && fs::is_regular_file(brought, failed)) {
      text = brought.string();
      out_.files.push_back({name, text});
    } else if (fs::exists(path, failed)) {
      error(pointer, say::kBadFile(p.label, path.string(), why));
    } else {
      error(pointer, say::kNoFile(p.label, path.string()));
    }
  }

  // a plain number is in the SI unit, a text has its own
  void number(const Param& p, const std::string& pointer, const Json& json, double& out) {
    double value = 0;
    std::string sentence;
    if (json.is_string()) {
      if (!parse_quantity(json.get<std::string>(), p.unit, p.label, value, sentence))
        return error(pointer, sentence);
    } else if (json.is_number()) {
      value = json.get<double>();
    } else {
      return error(pointer, say::kOtherType(p.label, expected(p), dump(json)));
    }
    if (p.type == SWAGE_PARAM_INTEGER && value != std::floor(value))
      return error(pointer, say::kOtherType(p.label, expected(p), dump(json)));
    // unit conversion rounds: "20 mm" must not exceed 0.02 m by its last bit
    const double slack = 1e-12 * std::max(std::abs(p.min), std::abs(p.max));
    if (!(value >= p.min - slack && value <= p.max + slack)) {
      return error(pointer, say::kOutOfRange(dump(json), p.label, format_quantity(p.min, p.display_unit), format_quantity(p.max, p.display_unit)));
    }
    out = std::clamp(value, p.min, p.max);
  }

  const ParamTable& table_;
  const ParamSource& source_;
  ParamValues& out_;
  base::Problems& problems_;
  std::size_t errors_ = 0;
};

}  // namespace

bool check_params_json(const Json& object, const ParamTable& table, const ParamSource& source,
                       ParamValues& out, base::Problems& problems) {
  return Checker(table, source, out, problems).run(object);
}

bool check_params(std::string_view text, const ParamTable& table, const ParamSource& source, ParamValues& out,
                  base::Problems& problems) {
  const Json object = text.empty() ? Json::object() : Json::parse(text, nullptr, false);
  if (object.is_discarded()) {
    out = default_values(table, source.bundle_folder);
    problems.push_back({Severity::kError, source.where ? source.where("") : source.plugin_id,
                        say::kParamsNoJson(text.substr(0, 60))});
    return false;
  }
  return check_params_json(object, table, source, out, problems);
}

}  // namespace swage::host
