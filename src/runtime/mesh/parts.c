/* parts.c - how the closed parts of a mesh lie: side by side, in each other, or across.
   SPDX-License-Identifier: GPL-3.0-or-later

   A part that lies in an even number of others is matter and must look outward; in an odd number
   it is a cavity and must look inward. One that does not is turned, and named. Parts that cross are
   named: what both hold counts twice, as in the sum of two bodies. All this is asked of points that
   are clearly in or out: farther from the faces than TOLERANCE of the smaller part, or than the
   rounding of floats. So parts may touch. */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>

#define TOLERANCE 1e-6
enum { SAMPLES = 256, LATTICE = 4096, WORK = 1 << 21 }; /* questions to trees: a few seconds */
enum relation { APART, WITHIN, AROUND, ACROSS };

struct part {
  size_t first, count; /* its triangles */
  double box[6];
  double size;  /* of the longest side */
  double reach; /* the largest coordinate */
  ph_wide volume;
  int side; /* of the volume: -1 looks inward, 0 has none */
  int depth;
  size_t around; /* the smallest part that it lies in */
  int planted;   /* has a tree */
  struct mesh_tree tree;
};

struct parts {
  struct mesh_build *b;
  struct part *list;
  size_t count;
  uint32_t *triangle; /* by parts */
  size_t work;
  int failed;
};

static const double *corner(const struct parts *ps, uint32_t t, int k) {
  const uint32_t v = ps->b->corner.item[3 * (size_t)t + (size_t)k] & ~MESH_DIAGONAL;
  return ps->b->points.xyz + 3 * (size_t)v;
}

/* ---- what a part is ---- */

/* Volume, box; the volume's side is known beyond rounding, see finish() in mesh.c. */
static void measure(const struct parts *ps, struct part *p) {
  const double *origin = corner(ps, ps->triangle[p->first], 0);
  ph_wide six = 0, terms = 0;
  for (int i = 0; i < 3; i++)
    p->box[i] = p->box[3 + i] = origin[i];
  for (size_t n = 0; n < p->count; n++) {
    ph_wide v[3][3], normal[3];
    for (int k = 0; k < 3; k++) {
      const double *c = corner(ps, ps->triangle[p->first + n], k);
      for (int i = 0; i < 3; i++) {
        v[k][i] = (ph_wide)c[i] - (ph_wide)origin[i];
        p->box[i] = fmin(p->box[i], c[i]);
        p->box[3 + i] = fmax(p->box[3 + i], c[i]);
      }
    }
    wide_cross(v[1], v[2], normal);
    const ph_wide x = v[0][0] * normal[0], y = v[0][1] * normal[1], z = v[0][2] * normal[2];
    six += x + y + z;
    terms += fabsl(x) + fabsl(y) + fabsl(z);
  }
  for (int i = 0; i < 3; i++) {
    p->size = fmax(p->size, p->box[3 + i] - p->box[i]);
    p->reach = fmax(p->reach, fmax(fabs(p->box[i]), fabs(p->box[3 + i])));
  }
  p->volume = six / 6;
  p->side = fabsl(six) > 0x1p-50L * terms ? six > 0 ? 1 : -1 : 0;
}

/* Numbers the parts, and puts their triangles together. */
static int gather(struct parts *ps) {
  struct mesh_build *b = ps->b;
  const size_t n = b->corner.count / 3;
  for (size_t t = 0; t < n; t++)
    ps->count += b->part[t] == t;
  b->result.parts = ps->count;
  uint32_t *number = calloc(n + 1, sizeof *number);
  ps->list = calloc(ps->count + 1, sizeof *ps->list);
  ps->triangle = malloc((n + 1) * sizeof *ps->triangle);
  if (number == NULL || ps->list == NULL || ps->triangle == NULL) {
    free(number);
    return mesh_fail_memory(b);
  }
  for (size_t t = 0, k = 0; t < n; t++) {
    if (b->part[t] == t)
      number[t] = (uint32_t)k++;
    b->part[t] = number[b->part[t]];
    ps->list[b->part[t]].count++;
  }
  for (size_t k = 1; k < ps->count; k++)
    ps->list[k].first = ps->list[k - 1].first + ps->list[k - 1].count;
  for (size_t k = 0; k < ps->count; k++)
    number[k] = (uint32_t)ps->list[k].first;
  for (size_t t = 0; t < n; t++)
    ps->triangle[number[b->part[t]]++] = (uint32_t)t;
  free(number);
  if (ps->count > 1)
    for (size_t k = 0; k < ps->count; k++)
      measure(ps, &ps->list[k]);
  return PH_OK;
}

