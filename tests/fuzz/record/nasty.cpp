// SPDX-License-Identifier: Apache-2.0
#include "nasty.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "record/codec.hpp"
#include "record/sql.hpp"

namespace swage::record::test {
namespace {

std::string slurp(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void spill(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

template <class T>
const T& one_of(const std::vector<T>& list, base::Xoshiro256& random) {
  return list[random() % list.size()];
}

// a chunk of zeros: some bytes that are many
Packed bomb(std::size_t rows, std::size_t columns) {
  const std::vector<uint64_t> zeros(rows * columns, 0);
  return pack(zeros.data(), rows, columns);
}

Value nasty_value(base::Xoshiro256& random) {
  static const std::vector<std::string> texts = {
      "",
      "\x1b[2J\x1b]0;title\x07",
      "/etc/passwd",
      "../../../../tmp/x",
      std::string(100'000, 'x'),
      std::string(3'000'000, '['),
      "'; DROP TABLE attempt; --",
      "{\"signals\": [], \"metrics\": 4}",
      "[\"a\",\"b\",\"c\",\"d\",\"e\",\"f\",\"g\",\"h\"]",
      "\xff\xfe\x80",
      std::string("zero\0inside", 11),
      "complete",
      "running",
      "hash",
      "00000000-0000-7000-8000-000000000000",
  };
  static const std::vector<int64_t> numbers = {0,          -1,         1,          2,        4096,      65536,
                                               4294967296, 2147483647, -2147483648, INT64_MAX, INT64_MIN};
  static const std::vector<double> reals = {0.0, -1e308, 1e308, 1e-320, 0.1, 1e18};
  switch (random() % 6) {
    case 0:
      return one_of(numbers, random);
    case 1:
      return one_of(reals, random);
    case 2:
      return std::monostate{};
    case 3:
      return bomb(std::size_t{1} << (random() % 13), 2 * 18).data;
    default:
      return one_of(texts, random);
  }
}

}  // namespace

std::string damage_file(const std::string& path, base::Xoshiro256& random) {
  std::string bytes = slurp(path);
  if (bytes.empty()) return "was empty";
  std::string done;
  const uint64_t strokes = 1 + random() % 4;
  for (uint64_t stroke = 0; stroke < strokes && !bytes.empty(); ++stroke) {
    // a third of the strokes go for the first page, where the header and the list of tables are
    const std::size_t reach = random() % 3 == 0 ? std::min<std::size_t>(bytes.size(), 4096) : bytes.size();
    const std::size_t at = random() % reach, size = std::min<std::size_t>(bytes.size() - at, 1 + random() % 5000);
    const std::size_t page = at / 4096 * 4096, whole = std::min<std::size_t>(4096, bytes.size() - page);
    switch (random() % 8) {
      case 0:
        for (int i = 0; i < 20; ++i) bytes[random() % reach] ^= static_cast<char>(1u << random() % 8);
        done += " flips";
        break;
      case 1:
        bytes[at] = static_cast<char>(random());
        done += " byte at " + std::to_string(at);
        break;
      case 2:
        bytes.replace(at, size, std::string(size, '\0'));
        done += " zeros at " + std::to_string(at);
        break;
      case 3:
        for (std::size_t i = 0; i < size; ++i) bytes[at + i] = static_cast<char>(random());
        done += " noise at " + std::to_string(at);
        break;
      case 4:
        bytes.resize(at);
        done += " cut at " + std::to_string(at);
        break;
      case 5:
        bytes.replace(page, whole, std::string(whole, '\0'));
        done += " page zeroed at " + std::to_string(page);
        break;
      case 6: {
        const std::size_t other = random() % (bytes.size() / 4096 + 1) * 4096;
        if (other + whole <= bytes.size()) {
          const std::string kept = bytes.substr(page, whole);
          bytes.replace(page, whole, bytes.substr(other, whole));
          bytes.replace(other, whole, kept);
        }
        done += " pages exchanged";
        break;
      }
      default:
        bytes.insert(page, bytes.substr(page, whole));
        done += " page doubled at " + std::to_string(page);
    }
  }
  spill(path, bytes);
  return done;
}

std::string craft_rows(const std::string& path, base::Xoshiro256& random) {
  static const std::vector<std::string> tables = {"attempt", "chunk", "chunk", "chunk", "hand", "file",
                                                  "event",   "metric", "person", "session", "device"};
  std::string error, done;
  const auto db = Database::open(path, Access::kWrite, error);
  if (!db) return error;
  db->run("PRAGMA foreign_keys = OFF");
  db->run("PRAGMA ignore_check_constraints = ON");
  for (uint64_t stroke = 1 + random() % 4; stroke > 0; --stroke) {
    const std::string& table = one_of(tables, random);
    const std::vector<Row> columns = db->rows("SELECT name FROM pragma_table_info('" + table + "')");
    const std::string column = text(one_of(columns, random)[0]);
    // the keys that hold the rows together are left alone, or nothing of the attempt would be found
    if (column.ends_with("_id") || column == "pseudonym") continue;
    const bool one_row = random() % 2 == 0;
    const std::string sql = "UPDATE " + table + " SET " + column + " = ?" +
                            (one_row ? " WHERE rowid = (SELECT MIN(rowid) FROM " + table + ")" : "");
    db->run(sql, {nasty_value(random)});
    done += sql + "; ";
  }
  if (random() % 8 == 0) {
    const Packed zeros = bomb(4096, 36);
    db->run("DELETE FROM chunk");
    db->begin();
    for (int64_t i = 0; i < 300; ++i)
      db->run("INSERT INTO chunk SELECT attempt_id, 'input', ?, 0, 4096, ?, ?, ?, NULL FROM attempt",
              {i, static_cast<int64_t>(zeros.codec), int64_t{zeros.crc}, zeros.data});
    db->commit();
    done += "bombs";
  }
  return done;
}

std::string craft_tables(const std::string& path, base::Xoshiro256& random) {
  static const std::vector<std::string> tables = {"attempt", "chunk", "hand", "file", "event",
                                                  "metric",  "person", "session", "device", "swage_schema"};
  const std::string& table = one_of(tables, random);
  const std::string endless = " AS WITH RECURSIVE n(i) AS (VALUES(1) UNION ALL SELECT i + 1 FROM n) SELECT hidden.* FROM n, hidden";
  const std::vector<std::vector<std::string>> crafts = {
      {"ALTER TABLE " + table + " RENAME TO hidden", "CREATE VIEW " + table + endless},
      {"DROP TABLE " + table},
      {"ALTER TABLE " + table + " ADD COLUMN more TEXT"},
      {"CREATE TRIGGER t AFTER INSERT ON person BEGIN DELETE FROM attempt; END"},
      {"CREATE INDEX slow ON " + table + " (hex(zeroblob(50000000)))"},
      {"CREATE VIEW more AS WITH RECURSIVE n(i) AS (VALUES(1) UNION ALL SELECT i + 1 FROM n) SELECT i FROM n"},
      {"UPDATE swage_schema SET version = version + 1000"},
      {"DELETE FROM swage_schema"},
      {"PRAGMA user_version = 77", "PRAGMA application_id = 77"},
  };
  std::string error, done;
  const auto db = Database::open(path, Access::kWrite, error);
  if (!db) return error;
  db->run("PRAGMA foreign_keys = OFF");
  db->run("PRAGMA legacy_alter_table = ON");
  for (const std::string& sql : one_of(crafts, random)) {
    db->run(sql);
    done += sql + "; ";
  }
  return done;
}

}  // namespace swage::record::test
