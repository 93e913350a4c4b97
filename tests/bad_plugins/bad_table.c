/* SPDX-License-Identifier: Apache-2.0 */
/* its table of parameters contradicts itself */
#include <stddef.h>
#include <swage/abi/params.h>
static const swage_param table[] = {{sizeof(swage_param),
                                     SWAGE_PARAM_REAL,
                                     0,
                                     1,
                                     "radius",
                                     "Radius",
                                     "",
                                     "mm",
                                     "mm",
                                     "Of the ball.",
                                     NULL,
                                     NULL,
                                     NULL,
                                     0,
                                     10,
                                     {1, 0, 0, 0}},
                                    {sizeof(swage_param),
                                     SWAGE_PARAM_REAL,
                                     0,
                                     1,
                                     "radius",
                                     "Radius",
                                     "",
                                     "m",
                                     "mm",
                                     "Of the ball.",
                                     NULL,
                                     NULL,
                                     NULL,
                                     0,
                                     1,
                                     {2, 0, 0, 0}}};
#define BALL_ID "org.example.bad.bad_table"
#define BALL_PARAMS table
#include "ball.h"
