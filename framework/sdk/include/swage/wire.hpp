// SPDX-License-Identifier: Apache-2.0
//
// The trait of a wire that bends plastically (abi/wire.h), for both sides. An object inherits Wire and returns wire_table<T>() from
// extension(); a coupling keeps a WirePeer.
#pragma once

#include <swage/abi/wire.h>
#include <swage/peer.hpp>
#include <swage/plugin.hpp>

#include <optional>

namespace swage {

class Wire {
 public:
  virtual ~Wire() = default;
  /// Writes where the wire collapsed and where it broke, each once in an attempt. [rt]
  virtual void wire_end(const Step& step, swage_wire_end& out) SWAGE_RT = 0;
};

/// The table of an object of class T that inherits Wire.
template <class T>
const swage_wire* wire_table() {
  static constexpr detail::Entry kEnd{"end", 39, detail::kRt, detail::When::kActive};
  static constexpr swage_wire table{[](swage_instance* i, const swage_object_step* s, swage_wire_end* out) noexcept {
    return detail::guarded<T>(i, kEnd, [&](auto&, detail::Holder<T>& h) { h.plugin->wire_end(Step(s), *out); });
  }};
  return &table;
}

/// A wire of another plugin. Cheap to copy; keep it from bind() on.
class WirePeer {
 public:
  WirePeer() = default;
  explicit WirePeer(const Peer& peer) : raw_(peer.raw()), table_(peer.trait<swage_wire>(SWAGE_TRAIT_WIRE)) {}

  bool valid() const { return table_ != nullptr; }
  std::optional<swage_wire_end> end(const Step& step) const SWAGE_RT {
    swage_wire_end out{-1, -1};
    if (table_ == nullptr || table_->end(raw_, step.raw(), &out) != SWAGE_OK) return std::nullopt;
    return out;
  }

 private:
  swage_instance* raw_ = nullptr;
  const swage_wire* table_ = nullptr;
};

}  // namespace swage
