/* fields.h - a Lua table that asks for something: its fields as numbers, truths and lists.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * `index` is the table's, `key` the field's. A value of another type is a bug of the caller: it
 * raises an error that names the field.
 */
#ifndef POLHODE_FIELDS_H
#define POLHODE_FIELDS_H

#include <lua.h>

int fields_has(lua_State *L, int index, const char *key);
double fields_number(lua_State *L, int index, const char *key);
/* The same, or `standard` where there is none. */
double fields_option(lua_State *L, int index, const char *key, double standard);
/* The same, of numbers that are more than 0 and finite; standard = 0: there must be one. */
double fields_positive(lua_State *L, int index, const char *key, double standard);
/* Absent is false. */
int fields_flag(lua_State *L, int index, const char *key);
/* n numbers, or `standard` where there are none (NULL: there must be). */
void fields_get(lua_State *L, int index, const char *key, int n, double out[],
                const double standard[]);
/* A list of at most `most` numbers: how many; absent is an empty one. */
int fields_some(lua_State *L, int index, const char *key, double out[], int most);
/* n numbers of the list at `index` itself. */
void fields_list(lua_State *L, int index, int n, double out[]);
/* The same; without a list, or with an empty one, zeros. */
void fields_optional(lua_State *L, int index, int n, double out[]);

/* Push {v[0], ..., v[n-1]}. */
void fields_push(lua_State *L, int n, const double v[]);
/* Into the table on the top. */
void fields_set_number(lua_State *L, const char *key, double x);
void fields_set_count(lua_State *L, const char *key, lua_Integer n);
void fields_set_flag(lua_State *L, const char *key, int yes);
void fields_set_list(lua_State *L, const char *key, const double v[], int n);

#endif
