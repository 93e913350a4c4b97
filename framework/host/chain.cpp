// SPDX-License-Identifier: Apache-2.0
#include <swage/abi/spheres.h>

#include <algorithm>
#include <cmath>

#include "host/builder.hpp"
#include "host/c_values.hpp"
#include "host/sentences.hpp"
#include "scene/chain.hpp"
#include "snapshot/snapshot.hpp"
#include "toolkit/math.hpp"

namespace swage::host {
namespace {

using toolkit::Vec3;

// 513 vertices: 30 mm of thread at 60 um; contacts number pieces with nine bits
constexpr uint32_t kMost = 513;

Vec3 vertex(const swage_chain& c, uint32_t i) {
  return {c.p_B[3 * i], c.p_B[3 * i + 1], c.p_B[3 * i + 2]};
}

/// Fault of a chain, or "". `states`: private doubles of the instance.
std::string problem_of(const swage_chain* c, uint32_t states) {
  if (c == nullptr || (c->kind != SWAGE_CHAIN_SEGMENTS && c->kind != SWAGE_CHAIN_SPHERES)) return say::kChainKind();
  if (c->n_vertex < 2 || c->n_vertex > kMost)
    return say::kChainCount(kMost, c->n_vertex);
  if (c->p_B == nullptr || c->radius == nullptr) return say::kChainNothing();
  for (uint32_t i = 0; i < c->n_vertex; ++i) {
    if (!vertex(*c, i).allFinite()) return say::kOfVertex(i, say::kVertexNotFinite());
    if (i > 0 && vertex(*c, i) == vertex(*c, i - 1)) return say::kOfVertex(i, say::kVertexTwice());
    if (c->s != nullptr && (!std::isfinite(c->s[i]) || (i > 0 && !(c->s[i] > c->s[i - 1]))))
      return say::kOfVertex(i, say::kVertexArc());
  }
  for (uint32_t i = 0; i + 1 < c->n_vertex; ++i)
    if (!std::isfinite(c->radius[i]) || c->radius[i] < 0)
      return say::kPieceRadius(i);
  if (!positive(c->bend_radius)) return say::kChainBend();
  const uint32_t n = scene::chain_doubles(c->n_vertex);
  if (c->state > states || n > states - c->state)
    return say::kChainState(n);
  return "";
}

scene::ChainInfo info_of(const swage_chain& c) {
  scene::ChainInfo info;
  info.bend_radius = c.bend_radius;
  info.radius.assign(c.radius, c.radius + c.n_vertex - 1);
  info.radius.push_back(0);
  double s = 0;
  for (uint32_t i = 0; i < c.n_vertex; ++i) {
    const Vec3 p = vertex(c, i);
    if (i > 0) s += (p - vertex(c, i - 1)).norm();
    info.start.push_back(toolkit::raw(p));
    info.s.push_back(c.s != nullptr ? c.s[i] : s);
  }
  return info;
}

}  // namespace

struct ChainCalls {
  static uint32_t declare(swage_builder* raw, uint32_t body, const swage_chain* chain, uint32_t flags) {
    Builder& b = *static_cast<Builder*>(raw->host_data);
    if (!b.owns_body(body, "A chain")) return scene::kNone;
    if (b.world_.body[b.body.first + body].motion != SWAGE_MOTION_FLEXIBLE)
      return b.refuse(say::kChainBody());
    if (const std::string wrong = problem_of(chain, b.state.count); !wrong.empty()) return b.refuse(wrong);
    size_t drawn = b.world_.particle_mass.size() + chain->n_vertex;
    for (const scene::ChainInfo& other : b.world_.chain) drawn += other.start.size();
    if (!b.fits(drawn, snapshot::kMaxParticles, "particles and vertices of chains")) return scene::kNone;

    scene::ChainInfo info = info_of(*chain);
    info.state = b.state.first + chain->state;
    scene::Shape shape;
    shape.kind = SWAGE_SHAPE_CHAIN;
    shape.X_BS = toolkit::Pose().abi();
    shape.radius = *std::max_element(info.radius.begin(), info.radius.end());
    shape.chain = static_cast<uint32_t>(b.world_.chain.size());
    for (const swage_vec3& p : info.start)
      shape.bounding_radius = std::max(shape.bounding_radius, toolkit::vec(p).norm() + shape.radius);
    const uint32_t index = b.add_shape(body, shape, flags);
    if (index == scene::kNone) return index;
    b.world_.chain.push_back(std::move(info));
    if (chain->kind == SWAGE_CHAIN_SPHERES) b.world_.shape.back().flags |= scene::kChainOfSpheres;
    return index;
  }
};

const swage_host_chain& chain_table() {
  static constexpr swage_host_chain table{ChainCalls::declare};
  return table;
}

}  // namespace swage::host
