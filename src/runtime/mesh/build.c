/* build.c - faces from a reader: welded, summed, remembered by their vertex numbers.
   SPDX-License-Identifier: GPL-3.0-or-later

   A batch at a time: the hashes of its corners first, so that the table's cache lines are on their
   way when they are needed. */
#include "mesh.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

int mesh_fail(struct mesh_build *b, int status, const char *format, ...) {
  if (b->message != NULL && b->message_size > 0) {
    va_list args;
    va_start(args, format);
    vsnprintf(b->message, b->message_size, format, args);
    va_end(args);
    for (char *s = b->message; *s != '\0'; s++) /* a file shall not steer the terminal */
      if ((*s >= 0 && *s < ' ') || *s == 127)
        *s = '?';
  }
  return status;
}

int mesh_fail_memory(struct mesh_build *b) {
  return mesh_fail(b, PH_EMEMORY, "%s", ph_status_phrase(PH_EMEMORY));
}

int mesh_fail_end(struct mesh_build *b, const char *what) {
  const unsigned long long at = b->in.offset + b->in.end;
  if (b->in.failed)
    return mesh_fail(b, PH_EFILE, "byte %llu: reading fails", at);
  return mesh_fail(b, PH_EFORMAT, "byte %llu: the file ends within %s", at, what);
}

int mesh_fail_line(struct mesh_build *b) {
  return mesh_fail(b, PH_EFORMAT, "line %llu: no text, or longer than %d bytes",
                   (unsigned long long)b->in.line, (int)MESH_BUFFER);
}

/* Room for n more: 0, or -1. */
static int reserve(struct mesh_list *list, size_t n) {
  if (list->capacity - list->count >= n)
    return 0;
  const size_t capacity = list->capacity ? 2 * list->capacity : 3 << 10;
  uint32_t *item = realloc(list->item, capacity * sizeof *item);
  if (item == NULL)
    return -1;
  list->item = item;
  list->capacity = capacity;
  return 0;
}

int mesh_list_push(struct mesh_build *b, struct mesh_list *list, uint32_t item) {
  if (reserve(list, 1) != 0)
    return mesh_fail_memory(b);
  list->item[list->count++] = item;
  return PH_OK;
}

/* Numbers for the corners of the batch that have none. */
static int weld(struct mesh_build *b) {
  struct mesh_batch *batch = &b->batch;
  uint64_t hash[MESH_BATCH][3];
  for (int k = 0; k < batch->count; k++)
    for (int i = 0; i < 3 && batch->id[k][0] == MESH_NONE; i++) {
      hash[k][i] = mesh_points_hash(batch->p[k] + 3 * i);
      mesh_points_fetch_slot(&b->points, hash[k][i]);
    }
  for (int k = 0; k < batch->count; k++)
    for (int i = 0; i < 3 && batch->id[k][0] == MESH_NONE; i++)
      mesh_points_fetch_vertex(&b->points, hash[k][i]);
  for (int k = 0; k < batch->count; k++) {
    if (batch->id[k][0] != MESH_NONE)
      continue;
    for (int i = 0; i < 3; i++) {
      batch->id[k][i] = mesh_points_weld(&b->points, batch->p[k] + 3 * i, hash[k][i]);
      if (batch->id[k][i] == MESH_NONE)
        return mesh_fail_memory(b);
    }
  }
  return PH_OK;
}

/* Remember the batch's triangles. Two equal corners make a line of no area whose two long edges are
   one: such a triangle is counted and left out, and its neighbours meet. */
static int remember(struct mesh_build *b) {
  const struct mesh_batch *batch = &b->batch;
  if (reserve(&b->corner, 3 * MESH_BATCH) != 0)
    return mesh_fail_memory(b);
  uint32_t *to = b->corner.item + b->corner.count;
  for (int k = 0; k < batch->count; k++) {
    const uint32_t *id = batch->id[k];
    if (!batch->fan[k]) {
      b->result.degenerate += (size_t)mesh_flat(batch->p[k]);
      if (id[0] == id[1] || id[1] == id[2] || id[2] == id[0])
        continue;
    }
    memcpy(to, id, sizeof batch->id[k]);
    to += 3;
  }
  b->corner.count = (size_t)(to - b->corner.item);
  return PH_OK;
}

