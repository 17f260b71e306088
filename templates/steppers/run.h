%% -- run.h -- the contract of a run by a tolerance: part of scene.h.  SPDX-License-Identifier: MIT-0
/* From time t0 to t1 in at most `most` steps whose estimated error is the tolerance times the size of each kind of state
 * (attitude, rates, ...); returns how many were tried, or -1 if they did not suffice or the state became infinite (x is
%% if has_switches then
 * then where it stopped).
%% if has_sides then
 * The equations have corners, where steps end; -1 also where both sides of one push back to it, so that no motion leads on. */
%% elseif has_switches then
 * The equations have corners, where steps end. */
%% end
%% else
 * then where it stopped). */
%% end
int ${name}_${method}_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most);
