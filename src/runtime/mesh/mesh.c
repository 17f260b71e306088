/* mesh.c - a mesh file read whole: the format, the result, the body made of it.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh.h"

#include "mass/body.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* ---- reading ---- */

typedef int reader(struct mesh_build *b);

/* Is the file a pointer of Git's storage of large files, or of a format that is not read? Then the
   status, with a message that helps. */
static int refuse(struct mesh_build *b, const char *path) {
  static const struct {
    const char *end, *name;
  } others[] = {{".dae", "Collada"}, {".step", "STEP"},    {".stp", "STEP"},  {".3mf", "3MF"},
                {".off", "OFF"},     {".glb", "glTF"},     {".gltf", "glTF"}, {".iges", "IGES"},
                {".igs", "IGES"},    {".fbx", "FBX"},      {".amf", "AMF"},   {".wrl", "VRML"},
                {".x3d", "X3D"},     {".blend", "Blender"}};
  static const char pointer[] = "version https://git-lfs.github.com/spec/";
  const size_t n = mesh_input_fill(&b->in, sizeof pointer - 1);
  if (n >= sizeof pointer - 1 && memcmp(b->in.data, pointer, sizeof pointer - 1) == 0)
    return mesh_fail(b, PH_EFORMAT,
                     "the file is a pointer of Git LFS (large file storage), not the mesh itself: "
                     "git lfs pull fetches it");
  const char *dot = strrchr(path, '.');
  for (size_t i = 0; dot != NULL && i < sizeof others / sizeof others[0]; i++)
    if (mesh_word_is(dot, dot + strlen(dot), others[i].end))
      return mesh_fail(b, PH_EFORMAT,
                       "%s is not read; export the part as STL, OBJ or PLY (and give its unit, "
                       "which is often mm)",
                       others[i].name);
  return PH_OK;
}

static reader *choose(const char *path, struct mesh_input *in) {
  const char *dot = strrchr(path, '.');
  if (dot != NULL) {
    const char *end = dot + strlen(dot);
    if (mesh_word_is(dot, end, ".stl"))
      return mesh_read_stl;
    if (mesh_word_is(dot, end, ".obj"))
      return mesh_read_obj;
    if (mesh_word_is(dot, end, ".ply"))
      return mesh_read_ply;
  }
  /* by content: a PLY says so, an OBJ is text that is no STL */
  const size_t n = mesh_input_fill(in, 1024);
  const unsigned char *s = in->data + in->at;
  if (n >= 4 && memcmp(s, "ply", 3) == 0 && (s[3] == '\n' || s[3] == '\r'))
    return mesh_read_ply;
  if (memchr(s, '\0', n < 1024 ? n : 1024) != NULL)
    return mesh_read_stl;
  char *word = mesh_blank((char *)in->data + in->at);
  return mesh_word_is(word, mesh_word(word), "solid") ? mesh_read_stl : mesh_read_obj;
}

/* The size, where the stream can tell; back at its beginning. */
static int64_t size_of(FILE *file) {
  const int64_t size = fseek(file, 0, SEEK_END) == 0 ? (int64_t)ftell(file) : -1;
  rewind(file);
  return size;
}

static int read_file(struct mesh_build *b, const char *path) {
  b->in.file = fopen(path, "rb");
  if (b->in.file == NULL)
    return mesh_fail(b, PH_EFILE, "%s", strerror(errno));
  int status = PH_OK;
  setvbuf(b->in.file, NULL, _IONBF, 0); /* pieces are large already */
  b->in.size = size_of(b->in.file);
  b->in.data = malloc(MESH_BUFFER + 1);
  if (b->in.data == NULL)
    status = mesh_fail_memory(b);
  else if (mesh_input_fill(&b->in, 1) == 0)
    status = b->in.failed ? mesh_fail(b, PH_EFILE, "%s", ph_status_phrase(PH_EFILE))
                          : mesh_fail(b, PH_EFORMAT, "the file is empty");
  if (status == PH_OK)
    status = refuse(b, path);
  if (status == PH_OK) {
    mesh_input_mark(&b->in);
    status = choose(path, &b->in)(b);
  }
  if (status == PH_OK)
    status = mesh_flush(b);
  fclose(b->in.file);
  free(b->in.data);
  return status;
}

/* ---- the result ---- */

/* Factors that make measure, centre and second moments of the sums; see sum.c. */
static const struct {
  ph_wide measure, first, second;
} factors[] = {
    [PH_MESH_VOLUME] = {6, 4, 20},
    [PH_MESH_SURFACE] = {2, 3, 12},
    [PH_MESH_WIRES] = {1, 2, 6},
};

/* Measure, centre and second moments about it from the sums. An open volume, or one that is
   nothing but rounding, keeps its measure 0: ph_mesh_check says so, here it is no failure. */
