// SPDX-License-Identifier: Apache-2.0
#include "record/schema.hpp"

#include <sys/stat.h>

#include <fstream>

#include "record/identity.hpp"

namespace swage::record {
namespace {

// Keys are UUIDs made by the program and times are UTC text, so that stores of many stations merge by
// inserting what is not there yet. No automatic numbers, no triggers, no types of one server only. DOUBLE
// PRECISION, because REAL is 4 bytes wide on PostgreSQL.
const std::vector<Step> kSteps = {
    {
        "CREATE TABLE person (person_id TEXT PRIMARY KEY, pseudonym TEXT NOT NULL UNIQUE, created_utc TEXT "
        "NOT NULL)",

        "CREATE TABLE session (session_id TEXT PRIMARY KEY,"
        " person_id TEXT NOT NULL REFERENCES person (person_id) ON DELETE CASCADE,"
        " station TEXT NOT NULL, app_version TEXT NOT NULL, started_utc TEXT NOT NULL)",

        "CREATE TABLE attempt (attempt_id TEXT PRIMARY KEY,"
        " session_id TEXT NOT NULL REFERENCES session (session_id) ON DELETE CASCADE,"
        " exercise TEXT NOT NULL, title TEXT NOT NULL, mode TEXT NOT NULL, device TEXT NOT NULL,"
        " started_utc TEXT NOT NULL, ended_utc TEXT NOT NULL,"
        " state TEXT NOT NULL CHECK (state IN ('running', 'complete', 'aborted', 'recovered')),"
        " outcome TEXT NOT NULL, reason TEXT NOT NULL, score DOUBLE PRECISION, simulated_s DOUBLE PRECISION "
        "NOT NULL,"
        " is_void BIGINT NOT NULL, dropped BIGINT NOT NULL, seed BIGINT NOT NULL, dt_s DOUBLE PRECISION NOT "
        "NULL,"
        " realtime BIGINT NOT NULL, descriptor TEXT NOT NULL, descriptor_path TEXT NOT NULL, plugins TEXT "
        "NOT NULL,"
        " devices TEXT NOT NULL, script TEXT NOT NULL, loop_health TEXT NOT NULL)",
        "CREATE INDEX attempt_by_session ON attempt (session_id)",
        "CREATE INDEX attempt_by_exercise ON attempt (exercise)",

        "CREATE TABLE metric (attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " seq BIGINT NOT NULL, name TEXT NOT NULL, value DOUBLE PRECISION, unit TEXT NOT NULL,"
        " PRIMARY KEY (attempt_id, seq))",

        "CREATE TABLE event (attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " seq BIGINT NOT NULL, step BIGINT NOT NULL, t_us BIGINT NOT NULL,"
        " kind TEXT NOT NULL CHECK (kind IN ('script', 'note', 'gap')), script_index BIGINT NOT NULL,"
        " owner TEXT NOT NULL, body TEXT NOT NULL, value DOUBLE PRECISION, PRIMARY KEY (attempt_id, seq))",

        "CREATE TABLE chunk (attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " stream TEXT NOT NULL, seq BIGINT NOT NULL, t0_us BIGINT NOT NULL, n BIGINT NOT NULL,"
        " codec BIGINT NOT NULL, crc32c BIGINT NOT NULL, data @BLOB@ NOT NULL, dictionary TEXT,"
        " PRIMARY KEY (attempt_id, stream, seq))",

        "CREATE TABLE device (device_id TEXT PRIMARY KEY, plugin TEXT NOT NULL, serial TEXT NOT NULL,"
        " descriptor TEXT NOT NULL, UNIQUE (plugin, serial))",

        "CREATE TABLE calibration (calibration_id TEXT PRIMARY KEY,"
        " device_id TEXT NOT NULL REFERENCES device (device_id) ON DELETE CASCADE,"
        " made_utc TEXT NOT NULL, made_by TEXT NOT NULL, kind TEXT NOT NULL, body TEXT NOT NULL,"
        " residual DOUBLE PRECISION)",

        "CREATE TABLE outbox (outbox_id TEXT PRIMARY KEY, kind TEXT NOT NULL, body TEXT NOT NULL,"
        " created_utc TEXT NOT NULL, sent_utc TEXT)",
    },
    {
        // 2: what a replay elsewhere needs beside the samples
        "CREATE TABLE hand (attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " seq BIGINT NOT NULL, name TEXT NOT NULL, choice TEXT NOT NULL, plugin TEXT NOT NULL,"
        " version TEXT NOT NULL, params TEXT NOT NULL, flags BIGINT NOT NULL, PRIMARY KEY (attempt_id, seq))",

        "CREATE TABLE file (attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " name TEXT NOT NULL, crc32c BIGINT NOT NULL, data @BLOB@ NOT NULL, PRIMARY KEY (attempt_id, name))",
    },
};

std::string in_dialect(std::string sql, bool postgres) {
  const std::string token = "@BLOB@";
  for (auto at = sql.find(token); at != std::string::npos; at = sql.find(token))
    sql.replace(at, token.size(), postgres ? "BYTEA" : "BLOB");
  return sql;
}

bool has_table(Database& db, const std::string& name) {
  const char* sql =
      db.on_postgres()
          ? "SELECT table_name FROM information_schema.tables WHERE table_schema = current_schema()"
            " AND table_name = ?"
          : "SELECT name FROM sqlite_master WHERE type = 'table' AND name = ?";
  return !db.rows(sql, {name}).empty();
}

bool take_steps(Database& db, std::span<const Step> steps, int version) {
  if (!db.run(
          "CREATE TABLE IF NOT EXISTS swage_schema (version BIGINT PRIMARY KEY, since_utc TEXT NOT NULL)"))
    return false;
  for (std::size_t i = static_cast<std::size_t>(version); i < steps.size(); ++i) {
    for (const std::string& sql : steps[i])
      if (!db.run(in_dialect(sql, db.on_postgres()))) return false;
    if (!db.run("INSERT INTO swage_schema (version, since_utc) VALUES (?, ?)",
                {static_cast<int64_t>(i + 1), utc_now()}))
      return false;
  }
  return true;
}

std::string too_new(int version, std::size_t known) {
  return "It was written by a newer Swage (tables of version " + std::to_string(version) +
         ", this program knows " + std::to_string(known) + "): update Swage.";
}

bool looks_like_sqlite(const std::string& path) {
  char magic[16] = {};
  std::ifstream(path, std::ios::binary).read(magic, sizeof magic);
  return std::string(magic, 15) == "SQLite format 3";
}

}  // namespace

