/* SPDX-License-Identifier: Apache-2.0
 *
 * swage/abi/plugin.h - entry, factory, host and instance.
 *
 * Life of an instance:
 *
 *   create -> configure -> activate -> [ step functions ] -> deactivate -> destroy
 *   [main]    [main]       [main]      [rt], 1 kHz           [main]        [main]
 *
 * configure may be called again while inactive; it declares everything the instance will ever own in the scene.
 */
#ifndef SWAGE_ABI_PLUGIN_H
#define SWAGE_ABI_PLUGIN_H

#include "base.h"
#include "params.h"

/* Kinds of plugin. */
#define SWAGE_KIND_OBJECT 1
#define SWAGE_KIND_COUPLING 2
#define SWAGE_KIND_DEVICE 3
#define SWAGE_KIND_LESSON 4

typedef struct swage_builder swage_builder; /* builder.h */

/* Functions of the host for every instance. Always complete; extensions come through get_extension. */
typedef struct swage_host swage_host;
struct swage_host {
  uint32_t struct_size, abi_major, abi_minor, reserved;
  void* host_data;
  const void* (*get_extension)(const swage_host*, const char* id);                             /* [any] */
  void (*report)(const swage_host*, int32_t severity, swage_str where, swage_str message);     /* [main | io] */
  void (*fault)(const swage_host*, int32_t code, double a, double b);                          /* [any] wait-free */
  int32_t (*thread_kind)(const swage_host*);                                                   /* [any] SWAGE_THREAD_* */
  uint64_t (*random_u64)(const swage_host*); /* [rt] one stream per instance, seeded by lesson and instance name */
};

typedef struct swage_instance swage_instance;
struct swage_instance {
  void* self; /* the plugin's */
  swage_result (*configure)(swage_instance*, const swage_values*, swage_builder*); /* [main & !active] */
  swage_result (*activate)(swage_instance*, double dt_s);                          /* [main & !active] */
  void (*deactivate)(swage_instance*);                                             /* [main & active] */
  void (*destroy)(swage_instance*);                                                /* [main & !active] */
  const void* (*get_extension)(swage_instance*, const char* id); /* [any] static for the life of the instance */
};

/* A plugin with LIVE parameters takes a new value at a step boundary, as often as an instructor turns the knob. The change
 * is a recorded command, so a replay repeats it. TEXT and FILE parameters are never LIVE. */
#define SWAGE_EXT_LIVE "swage.live/1"
typedef struct swage_live {
  swage_result (*change)(swage_instance*, uint32_t param, const swage_value*); /* [rt & active] checked by the host */
} swage_live;

/* Description of a plugin; static storage. */
typedef struct swage_descriptor {
  uint32_t struct_size;
  int32_t kind;              /* SWAGE_KIND_* */
  const char* id;            /* reverse domain, lower case: "org.example.clip" */
  const char* version;       /* semantic: "1.2.0" */
  const char* name;          /* for people */
  const char* summary;       /* one sentence: what it models and its limits */
  const char* author;
  const char* licence;       /* SPDX */
  const char* const* traits; /* OBJECT: traits it offers; COUPLING, DEVICE, LESSON: empty. NULL-terminated, not NULL */
} swage_descriptor;

#define SWAGE_FACTORY_INSTANCES "swage.factory.instances/1"
typedef struct swage_factory {
  uint32_t (*count)(void);                                      /* [any] */
  const swage_descriptor* (*descriptor)(uint32_t index);        /* [any] NULL when index >= count */
  swage_instance* (*create)(const swage_host*, const char* id); /* [main] NULL for an unknown id */
} swage_factory;

/* The only exported symbol of a plugin library:  const swage_entry swage_plugin_entry;  */
#define SWAGE_ENTRY_SYMBOL "swage_plugin_entry"
typedef struct swage_entry {
  uint32_t struct_size;
  uint32_t abi_major, abi_minor, reserved;
  const char* build_info;                            /* compiler, flags: for reports, never for decisions */
  swage_result (*init)(const char* bundle_dir);      /* [main] once after loading, fast */
  void (*deinit)(void);                              /* [main] once at exit; the library stays mapped */
  const void* (*get_factory)(const char* factory_id); /* [any] NULL when unknown */
} swage_entry;

SWAGE_STATIC_ASSERT(sizeof(swage_host) == 64, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_instance) == 48, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_live) == 8, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_descriptor) == 64, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_factory) == 24, "frozen layout");
SWAGE_STATIC_ASSERT(sizeof(swage_entry) == 48, "frozen layout");

#endif
