/* mesh.c - integrals over meshes against exact values, at all scales and places, and the defects
   that are counted. SPDX-License-Identifier: GPL-3.0-or-later

   Boxes and the corner tetrahedron have rational values, written here; the tessellated ellipsoid is
   integrated by mesh_files.h in 640 bits. Formats and malformed files are mesh_read.c's. */
#include <float.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "mesh_files.h"
#include "polhode.h"
#include "tap.h"

/* One rounding from long double at the end; before it 2^-56 of the sums of absolute terms, which
   for a compact mesh seen from one of its vertices are some ten times the result. */
static const double TOL = DBL_EPSILON;

static char path[64];

static ph_mesh read_shape(const shape *s, enum format format, ph_mesh_kind kind) {
  char message[200], name[80];
  ph_mesh m;
  memset(&m, 0, sizeof m);
  snprintf(name, sizeof name, "%s%s", path, format_ending[format]);
  shape_write(s, name, format);
  const int status = ph_mesh_read(&m, name, kind, message, sizeof message);
  if (status != PH_OK)
    diag("%s: status %d: %s", format_name[format], status, message);
  remove(name);
  return m;
}

static ph_mesh read_text(const char *ending, const char *text, ph_mesh_kind kind) {
  char message[200], name[80];
  ph_mesh m;
  memset(&m, 0, sizeof m);
  snprintf(name, sizeof name, "%s%s", path, ending);
  FILE *f = fopen(name, "wb");
  fputs(text, f);
  fclose(f);
  const int status = ph_mesh_read(&m, name, kind, message, sizeof message);
  if (status != PH_OK)
    diag("status %d: %s", status, message);
  remove(name);
  return m;
}

/* Centre to TOL of the size, second moments to TOL of their trace. */
static void compare(const ph_mesh *m, const truth *t, const char *what) {
  long double com[3], size = 0;
  const long double trace = t->sigma[0] + t->sigma[1] + t->sigma[2];
  for (int i = 0; i < 3; i++) {
    com[i] = fabsl((long double)m->com[i] + (long double)m->com_tail[i] - t->com[i]);
    size = fmaxl(size, com[i]);
  }
  near(m->measure, t->measure, TOL * (double)t->measure, "%s: measure", what);
  ok(size <= (long double)TOL * sqrtl(trace), "%s: centre with its tail, off by %.1Lg of %.1Lg",
     what, size, sqrtl(trace));
  near_all_wide(6, m->sigma, t->sigma, TOL * (double)trace, "%s: second moments", what);
}

/* ---- boxes: rational ---- */

static truth box_truth(const double lo[3], const double size[3], int kind) {
  truth t = {0};
  const long double d[3] = {(long double)size[0], (long double)size[1], (long double)size[2]};
  const long double face[3] = {d[1] * d[2], d[2] * d[0], d[0] * d[1]};
  if (kind == PH_MESH_VOLUME)
    t.measure = d[0] * d[1] * d[2];
  else if (kind == PH_MESH_SURFACE)
    t.measure = 2 * (face[0] + face[1] + face[2]);
  else
    t.measure = 4 * (d[0] + d[1] + d[2]);
  for (int i = 0; i < 3; i++) {
    /* how much of the measure lies at the two ends of axis i; the rest is spread along it */
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const long double end = kind == PH_MESH_VOLUME    ? 0
                            : kind == PH_MESH_SURFACE ? 2 * face[i]
                                                      : 4 * (d[j] + d[k]);
    t.com[i] = (long double)lo[i] + d[i] / 2;
    t.sigma[i] = d[i] * d[i] * (end / 4 + (t.measure - end) / 12) / t.measure;
  }
  return t;
}

static const char *const kinds[] = {"volume", "surface", "wires"};

