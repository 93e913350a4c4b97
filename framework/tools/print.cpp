// SPDX-License-Identifier: Apache-2.0
#include "tools/print.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <locale>
#include <nlohmann/json.hpp>

#include "base/quantity.hpp"
#include "base/text.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {

namespace {

constexpr std::size_t kMostShown = 4000;  // bytes of a place and of a message; a list of all parameters has a few hundred

const char* text(base::Severity severity) {
  switch (severity) {
    case base::Severity::kNote:
      return "note";
    case base::Severity::kWarning:
      return "warning";
    case base::Severity::kError:
      break;
  }
  return "error";
}

}  // namespace

std::string printable(const std::string& text) { return base::printable(text); }

void tell(base::Severity severity, const std::string& where, const std::string& message) {
  // flushes results first, if both go to one terminal
  std::fflush(stdout);
  // a sentence about an instance begins with its name, which is not said twice
  const std::string place = !where.empty() && message.starts_with(where + " (") ? "" : where;
  const char* between = place.empty() ? "" : ": ";
  const auto shown = [](const std::string& s) { return base::printable(base::shortened(s, kMostShown)); };
  std::fprintf(stderr, "%s: %s%s%s\n", text(severity), shown(place).c_str(), between, shown(message).c_str());
}

void tell(const base::Problems& problems) {
  for (const base::Problem& p : problems) tell(p.severity, p.where, p.message);
}

void progress(const std::string& text) {
  if (isatty(STDERR_FILENO) == 1) std::fprintf(stderr, "\r%-78s\r%s", "", text.c_str());
}

int problem(const std::string& message) {
  tell(base::Severity::kError, "", message);
  return kProblem;
}

void print(const nlohmann::ordered_json& json) {
  using Json = nlohmann::ordered_json;
  // JSON escapes C0 characters itself, as \\u001b; line ends of the layout stay
  std::printf("%s\n", printable(json.dump(2, ' ', false, Json::error_handler_t::replace)).c_str());
}

nlohmann::ordered_json to_json(const base::Problems& problems) {
  auto out = nlohmann::ordered_json::array();
  for (const base::Problem& p : problems)
    out.push_back({{"severity", text(p.severity)}, {"where", p.where}, {"message", p.message}});
  return out;
}

nlohmann::ordered_json number(double value) {
  if (std::isfinite(value)) return value;
  return nullptr;
}

std::ostringstream plain_stream() {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  return out;
}

std::string format(const char* form, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, form);
  std::vsnprintf(buffer, sizeof buffer, form, arguments);
  va_end(arguments);
  return buffer;
}

std::string quantity_text(double value, const std::string& unit) {
  value = base::meaningful(value, unit);
  const base::Shown as = base::shown_unit(value, unit);
  return format("%.4g%s%.*s", as.factor * value, as.unit.empty() ? "" : " ", static_cast<int>(as.unit.size()), as.unit.data());
}

}  // namespace swage::tools
