// SPDX-License-Identifier: Apache-2.0
//
// A PostgreSQL server of the test's own, from Debian's package, on a socket in a folder of its own. Root starts it as "postgres",
// because PostgreSQL refuses to run as root.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace swage::record::test {

class PostgresServer {
 public:
  PostgresServer();
  ~PostgresServer();
  PostgresServer(const PostgresServer&) = delete;
  PostgresServer& operator=(const PostgresServer&) = delete;

  bool running() const { return why_not_.empty(); }
  const std::string& why_not() const { return why_not_; }
  /// A new, empty database; its address.
  std::string make_database(const std::string& name);
  std::string address(const std::string& database, const std::string& password = "") const;
  /// Stops every process of the server as if its machine had frozen, or lets them go on.
  void freeze(bool on);
  /// kill -9 of every process of it.
  void crash();
  /// Starts it again. False: it does not answer.
  bool start();
  std::string folder() const { return folder_; }

 private:
  bool command(const std::vector<std::string>& words, const std::string& input = "") const;
  std::string bin_, folder_, why_not_;
  pid_t pid_ = -1;
};

}  // namespace swage::record::test
