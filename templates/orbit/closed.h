%% -- closed.h -- what it stores, and its set-up: part of scene.h.  SPDX-License-Identifier: MIT-0
typedef struct ${name}_orbit {
  ${name}_real q[4][4];               /* q0, l q0, q0 k, l q0 k: the quaternions that q(t) is a combination of */
  ${name}_real about[4];              /* |L|/(2 I1), half the rate about L, turns/s: high, low, and high in halves */
%% if symmetric then
  ${name}_real spin[4];               /* half the rate about k, likewise */
%% end
  ${name}_real along[3], across[3], turned[3]; /* w = along + cos(a) across + sin(a) turned, a the spin angle */
  ${name}_real mean;                  /* rate about L, rad/s */
  ${name}_real last;                  /* s; later times are taken for this one, after 2^50 turns (float: 2^46) */
%% if damped then
  ${name}_real decay;                 /* rate of decay of L, 1/s */
%% elseif flies then
  ${name}_real r[3], v[3], g[3];      /* centre of mass at t = 0, its velocity, and its acceleration */
%% elseif has_tick_fields then
  uint64_t about_tick[2];             /* set by ${name}_set_tick: the same for a tick, units of 2^-128 of a turn */
%% if symmetric then
  uint64_t spin_tick[2];
%% end
%% end
} ${name}_orbit;

/* Prepare the motion through x0 at t = 0.  q of x0 is normalised.  Returns 0, or 1 if q is 0, a number is not
 * finite or a rate beyond the range of the type; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);
