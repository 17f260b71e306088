/* ply.c - PLY: text and binary, either byte order, any scalar types.
   SPDX-License-Identifier: GPL-3.0-or-later

   The header names elements and their properties in the order of the data (G. Turk, The PLY Polygon
   File Format, 1994). Read are vertex {x, y, z}, face {list vertex_indices or vertex_index} and
   edge {vertex1, vertex2}; other elements and properties are passed over. Text has one element a
   line. */
#include "mesh.h"

#include <stdlib.h>
#include <string.h>

enum { MAX_ELEMENTS = 64, MAX_PROPERTIES = 256 };

enum type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64, NO_TYPE };

static const int width[] = {1, 1, 2, 2, 4, 4, 4, 8, 0};

/* What a property is for. */
enum role { OTHER, X, Y, Z, CORNERS, FROM, TO };
enum kind { UNKNOWN, VERTEX, FACE, EDGE };

struct property {
  enum type count, type; /* count NO_TYPE: a scalar */
  enum role role;
};

struct element {
  enum kind kind;
  uint64_t count;
  int first, last; /* properties [first, last) */
  unsigned roles;  /* which there are: bits 1 << role */
};

struct ply {
  int text, big;
  int elements, properties;
  struct element element[MAX_ELEMENTS];
  struct property property[MAX_PROPERTIES];
  char *s; /* text: what is left of the line */
};

static int wrong(struct mesh_build *b, const char *rule, const char *got) {
  return mesh_fail(b, PH_EFORMAT, "line %llu: %s, got \"%.40s\"", (unsigned long long)b->in.line,
                   rule, got);
}

/* ---- header ---- */

static enum type type_of(const char *s, const char *end) {
  static const char *const names[][2] = {
      {"char", "int8"}, {"uchar", "uint8"}, {"short", "int16"},   {"ushort", "uint16"},
      {"int", "int32"}, {"uint", "uint32"}, {"float", "float32"}, {"double", "float64"}};
  for (int i = 0; i < 8; i++)
    if (mesh_word_is(s, end, names[i][0]) || mesh_word_is(s, end, names[i][1]))
      return (enum type)i;
  return NO_TYPE;
}

static enum role role_of(enum kind kind, int list, const char *s, const char *end) {
  static const struct {
    enum kind kind;
    int list;
    const char *name;
    enum role role;
  } roles[] = {{VERTEX, 0, "x", X},        {VERTEX, 0, "y", Y},
               {VERTEX, 0, "z", Z},        {FACE, 1, "vertex_indices", CORNERS},
               {EDGE, 0, "vertex1", FROM}, {FACE, 1, "vertex_index", CORNERS},
               {EDGE, 0, "vertex2", TO}};
  for (size_t i = 0; i < sizeof roles / sizeof roles[0]; i++)
    if (roles[i].kind == kind && roles[i].list == list && mesh_word_is(s, end, roles[i].name))
      return roles[i].role;
  return OTHER;
}

static int read_element(struct mesh_build *b, struct ply *ply, char *s) {
  char *name = mesh_blank(s), *end = mesh_word(name), *digits = mesh_blank(end), *p = digits;
  if (ply->elements == MAX_ELEMENTS)
    return wrong(b, "at most 64 elements are understood", name);
  struct element *e = &ply->element[ply->elements];
  e->kind = mesh_word_is(name, end, "vertex") ? VERTEX
            : mesh_word_is(name, end, "face") ? FACE
            : mesh_word_is(name, end, "edge") ? EDGE
                                              : UNKNOWN;
  e->count = 0;
  e->first = e->last = ply->properties;
  e->roles = 0;
  for (; *p >= '0' && *p <= '9'; p++)
    if (e->count < UINT64_C(1) << 58)
      e->count = e->count * 10 + (uint64_t)(*p - '0');
  if (p == digits || *mesh_blank(p) != '\0')
    return wrong(b, "an element must have a name and a count", name);
  ply->elements++;
  return PH_OK;
}

