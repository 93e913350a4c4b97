// SPDX-License-Identifier: Apache-2.0
#include "step/chain_watch.hpp"

#include <algorithm>

#include "scene/chain.hpp"
#include "toolkit/rod_passage.hpp"

namespace swage::step {

using toolkit::Vec3;

namespace {

/// In radii of the chain: overlap with something that it met unseen. Smaller: steps are divided for overlaps by chance. 2: has passed.
constexpr double kDeep = 0.5;

}  // namespace

ChainWatch::ChainWatch(scene::World& world, contact::Detector& detector) : world_(world), detector_(detector) {
  std::size_t n = 0, most = 0;
  for (const scene::ChainInfo& chain : world.chain) n += 3 * chain.start.size(), most = std::max(most, chain.start.size());
  if (n == 0) return;
  for (std::vector<double>* p : {&p_begun_, &p_looked_, &v_}) p->resize(n);
  boxes_.resize(toolkit::room_for_passages(static_cast<int>(most)));
  alone_.assign(world.chain.size(), 1);
  for (const scene::Shape& shape : world.shape)
    for (const contact::Pair& pair : detector.pairs())
      if ((shape.flags & scene::kChainOfSpheres) == 0 && shape.chain != scene::kNone && pair.object_a == shape.object && pair.object_b == shape.object) alone_[shape.chain] = 0;
  V_.reserve(world.V_WB.size());
  detector_.reserve(on_the_way_);
}

void ChainWatch::copy_to(std::vector<double>& p) const noexcept {
  double* to = p.data();
  for (const scene::ChainInfo& chain : world_.chain)
    to = std::copy_n(world_.plugin_state.data() + chain.state, 3 * chain.start.size(), to);
}

bool ChainWatch::met_unseen(const contact::ContactSet& known) noexcept {
  if (!went_far()) return false;
  look_along_the_way();
  return std::any_of(on_the_way_.contact.begin(), on_the_way_.contact.end(),
                     [&](const contact::Contact& met) { return unseen(met, known); });
}

bool ChainWatch::passed_itself() noexcept {
  const double* from = p_begun_.data();
  for (std::size_t c = 0; c < world_.chain.size(); ++c) {
    const scene::ChainInfo& info = world_.chain[c];
    const scene::ChainView chain(world_, info);
    const int n = static_cast<int>(info.start.size());
    const double* to = world_.plugin_state.data() + info.state;
    const auto there = [&](int j) { return chain.radius(static_cast<std::size_t>(j)) > 0; };
    if (alone_[c] == 0 && toolkit::may_have_passed(n, from, to, chain.radius(0)) && toolkit::passages(n, from, to, there, boxes_) > 0)
      return true;
    from += 3 * info.start.size();
  }
  return false;
}

/// True when a vertex is farther than the radius from where contacts were detected.
bool ChainWatch::went_far() const noexcept {
  const double* from = p_looked_.data();
  for (const scene::ChainInfo& info : world_.chain) {
    const scene::ChainView chain(world_, info);
    const double far = chain.radius(0) * chain.radius(0);
    for (std::size_t i = 0; i < info.start.size(); ++i, from += 3)
      if ((chain.p(i) - Eigen::Map<const Vec3>(from)).squaredNorm() > far) return true;
  }
  return false;
}

/// Detects the contacts of chains that come from p_looked_, among resting bodies, and then restores all velocities.
void ChainWatch::look_along_the_way() noexcept {
  V_ = world_.V_WB;
  std::fill(world_.V_WB.begin(), world_.V_WB.end(), swage_twist{});
  std::size_t at = 0;
  for (const scene::ChainInfo& chain : world_.chain) {
    const std::size_t n = 3 * chain.start.size();
    double *p = world_.plugin_state.data() + chain.state, *v = p + n;
    for (std::size_t i = 0; i < n; ++i, ++at) v_[at] = v[i], v[i] = (p[i] - p_looked_[at]) / world_.dt;
  }
  on_the_way_.contact.clear(), on_the_way_.candidate.clear(), on_the_way_.of_pair.clear();
  detector_.detect(world_, on_the_way_);
  const double* from = v_.data();
  for (const scene::ChainInfo& chain : world_.chain) {
    const std::size_t n = 3 * chain.start.size();
    std::copy_n(from, n, world_.plugin_state.data() + chain.state + n);
    from += n;
  }
  world_.V_WB = V_;
}

/// True when no known contact is with the same shape at that piece or a neighbour. Left out are bodies that their object moves, and pairs
/// of which a coupling lets the chain pass somewhere: tissue with a thread in it.
bool ChainWatch::unseen(const contact::Contact& met, const contact::ContactSet& known) const noexcept {
  const bool a = met.place_a.segment != scene::kNone, b = met.place_b.segment != scene::kNone;
  const auto itself = [&](uint32_t body, bool chain) { return !chain && world_.body[body].motion == SWAGE_MOTION_FLEXIBLE; };
  if ((!a && !b) || itself(met.body_a, a) || itself(met.body_b, b)) return false;
  if (met.gap > -kDeep * world_.shape[a ? met.shape_a : met.shape_b].radius) return false;
  const auto beside = [](uint32_t i, uint32_t j) { return i == j || i + 1 == j || i == j + 1; };
  return std::none_of(known.contact.begin(), known.contact.end(), [&](const contact::Contact& c) {
    if (c.pair == met.pair && !(c.law.stiffness > 0)) return true;
    return c.shape_a == met.shape_a && c.shape_b == met.shape_b && (!a || beside(c.place_a.segment, met.place_a.segment)) &&
           (!b || beside(c.place_b.segment, met.place_b.segment));
  });
}

}  // namespace swage::step
