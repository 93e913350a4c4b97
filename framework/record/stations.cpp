// SPDX-License-Identifier: Apache-2.0
#include "record/stations.hpp"

#include <algorithm>
#include <cmath>

#include "record/identity.hpp"
#include "record/schema.hpp"
#include "record/sentences.hpp"

namespace swage::record {
namespace {

// s since 1970 by the server's clock
const std::string kNow = "CAST(EXTRACT(EPOCH FROM clock_timestamp()) AS DOUBLE PRECISION)";

constexpr const char* kChannels[] = {"swage_now", "swage_message", "swage_picture"};
// s before the moment at which an instructor marks: the event is already over then, as for a mark at the station itself
constexpr double kBeforeMark_s = 2.0;
constexpr int kMostNames = 64;  // limit of programs on machines of the same name
constexpr char kBetweenCues = '\n';

std::string join(const std::vector<std::string>& cues) {
  std::string out;
  for (const std::string& c : cues) out += (out.empty() ? "" : std::string(1, kBetweenCues)) + c;
  return out;
}

std::vector<std::string> split(const std::string& cues) {
  std::vector<std::string> out;
  for (std::size_t from = 0; from < cues.size();) {
    const std::size_t end = std::min(cues.find(kBetweenCues, from), cues.size());
    out.push_back(cues.substr(from, end - from));
    from = end + 1;
  }
  return out;
}

int64_t whole(uint64_t n) { return static_cast<int64_t>(n); }
uint64_t natural(const Value& v) { return static_cast<uint64_t>(std::max<int64_t>(integer(v), 0)); }

StationState state_from(const Value& v) {
  return static_cast<StationState>(std::clamp<int64_t>(integer(v), 0, static_cast<int64_t>(StationState::kClosed)));
}

class SqlStations final : public Stations {
 public:
  explicit SqlStations(std::unique_ptr<Database> db) : db_(std::move(db)) {}
  const std::string& error() const override { return error_; }
  bool lost() const override { return lost_; }

  bool listen(Channel channel, std::function<void()> heard) override {
    return done(db_->listen(kChannels[static_cast<int>(channel)], std::move(heard)));
  }

  bool enter(const std::string& wanted, const std::string& program, std::string& name) override;
  bool say(const StationNow& now) override;

  bool leave() override {
    return done(db_->run("WITH picture AS (DELETE FROM station_picture WHERE station_id = ?),"
                         " gone AS (UPDATE station SET state = ?, person_id = '', attempt_id = '', seen_s = " + kNow +
                         " WHERE station_id = ? AND program_id = ? RETURNING station_id)"
                         " SELECT pg_notify('swage_now', station_id) FROM gone",
                         {name_, static_cast<int64_t>(StationState::kClosed), name_, program_}));
  }

  bool inbox(std::vector<StationMessage>& out) override {
    return messages(" WHERE to_station = ? AND answer = '' ORDER BY message_id", out);
  }
  bool sent(std::vector<StationMessage>& out) override {
    return messages(" WHERE from_station = ? AND kind <> 2 ORDER BY message_id DESC", out);
  }

  bool tell_shown(const std::string& id) override {
    return receipt("UPDATE message SET shown_s = " + kNow + " WHERE message_id = ? AND shown_s IS NULL RETURNING message_id",
                   {id});
  }
  bool tell_answer(const std::string& id, const std::string& answer) override {
    return receipt("UPDATE message SET answer = ?, answered_s = " + kNow + " WHERE message_id = ? RETURNING message_id",
                   {answer, id});
  }

  bool show_picture(const std::string& png) override {
    return done(db_->run("WITH shown AS (INSERT INTO station_picture (station_id, taken_s, png) VALUES (?, " + kNow + ", ?)"
                         " ON CONFLICT (station_id) DO UPDATE SET taken_s = excluded.taken_s, png = excluded.png"
                         " RETURNING station_id) SELECT pg_notify('swage_picture', station_id) FROM shown",
                         {name_, Blob(png.begin(), png.end())}));
  }

  bool all(std::vector<StationNow>& out) override;

  bool send(StationMessage& m) override {
    m.id = make_id();
    m.from = name_;
    return done(db_->run("WITH old AS (DELETE FROM message WHERE sent_s < " + kNow + " - CAST(? AS DOUBLE PRECISION)),"
                         " said AS (INSERT INTO message (message_id, to_station, from_station, kind, body, title, sent_s, answer)"
                         " VALUES (?, ?, ?, ?, ?, ?, " + kNow + ", '') RETURNING to_station)"
                         " SELECT pg_notify('swage_message', to_station) FROM said",
                         {kMessageLife_s, m.id, m.to, m.from, static_cast<int64_t>(m.kind), m.body, m.title}));
  }

  bool picture(const std::string& station, std::string& png, double& age_s) override {
    const std::vector<Row> found = db_->rows(
        "SELECT png, " + kNow + " - taken_s FROM station_picture WHERE station_id = ?", {station});
    png.clear();
    if (!done(db_->trouble() == Trouble::kNone) || found.empty()) return error_.empty();
    const Blob& data = blob(found[0][0]);
    png.assign(data.begin(), data.end());
    age_s = real(found[0][1]);
    return true;
  }

