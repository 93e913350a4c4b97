// SPDX-License-Identifier: Apache-2.0
#include "record/schema.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include "record/identity.hpp"
#include "record/sentences.hpp"

namespace swage::record {
namespace {

// Keys are UUIDs made by the program and times are UTC text, so that stores of many stations merge by
// inserting missing rows. No automatic numbers, no triggers, no types of one server only. DOUBLE
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
        // 2: data beside the samples that a replay elsewhere needs
        "CREATE TABLE hand (attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " seq BIGINT NOT NULL, name TEXT NOT NULL, choice TEXT NOT NULL, plugin TEXT NOT NULL,"
        " version TEXT NOT NULL, params TEXT NOT NULL, flags BIGINT NOT NULL, PRIMARY KEY (attempt_id, seq))",

        "CREATE TABLE file (attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " name TEXT NOT NULL, crc32c BIGINT NOT NULL, data @BLOB@ NOT NULL, PRIMARY KEY (attempt_id, name))",
    },
    {
        // 3: a checksum of an attempt's rows, and the results of later versions of its lesson for it
        "CREATE TABLE seal (attempt_id TEXT PRIMARY KEY REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " digest TEXT NOT NULL)",

        "CREATE TABLE grade (grade_id TEXT PRIMARY KEY,"
        " attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " graded_utc TEXT NOT NULL, app_version TEXT NOT NULL, plugins TEXT NOT NULL, identical BIGINT NOT NULL,"
        " outcome TEXT NOT NULL, reason TEXT NOT NULL, score DOUBLE PRECISION, metrics TEXT NOT NULL)",
        "CREATE INDEX grade_by_attempt ON grade (attempt_id)",
    },
    {
        // 4: a school. Names of people are in `roster` alone, which is in no exported attempt; empty text means "none".
        "CREATE TABLE people_group (group_id TEXT PRIMARY KEY, position BIGINT NOT NULL, name TEXT NOT NULL,"
        " created_utc TEXT NOT NULL, archived_utc TEXT NOT NULL)",

        "CREATE TABLE roster (person_id TEXT PRIMARY KEY REFERENCES person (person_id) ON DELETE CASCADE,"
        " display_name TEXT NOT NULL, handedness TEXT NOT NULL CHECK (handedness IN ('', 'left', 'right')),"
        " group_id TEXT NOT NULL, archived_utc TEXT NOT NULL, changed_utc TEXT NOT NULL)",
        "CREATE INDEX roster_by_name ON roster (display_name)",
        "CREATE INDEX session_by_person ON session (person_id)",

        // a lesson as published; attempts refer to its digest
        "CREATE TABLE lesson_version (version_id TEXT PRIMARY KEY, digest TEXT NOT NULL UNIQUE, lesson_id TEXT NOT NULL,"
        " title TEXT NOT NULL, body TEXT NOT NULL, frozen_utc TEXT NOT NULL, retired_utc TEXT NOT NULL,"
        " number BIGINT NOT NULL)",

        // body: steps, limits and rules as JSON
        "CREATE TABLE course (course_id TEXT PRIMARY KEY, title TEXT NOT NULL, body TEXT NOT NULL,"
        " created_utc TEXT NOT NULL, changed_utc TEXT NOT NULL, published_utc TEXT NOT NULL, archived_utc TEXT NOT NULL)",

        "CREATE TABLE assignment (assignment_id TEXT PRIMARY KEY, to_group BIGINT NOT NULL,"
        " course_id TEXT NOT NULL REFERENCES course (course_id) ON DELETE CASCADE, who_id TEXT NOT NULL,"
        " made_utc TEXT NOT NULL, due_utc TEXT NOT NULL)",

        "CREATE TABLE note (note_id TEXT PRIMARY KEY,"
        " attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE, step BIGINT NOT NULL,"
        " t_us BIGINT NOT NULL, made_utc TEXT NOT NULL, made_by TEXT NOT NULL, body TEXT NOT NULL)",
        "CREATE INDEX note_by_attempt ON note (attempt_id)",

        // a person's decision about an attempt; the last one of each attempt is valid. kind: 0 counts, 1 void, 2 assigned to a person
        "CREATE TABLE ruling (ruling_id TEXT PRIMARY KEY,"
        " attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE, kind BIGINT NOT NULL,"
        " made_utc TEXT NOT NULL, made_by TEXT NOT NULL, reason TEXT NOT NULL)",
        "CREATE INDEX ruling_by_attempt ON ruling (attempt_id)",

        // origin of an attempt's numbers; calibration: JSON
        "CREATE TABLE provenance (attempt_id TEXT PRIMARY KEY REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " lesson_digest TEXT NOT NULL, input TEXT NOT NULL, calibration TEXT NOT NULL, is_scripted BIGINT NOT NULL,"
        " is_synthetic BIGINT NOT NULL)",

        // people and attempts that were erased permanently: no backup and no file restores them
        "CREATE TABLE erased (erased_id TEXT PRIMARY KEY, is_person BIGINT NOT NULL, erased_utc TEXT NOT NULL)",

        // files with data of a person; whole: without data of anybody else
        "CREATE TABLE exported (export_id TEXT PRIMARY KEY, whole BIGINT NOT NULL,"
        " person_id TEXT NOT NULL REFERENCES person (person_id) ON DELETE CASCADE, kind TEXT NOT NULL,"
        " file TEXT NOT NULL, station TEXT NOT NULL, made_utc TEXT NOT NULL)",
    },
    {
        // 5: the present state of a school's stations, and messages between them. Volatile: one row per station, overwritten twice a
        // second, in no backup and no export. Times: s since 1970 by the server's clock, as the stations' clocks differ.
        "CREATE TABLE station (station_id TEXT PRIMARY KEY, program_id TEXT NOT NULL, app_version TEXT NOT NULL,"
        " seen_s DOUBLE PRECISION NOT NULL, state BIGINT NOT NULL, person_id TEXT NOT NULL, lesson_id TEXT NOT NULL,"
        " lesson_title TEXT NOT NULL, mode TEXT NOT NULL, phase TEXT NOT NULL, cues TEXT NOT NULL, attempt_id TEXT NOT NULL,"
        " step BIGINT NOT NULL, time_s DOUBLE PRECISION NOT NULL, score DOUBLE PRECISION, force_n DOUBLE PRECISION,"
        " late BIGINT NOT NULL, dropped BIGINT NOT NULL, solver BIGINT NOT NULL, stopped BIGINT NOT NULL,"
        " silent_devices BIGINT NOT NULL, is_recorded BIGINT NOT NULL)",

        "CREATE TABLE station_picture (station_id TEXT PRIMARY KEY REFERENCES station (station_id) ON DELETE CASCADE,"
        " taken_s DOUBLE PRECISION NOT NULL, png @BLOB@ NOT NULL)",

        // kind: 0 text, 1 a lesson, 2 a request for a picture; answer: "" before it is answered
        "CREATE TABLE message (message_id TEXT PRIMARY KEY, to_station TEXT NOT NULL, from_station TEXT NOT NULL,"
        " kind BIGINT NOT NULL, body TEXT NOT NULL, title TEXT NOT NULL, sent_s DOUBLE PRECISION NOT NULL,"
        " shown_s DOUBLE PRECISION, answered_s DOUBLE PRECISION, answer TEXT NOT NULL)",
        "CREATE INDEX message_by_station ON message (to_station)",
    },
    {
        // 6: points that a person gives an attempt on an item of a rating scale, one row for each person and item
        "CREATE TABLE rating (attempt_id TEXT NOT NULL REFERENCES attempt (attempt_id) ON DELETE CASCADE,"
        " item TEXT NOT NULL, points DOUBLE PRECISION NOT NULL, made_utc TEXT NOT NULL, made_by TEXT NOT NULL,"
        " PRIMARY KEY (attempt_id, item, made_by))",
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
  return say::kNewerTables(version, known);
}