static int read_property(struct mesh_build *b, struct ply *ply, char *s) {
  char *word = mesh_blank(s), *end = mesh_word(word);
  if (ply->elements == 0 || ply->properties == MAX_PROPERTIES)
    return wrong(b, "a property must belong to an element; 256 are understood", word);
  struct element *e = &ply->element[ply->elements - 1];
  struct property *p = &ply->property[ply->properties];
  const int list = mesh_word_is(word, end, "list");
  p->count = NO_TYPE;
  if (list) {
    char *count = mesh_blank(end);
    end = mesh_word(count);
    p->count = type_of(count, end);
    word = mesh_blank(end);
    end = mesh_word(word);
  }
  p->type = type_of(word, end);
  char *name = mesh_blank(end), *tail = mesh_word(name);
  if (p->type == NO_TYPE || (list && (p->count == NO_TYPE || p->count >= FLOAT32)) || name == tail)
    return wrong(b, "a property must have a type and a name, a list a count of integer type", word);
  p->role = role_of(e->kind, list, name, tail);
  if (p->role != OTHER && (e->roles & 1u << p->role))
    return wrong(b, "a property must not be there twice", name);
  e->roles |= 1u << p->role;
  e->last = ++ply->properties;
  return PH_OK;
}

static int read_format(struct mesh_build *b, struct ply *ply, char *s) {
  char *word = mesh_blank(s), *end = mesh_word(word);
  ply->text = mesh_word_is(word, end, "ascii");
  ply->big = mesh_word_is(word, end, "binary_big_endian");
  if (!ply->text && !ply->big && !mesh_word_is(word, end, "binary_little_endian"))
    return wrong(b, "the format must be ascii, binary_little_endian or binary_big_endian", word);
  return PH_OK;
}

static int complete(struct mesh_build *b, const struct ply *ply) {
  static const unsigned needed[] = {0, 1u << X | 1u << Y | 1u << Z, 1u << CORNERS,
                                    1u << FROM | 1u << TO};
  static const char *const rules[] = {
      "", "the element vertex must have properties x, y, z",
      "the element face must have a list vertex_indices or vertex_index",
      "the element edge must have properties vertex1, vertex2"};
  for (int i = 0; i < ply->elements; i++) {
    const struct element *e = &ply->element[i];
    if ((e->roles & needed[e->kind]) != needed[e->kind])
      return mesh_fail(b, PH_EFORMAT, "line %llu: %s", (unsigned long long)b->in.line,
                       rules[e->kind]);
  }
  return PH_OK;
}

static int read_header(struct mesh_build *b, struct ply *ply) {
  char *s, *end;
  int more, format = 0;
  while ((more = mesh_input_line(&b->in, 0, &s, &end)) > 0) {
    char *word = mesh_blank(s), *tail = mesh_word(word);
    int status = PH_OK;
    if (b->in.line == 1) {
      if (!mesh_word_is(word, tail, "ply"))
        return wrong(b, "a PLY file must begin with ply", word);
    } else if (mesh_word_is(word, tail, "format")) {
      status = read_format(b, ply, tail);
      format = 1;
    } else if (mesh_word_is(word, tail, "element")) {
      status = read_element(b, ply, tail);
    } else if (mesh_word_is(word, tail, "property")) {
      status = read_property(b, ply, tail);
    } else if (mesh_word_is(word, tail, "end_header")) {
      return format ? complete(b, ply) : wrong(b, "a header must state its format", word);
    } else if (word != tail && !mesh_word_is(word, tail, "comment") &&
               !mesh_word_is(word, tail, "obj_info")) {
      status = wrong(b, "a line of a PLY header is expected", word);
    }
    if (status != PH_OK)
      return status;
  }
  return more < 0 ? mesh_fail_line(b) : mesh_fail_end(b, "the header");
}

/* ---- values ---- */

static double decode(const struct ply *ply, enum type type, const unsigned char *p) {
  const int n = width[type];
  uint64_t bits = 0;
  for (int i = 0; i < n; i++)
    bits = bits << 8 | p[ply->big ? i : n - 1 - i];
  float f;
  double d;
  const uint32_t low = (uint32_t)bits;
  switch (type) {
  case FLOAT32:
    memcpy(&f, &low, sizeof f);
    return (double)f;
  case FLOAT64:
    memcpy(&d, &bits, sizeof d);
    return d;
  case INT8:
    return low & 0x80 ? (double)low - 0x100 : (double)low;
  case INT16:
    return low & 0x8000 ? (double)low - 0x10000 : (double)low;
  case INT32:
    return low & 0x80000000 ? (double)low - 0x1p32 : (double)low;
  default:
    return (double)low;
  }
}

static int read_value(struct mesh_build *b, struct ply *ply, enum type type, double *value) {
  if (ply->text) {
    char *word = mesh_blank(ply->s), *end = mesh_number(word, value);
    if (end == NULL || end != mesh_word(word))
      return wrong(b, "a number is expected", word);
    ply->s = end;
    return PH_OK;
  }
  const size_t n = (size_t)width[type];
  if (b->in.end - b->in.at < n && mesh_input_fill(&b->in, n) < n)
    return mesh_fail_end(b, "an element");
  *value = decode(ply, type, b->in.data + b->in.at);
  b->in.at += n;
  return PH_OK;
}

