// SPDX-License-Identifier: Apache-2.0
//
// Couplings and their objects: traits, pairs, and the scene that the lesson gets.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "assembly/assembler.hpp"
#include "assembly/sentences.hpp"
#include "host/guard.hpp"
#include "host/nearest.hpp"
#include "judge/host_events.hpp"
#include "snapshot/snapshot.hpp"
#include "toolkit/height_field.hpp"
#include "toolkit/mirror.hpp"

namespace swage::assembly {

using host::Call;
using host::ObjectSlot;
using scene::kNone;

namespace {

swage_str view(const std::string& text) { return {text.data(), text.size()}; }

bool has_trait(const host::Instance& instance, const std::string& trait) {
  return std::find(instance.traits.begin(), instance.traits.end(), trait) != instance.traits.end();
}

}  // namespace

bool Assembler::offers(const LessonCoupling& use, const ObjectSlot& object, const char* const* needs,
                       const std::string& side) {
  bool all = true;
  for (; needs != nullptr && *needs != nullptr; ++needs) {
    const std::string trait = *needs;
    if (has_trait(*object.instance, trait) && object.instance->extension(*needs) != nullptr) continue;
    all = false;
    std::vector<std::string> others;
    for (const ObjectSlot& other : rig_->objects)
      if (other.instance && has_trait(*other.instance, trait)) others.push_back(other.instance->name);
    error(use.pointer + "/between/" + side,
          say::kNoTrait(use.plugin, trait, object.instance->name, object.instance->plugin_id, others.empty() ? say::kNobodyOffers() : say::kOthersOffer(host::join(others))));
  }
  return all;
}

// couplings that detect define the pairs, in the order of the file; couplings that only observe share them
void Assembler::find_pairs() {
  const auto same_two = [](const host::CouplingSlot& slot, const contact::Pair& pair) {
    return std::minmax(slot.object_a, slot.object_b) == std::minmax(pair.object_a, pair.object_b);
  };
  const auto one_was_refused = [&](const LessonCoupling& use) {
    for (std::size_t k = 0; k < rig_->couplings.size(); ++k) {
      const LessonCoupling& other = file_.couplings[k];
      if (!rig_->couplings[k].coupling && std::minmax(use.a, use.b) == std::minmax(other.a, other.b)) return true;
    }
    return false;
  };
  for (const bool detects : {true, false}) {
    for (std::size_t i = 0; i < rig_->couplings.size(); ++i) {
      host::CouplingSlot& slot = rig_->couplings[i];
      const LessonCoupling& use = file_.couplings[i];
      if (slot.coupling == nullptr || slot.object_a == kNone || slot.object_b == kNone) continue;
      if ((slot.coupling->detects != 0) != detects) continue;
      const auto found = std::find_if(rig_->pairs.begin(), rig_->pairs.end(),
                                      [&](const contact::Pair& p) { return same_two(slot, p); });
      slot.pair = static_cast<uint32_t>(found - rig_->pairs.begin());
      if (found == rig_->pairs.end()) {
        if (detects) {
          rig_->pairs.push_back({slot.object_a, slot.object_b, {}});
          continue;
        }
        slot.pair = kNone;
        // a refused coupling has been reported
        if (one_was_refused(use)) continue;
        error(use.pointer, say::kNobodyFinds(use.plugin, use.a, use.b));
      } else if (found->object_a != slot.object_a) {
        error(use.pointer + "/between", say::kOtherOrder(use.b, use.a));
      }
    }
  }
}

// Contacts are found and solved in the order of their pairs: sorted by the names of their objects, independent of the file's order.
void Assembler::sort_pairs() {
  const std::vector<contact::Pair> found = rig_->pairs;
  const auto names = [&](uint32_t pair) {
    return std::tie(file_.objects[found[pair].object_a].name, file_.objects[found[pair].object_b].name);
  };
  std::vector<uint32_t> order(found.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t i, uint32_t j) { return names(i) < names(j); });
  std::vector<uint32_t> place(found.size());
  for (uint32_t i = 0; i < order.size(); ++i) rig_->pairs[i] = found[order[i]], place[order[i]] = i;
  for (host::CouplingSlot& slot : rig_->couplings)
    if (slot.pair != kNone) slot.pair = place[slot.pair];
}

