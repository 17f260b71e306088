/* bounds.h - how much memory and work a scene may take.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef POLHODE_BOUNDS_H
#define POLHODE_BOUNDS_H

#include "host/host.h"

struct bounds {
  lua_Integer bytes;    /* above what is in use at the start */
  lua_Integer steps;    /* virtual instructions; 0: turnover is the bound instead */
  lua_Integer turnover; /* bytes in all blocks from then on */
  double seconds;       /* of processor time */
  const char *what;     /* "the scene", at the head of messages */
};

enum bound { BOUND_NONE, BOUND_MEMORY, BOUND_STEPS, BOUND_TURNOVER, BOUND_TIME };

/* Fields bytes, steps, turnover, seconds of the table at `index` (none: what is there already) into
 * *b. */
void bounds_read(lua_State *L, int index, struct bounds *b);

/* Put the bounds in force, one set at a time; *b and the message last_words, which is written when
   C code is stuck, must live until bounds_end. */
void bounds_begin(lua_State *L, const struct bounds *b, const char *last_words);
void bounds_end(lua_State *L);
int bounds_active(void);

/* An error is being described: nothing is raised any more, and memory is there. */
void bounds_unwind(lua_State *L);
int bounds_unwinding(void);

/* Which one was passed, and the message of it. */
enum bound bounds_passed(void);
void bounds_push(lua_State *L, enum bound which);

#endif
