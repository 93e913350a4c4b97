/* SPDX-License-Identifier: Apache-2.0 */
/* waits for something that never comes, before it is even loaded */
#include <unistd.h>
#define BALL_ID "org.example.bad.hangs_on_load"
#include "ball.h"
__attribute__((constructor)) static void hang(void) {
  for (;;) pause();
}
