/* scene.c - a numeric scene into the library's model, and its mass properties.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Effects of one kind add up: the library has one of each, so their parameters are summed first.
 */
#include "engine.h"

#include <math.h>
#include <string.h>

/* What the effects of a scene sum to. */
struct effects {
  int gravities, dampings, decays, torques_body, torques_inertial, rotors, controls;
  double g, direction[3]; /* of the only gravity, as given */
  double field[3];        /* their sum, m/s^2 */
  double damping[9], decay, torque_body[3], torque_inertial[3], rotor[3];
};

static void add(int n, double sum[], const double v[], double factor) {
  for (int i = 0; i < n; i++)
    sum[i] += factor * v[i];
}

static int read_gravity(lua_State *L, struct effects *e) {
  static const double down[3] = {0, 0, -1};
  lua_getfield(L, -1, "g");
  e->g = luaL_checknumber(L, -1);
  lua_pop(L, 1);
  engine_get(L, -1, "direction", 3, e->direction, down);
  const double norm = hypot(hypot(e->direction[0], e->direction[1]), e->direction[2]);
  if (!(norm > 0))
    return PH_EDIRECTION;
  add(3, e->field, e->direction, e->g / norm);
  e->gravities++;
  return PH_OK;
}

/* C w and rate L are different laws, so both may be there. */
static void read_damping(lua_State *L, struct effects *e) {
  double C[9];
  if (lua_getfield(L, -1, "rate") != LUA_TNIL) {
    e->decay += luaL_checknumber(L, -1);
    e->decays++;
  }
  if (lua_getfield(L, -2, "C") != LUA_TNIL) {
    engine_list(L, -1, 9, C);
    add(9, e->damping, C, 1);
    e->dampings++;
  }
  lua_pop(L, 2);
}

static void read_torque(lua_State *L, struct effects *e) {
  static const double none[3] = {0, 0, 0};
  double v[3];
  engine_get(L, -1, "body", 3, v, none);
  add(3, e->torque_body, v, 1);
  e->torques_body += v[0] != 0 || v[1] != 0 || v[2] != 0;
  engine_get(L, -1, "inertial", 3, v, none);
  add(3, e->torque_inertial, v, 1);
  e->torques_inertial += v[0] != 0 || v[1] != 0 || v[2] != 0;
}

static void read_rotor(lua_State *L, struct effects *e) {
  double h[3];
  engine_get(L, -1, "momentum", 3, h, NULL);
  add(3, e->rotor, h, 1);
  e->rotors++;
}

