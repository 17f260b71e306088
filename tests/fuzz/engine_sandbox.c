/* engine_sandbox.c - the program's sandbox, with its clock and hook made fit for many runs.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * libFuzzer keeps SIGALRM and the real timer for itself, so the sandbox gets the virtual one; its
 * last resort, _exit, becomes a finding: it says that a C function could be stuck; and its hook
 * shares Lua's one place for hooks with the counter of lines.
 */
#include <lauxlib.h>
#include <lua.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/time.h>
#include <unistd.h>

void fuzz_sethook(lua_State *L, lua_Hook hook, int mask, int count);

#undef SIGALRM
#define SIGALRM SIGVTALRM
#undef ITIMER_REAL
#define ITIMER_REAL             ITIMER_VIRTUAL
#define _exit(status)           abort()
#define lua_sethook(L, h, m, c) fuzz_sethook(L, h, m, c)

#include "../../src/cli/sandbox.c" /* NOLINT */
