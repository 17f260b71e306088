%% -- init.h -- the contract of the set-up: part of scene.h.  SPDX-License-Identifier: MIT-0
%% for _, line in ipairs(unasked) do
${line}
%% end
/* Parameters p[${upper}_NP], SI units; NULL: the scene's own.  Returns 0, or the number of the check that failed,
 * *m untouched then:
%% for _, c in ipairs(checks) do
 *   ${c.number}  ${c.text}
%% end
 */
int ${name}_init(${name}_model *m, const ${name}_real p[]);

/* The scene's own parameters. */
void ${name}_defaults(${name}_real p[]);
