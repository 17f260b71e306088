/* shape.c - the leaves of a body tree, as Lua tables, into a body of the library.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Beside the shapes with a fixed number of sizes there are
 * - points {list={{m,x,y,z}, ...}}
 * - tensor {mass=, com={3}, xx= ... yz=, about="com" or "origin"}; formal: of no body, about com
 * - mesh {mass=, com={3}, sigma={6}}
 * - solid.tetrahedron, plate.triangle {vertices={{3}, ...}}
 * - solid.parallelepiped {edges={{3}, ...}}
 * - wire.polyline {points={{3}, ...}, closed=boolean}
 * - solid.prism, extrude, revolve, plate.polygon {profile={{2}, ...}, holes={profile, ...}, h=}
 * - region {order={3}, limits={{lo, hi}, ...}, density=}: lo, hi, density lists of {c, i, j, k}
 *
 * Lists are copied to blocks of Lua's, so that an error in a list leaks nothing.
 */
#include "engine.h"

#include <string.h>

static const double zero[3] = {0, 0, 0};

/* Above INT_MAX no list fits into Lua's memory with the 16 bytes of a value. */
static int length(lua_State *L, int index) {
  return (int)lua_rawlen(L, index);
}

static ph_amount amount(lua_State *L) {
  return fields_has(L, -1, "density") ? ph_amount_density(fields_number(L, -1, "density"))
                                      : ph_amount_mass(fields_number(L, -1, "mass"));
}

/* ---- shapes of given sizes ---- */

/* The arguments' names of a shape in the library's catalogue, NULL when it has none of that
 * name. */
static const char *arguments_of(const char *name) {
  for (int i = 0; ph_shape_name(i) != NULL; i++)
    if (strcmp(ph_shape_name(i), name) == 0)
      return ph_shape_arguments(i);
  return NULL;
}

static int read_catalogued(lua_State *L, const char *name, ph_body *out) {
  const char *names = arguments_of(name);
  double argument[16];
  int count = 0;
  if (names == NULL)
    return PH_ENAME;
  const ph_amount a = amount(L);
  if (strcmp(name, "rod.between") == 0) {
    fields_get(L, -1, "from", 3, argument, NULL);
    fields_get(L, -1, "to", 3, argument + 3, NULL);
    count = 6;
    names = "";
  }
  while (*names != '\0' && count < 16) {
    const size_t n = strcspn(names, " ");
    const char *key = lua_pushlstring(L, names, n);
    lua_insert(L, -2);
    argument[count++] =
        strcmp(key, "ends") == 0 ? fields_flag(L, -1, key) : fields_number(L, -1, key);
    lua_remove(L, -2);
    names += n + strspn(names + n, " ");
  }
  return ph_shape_make(out, name, a, argument, count);
}

/* ---- lists ---- */

/* Rows of `width` numbers from the list at the stack's top into out. */
static void rows(lua_State *L, int width, double *out) {
  for (int i = 0, n = length(L, -1); i < n; i++) {
    lua_rawgeti(L, -1, i + 1);
    fields_list(L, -1, width, out + (ptrdiff_t)width * i);
    lua_pop(L, 1);
  }
}

/* Push the list in a field of the table on top: its length. */
static int field(lua_State *L, const char *key) {
  if (lua_getfield(L, -1, key) != LUA_TTABLE)
    luaL_error(L, "field '%s': list expected, got %s", key, luaL_typename(L, -1));
  return length(L, -1);
}

/* The rows in a field of the table on top, in a block that is pushed; *count of them. */
static double *list(lua_State *L, const char *key, int width, int *count) {
  *count = field(L, key);
  double *out = lua_newuserdatauv(L, ((size_t)*count * (size_t)width + 1) * sizeof *out, 0);
  lua_insert(L, -2);
  rows(L, width, out);
  lua_pop(L, 1);
  return out;
}

