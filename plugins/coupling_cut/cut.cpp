// SPDX-License-Identifier: Apache-2.0
#include "cut.hpp"

#include <algorithm>

#include "toolkit/math.hpp"

namespace swage::coupling_cut {

using toolkit::vec;
using toolkit::Vec3;

namespace {

// rad: after a cut, blades count as open once they have opened by this, 0.2 mm at 10 mm. Without it they would cut the material beside
// the cut in each step in which they stay closed.
constexpr double kOpens = 0.02;

}  // namespace

double Shear::force() const { return std::max(0.0, std::min(left, right)); }

void Cut::build(const CutParams& params, CouplingBuilder& builder) {
  params_ = params;
  builder.state<CutState>();
  force_ = builder.signal("cut.force", "N", "With which both blades press on the thread: that of the one that presses less.");
  cuts_ = builder.signal("cut.cuts", "1", "How often the thread was cut so far.");
  parted_ = builder.event("cut.parted", "The blades have cut the thread; value: where, m from its first end.");
}

void Cut::bind(const Peer& a, const Peer& b) {
  jaws_ = a;
  blades_ = BladesPeer(a), thread_ = StrandPeer(b), cuttable_ = CuttablePeer(b);
  if (!blades_.valid()) return refuse("the jaws have no table of " SWAGE_TRAIT_BLADES);
  if (!thread_.valid() || !cuttable_.valid()) refuse("the thread has no table of " SWAGE_TRAIT_STRAND " or of " SWAGE_TRAIT_CUTTABLE);
}

void Cut::resolve(const CouplingStep& step) {
  for (swage_contact& contact : step.contacts()) {
    contact.friction = params_.friction;
    contact.stiffness = params_.stiffness;
    contact.restitution = 0;
  }
}

/// Sums the force with which each blade presses, and the place.
bool Cut::gather(const CouplingStep& step, Shear& shear) const {
  const auto jaws = jaws_.describe(step.a());
  if (!jaws) return false;
  const Vec3 closing = vec(jaws->closing_W);
  shear.opening = jaws->opening;
  for (const swage_contact& contact : step.contacts()) {
    const Vec3 f = vec(contact.f_a_W);  // on the blade
    const double normal = f.dot(vec(contact.n_W));
    if (!(normal > 0)) continue;
    if (contact.body_a == jaws->left_body)
      shear.left += f.dot(closing);
    else if (contact.body_a == jaws->right_body)
      shear.right -= f.dot(closing);
    else
      continue;
    const auto place = thread_.nearest(step.b(), contact.p_W);
    if (!place) return false;
    shear.weight += normal, shear.s += normal * place->s;
  }
  if (shear.weight > 0) shear.s /= shear.weight;
  return true;
}

void Cut::finish(const CouplingStep& step) {
  const auto law = thread_.law(step.b());
  const auto blades = blades_.law(step.a());
  Shear shear;
  if (!law || !blades || !gather(step, shear)) return discard();
  auto& state = step.state<CutState>();
  const double parts = blades->shear * law->strength, force = shear.force();
  if (shear.opening > state.opening + kOpens) state.closed = 0;
  if (parts > 0 && force >= parts && state.closed == 0) {
    const auto place = thread_.place(step.b(), shear.s);
    if (!place || (place->parted == 0 && !cuttable_.cut(step.b(), shear.s))) return discard();
    state.closed = 1, state.opening = shear.opening;
    state.cuts += place->parted == 0 ? 1 : 0;
    if (place->parted == 0) step.event(parted_, shear.s);
  }
  step.signal(force_, force);
  step.signal(cuts_, state.cuts);
}

}  // namespace swage::coupling_cut

SWAGE_EXPORT(swage::coupling_cut::Cut)
