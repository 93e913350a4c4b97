// SPDX-License-Identifier: Apache-2.0
#include "session/playback.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "assembly/assemble.hpp"
#include "base/scratch_folder.hpp"
#include "host/catalogue.hpp"
#include "session/sentences.hpp"
#include "session/session.hpp"

namespace swage::session {

namespace {

// steps between two stored states: rewinding repeats at most this number of steps, about 20 ms; a quarter of an hour stores
// 1800 states of a few kilobytes
constexpr uint64_t kKeep = 500;

namespace fs = std::filesystem;

// attempts of format 1 lack the flags for reading their samples: their devices are created
assembly::Overrides overrides(const record::AttemptInfo& info, const std::map<std::string, std::string>& files) {
  assembly::Overrides out;
  out.files = files;
  out.mode = info.mode;
  out.eyes = eyes_of(info.display);
  for (const record::HandInfo& hand : info.hands)
    out.recorded.push_back({hand.plugin, hand.version, hand.flags});
  if (info.hands.empty()) out.device = info.device;
  return out;
}

// other versions may give other bits: a warning, no refusal
void tell_other_versions(const host::Rig& rig, const record::AttemptInfo& info, base::Problems& problems) {
  const std::vector<host::Instance*> all = host::instances(rig);
  for (std::size_t i = 0; i < std::min(all.size(), info.plugins.size()); ++i) {
    const auto& [id, version] = info.plugins[i];
    if (all[i]->plugin_id == id && all[i]->plugin_version == version) continue;
    problems.push_back({base::Severity::kWarning, all[i]->name,
                        say::kRecordedWith(id, version, all[i]->plugin_id, all[i]->plugin_version)});
  }
}

}  // namespace

// the files of a recording, in a temporary folder with the lifetime of this object
class Playback::Unpacked {
 public:
  explicit Unpacked(const std::vector<record::FileInfo>& files) {
    if (files.empty()) return;
    folder_.emplace("replay");
    if (folder_->path().empty()) return;
    for (const record::FileInfo& file : files) {
      // a number in front: two folders may hold files of the same name. The rest is for people
      const std::string name = std::to_string(path_.size()) + "_" + fs::path(file.name).filename().string();
      const fs::path path = folder_->path() / name;
      std::ofstream(path, std::ios::binary) << file.bytes;
      path_[file.name] = path.string();
    }
  }
  const std::map<std::string, std::string>& paths() const { return path_; }

 private:
  std::optional<base::ScratchFolder> folder_;  // none without files
  std::map<std::string, std::string> path_;
};

// gives the recorded sample of each step, for any request
class Playback::Port final : public step::DevicePort {
 public:
  void read(uint64_t, double, swage_sample& sample) noexcept override { sample = sample_; }
  void send(const step::ToolForce&) noexcept override {}
  void set(const swage_sample& sample) { sample_ = sample; }

 private:
  swage_sample sample_{};
};

Playback::Playback(const record::Recording& recording, std::vector<std::string> plugin_dirs)
    : recording_(recording), plugin_dirs_(std::move(plugin_dirs)), files_(std::make_unique<Unpacked>(recording.info.files)) {
  while (count_ < recording.step.size() && recording.step[count_] == count_) ++count_;
  first_difference_ = count_;
}

Playback::~Playback() = default;

std::unique_ptr<Playback> Playback::open(const record::Recording& recording,
                                         const std::vector<std::string>& plugin_dirs,
                                         base::Problems& problems) {
  std::unique_ptr<Playback> playback(new Playback(recording, plugin_dirs));
  return playback->build(problems) ? std::move(playback) : nullptr;
}

bool Playback::build(base::Problems& problems) {
  using base::Severity;
  engine_.reset();
  const record::AttemptInfo& info = recording_.info;
  assembly::LessonFile file;
  if (!assembly::parse_lesson(info.descriptor_text, info.descriptor_path, file, problems)) return false;
  host::Catalogue::Options search;
  search.plugin_dirs = plugin_dirs_;
  const host::Catalogue catalogue(search);
  rig_ = assembly::assemble(file, catalogue, overrides(info, files_->paths()), problems);
  if (!rig_) return false;
  tell_other_versions(*rig_, info, problems);
  if (rig_->devices.size() != info.devices.size()) {
    problems.push_back({Severity::kError, info.descriptor_path,
                        "The recording has " + std::to_string(info.devices.size()) + " devices, its lesson " +
                            std::to_string(rig_->devices.size()) + "."});
    return false;
  }
  ports_.clear();
  std::vector<step::DevicePort*> ports;
  for (std::size_t d = 0; d < rig_->devices.size(); ++d)
    ports.push_back(ports_.emplace_back(std::make_unique<Port>()).get());
  try {
    engine_ = std::make_unique<step::Engine>(*rig_, step::Options(), ports);
  } catch (const std::exception& e) {
    problems.push_back({Severity::kError, info.descriptor_path, e.what()});
    return false;
  }
  at_ = 0;
  command_ = 0;
  return true;
}

// the commands of one step, in order
void Playback::push_commands() {
  for (; command_ < recording_.commands.size() && recording_.commands[command_].step <= at_; ++command_) {
    const record::CommandRecord& from = recording_.commands[command_];
    step::Command command;
    command.kind = static_cast<step::CommandKind>(from.kind);
    command.object = from.object;
    command.parameter = from.parameter;
    std::copy(std::begin(from.number), std::end(from.number), std::begin(command.number));
    engine_->push(command);
  }
}

bool Playback::step() {
  if (at_ >= count_) return false;
  for (std::size_t d = 0; d < ports_.size(); ++d) ports_[d]->set(recording_.sample[ports_.size() * at_ + d]);
  push_commands();
  engine_->step();
  if (engine_->hash() != recording_.hash[at_]) first_difference_ = std::min(first_difference_, at_);
  ++at_;
  return true;
}

// live parameters are not part of the state: a stored state is valid only if none has changed since
bool Playback::live_change_between(uint64_t from, uint64_t to) const {
  return std::any_of(recording_.commands.begin(), recording_.commands.end(),
                     [&](const record::CommandRecord& c) {
                       return static_cast<step::CommandKind>(c.kind) == step::CommandKind::kLiveParameter &&
                              c.step >= from && c.step < to;
                     });
}

void Playback::back_to(uint64_t target) {
  const auto after = std::upper_bound(kept_.begin(), kept_.end(), target,
                                      [](uint64_t t, const Kept& k) { return t < k.at; });
  const Kept* kept = after == kept_.begin() ? nullptr : &*(after - 1);
  if (!kept || live_change_between(kept->at, at_) || !engine_->restore(kept->image)) {
    base::Problems quiet;  // the rig was built before without problems
    build(quiet);
    return;
  }
  at_ = kept->at;
  command_ = 0;
  while (command_ < recording_.commands.size() && recording_.commands[command_].step < at_) ++command_;
}

bool Playback::toward(uint64_t target, uint64_t most) {
  target = std::min(target, count_);
  if (target < at_) back_to(target);
  for (uint64_t n = 0; n < most && at_ < target; ++n) {
    if (at_ % kKeep == 0 && (kept_.empty() || kept_.back().at < at_)) {
      kept_.push_back({at_, std::vector<std::byte>(engine_->image_size())});
      if (!engine_->save(kept_.back().image)) kept_.pop_back();
    }
    step();
  }
  return at_ == target;
}

}  // namespace swage::session