/* ---- where a point is ---- */

static const struct mesh_tree *tree_of(struct parts *ps, struct part *p) {
  const struct mesh_build *b = ps->b;
  if (!p->planted)
    ps->failed |= mesh_tree_make(&p->tree, b->points.xyz, b->corner.item, ps->triangle + p->first,
                                 p->count) != PH_OK;
  p->planted = 1;
  return &p->tree;
}

/* -1: p is clearly in the part, 1: clearly out, 0: neither, within the tolerance of its faces. */
static int where(struct parts *ps, struct part *part, const double p[3], double tolerance) {
  for (int i = 0; i < 3; i++)
    if (p[i] < part->box[i] - tolerance || p[i] > part->box[3 + i] + tolerance)
      return 1;
  const struct mesh_tree *tree = tree_of(ps, part);
  if (ps->failed)
    return 0;
  ps->work++;
  if (tolerance > 0 && mesh_tree_distance(tree, p, 2 * tolerance) <= tolerance)
    return 0;
  return mesh_tree_winding(tree, p, NULL, NULL) != 0 ? -1 : 1;
}

static double tolerance_of(const struct part *a, const struct part *b) {
  return fmax(TOLERANCE * fmin(a->size, b->size), 0x1p-22 * fmax(a->reach, b->reach));
}

/* Which of the samples of a's faces lie in b: 1 some do, 2 some do not. */
static int sides(struct parts *ps, const struct part *a, struct part *b, double tolerance,
                 double inner[3]) {
  int seen = 0;
  const size_t step = a->count / SAMPLES + 1;
  for (size_t n = 0; n < a->count && seen != 3; n += step)
    for (int k = 0; k < 4 && seen != 3; k++) {
      double p[3];
      const double *c[3];
      for (int i = 0; i < 3; i++)
        c[i] = corner(ps, ps->triangle[a->first + n], i);
      for (int i = 0; i < 3; i++)
        p[i] = k == 3 ? c[0][i] / 3 + c[1][i] / 3 + c[2][i] / 3 : c[k][i];
      const int side = where(ps, b, p, tolerance);
      seen |= side < 0 ? 1 : side > 0 ? 2 : 0;
      if (side < 0)
        memcpy(inner, p, 3 * sizeof p[0]);
    }
  return seen;
}

/* ---- parts that cross without a sample of the one in the other ---- */

static void unit_normal(const double *const c[3], int side, double n[3]) {
  double p[9];
  ph_wide wide[3];
  for (int k = 0; k < 3; k++)
    memcpy(p + 3 * k, c[k], 3 * sizeof p[0]);
  mesh_normal(p, wide);
  const ph_wide length = wide_norm(wide);
  for (int i = 0; i < 3; i++)
    n[i] = length > 0 ? (double)(wide[i] / length) * side : 0;
}

/* Where the piece from a to b meets the triangle; 0: nowhere (Moeller and Trumbore 1997). */
static int meet(const double a[3], const double b[3], const double *const c[3], double at[3]) {
  double d[3], e[3], f[3], s[3], h[3], q[3];
  for (int i = 0; i < 3; i++)
    d[i] = b[i] - a[i], e[i] = c[1][i] - c[0][i], f[i] = c[2][i] - c[0][i], s[i] = a[i] - c[0][i];
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    h[i] = d[j] * f[k] - d[k] * f[j];
    q[i] = s[j] * e[k] - s[k] * e[j];
  }
  const double det = e[0] * h[0] + e[1] * h[1] + e[2] * h[2];
  if (det == 0)
    return 0;
  const double u = (s[0] * h[0] + s[1] * h[1] + s[2] * h[2]) / det;
  const double v = (d[0] * q[0] + d[1] * q[1] + d[2] * q[2]) / det;
  const double t = (f[0] * q[0] + f[1] * q[1] + f[2] * q[2]) / det;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1))
    return 0;
  for (int i = 0; i < 3; i++)
    at[i] = a[i] + t * d[i];
  return 1;
}

struct crossing {
  struct parts *ps;
  struct part *a, *b; /* an edge of a and a face of b */
  const double *face[3];
  int edge; /* of the face of a: from corner `edge` to the next */
  double lo[3], hi[3], tolerance;
  double *inner;
};

