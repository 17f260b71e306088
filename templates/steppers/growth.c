%% -- growth.c -- how long the next step is, of methods of order 5 with an estimate of order 4: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The next step, in parts of one whose error is r times the tolerance: 7/8 r^(-3/16), from an eighth to four; 3/16 is a little
 * less than 1/5.  What is not finite counts as an eighth. */
static ${name}_real ${name}_growth(${name}_real r)
{
  const ${name}_real factor = r > ${zero} ? ${exp}(-${n[3/16]}*${log}(r))*${n[7/8]} : ${eight};

  if (!(factor > ${eighth})) return ${eighth};
  return factor > ${four} ? ${four} : factor;
}