static void boxes(void) {
  static const double lo[3] = {1, -2, 3}, size[3] = {2, 3, 5};
  shape s = shape_box(lo, size, 1);
  for (int f = 0; f < FORMATS; f++)
    for (int kind = 0; kind < 2; kind++) {
      char what[80];
      const ph_mesh m = read_shape(&s, (enum format)f, (ph_mesh_kind)kind);
      const truth t = box_truth(lo, size, kind);
      snprintf(what, sizeof what, "box, %s, %s", format_name[f], kinds[kind]);
      compare(&m, &t, what);
      ok(m.triangles == 12 && m.vertices == 8 && m.edges == 18 && m.lo[1] == -2 && m.hi[2] == 8 &&
             m.open + m.flipped + m.nonmanifold + m.duplicate + m.degenerate == 0 && !m.inverted,
         "%s: counts, box, no defects", what);
    }
  shape_free(&s);
  /* wires: quadrangles have no diagonals */
  const char *cube = "v 1 -2 3\nv 3 -2 3\nv 3 1 3\nv 1 1 3\nv 1 -2 8\nv 3 -2 8\nv 3 1 8\nv 1 1 8\n"
                     "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  for (int kind = 0; kind < 3; kind++) {
    char what[80];
    const ph_mesh m = read_text(".obj", cube, (ph_mesh_kind)kind);
    const truth t = box_truth(lo, size, kind);
    snprintf(what, sizeof what, "box of quadrangles, %s", kinds[kind]);
    compare(&m, &t, what);
    ok(m.faces == 6 && m.triangles == 12 && m.edges == 12, "%s: counts", what);
  }
}

/* Far away, tiny, huge, a needle and a plate: entry by entry, since the axes are the coordinates'.
 */
static void hard_boxes(void) {
  static const struct {
    const char *what;
    double lo[3], size[3];
  } list[] = {
      {"1e9 away", {1e9, -3e9, 2e9}, {1, 2, 0.5}},
      {"1e15 away", {1e15, 1e15, -1e15}, {1, 2, 3}},
      {"size 1e-30", {1e-30, 0, 0}, {0x1p-100, 0x1p-99, 0x1p-98}},
      {"size 1e30", {0, 0, 0}, {0x1p100, 0x1p99, 0x1p101}},
      {"size 1e100", {0, 0, 0}, {0x1p332, 0x1p333, 0x1p331}},
      {"size 1e-100", {0, 0, 0}, {0x1p-332, 0x1p-333, 0x1p-331}},
      {"needle 1 : 1e-8", {0, 0, 0}, {1, 0x1p-27, 0x1p-26}},
      {"needle 1 : 1e-8 at 5", {5, 5, 5}, {1, 0x1p-27, 0x1p-26}},
      {"plate 1 : 1e-8", {0, 0, 0}, {1, 2, 0x1p-27}},
      {"plate 1 : 1e-20", {0, 0, 0}, {1, 2, 0x1p-66}},
  };
  for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
    shape s = shape_box(list[i].lo, list[i].size, 1);
    for (int kind = 0; kind < 2; kind++) {
      const ph_mesh m = read_shape(&s, PLY_LITTLE, (ph_mesh_kind)kind);
      const truth t = box_truth(list[i].lo, list[i].size, kind);
      int good = 1;
      for (int k = 0; k < 3; k++) {
        const long double centre = (long double)m.com[k] + (long double)m.com_tail[k];
        good = good && fabsl((long double)m.sigma[k] - t.sigma[k]) <= (long double)TOL * t.sigma[k];
        good = good && fabsl(centre - t.com[k]) <= (long double)TOL * sqrtl(t.sigma[k]);
        good = good && m.sigma[3 + k] * m.sigma[3 + k] <=
                           TOL * TOL * m.sigma[k > 1] * m.sigma[k > 0 ? 2 : 1];
      }
      ok(good && fabsl((long double)m.measure - t.measure) <= (long double)TOL * t.measure,
         "box %s, %s: each number to an ulp of itself", list[i].what, kinds[kind]);
    }
    shape_free(&s);
  }
  static const double zero[3] = {0}, big[3] = {1e120, 1e120, 1e120},
                      small[3] = {1e-120, 1e-120, 1e-120};
  for (int i = 0; i < 2; i++) {
    shape s = shape_box(zero, i ? small : big, 1);
    char message[100], name[80];
    ph_mesh m = {.faces = 77};
    snprintf(name, sizeof name, "%s.ply", path);
    shape_write(&s, name, PLY_BIG);
    ok(ph_mesh_read(&m, name, PH_MESH_VOLUME, message, sizeof message) == PH_ERANGE &&
           m.faces == 77,
       "a volume of 1e%s360 exceeds the doubles: %s", i ? "-" : "", message);
    remove(name);
    shape_free(&s);
  }
}

/* A plate 1 : t in no coordinate plane: terms of the size of its plane cancel down to its
   thickness, so the volume loses 1/t = 2^20 of the long doubles' digits. The roundings of a block
   of 2^8 terms wander 2^4 units of 2^-64: 2^-40 in all. */
