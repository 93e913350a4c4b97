// SPDX-License-Identifier: Apache-2.0
//
// @ID@: an elastic strand, such as a rubber band or the loop that holds a vessel aside.
#pragma once

#include <swage/band.hpp>

#include <Eigen/Core>
#include <vector>

#include "toolkit/band.hpp"

struct @NAME@Params {
  double length = 30e-3;     // m, unloaded
  double diameter = 0.8e-3;  // m
  double modulus = 1e6;      // Pa, of silicone rubber
  double density = 1100;     // kg/m3
  double damping = 30;       // 1/s, decay rate of velocities
  int segments = 30;
  bool fixed = true;  // the first end is held
};

class @NAME@ final : public swage::BandedObject<@NAME@Params>, public swage::Solid {
 public:
  static constexpr auto id = "@ID@";
  static constexpr auto version = "0.1.0";
  static constexpr auto name = "@TITLE@";
  static constexpr auto summary = "An elastic strand that stretches, bends and touches; it does not twist.";
  static constexpr auto author = "Somebody";
  static constexpr auto licence = "Apache-2.0";

  using P = @NAME@Params;
  static constexpr std::array fields = {
      swage::real<&P::length>("length", "Length", "m", "mm", 1e-3, 0.3, "Unloaded."),
      swage::real<&P::diameter>("diameter", "Diameter", "m", "mm", 0.02e-3, 5e-3, "Of its round section."),
      swage::real<&P::modulus>("modulus", "Young's modulus", "Pa", "MPa", 1e4, 1e8, "Silicone rubber: about 1 MPa."),
      swage::real<&P::density>("density", "Density", "kg/m3", "kg/m3", 100, 10000, "Silicone rubber: 1100 kg/m3."),
      swage::real<&P::damping>("damping", "Damping", "Hz", "Hz", 0, 1000, "Rate at which a speed dies away: at 10 Hz a third of it is left after 0.1 s."),
      swage::integer<&P::segments>("segments", "Segments", 2, 200, "Straight pieces."),
      swage::boolean<&P::fixed>("fixed", "First end fixed", "It stays where the lesson puts it."),
  };

  void build(const P& params, Builder& builder) override;
  void reset(const swage::Step& step) override;
  void finish(const swage::Step& step) override;

  // its mechanics, in the order of the host's calls
  void advance(const swage::Step& step) override;
  void linearise(const swage::Step& step, uint32_t stiffer, double* stiffness, double* gradient) override;
  void displace(const swage::Step& step, const double* change, std::span<const swage_contact_point> points,
                std::span<const swage_chain_place> place, const double* impulse) override;
  // the same for single points, for a host without the band extension
  void mobility(const swage::Step& step, std::span<const swage_contact_point> points,
                  std::span<const swage_chain_place> place, double* v_free, double* W) override;
  void apply_impulses(const swage::Step& step, std::span<const swage_contact_point> points,
             std::span<const swage_chain_place> place, const double* impulse) override;

 private:
  using Vec3 = Eigen::Vector3d;
  using Matrix = swage::toolkit::Band<SWAGE_BAND_REACH>;
  static constexpr size_t kOf = SWAGE_BAND_UNKNOWNS;  // unknowns of a vertex: its displacement, and a rotation that is not used

  swage::ChainState chain(const swage::Step& step) const { return step.chain(0, vertices()); }
  uint32_t vertices() const { return static_cast<uint32_t>(n_); }
  /// 1 when contacts or ties pushed in the last step, else 0: the one private number beside the chain.
  double& held(const swage::Step& step) const { return step.state()[8 * n_]; }
  double mass(size_t i) const { return i == 0 || i == n_ - 1 ? 0.5 * mass_ : mass_; }
  bool stays(size_t unknown) const { return unknown % kOf == 3 || (unknown < kOf && params().fixed); }

  bool goes_on(const swage::Step& step) const;
  void set_up(const swage::Step& step, const double* x);
  void add_segment(size_t j, const double* x);
  void add_joint(size_t i, const double* x);
  void add_square(size_t i, size_t j, const Eigen::Matrix3d& K);
  void solve(double* right);
  void go(const swage::Step& step, const double* from, const double* change) const;
  static Vec3 at(const swage_chain_place& p, const double* numbers, size_t per_vertex);
  static void push(const swage_chain_place& p, const Vec3& force, double* unknowns);

  size_t n_ = 0;                          // vertices
  double piece_ = 0, mass_ = 0;           // m, unloaded length of a segment; kg, its mass
  double stretch_ = 0, bend_ = 0;         // N/m, stiffness of a segment; of a joint
  swage::Body body_;
  swage::Signal elongation_;

  // work space of one step, computed anew in the next
  Matrix A_;
  std::vector<double> gradient_, right_;  // of all unknowns
  std::vector<double> x0_, v0_, base_;    // m and m/s, start of the step; m, after advance()
};
