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

#include "record/address.hpp"

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
enum class Trouble {
  kNone,
  kLocked,
  kFull,
  kDamaged,      // or not a database at all
  kReadOnly,     // the rights of this user, or a disk that may only be read
  kUnreachable,  // the server does not answer, or no longer
  kOther
};

/// A database of SQLite's that is gone with its connection.
inline constexpr const char* kInMemory = ":memory:";

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
  /// Empty on failure too: trouble() tells the two apart, and every caller must ask.
  std::vector<Row> rows(std::string_view sql, const Row& values = {});
  /// Row by row for what may be large; `visit` returns false to stop.
  bool each(std::string_view sql, const Row& values, const std::function<bool(const Row&)>& visit);

  bool begin();  // takes the write lock at once, so that a later statement cannot find it taken
  bool commit();
  void rollback();

  /// Calls `heard` when anybody notifies the channel (NOTIFY), from the event loop of this thread, which must have one. It must not
  /// close the connection. A server only.
  bool listen(const std::string& channel, std::function<void()> heard);

  bool on_postgres() const;
  Trouble trouble() const;           // of the last call
  const std::string& error() const;  // the driver's words

 private:
  struct Connection;
  bool connect(Access, std::string& error);
  explicit Database(std::unique_ptr<Connection>);
  std::unique_ptr<Connection> connection_;
};

}  // namespace swage::record
