/* SPDX-License-Identifier: Apache-2.0 */
/* says it is somebody else */
#define BALL_ID "org.example.ball"
#include "ball.h"
