// SPDX-License-Identifier: Apache-2.0
//
// The opening handshake of a WebSocket (RFC 6455, 4): the request of a client, and the check of a server's response. [any]
#pragma once

#include <string>
#include <string_view>

namespace swage::inverse3 {

/// Base64 of `bytes` (RFC 4648, 4).
std::string base64(std::string_view bytes);
/// The 20 bytes of SHA-1 (FIPS 180-4). The protocol requires it; it has no security purpose here.
std::string sha1(std::string_view bytes);
/// The response that a server must give to a key: base64(sha1(key + the GUID of RFC 6455)).
std::string accept_for(std::string_view key);

/// The request of a client. `key`: base64 of 16 random bytes.
std::string request_text(const std::string& host, int port, const std::string& path, const std::string& key);
/// "" where `answer`, the header of the server's response with its empty line, accepts `key`; else the reason, as a sentence.
std::string check_answer(std::string_view answer, std::string_view key);

}  // namespace swage::inverse3
