/* mesh.c - mesh files through the library: counts, defects, integrals, and the body they
 * make.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "engine.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

static void set_count(lua_State *L, const char *key, size_t n) {
  fields_set_count(L, key, (lua_Integer)n);
}

/* The faults that were kept, as {kind, part, other, triangles, at, share} each. */
static void push_faults(lua_State *L, const ph_mesh *m) {
  static const char *const kinds[] = {"inward", "outward", "solid", "overlap"};
  lua_newtable(L);
  for (size_t i = 0; i < m->faults && i < PH_MESH_FAULTS; i++) {
    const ph_mesh_fault *f = &m->fault[i];
    lua_newtable(L);
    lua_pushstring(L, kinds[f->kind]);
    lua_setfield(L, -2, "kind");
    set_count(L, "part", f->part);
    set_count(L, "other", f->other);
    set_count(L, "triangles", f->triangles);
    fields_set_list(L, "at", f->at, 3);
    fields_set_number(L, "share", f->share);
    lua_seti(L, -2, (lua_Integer)i + 1);
  }
  set_count(L, "count", m->faults);
  lua_setfield(L, -2, "faults");
}

static void push_mesh(lua_State *L, const ph_mesh *m) {
  lua_newtable(L);
  fields_set_number(L, "measure", m->measure);
  fields_set_list(L, "com", m->com, 3);
  fields_set_list(L, "com_tail", m->com_tail, 3);
  fields_set_list(L, "sigma", m->sigma, 6);
  lua_newtable(L);
  fields_set_list(L, "lo", m->lo, 3);
  fields_set_list(L, "hi", m->hi, 3);
  lua_setfield(L, -2, "box");
  set_count(L, "faces", m->faces);
  set_count(L, "triangles", m->triangles);
  set_count(L, "vertices", m->vertices);
  set_count(L, "edges", m->edges);
  set_count(L, "segments", m->segments);
  set_count(L, "parts", m->parts);
  fields_set_number(L, "weld", m->weld);
  fields_set_number(L, "gap", m->gap);
  set_count(L, "merged", m->merged);
  lua_newtable(L);
  push_faults(L, m);
  set_count(L, "bent", m->bent);
  fields_set_number(L, "bend", m->measure > 0 ? m->bend / m->measure : 0);
  fields_set_flag(L, "unseen", m->unseen);
  set_count(L, "open", m->open);
  set_count(L, "flipped", m->flipped);
  set_count(L, "nonmanifold", m->nonmanifold);
  set_count(L, "unbalanced", m->unbalanced);
  set_count(L, "duplicate", m->duplicate);
  set_count(L, "degenerate", m->degenerate);
  set_count(L, "nonfinite", m->nonfinite);
  fields_set_flag(L, "inverted", m->inverted);
  lua_setfield(L, -2, "defects");
}

/* nil, message, the table on the stack's top with `reason`; the message begins with the path. */
static int refuse(lua_State *L, const char *path, const char *reason, const char *message) {
  lua_pushstring(L, reason);
  lua_setfield(L, -2, "reason");
  lua_pushnil(L);
  lua_pushfstring(L, "%s: %s", path, message);
  lua_rotate(L, -3, 2);
  return 3;
}

/* What keeps the faces from closing, with counts. */
static const char *describe_open(lua_State *L, const ph_mesh *m) {
  const struct {
    size_t n;
    const char *what;
  } list[] = {{m->open, "with one face only"},
              {m->flipped, "between faces that look to opposite sides"},
              {m->nonmanifold, "of more than two faces"}};
  luaL_Buffer text;
  const char *between = "";
  luaL_buffinit(L, &text);
  luaL_addstring(&text, "a volume needs closed faces that look outward, got edges ");
  for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
    if (list[i].n == 0)
      continue;
    lua_pushfstring(L, "%s%s: %I", between, list[i].what, (LUAI_UACINT)list[i].n);
    luaL_addvalue(&text);
    between = ", ";
  }
  luaL_pushresult(&text);
  return lua_tostring(L, -1);
}

/* options {unit=, mass= or density=}: the body in SI as field `body`; else a status. */
static int set_body(lua_State *L, int options, const ph_mesh *m) {
  ph_body b;
  ph_axes axes;
  const int by_mass = fields_has(L, options, "mass");
  const double unit = fields_number(L, options, "unit"),
               value = fields_number(L, options, by_mass ? "mass" : "density");
  int status =
      ph_mesh_body(&b, by_mass ? ph_amount_mass(value) : ph_amount_density(value), m, unit);
  if (status == PH_OK)
    status = ph_principal(b.tensor, &axes);
  if (status != PH_OK)
    return status;
  lua_newtable(L);
  fields_set_number(L, "mass", b.mass);
  fields_set_list(L, "com", b.com, 3);
  fields_set_list(L, "com_tail", b.com_tail, 3);
  fields_set_list(L, "second", b.second, 6);
  fields_set_list(L, "tensor", b.tensor, 6);
  fields_set_list(L, "moments", axes.moment, 3);
  lua_newtable(L);
  for (int k = 0; k < 3; k++) {
    fields_push(L, 3, axes.axis[k]);
    lua_seti(L, -2, k + 1);
  }
  lua_setfield(L, -2, "axes");
  lua_setfield(L, -2, "body");
  return PH_OK;
}

/* ---- the faces, to be asked about points ---- */

