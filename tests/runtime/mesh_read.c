/* mesh_read.c - the formats of mesh files, the numbers in them, and files that are malformed.
   SPDX-License-Identifier: GPL-3.0-or-later

   Numbers are compared with strtod of the C library, which rounds correctly. Every format is cut
   off at every byte and has its bytes changed at random: a status must come back, whatever it is,
   and under the sanitizers nothing else may happen. */
#include <float.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "mesh/mesh.h"
#include "mesh_files.h"
#include "tap.h"

static char path[64];

static int read_bytes(const char *ending, const void *bytes, size_t n, ph_mesh_kind kind,
                      ph_mesh *m, char message[200]) {
  char name[80];
  snprintf(name, sizeof name, "%s%s", path, ending);
  FILE *f = fopen(name, "wb");
  fwrite(bytes, 1, n, f);
  fclose(f);
  const int status = ph_mesh_read(m, name, kind, message, 200);
  remove(name);
  return status;
}

/* xorshift64*, the same numbers every time */
static uint64_t random_bits(void) {
  static uint64_t x = 88172645463325252u;
  x ^= x >> 12, x ^= x << 25, x ^= x >> 27;
  return x * 2685821657736338717u;
}

/* ---- numbers ---- */

static int same(const char *text) {
  char copy[2000];
  double value = 77;
  snprintf(copy, sizeof copy, "%s", text);
  char *end = mesh_number(copy, &value);
  const double want = strtod(text, NULL);
  const int good = end && *end == '\0' && memcmp(&value, &want, sizeof value) == 0;
  if (!good)
    diag("%s: got %.17g want %.17g", text, value, want);
  return good;
}

static void numbers(void) {
  enum { MANY = 50000 };
  char text[1200];
  int good = 1;
  for (int i = 0; i < MANY; i++) {
    const uint64_t bits = random_bits();
    double x;
    memcpy(&x, &bits, sizeof x);
    if (isfinite(x)) {
      snprintf(text, sizeof text, "%.*g", 1 + (int)(random_bits() % 20), x);
      good = same(text) && good;
    }
  }
  ok(good, "%d doubles of any size, printed with 1 to 20 digits", (int)MANY);
  good = 1;
  for (int i = 0; i < MANY; i++) {
    const double x = ldexp((double)(random_bits() >> 11), -53 + (int)(random_bits() % 80) - 40);
    snprintf(text, sizeof text, i % 2 ? "%.17g" : "%.9f", random_bits() % 2 ? x : -x);
    good = same(text) && good;
  }
  ok(good, "%d doubles of everyday size", (int)MANY);
  good = 1;
  for (int i = 0; i < MANY; i++) { /* any digits, point anywhere, any exponent near the limits */
    const int digits = 1 + (int)(random_bits() % 22), point = (int)(random_bits() % 23);
    int n = 0;
    for (int k = 0; k < digits; k++) {
      if (k == point)
        text[n++] = '.';
      text[n++] = (char)('0' + random_bits() % 10);
    }
    snprintf(text + n, sizeof text - (size_t)n, "e%d", (int)(random_bits() % 64) - 32);
    good = same(text) && good;
  }
  ok(good, "%d strings of digits", (int)MANY);
  good = 1;
  for (int i = 0; i < MANY; i++) { /* (2 m + 1) 2^k, 54 bits, is halfway; one unit beside it too */
    const uint64_t odd = (random_bits() >> 11 | UINT64_C(1) << 52) * 2 + 1;
    const int k = (int)(random_bits() % 9);
    const uint64_t w = odd << k;
    snprintf(text, sizeof text, "%llu", (unsigned long long)(w + random_bits() % 3 - 1));
    good = same(text) && good;
    snprintf(text, sizeof text, "%.1f", ldexp((double)(odd >> 1), -k)); /* fractions */
    good = same(text) && good;
  }
  ok(good, "%d integers halfway between doubles, and beside them", (int)MANY);
  static const char *const odd[] = {"0",
                                    "-0",
                                    "+1",
                                    "1.",
                                    ".5",
                                    "-.5e+3",
                                    "0e999999999999",
                                    "0.0000000000000000000000000000000000000000000000000000001",
                                    "1e23",
                                    "8.5e22",
                                    "9007199254740993",
                                    "9007199254740993.0000000000000000000000001",
                                    "9007199254740992.9999999999999999999999999",
                                    "2.2250738585072011e-308",
                                    "4.9e-324",
                                    "2.4703282292062327e-324",
                                    "2.4703282292062328e-324",
                                    "1.7976931348623157e308",
                                    "1.7976931348623159e308",
                                    "1e999999",
                                    "-1e-999999",
                                    "00000000000000000000001",
                                    "1000000000000000000000000000000000000000000000e-45",
                                    "18446744073709551615",
                                    "9999999999999999999",
                                    "99999999999999999999",
                                    "6.0221407599999999e23",
                                    "123456789012345678.5",
                                    "-INF",
                                    "infinity"};
  for (size_t i = 0; i < sizeof odd / sizeof odd[0]; i++)
    ok(same(odd[i]), "the number %s", odd[i]);
  memset(text, '1', 1000);
  text[1000] = '\0';
  ok(same(text), "a number of 1000 digits");
  static const char *const wrong[] = {"", "-", "+", ".", "e5", "-.e5", "x", "--1", "i", "infi"};
  for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    double value;
    snprintf(text, sizeof text, "%s", wrong[i]);
    ok(mesh_number(text, &value) == NULL, "\"%s\" is no number", wrong[i]);
  }
}

