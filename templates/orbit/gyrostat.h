%% -- gyrostat.h -- contract of the asymmetric gyrostat's closed form: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ----
 *
%% for _, line in ipairs(closed_text) do
 * ${line}
%% end
 */
typedef struct ${name}_orbit {
  ${name}_real start[2], rate[2];   /* phase of the rates at t = 0, and per second, as pairs high + low */
  ${name}_real period[2], inverse;  /* its period; on a separatrix, which has none, both are 0 */
  ${name}_real turn[2][2], jump[2][2]; /* of a and b: turns per second, and what goes off with each period of the phase */
  ${name}_real re[2][6], im[2][6], odd[2], nome; /* series of a and b; 1: zero next to the phase 0, 0: next to half a period */
  ${name}_real mean;                /* rad/s, the rate about the angular momentum */
  ${name}_real q[4][4], along[2][3], across[2][3]; /* quaternion and rates are combinations of these */
  ${name}_real tick;                /* s; the rest is set by ${name}_set_tick: fractions of two periods, of turns of a and b */
  struct {
    uint64_t start[2], tick[2];
  } counts[3];
  int hyperbolic;                   /* near a separatrix: 1 on its side of two bands, 2 on that of one */
} ${name}_orbit;

/* Prepare the motion through x0 at t = 0, q of x0 normalised.  Returns 0, or 1 if q is 0, a number not finite, a moment
 * not positive, or a rate beyond the range of the type; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

/* The state at time t, of either sign: attitude and rates.  The phases are formed and reduced in twice the working
 * precision: errors stay some units of the last place until that is used up, after 2^40 turns (float: 2^20). */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);

/* The rates w[3], rad/s, body axes, or the attitude q[4] alone. */
void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[]);
void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[]);

/* n states at the times t[n]: x[i*n + k] is component i at t[k].  x must not overlap t.  Rounded as
 * ${name}_at is, or within a unit of the last place where the compiler fuses. */
void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[]);

/* Time in steps of h s.  Phases are integers, which lose nothing however many ticks have passed.  Returns 1 if a step is
 * beyond the range of the type. */
int ${name}_set_tick(${name}_orbit *o, ${name}_real h);
void ${name}_at_tick(const ${name}_orbit *o, int64_t n, ${name}_real x[]);

/* Period of the rates, s: infinite on a separatrix; 0 if they rest; that of small oscillations about a permanent rotation.
 * The mean rate at which the rotor's axis goes round the angular momentum, rad/s. */
${name}_real ${name}_polhode_period(const ${name}_orbit *o);
${name}_real ${name}_precession_rate(const ${name}_orbit *o);