int mesh_flush(struct mesh_build *b) {
  struct mesh_batch *batch = &b->batch;
  if (batch->count == 0)
    return PH_OK;
  if (!b->sum.begun)
    memcpy(b->sum.origin, batch->p[0], sizeof b->sum.origin);
  b->sum.begun = 1;
  int status = weld(b);
  if (status == PH_OK)
    status = remember(b);
  if (b->result.kind == PH_MESH_VOLUME)
    mesh_sum_volume(&b->sum, batch);
  else if (b->result.kind == PH_MESH_SURFACE)
    mesh_sum_surface(&b->sum, batch);
  batch->count = 0;
  return status;
}

/* Room in the batch for one more triangle. */
static int make_room(struct mesh_build *b) {
  return b->batch.count == MESH_BATCH ? mesh_flush(b) : PH_OK;
}

int mesh_add_triangle(struct mesh_build *b, const double p[9]) {
  const int status = make_room(b);
  if (status != PH_OK)
    return status;
  const int k = b->batch.count;
  double zero = 0; /* 0 * x is NaN for what is not finite */
  for (int i = 0; i < 9; i++) {
    b->batch.p[k][i] = p[i] + 0.0; /* -0 becomes 0 */
    zero += p[i] * 0;
  }
  b->result.faces++;
  if (!(zero == 0)) {
    b->result.nonfinite++;
    return PH_OK;
  }
  b->batch.id[k][0] = MESH_NONE;
  b->batch.sign[k] = 1;
  b->batch.fan[k] = 0;
  b->batch.count++;
  b->result.triangles++;
  return PH_OK;
}

int mesh_add_vertex(struct mesh_build *b, const double p[3]) {
  if (b->vertex_count == b->vertex_capacity) {
    const size_t capacity = b->vertex_capacity ? 2 * b->vertex_capacity : 1 << 10;
    double *vertex = realloc(b->vertex, 3 * capacity * sizeof *vertex);
    if (vertex != NULL)
      b->vertex = vertex;
    uint32_t *welded = vertex ? realloc(b->welded, capacity * sizeof *welded) : NULL;
    if (welded == NULL)
      return mesh_fail_memory(b);
    b->welded = welded;
    b->vertex_capacity = capacity;
  }
  if (b->vertex_count >= MESH_MAX)
    return mesh_fail(b, PH_EFORMAT, "more than %u vertices", (unsigned)MESH_MAX);
  for (int i = 0; i < 3; i++)
    b->vertex[3 * b->vertex_count + (size_t)i] = p[i] + 0.0;
  b->welded[b->vertex_count++] = MESH_NONE;
  return PH_OK;
}

/* The welded number of the file's vertex i, whose coordinates are finite. */
static int use_vertex(struct mesh_build *b, uint32_t i, uint32_t *id) {
  if (b->welded[i] == MESH_NONE) {
    const double *p = b->vertex + 3 * (size_t)i;
    b->welded[i] = mesh_points_weld(&b->points, p, mesh_points_hash(p));
    if (b->welded[i] == MESH_NONE)
      return mesh_fail_memory(b);
  }
  *id = b->welded[i];
  return PH_OK;
}

/* Vertices i, j, k of the file; diagonal: which of the edges i-j, j-k, k-i are a fan's. */
static int add_indexed(struct mesh_build *b, const uint32_t v[3], const int diagonal[3], int fan,
                       int sign) {
  int status = make_room(b);
  const int n = b->batch.count;
  for (int i = 0; i < 3 && status == PH_OK; i++) {
    memcpy(b->batch.p[n] + 3 * i, b->vertex + 3 * (size_t)v[i], 3 * sizeof(double));
    b->batch.id[n][i] = b->welded[v[i]] | (diagonal[i] ? MESH_DIAGONAL : 0);
  }
  b->batch.sign[n] = (signed char)sign;
  b->batch.fan[n] = (unsigned char)fan;
  b->batch.count += status == PH_OK;
  b->result.triangles++;
  return status;
}

/* Triangle i of the polygon's fan about its corner 0, i from 1: corners 0, i, i + 1. */
static void corners(const struct mesh_build *b, size_t i, double p[9], uint32_t v[3]) {
  v[0] = b->polygon.item[0], v[1] = b->polygon.item[i], v[2] = b->polygon.item[i + 1];
  for (size_t k = 0; k < 3; k++)
    memcpy(p + 3 * k, b->vertex + 3 * (size_t)v[k], 3 * sizeof p[0]);
}

/* Is the polygon, of vector area `area`, not flat? Then what another fan, from the corner after,
   would make of the measure goes into the result. A volume differs by the tetrahedra between both
   fans, seen from corner 0. */
