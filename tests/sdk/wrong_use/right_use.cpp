// SPDX-License-Identifier: Apache-2.0
// The fixtures of this folder begin as this one does, which compiles; each then makes the mistake it is named after.
#include "plugins.hpp"

class Ball final : public BallBase {};
SWAGE_EXPORT(Ball, Watch)
