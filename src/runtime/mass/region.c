/* region.c - bodies between polynomial limits, with polynomial density.
   SPDX-License-Identifier: GPL-3.0-or-later

   The integral of a polynomial over a variable between polynomial limits is a polynomial in the
   outer variables, whose degree is known; so Gauss's rule with enough points on each line is exact.
   Weights are positive and second moments are taken about the centroid. Points are pairs: a region
   far from the origin, or between limits that nearly cancel, keeps its digits. */
#include <string.h>

#include "shape.h"

enum { MAX_NODES = 256 };

typedef struct rule {
  int n;
  ph_wide node[MAX_NODES], weight[MAX_NODES];
} rule;

typedef struct region {
  const int *order;
  const ph_polynomial *limit;
  const ph_polynomial *density;
  rule line[3];
  /* what is summed up; moments are taken about `about` */
  pair about[3], first[3];
  ph_wide mass, second[6];
} region;

/* The point is in the order x, y, z. */
static pair evaluate(const ph_polynomial *p, const pair point[3]) {
  pair sum = {0, 0};
  for (int k = 0; k < p->count; k++) {
    pair term = pair_of((ph_wide)p->term[k].coefficient);
    for (int i = 0; i < 3; i++)
      for (int e = 0; e < p->term[k].power[i]; e++)
        term = pair_multiply(term, point[i]);
    sum = pair_add(sum, term);
  }
  return sum;
}

/* Add the point with that weight; PH_EMASS: the density is negative there. */
static int visit(region *r, const pair point[3], ph_wide weight) {
  if (r->density) {
    const ph_wide density = pair_value(evaluate(r->density, point));
    if (density < 0)
      return PH_EMASS;
    weight *= density;
  }
  ph_wide d[3];
  r->mass += weight;
  for (int i = 0; i < 3; i++) {
    const pair offset = pair_subtract(point[i], r->about[i]);
    d[i] = pair_value(offset);
    r->first[i] = pair_add(r->first[i], pair_times(offset, weight));
  }
  wide_add_outer(r->second, weight, d);
  return PH_OK;
}

/* The integral over the variables order[depth], .., order[2], those before them being fixed in
   `point`; weight: the product of the outer lines' weights and lengths. PH_EBOUND: an upper limit
   is below its lower one. */
static int scan(region *r, int depth, pair point[3], ph_wide weight) {
  if (depth == 3)
    return visit(r, point, weight);
  const pair low = evaluate(&r->limit[2 * depth], point);
  const pair length = pair_subtract(evaluate(&r->limit[2 * depth + 1], point), low);
  if (!(pair_value(length) >= 0))
    return PH_EBOUND;
  for (int k = 0; k < r->line[depth].n; k++) {
    point[r->order[depth]] = pair_add(low, pair_times(length, r->line[depth].node[k]));
    const int status =
        scan(r, depth + 1, point, weight * r->line[depth].weight[k] * pair_value(length));
    if (status)
      return status;
  }
  point[r->order[depth]] = pair_of(0);
  return PH_OK;
}

/* All sums anew, about r->about; PH_EMASS: nothing is in the region. */
static int sum_up(region *r) {
  pair point[3] = {{0, 0}, {0, 0}, {0, 0}};
  r->mass = 0;
  memset(r->first, 0, sizeof r->first);
  memset(r->second, 0, sizeof r->second);
  const int status = scan(r, 0, point, 1);
  return status ? status : r->mass > 0 ? PH_OK : PH_EMASS;
}

/* The highest power of one variable, at least 0. */
static int degree(const ph_polynomial *p, int variable) {
  int most = 0;
  for (int k = 0; p && k < p->count; k++)
    if (p->term[k].coefficient != 0 && p->term[k].power[variable] > most)
      most = p->term[k].power[variable];
  return most;
}

/* The degree in order[outer] of the two limits of order[depth]. */
static int degree_of_limits(const region *r, int depth, int outer) {
  const int low = degree(&r->limit[2 * depth], r->order[outer]);
  const int high = degree(&r->limit[2 * depth + 1], r->order[outer]);
  return low > high ? low : high;
}

/* Integrands: density times a product of two coordinates. Integrating w^k between limits of degree
   p in u adds (k + 1) p to u's degree, at most. Degrees are below 3 MAX_NODES each, so nothing
   overflows. */
static int prepare(region *r) {
  int top[3];
  for (int i = 0; i < 3; i++)
    top[i] = degree(r->density, r->order[i]) + 2;
  for (int i = 2; i > 0; i--)
    for (int outer = 0; outer < i; outer++) {
      top[outer] += (top[i] + 1) * degree_of_limits(r, i, outer);
      if (top[outer] > 2 * MAX_NODES)
        return PH_EBOUND;
    }
  for (int i = 0; i < 3; i++) {
    r->line[i].n = top[i] / 2 + 1;
    if (r->line[i].n > MAX_NODES)
      return PH_EBOUND;
    geometry_gauss(r->line[i].n, r->line[i].node, r->line[i].weight);
  }
  return PH_OK;
}

/* Of a limit, only the variables before it may occur; before = 3 for the density. */
static int polynomial_check(const ph_polynomial *p, const int order[3], int before) {
  for (int k = 0; k < p->count; k++) {
    if (!isfinite(p->term[k].coefficient))
      return PH_EFINITE;
    for (int i = 0; i < 3; i++) {
      const int power = p->term[k].power[order[i]];
      if (power < 0 || power > 2 * MAX_NODES || (power > 0 && i >= before))
        return PH_EBOUND;
    }
  }
  return PH_OK;
}

static int region_check(const int order[3], const ph_polynomial limit[6],
                        const ph_polynomial *density) {
  unsigned seen = 0;
  for (int i = 0; i < 3; i++) {
    if (order[i] < 0 || order[i] > 2 || seen >> order[i] & 1)
      return PH_EBOUND;
    seen |= 1u << order[i];
  }
  int status = density ? polynomial_check(density, order, 3) : PH_OK;
  for (int i = 0; i < 6 && !status; i++)
    status = polynomial_check(&limit[i], order, i / 2);
  return status;
}

int ph_region(ph_body *b, ph_amount a, const int order[3], const ph_polynomial limit[6],
              const ph_polynomial *density) {
  region r = {.order = order, .limit = limit, .density = density};
  int status = shape_amount(0, NULL, a);
  if (!status)
    status = region_check(order, limit, density);
  if (!status)
    status = prepare(&r);
  /* about the origin, about the centroid that this gives, and once more, now free of
     cancellation */
  for (int pass = 0; pass < 3 && !status; pass++) {
    status = sum_up(&r);
    for (int i = 0; i < 3 && !status && pass < 2; i++)
      r.about[i] = pair_add(r.about[i], pair_divide(r.first[i], pair_of(r.mass)));
  }
  if (status)
    return status;
  geometry g = {.measure = r.mass};
  for (int i = 0; i < 3; i++) {
    g.at[i] = (double)r.about[i].hi;
    if (!isfinite(g.at[i]))
      return PH_ERANGE;
    g.centroid[i] = (r.about[i].hi - (ph_wide)g.at[i]) + r.about[i].lo;
  }
  for (int i = 0; i < 6; i++)
    g.second[i] = r.second[i] / r.mass;
  return shape_store(b, a, &g);
}
