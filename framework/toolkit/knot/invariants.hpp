// SPDX-License-Identifier: Apache-2.0
//
// Determinant and signature of a knot, from its diagram: the form of Gordon and Litherland (1978) on the two surfaces of its chessboard
// colouring, which must agree. Exact. A half knot has 3 and -+2, a square knot 9 and 0, a granny 9 and -+4; a positive knot has a
// negative signature. Header-only.
//
// Threads: [rt], nothing allocates.
#pragma once

#include "toolkit/knot/faces.hpp"
#include "toolkit/knot/grid.hpp"

namespace swage::toolkit {

struct KnotInvariants {
  bool known = false;  // false: too many crossings, or a code that no diagram in the plane has
  int64_t determinant = 1;
  int signature = 0;
  bool operator==(const KnotInvariants&) const = default;
};

/// Size of the determinant and signature of a symmetric matrix of whole numbers, by elimination without fractions (Bareiss).
template <int N>
struct WholeForm {
  std::array<std::array<Wide, N>, N> m{};
  int n = 0;

  bool eliminate(int64_t& determinant, int& signature) {
    Wide before = 1;
    signature = 0;
    for (int k = 0; k < n; ++k) {
      if (!find_pivot(k)) return false;
      const Wide pivot = m[at(k)][at(k)];
      for (int i = k + 1; i < n; ++i)
        for (int j = k + 1; j < n; ++j)
          m[at(i)][at(j)] = (pivot * m[at(i)][at(j)] - m[at(i)][at(k)] * m[at(k)][at(j)]) / before;
      signature += sign_of(pivot) * sign_of(before);
      before = pivot;
    }
    determinant = static_cast<int64_t>(before < 0 ? -before : before);
    return true;
  }

 private:
  static size_t at(int i) { return static_cast<size_t>(i); }
  /// Brings a number other than 0 to the diagonal at k, by the same change of rows and columns.
  bool find_pivot(int k) {
    for (int i = k; i < n; ++i)
      if (m[at(i)][at(i)] != 0) return swap(k, i), true;
    for (int i = k; i < n; ++i)
      for (int j = k; j < n; ++j) {
        if (m[at(i)][at(j)] == 0) continue;
        for (int l = k; l < n; ++l) m[at(i)][at(l)] += m[at(j)][at(l)];
        for (int l = k; l < n; ++l) m[at(l)][at(i)] += m[at(l)][at(j)];
        return swap(k, i), true;
      }
    return false;
  }
  void swap(int a, int b) {
    std::swap(m[at(a)], m[at(b)]);
    for (auto& row : m) std::swap(row[at(a)], row[at(b)]);
  }
};

class KnotSurface {
 public:
  static constexpr int kCrossings = 40;  // determinants stay below 2^63, products of two of them below 2^127

  static KnotInvariants invariants(const KnotDiagram& diagram) {
    if (diagram.crossings() == 0) return {true, 1, 0};
    if (diagram.crossings() > kCrossings) return {};
    KnotSurface work(diagram);
    if (!work.faces_.find(work.d_) || !work.colour()) return {};
    const KnotInvariants one = work.form(0), other = work.form(1);
    return one == other ? one : KnotInvariants{};
  }

 private:
  static constexpr int kFaces = kCrossings + 2;
  static size_t at(int i) { return static_cast<size_t>(i); }

  explicit KnotSurface(const KnotDiagram& d) : d_(d), n_(d.visits()) { d_.number_anew(); }

  /// Colours the faces so that the two sides of each arc differ. False where that is impossible.
  bool colour() {
    colour_.fill(-1);
    colour_[0] = 0;
    for (int pass = 0; pass < faces_.count(); ++pass)
      for (int i = 0; i < n_; ++i) {
        int &l = colour_[at(faces_.left(i))], &r = colour_[at(faces_.right(i))];
        if (l >= 0 && r < 0) r = 1 - l;
        if (r >= 0 && l < 0) l = 1 - r;
        if (l >= 0 && l == r) return false;
      }
    return true;
  }
  /// The form on the faces of one colour, less one; the surface consists of the other faces. With the upper strand going east, a left
  /// rotation of it onto the other strand sweeps the corners in the north-east and south-west. Where both strands run along the surface's
  /// band in the same direction, the crossing counts in the correction.
  KnotInvariants form(int colour) {
    std::array<int, kFaces> row{};
    int rows = 0, correction = 0;
    for (int f = 0; f < faces_.count(); ++f) row[at(f)] = colour_[at(f)] == colour ? rows++ : -1;
    for (auto& line : form_.m) line.fill(0);
    for (int k = 0; k < n_ / 2; ++k) {
      const int out = d_.place(k, true), in = (out + n_ - 1) % n_;
      const int ne = faces_.left(out), se = faces_.right(out), nw = faces_.left(in), sw = faces_.right(in);
      const bool surface_ne = colour_[at(ne)] != colour;
      const int eta = surface_ne ? 1 : -1;
      if (eta == d_.sign(k)) correction += eta;
      const size_t a = at(row[at(surface_ne ? nw : ne)]), b = at(row[at(surface_ne ? se : sw)]);
      if (a == b) continue;
      form_.m[a][b] -= eta, form_.m[b][a] -= eta, form_.m[a][a] += eta, form_.m[b][b] += eta;
    }
    form_.n = rows - 1;
    KnotInvariants out;
    out.known = form_.eliminate(out.determinant, out.signature);
    out.signature -= correction;
    return out;
  }

  KnotDiagram d_;
  int n_ = 0;
  KnotFaces faces_;
  std::array<int, kFaces> colour_{};
  WholeForm<kFaces> form_;
};

}  // namespace swage::toolkit
