%% -- gyrostat_periods.h -- periods and mean rates of a closed form: part of scene.h.  SPDX-License-Identifier: MIT-0
/* Period of the rates, s: infinite on a separatrix; 0 if they rest; that of small oscillations about a permanent rotation.
 * The mean rate at which the rotor's axis goes round the angular momentum, rad/s. */
${name}_real ${name}_polhode_period(const ${name}_orbit *o);
${name}_real ${name}_precession_rate(const ${name}_orbit *o);