static void bend(struct mesh_build *b, const ph_wide area[3], ph_wide fan) {
  const struct mesh_list *face = &b->polygon;
  const size_t n = face->count;
  const double *first = b->vertex + 3 * (size_t)face->item[0];
  ph_wide volume = 0, surface = 0, terms = 0;
  for (size_t i = 2; i < n; i++) {
    const size_t at[3] = {1, i, (i + 1) % n};
    double p[9];
    ph_wide normal[3], away[3];
    for (size_t k = 0; k < 3; k++)
      memcpy(p + 3 * k, b->vertex + 3 * (size_t)face->item[at[k]], 3 * sizeof p[0]);
    mesh_normal(p, normal);
    for (int k = 0; k < 3; k++)
      away[k] = (ph_wide)p[k] - (ph_wide)first[k];
    volume += wide_dot(normal, away);
    terms += wide_norm(normal) * wide_norm(away);
    surface += wide_norm(normal) * (wide_dot(normal, area) < 0 ? -1 : 1);
  }
  /* not flat by more than the last of six digits, which text often has */
  if (fabsl(volume) <= 1e-5L * terms)
    return;
  b->result.bent++;
  if (b->result.kind == PH_MESH_VOLUME)
    b->result.bend += (double)(fabsl(volume) / 6);
  else if (b->result.kind == PH_MESH_SURFACE)
    b->result.bend += (double)(fabsl(surface - fan) / 2);
}

/* A polygon of more than three corners. Triangles that are turned against its vector area, beside a
   reflex corner, count as negative in surface sums; in volumes the order of corners does that. */
static int add_fan(struct mesh_build *b) {
  const size_t n = b->polygon.count;
  ph_wide normal[3], area[3] = {0}, surface = 0;
  double p[9];
  uint32_t v[3];
  int flat = 1, status = PH_OK;
  for (size_t i = 1; i + 1 < n; i++) {
    corners(b, i, p, v);
    mesh_normal(p, normal);
    for (int k = 0; k < 3; k++)
      area[k] += normal[k];
    flat = flat && mesh_flat(p);
  }
  b->result.degenerate += (size_t)flat;
  for (size_t i = 1; i + 1 < n && status == PH_OK; i++) {
    const int diagonal[3] = {i > 1, 0, i + 2 < n};
    corners(b, i, p, v);
    mesh_normal(p, normal);
    const int sign = wide_dot(normal, area) < 0 ? -1 : 1;
    surface += wide_norm(normal) * sign;
    status = add_indexed(b, v, diagonal, 1, sign);
  }
  if (!flat)
    bend(b, area, surface);
  return status;
}

int mesh_add_polygon(struct mesh_build *b) {
  static const int none[3] = {0};
  struct mesh_list *face = &b->polygon;
  size_t kept = 0;
  b->result.faces++;
  for (size_t i = 0; i < face->count; i++)
    if (!wide_finite(3, b->vertex + 3 * (size_t)face->item[i])) {
      b->result.nonfinite++;
      return PH_OK;
    }
  for (size_t i = 0; i < face->count; i++) {
    uint32_t id;
    const int status = use_vertex(b, face->item[i], &id);
    if (status != PH_OK)
      return status;
    /* a polygon goes without a corner that repeats the one before; a triangle keeps all three */
    if (face->count == 3 || kept == 0 || b->welded[face->item[kept - 1]] != id)
      face->item[kept++] = face->item[i];
  }
  while (face->count > 3 && kept > 1 && b->welded[face->item[kept - 1]] == b->welded[face->item[0]])
    kept--;
  face->count = kept;
  if (kept < 3) {
    b->result.degenerate++;
    return PH_OK;
  }
  return kept == 3 ? add_indexed(b, face->item, none, 0, 1) : add_fan(b);
}

int mesh_add_segment(struct mesh_build *b, uint32_t from, uint32_t to) {
  b->result.segments++;
  if (!wide_finite(3, b->vertex + 3 * (size_t)from) ||
      !wide_finite(3, b->vertex + 3 * (size_t)to)) {
    b->result.nonfinite++;
    return PH_OK;
  }
  uint32_t u = 0, v = 0;
  int status = use_vertex(b, from, &u);
  if (status == PH_OK)
    status = use_vertex(b, to, &v);
  if (status != PH_OK || u == v) {
    b->result.degenerate += status == PH_OK;
    return status;
  }
  status = mesh_list_push(b, &b->segment, u);
  return status == PH_OK ? mesh_list_push(b, &b->segment, v) : status;
}