/* ---- formats ---- */

#define FACET(a, b, c)                                                                             \
  "facet normal -nan(ind) 0 1\n outer loop\n  vertex " a "\n  vertex " b "\n  vertex " c           \
  "\n endloop\nendfacet\n"
#define SOLID                                                                                      \
  FACET("0 0 0", "0 1 0", "1 0 0")                                                                 \
  FACET("0 0 0", "1 0 0", "0 0 1") FACET("0 0 0", "0 0 1", "0 1 0") FACET("1 0 0", "0 1 0", "0 0 1")
#define PLY(format) "ply\nformat " format " 1.0\ncomment by hand\n"
#define PLY_VERTEX  "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
#define PLY_FACE    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
#define PLY_DATA    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
#define OBJ_DATA    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"

static void formats(void) {
  static const struct {
    const char *what, *ending, *text;
  } list[] = {
      {"text STL", ".stl", "solid corner\n" SOLID "endsolid corner\n"},
      {"text STL after blanks", ".stl", "\n  \t solid\n" SOLID "endsolid\n"},
      {"text STL, capitals, lines ended by CR LF", ".STL",
       "SOLID A B C\r\nFACET NORMAL 0 0 0\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nVERTEX 0 1 0\r\n"
       "VERTEX 1E0 0 0\r\nENDLOOP\r\nENDFACET\r\n" FACET("0 0 0", "1 0 0", "0 0 1")
           FACET("0 0 0", "0 0 1", "0 1 0") FACET("1 0 0", "0 1 0", "0 0 1") "ENDSOLID"},
      {"text STL of two solids", ".stl",
       "solid a\n" FACET("0 0 0", "0 1 0", "1 0 0")
           FACET("0 0 0", "1 0 0", "0 0 1") "endsolid a\nsolid b\n" FACET("0 0 0", "0 0 1", "0 1 0")
               FACET("1 0 0", "0 1 0", "0 0 1") "endsolid b\n"},
      {"text STL by content", ".dat", "solid corner\n" SOLID "endsolid corner\n"},
      {"OBJ", ".obj",
       "# c\nmtllib a.mtl\no x\n" OBJ_DATA "g y\ns off\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4"},
      {"OBJ with textures, normals, numbers from the end, colours", ".obj",
       "v 0 0 0 1 0.5 0.5\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\nf 1/1 3/1 2/1\n"
       "f 1/1/1 2/1/1 4/1/1\nf 1//1 4//1 3//1\nf -3 -2/-1 -1//-1\n"},
      {"OBJ, vertices between faces, lines continued", ".obj",
       "v 0 \\\n 0 0\nv 1 0 0\r\nv 0 1 0\nf 1 3 \\\r\n2\nv 0 0 1\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"},
      {"OBJ by content", "", "# c\n" OBJ_DATA "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"},
      {"text PLY", ".ply", PLY("ascii") PLY_VERTEX PLY_FACE PLY_DATA},
      {"text PLY by content", ".x.y", PLY("ascii") PLY_VERTEX PLY_FACE PLY_DATA},
      {"text PLY with more elements and properties", ".ply",
       PLY("ascii") "obj_info none\nelement camera 2\nproperty float fov\nproperty list uint8 "
                    "short ids\n"
                    "element vertex 4\nproperty uchar red\nproperty int8 z\nproperty float64 "
                    "y\nproperty list int "
                    "float w\nproperty short x\nelement face 4\nproperty float32 q\nproperty list "
                    "uint16 uint "
                    "vertex_index\nproperty list uchar float texcoord\nend_header\n"
                    "1 2 3 4\n2 0\n9 0 0 0 0\n9 0 0.0e0 1 5 1\n9 0 1 0 0\n9 1 0 2 1 1 0\n"
                    "0 3 0 2 1 0\n0 3 0 1 3 2 5 5\n\n0 3 0 3 2 0\n0 3 1 2 3 0\n"},
  };
  char message[200];
  for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
    ph_mesh m;
    memset(&m, 0, sizeof m);
    const int status =
        read_bytes(list[i].ending, list[i].text, strlen(list[i].text), PH_MESH_VOLUME, &m, message);
    ok(status == PH_OK && m.measure == 1 / 6.0 && m.vertices == 4 && m.edges == 6 && m.open == 0 &&
           m.triangles == 4,
       "%s: the corner tetrahedron %s", list[i].what, message);
  }
}

