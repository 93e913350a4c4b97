// SPDX-License-Identifier: Apache-2.0
//
// Resolves the objects and signals that the acts of a plan refer to, once, or finds the reason why the plan cannot be run in a scene.
#include "sentences.hpp"
#include "skilled.hpp"

namespace swage::skilled {
namespace {

Signal find_signal(const Scene& scene, const std::string& id) {
  for (uint32_t i = 0; i < scene->n_signal; ++i)
    if (view(scene->signal[i].id) == id) return Signal(i);
  return {};
}

}  // namespace

void Skilled::bind(const Scene& scene, std::span<const swage_scene_mark> marks) {
  gripper_ = scene.find_object(params_.gripper);
  needle_ = scene.find_object(params_.needle);
  if (gripper_ == kNone) return refuse(say::kNoObject(params_.gripper, "gripper"));
  if (needle_ == kNone) return refuse(say::kNoObject(params_.needle, "needle"));
  needle_peer_ = Peer(scene->object[needle_].instance);
  strand_ = StrandPeer(needle_peer_);
  if (!needle_peer_.graspable()) return refuse(say::kNotGraspable(params_.needle));
  force_ = params_.grasp.empty() ? find_signal(scene, "grasp.force") : scene.find_signal(params_.grasp, "grasp.force");
  if (!params_.grasp.empty() && !force_.valid()) return refuse(say::kNoForce(params_.grasp));
  hole_ = {};
  if (params_.steady > 0) {
    hole_.s = find_signal(scene, "pierce.s");
    for (int i = 0; i < 3; ++i) {
      hole_.entry[i] = find_signal(scene, std::string("pierce.entry_") + "xyz"[i]);
      hole_.at[i] = find_signal(scene, std::string("pierce.at_") + "xyz"[i]);
    }
    if (!hole_.valid()) return refuse(say::kNoHole());
  }

  for (size_t i = 0; i < plan_.acts.size(); ++i) {
    const Act& act = plan_.acts[i];
    const std::string where = "act " + std::to_string(i + 1) + " of " + params_.file;
    if (act.force > 0 && !force_.valid()) return refuse(say::kClosesToForce(where));
    if (act.keep && !strand_.valid()) return refuse(say::kNoThread(where, params_.needle));
    if (act.verb == Verb::kDraw && !(act.less > 0)) return refuse(say::kDrawsToNothing(where));
    if (!find_marks(marks, i, where) || !find_things(scene, i, where) || !find_signals(scene, i, where)) return;
  }
}

uint32_t Skilled::find_mark(std::span<const swage_scene_mark> marks, const std::string& meaning) const {
  for (uint32_t m = 0; m < marks.size(); ++m)
    if (view(marks[m].meaning) == meaning && marks[m].kind == SWAGE_MARK_POINT) return m;
  return kNone;
}

bool Skilled::cannot_see(const std::string& meaning, const std::string& where) {
  refuse(say::kNoPoint(where, meaning));
  return false;
}

bool Skilled::find_marks(std::span<const swage_scene_mark> marks, size_t i, const std::string& where) {
  const Act& act = plan_.acts[i];
  for (const auto& [meaning, index] :
       {std::pair{&act.mark, &seeks_[i].mark}, {&act.other, &seeks_[i].other}}) {
    if (meaning->empty()) continue;
    *index = find_mark(marks, *meaning);
    if (*index != kNone) continue;
    return cannot_see(*meaning, where);
  }
  seeks_[i].among.clear();
  for (const std::string& meaning : act.among) {
    seeks_[i].among.push_back(find_mark(marks, meaning));
    if (seeks_[i].among.back() == kNone) return cannot_see(meaning, where);
  }
  return true;
}

bool Skilled::find_things(const Scene& scene, size_t i, const std::string& where) {
  const Act& act = plan_.acts[i];
  Seeks& seeks = seeks_[i];
  if (act.verb == Verb::kAnswer || act.verb == Verb::kWind) {
    const std::string& thing = act.verb == Verb::kWind ? act.about : act.of;
    const std::string does = act.verb == Verb::kWind ? say::kWindsAbout() : say::kJudges();
    seeks.thing = scene.find_object(thing);
    if (seeks.thing == kNone) return refuse(say::kNotThere(where, does, thing)), false;
    seeks.thing_peer = Peer(scene->object[seeks.thing].instance);
    if (act.verb == Verb::kWind && !seeks.thing_peer.gripper())
      return refuse(say::kNoTips(where, does, thing)), false;
  }
  if (act.tissue.empty()) return true;
  seeks.tissue = scene.find_object(act.tissue);
  if (seeks.tissue == kNone)
    return refuse(say::kNotThere(where, say::kAimsInto(), act.tissue)), false;
  seeks.tissue_peer = Peer(scene->object[seeks.tissue].instance);
  if (!seeks.tissue_peer.has(SWAGE_TRAIT_PIERCEABLE))
    return refuse(say::kNotPierced(where, act.tissue)), false;
  return true;
}

bool Skilled::find_signals(const Scene& scene, size_t i, const std::string& where) {
  const Act& act = plan_.acts[i];
  if (act.signal.empty()) return true;
  seeks_[i].signal = scene.find_signal(act.of, act.signal);
  if (seeks_[i].signal.valid()) return true;
  refuse(say::kNotTold(where, act.signal, act.of));
  return false;
}

}  // namespace swage::skilled