// Programs that start at the same time on a new database must not create its tables twice; the lock ends with the transaction.
constexpr const char* kLockTables = "SELECT pg_advisory_xact_lock(83874652119)";  // any number, the same in every Swage

// Killing the program loses nothing that was committed; a power cut may lose the last commits but damages nothing. While another
// program switches a new file to that mode, SQLite reports "locked" without waiting.
bool use_write_ahead_log(Database& db) {
  constexpr int kTries = 40;
  for (int i = 0; i < kTries; ++i) {
    const std::vector<Row> mode = db.rows("PRAGMA journal_mode");
    const bool set = !mode.empty() && text(mode[0][0]) == "wal";
    if (set || db.run("PRAGMA journal_mode = WAL"))
      return db.run("PRAGMA synchronous = NORMAL") && db.run("PRAGMA wal_autocheckpoint = 1000");
    if (db.trouble() != Trouble::kLocked) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
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

  // queries the version again under the lock: another program may have upgraded meanwhile
  bool done = version >= 0 && db.begin() && (!db.on_postgres() || db.run(kLockTables));
  if (done) {
    version = schema_version(db);
    done = version >= 0 && take_steps(db, steps, version) && db.commit();
    if (!done) db.rollback();
  }
  if (!done) error = say::kNoUpgrade(db.error());
  return done;
}

std::string foreign_tables(Database& db, bool alone) {
  constexpr const char* kObjects =
      "SELECT type, name, tbl_name, sql FROM sqlite_master WHERE sql IS NOT NULL ORDER BY type, name";
  if (db.on_postgres()) return "";
  std::string error;
  const int version = schema_version(db);
  const std::unique_ptr<Database> model = Database::open(kInMemory, Access::kWrite, error);
  if (version < 1 || static_cast<std::size_t>(version) > kSteps.size() || !model ||
      !bring_up_to_date(*model, schema_steps().first(static_cast<std::size_t>(version)), error))
    return say::kNotCompared(error);
  std::vector<Row> there = db.rows(kObjects);
  if (db.trouble() != Trouble::kNone) return say::kNoTableList(db.error());
  for (const Row& wanted : model->rows(kObjects)) {
    const auto found = std::find(there.begin(), there.end(), wanted);
    if (found == there.end())
      return say::kOtherTable(text(wanted[0]), text(wanted[1]));
    there.erase(found);
  }
  for (const Row& more : there)
    if (alone && text(more[3]) != kExportTable)
      return say::kStrangeTable(text(more[0]));
  return "";
}

std::unique_ptr<Database> open_store(const std::string& where, std::string& error, Trouble* why) {
  Trouble trouble = Trouble::kNone;
  std::unique_ptr<Database> db = Database::open(where, Access::kWrite, error, &trouble);
  if (why != nullptr) *why = trouble;
  if (!db) {
    error += remedy(where, trouble);
    return nullptr;
  }
  const bool ready = db->on_postgres() || use_write_ahead_log(*db);
  if (!ready) error = db->error() + ".";
  if (ready && bring_up_to_date(*db, schema_steps(), error)) {
    error = foreign_tables(*db, false);
    if (error.empty()) return db;
    trouble = Trouble::kDamaged;
  } else {
    trouble = db->trouble();
  }
  // tables exist but differ from their definition
  if (trouble == Trouble::kOther && !db->on_postgres()) trouble = Trouble::kDamaged;
  if (trouble == Trouble::kNone) trouble = Trouble::kOther;
  if (why != nullptr) *why = trouble;
  error = say::kUnusable(shown(where), error, remedy(where, trouble));
  return nullptr;
}

std::unique_ptr<Database> open_for_reading(const std::string& where, std::string& error, Trouble* why) {
  Trouble trouble = Trouble::kNone;
  std::unique_ptr<Database> db = Database::open(where, Access::kRead, error, &trouble);
  if (!db) {
    if (why != nullptr) *why = trouble;
    return nullptr;
  }
  const int version = schema_version(*db);
  if (version >= 1 && static_cast<std::size_t>(version) <= schema_steps().size()) {
    const std::string foreign = foreign_tables(*db, false);
    if (foreign.empty()) return db;
    error = say::kForeign(shown(where), foreign, remedy(where, Trouble::kDamaged));
    if (why != nullptr) *why = Trouble::kDamaged;
    return nullptr;
  }
  trouble = version < 0 && db->trouble() != Trouble::kNone ? db->trouble() : Trouble::kOther;
  if (why != nullptr) *why = trouble;
  if (version > 0)
    error = shown(where) + ": " + too_new(version, schema_steps().size());
  else if (version == 0)
    error = say::kOtherDatabase(shown(where));
  else if (db->error().find("not a database") != std::string::npos)
    error = say::kNoStoreFile(where, remedy(where, trouble));
  else
    error = say::kUnreadable(shown(where), db->error(), remedy(where, trouble));
  return nullptr;
}

std::string remedy(const std::string& where, Trouble why) {
  switch (why) {
    case Trouble::kDamaged:
      if (is_postgres(where)) return say::kRestoreBackup();
      return say::kSalvageIt(where);
    case Trouble::kFull:
      return say::kFreeSpace();
    case Trouble::kReadOnly:
      return say::kOtherStore();
    case Trouble::kUnreachable:
      return say::kCheckServer();
    default:
      return "";
  }
}

}  // namespace swage::record
