// SPDX-License-Identifier: Apache-2.0
//
// Definitions that every kind of plugin uses: typed indices, strings, poses, and the attribute of real-time
// functions.
#pragma once

#include <swage/abi/builder.h>

#include <cstdint>
#include <string_view>

#ifdef __FAST_MATH__
#error "Swage plugins must not be compiled with -ffast-math: it changes the arithmetic of the whole process."
#endif

// Marks a function that runs on [rt]: no allocation, lock, throw, log or file. Documentation for people
// today; with SWAGE_CHECK_REALTIME and a clang that knows the attribute the compiler checks it.
#if defined(SWAGE_CHECK_REALTIME) && defined(__has_cpp_attribute)
#if __has_cpp_attribute(clang::nonblocking)
#define SWAGE_RT [[clang::nonblocking]]
#endif
#endif
#ifndef SWAGE_RT
#define SWAGE_RT
#endif

// Thread roles and call order are checked when this is 1. A violation is reported, never fatal.
#ifndef SWAGE_CHECKS
#ifdef NDEBUG
#define SWAGE_CHECKS 0
#else
#define SWAGE_CHECKS 1
#endif
#endif

namespace swage {

inline constexpr uint32_t kNone = SWAGE_NONE;

/// Index of an item that the builder declared. Converts to a number, but a cue cannot be passed for a metric.
template <class Tag>
struct Index {
  uint32_t value = kNone;

  constexpr Index() = default;
  constexpr explicit Index(uint32_t index) : value(index) {}
  constexpr operator uint32_t() const { return value; }  // NOLINT: indexes the host's arrays
  constexpr bool valid() const { return value != kNone; }
};

using Body = Index<struct BodyTag>;
using Shape = Index<struct ShapeTag>;
using Particles = Index<struct ParticlesTag>;  // the first of a run
using Hinge = Index<struct HingeTag>;
using Signal = Index<struct SignalTag>;
using Metric = Index<struct MetricTag>;
using Cue = Index<struct CueTag>;
using Event = Index<struct EventTag>;
using Phase = Index<struct PhaseTag>;
using Mark = Index<struct MarkTag>;

inline constexpr swage_pose kIdentity{{0, 0, 0}, {1, 0, 0, 0}};

/// The pose of a frame moved to (x, y, z) [m] and not turned.
constexpr swage_pose at(double x, double y, double z) { return {{x, y, z}, {1, 0, 0, 0}}; }

constexpr swage_str str(std::string_view text) { return {text.data(), text.size()}; }
constexpr std::string_view view(swage_str text) { return {text.data, text.size}; }

}  // namespace swage
