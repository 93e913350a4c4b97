// SPDX-License-Identifier: Apache-2.0
//
// A straight arm of wire, clamped at one end and pushed across at the other: the bending test, in any number of cells.
// With sections of strips as cells it is the reference for the needle in the loop; it is finer by two orders and
// shares neither the section's law nor the joints with it. Statics, planar, large turns. Not for the loop. [main]
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "toolkit/bent_wire.hpp"

namespace swage::toolkit {

/// A round section in strips across the bending axis, each elastic and perfectly plastic, plus the elastic share of hardening.
class StripSection {
 public:
  StripSection(double diameter, const WireMaterial& m, int strips)
      : material_(m), y_(static_cast<size_t>(strips)), area_(y_.size()), plastic_(y_.size(), 0.0) {
    const double r = 0.5 * diameter;
    for (size_t i = 0; i < y_.size(); ++i) {
      y_[i] = r * (-1 + 2 * (static_cast<double>(i) + 0.5) / strips);
      area_[i] = 2 * std::sqrt(r * r - y_[i] * y_[i]) * 2 * r / strips;
    }
  }

  /// Moment [N m] at a curvature [1/m], without a change of state.
  double moment(double curvature) const {
    double sum = 0;
    for (size_t i = 0; i < y_.size(); ++i) sum += stress(i, curvature) * area_[i] * y_[i];
    return sum;
  }
  /// Bends to a curvature; plastic strain remains.
  void bend(double curvature) {
    for (size_t i = 0; i < y_.size(); ++i) {
      const double strain = curvature * y_[i], limit = material_.yield / material_.youngs;
      plastic_[i] = std::clamp(plastic_[i], strain - limit, strain + limit);
    }
  }
  /// Stress of the outer strip over yield.
  double outer(double curvature) const { return std::abs(stress(0, curvature)) / material_.yield; }

 private:
  double stress(size_t i, double curvature) const {
    const double strain = curvature * y_[i], limit = material_.yield / material_.youngs;
    const double elastic = std::clamp(strain - plastic_[i], -limit, limit);
    return material_.youngs * ((1 - material_.hardening) * elastic + material_.hardening * strain);
  }
  WireMaterial material_;
  std::vector<double> y_, area_, plastic_;  // m, m2, strain
};

/// One joint of the needle in the loop, as a section of its length.
class JointSection {
 public:
  JointSection(double diameter, const WireMaterial& m, double length)
      : wire_(2, 1, 2 * length, m), length_(length) {
    wire_.set_section(0, wire_section(diameter, 1, 0, m));
  }
  double moment(double curvature) const {
    JointMemory copy = memory_;
    return go(curvature, copy);
  }
  void bend(double curvature) { go(curvature, memory_); }
  double outer(double curvature) const {
    JointMemory copy = memory_;
    go(curvature, copy);
    return wire_.stress(0, copy);
  }

 private:
  double go(double curvature, JointMemory& memory) const {
    wire_.bend(0, {0, 0, curvature * length_ - memory.turn[2]}, memory);
    return memory.moment[2];
  }
  BentWire wire_;
  JointMemory memory_;
  double length_ = 1;
};

/// The arm in cells of equal length, clamped at the origin along +x; the force acts at its end, across the line from the clamp
/// to there, as a knife edge does.
template <class Section>
class WireArm {
 public:
  WireArm(double length, std::vector<Section> cells)
      : cell_(std::move(cells)),
        curvature_(cell_.size(), 0.0),
        piece_(length / static_cast<double>(cell_.size())) {
    shape();
  }

