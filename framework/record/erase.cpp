// SPDX-License-Identifier: Apache-2.0
//
// Permanent erasure of a person: rows, recordings, names. Only identifiers without meaning remain, so that an old backup does
// not restore the attempts.
#include "record/erase.hpp"

#include <stdio.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "record/identity.hpp"
#include "record/roster.hpp"
#include "record/sentences.hpp"

namespace swage::record {
namespace {

// Compares the second field of a line of our CSV; codes have neither quotes nor commas.
bool is_line_of(const std::string& line, const std::string& code) {
  const std::size_t first = line.find(',');
  return first != std::string::npos && line.compare(first + 1, code.size() + 1, code + ",") == 0;
}

std::string without_lines(const std::string& csv, const std::string& code) {
  std::string out;
  for (std::size_t from = 0; from < csv.size();) {
    const std::size_t end = std::min(csv.find('\n', from), csv.size() - 1);
    const std::string line = csv.substr(from, end - from + 1);
    if (!is_line_of(line, code)) out += line;
    from = end + 1;
  }
  return out;
}

bool without_statements(const std::string& text, const std::string& code, std::string& out) {
  nlohmann::ordered_json all = nlohmann::ordered_json::parse(text, nullptr, false), kept = nlohmann::ordered_json::array();
  if (!all.is_array()) return false;
  for (const auto& s : all)
    if (s.value("/actor/account/name"_json_pointer, std::string()) != code) kept.push_back(s);
  out = kept.dump(1) + "\n";
  return true;
}

// Writes a file, which appears complete or not at all.
bool put_file(const std::string& path, const std::string& text) {
  const std::string part = path + ".part";
  std::ofstream file(part, std::ios::binary);
  file << text;
  file.close();
  if (file.good() && rename(part.c_str(), path.c_str()) == 0) return true;
  unlink(part.c_str());
  return false;
}

Cleaned clean_backup(const std::string& path, const Person& person) {
  std::string error;
  const auto school = School::open(path, error);
  Person there;
  if (!school) return {false, error};
  if (!school->find_person(person.code, there)) return {true, say::kHoldsNothing(path)};
  if (!school->erase_person(there.id)) return {false, path + ": " + school->error()};
  return {true, say::kTakenOut(path)};
}

}  // namespace

Cleaned erase_from_file(const ExportedFile& e, const Person& person) {
  if (e.kind == "lrs")
    return {false, say::kStatementsThere(e.file, person.code)};
  if (e.station != station()) return {false, say::kElsewhere(e.file, e.station)};
  std::error_code code;
  if (!std::filesystem::exists(e.file, code)) return {true, say::kFileGone(e.file)};
  if (e.kind == "backup") return clean_backup(e.file, person);
  if (e.whole) {
    std::filesystem::remove(e.file + ".about.json", code);
    if (std::filesystem::remove(e.file, code)) return {true, say::kDeleted(e.file)};
    return {false, say::kNotDeleted(e.file, code.message())};
  }
  std::ifstream in(e.file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::string rest;
  const bool read = e.kind == "xapi" ? without_statements(text, person.code, rest) : (rest = without_lines(text, person.code), true);
  if (!read || !put_file(e.file, rest)) return {false, say::kNotChanged(e.file)};
  return {true, say::kRowsTakenOut(e.file)};
}

bool erase_rows(Database& db, const std::string& person_id) {
  const std::string now = utc_now();
  const Row who = {person_id};
  return db.run("INSERT INTO erased (erased_id, is_person, erased_utc) SELECT a.attempt_id, 0, CAST(? AS TEXT) FROM attempt a"
                " JOIN session s ON s.session_id = a.session_id WHERE s.person_id = ? ON CONFLICT DO NOTHING",
                {now, person_id}) &&
         db.run("INSERT INTO erased (erased_id, is_person, erased_utc) VALUES (?, 1, ?) ON CONFLICT DO NOTHING",
                {person_id, now}) &&
         // the last state and image of this person at a station
         db.run("DELETE FROM station_picture WHERE station_id IN (SELECT station_id FROM station WHERE person_id = ?)", who) &&
         db.run("UPDATE station SET person_id = '', attempt_id = '' WHERE person_id = ?", who) &&
         db.run("DELETE FROM assignment WHERE to_group = 0 AND who_id = ?", who) &&
         // attempts, chunks, metrics, notes, rulings, the name and the list of files are deleted with the person (cascade)
         db.run("DELETE FROM person WHERE person_id = ?", who);
}

void forget_deleted(Database& db) {
  if (db.on_postgres())
    db.run("VACUUM");
  else
    db.rows("PRAGMA wal_checkpoint(TRUNCATE)");
}

}  // namespace swage::record
