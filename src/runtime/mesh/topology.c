/* topology.c - edges: open, flipped, shared by too many; triangles that repeat others.
   SPDX-License-Identifier: GPL-3.0-or-later

   Every edge of every triangle, and every segment, is a record filed under its lower vertex u
   (counting sort), then ordered within u by its higher vertex v and the triangle's third:

       v: 31 bits | third: 31 bits | code: 2 bits

   Equal edges are then neighbours. Records are as many as the corners that were read. */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>

enum { ALONG, AGAINST, DIAGONAL, SEGMENT }; /* code; ALONG: the face runs from u to v */

static uint64_t record(uint32_t v, uint32_t third, unsigned code) {
  return (uint64_t)v << 33 | (uint64_t)third << 2 | code;
}

static int ascending(const void *a, const void *b) {
  const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
  return (x > y) - (x < y);
}

/* A vertex has few edges; where it has many (the apex of a fan), insertion would be quadratic. */
static void sort(uint64_t *r, size_t n) {
  if (n > 40) {
    qsort(r, n, sizeof *r, ascending);
    return;
  }
  for (size_t i = 1; i < n; i++) {
    const uint64_t x = r[i];
    size_t j = i;
    for (; j > 0 && r[j - 1] > x; j--)
      r[j] = r[j - 1];
    r[j] = x;
  }
}

/* at[u + 1] becomes the number of records of vertex u, and then at[u] the place of its first. */
static size_t count(const struct mesh_build *b, size_t *at) {
  const uint32_t *c = b->corner.item, *s = b->segment.item;
  for (size_t t = 0; t < b->corner.count; t += 3) {
    const uint32_t x = c[t] & ~MESH_DIAGONAL, y = c[t + 1] & ~MESH_DIAGONAL,
                   z = c[t + 2] & ~MESH_DIAGONAL;
    at[1 + (x < y ? x : y)] += x != y;
    at[1 + (y < z ? y : z)] += y != z;
    at[1 + (z < x ? z : x)] += z != x;
  }
  for (size_t t = 0; t < b->segment.count; t += 2)
    at[1 + (s[t] < s[t + 1] ? s[t] : s[t + 1])]++;
  for (size_t i = 1; i <= b->points.count; i++)
    at[i] += at[i - 1];
  return at[b->points.count];
}

static inline void file_edge(uint64_t *r, size_t *at, uint32_t x, uint32_t y, uint32_t z) {
  const uint32_t from = x & ~MESH_DIAGONAL, to = y & ~MESH_DIAGONAL, third = z & ~MESH_DIAGONAL;
  const unsigned code = x & MESH_DIAGONAL ? DIAGONAL : from < to ? ALONG : AGAINST;
  if (from < to)
    r[at[from]++] = record(to, third, code);
  else if (to < from)
    r[at[to]++] = record(from, third, code);
}

/* Puts the records in their places; at[u] is then the place behind the last of u. */
static void file_all(const struct mesh_build *b, uint64_t *r, size_t *at) {
  const uint32_t *c = b->corner.item, *s = b->segment.item;
  for (size_t t = 0; t < b->corner.count; t += 3) {
    file_edge(r, at, c[t], c[t + 1], c[t + 2]);
    file_edge(r, at, c[t + 1], c[t + 2], c[t]);
    file_edge(r, at, c[t + 2], c[t], c[t + 1]);
  }
  for (size_t t = 0; t < b->segment.count; t += 2) {
    const uint32_t u = s[t] < s[t + 1] ? s[t] : s[t + 1], v = s[t] < s[t + 1] ? s[t + 1] : s[t];
    r[at[u]++] = record(v, 0, SEGMENT);
  }
}

/* The n records of one edge (u, v). Returns whether it is an edge: of a face, or a segment. */
static int look(ph_mesh *m, const uint64_t *r, size_t n) {
  size_t uses[4] = {0};
  const uint64_t v = r[0] >> 33;
  uint64_t last = 0; /* third corner of the triangle before; no third is 0, since u < v < third */
  for (size_t i = 0; i < n; i++) {
    const uint64_t third = r[i] >> 2 & 0x7fffffff, code = r[i] & 3;
    uses[code]++;
    if (code != SEGMENT && third > v) { /* each triangle once: at its two lower corners */
      m->duplicate += third == last;
      last = third;
    }
  }
  const size_t faces = uses[ALONG] + uses[AGAINST];
  m->edges += faces > 0;
  m->open += faces == 1;
  m->flipped += faces == 2 && uses[ALONG] != 1;
  m->nonmanifold += faces > 2;
  m->unbalanced += uses[ALONG] != uses[AGAINST];
  return faces > 0 || uses[SEGMENT] > 0;
}

struct wires {
  ph_wide block[MESH_TERMS];
  int count;
};

static void add_wire(struct mesh_build *b, struct wires *w, size_t u, size_t v) {
  double p[6];
  memcpy(p, b->points.xyz + 3 * u, 3 * sizeof p[0]);
  memcpy(p + 3, b->points.xyz + 3 * v, 3 * sizeof p[0]);
  mesh_sum_segment(&b->sum, p, w->block);
  if (++w->count == MESH_BATCH) {
    mesh_sum_block(&b->sum, w->block);
    memset(w, 0, sizeof *w);
  }
}

int mesh_topology(struct mesh_build *b) {
  const size_t vertices = b->points.count;
  struct wires wires = {0};
  if (vertices == 0)
    return PH_OK;
  size_t *at = calloc(vertices + 1, sizeof *at);
  const size_t records = at ? count(b, at) : 0;
  uint64_t *r = at ? malloc((records + 1) * sizeof *r) : NULL;
  if (r == NULL) {
    free(at);
    return mesh_fail_memory(b);
  }
  file_all(b, r, at);
  memcpy(b->sum.origin, b->points.xyz, sizeof b->sum.origin);
  for (size_t u = 0, first = 0; u < vertices; first = at[u++]) {
    sort(r + first, at[u] - first);
    for (size_t i = first, next; i < at[u]; i = next) {
      for (next = i + 1; next < at[u] && r[next] >> 33 == r[i] >> 33; next++)
        ;
      if (look(&b->result, r + i, next - i) && b->result.kind == PH_MESH_WIRES)
        add_wire(b, &wires, u, (size_t)(r[i] >> 33));
    }
  }
  mesh_sum_block(&b->sum, wires.block);
  free(r);
  free(at);
  return PH_OK;
}