/* From where the edge meets b's face a step into b, into a below its face, and off the edge. */
static int confirm(const struct crossing *x, const double *const other[3], const double at[3]) {
  double n[3], m[3], off[3], length = 0;
  unit_normal(x->face, x->a->side, n);
  unit_normal(other, x->b->side, m);
  const double *third = x->face[(x->edge + 2) % 3];
  for (int i = 0; i < 3; i++)
    off[i] = third[i] - at[i], length += off[i] * off[i];
  length = sqrt(length);
  for (double step = 4 * x->tolerance; step < length; step *= 8) {
    for (int i = 0; i < 3; i++)
      x->inner[i] = at[i] + step * (off[i] / length - n[i] - m[i]);
    if (where(x->ps, x->a, x->inner, x->tolerance) < 0 &&
        where(x->ps, x->b, x->inner, x->tolerance) < 0)
      return 1;
  }
  return 0;
}

static int search(const struct crossing *x, size_t k, size_t from, size_t to, int depth) {
  const struct mesh_tree *tree = &x->b->tree;
  const double *box = tree->box + 6 * k;
  for (int i = 0; i < 3; i++)
    if (box[i] > x->hi[i] || box[3 + i] < x->lo[i])
      return 0;
  if (depth < tree->depth) {
    const size_t middle = from + (to - from) / 2;
    return search(x, 2 * k + 1, from, middle, depth + 1) ||
           search(x, 2 * k + 2, middle, to, depth + 1);
  }
  for (size_t t = from; t < to && x->ps->work < WORK; t++) {
    const double *c[3];
    double at[3];
    for (int i = 0; i < 3; i++)
      c[i] = mesh_tree_corner(tree, tree->order[t], i);
    x->ps->work++;
    if (meet(x->face[x->edge], x->face[(x->edge + 1) % 3], c, at) && confirm(x, c, at))
      return 1;
  }
  return 0;
}

/* Does an edge of a go through a face of b?  inner: then a point in both. */
static int pierces(struct parts *ps, struct part *a, struct part *b, double tolerance,
                   double inner[3]) {
  struct crossing x = {.ps = ps, .a = a, .b = b, .tolerance = tolerance, .inner = inner};
  tree_of(ps, b);
  for (size_t n = 0; n < a->count && !ps->failed && ps->work < WORK; n++) {
    for (int k = 0; k < 3; k++)
      x.face[k] = corner(ps, ps->triangle[a->first + n], k);
    for (x.edge = 0; x.edge < 3; x.edge++) {
      const double *p = x.face[x.edge], *q = x.face[(x.edge + 1) % 3];
      for (int i = 0; i < 3; i++)
        x.lo[i] = fmin(p[i], q[i]), x.hi[i] = fmax(p[i], q[i]);
      ps->work++;
      if (search(&x, 0, 0, b->count, 0))
        return 1;
    }
  }
  return 0;
}

/* ---- pairs ---- */

static enum relation relate(struct parts *ps, struct part *a, struct part *b, double inner[3]) {
  const double tolerance = tolerance_of(a, b);
  const int x = sides(ps, a, b, tolerance, inner);
  if (x == 3)
    return ACROSS;
  const int y = sides(ps, b, a, tolerance, inner);
  if (y == 3 || (x == 1 && y == 1))
    return ACROSS;
  const int few = a->count <= SAMPLES && b->count <= SAMPLES;
  if ((!few || (x != 1 && y != 1)) &&
      (pierces(ps, a, b, tolerance, inner) || pierces(ps, b, a, tolerance, inner)))
    return ACROSS;
  return x == 1 ? WITHIN : y == 1 ? AROUND : APART;
}

static ph_mesh_fault *report(struct parts *ps, ph_mesh_fault_kind kind, size_t part, size_t other) {
  ph_mesh *m = &ps->b->result;
  if (m->faults++ >= PH_MESH_FAULTS)
    return NULL;
  ph_mesh_fault *f = &m->fault[m->faults - 1];
  *f = (ph_mesh_fault){.kind = kind, .part = part + 1, .other = other + 1};
  f->triangles = ps->list[part].count;
  for (int i = 0; i < 3; i++)
    f->at[i] = ps->list[part].box[i] / 2 + ps->list[part].box[3 + i] / 2;
  return f;
}

/* The volume of what both hold, by points of Halton's sequence (1960) in what their boxes share. */
static double shared(struct parts *ps, struct part *a, struct part *b) {
  static const int base[3] = {2, 3, 5};
  double lo[3], hi[3], volume = 1;
  int inside = 0;
  for (int i = 0; i < 3; i++) {
    lo[i] = fmax(a->box[i], b->box[i]), hi[i] = fmin(a->box[3 + i], b->box[3 + i]);
    volume *= hi[i] - lo[i];
  }
  for (int n = 1; n <= LATTICE; n++) {
    double p[3];
    for (int i = 0; i < 3; i++) {
      double at = 0, digit = 1;
      for (int rest = n; rest > 0; rest /= base[i])
        at += (digit /= base[i]) * (rest % base[i]);
      p[i] = lo[i] + (hi[i] - lo[i]) * at;
    }
    inside += where(ps, a, p, 0) < 0 && where(ps, b, p, 0) < 0;
  }
  return volume * inside / LATTICE;
}

