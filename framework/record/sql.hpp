// SPDX-License-Identifier: Apache-2.0
//
// One connection to SQLite or PostgreSQL, without a word of Qt in the header. Statements use `?` for values
// and run on both. Threads: a Database belongs to the thread that opened it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace swage::record {

using Blob = std::vector<uint8_t>;
using Value = std::variant<std::monostate, int64_t, double, std::string, Blob>;  // monostate: NULL
using Row = std::vector<Value>;

// What a value says, or the neutral thing when it is of another kind: a damaged file must not end the
// program.
int64_t integer(const Value&);
double real(const Value&);  // NULL is NaN, because SQLite keeps NaN as NULL
std::string text(const Value&);
const Blob& blob(const Value&);

enum class Access { kRead, kWrite };

/// Why the last call failed, as far as it decides what to do next.
enum class Trouble { kNone, kLocked, kFull, kDamaged, kOther };

bool is_postgres(std::string_view where);

class Database {
 public:
  /// SQLite: write access makes the file (0600) and missing folders (0700). nullptr with a sentence in
  /// `error`.
  static std::unique_ptr<Database> open(const std::string& where, Access, std::string& error,
                                        Trouble* why = nullptr);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  bool run(std::string_view sql, const Row& values = {});
  std::vector<Row> rows(std::string_view sql, const Row& values = {});  // empty on failure too: see trouble()
  /// Row by row for what may be large; `visit` returns false to stop.
  bool each(std::string_view sql, const Row& values, const std::function<bool(const Row&)>& visit);

  bool begin();  // takes the write lock at once, so that a later statement cannot find it taken
  bool commit();
  void rollback();

  bool on_postgres() const;
  Trouble trouble() const;           // of the last call
  const std::string& error() const;  // the driver's words

 private:
  struct Connection;
  explicit Database(std::unique_ptr<Connection>);
  std::unique_ptr<Connection> connection_;
};

}  // namespace swage::record