static void tilted_plate(void) {
  static const double lo[3] = {3, 4, 5}, size[3] = {1, 1, 0x1p-20};
  shape s = shape_box(lo, size, 8);
  for (size_t i = 0; i < s.vertices; i++) {
    double *p = s.xyz + 3 * i;
    const double x = p[0], y = p[1], z = p[2];
    p[0] = x - 0.7 * z + 0.1 * y, p[1] = y + 0.3 * x, p[2] = z + 0.9 * x - 1.1 * y;
  }
  const double loss = 0x1p-40;
  const ph_mesh m = read_shape(&s, PLY_BIG, PH_MESH_VOLUME);
  const truth t = shape_truth(&s, 0, 0);
  const double trace = (double)(t.sigma[0] + t.sigma[1] + t.sigma[2]);
  ok(m.unbalanced == 0 && m.degenerate == 0, "tilted plate: closed");
  near(m.measure, t.measure, loss * m.measure, "tilted plate: volume");
  near_all_wide(6, m.sigma, t.sigma, (TOL + loss) * trace, "tilted plate: moments");
  diag("volume off by %.1Lg of it", fabsl((long double)m.measure - t.measure) / t.measure);
  shape_free(&s);
}

static void others(void) {
  /* Corner tetrahedron: integrals x^i y^j z^k = i! j! k!/(i + j + k + 3)! */
  const ph_mesh m =
      read_text(".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
                PH_MESH_VOLUME);
  const truth t = {
      1.0L / 6, {0.25L, 0.25L, 0.25L}, {0.0375L, 0.0375L, 0.0375L, -0.0125L, -0.0125L, -0.0125L}};
  compare(&m, &t, "corner tetrahedron");
  static const double centres[][3] = {{0, 0, 0}, {1e6, -2e6, 5e5}}, axes[3] = {1, 2, 3};
  for (int i = 0; i < 2; i++) {
    shape s = shape_ellipsoid(centres[i], axes, 40);
    for (int kind = 0; kind < 2; kind++)
      for (int f = 0; f < FORMATS; f++) {
        char what[100];
        const truth exact = shape_truth(&s, kind, f == STL_BINARY);
        const ph_mesh e = read_shape(&s, (enum format)f, (ph_mesh_kind)kind);
        if (f == STL_BINARY && i == 1)
          continue; /* floats at 1e6 have no triangles left to speak of */
        snprintf(what, sizeof what, "ellipsoid%s, %s, %s", i ? " far away" : "", format_name[f],
                 kinds[kind]);
        compare(&e, &exact, what);
        ok(e.triangles == 6240 && e.vertices == 3122 && e.edges == 9360 && e.unbalanced == 0,
           "%s: Euler: V - E + F = 2", what);
      }
    shape_free(&s);
  }
  /* a concave prism: the profile of an L, 3 - 1 = 2 by 2 less 1 by 1, height 1; fans overlap */
  const char *ell =
      "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\n"
      "v 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\nv 0 0 1\n"
      "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\n"
      "f 5 6 12 11\nf 6 1 7 12\n";
  const ph_mesh v = read_text(".obj", ell, PH_MESH_VOLUME),
                a = read_text(".obj", ell, PH_MESH_SURFACE),
                w = read_text(".obj", ell, PH_MESH_WIRES);
  /* the square [0, 2]^2 less the square [1, 2]^2, height 1: area 4 - 1; integrals of x: 4 - 3/2;
     of x^2: 16/3 - 7/3; of xy: 4 - 9/4; less area times the centre's 5/6 squared */
  near(v.measure, 3, 0, "concave prism: volume 3");
  for (int i = 0; i < 3; i++)
    near(v.com[i], i < 2 ? 5.0L / 6 : 0.5L, TOL, "concave prism: centre %d", i);
  near(v.sigma[0], 11.0L / 36, TOL, "concave prism: xx");
  near(v.sigma[3], -1.0L / 9, TOL, "concave prism: xy");
  near(a.measure, 14, 0, "concave prism: area 2 * 3 + 8");
  near(w.measure, 22, 0, "concave prism: wires 2 * 8 + 6");
  ok(w.edges == 18 && v.degenerate == 0, "concave prism: 18 edges, no defects");
}

/* ---- defects ---- */

