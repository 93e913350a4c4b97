// SPDX-License-Identifier: Apache-2.0
#include "assembly/assemble.hpp"

#include <algorithm>

#include "assembly/assembler.hpp"
#include "assembly/sentences.hpp"
#include "assembly/source_map.hpp"
#include "host/library.hpp"
#include "host/version.hpp"
#include "judge/host_events.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::assembly {

using base::Severity;
using host::Instance;
using host::PluginInfo;
using host::Rig;
using scene::kNone;

std::unique_ptr<Rig> assemble(const LessonFile& file, const host::Catalogue& catalogue,
                              const Overrides& overrides, base::Problems& problems) {
  return Assembler(file, catalogue, overrides, problems).run();
}

Assembler::Assembler(const LessonFile& file, const host::Catalogue& catalogue, const Overrides& overrides,
                     base::Problems& problems)
    : file_(file), catalogue_(catalogue), overrides_(overrides), problems_(problems) {}

std::unique_ptr<Rig> Assembler::run() {
  const std::size_t before = problems_.size();
  rig_ = std::make_unique<Rig>();
  rig_->world.dt = 1 / file_.rate_hz;
  rig_->world.length = file_.scene_length;
  rig_->world.gravity = file_.gravity;
  rig_->world.environment = file_.environment;
  rig_->seed = file_.seed;
  rig_->mirror = file_.mirror;
  rig_->card.tips_only = file_.tips_only;
  rig_->card.view = file_.view;
  rig_->card.medium = file_.environment.medium;
  rig_->card.viscosity = file_.environment.viscosity;
  rig_->max_time_s = file_.max_time_s;
  rig_->pull = file_.pull;
  rig_->descriptor_text = file_.text;
  rig_->descriptor_path = file_.path;

  rig_->attempt.eyes = overrides_.eyes;
  resolve_mode();
  add_objects();
  add_couplings();
  resolve_override();
  add_devices();
  settle_mode();
  bind_follows();
  find_pairs();
  sort_pairs();
  bind_couplings();
  judge::declare_host_events(rig_->script);
  add_lesson();
  if (!file_.faulty) check_requirements();
  const auto good = [&] {
    return std::none_of(problems_.begin() + static_cast<long>(before), problems_.end(),
                        [](const base::Problem& p) { return p.severity == Severity::kError; });
  };
  // an incomplete scene would only cause further errors from the lesson
  if (file_.faulty || !good()) return nullptr;
  bind_lesson();
  bind_sights();
  if (rig_->pull.load > 0) rig_->first_pull_metric = judge::declare_pull_metrics(rig_->script);
  fill_card();
  if (!good() || !host::activate(*rig_, problems_)) return nullptr;
  return std::move(rig_);
}

void Assembler::resolve_mode() {
  const std::string said = overrides_.mode.empty() ? file_.mode : overrides_.mode;
  const std::string mode = said.empty() ? "test" : said;
  const bool known = std::find(std::begin(kModes), std::end(kModes), mode) != std::end(kModes);
  if (!known && mode != kHandMode)
    error("", say::kNoMode(mode));
  rig_->card.mode = mode;
  rig_->card.cues = said == "test" ? 0 : file_.cues;
  hand_ = mode == "demo" && overrides_.device.empty() ? "expert" : overrides_.device;
}

// An attempt with scripted hands only belongs to no person, and is judged as a test.
void Assembler::settle_mode() {
  std::string& mode = rig_->card.mode;
  const bool scripted = std::all_of(rig_->devices.begin(), rig_->devices.end(), [](const host::DeviceSlot& slot) {
    return slot.device != nullptr && (slot.device->flags & SWAGE_DEVICE_SCRIPTED) != 0;
  });
  if (scripted && !rig_->devices.empty() && mode != "demo") mode = kHandMode;
  rig_->attempt.mode = mode == "practice" ? SWAGE_ATTEMPT_PRACTICE
                       : mode == "demo"   ? SWAGE_ATTEMPT_DEMO
                                          : SWAGE_ATTEMPT_TEST;
}

void Assembler::error(const std::string& pointer, const std::string& message) {
  note(Severity::kError, pointer, message);
}

