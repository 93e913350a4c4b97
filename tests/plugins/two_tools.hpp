// SPDX-License-Identifier: Apache-2.0
//
// A person with one mouse and the keys who leads two tools, Tab between them.
#pragma once

#include <cmath>
#include <numbers>

#include "run_lesson.hpp"

namespace swage::stage {

/// Both tools with one mouse: what each does is led by where its tips are, and Tab goes over.
class TwoTools {
 public:
  explicit TwoTools(LessonRun& attempt) : run_(attempt) {
    run_.pointer().camera = toolkit::raw(toolkit::exp_rotation({0.5 * std::numbers::pi, 0, 0}));
  }
  void tab() {
    keys(uint64_t{1} << 46, 0.05);
    wait(0.05);
  }
  void keys(uint64_t down, double time_s) {
    run_.pointer().keys = down;
    wait(time_s);
    run_.pointer().keys = 0;
  }
  void wait(double time_s) {
    const double until = run_.world().time() + time_s - 0.5e-3;
    while (run_.world().time() < until && run_.outcome() == "running") run_.step();
  }
  /// Leads the tool there by keys, one axis after the other in each step.
  bool lead(const char* tool, const toolkit::Vec3& p_W) {
    const uint32_t body = run_.body(tool);
    for (int i = 0; i < 20000 && run_.outcome() == "running"; ++i) {
      const toolkit::Vec3 way = p_W - toolkit::vec(run_.world().X_WB[body].p);
      if (way.norm() < 40e-6) return true;
      uint64_t down = 0;
      const auto key = [&](double d, char plus, char minus) {
        if (std::abs(d) > 15e-6) down |= uint64_t{1} << ((d > 0 ? plus : minus) - 'a');
      };
      key(way.x(), 'd', 'a');
      key(way.z(), 'w', 's');
      key(way.y(), 'q', 'e');
      run_.pointer().modifiers = way.norm() < 0.8e-3 ? 1 : 0;
      keys(down, 2e-3);
    }
    return false;
  }
  /// Closes until the grip rests.
  void close() {
    run_.pointer().modifiers = 0;
    keys(uint64_t{1} << 40, 2.5);
    wait(0.2);
  }
  void open() { keys(uint64_t{1} << 41, 1); }

 private:
  LessonRun& run_;
};

}  // namespace swage::stage
