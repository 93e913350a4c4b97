// SPDX-License-Identifier: Apache-2.0
#include "@FILE@.hpp"

// [main] Declares everything that the coupling uses while the scene runs.
void @NAME@::build(const @NAME@Params&, Builder& builder) {
  builder.state<State>();
  force_ = builder.signal("touch.force", "N", "Sum of the normal forces between the two.");
  began_ = builder.event("touch.began", "They touch.");
  ended_ = builder.event("touch.ended", "They touch no more.");
}

// [rt] Called when the contacts are found and not yet solved: sets the law of each.
void @NAME@::resolve(const swage::CouplingStep& step) {
  for (swage_contact& contact : step.contacts()) {
    contact.friction = params().friction;
    contact.stiffness = params().stiffness;
  }
}

// [rt] Called when the contacts are solved and their forces known.
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

// [rt] Called before the first step and at each restart of the attempt.
void @NAME@::reset(const swage::CouplingStep& step) { step.state<State>().touching = 0; }

SWAGE_EXPORT(@NAME@)
