// SPDX-License-Identifier: Apache-2.0
//
// The lesson observes the step; plugins that came into quarantine are reported.
#pragma once

#include <swage/abi/sight.h>

#include <cstdint>
#include <vector>

#include "host/rig.hpp"
#include "judge/referee.hpp"
#include "scene/state_image.hpp"
#include "step/events.hpp"
#include "step/objects.hpp"

namespace swage::step {

class Judging {
 public:
  /// [main]
  Judging(host::Rig& rig, const Objects& objects, Events& events, WriteGuard& writes);

  void reset() noexcept;              // [rt]
  void observe() noexcept;            // [rt]
  void notice_quarantine() noexcept;  // [rt] reports instances that are newly in quarantine

  swage_sight sight() noexcept;  // [rt] the present scene, for devices that take it; valid until the next call

  const judge::Verdict& verdict() const noexcept { return referee_.verdict(); }
  std::size_t image_size() const;                // [main]
  void save(scene::Writer& out) const noexcept;  // [main or rt] the verdict so far
  bool restore(scene::Reader& in) noexcept;
  /// True when a plugin is in quarantine: the attempt is void.
  bool is_void() const noexcept { return bad_count_ > 0; }
  uint32_t quarantined() const noexcept { return bad_count_; }

 private:
  void ask_lesson() noexcept;
  void refresh_view() noexcept;

  host::Rig& rig_;
  const Objects& objects_;
  Events& events_;
  WriteGuard& writes_;
  judge::Referee referee_;
  std::vector<swage_view_event> seen_;
  swage_view view_{};
  std::vector<host::Instance*> instance_;  // in the order of evaluation
  std::vector<uint8_t> known_bad_;
  uint32_t bad_count_ = 0;
};

}  // namespace swage::step
