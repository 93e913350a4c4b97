// SPDX-License-Identifier: Apache-2.0
//
// swage attempts send: sends every finished attempt once to a Learning Record Store. The store is the queue: unsent statements follow
// the next time; a file of receipts lists those that have arrived.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "record/export.hpp"
#include "toolkit/read_file.hpp"
#include "tools/lrs.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/school_verbs.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {


constexpr std::size_t kAtOnce = 50;                           // statements in a request: under a megabyte
constexpr std::size_t kMostReceipts = std::size_t{256} << 20;  // five million

/// Receipts: ids of the statements that have arrived, one per line. Appended to after each answer.
class Receipts {
 public:
  Receipts(std::string path, const std::string& address) : path_(std::move(path)), address_(address) {
    std::string text, why;
    if (!toolkit::read_file(path_, kMostReceipts, text, why)) return;
    std::size_t at = 0;
    for (std::size_t end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
      const std::string line = text.substr(at, end - at), here = address_ + " ";
      if (line.rfind(here, 0) == 0) known_.insert(line.substr(here.size()));
    }
    whole_ = at;
  }
  bool has(const std::string& id) const { return known_.count(id) > 0; }
  bool add(const std::vector<std::string>& ids) {
    std::error_code none;
    std::filesystem::create_directories(std::filesystem::path(path_).parent_path(), none);
    // removes a last line that a kill has left incomplete
    if (std::filesystem::exists(path_, none) && std::filesystem::file_size(path_, none) > whole_) std::filesystem::resize_file(path_, whole_, none);
    std::ofstream file(path_, std::ios::binary | std::ios::app);
    for (const std::string& id : ids) {
      const std::string line = address_ + " " + id + "\n";
      file << line;
      whole_ += line.size();
      known_.insert(id);
    }
    file.close();
    return file.good();
  }

 private:
  const std::string path_, address_;
  std::set<std::string> known_;
  std::size_t whole_ = 0;
};

struct Sent {
  std::size_t kept = 0, waiting = 0, refused = 0;
  std::string why;  // reason for statements that wait or were refused
};

// a conflict counts as arrived: the attempt was voided or named since it was sent, and a sent statement cannot be changed
bool arrived(const LrsAnswer& a) { return a.kept() || a.conflict(); }

// Statements of a refused batch are sent one by one, so that one bad statement does not hold back the others.
bool send_batch(const LrsAddress& to, const std::vector<nlohmann::json>& batch, Receipts& receipts, Sent& sent) {
  const auto id = [](const nlohmann::json& s) { return s.at("id").get<std::string>(); };
  std::vector<std::string> ids;
  const LrsAnswer all = post_statements(to, nlohmann::json(batch).dump());
  if (!all.reached || all.status >= 500 || all.status == 401 || all.status == 403 || all.status == 404) return sent.why = all.error, false;
  if (all.kept())
    for (const nlohmann::json& s : batch) ids.push_back(id(s));
  for (std::size_t i = 0; !all.kept() && i < batch.size(); ++i) {
    const LrsAnswer one = post_statements(to, nlohmann::json::array({batch[i]}).dump());
    if (arrived(one)) ids.push_back(id(batch[i]));
    if (!arrived(one)) ++sent.refused, sent.why = one.error;
  }
  sent.kept += ids.size();
  if (receipts.add(ids)) return true;
  sent.why = say::kNoReceipts();
  return false;
}

std::string receipts_file(const SendOptions& o) {
  if (!o.receipts.empty()) return o.receipts;
  return (std::filesystem::path(record::Store::default_path()).parent_path() / "lrs_receipts.txt").string();
}

bool read_login(const SendOptions& o, LrsAddress& to) {
  std::string why;
  if (o.login_file.empty()) return true;
  if (!toolkit::read_file(o.login_file, 4096, to.login, why)) return problem(say::kOfLogin(o.login_file, why)), false;
  while (!to.login.empty() && (to.login.back() == '\n' || to.login.back() == '\r')) to.login.pop_back();
  return to.login.find(':') != std::string::npos || (problem(say::kLoginLine()), false);
}

}  // namespace

int send_attempts(const SendOptions& o) {
  LrsAddress to{o.to, ""};
  std::string error, text;
  if (const std::string wrong = problem_of(to); !wrong.empty()) return problem(wrong);
  if (!read_login(o, to)) return kProblem;
  const std::string where = store_place(o.store);
  std::vector<record::Exported> list;
  if (!existing_store(where, error) || !record::read_for_export(where, {}, list, error)) return problem(error);
  // attempts of scripted hands and synthetic attempts belong to no person's record
  std::erase_if(list, [](const record::Exported& e) {
    return e.attempt.is_scripted || e.attempt.is_synthetic || e.attempt.state == "running";
  });
  if (!record::xapi_statements(list, o.home, text, error)) return problem(say::kOfHome(error));

  Receipts receipts(receipts_file(o), o.to);
  std::vector<nlohmann::json> queue;
  for (nlohmann::json& s : nlohmann::json::parse(text))
    if (!receipts.has(s.at("id"))) queue.push_back(std::move(s));
  Sent sent;
  for (std::size_t i = 0; i < queue.size(); i += kAtOnce) {
    progress(format("%zu of %zu", i, queue.size()));
    const std::size_t end = std::min(queue.size(), i + kAtOnce);
    const std::vector<nlohmann::json> batch(queue.begin() + static_cast<std::ptrdiff_t>(i), queue.begin() + static_cast<std::ptrdiff_t>(end));
    if (!send_batch(to, batch, receipts, sent)) break;
  }
  progress("");
  sent.waiting = queue.size() - sent.kept - sent.refused;
  if (sent.kept > 0) {
    // the export is listed, so that erasing a person reports that statements were sent
    std::set<std::string> people;
    for (const record::Exported& e : list) people.insert(e.attempt.person_id);
    if (const auto school = record::School::open(where, error)) school->log_export({people.begin(), people.end()}, "lrs", o.to);
  }
  if (o.json)
    print({{"sent", sent.kept}, {"waiting", sent.waiting}, {"refused", sent.refused}, {"why", sent.why}});
  else
    std::printf("%zu sent, %zu wait, %zu refused\n", sent.kept, sent.waiting, sent.refused);
  if (sent.waiting + sent.refused == 0) return kPassed;
  tell(base::Severity::kWarning, o.to, sent.why + (sent.waiting > 0 ? say::kWaits() : ""));
  return kNotPassed;
}

}  // namespace swage::tools
