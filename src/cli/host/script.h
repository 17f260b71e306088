/* script.h - the generator's scripts and the templates, as text inside the program.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * With POLHODE_SOURCE=DIR in the environment they are read from that source tree instead, under the
 * same names, which is how one works on them.
 */
#ifndef POLHODE_SCRIPT_H
#define POLHODE_SCRIPT_H

#include <lua.h>
#include <stddef.h>

/* The name is the path in the source tree: "generator/algebra/expr.lua". */
struct script {
  const char *name, *text;
  size_t size;
};
/* In the order of their names; a NULL name follows the last. */
extern const struct script script_embedded[];
extern const size_t script_count;

/* Make `require "generator.x.y"` find generator/x/y.lua and nothing else; package is on the stack's
 * top. */
void script_open(lua_State *L);

/* Push the chunk of the named script; raises its syntax error, or one that says it is not there. */
void script_load(lua_State *L, const char *name);

/* Push {[name] = text, [1..n] = names in order} of everything below templates/. */
void script_push_templates(lua_State *L);

#endif
