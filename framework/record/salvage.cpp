// SPDX-License-Identifier: Apache-2.0
#include "record/salvage.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <string_view>

#include "record/attempt_rows.hpp"
#include "record/chunk_buffer.hpp"
#include "record/codec.hpp"
#include "record/identity.hpp"
#include "record/schema.hpp"
#include "record/seal.hpp"
#include "record/sentences.hpp"
#include "record/sqlite_pages.hpp"

namespace swage::record {
namespace {

namespace fs = std::filesystem;

// A table is identified by the types of its columns: T text, I integer, R a real number (SQLite stores whole ones as integers,
// and NaN as NULL), B bytes, N text or NULL.
struct Form {
  std::string_view table;
  const char* columns;
  const char* insert;
};
constexpr Form kForms[] = {
    {"person", "TTT", "INSERT OR IGNORE INTO person VALUES (?, ?, ?)"},
    {"session", "TTTTT", "INSERT OR IGNORE INTO session VALUES (?, ?, ?, ?, ?)"},
    {"device", "TTTT", "INSERT OR IGNORE INTO device VALUES (?, ?, ?, ?)"},
    {"attempt", "TTTTTTTTTTTRRIIIRITTTTTT",
     "INSERT OR IGNORE INTO attempt VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"},
    {"metric", "TITRT", "INSERT OR IGNORE INTO metric VALUES (?, ?, ?, ?, ?)"},
    {"event", "TIIITITTR", "INSERT OR IGNORE INTO event VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"},
    {"chunk", "TTIIIIIBN", "INSERT OR IGNORE INTO chunk VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"},
    {"hand", "TITTTTTI", "INSERT OR IGNORE INTO hand VALUES (?, ?, ?, ?, ?, ?, ?, ?)"},
    {"file", "TTIB", "INSERT OR IGNORE INTO file VALUES (?, ?, ?, ?)"},
    {"seal", "TT", "INSERT OR IGNORE INTO seal VALUES (?, ?)"},
    {"grade", "TTTTTITTRT", "INSERT OR IGNORE INTO grade VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"},
    {"people_group", "TITTT", "INSERT OR IGNORE INTO people_group VALUES (?, ?, ?, ?, ?)"},
    {"roster", "TTTTTT", "INSERT OR IGNORE INTO roster VALUES (?, ?, ?, ?, ?, ?)"},
    {"lesson_version", "TTTTTTTI", "INSERT OR IGNORE INTO lesson_version VALUES (?, ?, ?, ?, ?, ?, ?, ?)"},
    {"course", "TTTTTTT", "INSERT OR IGNORE INTO course VALUES (?, ?, ?, ?, ?, ?, ?)"},
    {"assignment", "TITTTT", "INSERT OR IGNORE INTO assignment VALUES (?, ?, ?, ?, ?, ?)"},
    {"note", "TTIITTT", "INSERT OR IGNORE INTO note VALUES (?, ?, ?, ?, ?, ?, ?)"},
    {"ruling", "TTITTT", "INSERT OR IGNORE INTO ruling VALUES (?, ?, ?, ?, ?, ?)"},
    {"rating", "TTRTT", "INSERT OR IGNORE INTO rating VALUES (?, ?, ?, ?, ?)"},
    {"provenance", "TTTTII", "INSERT OR IGNORE INTO provenance VALUES (?, ?, ?, ?, ?, ?)"},
    {"erased", "TIT", "INSERT OR IGNORE INTO erased VALUES (?, ?, ?)"},
    {"exported", "TITTTTT", "INSERT OR IGNORE INTO exported VALUES (?, ?, ?, ?, ?, ?, ?)"},
};
constexpr std::size_t kState = 8;  // column of an attempt

bool is_of_kind(const Value& v, char kind) {
  const bool null = std::holds_alternative<std::monostate>(v), whole = std::holds_alternative<int64_t>(v);
  const bool word = std::holds_alternative<std::string>(v);
  switch (kind) {
    case 'T':
      return word;
    case 'I':
      return whole;
    case 'R':
      return null || whole || std::holds_alternative<double>(v);
    case 'B':
      return std::holds_alternative<Blob>(v);
    default:
      return null || word;
  }
}

const Form* form_of(const Row& row) {
  for (const Form& form : kForms) {
    if (std::strlen(form.columns) != row.size()) continue;
    bool fits = true;
    for (std::size_t i = 0; fits && i < row.size(); ++i) fits = is_of_kind(row[i], form.columns[i]);
    // every table but that of metrics begins with an identifier; SQLite's list of tables has five columns too
    if (fits && is_id(text(row[0]))) return &form;
  }
  return nullptr;
}

// A chunk or file that does not match its checksum is dropped.
bool is_sound(const Form& form, const Row& row) {
  if (form.table != "chunk" && form.table != "file") return true;
  const bool chunk = form.table == "chunk";
  const Blob& data = blob(row[chunk ? 7 : 3]);
  return crc32c(data.data(), data.size()) == static_cast<uint32_t>(integer(row[chunk ? 6 : 2]));
}

void take_rows(SqlitePages& pages, Database& db, Salvaged& out) {
  out.lost_rows += pages.each_row([&](const Row& row) {
    const Form* form = form_of(row);
    if (form == nullptr) return;
    if (!is_sound(*form, row)) {
      ++out.lost_rows;
      return;
    }
    // of two copies of an attempt the ended one is the later
    if (form->table == "attempt" && text(row[kState]) != "running")
      db.run("DELETE FROM attempt WHERE attempt_id = ? AND state = 'running'", {row[0]});
    db.run(form->insert, row) ? ++out.rows : ++out.lost_rows;
  });
}

// Replaces missing sessions and people that attempts refer to by placeholders; drops pieces of attempts without a head.
bool mend_references(Database& db, Salvaged& out) {
  const std::vector<Row> headless = db.rows(
      "SELECT COUNT(*) FROM (SELECT DISTINCT attempt_id FROM chunk WHERE attempt_id NOT IN"
      " (SELECT attempt_id FROM attempt))");
  if (!headless.empty()) out.headless = static_cast<uint64_t>(integer(headless[0][0]));
  bool ok = true;
  for (const char* table : {"metric", "event", "chunk", "hand", "file", "seal", "grade", "provenance", "note", "ruling", "rating"})
    ok &= db.run("DELETE FROM " + std::string(table) +
                 " WHERE attempt_id NOT IN (SELECT attempt_id FROM attempt)");
  const std::string now = utc_now();
  ok &= db.run(
      "INSERT INTO session SELECT DISTINCT session_id, session_id, 'unknown', 'unknown', ? FROM attempt"
      " WHERE session_id NOT IN (SELECT session_id FROM session)",
      {now});
  ok &= db.run(
      "INSERT INTO person SELECT DISTINCT person_id, 'Unknown ' || substr(person_id, 1, 13), ? FROM session"
      " WHERE person_id NOT IN (SELECT person_id FROM person)",
      {now});
  for (const char* table : {"roster", "exported"})
    ok &= db.run("DELETE FROM " + std::string(table) + " WHERE person_id NOT IN (SELECT person_id FROM person)");
  ok &= db.run("DELETE FROM assignment WHERE course_id NOT IN (SELECT course_id FROM course)");
  return ok;
}

// Number of chunks from the first up to a gap.
int64_t prefix(Database& db, const std::string& id, const std::string& stream) {
  int64_t next = 0;
  db.each("SELECT seq FROM chunk WHERE attempt_id = ? AND stream = ? ORDER BY seq", {id, stream},
          [&](const Row& r) { return integer(r[0]) == next && ++next > 0; });
  return next;
}

// Cuts the streams of the steps at the first gap in any of them, so that the rest can be replayed.
bool shorten(Database& db, const std::string& id, bool& cut) {
  std::map<std::string, int64_t> last;
  for (const Row& r : db.rows("SELECT stream, MAX(seq) FROM chunk WHERE attempt_id = ? GROUP BY stream", {id}))
    last[text(r[0])] = integer(r[1]);
  std::vector<std::string> streams = {kHashStream};
  std::string error;
  const std::vector<Row> head = db.rows("SELECT devices, script FROM attempt WHERE attempt_id = ?", {id});
  std::vector<std::string> devices;
  judge::Script script;
  if (!head.empty() && from_json(text(head[0][0]), devices) && !devices.empty()) streams.push_back(kInputStream);
  if (!head.empty() && from_json(text(head[0][1]), script) && !script.signals.empty())
    streams.push_back(kSignalStream);
  int64_t whole = INT64_MAX;
  for (const std::string& stream : streams) whole = std::min(whole, prefix(db, id, stream));
  bool ok = true;
  const auto cut_at = [&](const std::string& stream, int64_t length) {
    const auto found = last.find(stream);
    if (found == last.end() || found->second < length) return;
    cut = true;
    ok &= db.run("DELETE FROM chunk WHERE attempt_id = ? AND stream = ? AND seq >= ?", {id, stream, length});
  };
  for (const std::string& stream : streams) cut_at(stream, whole);
  cut_at(kCommandStream, prefix(db, id, kCommandStream));
  return ok;
}

// Compares the number of steps of an attempt with those that exist.
bool misses_steps(Database& db, const std::string& id) {
  const std::vector<Row> said =
      db.rows("SELECT simulated_s / dt_s, dropped FROM attempt WHERE attempt_id = ? AND dt_s > 0", {id});
  const std::vector<Row> there =
      db.rows("SELECT COALESCE(SUM(n), 0) FROM chunk WHERE attempt_id = ? AND stream = 'hash'", {id});
  if (said.empty() || there.empty()) return false;
  return real(there[0][0]) + real(said[0][1]) < real(said[0][0]) - 0.5;
}

bool mend_recordings(Database& db, Salvaged& out) {
  std::vector<std::string> ids;
  for (const Row& r : db.rows("SELECT attempt_id FROM attempt")) ids.push_back(text(r[0]));
  bool ok = db.trouble() == Trouble::kNone;
  for (const std::string& id : ids) {
    bool cut = false;
    ok &= shorten(db, id, cut);
    // a seal covers the list of chunks too; without a seal the steps are counted
    const bool sealed = !db.rows("SELECT 1 FROM seal WHERE attempt_id = ?", {id}).empty();
    const bool as_it_was = sealed ? seal_holds(db, id) : !misses_steps(db, id);
    const bool short_now = cut || (!as_it_was && misses_steps(db, id));
    if (!cut && as_it_was) {
      ++out.whole;
      continue;
    }
    ++(short_now ? out.shortened : out.altered);
    ok &= db.run(
        "INSERT INTO event SELECT ?, COALESCE(MAX(seq), -1) + 1, 0, 0, 'gap', -1, 'gap', 'salvaged', 0 FROM event"
        " WHERE attempt_id = ?",
        {id, id});
    ok &= seal_attempt(db, id);  // seals the repaired state
  }
  return ok;
}

// SQLite holds a shared lock on a file while a program has it open. Tested with our own descriptor, so no
// connection of this process may be open.
bool is_in_use(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return false;
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  const bool used = fcntl(file, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  close(file);
  return used;
}

}  // namespace

bool salvage(const std::string& damaged, const std::string& fresh, Salvaged& out, std::string& error) {
  out = Salvaged();
  SqlitePages pages;
  if (is_postgres(damaged)) {
    error = say::kServerNotSalvaged();
    return false;
  }
  if (!pages.open(damaged, error)) return false;
  std::error_code code;
  if (fs::exists(fresh, code)) {
    error = say::kThereAlready(fresh);
    return false;
  }
  const std::unique_ptr<Database> db = open_store(fresh, error);
  if (!db) return false;
  bool ok = db->run("PRAGMA foreign_keys = OFF") && db->begin();
  if (ok) {
    take_rows(pages, *db, out);
    ok = mend_references(*db, out) && mend_recordings(*db, out) && db->commit();
  }
  if (!ok) error = fresh + " cannot be written: " + db->error() + ".";
  if (ok && out.rows == 0) {
    error = say::kNothingLeft(damaged);
    ok = false;
  }
  return ok;
}

bool salvage_in_place(const std::string& store, Salvaged& out, std::string& error) {
  const auto remove_all = [](const std::string& path) {
    for (const char* end : {"", "-wal", "-shm"}) unlink((path + end).c_str());
  };
  if (!is_postgres(store) && is_in_use(store)) {
    error = say::kInUse(store);
    return false;
  }
  const std::string fresh = store + ".salvaging", old = store + ".damaged-" + utc_now();
  remove_all(fresh);
  if (!salvage(store, fresh, out, error)) {
    remove_all(fresh);
    return false;
  }
  // the log is renamed with its file, so that it cannot be applied to another; the new file was closed and has none
  for (const char* end : {"-wal", "-shm", ""}) {
    if (rename((store + end).c_str(), (old + end).c_str()) == 0 || (errno == ENOENT && *end != '\0')) continue;
    error = store + end + " cannot be renamed: " + std::strerror(errno) + ".";
    return false;
  }
  if (rename(fresh.c_str(), store.c_str()) != 0) {
    error = fresh + " cannot be renamed to " + store + ": " + std::strerror(errno) + ".";
    return false;
  }
  out.damaged = old;
  return true;
}

}  // namespace swage::record
