// SPDX-License-Identifier: Apache-2.0
//
// A random system of a thread and a body, sparse and dense.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>
#include <vector>

#include "dynamics/banded_assembly.hpp"

namespace swage::dynamics {
namespace banded_blocks_test {

using toolkit::Mat3;
using toolkit::Vec3;

/// A thread of n nodes with one rigid body, contacts between both and of the thread with itself; and the same densely. `early`: blocks
/// that no contact touches have been eliminated before the contacts were added.
struct Knot {
  struct Contact {
    BlockPoint a, b;
    Mat3 D;
  };
  Knot(uint32_t n, uint32_t contacts, bool symmetric, unsigned seed, bool early = false)
      : random(seed), band(static_cast<int>(4 * n - 1)), blocks(n + 2, 4 * n * 16) {
    for (int j = 0; j < band.size(); ++j)
      for (int i = j; i < std::min(band.size(), j / 4 * 4 + 11); ++i)
        band.at(i, j) = i == j ? 12 + any(random) : any(random);
    std::vector<BandedBlocks::Pair> pairs;
    for (uint32_t i = 0; i < n; ++i)
      for (uint32_t k = 1; k < 3 && i + k < n; ++k) pairs.push_back({i + k, i});
    pairs.push_back({n, n + 1});
    const int size = static_cast<int>(4 * n + 8);
    dense = Eigen::MatrixXd::Zero(size, size);
    for (int j = 0; j < band.size(); ++j)
      for (int i = j; i < std::min(band.size(), j + 11); ++i) dense(i, j) = dense(j, i) = band.at(i, j);
    for (const int idle :
         {static_cast<int>(4 * n - 1), static_cast<int>(4 * n + 3), static_cast<int>(4 * n + 7)})
      dense(idle, idle) = 1;
    for (uint32_t k = 0; k < contacts; ++k) {
      Contact c;
      const auto node = [&] { return static_cast<uint32_t>(random() % (n - 1)); };
      c.a = thread_point(0, node(), 0.3, Vec3::UnitX(), Vec3(0, 0.1, 0));
      if (k % 3 == 0) c.b = body_point(n, Vec3(any(random), any(random), 1));
      if (k % 3 == 1) c.b = thread_point(0, node(), 0.6, Vec3::UnitY(), Vec3(0.1, 0, 0.2));
      c.D = Mat3::Identity() * 3;
      if (!symmetric) c.D(1, 0) = 0.9;
      for (const BlockPoint* p : {&c.a, &c.b})
        for (uint32_t i = 0; i < p->size; ++i)
          for (const BlockPoint* q : {&c.a, &c.b})
            for (uint32_t j = 0; j < q->size; ++j) pairs.push_back({p->block[i], q->block[j]});
      dense += rows(c).transpose() * c.D * rows(c);
      all.push_back(c);
    }
    std::vector<uint8_t> late(early ? n + 2 : 0);
    for (const Contact& c : all)
      for (const BlockPoint* p : {&c.a, &c.b})
        for (uint32_t i = 0; early && i < p->size; ++i) late[p->block[i]] = 1;
    EXPECT_TRUE(blocks.analyse(n + 2, pairs, late));
    blocks.set_zero(symmetric || early);
    add_band(blocks, 0, band, symmetric || early);
    BandedBlocks::Block body = BandedBlocks::Block::Identity();
    body.topLeftCorner<3, 3>() *= 2;
    for (uint32_t k = 0; k < 2; ++k) {
      blocks.add(n + k, n + k, body);
      for (int r = 0; r < 3; ++r)
        dense(static_cast<int>(4 * (n + k)) + r, static_cast<int>(4 * (n + k)) + r) += 2;
    }
    if (early) {
      EXPECT_TRUE(blocks.factor_early());
      // a direction with other stiffnesses, then that which is asked for
      blocks.take_late(!symmetric);
      for (const Contact& c : all) add_contact(blocks, c.a, c.b, 7 * Mat3::Identity(), !symmetric);
      EXPECT_TRUE(blocks.factor());
      blocks.take_late(symmetric);
    }
    for (const Contact& c : all) add_contact(blocks, c.a, c.b, c.D, symmetric);
  }
  /// J of a contact.
  Eigen::MatrixXd rows(const Contact& c) const {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3, dense.cols());
    for (uint32_t i = 0; i < c.a.size; ++i) J.middleCols(4 * c.a.block[i], 4) += c.a.J[i];
    for (uint32_t i = 0; i < c.b.size; ++i) J.middleCols(4 * c.b.block[i], 4) -= c.b.J[i];
    return J;
  }
  std::vector<Contact> all;
  std::mt19937 random;
  std::uniform_real_distribution<double> any{-1, 1};
  toolkit::Band<10> band;
  BandedBlocks blocks;
  Eigen::MatrixXd dense;
};

}  // namespace banded_blocks_test
}  // namespace swage::dynamics
