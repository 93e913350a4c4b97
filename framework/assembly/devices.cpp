// SPDX-License-Identifier: Apache-2.0
//
// The device of each hand, and the objects that follow it.
#include <algorithm>

#include "assembly/assembler.hpp"
#include "assembly/sentences.hpp"
#include "host/nearest.hpp"
#include "host/stand_in.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::assembly {

using base::Severity;
using host::PluginInfo;
using scene::kNone;

namespace {

bool matches(const DeviceChoice& choice, const std::string& wanted) {
  return choice.as == wanted || choice.plugin == wanted || last_word(choice.plugin) == wanted;
}

}  // namespace

void Assembler::resolve_override() {
  const std::string& wanted = hand_;
  if (wanted.empty() || !overrides_.recorded.empty()) return;
  if (file_.devices.empty()) {
    if (!file_.faulty)
      note(Severity::kNote, "", say::kNoDevices(wanted));
    return;
  }
  // one of the file's own choices
  std::vector<std::string> names;
  for (std::size_t i = 0; i < file_.devices.size(); ++i) {
    for (const DeviceChoice& choice : file_.devices[i].choices) {
      names.push_back(choice.as.empty() ? last_word(choice.plugin) : choice.as);
      if (substitute_for_ != ~std::size_t{0} || !matches(choice, wanted)) continue;
      substitute_ = choice;
      substitute_for_ = i;
    }
  }
  if (substitute_for_ != ~std::size_t{0}) {
    if (!overrides_.device_params.empty()) substitute_.params = overrides_.device_params;
    return;
  }
  // else any installed device, for the first hand
  for (const PluginInfo* plugin : catalogue_.of_kind(SWAGE_KIND_DEVICE)) {
    names.push_back(last_word(plugin->id));
    if (plugin->id != wanted && last_word(plugin->id) != wanted) continue;
    substitute_.plugin = plugin->id;
    substitute_.params = overrides_.device_params.empty() ? "{}" : overrides_.device_params;
    substitute_.pointer = "/devices/0";
    substitute_for_ = 0;
    return;
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  error("/devices", say::kNoDevice(wanted, host::did_you_mean(wanted, names), host::join(names)));
}

const DeviceChoice* Assembler::choose(const LessonDevice& device, std::size_t index) {
  if (index == substitute_for_) return &substitute_;
  // further hands use the same choice where they have one of that name
  if (!hand_.empty()) {
    for (const DeviceChoice& choice : device.choices)
      if (matches(choice, hand_)) return &choice;
  }
  const DeviceChoice& first = device.choices[0];
  if (catalogue_.find(first.plugin) != nullptr) return &first;
  for (const DeviceChoice& choice : device.choices) {
    if (catalogue_.find(choice.plugin) == nullptr) continue;
    used_.insert(first.plugin);
    note(
        Severity::kNote, first.pointer + "/plugin",
        say::kReplaced(first.plugin, device.name, choice.plugin));
    return &choice;
  }
  return &first;
}

void Assembler::add_devices() {
  if (file_.devices.size() > snapshot::kMaxDevices)
    return error("/devices", say::kManyDevices(snapshot::kMaxDevices, file_.devices.size()));
  for (std::size_t i = 0; i < file_.devices.size(); ++i) {
    const LessonDevice& use = file_.devices[i];
    // for "requires" the plugins of the other choices count as used, too
    for (const DeviceChoice& choice : use.choices) used_.insert(choice.plugin);
    host::DeviceSlot& slot = rig_->devices.emplace_back();
    if (i < overrides_.recorded.size()) {
      const RecordedHand& hand = overrides_.recorded[i];
      slot.instance = host::stand_in_device(use.name, hand.plugin, hand.version, hand.flags, rig_->shared);
      slot.device = static_cast<const swage_device*>(slot.instance->extension(SWAGE_EXT_DEVICE));
      place_hand(use, slot);
      continue;
    }
    const DeviceChoice* choice = choose(use, i);
    const bool given = choice == &substitute_ && !overrides_.device_params.empty();
    std::unique_ptr<host::Builder> builder;
    slot.instance =
        make(*choice, SWAGE_KIND_DEVICE, use.name, kNone, {}, given ? "--device-params" : "", builder);
    if (!slot.instance) continue;
    slot.device = table<swage_device>(*slot.instance, SWAGE_EXT_DEVICE, *choice);
    slot.sight = table<swage_device_sight>(*slot.instance, SWAGE_EXT_SIGHT, *choice, false);
    slot.choice = choice->as;
    slot.params = choice->params;
    if (slot.device != nullptr) place_hand(use, slot);
  }
}

void Assembler::place_hand(const LessonDevice& use, host::DeviceSlot& slot) {
  // scripted hands and replays use world coordinates
  const bool world = (slot.device->flags & SWAGE_DEVICE_WORLD) != 0;
  const bool force = (slot.device->flags & SWAGE_DEVICE_FORCE) != 0;
  slot.motion_scale = world ? 1 : use.motion_scale;
  slot.force_scale = force ? use.force_scale : 0;
  slot.filters = world ? host::HandFilters{} : use.filters;
  slot.reaction = use.reaction;
  slot.coupling = force ? use.coupling : host::HandCoupling{};
  slot.X_WD0 = world ? swage_pose{{0, 0, 0}, {1, 0, 0, 0}} : use.X_WD0;
}

void Assembler::bind_follows() {
  const auto index_of = [this](const std::string& name) {
    for (uint32_t i = 0; i < file_.devices.size(); ++i)
      if (file_.devices[i].name == name) return i;
    return kNone;
  };
  for (std::size_t i = 0; i < rig_->devices.size(); ++i)
    if (!file_.devices[i].clutch_of.empty()) rig_->devices[i].filters.clutch_device = index_of(file_.devices[i].clutch_of);
  for (std::size_t i = 0; i < rig_->objects.size(); ++i) {
    const LessonObject& use = file_.objects[i];
    host::ObjectSlot& slot = rig_->objects[i];
    slot.follow = {index_of(use.follow_pose), index_of(use.follow_closure)};
    for (uint32_t b = 0; b < slot.body.count && use.follow_pose.empty(); ++b) {
      const scene::BodyInfo& body = rig_->world.body[slot.body.first + b];
      if (body.motion != SWAGE_MOTION_FOLLOWS) continue;
      const std::string hand = file_.devices.empty() ? "hand" : file_.devices[0].name;
      error(use.pointer, say::kFollowsNobody(use.name, hand, hand));
      break;
    }
  }
}

}  // namespace swage::assembly
