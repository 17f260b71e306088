%% -- disc.h -- what can be asked of a rolling disc: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- the rolling disc: tilts, integrals, swing ---- */

/* The two linear integrals of the motion (Appell, Korteweg 1899), rad/s: the rate w about the axis and a = phi' sin theta
 * of the solution through x where the disc is upright, theta = 90 deg. They keep their values in any motion of the disc.
 * Returns 0, or 1 if the disc lies flat or a number is not finite; C is untouched then. Error up to ${bound} of
 * |C[0]| + |C[1]|. */
int ${name}_disc_integrals(const ${name}_model *m, const ${name}_real x[], ${name}_real C[2]);

/* w and a, rad/s, at the tilt theta of every motion with these integrals. Returns 0, or 1 if theta is not between 0 and
 * pi; rates is untouched then. */
int ${name}_disc_rates(const ${name}_model *m, const ${name}_real C[2], ${name}_real theta, ${name}_real rates[2]);

/* The swing of the tilt through x: its least and its greatest value, rad; the period between two least ones, s; the turn
 * of the contact point about the plane's normal in it, rad (also that of the precession phi). Nearly flat falls have turns
 * near ${pi} sqrt(1 + m R^2/(I1 + m rho^2)). A steady roll has the limits of small swings.
 * The energy's (I1 + m (R^2 + 2 R rho sin theta + rho^2)) theta'^2/2 = W(theta) decides, so it must roll, with N > 0.
 * Returns 0; 2 if the period is infinite, and then it and the turn are 0; 1 if x lies flat, a number is not finite, or
 * nothing turns it back before it falls flat, and then swing is untouched. Each is good to ${bound} of itself, the turn of
 * itself and 1 rad, the tilts of a swing that is no difference of roundings. */
int ${name}_disc_swing(const ${name}_model *m, const ${name}_real x[], ${name}_real swing[4]);
