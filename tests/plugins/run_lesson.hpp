// SPDX-License-Identifier: Apache-2.0
//
// Runs a lesson file with the real host, contacts and dynamics, as fast as it goes. No threads, no clock.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "assembly/assemble.hpp"
#include "step/step.hpp"
#include "swinging.hpp"
#include "toolkit/math.hpp"

namespace swage::stage {

/// A lesson on the bench.
class LessonRun {
 public:
  /// `device`: as on the command line, "" for the first choice.
  LessonRun(const std::string& path, const std::string& device)
      : LessonRun(path, assembly::Overrides{device, ""}) {}
  /// `change`: what is to be different from the file; `options`: levels of contact and of free motion.
  LessonRun(const std::string& path, const assembly::Overrides& overrides,
            const std::function<void(assembly::LessonFile&)>& change = {}, const step::Options& options = {});

  /// `settings`: as after --set, "needle.level=bending".
  LessonRun(const std::string& path, const std::string& device, const std::vector<std::string>& settings)
      : LessonRun(path, assembly::Overrides{device, ""}, settings) {}
  LessonRun(const std::string& path, const assembly::Overrides& overrides,
            const std::vector<std::string>& settings);

  bool ready() const { return engine_ != nullptr; }
  const std::string& problems() const { return problems_; }  // what was wrong, line by line

  /// Until the lesson has its verdict, the hand has come to its end for `after_s`, or `max_s` are over [s, simulated].
  void run(double max_s, double after_s = 0.5);
  /// One step.
  void step();
  /// The whole state as bytes, and back. False where either failed.
  bool save_and_restore();
  /// What the person does with pointer and keys, read in the next step; deltas then start again at zero.
  swage_pointer& pointer() { return pointer_; }
  /// A command for the next step, as the window gives it.
  bool push_command(const step::Command& command) { return engine_->push(command); }

  const judge::Verdict& verdict() const { return engine_->verdict(); }
  std::string outcome() const { return judge::text(verdict().outcome); }
  std::string reason() const;                  // id of an event
  double metric(const std::string& id) const;  // NaN until reported
  double signal(const std::string& owner, const std::string& id) const;
  int happened(const std::string& id) const;  // how often an event was sent so far
  int swings() const { return swinging_.longest(); }  // steps in a row in which the thread went to and fro
  std::string cue(const std::string& object) const;
  std::string phase() const;
  uint32_t body(const std::string& object) const;  // global index of its first body
  const scene::World& world() const { return rig_->world; }
  const step::Engine& engine() const { return *engine_; }
  const host::Rig& rig() const { return *rig_; }
  /// A force [N] through the centre of mass and a torque [N m] on a free body in the next step, both in W.
  void push(uint32_t body, const toolkit::Vec3& f_W, const toolkit::Vec3& t_W);

 private:
  void begin(const assembly::LessonFile& file, const assembly::Overrides& overrides,
             base::Problems& problems);

  std::string problems_;
  step::Options options_;
  std::unique_ptr<host::Rig> rig_;
  std::unique_ptr<step::Engine> engine_;
  std::map<std::string, int> happened_;
  Swinging swinging_;
  swage_pointer pointer_{0, 0, 0, 0, 0, 0, {1, 0, 0, 0}};
};

}  // namespace swage::stage
