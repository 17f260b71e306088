/* shape_points.c - bodies from points and outlines.
   SPDX-License-Identifier: GPL-3.0-or-later

   The order of refusals is that of shape.c: counts, not finite, mass, lengths, then what only the
   geometry knows. */
#include "shape.h"

int shape_amount(int n, const double number[], ph_amount a) {
  if (!wide_finite(n, number) || !isfinite(a.value))
    return PH_EFINITE;
  return a.value > 0 ? PH_OK : PH_EMASS;
}

int shape_store(ph_body *b, ph_amount a, geometry *g) {
  const ph_wide mass = (ph_wide)a.value * (a.by_density ? g->measure : 1);
  for (int i = 0; i < 6; i++)
    g->second[i] *= mass;
  return body_store(b, mass, g->at, g->centroid, g->second, NULL);
}

static int simplex(ph_body *b, ph_amount a, int n, const double vertex[]) {
  geometry g = {0};
  int status = shape_amount(3 * (n + 1), vertex, a);
  if (!status)
    status = geometry_simplex(n, vertex, &g);
  return status ? status : shape_store(b, a, &g);
}

int ph_plate_triangle(ph_body *b, ph_amount a, const double vertex[9]) {
  return simplex(b, a, 2, vertex);
}

int ph_solid_tetrahedron(ph_body *b, ph_amount a, const double vertex[12]) {
  return simplex(b, a, 3, vertex);
}

int ph_solid_parallelepiped(ph_body *b, ph_amount a, const double edge[9]) {
  geometry g = {0};
  int status = shape_amount(9, edge, a);
  if (!status)
    status = geometry_parallelepiped(edge, &g);
  return status ? status : shape_store(b, a, &g);
}

int ph_wire_polyline(ph_body *b, ph_amount a, int n, const double point[], int closed) {
  geometry g = {0};
  if (n < 2)
    return PH_ECOUNT;
  int status = shape_amount(3 * n, point, a);
  if (!status)
    status = geometry_polyline(n, point, closed, &g);
  return status ? status : shape_store(b, a, &g);
}

/* h: NULL for a plate. */
static int sweep(ph_body *b, ph_amount a, outlines o, const double *h) {
  geometry g = {0};
  int status = shape_amount(h != NULL, h, a);
  if (!status && h && !(*h > 0))
    status = PH_ELENGTH;
  if (!status)
    status = outlines_check(o);
  if (status)
    return status;
  geometry_polygon(o, &g);
  if (h) {
    g.measure *= (ph_wide)*h;
    g.centroid[2] = (ph_wide)*h / 2;
    g.second[ZZ] = square((ph_wide)*h) / 12;
  }
  return shape_store(b, a, &g);
}

int ph_plate_polygon(ph_body *b, ph_amount a, int n, const int count[], const double point[]) {
  return sweep(b, a, (outlines){n, count, point}, NULL);
}

int ph_extrude(ph_body *b, ph_amount a, int n, const int count[], const double point[], double h) {
  return sweep(b, a, (outlines){n, count, point}, &h);
}

int ph_solid_prism(ph_body *b, ph_amount a, int n, const double point[], double h) {
  return sweep(b, a, (outlines){1, &n, point}, &h);
}

int ph_revolve(ph_body *b, ph_amount a, int n, const int count[], const double point[]) {
  const outlines o = {n, count, point};
  geometry g = {0};
  int status = shape_amount(0, NULL, a);
  if (!status)
    status = outlines_check(o);
  if (!status)
    status = geometry_revolve(o, &g);
  return status ? status : shape_store(b, a, &g);
}