/* Every scalar type of PLY, both byte orders: vertices -1 and 1 in floats, 1 to 100 in integers. */
static void types(void) {
  static const char *const names[] = {"char", "uchar", "short", "ushort",
                                      "int",  "uint",  "float", "double"};
  static const int width[] = {1, 1, 2, 2, 4, 4, 4, 8};
  for (int t = 0; t < 8; t++)
    for (int big = 0; big < 2; big++) {
      char bytes[1000], message[200];
      FILE *f = fopen(path, "w+b");
      fprintf(f, "ply\nformat binary_%s_endian 1.0\nelement vertex 3\nproperty uchar a\n",
              big ? "big" : "little");
      for (int k = 0; k < 3; k++)
        fprintf(f, "property %s %c\n", names[t], 'x' + k);
      fprintf(
          f,
          "property list short double skipped\nelement face 1\nproperty list %s %s vertex_indices\n"
          "end_header\n",
          t < 6 ? names[t] : "uint", t < 6 ? names[t] : "int");
      const int least = t < 6 && t % 2 ? 1 : -1; /* unsigned types have no -1 */
      for (int v = 0; v < 3; v++) {
        put_bits(f, 10, 1, big); /* looks like a newline */
        for (int k = 0; k < 3; k++) {
          const double x = k == v ? 100 : least;
          if (t < 6)
            put_bits(f, (uint64_t)(int64_t)x, width[t], big);
          else if (t == 6)
            put_float(f, x, big);
          else
            put_double(f, x, big);
        }
        put_bits(f, 1, 2, big);
        put_double(f, 3, big);
      }
      put_bits(f, 3, t < 6 ? width[t] : 4, big);
      for (uint64_t k = 0; k < 3; k++)
        put_bits(f, k, t < 6 ? width[t] : 4, big);
      rewind(f);
      const size_t n = fread(bytes, 1, sizeof bytes, f);
      fclose(f);
      ph_mesh m;
      memset(&m, 0, sizeof m);
      const int status = read_bytes(".ply", bytes, n, PH_MESH_SURFACE, &m, message);
      /* an equilateral triangle: side sqrt 2 (100 - least), area sqrt 3/4 of its square */
      const long double side = 100.0L - least;
      ok(status == PH_OK, "binary PLY of %s, %s: is read %s", names[t], big ? "big" : "little",
         message);
      near(m.measure, sqrtl(3) / 2 * side * side, 2 * DBL_EPSILON * m.measure, "its area");
      ok(m.lo[0] == least && m.hi[2] == 100, "its box");
    }
  remove(path);
}

