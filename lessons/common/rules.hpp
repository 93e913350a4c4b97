// SPDX-License-Identifier: Apache-2.0
//
// Rules that several judges share, each set by the parameter of the same name. [main]
#pragma once

namespace swage::lessons {

/// Sets each of these rules that `rules` has. A rule whose parameter is missing does not compile.
template <class Params, class Rules>
void set_common_rules(const Params& params, bool practice, Rules& rules) {
  if constexpr (requires { rules.force_low; }) rules.force_low = params.force.low;
  if constexpr (requires { rules.force_high; }) rules.force_high = params.force.high;
  if constexpr (requires { rules.hold_time; }) rules.hold_time = params.hold_time;
  if constexpr (requires { rules.par_time; }) rules.par_time = params.par_time;
  if constexpr (requires { rules.max_time; }) rules.max_time = params.max_time;
  if constexpr (requires { rules.max_over_time; }) rules.max_over_time = params.max_over_time;
  if constexpr (requires { rules.max_drops; }) rules.max_drops = params.max_drops;
  if constexpr (requires { rules.drop_distance; }) rules.drop_distance = params.drop_distance;
  if constexpr (requires { rules.lost_distance; }) rules.lost_distance = params.lost_distance;
  rules.ends = !practice;  // no limit ends an attempt in practice: what is lost can be put back; what cannot (a broken thread) ends it
}

}  // namespace swage::lessons
