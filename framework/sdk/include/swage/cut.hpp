// SPDX-License-Identifier: Apache-2.0
//
// The traits of blades and of strands that they cut (abi/cut.h), for both sides. An object inherits Blades or Cuttable and returns
// blades_table<T>() or cuttable_table<T>() from extension(); a coupling keeps a BladesPeer and a CuttablePeer.
#pragma once

#include <swage/abi/cut.h>
#include <swage/peer.hpp>
#include <swage/plugin.hpp>

#include <optional>

namespace swage {

/// Jaws that cut.
class Blades {
 public:
  virtual ~Blades() = default;
  /// Writes the properties of the blades, constant while active. [rt]
  virtual void blades_law(const Step& step, swage_blades_law& out) SWAGE_RT = 0;
};

/// A strand that can be cut.
class Cuttable {
 public:
  virtual ~Cuttable() = default;
  /// Parts the material at the arc length s [m], from the next step on. [rt]
  virtual void cut(const Step& step, double s) SWAGE_RT = 0;
};

/// The table of an object of class T that inherits Blades.
template <class T>
const swage_blades* blades_table() {
  static constexpr detail::Entry kLaw{"law", 33, detail::kRt, detail::When::kActive};
  static constexpr swage_blades table{[](swage_instance* i, const swage_object_step* s, swage_blades_law* out) noexcept {
    return detail::guarded<T>(i, kLaw, [&](auto&, detail::Holder<T>& h) { h.plugin->blades_law(Step(s), *out); });
  }};
  return &table;
}

/// The table of an object of class T that inherits Cuttable.
template <class T>
const swage_cuttable* cuttable_table() {
  static constexpr detail::Entry kCut{"cut", 38, detail::kRt, detail::When::kActive};
  static constexpr swage_cuttable table{[](swage_instance* i, const swage_object_step* s, double at) noexcept {
    return detail::guarded<T>(i, kCut, [&](auto&, detail::Holder<T>& h) { h.plugin->cut(Step(s), at); });
  }};
  return &table;
}

/// Blades of another plugin. Cheap to copy; keep it from bind() on.
class BladesPeer {
 public:
  BladesPeer() = default;
  explicit BladesPeer(const Peer& peer) : raw_(peer.raw()), table_(peer.trait<swage_blades>(SWAGE_TRAIT_BLADES)) {}

  bool valid() const { return table_ != nullptr; }
  std::optional<swage_blades_law> law(const Step& step) const SWAGE_RT {
    swage_blades_law law{};
    if (table_ == nullptr || table_->law(raw_, step.raw(), &law) != SWAGE_OK) return std::nullopt;
    return law;
  }

 private:
  swage_instance* raw_ = nullptr;
  const swage_blades* table_ = nullptr;
};

/// A strand of another plugin that can be cut. Cheap to copy; keep it from bind() on.
class CuttablePeer {
 public:
  CuttablePeer() = default;
  explicit CuttablePeer(const Peer& peer) : raw_(peer.raw()), table_(peer.trait<swage_cuttable>(SWAGE_TRAIT_CUTTABLE)) {}

  bool valid() const { return table_ != nullptr; }
  /// Cuts the strand at s [m]; false when the object could not.
  bool cut(const Step& step, double s) const SWAGE_RT { return table_ != nullptr && table_->cut(raw_, step.raw(), s) == SWAGE_OK; }

 private:
  swage_instance* raw_ = nullptr;
  const swage_cuttable* table_ = nullptr;
};

}  // namespace swage
