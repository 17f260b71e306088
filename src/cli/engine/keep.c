/* keep.c - what lives as long as the scene's table, and what a refusal says.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "engine.h"

int engine_fail(const struct engine_scene *s, int status) {
  lua_pushnil(s->L);
  lua_pushfstring(s->L, "%s: %s", s->where, ph_status_phrase(status));
  return 2;
}

void engine_keep(struct engine_scene *s) {
  lua_State *L = s->L;
  if (lua_getfield(L, s->index, "memory") == LUA_TNIL) {
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_setfield(L, s->index, "memory");
  }
  lua_insert(L, -2);
  lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
  lua_pop(L, 1);
}
