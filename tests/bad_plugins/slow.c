/* SPDX-License-Identifier: Apache-2.0 */
/* needs two milliseconds of every one */
#define _POSIX_C_SOURCE 200809L
#include <swage/abi/object.h>
#include <time.h>
static swage_result forces(swage_instance* instance, const swage_object_step* step);
#define BALL_ID "org.example.bad.slow"
#define BALL_FORCES forces
#include "ball.h"
static double cpu_s(void) {
  struct timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
static swage_result forces(swage_instance* instance, const swage_object_step* step) {
  const double begin = cpu_s();
  (void)instance;
  if (step->step < BALL_GOOD_STEPS) return SWAGE_OK;
  while (cpu_s() - begin < 2e-3) {
  }
  return SWAGE_OK;
}
