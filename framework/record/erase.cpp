// SPDX-License-Identifier: Apache-2.0
//
// A person is erased for good: rows, recordings, names. What is left are identifiers without meaning, so that an old backup does
// not bring the attempts back.
#include "record/identity.hpp"
#include "record/roster.hpp"

namespace swage::record {

bool erase_rows(Database& db, const std::string& person_id) {
  const std::string now = utc_now();
  const Row who = {person_id};
  return db.run("INSERT INTO erased (erased_id, is_person, erased_utc) SELECT a.attempt_id, 0, CAST(? AS TEXT) FROM attempt a"
                " JOIN session s ON s.session_id = a.session_id WHERE s.person_id = ? ON CONFLICT DO NOTHING",
                {now, person_id}) &&
         db.run("INSERT INTO erased (erased_id, is_person, erased_utc) VALUES (?, 1, ?) ON CONFLICT DO NOTHING",
                {person_id, now}) &&
         db.run("DELETE FROM assignment WHERE to_group = 0 AND who_id = ?", who) &&
         // attempts, chunks, metrics, notes, rulings, the name and the list of files go with it
         db.run("DELETE FROM person WHERE person_id = ?", who);
}

void forget_deleted(Database& db) {
  if (db.on_postgres())
    db.run("VACUUM");
  else
    db.rows("PRAGMA wal_checkpoint(TRUNCATE)");
}

}  // namespace swage::record
