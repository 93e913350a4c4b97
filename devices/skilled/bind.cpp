// SPDX-License-Identifier: Apache-2.0
//
// What the acts of a plan look for in a scene, found once, or the reason why the plan cannot be carried out there.
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
  if (gripper_ == kNone) return refuse("there is no object \"" + params_.gripper + "\" (parameter gripper)");
  if (needle_ == kNone) return refuse("there is no object \"" + params_.needle + "\" (parameter needle)");
  needle_peer_ = Peer(scene->object[needle_].instance);
  strand_ = StrandPeer(needle_peer_);
  if (!needle_peer_.graspable()) return refuse("\"" + params_.needle + "\" is not graspable");
  force_ = params_.grasp.empty() ? find_signal(scene, "grasp.force") : scene.find_signal(params_.grasp, "grasp.force");
  if (!params_.grasp.empty() && !force_.valid())
    return refuse("there is no signal \"grasp.force\" of \"" + params_.grasp + "\" (parameter grasp)");
  hole_ = {};
  if (params_.steady > 0) {
    hole_.s = find_signal(scene, "pierce.s");
    for (int i = 0; i < 3; ++i) {
      hole_.entry[i] = find_signal(scene, std::string("pierce.entry_") + "xyz"[i]);
      hole_.at[i] = find_signal(scene, std::string("pierce.at_") + "xyz"[i]);
    }
    if (!hole_.valid())
      return refuse(
          "nothing here has a signal \"pierce.s\" by which to see where the needle goes in (parameter "
          "steady)");
  }

  for (size_t i = 0; i < plan_.acts.size(); ++i) {
    const Act& act = plan_.acts[i];
    const std::string where = "act " + std::to_string(i + 1) + " of " + params_.file;
    if (act.force > 0 && !force_.valid())
      return refuse(
          where +
          " closes to a force, but nothing here has a signal \"grasp.force\"; add a swage.coupling.grasp");
    if (act.keep && !strand_.valid()) return refuse(where + " reaches for a place of a thread, but \"" + params_.needle + "\" is none");
    if (act.verb == Verb::kDraw && !(act.less > 0)) return refuse(where + " draws up to a signal above 0");
    if (!find_marks(marks, i, where) || !find_things(scene, i, where) || !find_signals(scene, i, where)) return;
  }
}

uint32_t Skilled::find_mark(std::span<const swage_scene_mark> marks, const std::string& meaning) const {
  for (uint32_t m = 0; m < marks.size(); ++m)
    if (view(marks[m].meaning) == meaning && marks[m].kind == SWAGE_MARK_POINT) return m;
  return kNone;
}

bool Skilled::cannot_see(const std::string& meaning, const std::string& where) {
  refuse(where + " looks for the point \"" + meaning + "\", which this lesson does not show");
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
    const char* const does = act.verb == Verb::kWind ? " winds about \"" : " judges \"";
    seeks.thing = scene.find_object(thing);
    if (seeks.thing == kNone) return refuse(where + does + thing + "\", which is not there"), false;
    seeks.thing_peer = Peer(scene->object[seeks.thing].instance);
    if (act.verb == Verb::kWind && !seeks.thing_peer.gripper())
      return refuse(where + does + thing + "\", which has no tips"), false;
  }
  if (act.tissue.empty()) return true;
  seeks.tissue = scene.find_object(act.tissue);
  if (seeks.tissue == kNone)
    return refuse(where + " aims into \"" + act.tissue + "\", which is not there"), false;
  seeks.tissue_peer = Peer(scene->object[seeks.tissue].instance);
  if (!seeks.tissue_peer.has(SWAGE_TRAIT_PIERCEABLE))
    return refuse(where + ": \"" + act.tissue + "\" cannot be pierced"), false;
  return true;
}

bool Skilled::find_signals(const Scene& scene, size_t i, const std::string& where) {
  const Act& act = plan_.acts[i];
  if (act.signal.empty()) return true;
  seeks_[i].signal = scene.find_signal(act.of, act.signal);
  if (seeks_[i].signal.valid()) return true;
  refuse(where + " waits for \"" + act.signal + "\" of \"" + act.of + "\", which nobody tells here");
  return false;
}

}  // namespace swage::skilled
