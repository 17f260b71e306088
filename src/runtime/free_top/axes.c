/* axes.c - principal axes with twice the digits, and the exact side of the separatrix.
   SPDX-License-Identifier: GPL-3.0-or-later

   Over 10^6 turns a rate is needed to 22 digits. Doubles on the diagonal are exact as they are;
   a full tensor is turned by Jacobi's rotations (numbers/eigen.c) in pairs. */
#include "free_top.h"

enum { MAX_SWEEPS = 60 }; /* as in numbers/eigen.c */

static void rotate(pair a[3][3], pair v[3][3], int p, int q) {
  const int r = 3 - p - q;
  const pair one = pair_of(1), apq = a[p][q];
  const pair theta = pair_divide(pair_subtract(a[q][q], a[p][p]), pair_times(apq, 2));
  const pair size = theta.hi < 0 ? pair_negative(theta) : theta;
  const pair root = pair_sqrt(pair_add(pair_multiply(theta, theta), one));
  const pair t = pair_divide(pair_of(theta.hi < 0 ? -1 : 1), pair_add(size, root));
  const pair c = pair_divide(one, pair_sqrt(pair_add(pair_multiply(t, t), one)));
  const pair s = pair_multiply(t, c), move = pair_multiply(t, apq);
  a[p][p] = pair_subtract(a[p][p], move);
  a[q][q] = pair_add(a[q][q], move);
  a[p][q] = a[q][p] = pair_of(0);
  const pair arp = a[r][p], arq = a[r][q];
  a[r][p] = a[p][r] = pair_cross(c, arp, s, arq);
  a[r][q] = a[q][r] = pair_cross(s, arp, pair_negative(c), arq);
  for (int i = 0; i < 3; i++) {
    const pair vip = v[i][p], viq = v[i][q];
    v[i][p] = pair_cross(c, vip, s, viq);
    v[i][q] = pair_cross(s, vip, pair_negative(c), viq);
  }
}

void free_top_axes(const ph_wide tensor[6], pair moment[3], pair axis[3][3]) {
  static const int at[3][3] = {{XX, XY, XZ}, {XY, YY, YZ}, {XZ, YZ, ZZ}};
  pair a[3][3], v[3][3];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      a[i][j] = pair_of(tensor[at[i][j]]), v[i][j] = pair_of(i == j);
  for (int sweep = 0, turned = 1; turned && sweep < MAX_SWEEPS; sweep++) {
    turned = 0;
    for (int p = 0; p < 2; p++)
      for (int q = p + 1; q < 3; q++)
        if (fabsl(a[p][q].hi) > 0x1p-126L * sqrtl(fabsl(a[p][p].hi)) * sqrtl(fabsl(a[q][q].hi))) {
          rotate(a, v, p, q);
          turned = 1;
        }
  }
  int order[3] = {0, 1, 2};
  for (int i = 1; i < 3; i++)
    for (int j = i;
         j > 0 && pair_subtract(a[order[j]][order[j]], a[order[j - 1]][order[j - 1]]).hi < 0; j--) {
      const int k = order[j];
      order[j] = order[j - 1], order[j - 1] = k;
    }
  /* v has determinant 1; an odd permutation of its columns has -1 */
  const int odd = (order[1] - order[0] + 3) % 3 == 2;
  for (int k = 0; k < 3; k++) {
    moment[k] = a[order[k]][order[k]];
    for (int i = 0; i < 3; i++)
      axis[k][i] = odd && k == 1 ? pair_negative(v[i][order[k]]) : v[i][order[k]];
  }
}

/* ---- exact sums: numbers that do not overlap, small ones first (Shewchuk, Discrete Comput. Geom.
   18, 1997; his proofs hold for any binary format) ---- */

/* Products of four pairs have up to 128 terms, and 600 bits are ten long doubles; the rest is slack
   for long gaps. */
enum { TERMS = 128, KEPT = 520 };

typedef struct terms {
  int n;
  ph_wide v[TERMS];
} terms;

static terms terms_of(pair a) {
  return a.lo != 0 ? (terms){2, {a.lo, a.hi}} : (terms){a.hi != 0, {a.hi}};
}

static void put(terms *to, ph_wide v) {
  if (v != 0)
    to->v[to->n++] = v;
}

static terms times(const terms *a, const terms *b) {
  terms out = {0, {0}};
  for (int i = 0; i < a->n; i++)
    for (int j = 0; j < b->n; j++) {
      const pair p = pair_product(a->v[i], b->v[j]);
      put(&out, p.lo);
      put(&out, p.hi);
    }
  return out;
}

typedef struct total {
  int n;
  ph_wide v[KEPT];
} total;

static void grow(total *s, ph_wide term) {
  ph_wide carry = term;
  int n = 0;
  for (int i = 0; i < s->n; i++) {
    const pair p = pair_sum(carry, s->v[i]);
    if (p.lo != 0)
      s->v[n++] = p.lo;
    carry = p.hi;
  }
  if (carry != 0)
    s->v[n++] = carry;
  s->n = n;
}

/* s += sign a b c c */
static void accumulate(total *s, int sign, pair a, pair b, pair c) {
  const terms ta = terms_of(a), tb = terms_of(b), tc = terms_of(c);
  const terms ab = times(&ta, &tb), cc = times(&tc, &tc), all = times(&ab, &cc);
  for (int i = 0; i < all.n; i++)
    grow(s, sign * all.v[i]);
}

pair free_top_side(const pair moment[3], const pair w[3]) {
  total s = {0, {0}};
  accumulate(&s, 1, moment[2], moment[2], w[2]);
  accumulate(&s, -1, moment[2], moment[1], w[2]);
  accumulate(&s, -1, moment[0], moment[1], w[0]);
  accumulate(&s, 1, moment[0], moment[0], w[0]);
  pair sum = pair_of(0);
  for (int i = 0; i < s.n; i++)
    sum = pair_add(sum, pair_of(s.v[i]));
  return sum;
}
