/* mesh_files.h - meshes for tests and measurements: made, written in every format, and integrated
   in high precision. SPDX-License-Identifier: GPL-3.0-or-later

   The oracle sums signed tetrahedra about the file's own origin with MPFR in ORACLE_BITS bits:
   doubles within 2^+-40 of each other have exact products and sums there, and the formulas are
   those of the polynomial form (B. Mirtich, Fast and accurate computation of polyhedral mass
   properties, J. Graphics Tools 1, 1996: integrals of 1, x, x^2, xy over a tetrahedron), written
   out for this file alone. */
#ifndef MESH_FILES_H
#define MESH_FILES_H

#include <math.h>
#include <mpfr.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ORACLE_BITS = 640 };

/* ---- meshes ---- */

typedef struct shape {
  size_t vertices, triangles;
  double *xyz;    /* three a vertex */
  uint32_t *face; /* three a triangle */
} shape;

static inline void shape_vertex(shape *s, double x, double y, double z) {
  double *p = s->xyz + 3 * s->vertices++;
  p[0] = x, p[1] = y, p[2] = z;
}

static inline void shape_face(shape *s, size_t a, size_t b, size_t c) {
  uint32_t *f = s->face + 3 * s->triangles++;
  f[0] = (uint32_t)a, f[1] = (uint32_t)b, f[2] = (uint32_t)c;
}

static inline void shape_alloc(shape *s, size_t vertices, size_t triangles) {
  s->vertices = s->triangles = 0;
  s->xyz = malloc(3 * vertices * sizeof *s->xyz);
  s->face = malloc(3 * triangles * sizeof *s->face);
  if (!s->xyz || !s->face)
    abort();
}

static inline void shape_free(shape *s) {
  free(s->xyz);
  free(s->face);
}

/* The box [lo, lo + size], each side in n x n squares of two triangles: 12 n^2. The six sides have
   vertices of their own, which agree where they meet. */
static inline shape shape_box(const double lo[3], const double size[3], size_t n) {
  shape s;
  shape_alloc(&s, 6 * (n + 1) * (n + 1), 12 * n * n);
  for (int side = 0; side < 6; side++) {
    const int axis = side / 2, high = side % 2;
    const int u = (axis + 1 + !high) % 3, v = (axis + 1 + high) % 3; /* u x v looks out */
    const size_t first = s.vertices;
    for (size_t i = 0; i <= n; i++)
      for (size_t j = 0; j <= n; j++) {
        double p[3];
        p[axis] = lo[axis] + (high ? size[axis] : 0.0);
        p[u] = lo[u] + size[u] * (double)i / (double)n;
        p[v] = lo[v] + size[v] * (double)j / (double)n;
        shape_vertex(&s, p[0], p[1], p[2]);
      }
    for (size_t i = 0; i < n; i++)
      for (size_t j = 0; j < n; j++) {
        const size_t a = first + i * (n + 1) + j, b = a + n + 1;
        shape_face(&s, a, b, b + 1);
        shape_face(&s, a, b + 1, a + 1);
      }
  }
  return s;
}

/* Semi-axes a about c: n rings, 2 n meridians, 4 n (n - 1) triangles. */
static inline shape shape_ellipsoid(const double c[3], const double a[3], size_t n) {
  const double pi = 3.14159265358979323846;
  shape s;
  shape_alloc(&s, 2 + (n - 1) * 2 * n, 4 * n * (n - 1));
  shape_vertex(&s, c[0], c[1], c[2] + a[2]);
  for (size_t i = 1; i < n; i++)
    for (size_t j = 0; j < 2 * n; j++) {
      const double t = pi * (double)i / (double)n, f = pi * (double)j / (double)n;
      shape_vertex(&s, c[0] + a[0] * sin(t) * cos(f), c[1] + a[1] * sin(t) * sin(f),
                   c[2] + a[2] * cos(t));
    }
  shape_vertex(&s, c[0], c[1], c[2] - a[2]);
  const size_t south = s.vertices - 1;
  for (size_t j = 0; j < 2 * n; j++) {
    const size_t k = (j + 1) % (2 * n), last = 1 + (n - 2) * 2 * n;
    shape_face(&s, 0, 1 + j, 1 + k);
    shape_face(&s, south, last + k, last + j);
    for (size_t i = 0; i + 2 < n; i++) {
      const size_t p = 1 + i * 2 * n, q = p + 2 * n;
      shape_face(&s, p + j, q + j, q + k);
      shape_face(&s, p + j, q + k, p + k);
    }
  }
  return s;
}

/* ---- files ---- */

