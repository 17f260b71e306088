%% -- split_half.c -- cosine and sine of a half turn: part of scene.c.  SPDX-License-Identifier: MIT-0
/* c = cos(a), s = sin(a)/a of a = sqrt(z): their series up to a = 1/2 */
static void ${name}_split_half(${name}_real z, ${name}_real *c, ${name}_real *s)
{
  if (z <= ${quarter}) {
    const ${name}_real zz = z*z;

    *c = ${cos_series};
    *s = ${sin_series};
  } else {
    const ${name}_real a = ${sqrt}(z);

    *c = ${cos}(a);
    *s = ${sin}(a)/a;
  }
}
