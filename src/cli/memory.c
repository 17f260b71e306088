/* memory.c - Lua's allocator: malloc with a count and a limit.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * `used` is the sum of the live blocks' sizes.  A request that would pass the limit returns NULL;
 * Lua then collects garbage, tries once more, and only then raises its memory error.  Freeing and
 * shrinking always succeed, as Lua requires.  Rational numbers keep their limbs in Lua's blocks, so
 * they are counted too.
 */
#include "host.h"

#include <stdlib.h>

/* May `more` bytes be added? */
static int admit(struct account *a, size_t more) {
  const int fits = a->used <= a->limit && more <= a->limit - a->used;
  if (!fits && a->asked && a->refused != NULL)
    a->refused(); /* the same request after a collection */
  a->asked = !fits;
  return fits;
}

void *account_allocate(void *ud, void *block, size_t old_size, size_t new_size) {
  struct account *a = ud;
  const size_t old = block != NULL ? old_size : 0; /* else old_size is a type tag */
  if (new_size == 0) {
    free(block);
    a->used -= old;
    return NULL;
  }
  if (new_size > old && !admit(a, new_size - old))
    return NULL;
  void *fresh = realloc(block, new_size);
  if (fresh != NULL)
    a->used += new_size - old; /* modulo 2^n when it shrinks */
  return fresh;
}

struct account *account_of(lua_State *L) {
  void *ud;
  lua_getallocf(L, &ud);
  return ud;
}