#define CUBE                                                                                       \
  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"                       \
  "f 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"

static void defects(void) {
  static const struct {
    const char *what, *text;
    size_t open, flipped, nonmanifold, unbalanced, duplicate, degenerate, nonfinite;
    int inverted, status;
    double volume;
  } list[] = {
      {"no lid", CUBE, 4, 0, 0, 4, 0, 0, 0, 0, PH_EOPEN, 0},
      {"a lid flipped", CUBE "f 1 2 3 4\n", 0, 4, 0, 4, 0, 0, 0, 0, PH_EOPEN, 0},
      {"half a lid flipped", CUBE "f 1 3 2\nf 1 3 4\n", 0, 3, 0, 3, 0, 0, 0, 0, PH_EOPEN, 0},
      {"a triangle twice", CUBE "f 1 3 2\nf 1 4 3\nf 4 3 1\n", 0, 0, 3, 3, 1, 0, 0, 0, PH_EOPEN, 0},
      {"a triangle and its back", CUBE "f 1 3 2\nf 1 4 3\nf 1 4 3\nf 1 3 4\n", 0, 0, 3, 0, 2, 0, 0,
       0, PH_OK, 1},
      {"two corners equal", CUBE "f 1 3 2\nf 1 4 3\nf 1 1 2\n", 0, 0, 0, 0, 0, 1, 0, 0, PH_OK, 1},
      {"a zip of no area", CUBE "v 0.5 0.5 0\nf 1 9 2\nf 9 3 2\nf 1 3 9\nf 1 4 3\n", 0, 0, 0, 0, 0,
       1, 0, 0, PH_OK, 1},
      {"a corner repeated in a polygon", CUBE "f 4 3 3 2 1 4\n", 0, 0, 0, 0, 0, 0, 0, 0, PH_OK, 1},
      {"a corner at nan", CUBE "v nan 0 0\nf 4 3 2 1\nf 1 2 9\n", 0, 0, 0, 0, 0, 0, 1, 0,
       PH_EFINITE, 1},
      {"a corner at infinity", CUBE "v 0 1e999 0\nf 9 3 2 1\n", 4, 0, 0, 4, 0, 0, 1, 0, PH_EFINITE,
       0},
      {"vertices of its own for each side",
       CUBE "v 0 0 0\nv 1 -0 0\nv 1 1 -0.0\nv 0 1 0e5\nf 12 11 10 9\n", 0, 0, 0, 0, 0, 0, 0, 0,
       PH_OK, 1},
      {"unused vertices far away",
       "v 1e300 7 7\nv 9 9 9e200\n"
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n",
       0, 0, 0, 0, 0, 0, 0, 0, PH_OK, 1 / 6.0},
      {"inside out", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n", 0,
       0, 0, 0, 0, 0, 0, 1, PH_OK, 1 / 6.0},
      {"two triangles back to back", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n", 0, 0, 0, 0, 1,
       0, 0, 0, PH_EEMPTY, 0},
      {"two cubes that share an edge",
       CUBE "f 4 3 2 1\nv 1 2 0\nv 2 2 0\nv 2 1 0\nv 1 2 1\nv 2 2 1\nv 2 1 1\n"
            "f 3 9 10 11\nf 7 14 13 12\nf 3 11 14 7\nf 11 10 13 14\nf 10 9 12 13\nf 9 3 7 12\n",
       0, 0, 1, 0, 0, 0, 0, 0, PH_OK, 2},
      {"a cube with a hollow",
       CUBE "f 4 3 2 1\n"
            "v 0.25 0.25 0.25\nv 0.5 0.25 0.25\nv 0.25 0.5 0.25\nv 0.25 0.25 0.5\n"
            "f 9 10 11\nf 9 12 10\nf 9 11 12\nf 10 12 11\n",
       0, 0, 0, 0, 0, 0, 0, 0, PH_OK, 1 - 1 / 384.0},
  };
  for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
    const ph_mesh m = read_text(".obj", list[i].text, PH_MESH_VOLUME);
    const int good = m.open == list[i].open && m.flipped == list[i].flipped &&
                     m.nonmanifold == list[i].nonmanifold && m.unbalanced == list[i].unbalanced &&
                     m.duplicate == list[i].duplicate && m.degenerate == list[i].degenerate &&
                     m.nonfinite == list[i].nonfinite && m.inverted == list[i].inverted;
    if (!ok(good && ph_mesh_check(&m) == list[i].status, "%s: defects are counted", list[i].what))
      diag("open %zu flipped %zu nonmanifold %zu unbalanced %zu duplicate %zu degenerate %zu "
           "nonfinite %zu inverted %d status %d",
           m.open, m.flipped, m.nonmanifold, m.unbalanced, m.duplicate, m.degenerate, m.nonfinite,
           m.inverted, ph_mesh_check(&m));
    near(m.measure, list[i].volume, TOL * list[i].volume, "%s: volume", list[i].what);
  }
  const ph_mesh m = read_text(".obj", CUBE, PH_MESH_SURFACE);
  ok(ph_mesh_check(&m) == PH_OK && m.measure == 5, "an open mesh has a surface");
}

