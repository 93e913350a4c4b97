// SPDX-License-Identifier: Apache-2.0
//
// A flexible body: an object with its own mechanics, as the contact solve sees it. The step implements it on top of the
// plugin extensions swage.object.solver/1 or /2 and swage.object.band/1; tests implement it directly.
#pragma once

#include <swage/abi/object.h>

#include <cstdint>
#include <span>

namespace swage::dynamics {

/// Interface to the flexible bodies of one object. All calls [rt], noexcept, at most once per step and in this order; but mobility may
/// be asked for a second time, for more points, when points move farther than expected. `point[i].body` and `point[i].shape` are
/// indices of the world; points are in the order of the contact set.
class FlexibleBody {
 public:
  virtual ~FlexibleBody() = default;

  /// Index of the object, as in BodyInfo::object.
  virtual uint32_t object() const noexcept = 0;

  /// True when the surface is that of the shapes: the object need not be asked about contacts whose shapes are apart.
  virtual bool surface_is_shape() const noexcept { return false; }

  /// Gives the places, on the object's chains, of the points of the next calls; valid until the next locate().
  virtual void locate(std::span<const swage_chain_place> /*place*/) noexcept {}

  /// Its mobility: v = v_free + W j. v_free: 3 n [m/s]; W: 3n x 3n, row-major, symmetric, positive
  /// semi-definite [m/s per N s]. False: the object has failed, its points take part as if they could not be
  /// moved.
  virtual bool mobility(std::span<const swage_contact_point> point, double* v_free, double* W) noexcept = 0;

  /// True when it answers displacement(): its surface counts as apart from its shapes in every step, however small the displacement.
  virtual bool displaces() const noexcept { return false; }

  /// Displacement of the free surface from the shapes at the same points: u_W is 3 n [m], zero on entry. False: the object has
  /// failed, as in mobility().
  virtual bool displacement(std::span<const swage_contact_point> /*point*/, double* /*u_W*/) noexcept {
    return true;
  }

  /// Takes the impulses that the solve found: 3 n [N s], on the object. Writes the final flexible poses and
  /// twists.
  virtual void apply_impulses(std::span<const swage_contact_point> point, const double* impulse) noexcept = 0;

  /// True when its one chain is a band (swage/abi/band.h): linearise and displace take the places of mobility and apply_impulses.
  virtual bool banded() const noexcept { return false; }
  virtual bool linearise(uint32_t /*stiffer*/, double* /*stiffness*/, double* /*gradient*/) noexcept { return false; }
  /// Asked where that stiffness could not be factored. False: its numbers are not finite, and the object has failed. A matrix with
  /// such numbers is never factored: each of them makes a pivot that is not above zero or not finite.
  virtual bool stiffness_is_sound(const double* /*stiffness*/) noexcept { return true; }
  virtual void displace(const double* /*change*/, std::span<const swage_contact_point> /*point*/,
                        const double* /*impulse*/) noexcept {}
};

}  // namespace swage::dynamics
