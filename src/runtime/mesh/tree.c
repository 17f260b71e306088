/* tree.c - triangles in a tree of boxes: the nearest one, and how often they wind about a point.
   SPDX-License-Identifier: GPL-3.0-or-later

   The triangles are put in the order of a space-filling curve (Morton 1966); a node of the tree is
   a stretch of this order with the box of its triangles, split in the middle. Wires are triangles
   whose last two corners are one. */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>

enum { LEAF = 4, MOST_DEPTH = 40, BITS = 20, SHEARS = 8 };

struct filed {
  uint64_t key;
  uint32_t triangle;
};

static int by_key(const void *a, const void *b) {
  const struct filed *x = a, *y = b;
  return x->key != y->key ? (x->key > y->key) - (x->key < y->key)
                          : (x->triangle > y->triangle) - (x->triangle < y->triangle);
}

const double *mesh_tree_corner(const struct mesh_tree *tree, uint32_t triangle, int k) {
  const uint32_t v = tree->corner[3 * (size_t)triangle + (size_t)k] & ~MESH_DIAGONAL;
  return tree->xyz + 3 * (size_t)v;
}

/* Bits of the three places in turn, of the triangle's middle in the box of all. */
static uint64_t key_of(const struct mesh_tree *tree, uint32_t triangle, const double lo[3],
                       const double step[3]) {
  uint64_t key = 0, cell[3];
  for (int i = 0; i < 3; i++) {
    const double a = mesh_tree_corner(tree, triangle, 0)[i],
                 b = mesh_tree_corner(tree, triangle, 1)[i],
                 c = mesh_tree_corner(tree, triangle, 2)[i];
    const double at = ((a / 3 + b / 3 + c / 3) - lo[i]) * step[i];
    cell[i] = at > 0 ? at < (1 << BITS) ? (uint64_t)at : (1 << BITS) - 1 : 0;
  }
  for (int bit = BITS - 1; bit >= 0; bit--)
    for (int i = 0; i < 3; i++)
      key = key << 1 | (cell[i] >> bit & 1);
  return key;
}

static void widen(double box[6], const double p[3]) {
  for (int i = 0; i < 3; i++) {
    box[i] = p[i] < box[i] ? p[i] : box[i];
    box[3 + i] = p[i] > box[3 + i] ? p[i] : box[3 + i];
  }
}

