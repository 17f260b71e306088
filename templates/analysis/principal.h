%% -- principal.h -- principal axes, their contract: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- principal axes ---- */

/* Moments, ascending, and axes of any symmetric tensor I = xx yy zz xy xz yz (entries of the tensor: no sign is
 * turned).  axes[3*k .. 3*k+2] is the unit vector of moments[k]; the three are right-handed.  In the first two axes
 * the first component within 1/16 of the largest is positive.  Equal moments stay in the order of the coordinate axes,
 * and a diagonal tensor keeps these as its axes.
 * Each moment is right to one unit in the last place of the largest; of a positive definite tensor each to one of its
 * own, down to 10^-${pair_decades} of the largest, unless the tensor scaled to unit diagonal is singular to
 * ${pair_digits} digits.  The axes are rounded once: their products differ from 0 and 1 by at most the type's epsilon.
 * At most 240 rotations, some ten in practice.  Returns 0; 1 if an entry, or a moment, is not a finite number:
 * nothing is written then.  moments and axes must not overlap I. */
int ${name}_principal_of(const ${name}_real I[6], ${name}_real moments[3], ${name}_real axes[9]);

/* The same of the tensor about the origin of rotation. */
int ${name}_principal(const ${name}_model *m, ${name}_real moments[3], ${name}_real axes[9]);
