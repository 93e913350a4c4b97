// SPDX-License-Identifier: Apache-2.0
#include "@FILE@.hpp"

// [main] everything the coupling will ever own
void @NAME@::build(const @NAME@Params&, Builder& builder) {
  builder.state<State>();
  force_ = builder.signal("touch.force", "N", "Sum of the normal forces between the two.");
  began_ = builder.event("touch.began", "They touch.");
  ended_ = builder.event("touch.ended", "They touch no more.");
}

// [rt] the contacts are known and not yet solved: here their law may be changed
void @NAME@::resolve(const swage::CouplingStep& step) {
  for (swage_contact& contact : step.contacts()) {
    contact.friction = params().friction;
    contact.stiffness = params().stiffness;
  }
}

// [rt] the contacts are solved: their forces are known
void @NAME@::finish(const swage::CouplingStep& step) {
  double force = 0;
  for (const swage_contact& contact : step.contacts()) {
    const swage_vec3 &f = contact.f_a_W, &n = contact.n_W;
    force += f.x * n.x + f.y * n.y + f.z * n.z;
  }
  step.signal(force_, force);

  State& state = step.state<State>();
  const bool touching = force > 0;
  if (touching && state.touching == 0) step.event(began_, force);
  if (!touching && state.touching != 0) step.event(ended_);
  state.touching = touching ? 1 : 0;
}

// [rt] before the first step and whenever the trainee starts again
void @NAME@::reset(const swage::CouplingStep& step) { step.state<State>().touching = 0; }

SWAGE_EXPORT(@NAME@)
