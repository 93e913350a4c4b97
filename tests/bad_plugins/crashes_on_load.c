/* SPDX-License-Identifier: Apache-2.0 */
/* does not survive being loaded */
#define BALL_ID "org.example.bad.crashes_on_load"
#include "ball.h"
static int* volatile nowhere;
__attribute__((constructor)) static void crash(void) { *nowhere = 1; }
