// SPDX-License-Identifier: Apache-2.0
#include "tools/lrs.hpp"

#include <curl/curl.h>

#include <memory>

#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

constexpr long kConnect_s = 10, kAll_s = 60;
constexpr std::size_t kMostAnswer = 2000;  // bytes of the server's answer that go into the message

std::size_t take_answer(char* data, std::size_t size, std::size_t n, void* to) {
  auto& text = *static_cast<std::string*>(to);
  if (text.size() < kMostAnswer) text.append(data, std::min(size * n, kMostAnswer - text.size()));
  return size * n;
}

bool starts_with_any(const std::string& text, std::initializer_list<const char*> heads) {
  for (const char* head : heads)
    if (text.rfind(head, 0) == 0) return true;
  return false;
}

// sets up curl once in the program
void set_up() {
  static const CURLcode done = curl_global_init(CURL_GLOBAL_DEFAULT);
  static_cast<void>(done);
}

}  // namespace

std::string problem_of(const LrsAddress& a) {
  if (a.url.find_first_of(" \t\n\r") != std::string::npos || a.url.find('@') != std::string::npos)
    return say::kNoAddress(a.url);
  if (starts_with_any(a.url, {"https://"})) return "";
  // records of people leave the machine only encrypted
  if (starts_with_any(a.url, {"http://127.0.0.1:", "http://127.0.0.1/", "http://localhost:", "http://localhost/"})) return "";
  return say::kNotEncrypted(a.url);
}

LrsAnswer post_statements(const LrsAddress& address, const std::string& json) {
  LrsAnswer out;
  set_up();
  const std::unique_ptr<CURL, void (*)(CURL*)> curl(curl_easy_init(), &curl_easy_cleanup);
  if (!curl) return out.error = say::kNoCurl(), out;
  curl_slist* list = nullptr;
  for (const char* head : {"Content-Type: application/json", "X-Experience-API-Version: 1.0.3", "Expect:"})
    list = curl_slist_append(list, head);
  const std::unique_ptr<curl_slist, void (*)(curl_slist*)> heads(list, &curl_slist_free_all);
  std::string url = address.url, said;
  while (!url.empty() && url.back() == '/') url.pop_back();
  url += "/statements";
  char why[CURL_ERROR_SIZE] = "";
  CURL* c = curl.get();
  curl_easy_setopt(c, CURLOPT_URL, url.c_str());
  curl_easy_setopt(c, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(c, CURLOPT_HTTPHEADER, heads.get());
  curl_easy_setopt(c, CURLOPT_POSTFIELDS, json.c_str());
  curl_easy_setopt(c, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(json.size()));
  curl_easy_setopt(c, CURLOPT_CONNECTTIMEOUT, kConnect_s);
  curl_easy_setopt(c, CURLOPT_TIMEOUT, kAll_s);
  curl_easy_setopt(c, CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(c, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(c, CURLOPT_ERRORBUFFER, why);
  curl_easy_setopt(c, CURLOPT_WRITEFUNCTION, &take_answer);
  curl_easy_setopt(c, CURLOPT_WRITEDATA, &said);
  if (!address.login.empty()) {
    curl_easy_setopt(c, CURLOPT_HTTPAUTH, static_cast<long>(CURLAUTH_BASIC));
    curl_easy_setopt(c, CURLOPT_USERPWD, address.login.c_str());
  }
  const CURLcode code = curl_easy_perform(c);
  if (code != CURLE_OK) return out.error = say::kNoAnswer(*why ? why : curl_easy_strerror(code)), out;
  curl_easy_getinfo(c, CURLINFO_RESPONSE_CODE, &out.status);
  out.reached = true;
  if (!out.kept()) out.error = say::kAnswers(out.status, said.empty() ? "." : ": " + said);
  return out;
}

}  // namespace swage::tools
