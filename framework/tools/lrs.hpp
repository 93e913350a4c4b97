// SPDX-License-Identifier: Apache-2.0
//
// Statements of the Experience API to a Learning Record Store, over libcurl. [main]
#pragma once

#include <string>

namespace swage::tools {

struct LrsAddress {
  std::string url;    // "https://lrs.example.org/xapi"; http:// only to this machine
  std::string login;  // "user:password", "" for none; sent to that address alone
};

/// "" when statements may be sent to an address, else what is wrong, as a sentence.
std::string problem_of(const LrsAddress& address);

struct LrsAnswer {
  bool reached = false;  // somebody answered
  long status = 0;       // of HTTP
  std::string error;     // a sentence, unless the statements are kept there now
  bool kept() const { return reached && (status == 200 || status == 204); }
  bool conflict() const { return reached && status == 409; }  // another statement of that id is there already
};

/// POSTs a JSON array of statements to <url>/statements. Waits 10 s for a connection, 60 s in all; follows no redirection.
LrsAnswer post_statements(const LrsAddress& address, const std::string& json);

}  // namespace swage::tools