void Assembler::bind_couplings() {
  for (std::size_t i = 0; i < rig_->couplings.size(); ++i) {
    host::CouplingSlot& slot = rig_->couplings[i];
    const LessonCoupling& use = file_.couplings[i];
    if (slot.coupling == nullptr || slot.object_a >= rig_->objects.size() ||
        slot.object_b >= rig_->objects.size())
      continue;
    const ObjectSlot& a = rig_->objects[slot.object_a];
    const ObjectSlot& b = rig_->objects[slot.object_b];
    if (!a.instance || !b.instance) continue;
    const bool good_a = offers(use, a, slot.coupling->needs_a, "0");
    const bool good_b = offers(use, b, slot.coupling->needs_b, "1");
    if (!good_a || !good_b) continue;

    swage_result result = SWAGE_OK;
    const std::size_t before = problems_.size();
    const bool kept = host::guarded(*slot.instance, Call::kBind, 0, [&] {
      result = slot.coupling->bind(slot.instance->raw, a.instance->raw, b.instance->raw);
      return result == SWAGE_ERROR ? SWAGE_OK : result;
    });
    take_reports(*slot.instance, use.pointer);
    if (!kept) {
      error(use.pointer, host::quarantine_text(*slot.instance));
    } else if (result < 0 && problems_.size() == before) {
      error(use.pointer, say::kRefusedPair(use.plugin, use.a, use.b));
    }
  }
}

namespace {

// implementation of swage_lesson_binder
struct Binding {
  host::Rig& rig;
  std::vector<std::string> errors;

  static Binding& of(swage_lesson_binder* raw) { return *static_cast<Binding*>(raw->host_data); }

  static uint32_t mark(swage_lesson_binder* raw, const swage_mark* mark) {
    Binding& self = of(raw);
    std::vector<judge::Script::Mark>& marks = self.rig.script.marks;
    const std::string wrong = mark != nullptr ? self.check(*mark) : say::kNullMark();
    if (!wrong.empty()) {
      self.errors.push_back(wrong);
      return kNone;
    }
    judge::Script::Mark kept{*mark, std::string(mark->meaning.data, mark->meaning.size)};
    // the text is stored in `meaning`; the view would dangle as soon as the script is copied
    kept.mark.meaning = {nullptr, 0};
    marks.push_back(std::move(kept));
    return static_cast<uint32_t>(marks.size() - 1);
  }

  std::string check(const swage_mark& mark) const {
    if (rig.script.marks.size() >= snapshot::kMaxMarks)
      return say::kManyMarks(snapshot::kMaxMarks);
    if (mark.meaning.data == nullptr || mark.meaning.size == 0)
      return say::kMarkMeaning();
    if (mark.kind == SWAGE_MARK_POINT) {
      const bool place = std::isfinite(mark.p_W.x) && std::isfinite(mark.p_W.y) && std::isfinite(mark.p_W.z);
      return place && mark.number[0] > 0 ? "" : say::kPointMark();
    }
    if (mark.kind != SWAGE_MARK_ARC_RANGE) return say::kMarkKind(mark.kind);
    if (mark.object >= rig.objects.size())
      return say::kMarkOfNobody(mark.object);
    if (!(mark.number[0] >= 0 && mark.number[0] <= mark.number[1] && mark.number[1] <= 1))
      return say::kArcMarkRange();
    const ObjectSlot& slot = rig.objects[mark.object];
    for (uint32_t i = 0; i < slot.shape.count; ++i) {
      const int32_t kind = rig.world.shape[slot.shape.first + i].kind;
      if (kind == SWAGE_SHAPE_ARC || kind == SWAGE_SHAPE_CHAIN) return "";
    }
    return say::kArcMarkOf(slot.instance->name);
  }

