%% -- damped.h -- the contract of a damped motion in closed form: part of scene.h.  SPDX-License-Identifier: MIT-0
/* The state at any finite time t, of either sign: attitude and rates.  The time (1 - exp(-rate t))/rate of the free motion
 * is formed in twice the working precision, so that no error grows with the number of turns.  It is cut at o->last: beyond
 * that the phase is not known, and the attitude is that of o->last.  Long after the rates have faded the attitude stays at
 * its limit, and the rates are 0.  Rates beyond the range of the type are infinite, each with its sign, and the attitude is
 * finite nevertheless.  There are no ticks: equal steps of t are no equal phases. */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);

/* The rates w[3], rad/s, body axes, or the attitude q[4] alone; it costs the same. */
void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[]);
void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[]);

/* The states at n times, component i at t[k] in x[i*n + k]; t and x must not overlap. */
void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[]);
