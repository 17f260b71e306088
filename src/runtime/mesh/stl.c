/* stl.c - STL: binary or text, told apart by size and by what text may hold.
   SPDX-License-Identifier: GPL-3.0-or-later

   Binary: 80 bytes of anything (often beginning with "solid" too), a count of 32 bits, then 50
   bytes a triangle: normal and three corners as floats, 2 bytes of attribute; little endian. Text:
       solid NAME  { facet normal X Y Z  outer loop  { vertex X Y Z } x 3  endloop endfacet }
       endsolid NAME
   in any case, several solids one after another allowed (3D Systems, StereoLithography Interface
   Specification, 1988). Normals and attributes are passed over: the corners' order says the
   side. */
#include "mesh.h"

#include <string.h>

enum { HEADER = 84, FACET = 50, PROBE = 1024 };

static uint32_t little32(const unsigned char *p) {
  return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

static double little_float(const unsigned char *p) {
  const uint32_t bits = little32(p);
  float f;
  memcpy(&f, &bits, sizeof f);
  return (double)f;
}

static int64_t binary_size(uint32_t count) {
  return HEADER + (int64_t)FACET * (int64_t)count;
}

static int is_text(struct mesh_input *in) {
  const size_t n = mesh_input_fill(in, PROBE);
  const unsigned char *s = in->data + in->at;
  const size_t probe = n < PROBE ? n : PROBE;
  for (size_t i = 0; i < probe; i++)
    if ((s[i] < ' ' && !(s[i] >= '\t' && s[i] <= '\r')) || s[i] == 127)
      return 0;
  char *word = mesh_blank((char *)in->data + in->at);
  return mesh_word_is(word, mesh_word(word), "solid");
}

static int read_binary(struct mesh_build *b, uint32_t count) {
  struct mesh_input *in = &b->in;
  int status = mesh_input_skip(in, HEADER) == 0 ? PH_OK : mesh_fail_end(b, "the header");
  for (uint32_t k = 0; k < count && status == PH_OK; k++) {
    double p[9];
    if (mesh_input_fill(in, FACET) < FACET)
      return mesh_fail_end(b, "a facet");
    const unsigned char *s = in->data + in->at + 12;
    for (int i = 0; i < 9; i++)
      p[i] = little_float(s + 4 * i);
    in->at += FACET;
    status = mesh_add_triangle(b, p);
  }
  return status;
}

/* ---- text ---- */

struct loop {
  double p[9];
  int corners; /* -1: outside of a loop */
  int solid;   /* inside of a solid */
};

static int wrong(struct mesh_build *b, const char *rule, const char *got) {
  return mesh_fail(b, PH_EFORMAT, "line %llu: %s, got \"%.40s\"", (unsigned long long)b->in.line,
                   rule, got);
}

static int vertex(struct mesh_build *b, struct loop *loop, char **s) {
  if (loop->corners < 0 || loop->corners > 2)
    return wrong(b, "a vertex must be one of three in a loop", *s);
  for (int i = 0; i < 3; i++) {
    char *word = mesh_blank(*s), *end = mesh_number(word, loop->p + 3 * loop->corners + i);
    if (end == NULL || end != mesh_word(word))
      return wrong(b, "a vertex must be three numbers", word);
    *s = end;
  }
  loop->corners++;
  return PH_OK;
}

/* The statement at [word, *s); *s moves behind its arguments. */
static int statement(struct mesh_build *b, struct loop *loop, char *word, char **s) {
  if (mesh_word_is(word, *s, "vertex"))
    return vertex(b, loop, s);
  if (mesh_word_is(word, *s, "facet")) {
    for (int i = 0; i < 4; i++) /* normal x y z */
      *s = mesh_word(mesh_blank(*s));
  } else if (mesh_word_is(word, *s, "outer")) {
    *s = mesh_word(mesh_blank(*s));
    if (loop->corners >= 0)
      return wrong(b, "a loop must end before the next begins", word);
    loop->corners = 0;
  } else if (mesh_word_is(word, *s, "endloop")) {
    if (loop->corners != 3)
      return wrong(b, "a loop must have three vertices", word);
    loop->corners = -1;
    return mesh_add_triangle(b, loop->p);
  } else if (mesh_word_is(word, *s, "solid") || mesh_word_is(word, *s, "endsolid")) {
    if (loop->corners >= 0)
      return wrong(b, "a loop must end before the solid does", word);
    loop->solid = mesh_word_is(word, *s, "solid");
    *s += strlen(*s); /* the name */
  } else if (!mesh_word_is(word, *s, "endfacet")) {
    return wrong(b, "a statement of STL is expected", word);
  }
  return PH_OK;
}

static int read_text(struct mesh_build *b) {
  struct loop loop = {.corners = -1};
  char *s, *end;
  int more;
  while ((more = mesh_input_line(&b->in, 0, &s, &end)) > 0) {
    for (s = mesh_blank(s); *s != '\0'; s = mesh_blank(s)) {
      char *word = s;
      s = mesh_word(s);
      const int status = statement(b, &loop, word, &s);
      if (status != PH_OK)
        return status;
    }
  }
  if (more < 0)
    return mesh_fail_line(b);
  return loop.solid || b->in.failed ? mesh_fail_end(b, "a solid") : PH_OK;
}

int mesh_read_stl(struct mesh_build *b) {
  struct mesh_input *in = &b->in;
  const int long_enough = mesh_input_fill(in, HEADER) >= HEADER;
  const uint32_t count = long_enough ? little32(in->data + in->at + 80) : 0;
  if (long_enough && in->size == binary_size(count))
    return read_binary(b, count);
  if (is_text(in))
    return read_text(b);
  if (in->failed || !long_enough)
    return mesh_fail_end(b, "the header");
  return mesh_fail(b, PH_EFORMAT,
                   "byte 80: binary STL of %lu triangles must have %lld bytes, the file has %lld",
                   (unsigned long)count, (long long)binary_size(count), (long long)in->size);
}
