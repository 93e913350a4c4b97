// SPDX-License-Identifier: Apache-2.0
#include "run_lesson.hpp"
#include "test_places.hpp"

#include <cmath>
#include <limits>

namespace swage::stage {

LessonRun::LessonRun(const std::string& path, const assembly::Overrides& overrides,
                     const std::function<void(assembly::LessonFile&)>& change, const step::Options& options)
    : options_(options) {
  base::Problems problems;
  assembly::LessonFile file;
  const bool read = assembly::read_lesson_file(path, file, problems);
  if (read && change) change(file);
  if (read) begin(file, overrides, problems);
  for (const base::Problem& p : problems) problems_ += p.where + ": " + p.message + "\n";
}

LessonRun::LessonRun(const std::string& path, const assembly::Overrides& overrides,
                     const std::vector<std::string>& settings) {
  base::Problems problems;
  assembly::LessonFile file;
  std::vector<assembly::Setting> all(settings.size());
  bool understood = true;
  for (size_t i = 0; i < all.size(); ++i)
    understood = understood && assembly::parse_setting(settings[i], all[i]);
  if (!understood) problems_ += "a setting is not object.parameter=value\n";
  if (understood && assembly::read_lesson_file(path, all, file, problems)) begin(file, overrides, problems);
  for (const base::Problem& p : problems) problems_ += p.where + ": " + p.message + "\n";
}

void LessonRun::begin(const assembly::LessonFile& file, const assembly::Overrides& overrides,
                      base::Problems& problems) {
  host::Catalogue::Options options;
  options.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
  options.use_environment = false;
  const host::Catalogue catalogue(options);
  rig_ = assembly::assemble(file, catalogue, overrides, problems);
  if (!rig_) return;
  for (const host::DeviceSlot& slot : rig_->devices) {
    if (slot.device->open != nullptr && slot.device->open(slot.instance->raw) < 0)
      problems_ += "a device did not open\n";
  }
  engine_ = std::make_unique<step::Engine>(*rig_, options_);
}

void LessonRun::step() {
  engine_->point(pointer_);
  engine_->step();
  swinging_.look(rig_->world);
  pointer().dx = pointer().dy = pointer().wheel = 0;
  for (const judge::Event& event : engine_->events()) happened_[rig_->script.events[event.event].id] += 1;
}

void LessonRun::run(double max_s, double after_s) {
  double gone_s = 0;
  while (verdict().outcome == judge::Outcome::kRunning && world().time() < max_s && gone_s < after_s) {
    step();
    if (engine_->hand_gone()) gone_s += world().dt;
  }
}

bool LessonRun::save_and_restore() {
  std::vector<std::byte> image(engine_->image_size());
  return engine_->save(image) && engine_->restore(image);
}

void LessonRun::push(uint32_t body, const toolkit::Vec3& f_W, const toolkit::Vec3& t_W) {
  swage_wrench& F = rig_->world.F_B_W[body];
  F.f = toolkit::raw(toolkit::Vec3(toolkit::vec(F.f) + f_W));
  F.t = toolkit::raw(toolkit::Vec3(toolkit::vec(F.t) + t_W));
}

std::string LessonRun::reason() const {
  return verdict().reason == SWAGE_NONE ? "" : rig_->script.events[verdict().reason].id;
}

double LessonRun::metric(const std::string& id) const {
  for (size_t i = 0; i < rig_->script.metrics.size(); ++i) {
    if (rig_->script.metrics[i].id == id) return verdict().metric[i];
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double LessonRun::signal(const std::string& owner, const std::string& id) const {
  for (size_t i = 0; i < rig_->script.signals.size(); ++i) {
    const judge::Name& name = rig_->script.signals[i];
    if (name.owner == owner && name.id == id) return world().signal[i];
  }
  return std::numeric_limits<double>::quiet_NaN();
}

int LessonRun::happened(const std::string& id) const {
  const auto found = happened_.find(id);
  return found == happened_.end() ? 0 : found->second;
}

std::string LessonRun::cue(const std::string& object) const {
  for (size_t i = 0; i < rig_->objects.size(); ++i) {
    if (rig_->objects[i].instance->name != object) continue;
    const uint32_t cue = verdict().object_cue[i];
    return cue == SWAGE_NONE ? "" : rig_->script.cues[cue].id;
  }
  return "no such object";
}

std::string LessonRun::phase() const {
  return verdict().phase == SWAGE_NONE ? "" : rig_->script.phases[verdict().phase].id;
}

uint32_t LessonRun::body(const std::string& object) const {
  for (const host::ObjectSlot& slot : rig_->objects) {
    if (slot.instance->name == object) return slot.body.first;
  }
  return SWAGE_NONE;
}

}  // namespace swage::stage
