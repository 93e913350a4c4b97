// SPDX-License-Identifier: Apache-2.0
//
// Where on the thread something is, and is cut: the traits graspable, strand and cuttable.
#include <algorithm>
#include <cmath>

#include "thread.hpp"

namespace swage::thread {

using toolkit::raw;
using toolkit::RodState;
using toolkit::vec;
using toolkit::Vec3;

namespace {

/// Share of the edge at which arc length s lies; its nearer end for an s beyond it.
double share_of(const ChainState& chain, int edge, double s) {
  const auto j = static_cast<size_t>(edge);
  const double begin = chain.s[j], end = chain.s[j + 1];
  return std::clamp((s - begin) / (end - begin), 0.0, 1.0);
}

}  // namespace

std::pair<int, double> Thread::nearest_edge(const RodState& s, const Vec3& p_W) const {
  std::pair<int, double> found{0, 0.0};
  double nearest = HUGE_VAL;
  for (int j = 0; j < params_.segments; ++j) {
    const Vec3 a = s.node(j), e = s.edge(j);
    const double share = std::clamp((p_W - a).dot(e) / e.squaredNorm(), 0.0, 1.0),
                 away = (p_W - a - share * e).squaredNorm();
    if (away < nearest) nearest = away, found = {j, share};
  }
  return found;
}

void Thread::locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) {
  const RodState s = state(step);
  const auto [j, share] = nearest_edge(s, vec(p_W));
  out.s = params_.finer > 1 ? (s_[at(j)] + share * rod_.rest_length(j)) / params_.length : (j + share) / params_.segments;
  out.p_W = raw(Vec3(s.node(j) + share * s.edge(j)));
  out.tangent_W = raw(Vec3(s.edge(j).normalized()));
  out.normal_W = raw(s.material(j));
  out.length = params_.length;
}

const void* Thread::extension(std::string_view wanted) {
  if (wanted == SWAGE_TRAIT_CUTTABLE) return cuttable_table<Thread>();
  if (wanted == SWAGE_TRAIT_STRAND_NODES) return strand_nodes_table<Thread>();
  if (wanted == SWAGE_TRAIT_STRAND_LINE) return strand_line_table<Thread>();
  return wanted == SWAGE_TRAIT_STRAND ? strand_table<Thread>() : nullptr;
}

void Thread::strand_law(const Step&, swage_strand_law& out) {
  out = {params_.length, 0.5 * suture_.diameter, suture_.strength, suture_.pull_off};
}

void Thread::tell(const Step& step, int j, double share, swage_strand_place& out) const {
  const RodState s = state(step);
  const ChainState chain = step.chain(0, vertices());
  const Vec3 e = s.edge(j), t = e.normalized(), d = s.material(j);
  out.s = chain.s[at(j)] + share * (chain.s[at(j + 1)] - chain.s[at(j)]);
  out.tension = rod_.linear_tension(j);
  out.p_W = raw(Vec3(s.node(j) + share * e));
  out.tangent_W = raw(t);
  out.normal_W = raw(Vec3((d - d.dot(t) * t).normalized()));
  out.body = 0;
  out.parted = chain.radius[at(j)] == 0 ? 1 : 0;
}

int Thread::edge_at(const Step& step, double s) const {
  const auto all = step.chain(0, vertices()).s;
  const auto above = std::upper_bound(all.begin() + 1, all.end() - 1, s);
  return static_cast<int>(above - all.begin()) - 1;
}

/// The whole segment bears nothing any more.
void Thread::cut(const Step& step, double s) { step.chain(0, vertices()).radius[at(edge_at(step, s))] = 0; }

void Thread::strand_place(const Step& step, double s, swage_strand_place& out) {
  const int j = edge_at(step, s);
  tell(step, j, share_of(step.chain(0, vertices()), j, s), out);
}

void Thread::strand_line(const Step& step, std::span<double> p_W, std::span<uint32_t> parted) {
  const RodState state = this->state(step);
  const ChainState chain = step.chain(0, vertices());
  const int last = static_cast<int>(chain.s.size()) - 2, n = static_cast<int>(parted.size());
  for (int i = 0, j = 0; i < n; ++i) {
    const double s = params_.length * i / (n - 1);
    while (j < last && !(s < chain.s[at(j + 1)])) ++j;
    Eigen::Map<Vec3>(p_W.data() + 3 * i) = state.node(j) + share_of(chain, j, s) * state.edge(j);
    parted[at(i)] = chain.radius[at(j)] == 0 ? 1 : 0;
  }
}

void Thread::strand_nearest(const Step& step, swage_vec3 p_W, swage_strand_place& out) {
  const auto [j, share] = nearest_edge(state(step), vec(p_W));
  tell(step, j, share, out);
}

}  // namespace swage::thread
