/* SPDX-License-Identifier: Apache-2.0 */
/* does nothing wrong: the control of every test here */
#define BALL_ID "org.example.ball"
#include "ball.h"
