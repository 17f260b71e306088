/* host.c - the table `host`: everything that the generator can do to the world outside it.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Beside the functions of host.h it holds
 *     version    "0.1.0"
 *     build      "0.1.0+1a2b3c4", with the commit that it was built from; the version alone outside
 *                git
 *     templates  {["templates/body.h"] = text, ..., [1..n] = those names in order}
 *     safe       {assert =, ..., math = {...}, string = {...}, table = {...}}: all that a scene
 *                may be given
 */
#include "host.h"
#include "script.h"
#include "version.h"

static const luaL_Reg functions[] = {
    {"read", host_read},
    {"bodies", host_bodies},
    {"within", host_within},
    {"sha256", host_sha256},
    {"list_dir", host_list_dir},
    {"csv", host_csv},
    {"course", host_course},
    {"write_files", host_write_files},
    {"write_file", host_write_file},
    {"tempdir", host_tempdir},
    {"cache_read", host_cache_read},
    {"cache_write", host_cache_write},
    {"fingerprint", host_fingerprint},
    {"out", host_out},
    {"err", host_err},
    {"isatty", host_isatty},
    {"coloured", host_coloured},
    {"execute", host_execute},
    {"compile", host_compile},
    {"hand_over", host_hand_over},
    {"clock", host_clock},
    {"visible", sandbox_visible},
    {"mass", host_mass},
    {"run", host_run},
    {"rates", host_rates},
    {"xml", host_xml},
    {"plugin", host_plugin},
    {"mesh", host_mesh},
    {"bounded", host_bounded},
    {"processors", host_processors},
    {"baseline", host_baseline},
    {"peers", host_peers},
    {"compile_many", host_compile_many},
    {"fit", host_fit},
    {"design", host_design},
    {"odd", host_odd},
    {"tail", host_tail},
    {NULL, NULL},
};

void host_push(lua_State *L) {
  luaL_newlib(L, functions);
  lua_pushliteral(L, POLHODE_VERSION);
  lua_setfield(L, -2, "version");
  lua_pushliteral(L, POLHODE_BUILD);
  lua_setfield(L, -2, "build");
  script_push_templates(L);
  lua_setfield(L, -2, "templates");
  script_load(L, "src/cli/sandbox/safe.lua");
  lua_pushcfunction(L, sandbox_visible);
  lua_call(L, 1, 1);
  lua_pushvalue(L, -1);
  lua_pushcclosure(L, host_sandbox, 1);
  lua_setfield(L, -3, "sandbox");
  lua_setfield(L, -2, "safe");
}
