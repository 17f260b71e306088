%% -- top_periods.h -- periods and mean rates of a closed form: part of scene.h.  SPDX-License-Identifier: MIT-0
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
