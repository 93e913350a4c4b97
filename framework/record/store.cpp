// SPDX-License-Identifier: Apache-2.0
#include "record/store.hpp"

#include <cstdlib>
#include <map>

#include "record/identity.hpp"
#include "record/journal.hpp"
#include "record/schema.hpp"
#include "record/transfer.hpp"

namespace swage::record {
namespace {

constexpr const char* kSelectAttempts =
    "SELECT a.attempt_id, p.person_id, p.pseudonym, a.exercise, a.title, a.mode, a.device, a.started_utc, "
    "a.ended_utc,"
    " a.state, a.outcome, a.reason, a.score, a.simulated_s, a.is_void FROM attempt a"
    " JOIN session s ON s.session_id = a.session_id JOIN person p ON p.person_id = s.person_id";

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
  return a;
}

class SqlStore final : public Store {
 public:
  SqlStore(std::unique_ptr<Database> db, std::string where) : db_(std::move(db)), where_(std::move(where)) {}

  std::vector<Person> people() override {
    std::vector<Person> out;
    const char* sql =
        "SELECT p.person_id, p.pseudonym, p.created_utc, COUNT(a.attempt_id) FROM person p"
        " LEFT JOIN session s ON s.person_id = p.person_id LEFT JOIN attempt a ON a.session_id = s.session_id"
        " GROUP BY p.person_id, p.pseudonym, p.created_utc ORDER BY p.pseudonym";
    for (const Row& r : db_->rows(sql))
      out.push_back({text(r[0]), text(r[1]), text(r[2]), static_cast<uint32_t>(integer(r[3]))});
    return out;
  }

  Person person(const std::string& name) override {
    write(*db_, {Kind::kPerson, {make_id(), name, utc_now()}});
    for (Person& p : people())
      if (p.name == name) return p;
    return {};
  }

  std::vector<AttemptRow> attempts(const std::string& person_id, const std::string& lesson_id) override {
    const std::string which = " WHERE (? = '' OR p.person_id = ?) AND (? = '' OR a.exercise = ?)";
    const Row values = {person_id, person_id, lesson_id, lesson_id};
    std::vector<AttemptRow> out;
    std::map<std::string, std::size_t> place;
    for (const Row& r :
         db_->rows(kSelectAttempts + which + " ORDER BY a.started_utc DESC, a.attempt_id DESC", values)) {
      place[text(r[0])] = out.size();
      out.push_back(attempt_from(r));
    }
    const std::string metrics =
        "SELECT m.attempt_id, m.name, m.unit, m.value FROM metric m JOIN attempt a ON a.attempt_id = "
        "m.attempt_id"
        " JOIN session s ON s.session_id = a.session_id JOIN person p ON p.person_id = s.person_id";
    for (const Row& r : db_->rows(metrics + which + " ORDER BY m.attempt_id, m.seq", values)) {
      const auto at = place.find(text(r[0]));
      if (at != place.end()) out[at->second].metrics.push_back({text(r[1]), text(r[2]), real(r[3])});
    }
    return out;
  }

  bool attempt(const std::string& id, AttemptRow& out) override {
    const std::vector<Row> rows = db_->rows(std::string(kSelectAttempts) + " WHERE a.attempt_id = ?", {id});
    if (rows.empty()) return false;
    out = attempt_from(rows[0]);
    for (const Row& r :
         db_->rows("SELECT name, unit, value FROM metric WHERE attempt_id = ? ORDER BY seq", {id}))
      out.metrics.push_back({text(r[0]), text(r[1]), real(r[2])});
    return true;
  }

  std::vector<EventRow> events(const std::string& attempt_id) override {
    std::vector<EventRow> out;
    const char* sql =
        "SELECT step, t_us, owner, body, value FROM event WHERE attempt_id = ? ORDER BY step, seq";
    for (const Row& r : db_->rows(sql, {attempt_id}))
      out.push_back({static_cast<uint64_t>(integer(r[0])), 1e-6 * static_cast<double>(integer(r[1])),
                     text(r[2]), text(r[3]), real(r[4])});
    return out;
  }

  int recover() override {
    // on a shared server only this machine can know which of its programs live
    std::string sql =
        "SELECT a.attempt_id, a.dt_s FROM attempt a JOIN session s ON s.session_id = a.session_id"
        " WHERE a.state = 'running'";
    Row values;
    if (db_->on_postgres()) {
      sql += " AND s.station = ?";
      values.push_back(station());
    }
    int recovered = 0;
    for (const Row& r : db_->rows(sql, values))
      if (!is_recording(where_, text(r[0])) && recover_one(text(r[0]), real(r[1]))) ++recovered;
    return recovered;
  }

  bool export_attempt(const std::string& id, const std::string& file, std::string& error) override {
    return write_attempt_file(*db_, id, file, error);
  }
  bool import_attempt(const std::string& file, std::string& id, std::string& error) override {
    return read_attempt_file(*db_, file, id, error);
  }

 private:
  // what was committed tells how far it came
  bool recover_one(const std::string& id, double dt) {
    double simulated = 0;
    for (const Row& r : db_->rows("SELECT t0_us, n FROM chunk WHERE attempt_id = ? AND stream = 'hash'"
                                  " ORDER BY seq DESC LIMIT 1",
                                  {id}))
      simulated = 1e-6 * static_cast<double>(integer(r[0])) + dt * static_cast<double>(integer(r[1]));
    return db_->run(
        "UPDATE attempt SET state = 'recovered', outcome = ?, simulated_s = ?"
        " WHERE attempt_id = ? AND state = 'running'",
        {std::string(judge::text(judge::Outcome::kAborted)), simulated, id});
  }

  std::unique_ptr<Database> db_;
  const std::string where_;
};

}  // namespace

std::unique_ptr<Store> Store::open(const std::string& where, std::string& error) {
  const std::string path = where.empty() ? default_path() : where;
  std::unique_ptr<Database> db = open_store(path, error);
  if (!db) return nullptr;
  merge_journals(*db, path);
  return std::make_unique<SqlStore>(std::move(db), path);
}

std::string Store::default_path() {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && data[0] == '/') return std::string(data) + "/swage/attempts.db";
  const char* home = std::getenv("HOME");
  return std::string(home != nullptr ? home : "") + "/.local/share/swage/attempts.db";
}

}  // namespace swage::record
