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

// C0 and DEL, and C1, which UTF-8 writes as 0xC2 0x80 to 0xC2 0x9F: some terminals take the latter for escapes too
std::string printable(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    const bool c1 = c == 0xC2 && next >= 0x80 && next <= 0x9F;
    if (c1)
      out += format("\\x%02x", next), ++i;
    else if ((c < 0x20 && c != '\n' && c != '\t') || c == 0x7F)
      out += format("\\x%02x", c);
    else
      out += text[i];
  }
  return out;
}

void tell(base::Severity severity, const std::string& where, const std::string& message) {
  // results first, when both go to one terminal
  std::fflush(stdout);
  const char* between = where.empty() ? "" : ": ";
  std::fprintf(stderr, "%s: %s%s%s\n", text(severity), printable(where).c_str(), between,
               printable(message).c_str());
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
  // JSON itself writes C0 as \\u001b; line ends of the layout stay
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

std::string format(const char* form, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, form);
  std::vsnprintf(buffer, sizeof buffer, form, arguments);
  va_end(arguments);
  return buffer;
}

}  // namespace swage::tools