std::span<const Step> schema_steps() { return kSteps; }

int schema_version(Database& db) {
  const bool known = has_table(db, "swage_schema");
  if (db.trouble() != Trouble::kNone) return -1;
  if (!known) return 0;
  const std::vector<Row> rows = db.rows("SELECT MAX(version) FROM swage_schema");
  return rows.empty() ? -1 : static_cast<int>(integer(rows[0][0]));
}

bool bring_up_to_date(Database& db, std::span<const Step> steps, std::string& error) {
  int version = schema_version(db);
  if (version >= 0 && static_cast<std::size_t>(version) == steps.size()) return true;
  if (version >= 0 && static_cast<std::size_t>(version) > steps.size()) {
    error = too_new(version, steps.size());
    return false;
  }

  // ask again once the lock is ours: another program may have been quicker
  bool done = version >= 0 && db.begin();
  if (done) {
    version = schema_version(db);
    done = version >= 0 && take_steps(db, steps, version) && db.commit();
    if (!done) db.rollback();
  }
  if (!done) error = "Its tables cannot be made or upgraded: " + db.error() + ".";
  return done;
}

std::unique_ptr<Database> open_store(const std::string& where, std::string& error, Trouble* why) {
  std::unique_ptr<Database> db = Database::open(where, Access::kWrite, error, why);
  if (!db) return nullptr;
  bool ok = true;
  if (!db->on_postgres()) {
    // killed programs lose nothing that was committed; a power cut may lose the last commits but damages
    // nothing
    ok = db->run("PRAGMA journal_mode = WAL") && db->run("PRAGMA synchronous = NORMAL") &&
         db->run("PRAGMA wal_autocheckpoint = 1000");
    if (!ok) error = db->error() + ".";
  }
  if (ok && bring_up_to_date(*db, schema_steps(), error)) return db;
  if (why != nullptr) *why = db->trouble() == Trouble::kNone ? Trouble::kOther : db->trouble();
  error = where + " cannot be used as the store of attempts. " + error;
  return nullptr;
}

std::unique_ptr<Database> open_for_reading(const std::string& where, std::string& error) {
  struct stat facts {};
  if (!is_postgres(where) && stat(where.c_str(), &facts) == 0 && !looks_like_sqlite(where)) {
    error = where + " is not a file of Swage attempts (its first bytes are not those of an SQLite file).";
    return nullptr;
  }
  std::unique_ptr<Database> db = Database::open(where, Access::kRead, error);
  if (!db) return nullptr;
  const int version = schema_version(*db);
  if (version >= 1 && static_cast<std::size_t>(version) <= schema_steps().size()) return db;
  if (version < 0)
    error = where + " is damaged and cannot be read: " + db->error() + ".";
  else if (version == 0)
    error = where + " is a database, but not one of Swage attempts.";
  else
    error = where + ": " + too_new(version, schema_steps().size());
  return nullptr;
}

}  // namespace swage::record