static int read_effects(struct engine_scene *s, int index, struct effects *e) {
  static const char *const kinds[] = {"gravity", "damping",     "torque", "rotor",
                                      "control", "translation", "frame",  NULL};
  lua_State *L = s->L;
  int status = PH_OK;
  if (lua_getfield(L, index, "effects") == LUA_TNIL) {
    lua_pop(L, 1);
    return PH_OK;
  }
  const int n = (int)lua_rawlen(L, -1);
  for (int i = 1; i <= n && status == PH_OK; i++) {
    lua_rawgeti(L, -1, i);
    lua_getfield(L, -1, "kind");
    const char *name = luaL_checkstring(L, -1);
    lua_pop(L, 1); /* it lives in the effect's table */
    if (engine_read_act(s, name, &status)) {
      lua_pop(L, 1);
      continue;
    }
    lua_getfield(L, -1, "kind");
    const int kind = luaL_checkoption(L, -1, NULL, kinds);
    lua_pop(L, 1);
    s->where = kinds[kind];
    switch (kind) {
    case 0:
      status = read_gravity(L, e);
      break;
    case 1:
      read_damping(L, e);
      break;
    case 2:
      read_torque(L, e);
      break;
    case 3:
      read_rotor(L, e);
      break;
    case 5:
      status = engine_read_translation(s);
      break;
    case 6:
      status = engine_read_frame(s);
      break;
    default:
      s->inputs = s->inputs < 3 ? 3 : s->inputs;
      e->controls++;
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return status;
}

static int switch_on(struct engine_scene *s, const struct effects *e) {
  int status = PH_OK;
  if (e->gravities == 1) { /* g and direction as they were given: the library rounds once */
    s->where = "gravity";
    status = ph_top_gravity(&s->top, e->g, e->direction);
  } else if (e->gravities > 1) {
    const double g = hypot(hypot(e->field[0], e->field[1]), e->field[2]);
    s->where = "gravity";
    status = g > 0 ? ph_top_gravity(&s->top, g, e->field) : PH_OK;
  }
  if (status == PH_OK && e->dampings > 0) {
    s->where = "damping";
    status = ph_top_damping(&s->top, e->damping);
  }
  if (status == PH_OK && e->decays > 0) {
    s->where = "damping";
    status = ph_top_decay(&s->top, e->decay);
  }
  if (status == PH_OK && e->torques_body > 0) {
    s->where = "torque";
    status = ph_top_torque_body(&s->top, e->torque_body);
  }
  if (status == PH_OK && e->torques_inertial > 0) {
    s->where = "torque";
    status = ph_top_torque_inertial(&s->top, e->torque_inertial);
  }
  if (status == PH_OK && e->rotors > 0) {
    s->where = "rotor";
    status = ph_top_rotor(&s->top, e->rotor);
  }
  if (status == PH_OK && e->controls > 0) {
    s->where = "control";
    status = ph_top_control(&s->top);
  }
  return status;
}

int engine_read(struct engine_scene *s, lua_State *L, int index) {
  static const double here[3] = {0, 0, 0};
  struct effects e = {0};
  double origin[3];
  luaL_checktype(L, index, LUA_TTABLE);
  s->L = L;
  s->index = lua_absindex(L, index);
  s->where = "body";
  s->inputs = 0;
  if (lua_getfield(L, s->index, "inputs") != LUA_TNIL)
    s->inputs = (int)luaL_checkinteger(L, -1);
  lua_pop(L, 1);
  if (s->inputs > ENGINE_INPUTS)
    return luaL_error(L, "scene: more than %d inputs", ENGINE_INPUTS);
  s->input = lua_newuserdatauv(L, sizeof *s->input, 0);
  *s->input = (struct engine_inputs){0};
  engine_keep(s);
  lua_getfield(L, index, "body");
  int status = engine_read_body(s, &s->body);
  if (status != PH_OK)
    return status;
  engine_get(L, index, "origin", 3, origin, here);
  s->where = "body";
  status = ph_top_init(&s->top, &s->body, origin);
  if (status == PH_OK)
    status = read_effects(s, index, &e);
  return status == PH_OK ? switch_on(s, &e) : status;
}

/* ---- mass(scene) ---- */

static int push_principal(lua_State *L, const double tensor[6], const char *moments,
                          const char *axes) {
  ph_axes p;
  const int status = ph_principal(tensor, &p);
  if (status != PH_OK)
    return status;
  engine_push(L, 3, p.moment);
  lua_setfield(L, -2, moments);
  engine_push(L, 9, &p.axis[0][0]);
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
  lua_pushnumber(L, s.body.mass);
  lua_setfield(L, -2, "mass");
  engine_push(L, 3, s.top.com);
  lua_setfield(L, -2, "com");
  engine_push(L, 3, s.body.com);
  lua_setfield(L, -2, "center");
  engine_push(L, 6, s.top.inertia);
  lua_setfield(L, -2, "inertia");
  engine_push(L, 6, s.body.tensor);
  lua_setfield(L, -2, "centroidal");
  status = push_principal(L, s.top.inertia, "moments", "axes");
  if (status == PH_OK)
    status = push_principal(L, s.body.tensor, "central_moments", "central_axes");
  return status == PH_OK ? 1 : engine_fail(&s, status);
}