enum format { STL_BINARY, STL_TEXT, OBJ, PLY_TEXT, PLY_LITTLE, PLY_BIG, FORMATS };

static const char *const format_name[FORMATS] = {"STL binary", "STL text",   "OBJ",
                                                 "PLY text",   "PLY little", "PLY big"};
static const char *const format_ending[FORMATS] = {".stl", ".stl", ".obj", ".ply", ".ply", ".ply"};

/* n bytes of v, lowest first or last, whatever this machine's order. */
static inline void put_bits(FILE *f, uint64_t v, int n, int big) {
  for (int i = 0; i < n; i++)
    fputc((int)(v >> 8 * (big ? n - 1 - i : i) & 0xff), f);
}

static inline void put_float(FILE *f, double x, int big) {
  const float y = (float)x;
  uint32_t bits;
  memcpy(&bits, &y, sizeof bits);
  put_bits(f, bits, 4, big);
}

static inline void put_double(FILE *f, double x, int big) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  put_bits(f, bits, 8, big);
}

static inline void write_stl(FILE *f, const shape *s, int text) {
  if (text)
    fprintf(f, "solid test\n");
  else {
    fprintf(f, "%-80s", "solid in name only");
    put_bits(f, s->triangles, 4, 0);
  }
  for (size_t t = 0; t < s->triangles; t++) {
    if (text)
      fprintf(f, "facet normal 0 0 0\n outer loop\n");
    else
      for (int i = 0; i < 3; i++)
        put_float(f, 0, 0);
    for (int i = 0; i < 3; i++) {
      const double *p = s->xyz + 3 * (size_t)s->face[3 * t + (size_t)i];
      if (text)
        fprintf(f, "  vertex %.17g %.17g %.17g\n", p[0], p[1], p[2]);
      else
        for (int k = 0; k < 3; k++)
          put_float(f, p[k], 0);
    }
    if (text)
      fprintf(f, " endloop\nendfacet\n");
    else
      put_bits(f, 0, 2, 0);
  }
  if (text)
    fprintf(f, "endsolid test\n");
}

static inline void write_obj(FILE *f, const shape *s) {
  for (size_t i = 0; i < s->vertices; i++)
    fprintf(f, "v %.17g %.17g %.17g\n", s->xyz[3 * i], s->xyz[3 * i + 1], s->xyz[3 * i + 2]);
  for (size_t t = 0; t < s->triangles; t++)
    fprintf(f, "f %u %u %u\n", (unsigned)s->face[3 * t] + 1, (unsigned)s->face[3 * t + 1] + 1,
            (unsigned)s->face[3 * t + 2] + 1);
}

static inline void write_ply(FILE *f, const shape *s, enum format format) {
  const int big = format == PLY_BIG;
  fprintf(f,
          "ply\nformat %s 1.0\nelement vertex %zu\nproperty double x\nproperty double y\n"
          "property double z\nelement face %zu\nproperty list uchar int vertex_indices\n"
          "end_header\n",
          format == PLY_TEXT ? "ascii"
          : big              ? "binary_big_endian"
                             : "binary_little_endian",
          s->vertices, s->triangles);
  for (size_t i = 0; i < 3 * s->vertices; i++)
    if (format == PLY_TEXT)
      fprintf(f, "%.17g%c", s->xyz[i], i % 3 == 2 ? '\n' : ' ');
    else
      put_double(f, s->xyz[i], big);
  for (size_t t = 0; t < s->triangles; t++) {
    const uint32_t *v = s->face + 3 * t;
    if (format == PLY_TEXT) {
      fprintf(f, "3 %u %u %u\n", (unsigned)v[0], (unsigned)v[1], (unsigned)v[2]);
      continue;
    }
    put_bits(f, 3, 1, big);
    for (int i = 0; i < 3; i++)
      put_bits(f, v[i], 4, big);
  }
}

static inline void shape_write(const shape *s, const char *path, enum format format) {
  FILE *f = fopen(path, "wb");
  if (!f)
    abort();
  if (format == STL_BINARY || format == STL_TEXT)
    write_stl(f, s, format == STL_TEXT);
  else if (format == OBJ)
    write_obj(f, s);
  else
    write_ply(f, s, format);
  if (fclose(f) != 0)
    abort();
}

/* ---- the oracle ---- */

/* measure, centre, second moments about it per unit measure: xx yy zz xy xz yz */
typedef struct truth {
  long double measure, com[3], sigma[6];
} truth;

static const int truth_row[6] = {0, 1, 2, 0, 0, 1}, truth_col[6] = {0, 1, 2, 1, 2, 2};