static const double nowhere[6] = {HUGE_VAL, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

/* Boxes of node k, which has the triangles [from, to). */
static void enclose(struct mesh_tree *tree, size_t k, size_t from, size_t to, int depth) {
  double *box = tree->box + 6 * k;
  memcpy(box, nowhere, sizeof nowhere);
  if (depth == tree->depth) {
    for (size_t t = from; t < to; t++)
      for (int i = 0; i < 3; i++)
        widen(box, mesh_tree_corner(tree, tree->order[t], i));
    return;
  }
  const size_t middle = from + (to - from) / 2;
  enclose(tree, 2 * k + 1, from, middle, depth + 1);
  enclose(tree, 2 * k + 2, middle, to, depth + 1);
  for (size_t child = 2 * k + 1; child <= 2 * k + 2; child++)
    if (tree->box[6 * child] <= tree->box[6 * child + 3]) {
      widen(box, tree->box + 6 * child);
      widen(box, tree->box + 6 * child + 3);
    }
}

int mesh_tree_make(struct mesh_tree *tree, const double *xyz, const uint32_t *corner,
                   const uint32_t *list, size_t n) {
  memset(tree, 0, sizeof *tree);
  tree->xyz = xyz, tree->corner = corner, tree->count = n;
  while ((n >> tree->depth) > LEAF && tree->depth < MOST_DEPTH)
    tree->depth++;
  struct filed *filed = malloc((n + 1) * sizeof *filed);
  tree->order = malloc((n + 1) * sizeof *tree->order);
  tree->box = malloc(((size_t)2 << tree->depth) * 6 * sizeof *tree->box);
  if (filed == NULL || tree->order == NULL || tree->box == NULL) {
    free(filed);
    mesh_tree_free(tree);
    return PH_EMEMORY;
  }
  double box[6], step[3];
  memcpy(box, nowhere, sizeof box);
  for (size_t t = 0; t < n; t++)
    for (int i = 0; i < 3; i++)
      widen(box, mesh_tree_corner(tree, list ? list[t] : (uint32_t)t, i));
  for (int i = 0; i < 3; i++)
    step[i] = box[3 + i] > box[i] ? (1 << BITS) / (box[3 + i] - box[i]) : 0;
  for (size_t t = 0; t < n; t++) {
    filed[t].triangle = list ? list[t] : (uint32_t)t;
    filed[t].key = key_of(tree, filed[t].triangle, box, step);
  }
  qsort(filed, n, sizeof *filed, by_key);
  for (size_t t = 0; t < n; t++)
    tree->order[t] = filed[t].triangle;
  free(filed);
  enclose(tree, 0, 0, n, 0);
  return PH_OK;
}

void mesh_tree_free(struct mesh_tree *tree) {
  free(tree->order);
  free(tree->box);
  memset(tree, 0, sizeof *tree);
}

/* ---- the nearest triangle ---- */

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Square of the distance from p to the piece a + t (b - a), 0 <= t <= 1. */
static double to_segment(const double p[3], const double a[3], const double b[3]) {
  double e[3], d[3];
  for (int i = 0; i < 3; i++)
    e[i] = b[i] - a[i], d[i] = p[i] - a[i];
  const double along = dot(d, e), whole = dot(e, e);
  const double t = along > 0 && whole > 0 ? along < whole ? along / whole : 1 : 0;
  for (int i = 0; i < 3; i++)
    d[i] -= t * e[i];
  return dot(d, d);
}

/* Square of the distance from p to the triangle: above its inside to the plane, else to a side. */
static double to_triangle(const double p[3], const double *a, const double *b, const double *c) {
  double e[3], f[3], d[3];
  for (int i = 0; i < 3; i++)
    e[i] = b[i] - a[i], f[i] = c[i] - a[i], d[i] = p[i] - a[i];
  const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), de = dot(d, e), df = dot(d, f);
  const double area = ee * ff - ef * ef;
  const double v = ff * de - ef * df, w = ee * df - ef * de;
  if (area > 1e-12 * ee * ff && v >= 0 && w >= 0 && v + w <= area) {
    for (int i = 0; i < 3; i++)
      d[i] -= (v * e[i] + w * f[i]) / area;
    return dot(d, d);
  }
  const double x = to_segment(p, a, b), y = to_segment(p, b, c), z = to_segment(p, c, a);
  return fmin(x, fmin(y, z));
}

static double to_box(const double p[3], const double box[6]) {
  double sum = 0;
  for (int i = 0; i < 3; i++) {
    const double d = fmax(fmax(box[i] - p[i], p[i] - box[3 + i]), 0);
    sum += d * d;
  }
  return sum;
}

static void nearest(const struct mesh_tree *tree, size_t k, size_t from, size_t to, int depth,
                    const double p[3], double *best) {
  if (depth == tree->depth) {
    for (size_t t = from; t < to; t++) {
      const uint32_t id = tree->order[t];
      const double *a = mesh_tree_corner(tree, id, 0), *b = mesh_tree_corner(tree, id, 1),
                   *c = mesh_tree_corner(tree, id, 2);
      *best = fmin(*best, to_triangle(p, a, b, c));
    }
    return;
  }
  const size_t middle = from + (to - from) / 2;
  const double a = to_box(p, tree->box + 6 * (2 * k + 1)),
               b = to_box(p, tree->box + 6 * (2 * k + 2));
  for (int turn = 0; turn < 2; turn++) {
    const int first = (a <= b) == (turn == 0);
    if ((first ? a : b) >= *best)
      continue;
    if (first)
      nearest(tree, 2 * k + 1, from, middle, depth + 1, p, best);
    else
      nearest(tree, 2 * k + 2, middle, to, depth + 1, p, best);
  }
}

double mesh_tree_distance(const struct mesh_tree *tree, const double p[3], double most) {
  double best = most * most;
  nearest(tree, 0, 0, tree->count, 0, p, &best);
  return sqrt(best);
}

