// SPDX-License-Identifier: Apache-2.0
#include "record/backup.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <vector>

#include "record/attempt_rows.hpp"
#include "record/journal.hpp"
#include "record/schema.hpp"

namespace swage::record {
namespace {

// Every table with the one that it refers to before it.
constexpr const char* kTables[] = {"person", "session", "attempt", "metric", "event",       "chunk",
                                   "hand",   "file",    "device",  "calibration", "outbox", "seal",    "grade"};

struct Table {
  std::string name, columns, places, key;
};

Table table_of(Database& model, const std::string& name) {
  Table out{name, "", "", ""};
  for (const Row& r : model.rows("SELECT name FROM pragma_table_info('" + name + "') ORDER BY cid")) {
    out.columns += (out.columns.empty() ? "" : ", ") + text(r[0]);
    out.places += out.places.empty() ? "?" : ", ?";
  }
  for (const Row& r : model.rows("SELECT name FROM pragma_table_info('" + name + "') WHERE pk > 0 ORDER BY pk"))
    out.key += (out.key.empty() ? "" : ", ") + text(r[0]);
  return out;
}

// Two stations may know one person by two identifiers: the name decides, and sessions follow it.
bool put(Database& to, const Table& table, const Row& row) {
  if (table.name == "session")
    return to.run("INSERT INTO session (session_id, person_id, station, app_version, started_utc)"
                  " SELECT ?, person_id, ?, ?, ? FROM person WHERE pseudonym = ? ON CONFLICT DO NOTHING",
                  {row[0], row[2], row[3], row[4], row[5]});
  return to.run("INSERT INTO " + table.name + " (" + table.columns + ") VALUES (" + table.places +
                    ") ON CONFLICT DO NOTHING",
                row);
}

std::string select(const Table& table) {
  if (table.name == "session")
    return "SELECT s.session_id, s.person_id, s.station, s.app_version, s.started_utc, p.pseudonym FROM session s"
           " JOIN person p ON p.person_id = s.person_id ORDER BY s.session_id";
  return "SELECT " + table.columns + " FROM " + table.name + " ORDER BY " + table.key;
}

uint64_t count(Database& db, const std::string& table) {
  const std::vector<Row> rows = db.rows("SELECT COUNT(*) FROM " + table);
  return rows.empty() ? 0 : static_cast<uint64_t>(integer(rows[0][0]));
}

// One transaction on either side: what is read is one moment, what is written is all or nothing.
bool copy_all(Database& from, Database& to, std::string& error) {
  // an earlier version has fewer tables
  const int version = schema_version(from);
  const std::unique_ptr<Database> model = Database::open(kInMemory, Access::kWrite, error);
  if (version < 1 || !model ||
      !bring_up_to_date(*model, schema_steps().first(static_cast<std::size_t>(version)), error))
    return false;
  const bool one_moment =
      from.run(from.on_postgres() ? "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY" : "BEGIN");
  bool written = to.begin(), read = one_moment;
  for (const char* name : kTables) {
    const Table table = table_of(*model, name);
    if (read && written && !table.columns.empty())
      read = from.each(select(table), {}, [&](const Row& row) { return written = put(to, table, row); });
  }
  if (!written) error = "It cannot be written: " + to.error() + ".";
  if (!read) error = "It cannot be read: " + from.error() + ".";
  written = written && read && to.commit();
  if (!written) to.rollback();
  if (one_moment) from.run("COMMIT");
  if (written || !error.empty()) return written;
  error = "It cannot be written: " + to.error() + ".";
  return false;
}

// Both sides have the same number of rows everywhere, and the copy's pages are whole.
bool is_same(Database& store, Database& copy, std::string& error) {
  for (const char* name : kTables) {
    if (count(copy, name) <= count(store, name)) continue;
    error = "The copy has more rows in \"" + std::string(name) + "\" than the store.";
    return false;
  }
  const std::vector<Row> check = copy.rows("PRAGMA integrity_check(1)");
  const std::vector<Row> orphans = copy.rows("PRAGMA foreign_key_check");
  if (!check.empty() && text(check[0][0]) == "ok" && orphans.empty() && copy.trouble() == Trouble::kNone) return true;
  error = "The copy is damaged: the disk may be.";
  return false;
}

// A backup that a power cut takes back is none.
bool settle_on_disk(const std::string& path, std::string& error) {
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  const bool good = file >= 0 && fsync(file) == 0;
  if (!good) error = std::string(std::strerror(errno)) + ".";
  if (file >= 0) close(file);
  return good;
}

bool fill(const std::string& store, const std::string& part, Copied& out, std::string& error) {
  const std::unique_ptr<Database> from = open_store(store, error);
  if (!from) return false;
  merge_journals(*from, store);
  const std::unique_ptr<Database> to = Database::open(part, Access::kWrite, error);
  if (!to || !bring_up_to_date(*to, schema_steps(), error)) return false;
  if (!copy_all(*from, *to, error) || !is_same(*from, *to, error)) return false;
  out.people = count(*to, "person");
  out.attempts = out.added = count(*to, "attempt");
  return true;
}

}  // namespace

bool backup_store(const std::string& store, const std::string& file, Copied& out, std::string& error) {
  const std::string part = file + ".part";
  unlink(part.c_str());
  bool good = fill(store, part, out, error) && settle_on_disk(part, error);
  if (good && rename(part.c_str(), file.c_str()) != 0) {
    error = std::string(std::strerror(errno)) + ".";
    good = false;
  }
  if (good) return true;
  unlink(part.c_str());
  error = shown(store) + " cannot be backed up to " + file + ". " + error;
  return false;
}

bool restore_store(const std::string& file, const std::string& store, Copied& out, std::string& error) {
  // a backup of an earlier version is read through a copy that is brought up to date; the file itself is never changed
  const std::unique_ptr<Database> from = open_for_reading(file, error);
  if (!from) return false;
  const std::unique_ptr<Database> to = open_store(store, error);
  if (!to) return false;
  const uint64_t before = count(*to, "attempt");
  if (!copy_all(*from, *to, error)) {
    error = file + " cannot be restored into " + shown(store) + ". " + error;
    return false;
  }
  out.people = count(*from, "person");
  out.attempts = count(*from, "attempt");
  out.added = count(*to, "attempt") - before;
  return true;
}

}  // namespace swage::record
