// SPDX-License-Identifier: Apache-2.0
#include "record/attempt_heads.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <unordered_set>
#include <utility>

#include "record/attempt_rows.hpp"

namespace swage::record {
namespace {

// The text about the loop has some 1 000 characters and is parsed for lost time. A text that health_json() began
// with "nothing dropped, no forces off" has no lost time and is not transferred; any other is read completely.
constexpr const char* kHealth =
    "CASE WHEN a.loop_health LIKE '{\"dropped\":0,\"executed\":%,\"forces_off_s\":0.0,%' THEN '' ELSE a.loop_health END";

constexpr std::size_t kColumns = 25;  // of select_attempts(true)

// A row of a server has the number of the transaction that wrote it (xmin), and a transaction that an earlier query did not
// see is not older than the oldest one that ran then. Numbers have 32 bits and wrap: age() compares them as the server does.
std::string changed_since_mark() {
  std::string out;
  for (const char* table : {"a", "s", "p", "n", "v", "r"})
    out += std::string(out.empty() ? "" : " OR ") + "age(" + table + ".xmin) <= k.age";
  return " WHERE " + out;
}

// One statement sees one state: the new rows, the number of attempts, and the next mark (the last two columns).
std::string select_changed(bool all) {
  const std::string mark = all ? "" : ", age(CAST(CAST(? AS TEXT) AS xid)) AS age";
  const std::string which = all ? "" : changed_since_mark();
  return "SELECT h.*, k.n, k.mark FROM (SELECT (SELECT COUNT(*) FROM attempt) AS n,"
         " CAST(pg_snapshot_xmin(pg_current_snapshot()) AS TEXT) AS mark" + mark + ") k"
         " LEFT JOIN LATERAL (" + select_attempts(true) + which + ") h ON TRUE";
}

// the low 32 bits of a transaction's number, as in xmin
std::string low_bits(const std::string& number) {
  return std::to_string(std::strtoull(number.c_str(), nullptr, 10) & 0xffffffffull);
}

}  // namespace

std::string select_attempts(bool school) {
  // of a scripted attempt with the hand that was chosen: "swage.device.skilled (expert)"
  const std::string device =
      school ? "a.device || CASE WHEN v.is_scripted = 1 THEN COALESCE((SELECT ' (' || d.choice || ')' FROM hand d"
               " WHERE d.attempt_id = a.attempt_id AND d.seq = 0 AND d.choice <> ''), '') ELSE '' END AS device"
             : "a.device";
  const std::string own =
      "SELECT a.attempt_id, p.person_id, p.pseudonym, a.exercise, a.title, a.mode, " + device + ", a.started_utc, a.ended_utc,"
      " a.state, a.outcome, a.reason, a.score, a.simulated_s, a.is_void, " + std::string(kHealth) + " AS health, a.realtime, a.dropped";
  const std::string from =
      " FROM attempt a JOIN session s ON s.session_id = a.session_id JOIN person p ON p.person_id = s.person_id";
  if (!school) return own + from;
  return own +
         ", n.display_name, v.lesson_digest, v.is_scripted, v.is_synthetic, r.kind, r.reason AS why, r.made_by" + from +
         " LEFT JOIN roster n ON n.person_id = p.person_id LEFT JOIN provenance v ON v.attempt_id = a.attempt_id"
         " LEFT JOIN (SELECT attempt_id, MAX(ruling_id) AS ruling_id FROM ruling WHERE kind < 2 GROUP BY attempt_id) l"
         " ON l.attempt_id = a.attempt_id LEFT JOIN ruling r ON r.ruling_id = l.ruling_id";
}

AttemptRow attempt_from(const Row& r) {
  AttemptRow a;
  a.id = text(r[0]);
  a.person_id = text(r[1]);
  a.person_name = text(r[2]);
  a.lesson_id = text(r[3]);
  a.lesson_title = text(r[4]);
  a.mode = text(r[5]);
  a.device = text(r[6]);
  a.started_utc = text(r[7]);
  a.ended_utc = text(r[8]);
  a.state = text(r[9]);
  a.outcome = text(r[10]);
  a.reason = text(r[11]);
  a.score = real(r[12]);
  a.simulated_s = real(r[13]);
  a.is_void = integer(r[14]) != 0;
  a.remark = remark(text(r[15]), integer(r[16]) != 0, integer(r[17]));
  a.person_code = a.person_name;
  if (r.size() < kColumns) return a;
  if (!text(r[18]).empty()) a.person_name = text(r[18]);
  a.lesson_digest = text(r[19]);
  a.is_scripted = integer(r[20]) != 0;
  a.is_synthetic = integer(r[21]) != 0;
  if (std::holds_alternative<std::monostate>(r[22])) return a;
  a.is_void = integer(r[22]) == 1;
  a.void_reason = text(r[23]);
  a.void_by = text(r[24]);
  return a;
}

void sort_attempts(std::vector<AttemptRow>& rows) {
  std::sort(rows.begin(), rows.end(), [](const AttemptRow& a, const AttemptRow& b) {
    return a.started_utc != b.started_utc ? a.started_utc > b.started_utc : a.id > b.id;
  });
}

bool AttemptHeads::renew() {
  if (db_.on_postgres() && school_ ? renew_server() : renew_file()) return true;
  all_.clear();
  place_.clear();
  file_mark_.clear();
  server_mark_.clear();
  return false;
}

// SQLite counts the commits of other connections (data_version) and the rows that this one has changed. The mark is read before
// the rows: rows committed in between are read twice.
bool AttemptHeads::renew_file() {
  std::vector<Row> mark;
  if (!db_.on_postgres()) {
    for (const char* sql : {"PRAGMA data_version", "SELECT total_changes()"})
      for (Row& r : db_.rows(sql)) mark.push_back(std::move(r));
    if (mark.size() != 2) return false;
    if (mark == file_mark_) return true;
  }
  if (!read_all()) return false;
  file_mark_ = std::move(mark);
  return true;
}

bool AttemptHeads::read_all() {
  std::vector<AttemptRow> rows;
  if (!db_.each(select_attempts(school_), {}, [&](const Row& r) {
        rows.push_back(attempt_from(r));
        return true;
      }))
    return false;
  rows_read_ += rows.size();
  sort_attempts(rows);
  all_ = std::move(rows);
  return true;
}

bool AttemptHeads::renew_server() {
  const bool first = server_mark_.empty();
  int64_t n = -1;
  std::string mark;
  bool changed = false;
  const Row values = first ? Row{} : Row{low_bits(server_mark_)};
  const bool read = db_.each(select_changed(first), values, [&](const Row& r) {
    n = integer(r[kColumns]);
    mark = text(r[kColumns + 1]);
    if (text(r[0]).empty()) return true;  // no new rows
    ++rows_read_;
    changed = true;
    put(attempt_from(r));
    return true;
  });
  if (!read || n < 0 || mark.empty()) return false;
  if (static_cast<int64_t>(all_.size()) != n) {
    if (!forget_missing()) return false;
    changed = true;
  }
  if (changed) {
    sort_attempts(all_);
    place_.clear();
    for (std::size_t i = 0; i < all_.size(); ++i) place_[all_[i].id] = i;
  }
  server_mark_ = mark;
  return true;
}

void AttemptHeads::put(AttemptRow row) {
  const auto [at, is_new] = place_.try_emplace(row.id, all_.size());
  if (is_new)
    all_.push_back(std::move(row));
  else
    all_[at->second] = std::move(row);
}

// Removes erased attempts, which leave no new rows.
bool AttemptHeads::forget_missing() {
  std::unordered_set<std::string> there;
  if (!db_.each("SELECT attempt_id FROM attempt", {}, [&](const Row& r) {
        there.insert(text(r[0]));
        return true;
      }))
    return false;
  std::erase_if(all_, [&](const AttemptRow& a) { return !there.contains(a.id); });
  return true;
}

}  // namespace swage::record
