/* SPDX-License-Identifier: Apache-2.0 */
/* leaves a function out, and promises a trait that it does not have */
#define BALL_ID "org.example.bad.gaps"
#define BALL_FORCES NULL
#define BALL_TRAITS SWAGE_TRAIT_SOLID, SWAGE_TRAIT_GRASPABLE
#include "ball.h"
