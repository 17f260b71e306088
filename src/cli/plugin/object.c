/* object.c - a loaded plugin as an argument of Lua's, and what its methods and what times it share.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "object.h"

#include <math.h>
#include <string.h>

struct plugin *plugin_self(lua_State *L) {
  return luaL_checkudata(L, 1, PLUGIN_TYPE);
}

const struct plugin *plugin_ready(lua_State *L) {
  const struct plugin *p = plugin_self(L);
  if (!p->ready)
    luaL_error(L, "plugin: init first");
  return p;
}

const struct polhode_stepper *plugin_stepper(lua_State *L, const struct plugin *p, int i) {
  const char *name = luaL_optstring(L, i, NULL);
  const struct polhode_stepper *s = p->code->steppers;
  if (s == NULL)
    luaL_error(L, "plugin: there is no stepper in it");
  while (name != NULL && s->name != NULL && strcmp(s->name, name) != 0)
    s++;
  if (s->name == NULL)
    luaL_error(L, "plugin: there is no stepper %s in it", name != NULL ? name : "at all");
  return s;
}

double plugin_steps(double span, double h) {
  return ceil(fabs(span) / h * (1 - 1e-12));
}
