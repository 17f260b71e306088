/* engine.h - the general library seen from Lua: what the engine_*.c files share.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A scene arrives as plain tables of numbers, every parameter and default filled in:
 * - scene {name=, body=tree, origin={x,y,z}, effects={...}, q={w,x,y,z}, w={x,y,z},
 *   r={x,y,z}, v={x,y,z}, own={...}}, r and v where the body moves, own the effects' own states
 * - tree {shape="solid.box", mass= or density=, x=, y=, z=} and so on, arguments as the library
 *   names them, those that are points, outlines or polynomials as shape.c says
 * - tree {op="at", of=tree, r={3}} {op="turned", of=tree, q={4}} {op="scaled", of=tree, k={3}}
 *   {op="affine", of=tree, A={9}} {op="sum", tree, tree, ...} {op="minus", tree, hole}
 * - effect {kind="gravity", g=, direction={3}} and so on: kind is its name in Lua, and its fields
 * are those that src/runtime/effects/NAME.c lists
 * - varying: a number, {rows={t, v, ...}} or {code=program}; program: dynamics/postfix.lua's list
 * - inputs: how many the scene has, those of "control" first; over time: host/course.h
 *
 * Tables of the wrong form are a bug of the caller and raise; numbers that no body can have are the
 * library's to refuse, and come back as nil and a message that names the shape.
 */
#ifndef POLHODE_ENGINE_H
#define POLHODE_ENGINE_H

#include <stdint.h>

#include "effects/effect.h"
#include "polhode.h"
#include "host/course.h"
#include "host/fields.h"
#include "host/host.h"

/* Where the library refused: the shape, operation or effect. The text lives in the scene's
 * table. */
struct engine_scene {
  lua_State *L;
  int index; /* of the scene's table on the stack */
  const char *where;
  ph_body body;
  ph_top top;
  int inputs;
  struct course_segment *input; /* what programs read; lives as long as the scene's table */
};

/* Read body, origin and effects of the scene table at `index`: PH_OK or the library's status. */
int engine_read(struct engine_scene *s, lua_State *L, int index);
/* The tree at the stack's top, which is popped. */
int engine_read_body(struct engine_scene *s, ph_body *out);
/* The shape of that name from the table at the stack's top, which stays. */
int engine_read_shape(struct engine_scene *s, const char *name, ph_body *out);
/* Push nil and "solid.box: lengths and scale factors must be positive"; returns 2. */
int engine_fail(const struct engine_scene *s, int status);

/* The effects of the scene, into its top: PH_OK or the library's status. */
int engine_read_effects(struct engine_scene *s);
/* The initial values of the acts' own states, from the field "own" of the table at `index`. */
void engine_read_own(lua_State *L, int index, const ph_top *top, double x[]);
/* The program at the stack's top, which is popped. */
void engine_read_program(struct engine_scene *s, ph_varying *out);
/* Keeps the object at the stack's top, which is popped, as long as the scene's table. */
void engine_keep(struct engine_scene *s);
/* ph_varying.f of a program, and the size of its largest terms; x: n states. */
long double engine_program_value(void *program, long double t, const long double x[]);
/* ph_support.jet of a program of three variables: value, gradient, second derivatives. */
void engine_program_jet(void *program, const long double n[3], long double out[10]);
double engine_program_size(const ph_varying *v, double t, const double x[], int n);
/* Lua aligns its blocks for a double, a long double may want more: a userdata is made larger by
   this much, and what is kept there begins where engine_aligned says. */
enum { ENGINE_ALIGNMENT = 16 };
static inline void *engine_aligned(void *block) {
  return (char *)block + (ENGINE_ALIGNMENT - (uintptr_t)block % ENGINE_ALIGNMENT);
}

#endif
