/* engine_sandbox.c - the bounds of the sandbox, with their clock and hook made fit for many runs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * libFuzzer may keep SIGPROF and its timer for itself, so the sandbox gets the virtual one; its
 * last resort, _exit, becomes a finding: it says that a C function could be stuck; and its hook
 * shares Lua's one place for hooks with the counter of lines.
 */
#include <lauxlib.h>
#include <lua.h>
#include <signal.h>
#include <math.h>
#include <stdlib.h>
#include <sys/time.h>
#include <unistd.h>

void fuzz_sethook(lua_State *L, lua_Hook hook, int mask, int count);

#undef SIGPROF
#define SIGPROF SIGVTALRM
#undef ITIMER_PROF
#define ITIMER_PROF             ITIMER_VIRTUAL
#define _exit(status)           abort()
#define lua_sethook(L, h, m, c) fuzz_sethook(L, h, m, c)

#include "../../src/cli/sandbox/bounds.c" /* NOLINT */
