// SPDX-License-Identifier: Apache-2.0
//
// Numbers for people in SI units: everything in Swage is m, kg, s, N, rad.
#pragma once

namespace swage {

inline constexpr double kDegree = 0.017453292519943295;  // rad

}  // namespace swage
