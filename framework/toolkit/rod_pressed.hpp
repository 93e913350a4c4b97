// SPDX-License-Identifier: Apache-2.0
//
// A rod that is pressed together may buckle within a step. The linear step is then A = M/h^2 + K with a K that is not positive; where its negative
// part nearly balances the inertia, A can still be factored and answers small forces with large ways: 87 mm of a thread of 30 mm.
//
// A straight rod under a load P that is bent by a wave of number k resists with E I k^4 - P k^2 + m/h^2 per length (Timoshenko and Gere, Theory of
// Elastic Stability, 2.1, with inertia in the place of a foundation), least where k^2 = P / (2 E I): m/h^2 - P^2 / (4 E I). Below
// P = 2 sqrt((1 - c) E I m) / h it keeps the share c of its inertia against every wave; a free end gives way at half of that (Hetenyi, Beams on Elastic
// Foundation, 1946). Below that half nothing is looked at. Beyond, A - c M/h^2 is factored.
// Header-only, part of rod.hpp. Threads: [rt].
#pragma once

#include <algorithm>
#include <cmath>

#include "toolkit/rod.hpp"

namespace swage::toolkit {

/// Share of the inertia that A keeps against every displacement. Smaller: forces move a pressed rod by up to 1 / c as far as a free mass. Greater: a
/// rod that buckles slowly counts as stretched, and stays straight.
inline constexpr double kRodKeeps = 0.1;

/// True where an edge is pressed so hard that the step might buckle.
inline bool Rod::pressed() const {
  if (!(m_hh_ > 0)) return false;
  const double most = std::sqrt((1 - kRodKeeps) * section_.bending * section_.mass * m_hh_);  // N
  for (const double T : tension_)
    if (T < -most) return true;
  return false;
}

/// Whether the system in `columns` keeps that share of its inertia.
inline bool Rod::keeps_inertia(const double* columns) {
  std::copy_n(columns, at(unknowns()) * Matrix::kStride, tried_.column(0));
  tried_.clear_beyond();
  for (int i = 0; i < n_; ++i)
    for (int r = 0; held_[at(i)] == 0 && r < 3; ++r) tried_.column(4 * i + r)[0] -= kRodKeeps * mass_[at(i)] * m_hh_;
  return tried_.factor();
}

inline void Rod::count_as_stretched() {
  for (double& T : tension_) T = std::abs(T);
}

/// Stiffens a pressed system until it keeps that share, by the means of factor() and in their order: rotations, then compressed edges.
inline void Rod::stiffen_pressed(const RodState& s, const RodLoad& load, double* columns) {
  if (keeps_inertia(columns)) return;
  if (!slow_) {
    slow_ = true;
    slow_turns(s, columns);
    if (keeps_inertia(columns)) return;
  }
  count_as_stretched();
  system(s, load, columns);
  slow_turns(s, columns);
}

}  // namespace swage::toolkit