static int read_points(lua_State *L, ph_body *out) {
  int n;
  const double *row = list(L, "list", 4, &n);
  double *m = lua_newuserdatauv(L, ((size_t)n * 4 + 1) * sizeof *m, 0), *r = m + n;
  for (int i = 0; i < n; i++) {
    m[i] = row[4 * i];
    memcpy(r + 3 * i, row + 4 * i + 1, 3 * sizeof *r);
  }
  const int status = ph_body_points(out, n, m, r);
  lua_pop(L, 2);
  return status;
}

static int read_vertices(lua_State *L, const char *name, ph_body *out) {
  const ph_amount a = amount(L);
  const int line = strcmp(name, "wire.polyline") == 0,
            triangle = strcmp(name, "plate.triangle") == 0;
  const int edges = strcmp(name, "solid.parallelepiped") == 0;
  const int closed = line && fields_flag(L, -1, "closed");
  int n, status;
  const double *v = list(L, line ? "points" : edges ? "edges" : "vertices", 3, &n);
  if (line)
    status = ph_wire_polyline(out, a, n, v, closed);
  else if (n != (triangle || edges ? 3 : 4))
    status = PH_ECOUNT;
  else
    status = triangle ? ph_plate_triangle(out, a, v)
             : edges  ? ph_solid_parallelepiped(out, a, v)
                      : ph_solid_tetrahedron(out, a, v);
  lua_pop(L, 1);
  return status;
}

/* Profile and holes in one block each of counts and of coordinates. */
static int read_outlines(lua_State *L, const char *name, ph_body *out) {
  const ph_amount a = amount(L);
  const int solid = strcmp(name, "extrude") == 0 || strcmp(name, "solid.prism") == 0;
  const double h = solid ? fields_number(L, -1, "h") : 0;
  const int top = lua_gettop(L), profile = field(L, "profile");
  lua_pushvalue(L, top);
  const int holes = fields_has(L, -1, "holes") ? field(L, "holes") : (lua_newtable(L), 0);
  /* on the stack now: top, profile, top again, holes */
  int *count = lua_newuserdatauv(L, ((size_t)holes + 1) * sizeof *count, 0);
  size_t points = (size_t)profile;
  count[0] = profile;
  for (int i = 0; i < holes; i++) {
    if (lua_rawgeti(L, top + 3, i + 1) != LUA_TTABLE)
      luaL_error(L, "field 'holes': list of points expected, entry %d is a %s", i + 1,
                 luaL_typename(L, -1));
    points += (size_t)(count[i + 1] = length(L, -1));
    lua_pop(L, 1);
  }
  double *point = lua_newuserdatauv(L, (points * 2 + 1) * sizeof *point, 0), *next = point;
  lua_pushvalue(L, top + 1);
  rows(L, 2, next);
  for (int i = 0; i < holes; i++) {
    next += 2 * (ptrdiff_t)count[i];
    lua_rawgeti(L, top + 3, i + 1);
    rows(L, 2, next);
    lua_pop(L, 1);
  }
  const int status = solid ? ph_extrude(out, a, holes + 1, count, point, h)
                     : strcmp(name, "revolve") == 0
                         ? ph_revolve(out, a, holes + 1, count, point)
                         : ph_plate_polygon(out, a, holes + 1, count, point);
  lua_settop(L, top);
  return status;
}

/* ---- regions ---- */

/* The polynomial at the stack's top, which is replaced by the block of its terms. */
static ph_polynomial polynomial(lua_State *L) {
  luaL_checktype(L, -1, LUA_TTABLE);
  const int n = length(L, -1);
  ph_term *term = lua_newuserdatauv(L, ((size_t)n + 1) * sizeof *term, 0);
  for (int k = 0; k < n; k++) {
    double row[4];
    lua_rawgeti(L, -2, k + 1);
    fields_list(L, -1, 4, row);
    lua_pop(L, 1);
    term[k].coefficient = row[0];
    for (int i = 0; i < 3; i++) {
      if (!(row[1 + i] >= -1 && row[1 + i] <= 1e6)) /* what the library refuses anyway */
        row[1 + i] = -1;
      term[k].power[i] = (int)row[1 + i];
      if (term[k].power[i] != row[1 + i])
        luaL_error(L, "region: the exponent %f is no integer", row[1 + i]);
    }
  }
  lua_remove(L, -2);
  return (ph_polynomial){n, term};
}

