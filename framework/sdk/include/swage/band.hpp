// SPDX-License-Identifier: Apache-2.0
//
// An object with a chain whose stiffness matrix is a band: the host solves it together with everything that it touches, at a cost
// linear in the number of contacts. It offers mobility as well, for hosts without this extension.
//
//   class Thread final : public swage::BandedObject<ThreadParams>, public swage::Solid { ... };
#pragma once

#include <swage/abi/band.h>
#include <swage/object.hpp>

namespace swage {

namespace detail {
template <class T>
struct BandTables;
}

/// Base of an object with one chain on its one flexible body. Unknowns, and when each is called: swage/abi/band.h.
template <class P = NoParams>
class BandedObject : public Object<P>, public ChainSolver {
 public:
  template <class T>
  using Tables = detail::BandTables<T>;

  /// Linearises the step at the vertices that advance() wrote: 4 n columns of the stiffness, and the gradient. [rt]
  virtual void linearise(const Step& step, uint32_t stiffer, double* stiffness, double* gradient) SWAGE_RT = 0;
  /// Moves the vertices from there by `change`, of which the impulses are already a part. [rt]
  virtual void displace(const Step& step, const double* change, std::span<const swage_contact_point> points,
                        std::span<const swage_chain_place> place, const double* impulse) SWAGE_RT = 0;
};

namespace detail {

inline constexpr Entry kLinearise{"linearise", 35, kRt, When::kActive};
inline constexpr Entry kDisplace{"displace", 36, kRt, When::kActive};

template <class T>
struct BandTables : ObjectTables<T> {
  using Raw = const swage_object_step*;
  static swage_result linearise(swage_instance* i, Raw s, uint32_t stiffer, double* stiffness,
                                double* gradient) noexcept {
    return guarded<T>(i, kLinearise, [&](auto&, Holder<T>& h) {
      h.plugin->linearise(Step(s), stiffer, stiffness, gradient);
    });
  }
  static swage_result displace(swage_instance* i, Raw s, const double* change, uint32_t n,
                               const swage_contact_point* point, const swage_chain_place* place,
                               const double* impulse) noexcept {
    return guarded<T>(i, kDisplace, [&](auto&, Holder<T>& h) {
      h.plugin->displace(Step(s), change, {point, n}, {place, n}, impulse);
    });
  }
  static const void* find(const char* id) {
    static constexpr swage_band band{linearise, displace};
    return same(id, SWAGE_EXT_BAND) ? static_cast<const void*>(&band) : ObjectTables<T>::find(id);
  }
};

}  // namespace detail
}  // namespace swage
