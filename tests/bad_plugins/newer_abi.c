/* SPDX-License-Identifier: Apache-2.0 */
/* needs what this program does not offer yet */
#define BALL_ID "org.example.bad.newer_abi"
#define BALL_MINOR (SWAGE_ABI_MINOR + 1u)
#include "ball.h"
