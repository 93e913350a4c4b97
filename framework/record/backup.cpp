// SPDX-License-Identifier: Apache-2.0
#include "record/backup.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <vector>

#include "record/attempt_rows.hpp"
#include "record/journal.hpp"
#include "record/schema.hpp"
#include "record/sentences.hpp"

namespace swage::record {
namespace {

// All tables, each after those that it refers to.
constexpr const char* kTables[] = {"erased",  "person", "session", "attempt",     "metric", "event", "chunk",
                                   "hand",    "file",   "device",  "calibration", "outbox", "seal",  "grade",
                                   "provenance", "note", "ruling", "rating", "people_group", "roster", "lesson_version", "course",
                                   "assignment", "exported"};

struct Table {
  std::string name, columns, places, key;
  std::vector<std::string> column;
  // -1 when there is no such column
  int index(const std::string& what) const {
    const auto found = std::find(column.begin(), column.end(), what);
    return found == column.end() ? -1 : static_cast<int>(found - column.begin());
  }
};

// The column that refers to a person, who may have two identifiers from two stations.
int person_column(const Table& table) {
  if (table.name == "person") return -1;
  return table.name == "assignment" ? table.index("who_id") : table.index("person_id");
}

Table table_of(Database& model, const std::string& name) {
  Table out;
  out.name = name;
  for (const Row& r : model.rows("SELECT name FROM pragma_table_info('" + name + "') ORDER BY cid")) {
    out.columns += (out.columns.empty() ? "" : ", ") + text(r[0]);
    out.column.push_back(text(r[0]));
    out.places += out.places.empty() ? "?" : ", ?";
  }
  for (const Row& r : model.rows("SELECT name FROM pragma_table_info('" + name + "') WHERE pk > 0 ORDER BY pk"))
    out.key += (out.key.empty() ? "" : ", ") + text(r[0]);
  return out;
}

// The rows of a table; for rows that refer to a person, with its code as a further column.
std::string select(const Table& table) {
  const int person = person_column(table);
  if (person < 0) return "SELECT " + table.columns + " FROM " + table.name + " ORDER BY " + table.key;
  const std::string& named = table.column[static_cast<std::size_t>(person)];
  std::string columns;
  for (const std::string& c : table.column) columns += "t." + c + ", ";
  return "SELECT " + columns + "p.pseudonym FROM " + table.name + " t LEFT JOIN person p ON p.person_id = t." + named +
         " ORDER BY t." + table.key;
}

// Erased rows stay erased: a copy brings nothing back that either side has erased.
class Erased {
 public:
  bool load(Database& to) {
    for (const char* table : {"attempt", "person"}) {
      const std::string key = std::string(table) + "_id";
      if (!to.run("DELETE FROM " + std::string(table) + " WHERE " + key + " IN (SELECT erased_id FROM erased)")) return false;
    }
    return to.each("SELECT erased_id FROM erased", {}, [&](const Row& r) { return ids_.insert(text(r[0])).second || true; });
  }
  /// True for a row that belongs to something erased; rows that refer to it are then erased too.
  bool has(const Table& table, const Row& row) {
    if (table.name == "erased") return false;
    for (const char* what : {"person_id", "session_id", "attempt_id", "who_id"}) {
      const int at = table.index(what);
      if (at < 0 || !ids_.contains(text(row[static_cast<std::size_t>(at)]))) continue;
      ids_.insert(text(row[0]));
      return true;
    }
    return false;
  }

 private:
  std::set<std::string> ids_;
};

// Two stations may know one person by two identifiers: the code decides, and references to the person are changed accordingly.
bool put(Database& to, const Table& table, Row row) {
  const int person = person_column(table);
  if (person >= 0) {
    const std::string code = text(row.back());
    row.pop_back();
    const std::vector<Row> known = code.empty() ? std::vector<Row>() : to.rows("SELECT person_id FROM person WHERE pseudonym = ?", {code});
    if (!known.empty()) row[static_cast<std::size_t>(person)] = known[0][0];
  }
  return to.run("INSERT INTO " + table.name + " (" + table.columns + ") VALUES (" + table.places +
                    ") ON CONFLICT DO NOTHING",
                row);
}

uint64_t count(Database& db, const std::string& table) {
  const std::vector<Row> rows = db.rows("SELECT COUNT(*) FROM " + table);
  return rows.empty() ? 0 : static_cast<uint64_t>(integer(rows[0][0]));
}

// One transaction on either side: a consistent snapshot is read, and all rows or none are written.
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
  Erased erased;
  for (const char* name : kTables) {
    const Table table = table_of(*model, name);
    if (table.name != "erased") written = written && (table.name != "person" || erased.load(to));
    if (read && written && !table.columns.empty())
      read = from.each(select(table), {},
                       [&](const Row& row) { return erased.has(table, row) || (written = put(to, table, row)); });
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

// Checks that the copy has no more rows than the store in any table, and that its pages are undamaged.
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

// Waits until the file is on disk: a backup must survive a power cut.
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
  error = say::kNotBackedUp(shown(store), file, error);
  return false;
}

bool restore_store(const std::string& file, const std::string& store, Copied& out, std::string& error) {
  // a backup of an earlier version is read through an upgraded copy; the file itself is never changed
  const std::unique_ptr<Database> from = open_for_reading(file, error);
  if (!from) return false;
  const std::unique_ptr<Database> to = open_store(store, error);
  if (!to) return false;
  const uint64_t before = count(*to, "attempt");
  if (!copy_all(*from, *to, error)) {
    error = say::kNotRestored(file, shown(store), error);
    return false;
  }
  out.people = count(*from, "person");
  out.attempts = count(*from, "attempt");
  out.added = count(*to, "attempt") - before;
  return true;
}

}  // namespace swage::record
