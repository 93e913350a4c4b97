// SPDX-License-Identifier: Apache-2.0
//
// Sends statements of the Experience API to a Learning Record Store, with libcurl. [main]
#pragma once

#include <string>

namespace swage::tools {

struct LrsAddress {
  std::string url;    // "https://lrs.example.org/xapi"; http:// only to this machine
  std::string login;  // "user:password", "" for none; sent only to `url`
};

/// "" when statements may be sent to the address, otherwise a message.
std::string problem_of(const LrsAddress& address);

struct LrsAnswer {
  bool reached = false;  // a server answered
  long status = 0;       // status code of HTTP
  std::string error;     // a message, "" when the statements are stored there
  bool kept() const { return reached && (status == 200 || status == 204); }
  bool conflict() const { return reached && status == 409; }  // another statement with that id is stored there
};

/// POSTs a JSON array of statements to <url>/statements. Waits 10 s for a connection, 60 s in all; follows no redirection.
LrsAnswer post_statements(const LrsAddress& address, const std::string& json);

}  // namespace swage::tools
