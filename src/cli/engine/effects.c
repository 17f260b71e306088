/* effects.c - the effects of a scene, from Lua to the library.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * What an effect reads is its own table's to say (runtime/effects/effect.h). Tables and programs
 * live as long as the scene's Lua table, which keeps them in its field "memory".
 */
#include "engine.h"

#include <string.h>

/* A number, {rows = {t, v, ...}}, {code = program} or a program at the stack's top, which is
 * popped. */
static void read_varying(struct engine_scene *s, ph_varying *out) {
  lua_State *L = s->L;
  *out = (ph_varying){0};
  if (lua_type(L, -1) == LUA_TNUMBER) {
    out->value = lua_tonumber(L, -1);
    lua_pop(L, 1);
  } else if (fields_has(L, -1, "rows")) {
    lua_getfield(L, -1, "rows");
    const int n = (int)lua_rawlen(L, -1);
    double *table = lua_newuserdatauv(L, (size_t)n * sizeof *table, 0);
    lua_insert(L, -2);
    fields_list(L, -1, n, table);
    lua_pop(L, 1);
    engine_keep(s);
    out->rows = n / 2;
    out->table = table;
    lua_pop(L, 1);
  } else {
    if (fields_has(L, -1, "code")) {
      lua_getfield(L, -1, "code");
      lua_remove(L, -2);
    }
    engine_read_program(s, out);
  }
}

/* The field's value at the stack's top, which is popped: n that vary, or as many as there are. */
static void read_varyings(struct engine_scene *s, int n, ph_varying out[]) {
  lua_State *L = s->L;
  if (n == 1) {
    read_varying(s, out);
    return;
  }
  const int length = (int)lua_rawlen(L, -1);
  for (int i = 0; i < n && i < length; i++) {
    lua_rawgeti(L, -1, i + 1);
    read_varying(s, &out[i]);
  }
  lua_pop(L, 1);
}

/* Numbers from the list at the stack's top, which is popped. */
static void read_list(struct engine_scene *s, effect_list *out) {
  lua_State *L = s->L;
  const int n = (int)lua_rawlen(L, -1);
  double *v = lua_newuserdatauv(L, (size_t)(n > 0 ? n : 1) * sizeof *v, 0);
  lua_insert(L, -2);
  fields_list(L, -1, n, v);
  lua_pop(L, 1);
  engine_keep(s);
  *out = (effect_list){n, v};
}

static void read_numbers(lua_State *L, const effect_field *f, double out[]) {
  if (f->n > 1)
    fields_get(L, -1, f->name, f->n, out, f->standard);
  else if (f->standard && !fields_has(L, -1, f->name))
    out[0] = f->standard[0];
  else
    out[0] = fields_number(L, -1, f->name);
}

/* One field of the table at the stack's top, which stays. */
static void read_field(struct engine_scene *s, const effect_field *f, char *given) {
  lua_State *L = s->L;
  void *at = given + f->at;
  if (f->type == EFFECT_NUMBERS) {
    read_numbers(L, f, at);
    return;
  }
  const int there = lua_getfield(L, -1, f->name) != LUA_TNIL;
  if (f->type == EFFECT_VARYING && there) {
    read_varyings(s, f->n, at);
    return;
  }
  if (f->type == EFFECT_JET && there) {
    ph_varying program;
    engine_read_program(s, &program);
    *(ph_support *)at = (ph_support){engine_program_jet, program.context};
    return;
  }
  if (f->type == EFFECT_LIST && there) {
    read_list(s, at);
    return;
  }
  if (f->type == EFFECT_FLAG)
    *(int *)at = lua_toboolean(L, -1);
  else if (f->type == EFFECT_GIVEN)
    *(int *)at = there;
  else if (f->type == EFFECT_LENGTH)
    *(int *)at = there ? (int)lua_rawlen(L, -1) : 0;
  lua_pop(L, 1);
}

/* The effect's table at the stack's top, which is popped. */
static int read_effect(struct engine_scene *s) {
  lua_State *L = s->L;
  lua_getfield(L, -1, "kind");
  const char *name = luaL_checkstring(L, -1);
  const effect_table *effect = effect_named(name);
  if (!effect)
    luaL_error(L, "effect: the library knows none of the name '%s'", name);
  lua_pop(L, 1);
  char *given = engine_aligned(lua_newuserdatauv(L, effect->size + ENGINE_ALIGNMENT, 0));
  memset(given, 0, effect->size);
  lua_insert(L, -2);
  for (const effect_field *f = effect->fields; f->name; f++)
    read_field(s, f, given);
  if (s->inputs < effect->inputs)
    s->inputs = effect->inputs;
  s->where = effect->name;
  const int status = effect->add(&s->top, given);
  lua_pop(L, 2);
  return status;
}

int engine_read_effects(struct engine_scene *s) {
  lua_State *L = s->L;
  int status = PH_OK;
  if (lua_getfield(L, s->index, "effects") == LUA_TNIL) {
    lua_pop(L, 1);
    return PH_OK;
  }
  const int n = (int)lua_rawlen(L, -1);
  for (int i = 1; i <= n && status == PH_OK; i++) {
    lua_rawgeti(L, -1, i);
    status = read_effect(s);
  }
  lua_pop(L, 1);
  return status;
}

void engine_read_own(lua_State *L, int index, const ph_top *top, double x[]) {
  int n = 0;
  for (int k = 0; k < top->acts.n; k++)
    n += top->acts.list[k].states;
  if (n > 0)
    fields_get(L, index, "own", n, x + ph_top_states(top) - n, NULL);
}
