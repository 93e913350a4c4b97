// SPDX-License-Identifier: Apache-2.0
//
// One JSON object of a lesson file, read key by key, with messages for faults. [main]
#pragma once

#include <swage/abi/base.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/problem.hpp"
#include "base/text.hpp"

namespace swage::assembly {

using Json = nlohmann::ordered_json;

/// Reports problems of one file with their places.
struct Teller {
  std::function<std::string(const std::string& pointer)> where;
  base::Problems& problems;

  /// Reports an error; a very long message is shortened.
  void error(const std::string& pointer, const std::string& message) const {
    problems.push_back({base::Severity::kError, where(pointer), base::shortened(message, 2000)});
  }
  void warn(const std::string& pointer, const std::string& message) const {
    problems.push_back({base::Severity::kWarning, where(pointer), message});
  }
};

std::string short_dump(const Json& json);  // at most 60 characters

class ObjectReader {
 public:
  /// `what` names the object in messages: "an object of a lesson". A value that is not an object is read as an
  /// empty one.
  ObjectReader(const Json& json, std::string pointer, std::string what, const Teller& teller);

  /// The value at a key, or nullptr. The key is then known to finish().
  const Json* find(const std::string& key);
  /// The same, with an error when it is missing.
  const Json* need(const std::string& key);

  std::string text(const std::string& key, bool required);
  /// An optional text that must not be empty.
  std::string filled(const std::string& key);
  /// true or false.
  bool flag(const std::string& key, bool fallback);
  /// One of some words; the first one when the value is none of them.
  std::string choice(const std::string& key, std::span<const char* const> words);
  /// A snake_case name of an instance.
  std::string name(const std::string& key, bool required);
  /// A number in the SI unit or a text with unit, within [min, max].
  double quantity(const std::string& key, const char* unit, double fallback, double min, double max);
  uint64_t whole(const std::string& key, uint64_t fallback);
  swage_vec3 vector(const std::string& key, const char* unit, swage_vec3 fallback);
  swage_pose pose(const std::string& key);

  /// Calls f(value, pointer) for each element; an error when the value is no array, or has more than `most` elements.
  void each(const std::string& key, std::size_t most,
            const std::function<void(const Json&, const std::string&)>& f);

  /// Call after the last key: reports an error for each key that was not read ("x-..." are notes of people).
  void finish();

  std::string at(const std::string& key) const;  // pointer of a key
  const std::string& pointer() const { return pointer_; }

 private:
  bool number(const Json& json, const std::string& pointer, const std::string& label, const char* unit,
              double& out);

  const Json* json_;
  std::string pointer_, what_;
  const Teller& teller_;
  std::vector<std::string> known_;
};

}  // namespace swage::assembly
