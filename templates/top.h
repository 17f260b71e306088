%% -- top.h -- its contract: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ----
 *
%% for _, line in ipairs(closed_text) do
 * ${line}
%% end
 */
typedef struct ${name}_orbit {
  ${name}_real start[2], rate[4];   /* phase of the rates at t = 0, and per second, in their periods: high, low, halves of high */
  ${name}_real turn[4], jump;       /* turns about L per second; how far it runs ahead in half a period, near the separatrix */
  ${name}_real half, whole;         /* there: half a period in the functions' unit; on it 1 and 0: none, phases are unbounded */
  ${name}_real a[4], b[4], c[4], d[4], f[10], nome, scale[3], s; /* series, see ${name}_circular_terms */
  ${name}_real q[4][4], w[3][3];    /* quaternion and rates are combinations of these */
%% if damped then
  ${name}_real decay;               /* rate of decay of L, 1/s */
%% else
  ${name}_real tick;                /* s; the rest is set by ${name}_set_tick: fractions of two periods, of a turn */
  uint64_t rate_tick[2], rate_start[2], turn_tick[2], turn_start[2];
%% end
  int hyperbolic;                   /* near the separatrix */
} ${name}_orbit;

/* Prepare the motion through x0 at t = 0, q of x0 normalised: about 5000 operations.  Returns 0, or 1 if q is 0, a number
 * not finite, the body none (a negative moment; no moment about an axis across which two differ), or a rate beyond the
 * range of the type; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

%% if not damped then
/* The state at time t, of either sign: attitude and rates.  The phases are formed and reduced in twice the working
 * precision: errors stay some units of the last place until that is used up, after 2^40 turns (float: 2^20). */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);

/* The rates w[3], rad/s, body axes, or the attitude q[4] alone. */
void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[]);
void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[]);

/* Time in steps of h s.  Phases are integers, which lose nothing however many ticks have passed.  Returns 1 if a step is
 * beyond the range of the type. */
int ${name}_set_tick(${name}_orbit *o, ${name}_real h);
void ${name}_at_tick(const ${name}_orbit *o, int64_t n, ${name}_real x[]);

/* Period of the rates, s (infinite on the separatrix; 0 if they are constant), and the mean rate about L, rad/s. */
${name}_real ${name}_polhode_period(const ${name}_orbit *o);
${name}_real ${name}_precession_rate(const ${name}_orbit *o);
%% end
