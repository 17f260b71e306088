/* scene.c - a numeric scene into the library's model, and its mass properties.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "engine.h"

int engine_read(struct engine_scene *s, lua_State *L, int index) {
  static const double here[3] = {0, 0, 0};
  double origin[3];
  luaL_checktype(L, index, LUA_TTABLE);
  s->L = L;
  s->index = lua_absindex(L, index);
  s->where = "body";
  s->inputs = (int)fields_option(L, s->index, "inputs", 0);
  if (s->inputs > COURSE_INPUTS)
    return luaL_error(L, "scene: more than %d inputs", COURSE_INPUTS);
  s->input = lua_newuserdatauv(L, sizeof *s->input, 0);
  *s->input = (struct course_segment){{0}, {0}, {0}};
  engine_keep(s);
  lua_getfield(L, index, "body");
  int status = engine_read_body(s, &s->body);
  if (status != PH_OK)
    return status;
  fields_get(L, index, "origin", 3, origin, here);
  s->where = "body";
  status = ph_top_init(&s->top, &s->body, origin);
  return status == PH_OK ? engine_read_effects(s) : status;
}

/* ---- mass(scene) ---- */

static int push_principal(lua_State *L, const double tensor[6], const char *moments,
                          const char *axes) {
  ph_axes p;
  const int status = ph_principal(tensor, &p);
  if (status != PH_OK)
    return status;
  fields_push(L, 3, p.moment);
  lua_setfield(L, -2, moments);
  fields_push(L, 9, &p.axis[0][0]);
  lua_setfield(L, -2, axes);
  return PH_OK;
}

/* {mass, com (from the origin of rotation), center (in the body's coordinates), inertia (about the
   origin), centroidal, moments and axes of inertia, central_moments and central_axes of
   centroidal}. Axes are three unit vectors one after the other. */
int host_mass(lua_State *L) {
  struct engine_scene s;
  int status = engine_read(&s, L, 1);
  if (status != PH_OK)
    return engine_fail(&s, status);
  s.where = "body";
  lua_newtable(L);
  fields_set_number(L, "mass", s.body.mass);
  fields_set_list(L, "com", s.top.com, 3);
  fields_set_list(L, "center", s.body.com, 3);
  fields_set_list(L, "inertia", s.top.inertia, 6);
  fields_set_list(L, "centroidal", s.body.tensor, 6);
  status = push_principal(L, s.top.inertia, "moments", "axes");
  if (status == PH_OK)
    status = push_principal(L, s.body.tensor, "central_moments", "central_axes");
  return status == PH_OK ? 1 : engine_fail(&s, status);
}
