%% -- flight.h -- the contract of a flight in closed form: part of scene.h.  SPDX-License-Identifier: MIT-0
/* The state at any finite time t, of either sign.  Attitude and rates are those of the free body: their errors are at most
 * ${orbit_bound}, of a rate over the largest one, of the attitude as an angle (rad), until ${orbit_turns} turns have used up
 * twice the working precision.  Position and velocity take three roundings of their largest terms.  There are no ticks: a
 * place does not come back. */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);

/* The rates w[3], rad/s, body axes, or the attitude q[4] alone. */
void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[]);
void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[]);

/* The states at n times, component i at t[k] in x[i*n + k]; t and x must not overlap. */
void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[]);
