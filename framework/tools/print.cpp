// SPDX-License-Identifier: Apache-2.0
#include "tools/print.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tools/verbs.hpp"

namespace swage::tools {

namespace {

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

void tell(base::Severity severity, const std::string& where, const std::string& message) {
  // results first, when both go to one terminal
  std::fflush(stdout);
  const char* between = where.empty() ? "" : ": ";
  std::fprintf(stderr, "%s: %s%s%s\n", text(severity), where.c_str(), between, message.c_str());
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
  std::printf("%s\n", json.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
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

std::string format(const char* form, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, form);
  std::vsnprintf(buffer, sizeof buffer, form, arguments);
  va_end(arguments);
  return buffer;
}

}  // namespace swage::tools