void Assembler::note(Severity severity, const std::string& pointer, const std::string& message) {
  problems_.push_back({severity, file_.where(pointer), message});
}

void Assembler::take_reports(Instance& instance, const std::string& pointer) {
  for (base::Problem& p : instance.services->take_reports()) {
    // the plugin reports by its instance name; the reader of the file needs the place in the file
    if (p.where == instance.name) p.where = file_.where(pointer);
    problems_.push_back(std::move(p));
  }
}

const PluginInfo* Assembler::usable(const PluginUse& use, int32_t kind) {
  if (use.plugin.empty()) return nullptr;  // reported by the reader
  used_.insert(use.plugin);
  const std::string pointer = use.pointer + "/plugin";
  const PluginInfo* plugin = catalogue_.find(use.plugin);
  if (plugin == nullptr) {
    error(pointer, catalogue_.missing_text(use.plugin));
    return nullptr;
  }
  if (plugin->kind != kind) {
    error(pointer, say::kOtherKind(plugin->id, host::kind_text(plugin->kind), host::kind_text(kind)));
    return nullptr;
  }
  for (const auto& [id, range] : file_.requirements) {
    bool valid = false;
    if (id != plugin->id || host::in_range(plugin->version, range, valid)) continue;
    error("/requires/" + pointer_step(id),
          say::kOtherVersion(id, plugin->version, range));
    return nullptr;
  }
  return plugin;
}

void Assembler::check_requirements() {
  std::set<std::string> required;
  for (const auto& [id, range] : file_.requirements) {
    required.insert(id);
    if (!used_.contains(id))
      note(Severity::kWarning, "/requires/" + pointer_step(id),
           say::kUnused(id));
  }
  for (const std::string& id : used_) {
    const PluginInfo* plugin = catalogue_.find(id);
    if (plugin == nullptr || required.contains(id)) continue;
    const std::string& v = plugin->version;
    note(Severity::kWarning, "/requires",
         say::kNotRequired(id, id, v.substr(0, v.rfind('.'))));
  }
}

void Assembler::keep_files(const std::vector<host::GivenFile>& files) {
  for (const host::GivenFile& given : files) {
    const bool known = std::any_of(rig_->files.begin(), rig_->files.end(),
                                   [&](const host::GivenFile& f) { return f.written == given.written; });
    if (!known) rig_->files.push_back(given);
  }
}

uint32_t Assembler::add_random(int32_t kind) {
  if (kind == SWAGE_KIND_DEVICE) return kNone;
  rig_->world.random.push_back(0);
  return static_cast<uint32_t>(rig_->world.random.size() - 1);
}

std::unique_ptr<Instance> Assembler::make(const PluginUse& use, int32_t kind, const std::string& name,
                                          uint32_t object, const swage_pose& X_WO,
                                          const std::string& where_params,
                                          std::unique_ptr<host::Builder>& builder) {
  const PluginInfo* plugin = usable(use, kind);
  if (plugin == nullptr) return nullptr;
  const auto where = [this, &use, where_params](const std::string& below) {
    return where_params.empty() ? file_.where(use.pointer + "/params" + below) : where_params + " #" + below;
  };

  // values first: a plugin never gets an invalid one
  host::ParamValues values;
  host::ParamSource source{plugin->id, file_.folder(), plugin->bundle_dir, where, &overrides_.files};
  const bool good = host::check_params(use.params, plugin->params, source, values, problems_);
  keep_files(values.files);
  std::string sentence;
  const host::Library* library = catalogue_.load(*plugin, sentence);
  if (library == nullptr) error(use.pointer + "/plugin", sentence);
  if (!good || library == nullptr) return nullptr;

  auto instance =
      Instance::create(*plugin, *library, name, rig_->shared, add_random(kind), file_.seed, sentence);
  if (!instance) {
    error(use.pointer + "/plugin", sentence);
    return nullptr;
  }
  host::Builder::Owner owner{kind, name, object, X_WO, [this, &use, where](const std::string& id) {
                               return id.empty() ? file_.where(use.pointer) : where("/" + pointer_step(id));
                             }};
  builder = std::make_unique<host::Builder>(std::move(owner), rig_->world, rig_->script, problems_);
  const std::size_t before = problems_.size();
  const bool configured = instance->configure(std::move(values), *builder, sentence);
  take_reports(*instance, use.pointer);
  if (configured) return instance;
  if (!sentence.empty()) error(use.pointer, sentence);
  if (problems_.size() == before)
    error(use.pointer, say::kRefusedParams(plugin->id));
  return nullptr;
}