  /// Bends it until the first cell has this curvature [1/m], in small steps.
  void bend_root(double curvature, int steps) {
    const double from = curvature_[0];
    for (int k = 1; k <= steps; ++k) root(from + (curvature - from) * k / steps);
  }
  /// Takes the force away in small steps.
  void release(int steps) {
    const double from = force_;
    for (int k = 1; k <= steps; ++k) push(from * (1 - static_cast<double>(k) / steps));
  }
  /// Finds the shape under a force [N].
  void push(double force) {
    force_ = force;
    for (int pass = 0; pass < kPasses; ++pass) {
      for (size_t i = 0; i < cell_.size(); ++i) curvature_[i] = curvature(i, force * lever(i));
      shape();
    }
    settle();
  }

  double force() const { return force_; }                         // N
  double moment() const { return force_ * std::hypot(x_, y_); }   // N m, force times chord
  double angle() const { return std::atan2(y_, x_); }             // rad, of the chord
  double deflection() const { return y_; }                        // m
  double turn() const { return turn_; }                           // rad, of the end
  double outer() const { return cell_[0].outer(curvature_[0]); }  // stress at the clamp over yield
  double root_curvature() const { return curvature_[0]; }         // 1/m

 private:
  static constexpr int kPasses = 8;  // alternately of shape and lever arm: each brings two digits in small steps

  void root(double curvature_0) {
    for (int pass = 0; pass < kPasses; ++pass) {
      curvature_[0] = curvature_0;
      force_ = cell_[0].moment(curvature_0) / lever(0);
      for (size_t i = 1; i < cell_.size(); ++i) curvature_[i] = curvature(i, force_ * lever(i));
      shape();
    }
    settle();
  }
  void settle() {
    for (size_t i = 0; i < cell_.size(); ++i) cell_[i].bend(curvature_[i]);
  }
  /// Places cells and end: each cell turns in its middle.
  void shape() {
    double x = 0, y = 0, a = 0;
    place_.resize(cell_.size());
    for (size_t i = 0; i < cell_.size(); ++i) {
      x += 0.5 * piece_ * std::cos(a), y += 0.5 * piece_ * std::sin(a);
      place_[i] = {x, y};
      a += piece_ * curvature_[i];
      x += 0.5 * piece_ * std::cos(a), y += 0.5 * piece_ * std::sin(a);
    }
    x_ = x, y_ = y, turn_ = a;
  }
  /// Lever arm of the force about a cell [m].
  double lever(size_t i) const {
    const double chord = std::hypot(x_, y_);
    return ((x_ - place_[i].first) * x_ + (y_ - place_[i].second) * y_) / chord;
  }
  /// Curvature at which a cell bears a moment: brackets it around the present one, then the Illinois method.
  double curvature(size_t i, double moment) const {
    const auto off = [&](double k) { return cell_[i].moment(k) - moment; };
    double reach = 1, low = curvature_[i] - reach, high = curvature_[i] + reach;  // 1/m
    double at_low = off(low), at_high = off(high);
    for (; at_low > 0 && reach < kFar; at_low = off(low)) low -= (reach *= 2);
    for (; at_high < 0 && reach < kFar; at_high = off(high)) high += (reach *= 2);
    int side = 0;
    for (int k = 0; k < 100 && high - low > kNear * (1 + std::abs(low)); ++k) {
      const double middle = (low * at_high - high * at_low) / (at_high - at_low), at = off(middle);
      if (at == 0) return middle;
      if (at < 0) {
        low = middle, at_low = at;
        if (side == -1) at_high *= 0.5;
        side = -1;
      } else {
        high = middle, at_high = at;
        if (side == 1) at_low *= 0.5;
        side = 1;
      }
      if (std::abs(at) < kNear * (1e-9 + std::abs(moment))) return middle;
    }
    return 0.5 * (low + high);
  }
  static constexpr double kNear = 1e-9;  // of a curvature, or of a moment
  static constexpr double kFar = 1e9;    // 1/m: largest curvature searched; a joint folded so far bears its limit moment

  std::vector<Section> cell_;
  std::vector<double> curvature_;
  std::vector<std::pair<double, double>> place_;
  double piece_, force_ = 0, x_ = 0, y_ = 0, turn_ = 0;
};

}  // namespace swage::toolkit
