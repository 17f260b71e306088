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
  ${name}_real half;                /* there: half a period as a power of two, 2^half; on it ${no_period} */
  ${name}_real last;                /* s; later times are taken for this one, after 2^50 turns (float: 2^46) */
  ${name}_real a[4], b[4], c[4], d[4], f[10], nome, scale[3], s; /* series, see ${name}_circular_terms */
  ${name}_real q[4][4], w[3][3];    /* quaternion and rates are combinations of these */
%% if damped then
  ${name}_real decay;               /* rate of decay of L, 1/s */
%% else
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
/* Prepare the motion through x0 at t = 0, q of x0 normalised: about 6000 operations, a fixed number but for a tensor with
 * products, whose axes take some more.  Phases come to 2^-100 or so of a turn for each (float: 2^-42).  Near the
 * separatrix a tensor without products loses nothing; one with products is turned to its principal axes in pairs, which
 * displaces the state by less than 2^-45 of what a unit of the last place of x0 does (float: 2^-19).  Returns 0, or 1 if
 * q is 0, a number not finite, the body none (a negative moment; no moment about an axis across which two differ), or a
 * rate beyond the range of the type; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

%% if not damped then
/* The state at time t, of either sign: attitude and rates.  The phases are formed and reduced in twice the working
 * precision: errors stay some units of the last place until that is used up, after 2^40 turns (float: 2^20).  Later the
 * state is one of this motion, but nobody knows which. */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);

/* The same bits at n times (if the compiler fuses nothing: -ffp-contract=off), x[i*n + k] component i at t[k]; x apart from
 * t.  Worth vector instructions: with GCC or Clang -O3 -march=native -fno-math-errno. */
void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[]);

/* The rates w[3], rad/s, body axes, or the attitude q[4] alone. */
void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[]);
void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[]);

/* Time in steps of h s.  Phases are integers, which lose nothing however many ticks have passed.  Returns 1 if a step is
 * beyond the range of the type. */
int ${name}_set_tick(${name}_orbit *o, ${name}_real h);
void ${name}_at_tick(const ${name}_orbit *o, int64_t n, ${name}_real x[]);

/* The rates w go round the polhode in polhode_period s: infinite on the separatrix, 0 if w is constant.  The axis about
 * which L goes round in the body goes round L in space at precession_rate, rad/s, on average, once in precession_period s
 * (infinite without rotation).  rotation_number is the quotient of the periods: by so many turns about L is the body
 * further when w has come back (Montgomery's phase, Am. J. Phys. 59, 394, 1991, over 2 pi, counted continuously);
 * infinite on the separatrix, 0 if w is constant.  The rate is right to the type's last place, or to the square of that
 * in units of |w|, whichever is more. */
${name}_real ${name}_polhode_period(const ${name}_orbit *o);
${name}_real ${name}_precession_rate(const ${name}_orbit *o);
${name}_real ${name}_precession_period(const ${name}_orbit *o);
${name}_real ${name}_rotation_number(const ${name}_orbit *o);

/* The first time after t, rounded, at which the component of L (and of w) along the axis of the middle moment changes its
 * sign: near the separatrix the top flips there.  Twice in a period, on the separatrix once, never (infinite) if w is
 * constant.  With two equal moments it is some axis across the third.  Always more than t, so that
 * t = ${name}_next_flip(o, t) lists all flips; where flips follow faster than floating point numbers do, the next number. */
${name}_real ${name}_next_flip(const ${name}_orbit *o, ${name}_real t);
%% end