/* "line 12" or "byte 345" of what was just read. */
static int wrong_value(struct mesh_build *b, const struct ply *ply, const char *rule, double got) {
  return mesh_fail(b, PH_EFORMAT, "%s %llu: %s, got %.17g", ply->text ? "line" : "byte",
                   (unsigned long long)(ply->text ? b->in.line : mesh_input_tell(&b->in)), rule,
                   got);
}

static int read_index(struct mesh_build *b, struct ply *ply, enum type type, uint32_t *index) {
  double v;
  const int status = read_value(b, ply, type, &v);
  if (status != PH_OK)
    return status;
  if (!(v >= 0 && v < (double)b->vertex_count && v == floor(v)))
    return wrong_value(b, ply, "a corner must be the number of a vertex that was read", v);
  *index = (uint32_t)v;
  return PH_OK;
}

static int read_list(struct mesh_build *b, struct ply *ply, const struct property *p) {
  double count, value;
  int status = read_value(b, ply, p->count, &count);
  if (status == PH_OK && !(count >= 0 && count <= UINT32_MAX && count == floor(count)))
    return wrong_value(b, ply, "a list's length must be a whole number, not negative", count);
  if (p->role != CORNERS && !ply->text && status == PH_OK)
    return mesh_input_skip(&b->in, (uint64_t)count * (uint64_t)width[p->type]) == 0
               ? PH_OK
               : mesh_fail_end(b, "a list");
  for (uint64_t i = 0; status == PH_OK && (double)i < count; i++) {
    uint32_t index = 0;
    status = p->role == CORNERS ? read_index(b, ply, p->type, &index)
                                : read_value(b, ply, p->type, &value);
    if (status == PH_OK && p->role == CORNERS)
      status = mesh_list_push(b, &b->polygon, index);
  }
  return status;
}

static int read_one(struct mesh_build *b, struct ply *ply, const struct element *e) {
  double place[3] = {0}, value;
  uint32_t ends[2] = {0};
  int status = PH_OK;
  b->polygon.count = 0;
  for (int i = e->first; i < e->last && status == PH_OK; i++) {
    const struct property *p = &ply->property[i];
    if (p->count != NO_TYPE)
      status = read_list(b, ply, p);
    else if (p->role >= X && p->role <= Z)
      status = read_value(b, ply, p->type, &place[p->role - X]);
    else if (p->role == FROM || p->role == TO)
      status = read_index(b, ply, p->type, &ends[p->role - FROM]);
    else
      status = read_value(b, ply, p->type, &value);
  }
  if (status != PH_OK || e->kind == UNKNOWN)
    return status;
  if (e->kind == VERTEX)
    return mesh_add_vertex(b, place);
  if (e->kind == EDGE)
    return mesh_add_segment(b, ends[0], ends[1]);
  if (b->polygon.count < 3)
    return wrong_value(b, ply, "a face must have at least three corners", (double)b->polygon.count);
  return mesh_add_polygon(b);
}

/* The next line that is not empty. */
static int next_line(struct mesh_build *b, struct ply *ply) {
  char *end;
  int more;
  while ((more = mesh_input_line(&b->in, 0, &ply->s, &end)) > 0)
    if (*mesh_blank(ply->s) != '\0')
      return PH_OK;
  return more < 0 ? mesh_fail_line(b) : mesh_fail_end(b, "the elements that its header announces");
}

static int read_body(struct mesh_build *b, struct ply *ply) {
  for (int i = 0; i < ply->elements; i++) {
    const struct element *e = &ply->element[i];
    if (e->first == e->last)
      continue; /* nothing to read, however many */
    for (uint64_t k = 0; k < e->count; k++) {
      int status = ply->text ? next_line(b, ply) : PH_OK;
      if (status == PH_OK)
        status = read_one(b, ply, e);
      if (status == PH_OK && ply->text && *mesh_blank(ply->s) != '\0')
        status = wrong(b, "a line must have the numbers of one element", mesh_blank(ply->s));
      if (status != PH_OK)
        return status;
    }
  }
  return PH_OK;
}

int mesh_read_ply(struct mesh_build *b) {
  struct ply *ply = calloc(1, sizeof *ply);
  if (ply == NULL)
    return mesh_fail_memory(b);
  int status = read_header(b, ply);
  if (status == PH_OK)
    status = read_body(b, ply);
  free(ply);
  return status;
}