static void wires(void) {
  ph_mesh m;
  char message[200];
  const char *obj = OBJ_DATA "l 1 2\nl 2 1\nl 1 3 2 1\nf 1 2 3\n";
  ok(read_bytes(".obj", obj, strlen(obj), PH_MESH_WIRES, &m, message) == PH_OK && m.segments == 5,
     "OBJ lines are read");
  near(m.measure, 2 + sqrtl(2), 4 * DBL_EPSILON, "each distinct edge or segment is there once");
  const char *ply = PLY("ascii") PLY_VERTEX
      "element edge 2\nproperty int vertex1\nproperty int "
      "vertex2\nproperty uchar red\nend_header\n0 0 0\n3 0 0\n0 4 0\n0 0 1\n0 1 9\n2 0 9\n";
  ok(read_bytes(".ply", ply, strlen(ply), PH_MESH_WIRES, &m, message) == PH_OK && m.segments == 2 &&
         m.measure == 7 && m.vertices == 3 && m.faces == 0,
     "PLY edges are read");
  /* rods of 3 and 4 along x and y from the corner: integrals of x, y, x^2, y^2 over length 7 */
  near(m.com[0], 4.5L / 7, DBL_EPSILON, "centre x");
  near(m.com[1], 8.0L / 7, 2 * DBL_EPSILON, "centre y");
  near(m.sigma[0], 9.0L / 7 - 4.5L * 4.5L / 49, 2 * DBL_EPSILON, "xx");
  near(m.sigma[1], 64.0L / 21 - 64.0L / 49, 2 * DBL_EPSILON, "yy");
  near(m.sigma[3], -36.0L / 49, DBL_EPSILON, "xy");
  ok(read_bytes(".ply", ply, strlen(ply), PH_MESH_VOLUME, &m, message) == PH_OK &&
         ph_mesh_check(&m) == PH_EEMPTY,
     "edges have no volume");
}

/* ---- pieces: what lies across the buffer's end ---- */

static void pieces(void) {
  const char *tail = "f 1 3 \\\r\n 2\nf 1 2 4\nf 1 \\\n4 3\nf 2 3 4\n", *head = OBJ_DATA "#";
  char *text = malloc(MESH_BUFFER + 1000), message[200];
  int good = 1;
  for (size_t early = 0; early < 30 && text; early++) {
    const size_t start = strlen(head), pad = MESH_BUFFER - early - start;
    ph_mesh m;
    memset(&m, 0, sizeof m);
    memcpy(text, head, start);
    memset(text + start, 'c', pad);
    text[start + pad - 1] = '\n';
    memcpy(text + start + pad, tail, strlen(tail));
    const int status =
        read_bytes(".obj", text, start + pad + strlen(tail), PH_MESH_VOLUME, &m, message);
    good = good && status == PH_OK && m.measure == 1 / 6.0 && m.open == 0;
  }
  ok(good, "lines and their continuations across the end of a piece");
  free(text);
  static const double c[3] = {0.1, 0.2, 0.3}, a[3] = {1, 2, 3};
  const shape s = shape_ellipsoid(c, a, 60);
  ph_mesh m[FORMATS];
  char name[80];
  memset(m, 0, sizeof m);
  good = 1;
  for (int f = STL_TEXT; f < FORMATS; f++) {
    snprintf(name, sizeof name, "%s%s", path, format_ending[f]);
    shape_write(&s, name, (enum format)f);
    good = good && ph_mesh_read(&m[f], name, PH_MESH_VOLUME, NULL, 0) == PH_OK;
    good = good && memcmp(&m[f], &m[STL_TEXT], sizeof m[f]) == 0;
    remove(name);
  }
  ok(good && m[OBJ].triangles == 14160,
     "a mesh of many pieces is bit for bit the same in every format");
  shape_free((shape *)&s);
}

/* ---- malformed ---- */

#define BINARY80 "solid and yet binary, which is told by the size and by bytes that are no text. \1"

