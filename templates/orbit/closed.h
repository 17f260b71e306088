%% -- closed.h -- its contract: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ----
 *
%% for _, line in ipairs(closed_text) do
 * ${line}
%% end
 */
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
%% else
  uint64_t about_tick[2];             /* set by ${name}_set_tick: the same for a tick, units of 2^-128 of a turn */
%% if symmetric then
  uint64_t spin_tick[2];
%% end
%% end
} ${name}_orbit;

/* Prepare the motion through x0 at t = 0.  q of x0 is normalised.  Returns 0, or 1 if q is 0, a number is not
 * finite or a rate beyond the range of the type; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

%% if not damped then
/* The state at time t, of either sign: attitude and rates.  The phases are formed and reduced in twice the working
 * precision: errors stay some units of the last place until that is used up, after 2^40 turns (float: 2^20).  Later the
 * state is one of this motion, but nobody knows which. */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);

/* The rates w[3], rad/s, body axes, or the attitude q[4] alone. */
void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[]);
void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[]);

/* The states at n times, component i at t[k] in x[i*n + k]; t and x must not overlap.  A plain loop, which compilers
 * vectorise at -O3. */
void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[]);

/* Time in steps of h s.  Phases are integers, which lose nothing however many ticks have passed; before the first call
 * every tick is t = 0.  Returns 1 if a step is beyond the range of the type. */
int ${name}_set_tick(${name}_orbit *o, ${name}_real h);
void ${name}_at_tick(const ${name}_orbit *o, int64_t n, ${name}_real x[]);

/* The rates w go round the polhode in polhode_period s, 0 if w is constant.  The body's axis goes round L in space at
 * precession_rate, rad/s, once in precession_period s (infinite without); if w is constant, it is the rate of the body
 * about L.  rotation_number is the quotient of the periods: by so many turns about L is the body further when w has come
 * back; 0 if w is constant. */
${name}_real ${name}_polhode_period(const ${name}_orbit *o);
${name}_real ${name}_precession_rate(const ${name}_orbit *o);
${name}_real ${name}_precession_period(const ${name}_orbit *o);
${name}_real ${name}_rotation_number(const ${name}_orbit *o);

/* The time of the first flip after t: a symmetric top has no middle moment and never flips, so infinite. */
${name}_real ${name}_next_flip(const ${name}_orbit *o, ${name}_real t);
%% end
