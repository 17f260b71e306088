/* object.h - a loaded plugin as its parts see it: plugin.c, and what times it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef POLHODE_PLUGIN_OBJECT_H
#define POLHODE_PLUGIN_OBJECT_H

#include "../../../templates/host/plugin.h"
#include "engine/engine.h"

#define PLUGIN_TYPE "polhode.plugin"
/* More than these no plugin has: those that say so are not loaded. */
#define MAX_STATES 64
#define MAX_PARAMS 256

struct plugin {
  void *library, *model, *orbit;
  const struct polhode_plugin *code;
  int ready, solved; /* is the model filled in, the orbit? */
};

/* The plugin at the stack's bottom. */
struct plugin *plugin_self(lua_State *L);
/* The same, its model filled in; raises an error if it is not. */
const struct plugin *plugin_ready(lua_State *L);
/* The stepper called so at index i of the stack, or the scene's own. */
const struct polhode_stepper *plugin_stepper(lua_State *L, const struct plugin *p, int i);
/* n numbers from the list at `index`; none or an empty list is zeros. */
void plugin_optional(lua_State *L, int index, int n, double out[]);
/* How many equal steps no longer than h > 0 lead over a span: a quotient that rounding has lifted
   just above a whole number is that number. */
double plugin_steps(double span, double h);

#endif
