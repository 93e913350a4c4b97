// SPDX-License-Identifier: Apache-2.0
//
// One connection to SQLite or PostgreSQL, with no Qt type in the header. Statements use `?` for values
// and run on both. Threads: a Database belongs to the thread that opened it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "record/address.hpp"

namespace swage::record {

using Blob = std::vector<uint8_t>;
using Value = std::variant<std::monostate, int64_t, double, std::string, Blob>;  // monostate: NULL
using Row = std::vector<Value>;

// Conversions of a value, with a neutral result for another type: a damaged file must not end the
// program.
int64_t integer(const Value&);
double real(const Value&);  // NULL gives NaN, because SQLite stores NaN as NULL
std::string text(const Value&);
const Blob& blob(const Value&);

enum class Access { kRead, kWrite };

/// Cause of the last failure, as far as it determines the reaction.
enum class Trouble {
  kNone,
  kLocked,
  kFull,
  kDamaged,      // or not a database at all
  kReadOnly,     // the rights of this user, or a read-only disk
  kUnreachable,  // the server does not respond, or no longer
  kOther
};

/// An SQLite database in memory, which ends with its connection.
inline constexpr const char* kInMemory = ":memory:";

class Database {
 public:
  /// SQLite: write access creates the file (0600) and missing folders (0700). nullptr with a sentence in
  /// `error`.
  static std::unique_ptr<Database> open(const std::string& where, Access, std::string& error,
                                        Trouble* why = nullptr);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  bool run(std::string_view sql, const Row& values = {});
  /// Empty on failure too: every caller must check trouble() to tell the two apart.
  std::vector<Row> rows(std::string_view sql, const Row& values = {});
  /// Visits a large result row by row; `visit` returns false to stop.
  bool each(std::string_view sql, const Row& values, const std::function<bool(const Row&)>& visit);

  bool begin();  // takes the write lock at once, so that a later statement cannot fail for the lock
  bool commit();
  void rollback();

  /// Calls `heard` when the channel is notified (NOTIFY), from the event loop of this thread, which must have one. `heard` must not
  /// close the connection. PostgreSQL only.
  bool listen(const std::string& channel, std::function<void()> heard);

  bool on_postgres() const;
  Trouble trouble() const;           // of the last call
  const std::string& error() const;  // the driver's message

 private:
  struct Connection;
  bool connect(Access, std::string& error);
  explicit Database(std::unique_ptr<Connection>);
  std::unique_ptr<Connection> connection_;
};

}  // namespace swage::record
