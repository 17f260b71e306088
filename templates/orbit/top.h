%% -- top.h -- what it stores, and its set-up: part of scene.h.  SPDX-License-Identifier: MIT-0
typedef struct ${name}_orbit {
  ${name}_real start[2], rate[4];   /* phase of the rates at t = 0, and per second, in their periods: high, low, halves of high */
  ${name}_real turn[4], jump;       /* turns about L per second; how far it runs ahead in half a period, near the separatrix */
  ${name}_real half;                /* there: half a period as a power of two, 2^half; on it ${no_period} */
  ${name}_real last;                /* s; later times are taken for this one, after 2^50 turns (float: 2^46) */
  ${name}_real a[4], b[4], c[4], d[4], f[10], nome, scale[3], s; /* series, see circular_terms in the source */
  ${name}_real q[4][4], w[3][3];    /* quaternion and rates are combinations of these */
%% if damped then
  ${name}_real decay;               /* rate of decay of L, 1/s */
%% elseif flies then
  ${name}_real r[3], v[3], g[3];    /* centre of mass at t = 0, its velocity, and its acceleration */
%% elseif has_tick_fields then
  ${name}_real tick;                /* s; the rest is set by ${name}_set_tick: fractions of two periods, of a turn */
  uint64_t rate_tick[2], rate_start[2], turn_tick[2], turn_start[2];
%% end
  int hyperbolic;                   /* 1 near the separatrix, 2 nearest to it */
} ${name}_orbit;

%% if has_own then
/* The motion through the scene's own initial state, as ${name}_solve gives it, but computed with many digits when this
 * file was made; ticks are of ${step_text} s, the scene's step. */
extern const ${name}_orbit ${name}_own_orbit;

%% end
%% if diagonal then
/* Prepare the motion through x0 at t = 0, q of x0 normalised: about 6000 operations, a fixed number.  Phases come to
 * 2^-100 or so of a turn for each (float: 2^-42), near the separatrix too.  Returns 0, or 1 if q is 0, a number not finite,
%% if has_rod then
 * the body none (a negative moment; no moment about an axis across which two differ), or a rate beyond the range of the
%% else
 * a moment so small that it has become 0, or a rate beyond the range of the
%% end
 * type; *o is untouched then. */
%% else
/* Prepare the motion through x0 at t = 0, q of x0 normalised: about 6000 operations, a fixed number but for a tensor with
 * products, whose axes take some more.  Phases come to 2^-100 or so of a turn for each (float: 2^-42).  Near the
 * separatrix a tensor without products loses nothing; one with products is turned to its principal axes in pairs, which
 * displaces the state by less than 2^-45 of what a unit of the last place of x0 does (float: 2^-19).  Returns 0, or 1 if
 * q is 0, a number not finite, the body none (a negative moment; no moment about an axis across which two differ), or a
 * rate beyond the range of the type; *o is untouched then. */
%% end
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);
