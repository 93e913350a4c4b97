// SPDX-License-Identifier: Apache-2.0
//
// Runs the program as a person would, with a home of its own.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

/// `swage` with these arguments, at most two minutes.
Said swage(const std::vector<std::string>& arguments);

/// A home for the program and a folder for the test, removed afterwards.
class Program : public testing::Test {
 protected:
  Program();
  ~Program() override;
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  std::string store() const { return path("attempts.db"); }
  void write(const std::string& name, const std::string& text) const;

 private:
  std::string folder_;
};

/// A file of the source tree.
std::string source(const std::string& path);

}  // namespace swage::tools::test
