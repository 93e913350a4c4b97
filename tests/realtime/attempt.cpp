// SPDX-License-Identifier: Apache-2.0
#include "attempt.hpp"

#include <cmath>
#include <cstdio>

#include "assembly/assemble.hpp"
#include "host/catalogue.hpp"

namespace swage::realtime {

Attempt::Attempt(const std::string& lesson, const std::string& device,
                 const std::vector<std::string>& plugin_dirs, const std::string& store) {
  base::Problems problems;
  assembly::LessonFile file;
  host::Catalogue::Options search;
  search.plugin_dirs = plugin_dirs;
  search.use_environment = false;
  const host::Catalogue catalogue(search);
  if (assembly::read_lesson_file(lesson, file, problems))
    rig_ = assembly::assemble(file, catalogue, {device, ""}, problems);
  if (base::failed(problems))
    for (const base::Problem& p : problems)
      std::fprintf(stderr, "%s: %s\n", p.where.c_str(), p.message.c_str());
  if (!rig_) return;

  std::vector<step::DevicePort*> step_ports;
  std::vector<session::Port*> ports;
  for (host::DeviceSlot& slot : rig_->devices) {
    slot.device->open(slot.instance->raw);
    ports_.push_back(std::make_unique<session::StepPort>(slot, rig_->world.dt, false));
    step_ports.push_back(ports_.back().get());
    ports.push_back(ports_.back().get());
  }
  engine_ = std::make_unique<step::Engine>(*rig_, step::Options(), step_ports);
  if (!store.empty()) {
    record::AttemptInfo info;
    info.lesson_id = rig_->card.lesson_id;
    info.descriptor_text = rig_->descriptor_text;
    info.script = rig_->script;
    info.realtime = true;
    for (const host::DeviceSlot& slot : rig_->devices) info.devices.push_back(slot.instance->name);
    recorder_ = record::Recorder::open(store, info, problems);
  }
  loop_ = std::make_unique<session::Loop>(*rig_, *engine_, ports, recorder_.get(), session::Loop::Settings());
}

Attempt::~Attempt() {
  if (recorder_) {
    record::AttemptEnd end;
    end.outcome = engine_->verdict().outcome;
    end.metric = engine_->verdict().metric;
    recorder_->finish(end);
  }
  if (!rig_) return;
  for (host::DeviceSlot& slot : rig_->devices) slot.device->close(slot.instance->raw);
}

}  // namespace swage::realtime
