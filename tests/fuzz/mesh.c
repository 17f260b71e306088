/* mesh.c - fuzz target: bytes as a mesh file (-DFUZZ_SUFFIX=".stl", ".obj", ".ply").
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The readers hand their faces to mesh_add_triangle and mesh_add_polygon; they are compiled with
 * other names for these, which are here: the faces are noted before they go on.  So the harness has
 * its own opinion of the mesh that was read, by other means than welding, sums and sorted records:
 * directed edges that must balance, and the sum of the tetrahedra.
 *
 * Findings: a number that is not finite, or a mass that is not positive, from status 0; a volume of
 * an open surface; a closed one refused as open; a volume that is not the sum; a status that is
 * none of the library's; an empty message with a failure to read. Near vertices are welded, too,
 * and the faces asked about a point: that these end, and in time, is all that is known of them.
 */
#include "../../src/runtime/mesh/mesh.h"
#include "fuzz.h"

#include <math.h>
#include <stdio.h>

enum { MOST = 6000 }; /* edges; beyond, a case has no opinion */

struct edge {
  double a[3], b[3]; /* a before b */
  int along;
};

static struct edge edges[MOST];
static size_t count;
static int overflow;
static long double volume, terms, origin[3];
static int begun;

static int compare(const double a[3], const double b[3]) {
  for (int i = 0; i < 3; i++)
    if (a[i] < b[i] || a[i] > b[i])
      return a[i] < b[i] ? -1 : 1;
  return 0;
}

static int by_ends(const void *x, const void *y) {
  const struct edge *a = x, *b = y;
  const int first = compare(a->a, b->a);
  return first != 0 ? first : compare(a->b, b->b);
}

static void note_edge(const double a[3], const double b[3]) {
  const int order = compare(a, b);
  if (order == 0)
    return;
  if (count == MOST) {
    overflow = 1;
    return;
  }
  struct edge *e = &edges[count++];
  memcpy(e->a, order < 0 ? a : b, sizeof e->a);
  memcpy(e->b, order < 0 ? b : a, sizeof e->b);
  e->along = order < 0 ? 1 : -1;
}

static void note_tetrahedron(const double a[3], const double b[3], const double c[3]) {
  long double p[3][3];
  if (!begun)
    for (int i = 0; i < 3; i++)
      origin[i] = (long double)a[i];
  begun = 1;
  for (int i = 0; i < 3; i++) {
    p[0][i] = (long double)a[i] - origin[i];
    p[1][i] = (long double)b[i] - origin[i];
    p[2][i] = (long double)c[i] - origin[i];
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const long double u = p[0][i] * p[1][j] * p[2][k], v = p[0][i] * p[1][k] * p[2][j];
    volume += (u - v) / 6;
    terms += (fabsl(u) + fabsl(v)) / 6;
    /* the library multiplies a corner by the normal, a product of edges */
    terms += fabsl(p[0][i]) *
             (fabsl(p[1][j] - p[0][j]) * fabsl(p[2][k] - p[0][k]) +
              fabsl(p[1][k] - p[0][k]) * fabsl(p[2][j] - p[0][j])) /
             6;
  }
}

int fuzz_add_triangle(struct mesh_build *b, const double p[9]);
int fuzz_add_triangle(struct mesh_build *b, const double p[9]) {
  for (size_t i = 0; i < 3; i++)
    note_edge(p + 3 * i, p + 3 * ((i + 1) % 3));
  note_tetrahedron(p, p + 3, p + 6);
  return mesh_add_triangle(b, p);
}

int fuzz_add_polygon(struct mesh_build *b);
int fuzz_add_polygon(struct mesh_build *b) {
  const size_t n = b->polygon.count;
  const uint32_t *corner = b->polygon.item;
  for (size_t i = 0; i < n; i++)
    note_edge(b->vertex + 3 * (size_t)corner[i], b->vertex + 3 * (size_t)corner[(i + 1) % n]);
  for (size_t i = 1; i + 1 < n; i++)
    note_tetrahedron(b->vertex + 3 * (size_t)corner[0], b->vertex + 3 * (size_t)corner[i],
                     b->vertex + 3 * (size_t)corner[i + 1]);
  return mesh_add_polygon(b);
}

/* Is every edge run along as often one way as the other? */
static int balanced(void) {
  qsort(edges, count, sizeof edges[0], by_ends);
  for (size_t i = 0, next; i < count; i = next) {
    int sum = 0;
    for (next = i; next < count && by_ends(&edges[i], &edges[next]) == 0; next++)
      sum += edges[next].along;
    if (sum != 0)
      return 0;
  }
  return 1;
}

