/* mesh.c - what reading a mesh costs and how good its numbers are, beside a plain double summation.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Bodies: a box whose corner is 1e3 of its edges away, subdivided, and a tessellated ellipsoid at
 * the origin. Truth is the sum over the very same triangles in 640 bits. The plain summation has
 * the same tetrahedra in double about the file's origin, added one by one.
 */
#include "clock.h"
#include "mesh_files.h"
#include "polhode.h"

enum { REPEATS = 5 };

/* Seconds to read the file, the median. */
static double time_read(const char *path, ph_mesh *mesh) {
  double time[REPEATS];
  char message[200];
  for (int k = 0; k < REPEATS; k++) {
    const double start = now();
    if (ph_mesh_read(mesh, path, PH_MESH_VOLUME, message, sizeof message) != PH_OK) {
      fprintf(stderr, "%s: %s\n", path, message);
      exit(1);
    }
    time[k] = now() - start;
  }
  qsort(time, REPEATS, sizeof time[0], ascending);
  return time[REPEATS / 2];
}

/* Volume and second moments about the centre per unit volume, the textbook way. */
static double plain(const shape *s, double sigma[6]) {
  double v = 0, f[3] = {0}, q[6] = {0};
  for (size_t t = 0; t < s->triangles; t++) {
    double p[3][3], c[3];
    for (size_t k = 0; k < 3; k++)
      for (size_t i = 0; i < 3; i++)
        p[k][i] = s->xyz[3 * (size_t)s->face[3 * t + k] + i];
    for (int i = 0; i < 3; i++) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      c[i] = p[1][j] * p[2][k] - p[1][k] * p[2][j];
    }
    const double d = p[0][0] * c[0] + p[0][1] * c[1] + p[0][2] * c[2];
    v += d / 6;
    for (int i = 0; i < 3; i++)
      f[i] += d / 24 * (p[0][i] + p[1][i] + p[2][i]);
    for (int i = 0; i < 6; i++) {
      const int r = truth_row[i], l = truth_col[i];
      double sum = (p[0][r] + p[1][r] + p[2][r]) * (p[0][l] + p[1][l] + p[2][l]);
      for (int k = 0; k < 3; k++)
        sum += p[k][r] * p[k][l];
      q[i] += d / 120 * sum;
    }
  }
  for (int i = 0; i < 6; i++)
    sigma[i] = q[i] / v - f[truth_row[i]] / v * (f[truth_col[i]] / v);
  return v;
}

/* Largest error of an entry, relative to the trace. */
static double error_of(const double sigma[6], const truth *t) {
  long double worst = 0;
  for (int i = 0; i < 6; i++)
    worst = fmaxl(worst, fabsl((long double)sigma[i] - t->sigma[i]));
  return (double)(worst / (t->sigma[0] + t->sigma[1] + t->sigma[2]));
}

static void row(const char *name, const shape *s, const char *path) {
  ph_mesh mesh;
  double sigma[6], time[FORMATS];
  for (int f = 0; f < FORMATS; f++) {
    shape_write(s, path, (enum format)f);
    char moved[300];
    snprintf(moved, sizeof moved, "%s%s", path, format_ending[f]);
    if (rename(path, moved) != 0)
      exit(1);
    time[f] = time_read(moved, &mesh);
    if (f == PLY_LITTLE) {
      const truth t = shape_truth(s, 0, 0);
      const double start = now(), v = plain(s, sigma), spent = now() - start;
      printf("  %-9s %8zu  %8.1e %8.1e  %8.1e %8.1e  %6.1f", name, s->triangles,
             (double)fabsl(((long double)mesh.measure - t.measure) / t.measure),
             error_of(mesh.sigma, &t), (double)fabsl(((long double)v - t.measure) / t.measure),
             error_of(sigma, &t), 1e3 * spent);
    }
    remove(moved);
  }
  for (int f = 0; f < FORMATS; f++)
    printf(" %10.2f", 1e3 * time[f]);
  printf("\n");
}

int main(int argc, char **argv) {
  static const double box_lo[3] = {1000, 2000, 3000}, box[3] = {1, 2, 3};
  static const double centre[3] = {0, 0, 0}, axes[3] = {1, 2, 3};
  static const size_t squares[] = {3, 9, 29, 91, 289}, rings[] = {6, 16, 50, 158, 500};
  if (argc != 2)
    return 2;
  printf("meshes: error of the volume and of the second moments (relative to their trace) against\n"
         "640 bits; time in ms to read the file and look at its edges, median of %d\n"
         "                         this library        plain double sum       "
         "read and check\n"
         "  body     triangles    volume  moments    volume  moments   time",
         (int)REPEATS);
  for (int f = 0; f < FORMATS; f++)
    printf(" %10s", format_name[f]);
  printf("\n");
  for (int i = 0; i < 5; i++) {
    shape s = shape_box(box_lo, box, squares[i]);
    row("far box", &s, argv[1]);
    shape_free(&s);
  }
  for (int i = 0; i < 5; i++) {
    shape s = shape_ellipsoid(centre, axes, rings[i]);
    row("ellipsoid", &s, argv[1]);
    shape_free(&s);
  }
  return 0;
}