/* Part i lies in part k. */
static void enter(struct parts *ps, size_t i, size_t k) {
  struct part *p = &ps->list[i];
  if (p->depth++ == 0 || fabsl(ps->list[k].volume) < fabsl(ps->list[p->around].volume))
    p->around = k;
}

static void pair(struct parts *ps, size_t i, size_t k) {
  struct part *a = &ps->list[i], *b = &ps->list[k];
  double inner[3];
  switch (relate(ps, a, b, inner)) {
  case WITHIN:
    enter(ps, i, k);
    break;
  case AROUND:
    enter(ps, k, i);
    break;
  case ACROSS: {
    ph_mesh_fault *f = report(ps, PH_MESH_OVERLAP, i < k ? i : k, i < k ? k : i);
    if (f != NULL) {
      memcpy(f->at, inner, sizeof f->at);
      f->share = shared(ps, a, b);
    }
    break;
  }
  case APART:
    break;
  }
}

struct order {
  double lo;
  size_t part;
};

static int by_lo(const void *a, const void *b) {
  const struct order *x = a, *y = b;
  return x->lo != y->lo ? (x->lo > y->lo) - (x->lo < y->lo)
                        : (x->part > y->part) - (x->part < y->part);
}

/* All pairs whose boxes meet, along x in order. */
static int compare(struct parts *ps) {
  struct order *order = malloc((ps->count + 1) * sizeof *order);
  if (order == NULL)
    return mesh_fail_memory(ps->b);
  for (size_t k = 0; k < ps->count; k++)
    order[k] = (struct order){ps->list[k].box[0], k};
  qsort(order, ps->count, sizeof *order, by_lo);
  for (size_t i = 0; i < ps->count; i++)
    for (size_t k = i + 1; k < ps->count; k++) {
      const struct part *a = &ps->list[order[i].part], *b = &ps->list[order[k].part];
      if (b->box[0] > a->box[3])
        break;
      if (ps->work++ >= WORK) { /* looking at boxes is work, too */
        ps->b->result.unseen = 1;
        free(order);
        return PH_OK;
      }
      if (a->side != 0 && b->side != 0 && b->box[1] <= a->box[4] && a->box[1] <= b->box[4] &&
          b->box[2] <= a->box[5] && a->box[2] <= b->box[5])
        pair(ps, order[i].part, order[k].part);
    }
  free(order);
  return ps->failed ? mesh_fail_memory(ps->b) : PH_OK;
}

/* Turns the parts that look to the wrong side. If all do, the mesh as a whole is inside out, and
   nothing is turned: its volume is taken positive. */
static int turn(struct parts *ps) {
  struct mesh_build *b = ps->b;
  size_t wrong = 0, all = 0;
  b->turn = malloc(ps->count + 1);
  if (b->turn == NULL)
    return mesh_fail_memory(b);
  for (size_t k = 0; k < ps->count; k++) {
    const struct part *p = &ps->list[k];
    b->turn[k] = p->side != 0 && p->side != (p->depth % 2 == 0 ? 1 : -1) ? -1 : 1;
    wrong += b->turn[k] < 0;
    all += p->side != 0;
  }
  if (wrong == all)
    memset(b->turn, 1, ps->count);
  else if (wrong > 0) {
    for (size_t k = 0; k < ps->count; k++)
      if (b->turn[k] < 0)
        report(ps,
               ps->list[k].depth == 0 ? PH_MESH_INWARD
               : ps->list[k].side > 0 ? PH_MESH_OUTWARD
                                      : PH_MESH_SOLID,
               k, ps->list[k].around);
    mesh_sum_again(b);
  }
  return PH_OK;
}

int mesh_parts(struct mesh_build *b) {
  struct parts ps = {.b = b};
  int status = gather(&ps);
  if (status == PH_OK && ps.count > 1)
    status = compare(&ps);
  if (status == PH_OK && ps.count > 1)
    status = turn(&ps);
  for (size_t k = 0; k < ps.count && ps.list != NULL; k++)
    mesh_tree_free(&ps.list[k].tree);
  free(ps.list);
  free(ps.triangle);
  return status;
}
