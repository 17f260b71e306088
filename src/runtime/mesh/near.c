/* near.c - vertices that are near each other welded: what exporters write twice, differently.
   SPDX-License-Identifier: GPL-3.0-or-later

   The tolerance is a part of the box's longest side, for the differences come from the digits that
   were written: 2^-24 of a coordinate in binary STL, the last of 6 digits in text. So a file means
   the same in every unit. A grid of cells as wide as the tolerance holds the vertices that stay;
   each vertex goes to the first of these within the tolerance, which lies in its cell or in one of
   the 26 around. Vertices that stay are farther apart than the tolerance, so a cell holds few. */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>

struct grid {
  double lo[3], width;
  uint32_t *first; /* of each slot: vertex + 1; 0: none */
  uint32_t *next;  /* of each vertex: the next in its slot */
  size_t mask;
};

static double longest_side(const struct mesh_points *v) {
  double side = 0;
  for (int i = 0; i < 3; i++)
    side = fmax(side, v->hi[i] - v->lo[i]);
  return side;
}

static size_t slot_of(const struct grid *g, const double cell[3]) {
  double key[3];
  for (int i = 0; i < 3; i++)
    key[i] = cell[i] + 0.0;
  return (size_t)mesh_points_hash(key) & g->mask;
}

/* The vertex that p becomes: one that stays and is near, or MESH_NONE. */
static uint32_t find(const struct grid *g, const double *xyz, const double p[3], double *gap) {
  for (int n = 0; n < 27; n++) {
    const int step[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
    double cell[3];
    for (int i = 0; i < 3; i++)
      cell[i] = floor((p[i] - g->lo[i]) / g->width) + step[i];
    for (uint32_t v = g->first[slot_of(g, cell)]; v != 0; v = g->next[v - 1]) {
      const double *q = xyz + 3 * (size_t)(v - 1);
      const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
      const double d = sqrt(x * x + y * y + z * z);
      if (d <= g->width) {
        *gap = fmax(*gap, d);
        return v - 1;
      }
    }
  }
  return MESH_NONE;
}

/* to[i]: what becomes of vertex i. */
static void settle(struct mesh_build *b, struct grid *g, uint32_t *to) {
  for (size_t i = 0; i < b->points.count; i++) {
    const double *p = b->points.xyz + 3 * i;
    double cell[3];
    to[i] = find(g, b->points.xyz, p, &b->result.gap);
    if (to[i] != MESH_NONE) {
      b->result.merged++;
      continue;
    }
    to[i] = (uint32_t)i;
    for (int k = 0; k < 3; k++)
      cell[k] = floor((p[k] - g->lo[k]) / g->width);
    const size_t slot = slot_of(g, cell);
    g->next[i] = g->first[slot];
    g->first[slot] = (uint32_t)i + 1;
  }
}

/* The corners by their new numbers; what has become a line or a point is left out. */
static void renumber(struct mesh_build *b, const uint32_t *to) {
  uint32_t *c = b->corner.item, *s = b->segment.item;
  size_t kept = 0;
  for (size_t t = 0; t < b->corner.count; t += 3) {
    uint32_t v[3];
    for (size_t k = 0; k < 3; k++)
      v[k] = to[c[t + k] & ~MESH_DIAGONAL] | (c[t + k] & MESH_DIAGONAL);
    const uint32_t x = v[0] & ~MESH_DIAGONAL, y = v[1] & ~MESH_DIAGONAL, z = v[2] & ~MESH_DIAGONAL;
    if (x != y && y != z && z != x) {
      memcpy(c + kept, v, sizeof v);
      kept += 3;
    }
  }
  b->corner.count = kept;
  kept = 0;
  for (size_t t = 0; t < b->segment.count; t += 2)
    if (to[s[t]] != to[s[t + 1]]) {
      const uint32_t u = to[s[t]], v = to[s[t + 1]];
      s[kept++] = u, s[kept++] = v;
    }
  b->segment.count = kept;
}

int mesh_near(struct mesh_build *b) {
  const size_t n = b->points.count;
  struct grid g = {.mask = 1, .width = b->weld * longest_side(&b->points)};
  b->result.merged = 0, b->result.gap = 0, b->result.weld = b->weld;
  if (!(g.width > 0))
    return PH_OK;
  memcpy(g.lo, b->points.lo, sizeof g.lo);
  while (g.mask < 2 * n)
    g.mask = 2 * g.mask + 1;
  g.first = calloc(g.mask + 1, sizeof *g.first);
  g.next = calloc(n, sizeof *g.next);
  uint32_t *to = malloc(n * sizeof *to);
  const int whole = g.first != NULL && g.next != NULL && to != NULL;
  if (whole) {
    settle(b, &g, to);
    renumber(b, to);
  }
  free(g.first);
  free(g.next);
  free(to);
  return whole ? PH_OK : mesh_fail_memory(b);
}

int mesh_near_offer(struct mesh_build *b) {
  static const double tries[] = {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3};
  const struct mesh_list own = b->corner;
  const ph_mesh seen = b->result;
  ph_mesh found = seen;
  struct mesh_list copy = {malloc((own.count + 1) * sizeof *copy.item), own.count, own.count};
  int status = PH_OK;
  if (copy.item == NULL)
    return mesh_fail_memory(b);
  for (size_t k = 0; k < sizeof tries / sizeof tries[0] && status == PH_OK; k++) {
    if (found.weld > 0)
      break;
    memcpy(copy.item, own.item, own.count * sizeof *copy.item);
    b->corner = copy;
    b->weld = tries[k];
    b->result.unbalanced = 0;
    status = mesh_near(b);
    const size_t merged = b->result.merged;
    if (status == PH_OK && merged > found.merged) /* else nothing is new */
      status = mesh_topology(b);
    /* most of the mesh must be left: everything in one point would close as well */
    if (status == PH_OK && merged > found.merged && b->result.unbalanced == 0 &&
        2 * b->corner.count >= own.count) {
      found.weld = tries[k];
      found.gap = b->result.gap;
    }
    found.merged = merged;
    free(b->part);
    b->part = NULL;
  }
  found.merged = 0;
  free(copy.item);
  b->corner = own;
  b->result = found;
  b->weld = 0;
  return status;
}

void mesh_sum_again(struct mesh_build *b) {
  struct mesh_batch *batch = &b->batch;
  memset(b->sum.head, 0, sizeof b->sum.head);
  memset(b->sum.tail, 0, sizeof b->sum.tail);
  batch->count = 0;
  for (size_t t = 0; t < b->corner.count / 3; t++) {
    const uint32_t *c = b->corner.item + 3 * t;
    const int behind = b->turn != NULL && b->turn[b->part[t]] < 0;
    for (int k = 0; k < 3; k++) {
      const uint32_t v = c[k == 0 || !behind ? k : 3 - k] & ~MESH_DIAGONAL;
      memcpy(batch->p[batch->count] + 3 * k, b->points.xyz + 3 * (size_t)v, 3 * sizeof(double));
    }
    if (++batch->count == MESH_BATCH) {
      mesh_sum_volume(&b->sum, batch);
      batch->count = 0;
    }
  }
  mesh_sum_volume(&b->sum, batch);
  batch->count = 0;
}
