// SPDX-License-Identifier: Apache-2.0
#include "contact/narrow_phase.hpp"

#include <algorithm>

#include "contact/arc_arc.hpp"
#include "contact/convex_convex.hpp"
#include "contact/wire_convex.hpp"
#include "contact/wire_field.hpp"

namespace swage::contact {
namespace {

/// Turns contacts of (b, a) into contacts of (a, b).
void swap_sides(Manifold& out, const Frame& X_WB) {
  for (int i = 0; i < out.count; ++i) {
    Candidate& c = out.candidate[static_cast<size_t>(i)];
    std::swap(c.a, c.b);
    c.touch.n_W = -c.touch.n_W;
    c.n_B = X_WB.turn_back(c.touch.n_W);
  }
}

}  // namespace

Candidate* Manifold::add(double gap) {
  if (count == kCapacity) {
    ++dropped;
    const auto shallower = [](const Candidate& x, const Candidate& y) { return x.touch.gap < y.touch.gap; };
    const auto last = std::max_element(candidate.begin(), candidate.end(), shallower);
    if (!(gap < last->touch.gap)) return nullptr;
    std::move(last + 1, candidate.end(), last);
    --count;
    candidate.back() = Candidate{};
  }
  return &candidate[static_cast<size_t>(count++)];
}

int collide(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB, const Query& query,
            Separation& memory, Manifold& out) noexcept {
  out.clear();
  // bounding spheres
  const double reach = a.bound + b.bound + query.margin;
  if ((X_WA * a.centre - X_WB * b.centre).squaredNorm() > reach * reach) return 0;

  if (is_wire(a) && b.kind == SWAGE_SHAPE_HEIGHT_FIELD) {
    collide_wire_field(a, X_WA, b, X_WB, query, out);
  } else if (is_wire(b) && a.kind == SWAGE_SHAPE_HEIGHT_FIELD) {
    collide_wire_field(b, X_WB, a, X_WA, query, out);
    swap_sides(out, X_WB);
  } else if (a.kind == SWAGE_SHAPE_ARC && b.kind == SWAGE_SHAPE_ARC) {
    collide_arc_arc(a, X_WA, b, X_WB, query, out);
  } else if (is_wire(a) && has_vertices(b)) {
    collide_wire_convex(a, X_WA, b, X_WB, query, memory, out);
  } else if (is_wire(b) && has_vertices(a)) {
    collide_wire_convex(b, X_WB, a, X_WA, query, memory, out);
    swap_sides(out, X_WB);
  } else if (has_vertices(a) && has_vertices(b)) {
    collide_convex_convex(a, X_WA, b, X_WB, query, memory, out);
  }
  return out.count;
}

}  // namespace swage::contact
