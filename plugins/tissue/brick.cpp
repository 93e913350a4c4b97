// SPDX-License-Identifier: Apache-2.0
#include "brick.hpp"

#include <algorithm>

#include "elimination.hpp"

namespace swage::tissue {
namespace {

constexpr size_t kStresses = 18;
using Row = std::array<double, 24>;

/// Strain components xx yy zz xy yz zx (engineering shear) of the corners' displacements at a place in [-1, 1]^3.
std::array<Row, 6> strain(const std::array<double, 3>& at, const std::array<double, 3>& edge) {
  std::array<Row, 6> B{};
  for (size_t c = 0; c < 8; ++c) {
    const std::array<double, 3> side{c & 1 ? 1.0 : -1.0, c & 2 ? 1.0 : -1.0, c & 4 ? 1.0 : -1.0};
    std::array<double, 3> d{};
    for (size_t i = 0; i < 3; ++i) {
      const size_t j = (i + 1) % 3, k = (i + 2) % 3;
      d[i] = 0.125 * side[i] * (1 + side[j] * at[j]) * (1 + side[k] * at[k]) * 2 / edge[i];
    }
    for (size_t i = 0; i < 3; ++i) {
      const size_t j = (i + 1) % 3;
      B[i][3 * c + i] = d[i];
      B[3 + i][3 * c + i] = d[j], B[3 + i][3 * c + j] = d[i];
    }
  }
  return B;
}

/// Stresses of the eighteen modes at a place in [-1, 1]^3.
std::array<std::array<double, kStresses>, 6> stress(const std::array<double, 3>& at) {
  std::array<std::array<double, kStresses>, 6> P{};
  for (size_t i = 0; i < 3; ++i) {
    const double y = at[(i + 1) % 3], z = at[(i + 2) % 3];
    P[i][i] = 1, P[3 + i][3 + i] = 1;
    P[i][6 + 3 * i] = y, P[i][7 + 3 * i] = z, P[i][8 + 3 * i] = y * z;
    P[3 + i][15 + i] = z;  // the axis that is neither of the two of this shear
  }
  return P;
}

}  // namespace

BrickStiffness brick(const std::array<double, 3>& edge, double young, double poisson) {
  // the matrices of complementary energy and work, H and G; K = G' H^-1 G is the Schur complement of [H G; G' 0] after
  // elimination of the stresses
  Symmetric m(kStresses + 24);
  const double a = 0.57735026918962576451;  // sqrt(1/3): Gauss points, two per axis integrate all of it exactly
  const double weight = edge[0] * edge[1] * edge[2] / 8;
  for (int g = 0; g < 8; ++g) {
    const std::array<double, 3> at{g & 1 ? a : -a, g & 2 ? a : -a, g & 4 ? a : -a};
    const auto B = strain(at, edge);
    const auto P = stress(at);
    for (size_t i = 0; i < kStresses; ++i) {
      std::array<double, 6> e{};  // strain of mode i
      for (size_t c = 0; c < 3; ++c) {
        const size_t d = (c + 1) % 3, f = (c + 2) % 3;
        e[c] = (P[c][i] - poisson * (P[d][i] + P[f][i])) / young;
        e[3 + c] = 2 * (1 + poisson) * P[3 + c][i] / young;
      }
      for (size_t j = 0; j <= i; ++j)
        for (size_t c = 0; c < 6; ++c) m.row(i)[j] += weight * P[c][j] * e[c];
      for (size_t u = 0; u < 24; ++u)
        for (size_t c = 0; c < 6; ++c) m.row(kStresses + u)[i] += weight * P[c][i] * B[c][u];
    }
  }
  eliminate(m, kStresses);
  BrickStiffness K{};
  for (size_t i = 0; i < 24; ++i)
    for (size_t j = 0; j <= i; ++j) K[i][j] = K[j][i] = -m.row(kStresses + i)[kStresses + j];
  return K;
}

}  // namespace swage::tissue