#define SHAPE_TYPE "polhode mesh shape"

static ph_mesh_shape **shape_at(lua_State *L) {
  return luaL_checkudata(L, 1, SHAPE_TYPE);
}

/* shape:excess(x, y, z): the distance from the faces, negative inside of a volume. */
static int shape_excess(lua_State *L) {
  ph_mesh_shape **shape = shape_at(L);
  double p[3];
  for (int i = 0; i < 3; i++)
    p[i] = luaL_checknumber(L, 2 + i);
  const double excess = ph_mesh_excess(*shape, p);
  if (isnan(excess) && isfinite(p[0] + p[1] + p[2]))
    return luaL_error(L, "out of memory");
  lua_pushnumber(L, excess);
  return 1;
}

/* shape:count(): how many triangles. */
static int shape_count(lua_State *L) {
  lua_pushinteger(L, (lua_Integer)ph_mesh_count(*shape_at(L)));
  return 1;
}

/* shape:triangle(i), from 1: nine numbers in a table. */
static int shape_triangle(lua_State *L) {
  double p[9];
  const lua_Integer i = luaL_checkinteger(L, 2);
  luaL_argcheck(L, i >= 1 && ph_mesh_triangle(*shape_at(L), (size_t)i - 1, p) == PH_OK, 2,
                "no such triangle");
  fields_push(L, 9, p);
  return 1;
}

static int shape_collect(lua_State *L) {
  ph_mesh_shape **shape = shape_at(L);
  ph_mesh_close(*shape);
  *shape = NULL;
  return 0;
}

/* An empty handle on the stack's top. */
static ph_mesh_shape **new_shape(lua_State *L) {
  static const luaL_Reg methods[] = {
      {"excess", shape_excess}, {"count", shape_count}, {"triangle", shape_triangle}, {NULL, NULL}};
  ph_mesh_shape **shape = lua_newuserdatauv(L, sizeof(ph_mesh_shape *), 0);
  *shape = NULL;
  if (luaL_newmetatable(L, SHAPE_TYPE)) {
    lua_pushcfunction(L, shape_collect);
    lua_setfield(L, -2, "__gc");
    luaL_newlib(L, methods);
    lua_setfield(L, -2, "__index");
  }
  lua_setmetatable(L, -2);
  return shape;
}

/* mesh(path, kind[, {unit=, mass= or density=, weld=, shape=}]) -> table | nil, message, table.
   kind: volume, surface or wires; weld: see ph_mesh_open; shape: true asks for the faces.  The
   table, in the file's unit: measure, com, com_tail, sigma (about com, per unit measure), box {lo,
   hi}, faces, triangles, vertices, edges, segments, parts, weld, gap, merged, defects {open,
   flipped, nonmanifold, unbalanced, duplicate, degenerate, nonfinite, inverted, bent, bend (in
   parts of the measure), unseen, faults}; shape (excess, count, triangle); body {mass, com,
   com_tail, second, tensor, moments, axes} in SI where unit (m) and mass (kg) or density (SI) are
   given. When it fails, the third result has `reason`: "file" (cannot be read), "format"
   (malformed), or "mesh" (no body can be made of it), with the counts of above only then. */
int host_mesh(lua_State *L) {
  static const char *const kinds[] = {"volume", "surface", "wires", NULL};
  const char *path = luaL_checkstring(L, 1);
  const ph_mesh_kind kind = (ph_mesh_kind)luaL_checkoption(L, 2, "volume", kinds);
  char message[256];
  struct stat info;
  ph_mesh mesh;
  lua_settop(L, 3);
  if (lua_isnil(L, 3)) {
    lua_newtable(L);
    lua_replace(L, 3);
  }
  interrupt_check(L);
  const char *why = stat(path, &info) != 0 ? strerror(errno) : NULL;
  if (why == NULL && !S_ISREG(info.st_mode)) /* a fifo would block */
    why = "it is not a regular file";
  if (why != NULL) {
    lua_newtable(L);
    return refuse(L, path, "file", why);
  }
  ph_mesh_shape **shape = fields_flag(L, 3, "shape") ? new_shape(L) : NULL;
  int status = ph_mesh_open(&mesh, shape, path, kind, fields_option(L, 3, "weld", 0), message,
                            sizeof message);
  interrupt_check(L);
  if (status != PH_OK) {
    lua_newtable(L);
    return refuse(L, path, status == PH_EFILE ? "file" : "format",
                  message[0] != '\0' ? message : ph_status_phrase(status));
  }
  push_mesh(L, &mesh);
  if (shape != NULL && *shape != NULL) {
    lua_pushvalue(L, 4);
    lua_setfield(L, -2, "shape");
  }
  status = ph_mesh_check(&mesh);
  if (status == PH_EOPEN) {
    const char *text = describe_open(L, &mesh);
    lua_insert(L, -2);
    return refuse(L, path, "mesh", text);
  }
  if (status == PH_EFINITE) {
    const char *text = lua_pushfstring(L, "coordinates must be finite, faces with others: %I",
                                       (LUAI_UACINT)mesh.nonfinite);
    lua_insert(L, -2);
    return refuse(L, path, "mesh", text);
  }
  if (status == PH_OK && fields_has(L, 3, "unit"))
    status = set_body(L, 3, &mesh);
  return status == PH_OK ? 1 : refuse(L, path, "mesh", ph_status_phrase(status));
}
