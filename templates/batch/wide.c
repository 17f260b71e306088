%% -- wide.c -- numbers of several bodies in one: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- the series of ${upper}_WIDE bodies at once ----
 * A ${name}_wide is one number of each of ${upper}_WIDE bodies, and arithmetic on it is that of all of them: GNU C's vectors, which
 * fill the processor's as they fit; elsewhere one body at a time.  The text is that of the series of one body. */
#if defined __GNUC__
enum { ${upper}_WIDE = ${wide} };
typedef ${name}_real ${name}_wide __attribute__((vector_size(${wide}*sizeof(${name}_real))));
#else
enum { ${upper}_WIDE = 1 };
typedef ${name}_real ${name}_wide;
#endif

/* the same, body by body */
typedef union ${name}_bodies {
  ${name}_wide v;
  ${name}_real e[${upper}_WIDE];
} ${name}_bodies;