void Assembler::add_objects() {
  if (file_.objects.size() > snapshot::kMaxObjects)
    return error("/objects", say::kManyObjects(snapshot::kMaxObjects, file_.objects.size()));
  for (const LessonObject& use : file_.objects) {
    // a slot for each, so that indices agree with those of the file
    host::ObjectSlot& slot = rig_->objects.emplace_back();
    slot.X_WO = use.X_WO;
    const auto index = static_cast<uint32_t>(rig_->objects.size() - 1);
    std::unique_ptr<host::Builder> builder;
    slot.instance = make(use, SWAGE_KIND_OBJECT, use.name, index, use.X_WO, "", builder);
    if (!slot.instance) continue;
    slot.body = builder->body;
    slot.particle = builder->particle;
    slot.shape = builder->shape;
    slot.hinge = builder->hinge;
    slot.state = builder->state;
    slot.signal = builder->signal;
    slot.object = table<swage_object>(*slot.instance, SWAGE_EXT_OBJECT, use);
    slot.solver_2 = table<swage_solver_2>(*slot.instance, SWAGE_EXT_SOLVER_2, use, false);
    if (slot.solver_2 == nullptr)
      slot.solver = table<swage_solver>(*slot.instance, SWAGE_EXT_SOLVER, use, false);
    slot.surface = table<swage_surface>(*slot.instance, SWAGE_EXT_SURFACE, use, false);
    slot.visuals = table<swage_visuals>(*slot.instance, SWAGE_EXT_VISUAL, use, false);
    bool moves_itself = false;
    for (uint32_t i = 0; i < slot.body.count; ++i) {
      const scene::BodyInfo& body = rig_->world.body[slot.body.first + i];
      if (body.motion != SWAGE_MOTION_FLEXIBLE) continue;
      moves_itself = true;
      if (!slot.moves_itself())
        error(use.pointer, say::kNoSolver(body.name, slot.instance->plugin_id, SWAGE_EXT_SOLVER, SWAGE_EXT_SOLVER_2));
    }
    // at some levels of a plugin its object is not flexible
    if (!moves_itself) slot.solver = nullptr, slot.solver_2 = nullptr;
  }
}

void Assembler::add_couplings() {
  const auto index_of = [this](const std::string& name) {
    for (uint32_t i = 0; i < file_.objects.size(); ++i)
      if (file_.objects[i].name == name) return i;
    return kNone;
  };
  for (const LessonCoupling& use : file_.couplings) {
    host::CouplingSlot& slot = rig_->couplings.emplace_back();
    slot.object_a = index_of(use.a);
    slot.object_b = index_of(use.b);
    std::unique_ptr<host::Builder> builder;
    slot.instance = make(use, SWAGE_KIND_COUPLING, use.name, kNone, {}, "", builder);
    if (!slot.instance) continue;
    slot.state = builder->state;
    slot.signal = builder->signal;
    slot.event = builder->event;
    slot.coupling = table<swage_coupling>(*slot.instance, SWAGE_EXT_COUPLING, use);
    slot.ties = table<swage_ties>(*slot.instance, SWAGE_EXT_TIES, use, false);
    slot.visuals = table<swage_visuals>(*slot.instance, SWAGE_EXT_VISUAL, use, false);
  }
}

void Assembler::add_lesson() {
  host::LessonSlot& slot = rig_->lesson;
  std::unique_ptr<host::Builder> builder;
  slot.instance = make(file_.lesson, SWAGE_KIND_LESSON, "lesson", kNone, {}, "", builder);
  if (!slot.instance) return;
  slot.state = builder->state;
  slot.metric = builder->metric;
  slot.cue = builder->cue;
  slot.event = builder->event;
  slot.phase = builder->phase;
  slot.lesson = table<swage_lesson>(*slot.instance, SWAGE_EXT_LESSON, file_.lesson);
}

}  // namespace swage::assembly
