%% -- nutation.h -- periods and mean rates of a closed form: part of scene.h.  SPDX-License-Identifier: MIT-0
/* Period of the nutation, s: infinite on the separatrix; 0 if the axis rests; that of small nutation about a steady
 * precession.  The mean rate at which the axis goes round the vertical, rad/s: a passage through the vertical counts for
 * nothing.  Smallest and largest angle between the upward vertical and the direction from the fixed point to the centre
 * of mass (the symmetry axis if they coincide), rad. */
${name}_real ${name}_nutation_period(const ${name}_orbit *o);
${name}_real ${name}_precession_rate(const ${name}_orbit *o);
void ${name}_nutation_range(const ${name}_orbit *o, ${name}_real tilt[2]);