static void malformed(void) {
  static const struct {
    const char *what, *ending, *text;
    size_t size; /* 0: strlen */
    const char *message;
  } list[] = {
      {"empty", ".stl", "", 0, "the file is empty"},
      {"no faces", ".stl", "solid\nendsolid\n", 0, "the file has no faces and no lines"},
      {"no facets in binary", ".stl", BINARY80 "\0\0\0\0", 84,
       "the file has no faces and no lines"},
      {"binary cut off", ".stl", BINARY80 "\2\0\0\0 ....", 90,
       "byte 80: binary STL of 2 triangles must have 184 bytes, the file has 90"},
      {"binary, a huge count", ".stl", BINARY80 "\xff\xff\xff\xff", 84,
       "byte 80: binary STL of 4294967295 triangles must have 214748364834 bytes, the file has 84"},
      {"not even a header", ".stl", "so", 0, "byte 2: the file ends within the header"},
      {"text cut off in a loop", ".stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", 0,
       "byte 49: the file ends within a solid"},
      {"two vertices", ".stl",
       "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nendloop\n", 0,
       "line 6: a loop must have three vertices, got \"endloop\""},
      {"a vertex without a loop", ".stl", "solid\nvertex 0 0 0\n", 0,
       "line 2: a vertex must be one of three in a loop, got \" 0 0 0\""},
      {"a word for a number", ".stl", "solid\nouter loop\nvertex 0 0 1,5\n", 0,
       "line 3: a vertex must be three numbers, got \"1,5\""},
      {"a word of no meaning", ".stl", "solid\nface\n", 0,
       "line 2: a statement of STL is expected, got \"face\""},
      {"control characters", ".obj", "v 0 0 \33[31m\n", 0,
       "line 1: a vertex must be three numbers, got \"?[31m\""},
      {"OBJ vertex of two", ".obj", "v 0 0\n", 0,
       "line 1: a vertex must be three numbers, got \"\""},
      {"OBJ vertex not there", ".obj", OBJ_DATA "f 1 2 5\n", 0,
       "line 5: vertex 5 is not there: 4 so far"},
      {"OBJ vertex from the end not there", ".obj", OBJ_DATA "\nf 1 2 -5\n", 0,
       "line 6: vertex -5 is not there: 4 so far"},
      {"OBJ vertex 0", ".obj", OBJ_DATA "f 1 2 0\n", 0,
       "line 5: a corner must be a vertex's number, not 0, got \"0\""},
      {"OBJ vertex beyond all", ".obj", OBJ_DATA "f 1 2 99999999999999999999\n", 0,
       "line 5: vertex 99999999999999999999 is not there: 4 so far"},
      {"OBJ vertex 1.5", ".obj", OBJ_DATA "f 1 2 1.5\n", 0,
       "line 5: a corner must be a vertex's number, not 0, got \"1.5\""},
      {"OBJ face of two", ".obj", OBJ_DATA "f 1 2\n", 0,
       "line 5: a face must have at least three corners, got \" 1 2\""},
      {"OBJ line of one", ".obj", OBJ_DATA "l 1\n", 0,
       "line 5: a line must have at least two vertices, got \" 1\""},
      {"OBJ surface", ".obj", "cstype bezier\n", 0,
       "line 1: v, f, l or what belongs to them is expected, got \"cstype bezier\""},
      {"a NUL", ".obj", "v 0 \0 0\n", 8, "line 1: no text, or longer than 1048576 bytes"},
      {"PLY without its word", ".ply", "plyx\n", 0,
       "line 1: a PLY file must begin with ply, got \"plyx\""},
      {"PLY header cut off", ".ply", "ply\nformat ascii 1.0\n", 0,
       "byte 21: the file ends within the header"},
      {"PLY without format", ".ply", "ply\nend_header\n", 0,
       "line 2: a header must state its format, got \"end_header\""},
      {"PLY format", ".ply", "ply\nformat text 1.0\n", 0,
       "line 2: the format must be ascii, binary_little_endian or binary_big_endian, got \"text "
       "1.0\""},
      {"PLY type", ".ply", PLY("ascii") "element vertex 1\nproperty real x\n", 0,
       "line 5: a property must have a type and a name, a list a count of integer type, got \"real "
       "x\""},
      {"PLY property of no element", ".ply", PLY("ascii") "property float x\n", 0,
       "line 4: a property must belong to an element; 256 are understood, got \"float x\""},
      {"PLY without z", ".ply",
       PLY("ascii") "element vertex 1\nproperty float x\nproperty float y\nend_header\n", 0,
       "line 7: the element vertex must have properties x, y, z"},
      {"PLY property twice", ".ply",
       PLY("ascii") "element vertex 1\nproperty float x\nproperty float x\n", 0,
       "line 6: a property must not be there twice, got \"x\""},
      {"PLY count", ".ply", PLY("ascii") "element vertex -1\n", 0,
       "line 4: an element must have a name and a count, got \"vertex -1\""},
      {"PLY a huge count", ".ply",
       PLY("ascii") "element vertex 99999999999999999999\nproperty float x\nproperty float "
                    "y\nproperty float z\n"
                    "end_header\n0 0 0\n",
       0, "byte 141: the file ends within the elements that its header announces"},
      {"PLY a huge list", ".ply",
       PLY("binary_big_endian") "element face 1\nproperty list uint char other\nproperty list uint "
                                "int "
                                "vertex_index\nend_header\n\377\377\377\377.",
       0, "byte 146: the file ends within a list"},
      {"PLY a list of -1", ".ply",
       PLY("ascii") "element face 1\nproperty list char int vertex_index\nend_header\n-1\n", 0,
       "line 7: a list's length must be a whole number, not negative, got -1"},
      {"PLY corner not there", ".ply",
       PLY("ascii") PLY_VERTEX PLY_FACE "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 4\n", 0,
       "line 15: a corner must be the number of a vertex that was read, got 4"},
      {"PLY face of two", ".ply",
       PLY("ascii") PLY_VERTEX PLY_FACE "0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 0 1\n", 0,
       "line 15: a face must have at least three corners, got 2"},
      {"PLY line too long", ".ply", PLY("ascii") PLY_VERTEX PLY_FACE "0 0 0 0\n", 0,
       "line 11: a line must have the numbers of one element, got \"0\""},
      {"PLY line too short", ".ply", PLY("ascii") PLY_VERTEX PLY_FACE "0 0\n", 0,
       "line 11: a number is expected, got \"\""},
  };
  char message[200];
  for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
    ph_mesh m = {.faces = 77};
    const size_t n = list[i].size ? list[i].size : strlen(list[i].text);
    const int status = read_bytes(list[i].ending, list[i].text, n, PH_MESH_VOLUME, &m, message);
    if (!ok(status == PH_EFORMAT && m.faces == 77 && strcmp(message, list[i].message) == 0,
            "malformed, %s: says so", list[i].what))
      diag("status %d, message: %s", status, message);
  }
  ph_mesh m;
  ok(ph_mesh_read(&m, "/nonexistent/mesh.stl", PH_MESH_VOLUME, message, sizeof message) == PH_EFILE,
     "a file that is not there: %s", message);
  ok(ph_mesh_read(&m, "/", PH_MESH_VOLUME, message, sizeof message) == PH_EFILE, "a directory: %s",
     message);
  ok(ph_mesh_read(&m, "/nonexistent/mesh.stl", PH_MESH_VOLUME, message, 5) == PH_EFILE &&
         strlen(message) == 4,
     "a message is cut to its size");
}

