/* sum.c - the integrals over triangles and segments.
   SPDX-License-Identifier: GPL-3.0-or-later

   Over a simplex with corners p_i (one of them may be the origin), of measure m and dimension k,
       integral r dm     = m/(k+1) s                  s = sum p_i
       integral r r^T dm = m/((k+1)(k+2)) Q           Q = sum p_i p_i^T + s s^T
   (the products of barycentric coordinates average to (1 + delta_ij)/((k+1)(k+2)); Zienkiewicz and
   Taylor, The Finite Element Method, volume 1, integration formulae for simplexes). So one
   routine sums w, w s and w Q:
     volume   tetrahedra over the triangles from the local origin, divergence theorem: w = 6 m =
              a . n with n = (b - a) x (c - a);
     surface  w = |n| = 2 m, with the sign that the caller gives;
     wires    w = |b - a| = m.
   Corners are relative to the local origin, which is a vertex of the mesh, so that a far mesh loses
   nothing. Terms are formed in long double. Within a block of MESH_BATCH they are added plainly,
   blocks are added with compensation (Neumaier 1974): the sum is within 2^8 2^-64 = 2^-56 of the
   sum of the absolute terms whatever their number. */
#include "mesh.h"

/* Adds w, w s, w Q. */
static void weigh(ph_wide t[MESH_TERMS], ph_wide w, const ph_wide s[3], const ph_wide q[6]) {
  t[0] += w;
  for (int i = 0; i < 3; i++)
    t[1 + i] += w * s[i];
  for (int i = 0; i < 6; i++)
    t[4 + i] += w * q[i];
}

/* Corners relative to the origin, and n. */
static inline void triangle(const double origin[3], const double p[9], ph_wide a[3], ph_wide b[3],
                            ph_wide c[3], ph_wide n[3]) {
  for (int i = 0; i < 3; i++) {
    const ph_wide o = (ph_wide)origin[i];
    a[i] = (ph_wide)p[i] - o, b[i] = (ph_wide)p[3 + i] - o, c[i] = (ph_wide)p[6 + i] - o;
  }
  const ph_wide e[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const ph_wide f[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  wide_cross(e, f, n);
}

/* s and Q of three corners; one at the origin adds nothing to them. */
static inline void moments(const ph_wide a[3], const ph_wide b[3], const ph_wide c[3], ph_wide s[3],
                           ph_wide q[6]) {
  for (int i = 0; i < 3; i++)
    s[i] = a[i] + b[i] + c[i];
  q[XX] = a[0] * a[0] + b[0] * b[0] + c[0] * c[0] + s[0] * s[0];
  q[YY] = a[1] * a[1] + b[1] * b[1] + c[1] * c[1] + s[1] * s[1];
  q[ZZ] = a[2] * a[2] + b[2] * b[2] + c[2] * c[2] + s[2] * s[2];
  q[XY] = a[0] * a[1] + b[0] * b[1] + c[0] * c[1] + s[0] * s[1];
  q[XZ] = a[0] * a[2] + b[0] * b[2] + c[0] * c[2] + s[0] * s[2];
  q[YZ] = a[1] * a[2] + b[1] * b[2] + c[1] * c[2] + s[1] * s[2];
}

void mesh_sum_volume(struct mesh_sum *sum, struct mesh_batch *batch) {
  ph_wide t[MESH_TERMS] = {0};
  for (int k = 0; k < batch->count; k++) {
    ph_wide a[3], b[3], c[3], n[3], s[3], q[6];
    triangle(sum->origin, batch->p[k], a, b, c, n);
    moments(a, b, c, s, q);
    const ph_wide x = a[0] * n[0], y = a[1] * n[1], z = a[2] * n[2];
    weigh(t, x + y + z, s, q);
    t[10] += fabsl(x) + fabsl(y) + fabsl(z);
  }
  mesh_sum_block(sum, t);
}

void mesh_sum_surface(struct mesh_sum *sum, struct mesh_batch *batch) {
  ph_wide t[MESH_TERMS] = {0};
  for (int k = 0; k < batch->count; k++) {
    ph_wide a[3], b[3], c[3], n[3], s[3], q[6];
    triangle(sum->origin, batch->p[k], a, b, c, n);
    moments(a, b, c, s, q);
    const ph_wide w = wide_norm(n);
    weigh(t, batch->sign[k] < 0 ? -w : w, s, q);
    t[10] += w;
  }
  mesh_sum_block(sum, t);
}

void mesh_sum_segment(struct mesh_sum *sum, const double p[6], ph_wide block[MESH_TERMS]) {
  static const ph_wide zero[3] = {0};
  ph_wide a[3], b[3], e[3], s[3], q[6];
  for (int i = 0; i < 3; i++) {
    a[i] = (ph_wide)p[i] - (ph_wide)sum->origin[i];
    b[i] = (ph_wide)p[3 + i] - (ph_wide)sum->origin[i];
    e[i] = (ph_wide)p[3 + i] - (ph_wide)p[i];
  }
  moments(a, b, zero, s, q);
  const ph_wide w = wide_norm(e);
  weigh(block, w, s, q);
  block[10] += w;
}

/* Neumaier: the tail gathers what the addition to the head loses, be x or the head the larger. */
void mesh_sum_block(struct mesh_sum *sum, const ph_wide block[MESH_TERMS]) {
  for (int i = 0; i < MESH_TERMS; i++) {
    const ph_wide x = block[i], total = sum->head[i] + x;
    sum->tail[i] +=
        fabsl(sum->head[i]) >= fabsl(x) ? (sum->head[i] - total) + x : (x - total) + sum->head[i];
    sum->head[i] = total;
  }
}

void mesh_normal(const double p[9], ph_wide n[3]) {
  ph_wide a[3], b[3], c[3];
  triangle(p, p, a, b, c, n);
}

int mesh_flat(const double p[9]) {
  /* Quick, in double: far from flat is not flat. What overflows or underflows goes on. 2^-80:
     squares of a normal that is 2^12 times larger than its rounding. */
  const double e[3] = {p[3] - p[0], p[4] - p[1], p[5] - p[2]};
  const double f[3] = {p[6] - p[0], p[7] - p[1], p[8] - p[2]};
  const double x = e[1] * f[2] - e[2] * f[1], y = e[2] * f[0] - e[0] * f[2],
               z = e[0] * f[1] - e[1] * f[0];
  const double ee = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
  const double ff = f[0] * f[0] + f[1] * f[1] + f[2] * f[2];
  const double size = x * x + y * y + z * z;
  if (size > 0x1p-80 * ee * ff && size > 0x1p-900)
    return 0;
  /* Each component is a difference of two products, made with four roundings of 2^-64 */
  ph_wide E[3], F[3];
  for (int i = 0; i < 3; i++) {
    E[i] = (ph_wide)p[3 + i] - (ph_wide)p[i];
    F[i] = (ph_wide)p[6 + i] - (ph_wide)p[i];
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const ph_wide u = E[j] * F[k], v = E[k] * F[j];
    if (fabsl(u - v) > 2 * LDBL_EPSILON * (fabsl(u) + fabsl(v)))
      return 0;
  }
  return 1;
}
