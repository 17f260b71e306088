/* weld.c - vertices welded by exact coordinates.
   SPDX-License-Identifier: GPL-3.0-or-later

   A table of numbers, open addressing with linear probing, at most half full. A slot carries the
   high half of the hash, so that a stranger's coordinates are hardly ever looked at. */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>

static uint64_t mix(uint64_t h, uint64_t v) {
  h = (h ^ v) * UINT64_C(0x9E3779B97F4A7C15); /* 2^64/golden ratio: odd, bits without pattern */
  return h ^ (h >> 32);
}

/* Of the bits: equal coordinates have equal ones, since 0 has one sign only and NaN does not come
   here (build.c). */
uint64_t mesh_points_hash(const double p[3]) {
  uint64_t k[3];
  memcpy(k, p, sizeof k);
  return mix(mix(mix(UINT64_C(0x2545F4914F6CDD1D), k[0]), k[1]), k[2]);
}

/* Double the table: 0, or -1 without memory. */
static int grow_table(struct mesh_points *v) {
  const size_t slots = v->slot ? 2 * (v->mask + 1) : 1 << 12;
  uint64_t *slot = calloc(slots, sizeof *slot);
  if (slot == NULL)
    return -1;
  free(v->slot);
  v->slot = slot;
  v->mask = slots - 1;
  for (size_t i = 0; i < v->count; i++) {
    const uint64_t hash = mesh_points_hash(v->xyz + 3 * i);
    size_t at = (size_t)hash & v->mask;
    while (slot[at] != 0)
      at = (at + 1) & v->mask;
    slot[at] = (hash >> 32 << 32) | (uint64_t)(i + 1);
  }
  return 0;
}

static uint32_t add(struct mesh_points *v, const double p[3], uint64_t hash, size_t at) {
  if (v->count + 1 >= MESH_MAX)
    return MESH_NONE;
  if (v->count == v->capacity) {
    const size_t capacity = v->capacity ? 2 * v->capacity : 1 << 10;
    double *xyz = realloc(v->xyz, 3 * capacity * sizeof *xyz);
    if (xyz == NULL)
      return MESH_NONE;
    v->xyz = xyz;
    v->capacity = capacity;
  }
  for (int i = 0; i < 3; i++) {
    v->xyz[3 * v->count + (size_t)i] = p[i];
    if (v->count == 0 || p[i] < v->lo[i])
      v->lo[i] = p[i];
    if (v->count == 0 || p[i] > v->hi[i])
      v->hi[i] = p[i];
  }
  v->slot[at] = (hash >> 32 << 32) | (uint64_t)(v->count + 1);
  return (uint32_t)v->count++;
}

uint32_t mesh_points_weld(struct mesh_points *v, const double p[3], uint64_t hash) {
  if (2 * (v->count + 1) > v->mask && grow_table(v) != 0)
    return MESH_NONE;
  size_t at = (size_t)hash & v->mask;
  for (; v->slot[at] != 0; at = (at + 1) & v->mask) {
    if (v->slot[at] >> 32 == hash >> 32) {
      const uint32_t id = (uint32_t)v->slot[at] - 1;
      const double *q = v->xyz + 3 * (size_t)id;
      if (q[0] == p[0] && q[1] == p[1] && q[2] == p[2])
        return id;
    }
  }
  return add(v, p, hash, at);
}
