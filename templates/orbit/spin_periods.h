%% -- spin_periods.h -- periods and mean rates of a closed form: part of scene.h.  SPDX-License-Identifier: MIT-0
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