static void fuzz(void) {
  static const double c[3] = {1, 2, 3}, a[3] = {2, 3, 5};
  static unsigned char whole[1 << 14], bytes[1 << 14];
  char message[200];
  ph_mesh m;
  shape s = shape_ellipsoid(c, a, 3);
  for (int f = 0; f < FORMATS; f++) {
    const int binary = f == STL_BINARY || f == PLY_LITTLE || f == PLY_BIG;
    shape_write(&s, path, (enum format)f);
    FILE *file = fopen(path, "rb");
    const size_t n = fread(whole, 1, sizeof whole, file);
    fclose(file);
    int whole_ones = 0;
    for (size_t k = 0; k < n; k++)
      whole_ones += read_bytes(format_ending[f], whole, k, PH_MESH_VOLUME, &m, message) == PH_OK &&
                    m.open == 0;
    /* text may lack its last newline, and STL the name behind endsolid */
    ok(whole_ones <= (binary          ? 0
                      : f == STL_TEXT ? 6
                                      : 1),
       "%s cut off anywhere: %d of %zu are whole", format_name[f], whole_ones, n);
    int known = 1;
    for (int k = 0; k < 1500; k++) {
      memcpy(bytes, whole, n);
      for (uint64_t i = 0; i <= random_bits() % 4; i++)
        bytes[random_bits() % n] = (unsigned char)random_bits();
      const int status = read_bytes(format_ending[f], bytes, n, (ph_mesh_kind)(k % 3), &m, message);
      known = known && (status == PH_OK || status == PH_EFORMAT || status == PH_ERANGE);
    }
    ok(known, "%s with bytes changed at random", format_name[f]);
  }
  int refused = 0;
  for (int k = 0; k < 600; k++) {
    const size_t n = random_bits() % 300;
    for (size_t i = 0; i < n; i++)
      bytes[i] = (unsigned char)random_bits();
    const int status = read_bytes(k % 3 ? k % 3 == 1 ? ".obj" : ".stl" : ".ply", bytes, n,
                                  PH_MESH_SURFACE, &m, message);
    refused += status == PH_EFORMAT || status == PH_ERANGE;
  }
  ok(refused == 600, "random bytes are refused");
  shape_free(&s);
  remove(path);
}

int main(void) {
  const char *tmp = getenv("TMPDIR");
  if (chdir(tmp ? tmp : "/tmp") != 0)
    return 1;
  snprintf(path, sizeof path, "polhode-read-%ld", (long)getpid());
  numbers();
  formats();
  types();
  wires();
  pieces();
  malformed();
  fuzz();
  return tap_done();
}