static int finish(struct mesh_build *b) {
  ph_mesh *m = &b->result;
  const struct mesh_sum *sum = &b->sum;
  ph_wide t[MESH_TERMS], centre[3], second[6];
  m->vertices = b->points.count - m->merged;
  memcpy(m->lo, b->points.lo, sizeof m->lo);
  memcpy(m->hi, b->points.hi, sizeof m->hi);
  if (m->faces + m->segments == 0)
    return mesh_fail(b, PH_EFORMAT, "the file has no faces and no lines");
  if (m->kind == PH_MESH_VOLUME && m->unbalanced > 0)
    return PH_OK;
  for (int i = 0; i < MESH_TERMS; i++)
    t[i] = sum->head[i] + sum->tail[i];
  /* A volume is a sum of products whose own rounding is 2^-61 of their size (t[10]): three
     roundings in n, one in the product, two in the sum, and 2^-56 of what was added. */
  if (!(fabsl(t[0]) > 0x1p-56L * t[10]))
    return PH_OK;
  m->inverted = t[0] < 0;
  for (int i = 0; i < 3; i++)
    centre[i] = t[1 + i] / (factors[m->kind].first * t[0]);
  for (int i = 0; i < 6; i++)
    second[i] = t[4 + i] / (factors[m->kind].second * t[0]);
  second[XX] -= centre[0] * centre[0], second[YY] -= centre[1] * centre[1];
  second[ZZ] -= centre[2] * centre[2], second[XY] -= centre[0] * centre[1];
  second[XZ] -= centre[0] * centre[2], second[YZ] -= centre[1] * centre[2];
  const ph_wide measure = fabsl(t[0]) / factors[m->kind].measure;
  if (!wide_fits(1, &measure) || !wide_fits(6, second) || (double)measure == 0)
    return mesh_fail(b, PH_ERANGE, "%s", ph_status_phrase(PH_ERANGE));
  m->measure = (double)measure;
  for (int i = 0; i < 6; i++)
    m->sigma[i] = (double)second[i];
  for (int i = 0; i < 3; i++) {
    const ph_wide whole = (ph_wide)sum->origin[i] + centre[i];
    m->com[i] = (double)whole;
    m->com_tail[i] = (double)(((ph_wide)sum->origin[i] - (ph_wide)m->com[i]) + centre[i]);
  }
  return PH_OK;
}

/* What is known once the file is read: near vertices, edges, parts, the integrals. */
static int examine(struct mesh_build *b) {
  ph_mesh *m = &b->result;
  int status = b->weld > 0 ? mesh_near(b) : PH_OK;
  if (status == PH_OK && b->weld > 0 && m->kind == PH_MESH_VOLUME)
    mesh_sum_again(b);
  if (status == PH_OK)
    status = mesh_topology(b);
  if (status == PH_OK && m->kind == PH_MESH_VOLUME && m->unbalanced > 0 && b->weld == 0)
    status = mesh_near_offer(b);
  if (status == PH_OK && b->part != NULL)
    status = mesh_parts(b);
  return status == PH_OK ? finish(b) : status;
}

int ph_mesh_open(ph_mesh *out, ph_mesh_shape **shape, const char *path, ph_mesh_kind kind,
                 double weld, char *message, size_t size) {
  struct mesh_build *b = calloc(1, sizeof *b);
  if (message != NULL && size > 0)
    message[0] = '\0';
  if (shape != NULL)
    *shape = NULL;
  if (b == NULL)
    return PH_EMEMORY;
  if ((unsigned)kind > PH_MESH_WIRES || !(weld >= 0 && weld <= 0.01)) {
    free(b);
    return (unsigned)kind > PH_MESH_WIRES ? PH_ENAME : PH_EBOUND;
  }
  b->message = message;
  b->message_size = size;
  b->result.kind = kind;
  b->weld = weld;
  int status = read_file(b, path);
  free(b->vertex);
  free(b->welded);
  free(b->polygon.item);
  free(b->points.slot);
  if (status == PH_OK)
    status = examine(b);
  if (status == PH_OK && shape != NULL && ph_mesh_check(&b->result) == PH_OK &&
      (*shape = mesh_shape(b)) == NULL)
    status = mesh_fail_memory(b);
  if (status == PH_OK)
    *out = b->result;
  free(b->points.xyz);
  free(b->corner.item);
  free(b->segment.item);
  free(b->part);
  free(b->turn);
  free(b);
  return status;
}

int ph_mesh_read(ph_mesh *out, const char *path, ph_mesh_kind kind, char *message, size_t size) {
  return ph_mesh_open(out, NULL, path, kind, 0, message, size);
}

/* ---- the body ---- */

int ph_mesh_check(const ph_mesh *mesh) {
  if (mesh->nonfinite > 0)
    return PH_EFINITE;
  if (mesh->kind == PH_MESH_VOLUME && mesh->unbalanced > 0)
    return PH_EOPEN;
  return mesh->measure > 0 ? PH_OK : PH_EEMPTY;
}

int ph_mesh_body(ph_body *b, ph_amount a, const ph_mesh *mesh, double unit) {
  int status = ph_mesh_check(mesh);
  if (status != PH_OK)
    return status;
  if (!isfinite(unit) || !isfinite(a.value))
    return PH_EFINITE;
  if (!(unit > 0))
    return PH_ELENGTH;
  if (!(a.value > 0))
    return PH_EMASS;
  const ph_wide u = (ph_wide)unit;
  ph_wide mass = (ph_wide)a.value, off[3], second[6];
  if (a.by_density) {
    mass *= (ph_wide)mesh->measure;
    for (int dimension = 3 - (int)mesh->kind; dimension > 0; dimension--)
      mass *= u;
  }
  double head[3];
  for (int i = 0; i < 3; i++) {
    const ph_wide at = (ph_wide)mesh->com[i] * u;
    head[i] = (double)at;
    off[i] = (at - (ph_wide)head[i]) + (ph_wide)mesh->com_tail[i] * u;
  }
  for (int i = 0; i < 6; i++)
    second[i] = mass * (ph_wide)mesh->sigma[i] * u * u;
  ph_body made;
  status = body_store(&made, mass, head, off, second, NULL);
  if (status == PH_OK)
    status = ph_body_check(&made);
  if (status == PH_OK)
    *b = made;
  return status;
}
