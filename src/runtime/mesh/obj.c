/* obj.c - Wavefront OBJ: vertices, faces and lines; everything else is passed over.
   SPDX-License-Identifier: GPL-3.0-or-later

   v X Y Z [...]; f and l: corners I, I/T, I//N or I/T/N, where I counts from 1 and -1 is the
   vertex before; a backslash continues a line (Wavefront, Advanced Visualizer manual, appendix B1).
   A corner must be defined before it is used. Free-form curves and surfaces are refused: leaving
   them out would leave out a part of the body. */
#include "mesh.h"

#include <string.h>

static int wrong(struct mesh_build *b, const char *rule, const char *got) {
  return mesh_fail(b, PH_EFORMAT, "line %llu: %s, got \"%.40s\"", (unsigned long long)b->in.line,
                   rule, got);
}

static int vertex(struct mesh_build *b, char *s) {
  double p[3];
  for (int i = 0; i < 3; i++) {
    char *word = mesh_blank(s);
    s = mesh_number(word, p + i);
    if (s == NULL || s != mesh_word(word))
      return wrong(b, "a vertex must be three numbers", word);
  }
  return mesh_add_vertex(b, p);
}

/* The corner at *s, which moves behind it. */
static int corner(struct mesh_build *b, char **s, uint32_t *index) {
  char *const word = *s, *p = *s;
  const int back = *p == '-';
  uint64_t n = 0;
  p += back;
  for (; *p >= '0' && *p <= '9'; p++)
    n = n <= MESH_MAX ? n * 10 + (uint64_t)(*p - '0') : n;
  *s = mesh_word(word);
  if (n == 0 || (p != *s && *p != '/'))
    return wrong(b, "a corner must be a vertex's number, not 0", word);
  if (n > b->vertex_count)
    return mesh_fail(b, PH_EFORMAT, "line %llu: vertex %.20s is not there: %llu so far",
                     (unsigned long long)b->in.line, word, (unsigned long long)b->vertex_count);
  *index = (uint32_t)(back ? b->vertex_count - n : n - 1);
  return PH_OK;
}

static int corners(struct mesh_build *b, char *s) {
  b->polygon.count = 0;
  for (s = mesh_blank(s); *s != '\0'; s = mesh_blank(s)) {
    uint32_t index = 0;
    int status = corner(b, &s, &index);
    if (status == PH_OK)
      status = mesh_list_push(b, &b->polygon, index);
    if (status != PH_OK)
      return status;
  }
  return PH_OK;
}

static int face(struct mesh_build *b, char *s) {
  const int status = corners(b, s);
  if (status == PH_OK && b->polygon.count < 3)
    return wrong(b, "a face must have at least three corners", s);
  return status == PH_OK ? mesh_add_polygon(b) : status;
}

static int lines(struct mesh_build *b, char *s) {
  int status = corners(b, s);
  if (status == PH_OK && b->polygon.count < 2)
    return wrong(b, "a line must have at least two vertices", s);
  for (size_t i = 1; status == PH_OK && i < b->polygon.count; i++)
    status = mesh_add_segment(b, b->polygon.item[i - 1], b->polygon.item[i]);
  return status;
}

static int passed_over(const char *word, const char *end) {
  static const char *const names[] = {"vt",     "vn",         "vp",        "g",        "o",
                                      "s",      "usemtl",     "mtllib",    "p",        "mg",
                                      "lod",    "bevel",      "c_interp",  "d_interp", "usemap",
                                      "maplib", "shadow_obj", "trace_obj", "vc"};
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
    if (mesh_word_is(word, end, names[i]))
      return 1;
  return 0;
}

int mesh_read_obj(struct mesh_build *b) {
  char *s, *end;
  int more, status = PH_OK;
  while (status == PH_OK && (more = mesh_input_line(&b->in, 1, &s, &end)) > 0) {
    s = mesh_blank(s);
    char *const tail = mesh_word(s);
    if (*s == '\0' || *s == '#')
      continue;
    if (tail == s + 1 && *s == 'v')
      status = vertex(b, tail);
    else if (tail == s + 1 && *s == 'f')
      status = face(b, tail);
    else if (tail == s + 1 && *s == 'l')
      status = lines(b, tail);
    else if (!passed_over(s, tail))
      status = wrong(b, "v, f, l or what belongs to them is expected", s);
  }
  if (status != PH_OK)
    return status;
  if (more < 0)
    return mesh_fail_line(b);
  return b->in.failed ? mesh_fail_end(b, "a line") : PH_OK;
}
