// SPDX-License-Identifier: Apache-2.0
//
// The trait of threads (abi/strand.h), for both sides. An object inherits Strand, lists SWAGE_TRAIT_STRAND in its `traits` and
// returns strand_table<T>() from extension(); a coupling keeps a StrandPeer.
#pragma once

#include <swage/abi/strand.h>
#include <swage/peer.hpp>
#include <swage/plugin.hpp>

#include <algorithm>
#include <optional>
#include <span>

namespace swage {

/// A thread: its properties, and its places by arc length [m] from its first end.
class Strand {
 public:
  virtual ~Strand() = default;
  /// Writes the properties of the thread, constant while active. [rt]
  virtual void strand_law(const Step& step, swage_strand_law& out) SWAGE_RT = 0;
  /// Writes the place of the material at s; for an s beyond an end, that end. [rt]
  virtual void strand_place(const Step& step, double s, swage_strand_place& out) SWAGE_RT = 0;
  /// Writes the place on the centre line nearest to p_W. [rt]
  virtual void strand_nearest(const Step& step, swage_vec3 p_W, swage_strand_place& out) SWAGE_RT = 0;
};

/// A strand of straight pieces.
class StrandNodes {
 public:
  virtual ~StrandNodes() = default;
  /// Number of nodes, ends included, constant while active. [rt]
  virtual uint32_t strand_nodes(const Step& step) SWAGE_RT = 0;
};

/// A strand that tells all its places in one call.
class StrandLine {
 public:
  virtual ~StrandLine() = default;
  /// Writes the places [m, W] of parted.size() points at equal arc lengths, both ends included, and 1 where the strand is parted. They are
  /// those of strand_place(). [rt]
  virtual void strand_line(const Step& step, std::span<double> p_W, std::span<uint32_t> parted) SWAGE_RT = 0;
};

/// The table of an object of class T that inherits Strand.
template <class T>
const swage_strand* strand_table() {
  using I = swage_instance*;
  using S = const swage_object_step*;
  static constexpr detail::Entry kLaw{"law", 33, detail::kRt, detail::When::kActive}, kPlace{"place", 25, detail::kRt, detail::When::kActive},
      kNearest{"nearest", 32, detail::kRt, detail::When::kActive};
  static constexpr swage_strand table{
      [](I i, S s, swage_strand_law* out) noexcept {
        return detail::guarded<T>(i, kLaw, [&](auto&, detail::Holder<T>& h) { h.plugin->strand_law(Step(s), *out); });
      },
      [](I i, S s, double at, swage_strand_place* out) noexcept {
        return detail::guarded<T>(i, kPlace, [&](auto&, detail::Holder<T>& h) { h.plugin->strand_place(Step(s), at, *out); });
      },
      [](I i, S s, swage_vec3 p_W, swage_strand_place* out) noexcept {
        return detail::guarded<T>(i, kNearest, [&](auto&, detail::Holder<T>& h) { h.plugin->strand_nearest(Step(s), p_W, *out); });
      }};
  return &table;
}

/// The table of an object of class T that inherits StrandNodes.
template <class T>
const swage_strand_nodes* strand_nodes_table() {
  static constexpr detail::Entry kCount{"count", 42, detail::kRt, detail::When::kActive};
  static constexpr swage_strand_nodes table{[](swage_instance* i, const swage_object_step* s, uint32_t* out) noexcept {
    return detail::guarded<T>(i, kCount, [&](auto&, detail::Holder<T>& h) { *out = h.plugin->strand_nodes(Step(s)); });
  }};
  return &table;
}

/// The table of an object of class T that inherits StrandLine.
template <class T>
const swage_strand_line* strand_line_table() {
  static constexpr detail::Entry kLine{"line", 43, detail::kRt, detail::When::kActive};
  static constexpr swage_strand_line table{[](swage_instance* i, const swage_object_step* s, uint32_t n, double* p_W, uint32_t* parted) noexcept {
    return detail::guarded<T>(i, kLine, [&](auto&, detail::Holder<T>& h) { h.plugin->strand_line(Step(s), {p_W, size_t{3} * n}, {parted, n}); });
  }};
  return &table;
}

/// A thread of another plugin. Cheap to copy; keep it from bind() on.
class StrandPeer {
 public:
  StrandPeer() = default;
  explicit StrandPeer(const Peer& peer) : raw_(peer.raw()), table_(peer.trait<swage_strand>(SWAGE_TRAIT_STRAND)), nodes_(peer.trait<swage_strand_nodes>(SWAGE_TRAIT_STRAND_NODES)), line_(peer.trait<swage_strand_line>(SWAGE_TRAIT_STRAND_LINE)) {}

  bool valid() const { return table_ != nullptr; }
  std::optional<swage_strand_law> law(const Step& step) const SWAGE_RT {
    swage_strand_law law{};
    if (table_ == nullptr || table_->law(raw_, step.raw(), &law) != SWAGE_OK) return std::nullopt;
    return law;
  }
  std::optional<swage_strand_place> place(const Step& step, double s) const SWAGE_RT {
    swage_strand_place place{};
    if (table_ == nullptr || table_->place(raw_, step.raw(), s, &place) != SWAGE_OK) return std::nullopt;
    return place;
  }
  std::optional<swage_strand_place> nearest(const Step& step, swage_vec3 p_W) const SWAGE_RT {
    swage_strand_place place{};
    if (table_ == nullptr || table_->nearest(raw_, step.raw(), p_W, &place) != SWAGE_OK) return std::nullopt;
    return place;
  }
  /// Places at equal arc lengths, both ends included, and whether it is parted there: p_W has three numbers for each of parted, of which
  /// there are two or more. False: it did not answer.
  bool line(const Step& step, std::span<double> p_W, std::span<uint32_t> parted) const SWAGE_RT {
    const auto n = static_cast<uint32_t>(parted.size());
    if (line_ != nullptr) return line_->line(raw_, step.raw(), n, p_W.data(), parted.data()) == SWAGE_OK;
    const auto of = law(step);
    for (uint32_t i = 0; of && i < n; ++i) {
      const auto at = place(step, of->length * i / (n - 1));
      if (!at) return false;
      p_W[3 * i] = at->p_W.x, p_W[3 * i + 1] = at->p_W.y, p_W[3 * i + 2] = at->p_W.z;
      parted[i] = at->parted;
    }
    return of.has_value();
  }
  /// Number of its nodes; 0 where it does not tell.
  uint32_t nodes(const Step& step) const SWAGE_RT {
    uint32_t nodes = 0;
    return nodes_ != nullptr && nodes_->count(raw_, step.raw(), &nodes) == SWAGE_OK ? nodes : 0;
  }
  /// Number of places at which to look at it: `asked`, or as many as it has nodes where these are more, `most` of them at most. Between fewer places
  /// than nodes its narrow turns are cut off, and go through each other and through what they are wound about.
  int places(const Step& step, int asked, int most) const SWAGE_RT { return std::max(asked, static_cast<int>(std::min(static_cast<uint32_t>(most), nodes(step)))); }

 private:
  swage_instance* raw_ = nullptr;
  const swage_strand* table_ = nullptr;
  const swage_strand_nodes* nodes_ = nullptr;
  const swage_strand_line* line_ = nullptr;
};

}  // namespace swage
