// SPDX-License-Identifier: Apache-2.0
#include "leash.hpp"

#include "toolkit/math.hpp"

namespace swage::test {

using toolkit::Pose;
using toolkit::raw;
using toolkit::vec;
using toolkit::Vec3;

void Leash::resolve(const swage::CouplingStep& step) {
  for (swage_contact& contact : step.contacts()) contact.stiffness = contact.friction = 0;
}

// [rt] one tie per place: how far it is stretched at the poses of now
uint32_t Leash::ties(const swage::CouplingStep& step, std::span<swage_tie> out) {
  const Pose X_WA(step.a()->X_WB[0]), X_WB(step.b()->X_WB[0]);
  State& state = step.state<State>();
  if (!(params().stiffness > 0)) {  // let go: taken hold of again, it is at rest as it then stands
    state.known = 0;
    return 0;
  }
  if (state.known == 0) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 p_B = params().arm * Vec3::Unit(i);
      state.p_B[i] = raw(p_B);
      state.p_A[i] = raw(X_WA.inverse() * (X_WB * p_B));
    }
    state.known = 1;
  }
  for (uint32_t i = 0; i < 3; ++i) {
    const Vec3 p_a = X_WA * vec(state.p_A[i]), p_b = X_WB * vec(state.p_B[i]);
    swage_tie& tie = out[i];
    tie = {};
    tie.body_a = tie.body_b = 0;
    tie.p_W = raw(p_a);
    tie.axis_W = raw(X_WB.q * Vec3::Unit(i));
    tie.offset_W = raw(Vec3(p_a - p_b));
    tie.stiffness_across = tie.stiffness_along = params().stiffness;
    tie.strength = tie.forward_limit = tie.backward_limit = params().strength > 0 ? params().strength : HUGE_VAL;
  }
  return 3;
}

// [rt] what a tie gave up is where it is at rest from now on
void Leash::on_solved(const swage::CouplingStep& step, std::span<const swage_tie> ties) {
  const Pose X_WB(step.b()->X_WB[0]);
  State& state = step.state<State>();
  for (size_t i = 0; i < ties.size(); ++i) {
    const Vec3 slid_B = X_WB.q.conjugate() * vec(ties[i].plastic_slip_W);
    state.p_B[i] = raw(Vec3(vec(state.p_B[i]) + slid_B));
  }
}

}  // namespace swage::test

SWAGE_EXPORT(swage::test::Leash)
