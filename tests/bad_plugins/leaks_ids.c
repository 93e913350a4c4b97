/* SPDX-License-Identifier: Apache-2.0 */
/* makes a ball of whatever it is asked for */
#include <swage/abi/object.h>
static swage_instance* create(const swage_host* host, const char* id);
#define BALL_ID "org.example.bad.leaks_ids"
#define BALL_CREATE create
#include "ball.h"
static swage_instance* create(const swage_host* host, const char* id) {
  (void)id;
  return ball_make(host);
}