struct oracle {
  mpfr_t sum[10], p[3][3], e[3][3], n[3], w, t, u;
};

/* sum += w * (integral of 1, x_i, x_i x_j by corners 0..k-1), up to the factor of the kind */
static inline void oracle_add(struct oracle *o, int corners) {
  mpfr_add(o->sum[0], o->sum[0], o->w, MPFR_RNDN);
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < corners; k++)
      mpfr_fma(o->sum[1 + i], o->w, o->p[k][i], o->sum[1 + i], MPFR_RNDN);
  for (int i = 0; i < 6; i++) {
    /* 2 sum p_k p_k + sum over k != l of p_k p_l */
    mpfr_set_zero(o->u, 1);
    for (int k = 0; k < corners; k++)
      for (int l = 0; l < corners; l++) {
        mpfr_mul(o->t, o->p[k][truth_row[i]], o->p[l][truth_col[i]], MPFR_RNDN);
        mpfr_mul_ui(o->t, o->t, k == l ? 2 : 1, MPFR_RNDN);
        mpfr_add(o->u, o->u, o->t, MPFR_RNDN);
      }
    mpfr_fma(o->sum[4 + i], o->w, o->u, o->sum[4 + i], MPFR_RNDN);
  }
}

static inline void oracle_normal(struct oracle *o) {
  for (int i = 0; i < 3; i++) {
    mpfr_sub(o->e[0][i], o->p[1][i], o->p[0][i], MPFR_RNDN);
    mpfr_sub(o->e[1][i], o->p[2][i], o->p[0][i], MPFR_RNDN);
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    mpfr_mul(o->t, o->e[0][j], o->e[1][k], MPFR_RNDN);
    mpfr_mul(o->u, o->e[0][k], o->e[1][j], MPFR_RNDN);
    mpfr_sub(o->n[i], o->t, o->u, MPFR_RNDN);
  }
}

/* kind: 0 volume, 1 surface. rounded: coordinates as floats, as in a binary STL. */
static inline truth shape_truth(const shape *s, int kind, int rounded) {
  static const unsigned first[2] = {4, 3}, second[2] = {20, 12};
  struct oracle o;
  truth result;
  mpfr_t *const all = (mpfr_t *)&o;
  const size_t count = sizeof o / sizeof(mpfr_t);
  for (size_t i = 0; i < count; i++) {
    mpfr_init2(all[i], ORACLE_BITS);
    mpfr_set_zero(all[i], 1);
  }
  for (size_t t = 0; t < s->triangles; t++) {
    for (size_t k = 0; k < 3; k++)
      for (size_t i = 0; i < 3; i++) {
        const double x = s->xyz[3 * (size_t)s->face[3 * t + k] + i];
        mpfr_set_d(o.p[k][i], rounded ? (double)(float)x : x, MPFR_RNDN);
      }
    oracle_normal(&o);
    mpfr_set_zero(o.w, 1);
    for (int i = 0; i < 3; i++)
      mpfr_fma(o.w, kind ? o.n[i] : o.p[0][i], o.n[i], o.w, MPFR_RNDN);
    if (kind)
      mpfr_sqrt(o.w, o.w, MPFR_RNDN);
    oracle_add(&o, 3);
  }
  for (int i = 0; i < 3; i++) {
    mpfr_div(o.sum[1 + i], o.sum[1 + i], o.sum[0], MPFR_RNDN);
    mpfr_div_ui(o.sum[1 + i], o.sum[1 + i], first[kind], MPFR_RNDN);
    result.com[i] = mpfr_get_ld(o.sum[1 + i], MPFR_RNDN);
  }
  for (int i = 0; i < 6; i++) {
    mpfr_div(o.sum[4 + i], o.sum[4 + i], o.sum[0], MPFR_RNDN);
    mpfr_div_ui(o.sum[4 + i], o.sum[4 + i], second[kind], MPFR_RNDN);
    mpfr_mul(o.t, o.sum[1 + truth_row[i]], o.sum[1 + truth_col[i]], MPFR_RNDN);
    mpfr_sub(o.t, o.sum[4 + i], o.t, MPFR_RNDN);
    result.sigma[i] = mpfr_get_ld(o.t, MPFR_RNDN);
  }
  mpfr_div_ui(o.t, o.sum[0], kind ? 2 : 6, MPFR_RNDN);
  result.measure = mpfr_get_ld(o.t, MPFR_RNDN);
  for (size_t i = 0; i < count; i++)
    mpfr_clear(all[i]);
  return result;
}

#endif
