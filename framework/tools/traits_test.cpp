// SPDX-License-Identifier: Apache-2.0
//
// Test of the traits with functions (abi/object.h), called as by a coupling that does not know the object.
#include <swage/abi/cut.h>
#include <swage/abi/strand.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/rng.hpp"
#include "host/services.hpp"
#include "scene/view.hpp"
#include "tools/extension_tests.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using host::Finding;
using host::Mark;

bool is_unit(const swage_vec3& a) { return std::abs(std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z) - 1) < 1e-6; }
double dot(const swage_vec3& a, const swage_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
bool positive(double a) { return std::isfinite(a) && a > 0; }
bool at_least_0(double a) { return a >= 0; }  // infinity is allowed, as for a strength

class Traits {
 public:
  Traits(Stepped& scene, uint32_t object, uint64_t seed)
      : scene_(scene), slot_(scene.rig->objects[object]), random_(seed) {}

  int asked() const { return asked_; }

  std::string check() {
    std::string wrong = graspable();
    if (wrong.empty()) wrong = gripper();
    if (wrong.empty()) wrong = piercing();
    if (wrong.empty()) wrong = pierceable();
    if (wrong.empty()) wrong = strand();
    if (wrong.empty()) wrong = strand_nodes();
    if (wrong.empty()) wrong = strand_line();
    if (wrong.empty()) wrong = blades();
    if (wrong.empty()) wrong = cuttable();
    return wrong;
  }

 private:
  const swage_object_step& view() {
    view_ = scene::view(scene_.rig->world,
                        {slot_.body, slot_.particle, slot_.shape, slot_.hinge, slot_.state, slot_.signal}, &input_);
    return view_;
  }
  template <class T>
  const T* table(const char* id) {
    const auto* found = static_cast<const T*>(slot_.instance->extension(id));
    asked_ += found != nullptr;
    return found;
  }
  // calls twice: "" when both results have the same bits and no instance is in quarantine
  template <class T, class F>
  std::string twice(const char* what, T& out, F&& f) {
    T again{};
    out = {};
    const host::ScopedRole rt(SWAGE_THREAD_RT);
    for (T* answer : {&out, &again}) {
      host::guarded(*slot_.instance, host::Call::kResolve, scene_.rig->world.step, [&] { return f(answer); });
      if (slot_.instance->quarantined.load() != 0) return std::string(what) + "(): " + host::quarantine_text(*slot_.instance);
    }
    if (std::memcmp(&out, &again, sizeof out) != 0) return say::kOtherBits(what);
    return "";
  }
  // a random place near the object or 1 m away
  swage_vec3 somewhere() {
    const swage_vec3& p = scene_.rig->world.X_WB[slot_.body.first].p;
    const double r = random_() % 4 == 0 ? 1.0 : 1e-2;
    return {p.x + r * random_.uniform(-1, 1), p.y + r * random_.uniform(-1, 1), p.z + r * random_.uniform(-1, 1)};
  }
  static std::string told(const char* what, const std::string& wrong) { return say::kOfCall(what, wrong); }

  std::string graspable() {
    const auto* t = table<swage_graspable>(SWAGE_TRAIT_GRASPABLE);
    if (t == nullptr) return "";
    if (t->locate == nullptr) return say::kGaps(SWAGE_TRAIT_GRASPABLE);
    for (int i = 0; i < 200; ++i) {
      const swage_vec3 p = somewhere();
      swage_graspable_place place;
      std::string wrong =
          twice("locate", place, [&](auto* out) { return t->locate(slot_.instance->raw, &view(), p, out); });
      if (!wrong.empty()) return wrong;
      if (!(place.s >= 0 && place.s <= 1)) return told("locate", say::kPlaceRange());
      if (!positive(place.length)) return told("locate", say::kNoLength());
      if (!is_unit(place.tangent_W) || !is_unit(place.normal_W) || std::abs(dot(place.tangent_W, place.normal_W)) > 1e-6)
        return told("locate", say::kNotSquare());
      if (!host::finite(&place.p_W.x, 3)) return told("locate", say::kPlaceNoNumber());
    }
    return "";
  }

  std::string gripper() {
    const auto* t = table<swage_gripper>(SWAGE_TRAIT_GRIPPER);
    if (t == nullptr) return "";
    if (t->describe == nullptr) return say::kGaps(SWAGE_TRAIT_GRIPPER);
    for (const double closure : {0.0, 0.5, 1.0}) {
      input_.closure = closure;
      swage_gripper_state g;
      std::string wrong = twice("describe", g, [&](auto* out) { return t->describe(slot_.instance->raw, &view(), out); });
      if (!wrong.empty()) return wrong;
      if (g.left_body >= slot_.body.count || g.right_body >= slot_.body.count)
        return told("describe", say::kNoJaw());
      if (!is_unit(g.axis_W) || !is_unit(g.closing_W)) return told("describe", say::kAxis());
      if (!host::finite(&g.tip_W.x, 3) || !std::isfinite(g.opening) || !(g.closure >= 0 && g.closure <= 1))
        return told("describe", say::kGripper());
    }
    return "";
  }

  std::string piercing() {
    const auto* t = table<swage_piercing>(SWAGE_TRAIT_PIERCING);
    if (t == nullptr) return "";
    if (t->place == nullptr || t->nearest == nullptr) return say::kGaps(SWAGE_TRAIT_PIERCING);
    for (int i = 0; i < 200; ++i) {
      const double s = random_.uniform(0, 1);
      const swage_vec3 p = somewhere();
      swage_piercing_place place[2];
      std::string wrong =
          twice("place", place[0], [&](auto* out) { return t->place(slot_.instance->raw, &view(), s, out); });
      if (wrong.empty())
        wrong = twice("nearest", place[1], [&](auto* out) { return t->nearest(slot_.instance->raw, &view(), p, out); });
      if (!wrong.empty()) return wrong;
      for (const swage_piercing_place& at : place) {
        const char* who = &at == place ? "place" : "nearest";
        if (!(at.s >= 0 && at.s <= 1)) return told(who, say::kPlaceRange());
        if (!positive(at.length) || !positive(at.radius)) return told(who, say::kNoLengthRadius());
        if (!is_unit(at.tangent_W) || !host::finite(&at.p_W.x, 3)) return told(who, say::kTangent());
        if (at.body >= slot_.body.count) return told(who, say::kNoBody());
      }
    }
    return "";
  }

  std::string pierceable() {
    const auto* t = table<swage_pierceable>(SWAGE_TRAIT_PIERCEABLE);
    if (t == nullptr) return "";
    if (t->law == nullptr || t->locate == nullptr) return say::kGaps(SWAGE_TRAIT_PIERCEABLE);
    swage_pierceable_law law;
    if (std::string wrong = twice("law", law, [&](auto* out) { return t->law(slot_.instance->raw, &view(), out); }); !wrong.empty())
      return wrong;
    for (const double x : {law.stiffness, law.stiffening, law.friction, law.puncture_force, law.cutting_force, law.drag,
                           law.side_stiffness, law.failure_stress})
      if (!at_least_0(x)) return told("law", say::kProperty());
    for (int i = 0; i < 200; ++i) {
      const swage_vec3 p = somewhere();
      swage_pierceable_place place;
      std::string wrong =
          twice("locate", place, [&](auto* out) { return t->locate(slot_.instance->raw, &view(), p, out); });
      if (!wrong.empty()) return wrong;
      const double at[] = {place.depth, place.beyond, place.edge, place.p_W.x, place.p_W.y, place.p_W.z};
      for (const double x : at)
        if (std::isnan(x)) return told("locate", say::kPlaceNoNumber());
      if (!is_unit(place.normal_W)) return told("locate", say::kNormal());
      if (place.body >= slot_.body.count) return told("locate", say::kNoBody());
    }
    return "";
  }

  std::string strand() {
    const auto* t = table<swage_strand>(SWAGE_TRAIT_STRAND);
    if (t == nullptr) return "";
    if (t->law == nullptr || t->place == nullptr || t->nearest == nullptr) return say::kGaps(SWAGE_TRAIT_STRAND);
    swage_strand_law law;
    if (std::string wrong = twice("law", law, [&](auto* out) { return t->law(slot_.instance->raw, &view(), out); }); !wrong.empty())
      return wrong;
    if (!positive(law.length) || !positive(law.radius) || !at_least_0(law.strength) || !at_least_0(law.pull_off))
      return told("law", say::kStrand());
    for (int i = 0; i < 200; ++i) {
      const double s = random_.uniform(-0.1, 1.1) * law.length;
      const swage_vec3 p = somewhere();
      swage_strand_place place[2];
      std::string wrong =
          twice("place", place[0], [&](auto* out) { return t->place(slot_.instance->raw, &view(), s, out); });
      if (wrong.empty())
        wrong = twice("nearest", place[1], [&](auto* out) { return t->nearest(slot_.instance->raw, &view(), p, out); });
      if (!wrong.empty()) return wrong;
      const double nearest = std::clamp(s, 0.0, law.length);
      if (!(std::abs(place[0].s - nearest) <= 1e-9 * law.length)) return told("place", say::kElsewhere());
      for (const swage_strand_place& at : place) {
        const char* who = &at == place ? "place" : "nearest";
        if (!(at.s >= 0 && at.s <= law.length * (1 + 1e-9))) return told(who, say::kStrandRange());
        if (!is_unit(at.tangent_W) || !is_unit(at.normal_W) || std::abs(dot(at.tangent_W, at.normal_W)) > 1e-6)
          return told(who, say::kNotSquare());
        if (!host::finite(&at.p_W.x, 3) || !std::isfinite(at.tension)) return told(who, say::kTension());
        if (at.body >= slot_.body.count) return told(who, say::kNoBody());
      }
    }
    return "";
  }

  std::string strand_nodes() {
    const auto* t = table<swage_strand_nodes>(SWAGE_TRAIT_STRAND_NODES);
    if (t == nullptr) return "";
    if (t->count == nullptr) return say::kGaps(SWAGE_TRAIT_STRAND_NODES);
    if (slot_.instance->extension(SWAGE_TRAIT_STRAND) == nullptr) return say::kNodesAlone(SWAGE_TRAIT_STRAND);
    uint32_t nodes = 0;
    std::string wrong = twice("count", nodes, [&](auto* out) { return t->count(slot_.instance->raw, &view(), out); });
    if (wrong.empty() && nodes < 2) return told("count", say::kFewNodes());
    return wrong;
  }

  std::string strand_line() {
    const auto* t = table<swage_strand_line>(SWAGE_TRAIT_STRAND_LINE);
    if (t == nullptr) return "";
    if (t->line == nullptr) return say::kGaps(SWAGE_TRAIT_STRAND_LINE);
    const auto* strand = table<swage_strand>(SWAGE_TRAIT_STRAND);
    swage_strand_law law{};
    if (strand == nullptr || strand->law(slot_.instance->raw, &view(), &law) != SWAGE_OK) return say::kLineAlone(SWAGE_TRAIT_STRAND);
    for (const uint32_t n : {2u, 3u, 17u, 100u}) {
      std::vector<double> p(3 * n + 1, 7.0);
      std::vector<uint32_t> parted(n + 1, 7u);
      if (t->line(slot_.instance->raw, &view(), n, p.data(), parted.data()) != SWAGE_OK) return told("line", say::kLineFails());
      if (p.back() != 7.0 || parted.back() != 7u) return told("line", say::kBeyond());
      for (uint32_t i = 0; i < n; ++i) {
        swage_strand_place place{};
        strand->place(slot_.instance->raw, &view(), law.length * i / (n - 1), &place);
        const double away = std::hypot(place.p_W.x - p[3 * i], place.p_W.y - p[3 * i + 1], place.p_W.z - p[3 * i + 2]);
        if (!(away <= 1e-9 * law.length) || parted[i] != place.parted) return told("line", say::kOtherPlaces());
      }
    }
    return "";
  }

  std::string blades() {
    const auto* t = table<swage_blades>(SWAGE_TRAIT_BLADES);
    if (t == nullptr) return "";
    if (t->law == nullptr) return say::kGaps(SWAGE_TRAIT_BLADES);
    swage_blades_law law;
    std::string wrong = twice("law", law, [&](auto* out) { return t->law(slot_.instance->raw, &view(), out); });
    if (wrong.empty() && !at_least_0(law.shear)) return told("law", say::kShear());
    return wrong;
  }

  // the last test, because it cuts the object
  std::string cuttable() {
    const auto* t = table<swage_cuttable>(SWAGE_TRAIT_CUTTABLE);
    if (t == nullptr) return "";
    const auto* strand = table<swage_strand>(SWAGE_TRAIT_STRAND);
    if (t->cut == nullptr) return say::kGaps(SWAGE_TRAIT_CUTTABLE);
    swage_strand_law law{};
    if (strand == nullptr || strand->law(slot_.instance->raw, &view(), &law) != SWAGE_OK)
      return say::kNoStrand(SWAGE_TRAIT_STRAND);
    const double s = random_.uniform(0.2, 0.8) * law.length;
    if (t->cut(slot_.instance->raw, &view(), s) != SWAGE_OK) return told("cut", say::kCutFails());
    if (std::string wrong = scene_.run(10); !wrong.empty()) return wrong;
    swage_strand_place place{};
    if (strand->place(slot_.instance->raw, &view(), s, &place) != SWAGE_OK || place.parted == 0)
      return told("cut", say::kStaysWhole());
    return "";
  }

  Stepped& scene_;
  host::ObjectSlot& slot_;
  base::Xoshiro256 random_;
  swage_object_step view_{};
  swage_input input_{{{0, 0, 0}, {1, 0, 0, 0}}, 0, 0, 0, 0};
  int asked_ = 0;
};

}  // namespace

Finding traits(const TestScene& scene, uint64_t seed) {
  Stepped s;
  std::string error;
  if (!scene.make({}, s, error)) return {Mark::kFailed, error};
  if (std::string wrong = s.run(10); !wrong.empty()) return {Mark::kFailed, wrong};
  Traits traits(s, scene.subject({}), seed);
  if (std::string wrong = traits.check(); !wrong.empty()) return {Mark::kFailed, wrong};
  return traits.asked() > 0 ? Finding{} : Finding{Mark::kSkipped, say::kNoFunctions()};
}

}  // namespace swage::tools
