/* memory.c - Lua's allocator: small blocks from a pool, large ones from malloc; count and limit.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * `used` is the sum of the live blocks' sizes, `total` of all blocks there ever were: the length of
 * the work, as bounds.c takes it.  A request that would pass the limit returns NULL; Lua then
 * collects garbage, tries once more, and only then raises its memory error.  Freeing and shrinking
 * always succeed, as Lua requires.  Rational numbers keep their limbs in Lua's blocks, so they are
 * counted too.
 *
 * A third of a run went to malloc and free.  The pool: blocks of at most ACCOUNT_LARGEST bytes,
 * rounded up to a multiple of GRAIN, are cut from chunks and go back to the list of their size; Lua
 * says how large a block was, so nothing is kept beside it.  Chunks stay to the end of the run, as
 * what was kept does; each is a huge page where Linux grants one, for a tenth of a run went to
 * thousands of page faults.  With an address sanitizer, or with POLHODE_MALLOC in the environment
 * (for valgrind), all is malloc's, so that each block is seen.
 */
#define _DEFAULT_SOURCE /* madvise */
#include "host/host.h"

#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

enum { GRAIN = ACCOUNT_GRAIN, CHUNK = 1 << 21 };

#if defined __SANITIZE_ADDRESS__
#define POOL 0
#elif defined __has_feature
#if __has_feature(address_sanitizer)
#define POOL 0
#endif
#endif
#ifndef POOL
#define POOL 1
#endif

void account_open(struct account *a) {
  a->pooled = POOL && getenv("POLHODE_MALLOC") == NULL ? ACCOUNT_LARGEST : 0;
}

static int pooled(const struct account *a, size_t size) {
  return size <= a->pooled;
}

static char *chunk(void) {
  char *block = aligned_alloc(CHUNK, CHUNK);
#ifdef MADV_HUGEPAGE
  if (block != NULL)
    madvise(block, CHUNK, MADV_HUGEPAGE); /* refused: small pages */
#endif
  return block;
}

/* Of a size that is pooled: a block of its class. */
static void *take(struct account *a, size_t size) {
  const size_t class = (size + GRAIN - 1) / GRAIN, bytes = class * GRAIN;
  void *block = a->free[class];
  if (block != NULL) {
    memcpy(&a->free[class], block, sizeof(void *));
    return block;
  }
  if (a->left < bytes) { /* what is left of the last chunk is lost */
    a->next = chunk();
    a->left = a->next != NULL ? CHUNK : 0;
    if (a->next == NULL)
      return NULL;
  }
  block = a->next;
  a->next += bytes;
  a->left -= bytes;
  return block;
}

static void give(struct account *a, void *block, size_t size) {
  const size_t class = (size + GRAIN - 1) / GRAIN;
  memcpy(block, &a->free[class], sizeof(void *));
  a->free[class] = block;
}

/* As realloc, of a block of `old` bytes. */
static void *move(struct account *a, void *block, size_t old, size_t size) {
  const int from = block != NULL && pooled(a, old), to = pooled(a, size);
  if (!from && !to)
    return realloc(block, size);
  if (from && to && (old + GRAIN - 1) / GRAIN == (size + GRAIN - 1) / GRAIN)
    return block;
  void *fresh = to ? take(a, size) : malloc(size);
  if (fresh == NULL)
    return size <= old ? block : NULL;
  if (block != NULL) {
    memcpy(fresh, block, old < size ? old : size);
    if (from)
      give(a, block, old);
    else
      free(block);
  }
  return fresh;
}

/* May `more` bytes be added? */
static int admit(struct account *a, size_t more) {
  const int fits = a->used <= a->limit && more <= a->limit - a->used;
  if (!fits && a->asked && a->refused != NULL)
    a->refused(); /* the same request after a collection */
  a->asked = !fits;
  return fits;
}

static void count(struct account *a, size_t more) {
  a->total += more;
  if (a->passed != NULL && a->total >= a->mark)
    a->passed();
}

void *account_allocate(void *ud, void *block, size_t old_size, size_t new_size) {
  struct account *a = ud;
  const size_t old = block != NULL ? old_size : 0; /* else old_size is a type tag */
  if (new_size == 0) {
    if (block != NULL && pooled(a, old))
      give(a, block, old);
    else
      free(block);
    a->used -= old;
    return NULL;
  }
  if (new_size > old && !admit(a, new_size - old))
    return NULL;
  void *fresh = move(a, block, old, new_size);
  if (fresh == NULL)
    return NULL;
  a->used += new_size - old; /* modulo 2^n when it shrinks */
  if (new_size > old)
    count(a, new_size - old);
  return fresh;
}

struct account *account_of(lua_State *L) {
  void *ud;
  lua_getallocf(L, &ud);
  return ud;
}
