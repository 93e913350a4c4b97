/* SPDX-License-Identifier: Apache-2.0 */
/* does nothing wrong itself, but is linked with -ffast-math: loading it turns subnormal numbers off */
#define BALL_ID "org.example.bad.fast_math"
#include "ball.h"
