// SPDX-License-Identifier: Apache-2.0
//
// An island whose unknowns are the displacements d of its blocks: H step = -F, dense. [rt]; built on [main].
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/island.hpp"
#include "dynamics/space.hpp"

namespace swage::dynamics {

class DisplacementSpace final : public Space {
 public:
  explicit DisplacementSpace(uint32_t max_unknowns);

  size_t begin(const Island& island) noexcept override;
  bool start(double* d) noexcept override;
  void displace(const double* d) noexcept override;
  void residual(const double* d) noexcept override;
  double merit() noexcept override;
  bool search_direction(const double* d, bool same, double* step) noexcept override;
  int sign() const noexcept override;
  void set_search_direction(const double* step) noexcept override;
  double slope(const double* d, const double* step) noexcept override;
  double length(const double* step) noexcept override;
  double moved(const double* d) noexcept override { return length(d); }
  void finish(const double* z, double* d) noexcept override;

 private:
  const Island* island_ = nullptr;
  size_t size_ = 0;
  bool factored_ = false;  // H_ holds the factors of the last system
  std::vector<double> F_, negative_F_, H_;
  std::vector<uint32_t> pivot_;
};

}  // namespace swage::dynamics
