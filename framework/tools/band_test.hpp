// SPDX-License-Identifier: Apache-2.0
//
// Test of the contract of swage.object.band/1 (abi/band.h): the table alone, compared with the solver of the same object.
#pragma once

#include <swage/abi/band.h>

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "host/instance.hpp"
#include "scene/world.hpp"

namespace swage::tools {

/// Contact points for a solver; `place` is used only for an object with chains.
struct SolverPoints {
  std::vector<swage_contact_point> point;
  std::vector<swage_chain_place> place;
  uint32_t size() const { return static_cast<uint32_t>(point.size()); }
  bool empty() const { return point.empty(); }
};

/// Result of a solver for some points.
struct SolverAnswer {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::VectorXd v_free;
  Matrix W;
  bool operator==(const SolverAnswer& other) const { return v_free == other.v_free && W == other.W; }
};

/// A band after advance() of its object, with the object's data and the way to call it.
struct BandAsk {
  const swage_band& table;
  scene::World& world;
  uint32_t chain;  // index in the world
  const SolverPoints& points;
  const SolverAnswer& all;  // for `points`
  uint64_t seed;
  std::function<swage_instance*()> raw;
  std::function<const swage_object_step*()> view;
  /// "" or why the instance is in quarantine.
  std::function<std::string(host::Call, const std::function<swage_result()>&)> call;
};

/// "" or the fault. Tests that results are finite and equal the solver's, and that displace() applies the change. Restores the world.
std::string check_band(BandAsk& ask);

}  // namespace swage::tools