/* ---- winding ----

   A ray from p along (s, t, 1), seen along itself: u = x - s z, v = y - t z, and p is the origin.
   A triangle that has the origin inside is crossed, upward or downward by its orientation there.
   Of an edge that two triangles share both form the same two products, so no ray slips between
   them; one that meets an edge exactly is given up for another. */

struct ray {
  double p[3], s, t;
  const signed char *turn;
  const uint32_t *part;
  int winding, hit_edge;
};

static void cross_triangle(struct ray *ray, const double *const corner[3], int sign) {
  double u[3], v[3], w[3];
  for (int k = 0; k < 3; k++) {
    w[k] = corner[k][2] - ray->p[2];
    u[k] = corner[k][0] - ray->p[0] - ray->s * w[k];
    v[k] = corner[k][1] - ray->p[1] - ray->t * w[k];
  }
  /* products rounded one by one: fused ones would differ between two triangles of an edge */
  volatile double m[6];
  double area[3];
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    m[2 * k] = u[i] * v[j], m[2 * k + 1] = u[j] * v[i];
    area[k] = m[2 * k] - m[2 * k + 1];
  }
  const int up = area[0] >= 0 && area[1] >= 0 && area[2] >= 0;
  const int down = area[0] <= 0 && area[1] <= 0 && area[2] <= 0;
  if (!up && !down)
    return;
  const double whole = area[0] + area[1] + area[2];
  const double height = area[0] * w[0] + area[1] * w[1] + area[2] * w[2];
  if (area[0] == 0 || area[1] == 0 || area[2] == 0)
    ray->hit_edge = 1;
  else if (height / whole > 0)
    ray->winding += whole > 0 ? sign : -sign;
}

/* Does the ray meet the box?  Widened by rounding's share of the places. */
static int meets(const struct ray *ray, const double box[6]) {
  double from = 0, to = HUGE_VAL;
  const double d[3] = {ray->s, ray->t, 1};
  for (int i = 0; i < 3; i++) {
    const double wide = 0x1p-48 * (fabs(box[i]) + fabs(box[3 + i]) + fabs(ray->p[i]));
    const double a = (box[i] - wide - ray->p[i]) / d[i], b = (box[3 + i] + wide - ray->p[i]) / d[i];
    from = fmax(from, fmin(a, b)), to = fmin(to, fmax(a, b));
  }
  return from <= to * (1 + 0x1p-40);
}

static void follow(const struct mesh_tree *tree, struct ray *ray, size_t k, size_t from, size_t to,
                   int depth) {
  if (from == to || ray->hit_edge || !meets(ray, tree->box + 6 * k))
    return;
  if (depth < tree->depth) {
    const size_t middle = from + (to - from) / 2;
    follow(tree, ray, 2 * k + 1, from, middle, depth + 1);
    follow(tree, ray, 2 * k + 2, middle, to, depth + 1);
    return;
  }
  for (size_t t = from; t < to; t++) {
    const uint32_t id = tree->order[t];
    const double *const corner[3] = {mesh_tree_corner(tree, id, 0), mesh_tree_corner(tree, id, 1),
                                     mesh_tree_corner(tree, id, 2)};
    cross_triangle(ray, corner, ray->turn ? ray->turn[ray->part[id]] : 1);
  }
}

int mesh_tree_winding(const struct mesh_tree *tree, const double p[3], const uint32_t *part,
                      const signed char *turn) {
  struct ray ray = {.part = part, .turn = turn};
  memcpy(ray.p, p, sizeof ray.p);
  for (int k = 1; k <= SHEARS; k++) {
    /* multiples of two irrational numbers, modulo 1: no direction that a drawing would have */
    ray.s = fmod(0.6180339887498949 * k, 1) - 0.4876, ray.t = fmod(0.4142135623730950 * k, 1) - 0.5;
    ray.winding = ray.hit_edge = 0;
    follow(tree, &ray, 0, 0, tree->count, 0);
    if (!ray.hit_edge)
      break;
  }
  return ray.winding;
}
