/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/params.h - one table per plugin describes its parameters. The checker of lesson files, the JSON Schema, the
 * instructor's form, the documentation table and the fuzzer all derive from it.
 */
#ifndef SWAGE_ABI_PARAMS_H
#define SWAGE_ABI_PARAMS_H

#include "base.h"

/* Types of a parameter. */
#define SWAGE_PARAM_REAL 1    /* number[0], in the SI unit */
#define SWAGE_PARAM_INTEGER 2 /* number[0], integral */
#define SWAGE_PARAM_BOOL 3    /* number[0], 0 or 1 */
#define SWAGE_PARAM_CHOICE 4  /* number[0], index into choices */
#define SWAGE_PARAM_TEXT 5    /* text */
#define SWAGE_PARAM_VECTOR 6  /* number[0 .. dimension), in the SI unit */
#define SWAGE_PARAM_FILE 7    /* text: absolute path, resolved by the host against the lesson file's folder */

/* Flags of a parameter. */
#define SWAGE_PARAM_LIVE 1u     /* may change while the scene runs */
#define SWAGE_PARAM_REQUIRED 2u /* a lesson must give it; the default is then only a start for the form */
#define SWAGE_PARAM_HIDDEN 4u   /* shown under "advanced" */
#define SWAGE_PARAM_INTERVAL 8u /* VECTOR of dimension 2: its numbers are the ends of a range, shown as "from" and "to"; else sizes along axes */

typedef struct swage_param {
  uint32_t struct_size;
  int32_t type;                /* SWAGE_PARAM_* */
  uint32_t flags;
  uint32_t dimension;          /* of a VECTOR: 2 to 4; 1 otherwise */
  const char* id;              /* snake_case, stable for ever */
  const char* label;           /* for people */
  const char* group;           /* section of the form, "" for the first one */
  const char* unit;            /* SI: "m", "N", "rad", ...; "1" for a pure number */
  const char* display_unit;    /* what a form shows: "mm", "deg", ... */
  const char* doc;             /* one or two sentences */
  const char* const* choices;  /* CHOICE: NULL-terminated; NULL otherwise */
  const char* const* aliases;  /* former ids, NULL-terminated, or NULL */
  const char* default_text;    /* TEXT and FILE; NULL otherwise */
  double min, max;             /* inclusive, SI; each component of a VECTOR */
  double default_number[4];
} swage_param;

/* A value that was checked, converted to SI and defaulted by the host. */
typedef struct swage_value {
  double number[4];
  swage_str text;
} swage_value;

/* Value i belongs to parameter i of the table. */
typedef struct swage_values {
  uint32_t struct_size, count;
  const swage_value* value;
  swage_str instance_name; /* as the lesson file names the instance */
} swage_values;

#define SWAGE_FACTORY_PARAMS "swage.factory.params/1"
typedef struct swage_param_factory {
  /* [any] The table of a plugin, static storage; *count = 0 and NULL for a plugin without parameters. */
  const swage_param* (*table)(const char* plugin_id, uint32_t* count);
} swage_param_factory;

SWAGE_STATIC_ASSERT(sizeof(swage_param) == 136, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_value) == 48, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_values) == 32, "frozen layout");

#endif