static int read_region(lua_State *L, ph_body *out) {
  const int top = lua_gettop(L);
  double order[3];
  int permutation[3];
  ph_polynomial limit[6], density = {0, NULL};
  fields_get(L, top, "order", 3, order, NULL);
  for (int i = 0; i < 3; i++)
    permutation[i] = order[i] == 1 || order[i] == 2 || order[i] == 3 ? (int)order[i] - 1 : -1;
  field(L, "limits");
  for (int i = 0; i < 3; i++) {
    if (lua_rawgeti(L, top + 1, i + 1) != LUA_TTABLE)
      luaL_error(L, "region: three pairs of limits expected");
    const int at = lua_gettop(L);
    for (int k = 0; k < 2; k++) {
      lua_rawgeti(L, at, k + 1);
      limit[2 * i + k] = polynomial(L);
    }
  }
  lua_pushvalue(L, top);
  ph_amount a = {0, 0};
  const int by_polynomial = lua_getfield(L, -1, "density") == LUA_TTABLE;
  if (by_polynomial) {
    density = polynomial(L);
    a = ph_amount_density(1);
  } else {
    lua_pop(L, 1);
    a = amount(L);
  }
  const int status = ph_region(out, a, permutation, limit, by_polynomial ? &density : NULL);
  lua_settop(L, top);
  return status;
}

/* ---- bodies by their moments ---- */

static int read_mesh(lua_State *L, ph_body *out) {
  double com[3], sigma[6];
  fields_get(L, -1, "com", 3, com, NULL);
  fields_get(L, -1, "sigma", 6, sigma, NULL);
  return ph_body_moments(out, fields_number(L, -1, "mass"), com, sigma);
}

static int read_tensor(lua_State *L, ph_body *out) {
  static const char *const entry[6] = {"xx", "yy", "zz", "xy", "xz", "yz"};
  double com[3], tensor[6];
  const double mass = fields_number(L, -1, "mass");
  fields_get(L, -1, "com", 3, com, zero);
  for (int i = 0; i < 6; i++)
    tensor[i] = i < 3 || fields_has(L, -1, entry[i]) ? fields_number(L, -1, entry[i]) : 0.0;
  lua_getfield(L, -1, "about");
  const int origin = strcmp(luaL_optstring(L, -1, "com"), "origin") == 0;
  lua_pop(L, 1);
  if (fields_has(L, -1, "formal"))
    return ph_body_formal(out, mass, com, tensor);
  return origin ? ph_body_tensor_origin(out, mass, com, tensor)
                : ph_body_tensor(out, mass, com, tensor);
}

/* Is name one of the words? */
static int among(const char *name, const char *const words[]) {
  while (*words != NULL && strcmp(*words, name) != 0)
    words++;
  return *words != NULL;
}

int engine_read_shape(struct engine_scene *s, const char *name, ph_body *out) {
  static const char *const vertices[] = {"solid.tetrahedron", "solid.parallelepiped",
                                         "plate.triangle", "wire.polyline", NULL};
  static const char *const outlines[] = {"solid.prism", "extrude", "revolve", "plate.polygon",
                                         NULL};
  lua_State *L = s->L;
  luaL_checkstack(L, 24, "shape");
  if (strcmp(name, "points") == 0)
    return read_points(L, out);
  if (strcmp(name, "tensor") == 0)
    return read_tensor(L, out);
  if (strcmp(name, "mesh") == 0)
    return read_mesh(L, out);
  if (strcmp(name, "region") == 0)
    return read_region(L, out);
  if (among(name, vertices))
    return read_vertices(L, name, out);
  return among(name, outlines) ? read_outlines(L, name, out) : read_catalogued(L, name, out);
}