  static void error(swage_lesson_binder* raw, const char* message) {
    of(raw).errors.push_back(message != nullptr ? message : "");
  }
};

void fill_bound(host::Rig& rig) {
  host::BoundScene& bound = rig.bound;
  for (const ObjectSlot& slot : rig.objects)
    bound.objects.push_back({view(slot.instance->name), view(slot.instance->plugin_id), slot.body.first,
                             slot.body.count, slot.particle.first, slot.particle.count, slot.instance->raw});
  for (const judge::Name& name : rig.script.signals)
    bound.signals.push_back({view(name.owner), view(name.id), view(name.unit)});
  for (const judge::Name& name : rig.script.events) bound.events.push_back({view(name.owner), view(name.id)});
  bound.card = {sizeof(swage_scene_card),
                static_cast<uint32_t>(bound.objects.size()),
                static_cast<uint32_t>(bound.signals.size()),
                static_cast<uint32_t>(bound.events.size()),
                bound.objects.data(),
                bound.signals.data(),
                bound.events.data(),
                rig.world.length};
}

}  // namespace

void Assembler::bind_lesson() {
  host::LessonSlot& slot = rig_->lesson;
  fill_bound(*rig_);
  // nullptr: a scene without a lesson, as in the validator
  if (slot.lesson == nullptr || slot.lesson->bind == nullptr) return;
  Binding binding{*rig_, {}};
  swage_lesson_binder raw{sizeof(swage_lesson_binder), 0, &binding, Binding::mark, Binding::error};
  swage_result result = SWAGE_OK;
  const std::size_t before = problems_.size();
  const bool kept = host::guarded(*slot.instance, Call::kBind, 0, [&] {
    result = slot.lesson->bind(slot.instance->raw, &rig_->bound.card, &raw);
    return result == SWAGE_ERROR ? SWAGE_OK : result;
  });
  for (const std::string& message : binding.errors) error(file_.lesson.pointer, message);
  take_reports(*slot.instance, file_.lesson.pointer);
  if (!kept) {
    error(file_.lesson.pointer, host::quarantine_text(*slot.instance));
  } else if (result < 0 && problems_.size() == before) {
    error(file_.lesson.pointer, say::kRefusedScene(file_.lesson.plugin));
  }
}

// devices with sight get the same scene as the lesson, and its marks
void Assembler::bind_sights() {
  std::vector<swage_scene_mark> marks;
  for (const judge::Script::Mark& m : rig_->script.marks)
    marks.push_back({m.mark.kind, m.mark.object, view(m.meaning), {m.mark.number[0], m.mark.number[1]}});
  const swage_sight_card card{sizeof(swage_sight_card), static_cast<uint32_t>(marks.size()),
                              &rig_->bound.card, marks.data()};
  for (std::size_t i = 0; i < rig_->devices.size(); ++i) {
    const host::DeviceSlot& slot = rig_->devices[i];
    if (slot.sight == nullptr) continue;
    const std::string pointer = "/devices/" + std::to_string(i);
    swage_result result = SWAGE_OK;
    const std::size_t before = problems_.size();
    const bool kept = host::guarded(*slot.instance, Call::kBind, 0, [&] {
      result = slot.sight->bind(slot.instance->raw, &card);
      return result == SWAGE_ERROR ? SWAGE_OK : result;
    });
    take_reports(*slot.instance, pointer);
    if (!kept) {
      error(pointer, host::quarantine_text(*slot.instance));
    } else if (result < 0 && problems_.size() == before) {
      error(pointer, say::kRefusedSight(slot.instance->plugin_id));
    }
  }
}

