/* hook.h - put before every file of src/cli when the program is built to be covered.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The program sets hooks of its own (bounds of scenes, interrupts) and takes them away again; the
 * hook that sees lines must outlive that.  So its calls come here, and src/cli itself is unchanged.
 */
#ifndef POLHODE_COVERAGE_HOOK_H
#define POLHODE_COVERAGE_HOOK_H

#include <lua.h>

lua_State *coverage_state(lua_State *L);
void coverage_sethook(lua_State *L, lua_Hook hook, int mask, int count);

#ifndef POLHODE_COVERAGE_ITSELF
#define lua_newstate(allocate, data) coverage_state(lua_newstate(allocate, data))
#define lua_sethook                  coverage_sethook
#endif

#endif