/* Many edges at one vertex. */
static void fan(void) {
  enum { SIDES = 1000 };
  shape s;
  shape_alloc(&s, SIDES + 2, 2 * (size_t)SIDES);
  shape_vertex(&s, 0, 0, 1);
  shape_vertex(&s, 0, 0, -1);
  for (int i = 0; i < SIDES; i++)
    shape_vertex(&s, cos(2e-3 * i * 3.14159265358979), sin(2e-3 * i * 3.14159265358979), 0);
  for (size_t i = 0; i < SIDES; i++) {
    const size_t j = 2 + (i + 1) % SIDES;
    shape_face(&s, 0, 2 + i, j);
    shape_face(&s, 1, j, 2 + i);
  }
  const ph_mesh m = read_shape(&s, STL_TEXT, PH_MESH_VOLUME);
  const truth t = shape_truth(&s, 0, 0);
  compare(&m, &t, "bipyramid of 1000 sides");
  ok(m.edges == 3 * SIDES && m.unbalanced == 0 && m.vertices == SIDES + 2,
     "bipyramid of 1000 sides: edges, closed");
  shape_free(&s);
}

/* ---- bodies ---- */

static void bodies(void) {
  static const double lo[3] = {1000, 2000, 3000}, size[3] = {200, 300, 500};
  shape s = shape_box(lo, size, 1);
  ph_mesh m = read_shape(&s, STL_BINARY, PH_MESH_VOLUME);
  shape_free(&s);
  ph_body b, c;
  const ph_amount density = {1, 2700}, mass = {0, 81}, none = {0, 0};
  const double r[3] = {1.1, 2.15, 3.25};
  ok(ph_mesh_body(&b, density, &m, 1e-3) == PH_OK &&
         ph_solid_box(&c, mass, 0.2, 0.3, 0.5) == PH_OK && ph_body_at(&c, &c, r) == PH_OK,
     "a box in millimetres is the library's box");
  /* 1e-3 is a double near a thousandth: five factors of it, and the box's own roundings */
  near(b.mass, 81, 4 * DBL_EPSILON * 81, "its mass");
  near_all(3, b.com, c.com, 4 * DBL_EPSILON * 3.25, "its centre");
  near_all(6, b.tensor, c.tensor, 8 * DBL_EPSILON * c.tensor[0], "its tensor");
  ok(ph_mesh_body(&b, mass, &m, 1) == PH_OK && b.mass == 81, "by mass");
  ok(ph_mesh_body(&b, none, &m, 1) == PH_EMASS, "a mass of 0 is refused");
  ok(ph_mesh_body(&b, mass, &m, -1) == PH_ELENGTH, "a unit must be positive");
  ok(ph_mesh_body(&b, mass, &m, nan("")) == PH_EFINITE, "a unit must be finite");
  ok(ph_mesh_body(&b, density, &m, 1e150) == PH_ERANGE, "a unit too large");
  ok(ph_mesh_read(&m, path, (ph_mesh_kind)3, NULL, 0) == PH_ENAME, "there are three kinds");
  m.unbalanced = 1;
  ok(ph_mesh_body(&b, mass, &m, 1) == PH_EOPEN, "an open mesh makes no solid");
}

int main(void) {
  const char *tmp = getenv("TMPDIR");
  if (chdir(tmp ? tmp : "/tmp") != 0)
    return 1;
  snprintf(path, sizeof path, "polhode-mesh-%ld", (long)getpid());
  boxes();
  hard_boxes();
  tilted_plate();
  others();
  defects();
  fan();
  bodies();
  return tap_done();
}
