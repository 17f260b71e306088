%% -- state.h -- the state at a time, of forms that count ticks: part of scene.h.  SPDX-License-Identifier: MIT-0
/* The state at time t, of either sign: attitude and rates.  Errors are at most ${orbit_bound}, of a rate over the largest
%% if orbit_worst then
 * one, of the attitude as an angle (rad); a search of ${orbit_searched} states found ${orbit_worst}.  Phases are formed and reduced in
%% else
 * one${orbit_pace}, of the attitude as an angle (rad).  Phases are formed and reduced in
%% end
 * twice the working precision, which is used up after ${orbit_turns} turns: later the state is one of this motion, but nobody
 * knows which. */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);

/* The rates w[3], rad/s, body axes, or the attitude q[4] alone, as right as ${name}_at. */
void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[]);
void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[]);

/* The states at n times, x[i*n + k] component i at t[k]; x must not overlap t.  The same bits as ${name}_at gives, if the
 * compiler fuses nothing (-ffp-contract=off).${many_note} */
void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[]);

/* Time in steps of h s.  Phases are integers, which lose nothing however many ticks have passed.  Returns 0, or 1 if a step
 * is beyond the range of the type. */
int ${name}_set_tick(${name}_orbit *o, ${name}_real h);

/* The state after n ticks, as right as ${name}_at at any n; needs ${name}_set_tick before it. */
void ${name}_at_tick(const ${name}_orbit *o, int64_t n, ${name}_real x[]);