namespace {

// mirrors the display for the left hand: poses and places reflected, shapes with their bodies
void mirror(snapshot::SceneCard& card) {
  using toolkit::mirrored;
  for (swage_pose& X_WB : card.start) X_WB = mirrored(X_WB);
  for (judge::Script::Mark& mark : card.script.marks) mark.mark.p_W = mirrored(mark.mark.p_W);
  for (snapshot::CardShape& shape : card.shapes) {
    shape.X_BS = toolkit::mirrored_shape(shape.X_BS);
    for (swage_vec3& v : shape.vertex) v.z = -v.z;
    for (std::vector<uint32_t>& face : shape.face) std::reverse(face.begin(), face.end());
  }
}

/// What the card of its owner says of a metric.
snapshot::CardMetric card_metric(const judge::Name& metric, const host::PluginInfo* plugin) {
  const bool of_host = metric.owner == judge::kHostOwner;
  if (!of_host && plugin == nullptr) return {};
  for (const host::MetricInfo& m : of_host ? host::pull_metrics() : plugin->metrics)
    if (m.id == metric.id) return {m.better, m.evidence, m.code, m.formula, m.title, m.show, m.rank};
  return {};
}

/// Adds the surface of a height field as declared.
void add_triangles(const scene::HeightFieldInfo& info, snapshot::CardShape& shape) {
  const toolkit::HeightField field{info.nx, info.ny, info.dx, info.dy, info.height.data()};
  for (uint32_t k = 0; k < field.vertices(); ++k)
    shape.vertex.push_back(toolkit::raw(field.vertex(k % info.nx, k / info.nx)));
  for (uint32_t j = 0; j + 1 < info.ny; ++j)
    for (uint32_t i = 0; i + 1 < info.nx; ++i) {
      const uint32_t v = j * info.nx + i, opposite = v + info.nx + 1;
      shape.face.push_back({v, v + 1, opposite});
      shape.face.push_back({v, opposite, v + info.nx});
    }
}

}  // namespace

void Assembler::fill_metrics() {
  const host::PluginInfo* plugin = catalogue_.find(file_.lesson.plugin);
  for (const judge::Name& metric : rig_->script.metrics) rig_->card.metrics.push_back(card_metric(metric, plugin));
  rig_->card.cue_channels.assign(rig_->script.cues.size(), kAllChannels);
  for (std::size_t i = 0; plugin != nullptr && i < rig_->script.cues.size(); ++i)
    for (const host::CueInfo& c : plugin->cues)
      if (c.id == rig_->script.cues[i].id) rig_->card.cue_channels[i] = c.channels;
}

void Assembler::fill_card() {
  const host::Rig& rig = *rig_;
  fill_metrics();
  snapshot::SceneCard& card = rig_->card;
  card.lesson_id = file_.id;
  card.title = file_.title;
  card.lesson_plugin = file_.lesson.plugin;
  card.length = rig.world.length;
  card.dt = rig.world.dt;
  card.seed = rig.seed;
  card.script = rig.script;
  for (const ObjectSlot& slot : rig.objects)
    card.objects.push_back({slot.instance->name, slot.instance->plugin_id, slot.instance->plugin_version,
                            slot.instance->traits, slot.body.first, slot.body.count, slot.particle.first,
                            slot.particle.count});
  for (const host::DeviceSlot& slot : rig.devices)
    card.devices.push_back({slot.instance->name, slot.instance->plugin_id, slot.instance->plugin_version,
                            slot.device != nullptr ? slot.device->flags : 0});
  for (const scene::BodyInfo& body : rig.world.body) {
    card.start.push_back(body.start);
    card.motion.push_back(body.motion);
  }
  for (const scene::Shape& s : rig.world.shape) {
    snapshot::CardShape shape{s.kind,        s.body,       s.object, s.flags, s.X_BS, s.radius,
                              s.half_length, s.arc_radius, s.sweep,  {},      {}};
    if (s.convex != kNone) {
      const toolkit::Convex& convex = rig.world.convex[s.convex];
      for (const toolkit::Vec3& v : convex.vertex) shape.vertex.push_back(toolkit::raw(v));
      for (const toolkit::Convex::Face& f : convex.face) shape.face.push_back(f.vertex);
    }
    if (s.field != kNone) add_triangles(rig.world.field[s.field], shape);
    // start of the chain; the snapshot has its vertices after the particles, chain by chain
    if (s.kind == SWAGE_SHAPE_CHAIN) shape.vertex = rig.world.chain[s.chain].start;
    card.shapes.push_back(std::move(shape));
  }
  if (rig.mirror) mirror(card);
}

}  // namespace swage::assembly
