%% -- copy.c -- structures as bytes: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if clears then
/* A structure byte by byte; from NULL: bits 0, which are the numbers 0, too.  Of anything simpler
 * compilers make calls of memcpy and memset, which firmware need not have. */
static void ${name}_copy(void *to, const void *from, unsigned int size)
{
  volatile unsigned char *a = (volatile unsigned char *)to;
  const unsigned char *b = (const unsigned char *)from;
  for (unsigned int i = 0; i < size; i++) { /* some 200 times */
    a[i] = b ? b[i] : 0;
  }
}
%% else
/* A structure byte by byte: of anything simpler compilers make a call of memcpy, which firmware need
 * not have. */
static void ${name}_copy(void *to, const void *from, unsigned int size)
{
  unsigned char *a = (unsigned char *)to;
  const volatile unsigned char *b = (const volatile unsigned char *)from;
  for (unsigned int i = 0; i < size; i++) { /* some 200 times */
    a[i] = b[i];
  }
}
%% end

/* are all n finite? */
static int ${name}_numbers(const ${name}_real x[], int n)
{
  for (int i = 0; i < n; i++) if (!(x[i] - x[i] == ${zero})) return 0;
  return 1;
}

/* Is the state at time 0 made of numbers?  Rates next to the end of the type's range overflow on the way to it. */
static int ${name}_starts(const ${name}_orbit *o)
{
%% if has_full then
  ${name}_real x[${upper}_NX];

  ${name}_at(o, ${zero}, x);
  return ${name}_numbers(x, ${upper}_NX);
%% elseif has_centre then
  ${name}_real p[2], v[2], W[3];

  ${name}_at_centre(o, ${zero}, p, v, W);
  return ${name}_numbers(p, 2) && ${name}_numbers(v, 2) && ${name}_numbers(W, 3);
%% else
  ${name}_real w[3];

  ${name}_at_rates(o, ${zero}, w);
  return ${name}_numbers(w, 3);
%% end
}
