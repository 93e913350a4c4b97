/* SPDX-License-Identifier: Apache-2.0 */
/* comes from another time */
#define BALL_ID "org.example.bad.wrong_abi"
#define BALL_MAJOR (SWAGE_ABI_MAJOR + 1u)
#define BALL_MINOR 0u
#include "ball.h"
