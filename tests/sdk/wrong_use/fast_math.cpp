// SPDX-License-Identifier: Apache-2.0
// expect: must not be compiled with -ffast-math
// flags: -ffast-math
#include "plugins.hpp"

class Ball final : public BallBase {};
SWAGE_EXPORT(Ball)
