/* script.c - where `require` finds the generator: in the program, or in a source tree.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A chunk's name is "@" and its path in the source tree, so messages and tracebacks point at true
 * lines.  The program's own scripts are compiled when it is built (embed.lua); a source tree's are
 * text, and nothing else is ever loaded as bytecode.  There is no search path: a module is
 * "generator." and names, or it does not exist.
 */
#include "script.h"
#include "host.h"

#include <lauxlib.h>
#include <stdlib.h>
#include <string.h>

/* The tree that holds the generator; the host's own sandbox/safe.lua always comes from the
 * program. */
static const char *source_tree(const char *name) {
  if (strncmp(name, "generator/", 10) != 0 && strncmp(name, "templates/", 10) != 0)
    return NULL;
  const char *dir = getenv("POLHODE_SOURCE");
  return dir != NULL && *dir != '\0' ? dir : NULL;
}

static int by_name(const void *name, const void *script) {
  return strcmp(name, ((const struct script *)script)->name);
}

/* One of the program's own; NULL when there is none. */
static const struct script *embedded(const char *name) {
  return bsearch(name, script_embedded, script_count, sizeof script_embedded[0], by_name);
}

/* Push the text of a file of the source tree `dir`; 0 and nothing pushed when there is none. */
static int push_text(lua_State *L, const char *dir, const char *name) {
  const char *path = lua_pushfstring(L, "%s/%s", dir, name);
  const int found = host_read_file(L, path) == 1;
  if (!found)
    lua_pop(L, 1);
  lua_remove(L, found ? -2 : -1);
  return found;
}

/* Push the chunk of the named script; 0 and nothing pushed when there is none. */
static int push_chunk(lua_State *L, const char *name) {
  const char *dir = source_tree(name);
  const int top = lua_gettop(L);
  struct script s = {0};
  if (dir == NULL && embedded(name) != NULL)
    s = *embedded(name);
  else if (dir != NULL && push_text(L, dir, name))
    s.text = lua_tolstring(L, -1, &s.size);
  if (s.text == NULL)
    return 0;
  const char *chunk = lua_pushfstring(L, "@%s", name);
  if (luaL_loadbufferx(L, s.text, s.size, chunk, dir != NULL ? "t" : "b") != LUA_OK)
    lua_error(L);
  lua_insert(L, top + 1);
  lua_settop(L, top + 1);
  return 1;
}

void script_load(lua_State *L, const char *name) {
  if (!push_chunk(L, name))
    luaL_error(L, "no script '%s'", name);
}

/* package.searchers entry: module name -> loader, file name; or a line for require's message. */
static int searcher(lua_State *L) {
  const char *module = luaL_checkstring(L, 1);
  if (strncmp(module, "generator.", 10) != 0) {
    lua_pushfstring(L, "no module outside 'generator.'");
    return 1;
  }
  luaL_gsub(L, module, ".", "/");
  const char *name = lua_pushfstring(L, "%s.lua", lua_tostring(L, -1));
  if (!push_chunk(L, name)) {
    lua_pushfstring(L, "no script '%s'", name);
    return 1;
  }
  lua_pushstring(L, name);
  return 2;
}

void script_open(lua_State *L) {
  lua_getfield(L, -1, "searchers");
  lua_rawgeti(L, -1, 1); /* the one for package.preload stays first */
  lua_createtable(L, 2, 0);
  lua_insert(L, -2);
  lua_rawseti(L, -2, 1);
  lua_pushcfunction(L, searcher);
  lua_rawseti(L, -2, 2);
  lua_setfield(L, -3, "searchers");
  lua_pop(L, 1);
  static const char *const gone[] = {"loadlib", "searchpath", "path", "cpath", "config"};
  for (size_t i = 0; i < sizeof gone / sizeof gone[0]; i++) {
    lua_pushnil(L);
    lua_setfield(L, -2, gone[i]);
  }
}

static int is_template(const char *name) {
  return strncmp(name, "templates/", 10) == 0;
}

/* __index of the table: (t, name) -> text, which from then on is there; nil if there is none. */
static int read_embedded(lua_State *L) {
  const char *name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
  const struct script *s = is_template(name) ? embedded(name) : NULL;
  if (s == NULL)
    return 0;
  lua_pushlstring(L, s->text, s->size);
  lua_pushvalue(L, -1);
  lua_setfield(L, 1, name);
  return 1;
}

static void add_name(lua_State *L, const char *name) {
  lua_pushstring(L, name);
  lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
}

/* From the program itself, a text when it is asked for: few are; the table is on top. */
static void add_embedded(lua_State *L) {
  for (const struct script *s = script_embedded; s->name != NULL; s++)
    if (is_template(s->name))
      add_name(L, s->name);
  lua_createtable(L, 0, 1);
  lua_pushcfunction(L, read_embedded);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
}

/* The files of a folder of the source tree, those of folders in it left out; 0 if there is none.
   The table is on top. */
static int add_folder(lua_State *L, const char *dir, const char *folder) {
  const int top = lua_gettop(L);
  if (host_list_directory(L, lua_pushfstring(L, "%s/%s", dir, folder), "") != 1) {
    lua_settop(L, top);
    return 0;
  }
  const int list = lua_gettop(L);
  for (lua_Integer i = 1; lua_rawgeti(L, list, i) != LUA_TNIL; i++) {
    const char *name = lua_pushfstring(L, "%s/%s", folder, lua_tostring(L, -1));
    lua_pushvalue(L, top);
    if (push_text(L, dir, name)) {
      lua_setfield(L, -2, name);
      add_name(L, name);
    }
    lua_settop(L, list);
  }
  lua_settop(L, top);
  return 1;
}

void script_push_templates(lua_State *L) {
  static const char *const folders[] = {"templates/core",     "templates/estimator",
                                        "templates/numeric",  "templates/orbit",
                                        "templates/steppers", "templates/analysis",
                                        "templates/test",     "templates/host",
                                        "templates/projects", "templates/projects/firmware",
                                        "templates/target",   "templates/batch",
                                        "templates/sweep",    "templates/fit",
                                        "templates/start",    "templates/page"};
  const char *dir = source_tree("templates/");
  lua_newtable(L);
  if (dir == NULL || !add_folder(L, dir, "templates"))
    add_embedded(L); /* also when the tree has none of its own */
  else
    for (size_t i = 0; i < sizeof folders / sizeof folders[0]; i++)
      add_folder(L, dir, folders[i]);
}
