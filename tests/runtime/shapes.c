/* shapes.c - every shape of the library against integrals in 110 digits.
   SPDX-License-Identifier: GPL-3.0-or-later

   Rows of reference/shapes.h: needles and plates, thin walls, slivers, far places, sizes of 1e-30
   and 1e30. Mass (by density 1) is compared with the measure, the centre and the tensor of unit
   mass with theirs; the worst errors are printed in ulp. Not here: combinations (mass.c), refusals
   (status.c). */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "reference/shapes.h"
#include "tap.h"

/* The requirement: 4 ulp of the largest entry. */
static const long double ULP = (long double)DBL_EPSILON, TOL = 4 * (long double)DBL_EPSILON;

static const ph_amount ONE = {0, 1.0}, DENSE = {1, 1.0};

/* in ulp */
static struct worst { long double mass, com, tensor; } worst;

static long double largest(int n, const long double v[]) {
  long double size = 0;
  for (int i = 0; i < n; i++)
    size = fmaxl(size, fabsl(v[i]));
  return size;
}

static long double error(int n, const double got[], const long double want[], long double size) {
  long double e = 0;
  for (int i = 0; i < n; i++) {
    const long double d = fabsl((long double)got[i] - want[i]) / size;
    e = d > e || isnan(d) ? d : e;
  }
  return e;
}

static void compare(const char *name, const double *size, int s1, const ph_body *dense, int s2,
                    const ph_body *b, long double measure, const long double com[3],
                    const long double tensor[6]) {
  const long double big = largest(6, tensor), reach = fmaxl(largest(3, com), sqrtl(big));
  if (!ok(s1 == PH_OK && s2 == PH_OK && ph_body_check(b) == PH_OK, "%s %g %g %g is a body", name,
          size[0], size[1], size[2]))
    return;
  const long double mass = error(1, &dense->mass, &measure, measure);
  const long double place = error(3, b->com, com, reach), turn = error(6, b->tensor, tensor, big);
  worst.mass = fmaxl(worst.mass, mass / ULP);
  worst.com = fmaxl(worst.com, place / ULP);
  worst.tensor = fmaxl(worst.tensor, turn / ULP);
  if (!ok(mass <= TOL && place <= TOL && turn <= TOL, "%s %g %g %g: mass, centre, tensor to 4 ulp",
          name, size[0], size[1], size[2])) {
    diag("errors in ulp: mass %.3Lg, centre %.3Lg, tensor %.3Lg", mass / ULP, place / ULP,
         turn / ULP);
    diag("centre %.17g %.17g %.17g", b->com[0], b->com[1], b->com[2]);
    diag("tensor %.17g %.17g %.17g %.17g %.17g %.17g", b->tensor[0], b->tensor[1], b->tensor[2],
         b->tensor[3], b->tensor[4], b->tensor[5]);
  }
}

#define COMPARE(name, size, make)                                                                  \
  do {                                                                                             \
    ph_body dense = {0}, unit = {0};                                                               \
    ph_amount a = DENSE;                                                                           \
    ph_body *b = &dense;                                                                           \
    const int s1 = make;                                                                           \
    a = ONE, b = &unit;                                                                            \
    const int s2 = make;                                                                           \
    compare(name, size, s1, &dense, s2, &unit, r->measure, r->centroid, r->tensor);                \
  } while (0)

#define EACH(row, table)                                                                           \
  const struct row *r = table;                                                                     \
  r < table + sizeof table / sizeof table[0];                                                      \
  r++

/* The tables also say which shapes of the catalogue they hold. */
static void sizes(void) {
  for (EACH(size_row, size_rows))
    COMPARE(r->name, r->size, ph_shape_make(b, r->name, a, r->size, r->count));
  static const char *const elsewhere[] = {
      /* mass.c: by the reference set or as affine images */
      "solid.box",  "solid.sphere",  "solid.ellipsoid", "solid.cylinder", "solid.elliptic_cylinder",
      "plate.disc", "plate.ellipse", "plate.rectangle", "rod.straight",   "rod.between",
      "wire.hoop"};
  for (int i = 0; ph_shape_name(i); i++) {
    int found = 0;
    for (EACH(size_row, size_rows))
      found += strcmp(r->name, ph_shape_name(i)) == 0;
    for (size_t k = 0; k < sizeof elsewhere / sizeof elsewhere[0]; k++)
      found += strcmp(elsewhere[k], ph_shape_name(i)) == 0;
    ok(found > 0, "%s has a reference", ph_shape_name(i));
  }
}

static int by_points(const struct point_row *r, ph_body *b, ph_amount a) {
  if (strcmp(r->kind, "tetrahedron") == 0)
    return ph_solid_tetrahedron(b, a, r->point);
  if (strcmp(r->kind, "parallelepiped") == 0)
    return ph_solid_parallelepiped(b, a, r->point);
  if (strcmp(r->kind, "triangle") == 0)
    return ph_plate_triangle(b, a, r->point);
  return ph_wire_polyline(b, a, r->count, r->point, strcmp(r->kind, "ring") == 0);
}

static int by_outlines(const struct outline_row *r, ph_body *b, ph_amount a) {
  if (strcmp(r->kind, "plate") == 0)
    return ph_plate_polygon(b, a, r->n, r->count, r->point);
  if (strcmp(r->kind, "revolve") == 0)
    return ph_revolve(b, a, r->n, r->count, r->point);
  return r->n == 1 ? ph_solid_prism(b, a, r->count[0], r->point, r->h)
                   : ph_extrude(b, a, r->n, r->count, r->point, r->h);
}

int main(void) {
  sizes();
  for (EACH(point_row, point_rows))
    COMPARE(r->kind, r->point, by_points(r, b, a));
  for (EACH(outline_row, outline_rows))
    COMPARE(r->kind, r->point, by_outlines(r, b, a));
  for (EACH(region_row, region_rows)) {
    const double order[3] = {r->order[0], r->order[1], r->order[2]};
    COMPARE("region", order, ph_region(b, a, r->order, r->limit, &r->density));
  }
  diag("worst errors in ulp: mass %.2Lf, centre %.2Lf, tensor %.2Lf", worst.mass, worst.com,
       worst.tensor);
  return tap_done();
}
