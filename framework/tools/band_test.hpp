// SPDX-License-Identifier: Apache-2.0
//
// The contract of swage.object.band/1 (abi/band.h), asked of the table alone, beside what the solver of the same object answers.
#pragma once

#include <swage/abi/band.h>

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "host/instance.hpp"
#include "scene/world.hpp"

namespace swage::tools {

/// Places that a solver is asked about; where on a chain they are only of an object with chains.
struct SolverPoints {
  std::vector<swage_contact_point> point;
  std::vector<swage_chain_place> place;
  uint32_t size() const { return static_cast<uint32_t>(point.size()); }
  bool empty() const { return point.empty(); }
};

/// What a solver answers for some points.
struct SolverAnswer {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::VectorXd v_free;
  Matrix W;
  bool operator==(const SolverAnswer& other) const { return v_free == other.v_free && W == other.W; }
};

/// A band after advance() of its object, what is known of the object, and how it is called.
struct BandAsk {
  const swage_band& table;
  scene::World& world;
  uint32_t chain;  // index in the world
  const SolverPoints& points;
  const SolverAnswer& all;  // of the points
  uint64_t seed;
  std::function<swage_instance*()> raw;
  std::function<const swage_object_step*()> view;
  /// "" or why the instance is in quarantine.
  std::function<std::string(host::Call, const std::function<swage_result()>&)> call;
};

/// "" or what is wrong: the answers are finite and those of the solver, and displace() goes where the change says. The world is as it was.
std::string check_band(BandAsk& ask);

}  // namespace swage::tools
