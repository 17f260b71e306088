/* faces.c - the faces of a mesh that was read, kept to be asked about points.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>

struct ph_mesh_shape {
  ph_mesh_kind kind;
  int side; /* -1: the whole is inside out */
  double *xyz;
  uint32_t *corner, *part;
  signed char *turn;
  size_t count;
  int planted; /* the tree is there: it is made for the first question */
  struct mesh_tree tree;
};

/* Edges as triangles whose last two corners are one; one of two faces stands twice, which does not
   matter to what is asked. NULL: out of memory. */
static uint32_t *edges(const struct mesh_build *b, size_t *count) {
  const size_t corners = b->corner.count, segments = b->segment.count / 2;
  uint32_t *list = malloc(3 * (corners + segments + 1) * sizeof *list);
  size_t n = 0;
  for (size_t i = 0; list != NULL && i < corners; i++) {
    const uint32_t *c = b->corner.item + i / 3 * 3;
    if ((c[i % 3] & MESH_DIAGONAL) == 0) {
      list[n] = c[i % 3];
      list[n + 1] = list[n + 2] = c[(i + 1) % 3] & ~MESH_DIAGONAL;
      n += 3;
    }
  }
  for (size_t i = 0; list != NULL && i < segments; i++, n += 3) {
    list[n] = b->segment.item[2 * i];
    list[n + 1] = list[n + 2] = b->segment.item[2 * i + 1];
  }
  *count = n / 3;
  return list;
}

ph_mesh_shape *mesh_shape(struct mesh_build *b) {
  ph_mesh_shape *s = calloc(1, sizeof *s);
  if (s == NULL)
    return NULL;
  s->kind = b->result.kind;
  s->side = b->result.inverted ? -1 : 1;
  s->xyz = b->points.xyz, b->points.xyz = NULL;
  if (s->kind == PH_MESH_WIRES) {
    s->corner = edges(b, &s->count);
  } else {
    s->corner = b->corner.item, b->corner.item = NULL;
    s->count = b->corner.count / 3;
    s->part = b->part, b->part = NULL;
    s->turn = b->turn, b->turn = NULL;
  }
  if (s->corner == NULL) {
    ph_mesh_close(s);
    return NULL;
  }
  return s;
}

void ph_mesh_close(ph_mesh_shape *shape) {
  if (shape == NULL)
    return;
  mesh_tree_free(&shape->tree);
  free(shape->xyz);
  free(shape->corner);
  free(shape->part);
  free(shape->turn);
  free(shape);
}

double ph_mesh_excess(ph_mesh_shape *shape, const double p[3]) {
  if (!shape->planted &&
      mesh_tree_make(&shape->tree, shape->xyz, shape->corner, NULL, shape->count) != PH_OK)
    return NAN;
  shape->planted = 1;
  const double far = mesh_tree_distance(&shape->tree, p, HUGE_VAL);
  if (shape->kind != PH_MESH_VOLUME)
    return far;
  const int winding = mesh_tree_winding(&shape->tree, p, shape->part, shape->turn);
  return winding * shape->side > 0 ? -far : far;
}

size_t ph_mesh_count(const ph_mesh_shape *shape) {
  return shape->count;
}

int ph_mesh_triangle(const ph_mesh_shape *shape, size_t i, double corner[9]) {
  if (i >= shape->count)
    return PH_ECOUNT;
  const int behind = shape->side * (shape->turn ? shape->turn[shape->part[i]] : 1) < 0;
  for (size_t k = 0; k < 3; k++) {
    const uint32_t v = shape->corner[3 * i + (behind && k > 0 ? 3 - k : k)] & ~MESH_DIAGONAL;
    memcpy(corner + 3 * k, shape->xyz + 3 * (size_t)v, 3 * sizeof(double));
  }
  return PH_OK;
}