  bool mark(const std::string& station, const std::string& words, const std::string& by, double& time_s) override;

  bool forget(const std::string& station) override {
    return done(db_->run("DELETE FROM message WHERE to_station = ?", {station}) &&
                db_->run("DELETE FROM station WHERE station_id = ?", {station}));
  }

 private:
  bool done(bool good) {
    error_ = good ? "" : db_->error();
    lost_ = lost_ || (!good && db_->trouble() == Trouble::kUnreachable);
    if (!good && error_.empty()) error_ = "The server refused.";
    return good;
  }
  bool fail(const std::string& sentence) {
    error_ = sentence;
    return false;
  }
  bool receipt(const std::string& update, const Row& values) {
    return done(db_->run("WITH told AS (" + update + ") SELECT pg_notify('swage_message', message_id) FROM told", values));
  }
  bool messages(const std::string& which, std::vector<StationMessage>& out);
  std::string id_of(const std::string& person);

  std::unique_ptr<Database> db_;
  std::string program_, name_, error_;
  std::string person_, person_id_;  // last query of id_of()
  bool lost_ = false;
};

// A single statement, so that two programs never take the same name.
bool SqlStations::enter(const std::string& wanted, const std::string& program, std::string& name) {
  program_ = program;
  const std::string take =
      "INSERT INTO station (station_id, program_id, app_version, seen_s, state, person_id, lesson_id, lesson_title, mode, phase,"
      " cues, attempt_id, step, time_s, late, dropped, solver, stopped, silent_devices, is_recorded)"
      " VALUES (?, ?, ?, " + kNow + ", 0, '', '', '', '', '', '', '', 0, 0, 0, 0, 0, 0, 0, 0)"
      " ON CONFLICT (station_id) DO UPDATE SET program_id = excluded.program_id, app_version = excluded.app_version,"
      " seen_s = excluded.seen_s, state = 0, person_id = '', attempt_id = '' WHERE station.program_id = excluded.program_id"
      " OR station.state = ? OR station.seen_s < excluded.seen_s - CAST(? AS DOUBLE PRECISION) RETURNING station_id";
  for (int i = 1; i <= kMostNames; ++i) {
    const std::string next = i == 1 ? wanted : wanted + " " + std::to_string(i);
    const std::vector<Row> taken =
        db_->rows(take, {next, program_, std::string(SWAGE_VERSION), static_cast<int64_t>(StationState::kClosed), kLost_s});
    if (!done(db_->trouble() == Trouble::kNone)) return false;
    if (taken.empty()) continue;
    name = name_ = next;
    return true;
  }
  return fail(say::kManyStations(kMostNames, wanted));
}

// Finds a person by the roster's name; cached for the last name found.
std::string SqlStations::id_of(const std::string& person) {
  if (person == person_ && !person_id_.empty()) return person_id_;
  person_ = person;
  const std::vector<Row> found =
      db_->rows("SELECT p.person_id FROM person p LEFT JOIN roster n ON n.person_id = p.person_id"
                " WHERE n.display_name = ? OR p.pseudonym = ? ORDER BY COALESCE(n.display_name, '') = ? DESC LIMIT 1",
                {person, person, person});
  return person_id_ = found.empty() ? "" : text(found[0][0]);
}

bool SqlStations::say(const StationNow& n) {
  const std::string who = n.person.empty() ? "" : id_of(n.person);
  if (!done(db_->trouble() != Trouble::kUnreachable)) return false;
  // a row that was removed from the list is inserted again
  return done(db_->run(
      "WITH said AS (INSERT INTO station (station_id, program_id, app_version, seen_s, state, person_id, lesson_id, lesson_title,"
      " mode, phase, cues, attempt_id, step, time_s, score, force_n, late, dropped, solver, stopped, silent_devices, is_recorded)"
      " VALUES (?, ?, ?, " + kNow + ", ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"
      " ON CONFLICT (station_id) DO UPDATE SET seen_s = excluded.seen_s, state = excluded.state, person_id = excluded.person_id,"
      " lesson_id = excluded.lesson_id, lesson_title = excluded.lesson_title, mode = excluded.mode, phase = excluded.phase,"
      " cues = excluded.cues, attempt_id = excluded.attempt_id, step = excluded.step, time_s = excluded.time_s,"
      " score = excluded.score, force_n = excluded.force_n, late = excluded.late, dropped = excluded.dropped,"
      " solver = excluded.solver, stopped = excluded.stopped, silent_devices = excluded.silent_devices,"
      " is_recorded = excluded.is_recorded RETURNING station_id) SELECT pg_notify('swage_now', station_id) FROM said",
      {name_, program_, std::string(SWAGE_VERSION), static_cast<int64_t>(n.state), who, n.lesson_id, n.lesson_title, n.mode, n.phase,
       join(n.cues), n.attempt_id, whole(n.step), n.time_s, n.score, n.force_N, whole(n.late), whole(n.dropped), whole(n.solver),
       whole(n.stopped), whole(n.silent_devices), static_cast<int64_t>(n.recorded)}));
}

bool SqlStations::all(std::vector<StationNow>& out) {
  out.clear();
  for (const Row& r : db_->rows(
           "SELECT s.station_id, s.state, COALESCE(n.display_name, p.pseudonym, ''), s.lesson_id, s.lesson_title, s.mode, s.phase,"
           " s.cues, s.attempt_id, s.step, s.time_s, s.score, s.force_n, s.late, s.dropped, s.solver, s.stopped, s.silent_devices,"
           " s.is_recorded, s.app_version, " + kNow + " - s.seen_s FROM station s"
           " LEFT JOIN person p ON p.person_id = s.person_id LEFT JOIN roster n ON n.person_id = s.person_id")) {
    StationNow n;
    n.station = text(r[0]);
    n.state = state_from(r[1]);
    n.person = text(r[2]);
    n.lesson_id = text(r[3]);
    n.lesson_title = text(r[4]);
    n.mode = text(r[5]);
    n.phase = text(r[6]);
    n.cues = split(text(r[7]));
    n.attempt_id = text(r[8]);
    n.step = natural(r[9]);
    n.time_s = real(r[10]);
    n.score = real(r[11]);
    n.force_N = real(r[12]);
    n.late = natural(r[13]);
    n.dropped = natural(r[14]);
    n.solver = natural(r[15]);
    n.stopped = natural(r[16]);
    n.silent_devices = natural(r[17]);
    n.recorded = integer(r[18]) != 0;
    n.app_version = text(r[19]);
    n.silent_s = std::max(0.0, real(r[20]));
    out.push_back(std::move(n));
  }
  // independent of the server's collation
  std::sort(out.begin(), out.end(), [](const StationNow& a, const StationNow& b) { return a.station < b.station; });
  return done(db_->trouble() == Trouble::kNone);
}

bool SqlStations::messages(const std::string& which, std::vector<StationMessage>& out) {
  out.clear();
  for (const Row& r : db_->rows("SELECT message_id, to_station, from_station, kind, body, title, answer, " + kNow +
                                " - sent_s, shown_s FROM message" + which,
                                {name_})) {
    StationMessage m;
    m.id = text(r[0]);
    m.to = text(r[1]);
    m.from = text(r[2]);
    m.kind = static_cast<StationMessage::Kind>(std::clamp<int64_t>(integer(r[3]), 0, 2));
    m.body = text(r[4]);
    m.title = text(r[5]);
    m.answer = text(r[6]);
    m.age_s = std::max(0.0, real(r[7]));
    m.shown = !std::isnan(real(r[8]));
    if (m.age_s < kMessageLife_s) out.push_back(std::move(m));
  }
  return done(db_->trouble() == Trouble::kNone);
}

// The station's time of the attempt has advanced since its last report, unless it is paused.
bool SqlStations::mark(const std::string& station, const std::string& words, const std::string& by, double& time_s) {
  std::vector<StationNow> now;
  if (!all(now)) return false;
  const auto at = std::find_if(now.begin(), now.end(), [&](const StationNow& n) { return n.station == station; });
  const bool runs = at != now.end() && !at->lost() && (at->state == StationState::kRunning || at->state == StationState::kPaused);
  if (!runs) return fail(say::kNothingRuns(station));
  if (at->attempt_id.empty()) return fail(say::kNotRecorded(station));
  const double since = at->state == StationState::kRunning ? at->silent_s : 0;
  time_s = std::max(0.0, at->time_s + since - kBeforeMark_s);
  const double steps_per_s = at->time_s > 0 ? static_cast<double>(at->step) / at->time_s : 0;
  const std::vector<Row> there = db_->rows("SELECT 1 FROM attempt WHERE attempt_id = ?", {at->attempt_id});
  if (!done(db_->trouble() == Trouble::kNone)) return false;
  if (there.empty()) return fail(say::kKeptThere(station));
  return done(db_->run("INSERT INTO note (note_id, attempt_id, step, t_us, made_utc, made_by, body) VALUES (?, ?, ?, ?, ?, ?, ?)",
                       {make_id(), at->attempt_id, static_cast<int64_t>(std::llround(time_s * steps_per_s)),
                        static_cast<int64_t>(std::llround(time_s * 1e6)), utc_now(), by, words.empty() ? std::string("Mark") : words}));
}

}  // namespace

std::unique_ptr<Stations> Stations::open(const std::string& where, std::string& error) {
  if (!is_postgres(where)) {
    error = "The store is a file, and a file has one station. To see all stations of a school, give each the same PostgreSQL "
            "database: --store postgresql://user@host/database?sslmode=verify-full.";
    return nullptr;
  }
  std::unique_ptr<Database> db = open_store(where, error);
  return db ? std::make_unique<SqlStations>(std::move(db)) : nullptr;
}

}  // namespace swage::record
