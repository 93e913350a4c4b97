// SPDX-License-Identifier: Apache-2.0
#include "record/transfer.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "base/hash.hpp"
#include "record/attempt_rows.hpp"
#include "record/identity.hpp"
#include "record/recorder.hpp"
#include "record/schema.hpp"
#include "record/sentences.hpp"

namespace swage::record {
namespace {

// An exported attempt has at most 70 kB a second, 250 MB an hour; a larger file is not one.
constexpr uint64_t kMostFile = uint64_t{1} << 30;

struct Source {
  Kind kind;
  std::string sql;  // the values of a row of this kind, in its order
};

// In the order in which they are written and hashed; parts added by a version come last, so that the checksum of an attempt
// without them stays the same.
std::vector<Source> sources(int version) {
  const std::string of_person =
      " FROM person p JOIN session s ON s.person_id = p.person_id"
      " JOIN attempt a ON a.session_id = s.session_id WHERE a.attempt_id = ?";
  std::vector<Source> out = {
      {Kind::kPerson, "SELECT p.person_id, p.pseudonym, p.created_utc" + of_person},
      {Kind::kSession,
       "SELECT s.session_id, s.station, s.app_version, s.started_utc, p.pseudonym" + of_person},
      {Kind::kDevice,
       "SELECT d.device_id, d.plugin, d.serial, d.descriptor FROM device d JOIN attempt a ON a.device = "
       "d.plugin"
       " WHERE a.attempt_id = ?"},
      {Kind::kAttempt, "SELECT " + std::string(kAttemptColumns) + " FROM attempt WHERE attempt_id = ?"},
      {Kind::kMetric,
       "SELECT attempt_id, seq, name, value, unit FROM metric WHERE attempt_id = ? ORDER BY seq"},
      {Kind::kEvent,
       "SELECT attempt_id, seq, step, t_us, kind, script_index, owner, body, value FROM event WHERE "
       "attempt_id = ?"
       " ORDER BY seq"},
      {Kind::kChunk,
       "SELECT attempt_id, stream, seq, t0_us, n, codec, crc32c, data, dictionary FROM chunk WHERE "
       "attempt_id = ?"
       " ORDER BY stream, seq"},
  };
  if (version >= 2) {
    out.push_back({Kind::kHand,
                   "SELECT attempt_id, seq, name, choice, plugin, version, params, flags FROM hand"
                   " WHERE attempt_id = ? ORDER BY seq"});
    out.push_back(
        {Kind::kFile, "SELECT attempt_id, name, crc32c, data FROM file WHERE attempt_id = ? ORDER BY name"});
  }
  if (version >= 4) {
    out.push_back({Kind::kProvenance,
                   "SELECT attempt_id, lesson_digest, input, calibration, is_scripted, is_synthetic FROM provenance"
                   " WHERE attempt_id = ?"});
    out.push_back({Kind::kNote,
                   "SELECT note_id, attempt_id, step, t_us, made_utc, made_by, body FROM note WHERE attempt_id = ?"
                   " ORDER BY note_id"});
    out.push_back({Kind::kRuling,
                   "SELECT ruling_id, attempt_id, kind, made_utc, made_by, reason FROM ruling WHERE attempt_id = ?"
                   " ORDER BY ruling_id"});
  }
  if (version >= 6)
    out.push_back({Kind::kRating,
                   "SELECT attempt_id, item, points, made_utc, made_by FROM rating WHERE attempt_id = ?"
                   " ORDER BY item, made_by"});
  return out;
}

void add_row(base::Hash& hash, const Row& row) {
  for (const Value& value : row) {
    hash.add(uint64_t{value.index()});
    if (const auto* i = std::get_if<int64_t>(&value)) hash.add(static_cast<uint64_t>(*i));
    if (const auto* d = std::get_if<double>(&value)) hash.add(*d);
    if (const auto* t = std::get_if<std::string>(&value))
      hash.add(t->data(), t->size()).add(uint64_t{t->size()});
    if (const auto* b = std::get_if<Blob>(&value)) hash.add(b->data(), b->size()).add(uint64_t{b->size()});
  }
}

// every row of an attempt, one at a time, so that an hour of traces is never in memory as a whole
bool each_row(Database& db, const std::string& id, const std::function<bool(Kind, const Row&)>& visit) {
  bool ok = true;
  for (const Source& source : sources(schema_version(db))) {
    const bool read = db.each(source.sql, {id}, [&](const Row& row) { return ok = visit(source.kind, row); });
    if (!read || !ok) return false;
  }
  return true;
}

bool copy(Database& from, Database& to, const std::string& id, std::string& digest, std::string& error) {
  base::Hash hash;
  const bool ok = to.begin() && each_row(from, id, [&](Kind kind, const Row& row) {
                    add_row(hash, row);
                    return write(to, {kind, row});
                  });
  if (ok && to.commit()) {
    digest = std::to_string(hash.value());
    return true;
  }
  if (to.trouble() != Trouble::kNone)
    error = "It cannot be written: " + to.error() + ".";
  else
    error = "It cannot be read: " + from.error() + ".";
  to.rollback();
  return false;
}

bool make_file(Database& store, const std::string& id, const std::string& file, std::string& error) {
  const std::unique_ptr<Database> out = Database::open(file, Access::kWrite, error);
  std::string digest;
  return out && bring_up_to_date(*out, schema_steps(), error) && copy(store, *out, id, digest, error) &&
         out->run(kExportTable) &&
         out->run("INSERT INTO swage_export (digest) VALUES (?)", {digest});
}

// checks a file of unknown origin before any row is used
bool check_file(Database& file, std::string& id, std::string& error) {
  error = foreign_tables(file, true);
  if (!error.empty()) {
    // the message names a store of many attempts as such
    const std::vector<Row> attempts = file.rows("SELECT COUNT(*) FROM attempt");
    const bool store = foreign_tables(file, false).empty() && !attempts.empty() && integer(attempts[0][0]) > 1;
    if (!store) return false;
  }
  const std::vector<Row> integrity = file.rows("PRAGMA integrity_check(1)");
  if (integrity.empty() || text(integrity[0][0]) != "ok") {
    error = "It is damaged: " + (integrity.empty() ? file.error() : text(integrity[0][0])) + ".";
    return false;
  }
  const std::vector<Row> attempts = file.rows("SELECT attempt_id FROM attempt LIMIT 2");
  if (attempts.size() != 1) {
    error = attempts.empty() ? say::kHoldsNoAttempt()
                             : say::kHoldsMore();
    return false;
  }
  id = text(attempts[0][0]);
  if (!is_id(id)) {
    error = say::kStrangeId();
    return false;
  }

  base::Hash hash;
  const std::vector<Row> digest = file.rows("SELECT digest FROM swage_export");
  const bool read = each_row(file, id, [&](Kind, const Row& row) {
    add_row(hash, row);
    return true;
  });
  if (read && digest.size() == 1 && text(digest[0][0]) == std::to_string(hash.value())) return true;
  error = say::kRowsChecksum();
  return false;
}

}  // namespace

bool write_attempt_file(Database& store, const std::string& id, const std::string& file, std::string& error) {
  if (store.rows("SELECT attempt_id FROM attempt WHERE attempt_id = ?", {id}).empty()) {
    error = say::kNoAttempt(id);
    return false;
  }
  const std::string part = file + ".part";
  unlink(part.c_str());
  bool ok = make_file(store, id, part, error);
  if (ok && rename(part.c_str(), file.c_str()) != 0) {
    error = std::string(std::strerror(errno)) + ".";
    ok = false;
  }
  if (ok) return true;
  unlink(part.c_str());
  error = say::kNotExported(id, file, error);
  return false;
}

bool read_attempt_file(Database& store, const std::string& file, std::string& id, std::string& error) {
  std::error_code code;
  if (std::filesystem::is_regular_file(file, code) && std::filesystem::file_size(file, code) > kMostFile) {
    error = say::kTooLarge(file);
    return false;
  }
  const std::unique_ptr<Database> in = open_for_reading(file, error);
  if (!in) return false;
  std::string found, digest, reason;
  const auto was_erased = [&] {
    if (store.rows("SELECT 1 FROM erased WHERE erased_id = ?", {found}).empty()) return false;
    reason = say::kErased();
    return true;
  };
  if (check_file(*in, found, reason) && check_recording(file, found, reason) && !was_erased() &&
      copy(*in, store, found, digest, reason)) {
    id = found;
    return true;
  }
  error = file + " is refused. " + reason;
  return false;
}

}  // namespace swage::record
