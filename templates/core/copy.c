%% -- copy.c -- structures as bytes: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- whole structures, byte by byte ----
 * Compilers make calls of memcpy and memset of anything simpler, and firmware need not have them. */

static void ${name}_copy(void *to, const void *from, unsigned int size)
{
  unsigned char *a = (unsigned char *)to;
  const volatile unsigned char *b = (const volatile unsigned char *)from;
  unsigned int i;

  for (i = 0; i < size; i++) { /* some 200 times */
    a[i] = b[i];
  }
}
%% if clears then

/* integers and IEEE 754 numbers of which all bits are 0 are 0 */
static void ${name}_zero(void *to, unsigned int size)
{
  volatile unsigned char *a = (volatile unsigned char *)to;
  unsigned int i;

  for (i = 0; i < size; i++) { /* some 200 times */
    a[i] = 0;
  }
}
%% end

/* Is the state at time 0 made of numbers?  Rates next to the end of the type's range overflow on the way to it. */
static int ${name}_starts(const ${name}_orbit *o)
{
%% if has_full then
  ${name}_real x[${upper}_NX];
  int i;

  ${name}_at(o, ${zero}, x);
  for (i = 0; i < ${upper}_NX; i++) {
    if (!(x[i] - x[i] == ${zero})) return 0;
  }
%% else
  ${name}_real w[3];
  int i;

  ${name}_at_rates(o, ${zero}, w);
  for (i = 0; i < 3; i++) {
    if (!(w[i] - w[i] == ${zero})) return 0;
  }
%% end
  return 1;
}
