/* xml.c - XML text as a tree of Lua tables, by libexpat.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *   xml(text) -> element | nil, message, line
 * An element is {name=, line=, at={[attribute]=value, [1..n]=attribute names in order}, text=,
 * [1..n]=child elements}.  text is the element's own character data, joined; comments and
 * processing instructions are left out; names keep their prefix ("gazebo:sensor").
 *
 * Someone may have sent the text: a document type is refused, so there are no entities to expand
 * beside the five of XML itself, and size, depth and the number of elements are bounded.
 *
 * Law: no Lua error crosses a frame of expat.  What a handler does in Lua runs under lua_pcall; an
 * error stops the parser and is raised again when the parser has been freed.
 */
#include "host.h"

#include <expat.h>
#include <limits.h>
#include <string.h>

#define MAX_BYTES    ((size_t)16 << 20)
#define MAX_DEPTH    200
#define MAX_ELEMENTS 200000

_Static_assert(MAX_BYTES <= INT_MAX, "one call of XML_Parse takes an int");

struct reading {
  lua_State *L;
  XML_Parser parser;
  int open;         /* stack index of the list of open elements, the document first */
  int depth;        /* of the innermost open element; the document has 0 */
  int elements;     /* so far */
  int raised;       /* a Lua error is on the stack's top */
  const char *rule; /* why the text is refused, or NULL */
};

/* What one handler hands to its Lua part. */
struct event {
  const char *name;
  const XML_Char **attributes;
  const char *text;
  size_t length;
  int line, depth;
};

/* Lua: (open, event).  A new element, the last child of the innermost open one. */
static int start_in_lua(lua_State *L) {
  const struct event *e = lua_touserdata(L, 2);
  lua_createtable(L, 0, 4);
  lua_pushstring(L, e->name);
  lua_setfield(L, -2, "name");
  lua_pushinteger(L, e->line);
  lua_setfield(L, -2, "line");
  lua_newtable(L);
  for (int i = 0; e->attributes[2 * i] != NULL; i++) {
    lua_pushstring(L, e->attributes[2 * i + 1]);
    lua_setfield(L, -2, e->attributes[2 * i]);
    lua_pushstring(L, e->attributes[2 * i]);
    lua_rawseti(L, -2, i + 1);
  }
  lua_setfield(L, -2, "at");
  lua_newtable(L); /* pieces of text until the element ends */
  lua_setfield(L, -2, "text");
  lua_rawgeti(L, 1, e->depth);
  lua_pushvalue(L, 3);
  lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
  lua_settop(L, 3);
  lua_rawseti(L, 1, e->depth + 1);
  return 0;
}

/* Lua: (open, event).  The pieces of text become one. */
static int end_in_lua(lua_State *L) {
  const struct event *e = lua_touserdata(L, 2);
  lua_rawgeti(L, 1, e->depth);
  lua_getfield(L, 3, "text");
  luaL_Buffer all;
  luaL_buffinit(L, &all);
  const lua_Integer n = (lua_Integer)lua_rawlen(L, 4);
  for (lua_Integer i = 1; i <= n; i++) {
    lua_rawgeti(L, 4, i);
    luaL_addvalue(&all);
  }
  luaL_pushresult(&all);
  lua_setfield(L, 3, "text");
  return 0;
}

/* Lua: (open, event). */
static int text_in_lua(lua_State *L) {
  const struct event *e = lua_touserdata(L, 2);
  lua_rawgeti(L, 1, e->depth);
  lua_getfield(L, 3, "text");
  lua_pushlstring(L, e->text, e->length);
  lua_rawseti(L, 4, (lua_Integer)lua_rawlen(L, 4) + 1);
  return 0;
}

/* Nothing here allocates before the protected call. */
static void in_lua(struct reading *r, lua_CFunction f, struct event *e) {
  lua_State *L = r->L;
  lua_pushcfunction(L, f);
  lua_pushvalue(L, r->open);
  lua_pushlightuserdata(L, e);
  if (lua_pcall(L, 2, 0, 0) != LUA_OK) {
    r->raised = 1;
    XML_StopParser(r->parser, XML_FALSE);
  }
}

static void refuse(struct reading *r, const char *rule) {
  r->rule = rule;
  XML_StopParser(r->parser, XML_FALSE);
}

/* Has the parser been stopped?  Expat may still call a handler or two. */
static int stopped(const struct reading *r) {
  return r->raised || r->rule != NULL;
}

static void XMLCALL on_start(void *data, const XML_Char *name, const XML_Char **attributes) {
  struct reading *r = data;
  if (stopped(r))
    return;
  if (r->depth >= MAX_DEPTH) {
    refuse(r, "elements are nested more than 200 deep");
    return;
  }
  if (++r->elements > MAX_ELEMENTS) {
    refuse(r, "there are more than 200000 elements");
    return;
  }
  struct event e = {.name = name,
                    .attributes = attributes,
                    .line = (int)XML_GetCurrentLineNumber(r->parser),
                    .depth = r->depth};
  in_lua(r, start_in_lua, &e);
  r->depth++;
}

static void XMLCALL on_end(void *data, const XML_Char *name) {
  struct reading *r = data;
  (void)name;
  if (stopped(r))
    return;
  struct event e = {.depth = r->depth};
  in_lua(r, end_in_lua, &e);
  r->depth--;
}

static void XMLCALL on_text(void *data, const XML_Char *text, int length) {
  struct reading *r = data;
  if (stopped(r))
    return;
  struct event e = {.text = text, .length = (size_t)length, .depth = r->depth};
  in_lua(r, text_in_lua, &e);
}

static void XMLCALL on_doctype(void *data, const XML_Char *name, const XML_Char *system,
                               const XML_Char *public, int internal) {
  struct reading *r = data;
  (void)name, (void)system, (void)public, (void)internal;
  if (!stopped(r))
    refuse(r, "a document type declaration is not allowed");
}

static int fail(lua_State *L, const char *message, lua_Integer line) {
  lua_pushnil(L);
  lua_pushstring(L, message);
  lua_pushinteger(L, line);
  return 3;
}

int host_xml(lua_State *L) {
  size_t size = 0;
  const char *text = luaL_checklstring(L, 1, &size);
  if (size > MAX_BYTES)
    return fail(L, "the text is larger than 16 MiB", 1);
  luaL_checkstack(L, 10, "xml");
  lua_settop(L, 1);
  lua_newtable(L);
  lua_newtable(L);
  lua_rawseti(L, 2, 0); /* the document */
  struct reading r = {.L = L, .open = 2};
  r.parser = XML_ParserCreate(NULL); /* from here to XML_ParserFree nothing may raise */
  if (r.parser == NULL)
    return luaL_error(L, "not enough memory");
  XML_SetUserData(r.parser, &r);
  XML_SetElementHandler(r.parser, on_start, on_end);
  XML_SetCharacterDataHandler(r.parser, on_text);
  XML_SetStartDoctypeDeclHandler(r.parser, on_doctype);
  const enum XML_Status status = XML_Parse(r.parser, text, (int)size, XML_TRUE);
  const lua_Integer line = (lua_Integer)XML_GetCurrentLineNumber(r.parser);
  const char *message = r.rule;
  if (message == NULL && status != XML_STATUS_OK)
    message = XML_ErrorString(XML_GetErrorCode(r.parser));
  XML_ParserFree(r.parser);
  if (r.raised)
    return lua_error(L);
  if (message != NULL)
    return fail(L, message, line);
  lua_rawgeti(L, 2, 1); /* the root */
  return 1;
}
