// SPDX-License-Identifier: Apache-2.0
//
// Events of a step, in order. Events of the host have an index in the script like all others.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "judge/host_events.hpp"

namespace swage::step {

class Events {
 public:
  // events of one step; normal is 0 to 5. More are dropped and counted
  static constexpr std::size_t kCapacity = 256;

  /// [main]
  explicit Events(judge::Script& script) : first_host_(judge::declare_host_events(script)) {
    list_.reserve(kCapacity);
    late_.reserve(kCapacity);
  }

  /// Begins a step: clears the list; late() has the events that the lesson could not see in the last step. [rt]
  void begin(uint64_t step) noexcept {
    step_ = step;
    list_.clear();
    late_seen_ = late_.size();
  }
  void emit(uint32_t event, double value) noexcept {
    emit_own(event, value);
    if (observed_ && late_.size() < kCapacity) late_.push_back({step_, event, 0, value});
  }
  /// An event of the lesson itself, which is not shown to it again.
  void emit_own(uint32_t event, double value) noexcept {
    if (list_.size() < kCapacity) {
      list_.push_back({step_, event, 0, value});
    } else {
      ++lost_;
    }
  }
  /// Number of events; keep_first() drops those after the first `count`, as the rest of the step is repeated. [rt]
  std::size_t count() const noexcept { return list_.size(); }
  void keep_first(std::size_t count) noexcept { list_.resize(std::min(count, list_.size())); }
  void emit_host(judge::HostEvent event, double value) noexcept { emit(first_host_ + event, value); }

  /// Called as the lesson observes: it sees later events of this step in the next one. [rt]
  void observe() noexcept {
    late_.erase(late_.begin(), late_.begin() + static_cast<std::ptrdiff_t>(late_seen_));
    late_seen_ = 0;
    observed_ = true;
  }
  void end() noexcept { observed_ = false; }

  std::span<const judge::Event> list() const noexcept { return list_; }  // of this step
  std::span<const judge::Event> late() const noexcept {
    return {late_.data(), late_seen_};
  }  // of the last step, not yet seen
  uint64_t lost() const noexcept { return lost_; }
  uint32_t first_host() const noexcept { return first_host_; }
  void clear() noexcept {
    list_.clear();
    late_.clear();
    late_seen_ = 0;
    observed_ = false;
  }

 private:
  const uint32_t first_host_;
  std::vector<judge::Event> list_, late_;
  std::size_t late_seen_ = 0;
  uint64_t step_ = 0, lost_ = 0;
  bool observed_ = false;
};

}  // namespace swage::step
