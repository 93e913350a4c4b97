// SPDX-License-Identifier: Apache-2.0
//
// Runs the program as a person would, with a home of its own.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/types.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace swage::tools::test {

struct Said {
  int code = -1;
  std::string out, err;
  /// The answer as JSON; a failure of the test when it is none.
  nlohmann::json json() const;
};

/// `swage` with these arguments; `program`: another copy of it, "" for the one that was built.
Said swage(const std::vector<std::string>& arguments, const std::string& program = "");

/// `swage` with these arguments, while it runs; what it says goes to two files in `folder`. Killed if nobody waits for its end.
class Running {
 public:
  Running(const std::vector<std::string>& arguments, const std::string& folder);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  bool alive();
  void signal(int number);  // to this process alone, once
  Said end();               // waits

 private:
  const std::string out_, err_;
  pid_t pid_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

/// A home for the program and a folder for the test, removed afterwards.
class Program : public testing::Test {
 protected:
  Program();
  ~Program() override;
  const std::string& folder() const { return folder_; }
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  std::string store() const { return path("attempts.db"); }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// drop.json: a lesson of 10 ms, in which a ball falls and the mouse is "hand".
  void write_drop_lesson() const;
  /// `swage validate` by one test, of a bad object in tests/bad_plugins/bundles_solvers in a scene of its own, with the value of its parameter
  /// `fault`.
  Said validate_fault(const std::string& id, const std::string& test, int fault) const;
  /// two.json: a lesson of two solids, "ring" at the origin and "hook" at x ("0.4 mm": inside the ring). Returns its path.
  std::string write_two_solids(const std::string& x) const;

 private:
  std::string folder_;
};

/// A file of the source tree.
std::string source(const std::string& path);

}  // namespace swage::tools::test
