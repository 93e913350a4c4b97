// SPDX-License-Identifier: Apache-2.0
#include "record/seal.hpp"

#include "base/hash.hpp"
#include "record/attempt_rows.hpp"

namespace swage::record {
namespace {

// hashed in this order; tables added by a later version come last
const std::string& selects(std::size_t i) {
  static const std::string kSelects[] = {
      "SELECT " + std::string(kAttemptColumns) + " FROM attempt WHERE attempt_id = ?",
      "SELECT seq, name, value, unit FROM metric WHERE attempt_id = ? ORDER BY seq",
      "SELECT seq, step, t_us, kind, script_index, owner, body, value FROM event WHERE attempt_id = ? ORDER BY seq",
      "SELECT stream, seq, t0_us, n, codec, crc32c, dictionary FROM chunk WHERE attempt_id = ? ORDER BY stream, seq",
      "SELECT seq, name, choice, plugin, version, params, flags FROM hand WHERE attempt_id = ? ORDER BY seq",
      "SELECT name, crc32c FROM file WHERE attempt_id = ? ORDER BY name",
      "SELECT p.pseudonym, s.station FROM attempt a JOIN session s ON s.session_id = a.session_id"
      " JOIN person p ON p.person_id = s.person_id WHERE a.attempt_id = ?",
  };
  return kSelects[i];
}
constexpr std::size_t kParts = 7;

void feed(base::Hash& hash, const Row& row) {
  for (const Value& value : row) {
    hash.add(uint64_t{value.index()});
    if (const auto* i = std::get_if<int64_t>(&value)) hash.add(static_cast<uint64_t>(*i));
    if (const auto* d = std::get_if<double>(&value)) hash.add(*d);
    if (const auto* t = std::get_if<std::string>(&value)) hash.add(t->data(), t->size()).add(uint64_t{t->size()});
  }
}

// "" when the rows cannot be read
std::string digest(Database& db, const std::string& id) {
  base::Hash hash;
  for (std::size_t i = 0; i < kParts; ++i) {
    const bool read = db.each(selects(i), {id}, [&](const Row& row) {
      feed(hash, row);
      return true;
    });
    if (!read) return "";
  }
  return std::to_string(hash.value());
}

}  // namespace

bool seal_attempt(Database& db, const std::string& id) {
  const std::string now = digest(db, id);
  return !now.empty() && db.run("INSERT INTO seal (attempt_id, digest) VALUES (?, ?)"
                                " ON CONFLICT (attempt_id) DO UPDATE SET digest = excluded.digest",
                                {id, now});
}

bool seal_holds(Database& db, const std::string& id) {
  const std::vector<Row> said = db.rows("SELECT digest FROM seal WHERE attempt_id = ?", {id});
  return said.empty() || text(said[0][0]) == digest(db, id);
}

void seal_unsealed(Database& db, int most) {
  for (const Row& r : db.rows("SELECT attempt_id FROM attempt WHERE state <> 'running' AND attempt_id NOT IN"
                              " (SELECT attempt_id FROM seal) LIMIT " +
                              std::to_string(most)))
    if (!seal_attempt(db, text(r[0]))) return;
}

std::string broken_seals(Database& db) {
  std::string first;
  int broken = 0;
  for (const Row& r : db.rows("SELECT attempt_id, digest FROM seal ORDER BY attempt_id")) {
    if (digest(db, text(r[0])) == text(r[1])) continue;
    if (broken++ == 0) first = text(r[0]);
  }
  if (broken == 0) return "";
  return std::to_string(broken) + (broken == 1 ? " attempt is" : " attempts are") +
         " no longer what was recorded, the first is " + first + ".";
}

}  // namespace swage::record
