/* mesh.c - mesh files through the library: counts, defects, integrals, and the body they
 * make.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "engine.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

static void set_count(lua_State *L, const char *key, size_t n) {
  lua_pushinteger(L, (lua_Integer)n);
  lua_setfield(L, -2, key);
}

static void set_list(lua_State *L, const char *key, int n, const double v[]) {
  engine_push(L, n, v);
  lua_setfield(L, -2, key);
}

static void set_number(lua_State *L, const char *key, double x) {
  lua_pushnumber(L, x);
  lua_setfield(L, -2, key);
}

static void push_mesh(lua_State *L, const ph_mesh *m) {
  lua_newtable(L);
  set_number(L, "measure", m->measure);
  set_list(L, "com", 3, m->com);
  set_list(L, "com_tail", 3, m->com_tail);
  set_list(L, "sigma", 6, m->sigma);
  lua_newtable(L);
  set_list(L, "lo", 3, m->lo);
  set_list(L, "hi", 3, m->hi);
  lua_setfield(L, -2, "box");
  set_count(L, "faces", m->faces);
  set_count(L, "triangles", m->triangles);
  set_count(L, "vertices", m->vertices);
  set_count(L, "edges", m->edges);
  set_count(L, "segments", m->segments);
  lua_newtable(L);
  set_count(L, "open", m->open);
  set_count(L, "flipped", m->flipped);
  set_count(L, "nonmanifold", m->nonmanifold);
  set_count(L, "unbalanced", m->unbalanced);
  set_count(L, "duplicate", m->duplicate);
  set_count(L, "degenerate", m->degenerate);
  set_count(L, "nonfinite", m->nonfinite);
  lua_pushboolean(L, m->inverted);
  lua_setfield(L, -2, "inverted");
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
  lua_getfield(L, options, "unit");
  const double unit = luaL_checknumber(L, -1);
  const int by_mass = lua_getfield(L, options, "mass") != LUA_TNIL;
  if (!by_mass)
    lua_getfield(L, options, "density");
  const double value = luaL_checknumber(L, -1);
  lua_pop(L, by_mass ? 2 : 3);
  int status =
      ph_mesh_body(&b, by_mass ? ph_amount_mass(value) : ph_amount_density(value), m, unit);
  if (status == PH_OK)
    status = ph_principal(b.tensor, &axes);
  if (status != PH_OK)
    return status;
  lua_newtable(L);
  set_number(L, "mass", b.mass);
  set_list(L, "com", 3, b.com);
  set_list(L, "com_tail", 3, b.com_tail);
  set_list(L, "second", 6, b.second);
  set_list(L, "tensor", 6, b.tensor);
  set_list(L, "moments", 3, axes.moment);
  lua_newtable(L);
  for (int k = 0; k < 3; k++) {
    engine_push(L, 3, axes.axis[k]);
    lua_seti(L, -2, k + 1);
  }
  lua_setfield(L, -2, "axes");
  lua_setfield(L, -2, "body");
  return PH_OK;
}

/* mesh(path, kind[, {unit=, mass= or density=}]) -> table | nil, message, table.  kind: volume,
   surface or wires.  The table, in the file's unit: measure, com, com_tail, sigma (about com, per
   unit measure), box {lo, hi}, faces, triangles, vertices, edges, segments, defects {open, flipped,
   nonmanifold, unbalanced, duplicate, degenerate, nonfinite, inverted}; body {mass, com, com_tail,
   second, tensor, moments, axes} in SI where unit (m) and mass (kg) or density (SI) are given. When
   it fails, the third result has `reason`: "file" (cannot be read), "format" (malformed), or
   "mesh" (no body can be made of it), with the counts of above only then. */
int host_mesh(lua_State *L) {
  static const char *const kinds[] = {"volume", "surface", "wires", NULL};
  const char *path = luaL_checkstring(L, 1);
  const ph_mesh_kind kind = (ph_mesh_kind)luaL_checkoption(L, 2, "volume", kinds);
  char message[256];
  struct stat info;
  ph_mesh mesh;
  lua_settop(L, 3);
  interrupt_check(L);
  const char *why = stat(path, &info) != 0 ? strerror(errno) : NULL;
  if (why == NULL && !S_ISREG(info.st_mode)) /* a fifo would block */
    why = "it is not a regular file";
  if (why != NULL) {
    lua_newtable(L);
    return refuse(L, path, "file", why);
  }
  int status = ph_mesh_read(&mesh, path, kind, message, sizeof message);
  interrupt_check(L);
  if (status != PH_OK) {
    lua_newtable(L);
    return refuse(L, path, status == PH_EFILE ? "file" : "format",
                  message[0] != '\0' ? message : ph_status_phrase(status));
  }
  push_mesh(L, &mesh);
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
  if (status == PH_OK && lua_istable(L, 3))
    status = set_body(L, 3, &mesh);
  return status == PH_OK ? 1 : refuse(L, path, "mesh", ph_status_phrase(status));
}
