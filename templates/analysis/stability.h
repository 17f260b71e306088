%% -- stability.h -- which spins persist, by the signs of differences of moments: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- stability by design ---- */

/* Does a spin of the free body about a principal axis persist?  1 stable, 0 neutral (equal
 * moments), -1 unstable.  (Landau, Lifshitz, section 37; Hughes, Spacecraft Attitude Dynamics,
 * chapter 7.)
 *   dissipation 0: a rigid body, stable about the axes of the largest and of the smallest moment
 *   not 0: a body that loses energy inside while it keeps its angular momentum, stable about the
 *     axis of the largest moment only
 * axis, and when it is stable:
%% for _, line in ipairs(doc) do
 *   ${line}
%% end
%% for _, line in ipairs(note) do
 * ${line}
%% end
 */
int ${name}_spin_stable(const ${name}_model *m, int axis, int dissipation);
