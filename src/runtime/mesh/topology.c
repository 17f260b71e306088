/* topology.c - edges: open, flipped, shared by too many; triangles that repeat others; parts.
   SPDX-License-Identifier: GPL-3.0-or-later

   Every edge of every triangle, and every segment, is a record filed under its lower vertex u
   (counting sort), then ordered within u by its higher vertex v and the triangle:

       v: 31 bits | triangle: 31 bits | code: 2 bits

   Equal edges are then neighbours. Records are as many as the corners that were read. A part is
   what edges of two faces hold together, and, where that alone would not close, edges of more. */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>

enum { ALONG, AGAINST, DIAGONAL, SEGMENT }; /* code; ALONG: the face runs from u to v */

static uint64_t record(uint32_t v, size_t triangle, unsigned code) {
  return (uint64_t)v << 33 | (uint64_t)triangle << 2 | code;
}

static size_t triangle_of(uint64_t r) {
  return (size_t)(r >> 2 & 0x7fffffff);
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

static inline void file_edge(uint64_t *r, size_t *at, uint32_t x, uint32_t y, size_t triangle) {
  const uint32_t from = x & ~MESH_DIAGONAL, to = y & ~MESH_DIAGONAL;
  const unsigned code = x & MESH_DIAGONAL ? DIAGONAL : from < to ? ALONG : AGAINST;
  if (from < to)
    r[at[from]++] = record(to, triangle, code);
  else if (to < from)
    r[at[to]++] = record(from, triangle, code);
}

/* Puts the records in their places; at[u] is then the place behind the last of u. */
static void file_all(const struct mesh_build *b, uint64_t *r, size_t *at) {
  const uint32_t *c = b->corner.item, *s = b->segment.item;
  for (size_t t = 0; t < b->corner.count; t += 3) {
    file_edge(r, at, c[t], c[t + 1], t / 3);
    file_edge(r, at, c[t + 1], c[t + 2], t / 3);
    file_edge(r, at, c[t + 2], c[t], t / 3);
  }
  for (size_t t = 0; t < b->segment.count; t += 2) {
    const uint32_t u = s[t] < s[t + 1] ? s[t] : s[t + 1], v = s[t] < s[t + 1] ? s[t + 1] : s[t];
    r[at[u]++] = record(v, 0, SEGMENT);
  }
}

/* ---- parts ---- */

static uint32_t root(uint32_t *part, uint32_t t) {
  while (part[t] != t)
    t = part[t] = part[part[t]];
  return t;
}

static void unite(uint32_t *part, size_t a, size_t b) {
  const uint32_t x = root(part, (uint32_t)a), y = root(part, (uint32_t)b);
  if (x < y)
    part[y] = x;
  else
    part[x] = y;
}

/* Of the n records of an edge: do the triangles of one part run along it as often one way as the
   other? */
static int closes(uint32_t *part, const uint64_t *r, size_t n) {
  for (size_t i = 0; i < n; i++) {
    if ((r[i] & 3) == SEGMENT)
      continue;
    const uint32_t own = root(part, (uint32_t)triangle_of(r[i]));
    int sum = 0;
    for (size_t k = 0; k < n; k++)
      if (root(part, (uint32_t)triangle_of(r[k])) == own)
        sum += (r[k] & 3) == ALONG ? 1 : (r[k] & 3) == AGAINST ? -1 : 0;
    if (sum != 0)
      return 0;
  }
  return 1;
}

/* The n records of one edge hold triangles together: neighbours in a fan along its diagonal, two
   faces; with `all` more faces too, if their parts do not close without. */
static void hold(uint32_t *part, const uint64_t *r, size_t n, int all) {
  size_t faces = 0, last[2] = {0}, fan = SIZE_MAX;
  for (size_t i = 0; i < n; i++) {
    const size_t t = triangle_of(r[i]);
    const unsigned code = (unsigned)(r[i] & 3);
    if (code == DIAGONAL && fan != SIZE_MAX && t == fan + 1)
      unite(part, fan, t);
    if (code == DIAGONAL)
      fan = t;
    if (code <= AGAINST)
      last[faces++ % 2] = t;
  }
  if (faces == 2)
    unite(part, last[0], last[1]);
  else if (all && faces > 2 && !closes(part, r, n))
    for (size_t i = 0; i < n; i++)
      if ((r[i] & 3) <= AGAINST)
        unite(part, last[0], triangle_of(r[i]));
}

/* ---- edges ---- */

/* The n records of one edge (u, v). Returns whether it is an edge: of a face, or a segment. */
static int look(ph_mesh *m, const uint64_t *r, size_t n) {
  size_t uses[4] = {0};
  for (size_t i = 0; i < n; i++)
    uses[r[i] & 3]++;
  const size_t faces = uses[ALONG] + uses[AGAINST];
  m->edges += faces > 0;
  m->open += faces == 1;
  m->flipped += faces == 2 && uses[ALONG] != 1;
  m->nonmanifold += faces > 2;
  m->unbalanced += uses[ALONG] != uses[AGAINST];
  return faces > 0 || uses[SEGMENT] > 0;
}

/* Triangles with the n records of the edge (u, v) that have the third corner of another. Each is
   looked at once, at its two lower corners.  The records become these corners. */
static size_t repeated(const struct mesh_build *b, size_t u, uint64_t *r, size_t n) {
  const uint64_t v = r[0] >> 33;
  size_t thirds = 0, found = 0;
  for (size_t i = 0; i < n; i++) {
    if ((r[i] & 3) == SEGMENT)
      continue;
    const uint32_t *c = b->corner.item + 3 * triangle_of(r[i]);
    const uint64_t third = (uint64_t)(c[0] & ~MESH_DIAGONAL) + (c[1] & ~MESH_DIAGONAL) +
                           (c[2] & ~MESH_DIAGONAL) - u - v;
    if (third > v)
      r[thirds++] = third;
  }
  sort(r, thirds);
  for (size_t i = 1; i < thirds; i++)
    found += r[i] == r[i - 1];
  return found;
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

/* Where the records of the edge at `first` end. */
static size_t edge_end(const uint64_t *r, size_t first, size_t end) {
  size_t next = first + 1;
  while (next < end && r[next] >> 33 == r[first] >> 33)
    next++;
  return next;
}

/* Every triangle's part, named by its first triangle, of a mesh that closes. */
static int divide(struct mesh_build *b, const uint64_t *r, const size_t *at) {
  const size_t triangles = b->corner.count / 3;
  b->part = malloc((triangles + 1) * sizeof *b->part);
  if (b->part == NULL)
    return mesh_fail_memory(b);
  for (size_t t = 0; t < triangles; t++)
    b->part[t] = (uint32_t)t;
  const int rounds = b->result.nonmanifold > 0 ? 2 : 1;
  for (int all = 0; all < rounds; all++)
    for (size_t u = 0, first = 0; u < b->points.count; first = at[u++])
      for (size_t i = first, next; i < at[u]; i = next) {
        next = edge_end(r, i, at[u]);
        hold(b->part, r + i, next - i, all);
      }
  for (size_t t = 0; t < triangles; t++)
    b->part[t] = root(b->part, (uint32_t)t);
  return PH_OK;
}

int mesh_topology(struct mesh_build *b) {
  const size_t vertices = b->points.count;
  struct wires wires = {0};
  int status = PH_OK;
  if (vertices == 0)
    return PH_OK;
  size_t *at = calloc(vertices + 1, sizeof *at);
  const size_t records = at ? count(b, at) : 0;
  uint64_t *r = at ? malloc((records + 1) * sizeof *r) : NULL;
  if (r == NULL || b->corner.count / 3 >= MESH_MAX) {
    free(at);
    free(r);
    return mesh_fail_memory(b);
  }
  file_all(b, r, at);
  memcpy(b->sum.origin, b->points.xyz, sizeof b->sum.origin);
  for (size_t u = 0, first = 0; u < vertices; first = at[u++]) {
    sort(r + first, at[u] - first);
    for (size_t i = first, next; i < at[u]; i = next) {
      next = edge_end(r, i, at[u]);
      if (look(&b->result, r + i, next - i) && b->result.kind == PH_MESH_WIRES)
        add_wire(b, &wires, u, (size_t)(r[i] >> 33));
    }
  }
  mesh_sum_block(&b->sum, wires.block);
  if (b->result.kind == PH_MESH_VOLUME && b->result.unbalanced == 0)
    status = divide(b, r, at);
  for (size_t u = 0, first = 0; u < vertices; first = at[u++])
    for (size_t i = first, next; i < at[u]; i = next) {
      next = edge_end(r, i, at[u]);
      b->result.duplicate += repeated(b, u, r + i, next - i);
    }
  free(r);
  free(at);
  return status;
}
