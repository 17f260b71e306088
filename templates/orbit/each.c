%% -- each.c -- a closed form at many times, one after the other: part of scene.c.  SPDX-License-Identifier: MIT-0
void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[])
{
  ${name}_real y[${upper}_NX], *row;
  int i;

  for (int k = 0; k < n; k++) {
    ${name}_at(o, t[k], y);
    for (i = 0, row = x;; row += n) {
      row[k] = y[i];
      if (++i == ${upper}_NX) break;
    }
  }
}