/* ---- the file ---- */

static const uint8_t *bytes;
static size_t bytes_size;

FILE *fuzz_fopen(const char *path, const char *mode);
FILE *fuzz_fopen(const char *path, const char *mode) {
  (void)path;
  return fmemopen((void *)(uintptr_t)bytes, bytes_size, mode);
}

/* ---- what came of it ---- */

static void finite(const char *what, int n, const double v[]) {
  for (int i = 0; i < n; i++)
    if (!isfinite(v[i]))
      fuzz_finding("%s[%d] is %g from status 0", what, i, v[i]);
}

static void check_body(const ph_mesh *m, ph_amount amount, double unit) {
  ph_body b;
  ph_axes axes;
  const int status = ph_mesh_body(&b, amount, m, unit);
  if (status != PH_OK)
    return;
  if (fuzz_planted("nan"))
    b.mass = NAN;
  if (!(b.mass > 0 && isfinite(b.mass)))
    fuzz_finding("a mass of %g from status 0", b.mass);
  finite("com", 3, b.com);
  finite("com_tail", 3, b.com_tail);
  finite("second", 6, b.second);
  finite("tensor", 6, b.tensor);
  if (ph_principal(b.tensor, &axes) == PH_OK)
    finite("moment", 3, axes.moment);
}

static void check_volume(const ph_mesh *m, int status) {
  if (overflow || !isfinite(terms) || m->nonfinite > 0)
    return;
  const int closed = balanced() && !fuzz_planted("open");
  if (status == PH_OK && !closed)
    fuzz_finding("a volume of an open surface");
  if (status == PH_EOPEN && closed)
    fuzz_finding("a closed surface is refused as open");
  if (m->faults > 0) /* parts were turned, so it is not this sum */
    return;
  /* long double: either way a term has at most 8 roundings of 2^-64, and its sum one for each of
     the at most MOST terms before it, 2^13; and the double at the end */
  const long double off = fabsl(fabsl(volume) - (long double)m->measure);
  if (status == PH_OK && off > 0x1p-52L * fabsl(volume) + 0x1p-51L * terms)
    fuzz_finding("volume %.17g, the sum of tetrahedra is %.17Lg", m->measure, fabsl(volume));
}

static void check(const char *path, ph_mesh_kind kind) {
  char message[256];
  ph_mesh m;
  count = 0;
  overflow = begun = 0;
  volume = terms = 0;
  int status = ph_mesh_read(&m, path, kind, message, sizeof message);
  if (strcmp(ph_status_phrase(status), ph_status_phrase(-1)) == 0)
    fuzz_finding("status %d", status);
  if (status != PH_OK) {
    if (status != PH_EMEMORY && message[0] == '\0')
      fuzz_finding("status %d without a message", status);
    return;
  }
  status = ph_mesh_check(&m);
  if (status == PH_OK) {
    if (!(m.measure > 0 && isfinite(m.measure)))
      fuzz_finding("a measure of %g from status 0", m.measure);
    finite("com", 3, m.com);
    finite("com_tail", 3, m.com_tail);
    finite("sigma", 6, m.sigma);
    check_body(&m, ph_amount_density(1), 1);
    check_body(&m, ph_amount_mass(2), 1e-3);
    check_body(&m, ph_amount_density(1e300), 1e100);
  }
  if (kind == PH_MESH_VOLUME)
    check_volume(&m, status);
}

/* Welded, and asked about the middle of its box. */
static void ask(const char *path, ph_mesh_kind kind) {
  ph_mesh m;
  ph_mesh_shape *shape = NULL;
  double middle[3];
  if (ph_mesh_open(&m, &shape, path, kind, 1e-3, NULL, 0) != PH_OK || shape == NULL)
    return;
  for (int i = 0; i < 3; i++)
    middle[i] = m.lo[i] / 2 + m.hi[i] / 2;
  if (isnan(ph_mesh_excess(shape, middle)))
    fuzz_finding("a distance that is no number");
  ph_mesh_close(shape);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const char *const paths[] = {"x" FUZZ_SUFFIX, "x"};
  bytes = data;
  bytes_size = size;
  if (size == 0)
    return 0; /* fmemopen refuses it */
  for (int kind = PH_MESH_VOLUME; kind <= PH_MESH_WIRES; kind++) {
    check(paths[size % 4 == 3], (ph_mesh_kind)kind);
    ask(paths[size % 4 == 3], (ph_mesh_kind)kind);
  }
  return 0;
}
