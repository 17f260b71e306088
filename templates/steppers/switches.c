%% -- switches.c -- where the equations have corners, and their forms between them: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- Corners of the equations (Hairer, Norsett, Wanner I, section II.6) ----
 * Each is where a function g of state and time is 0:
%% for _, s in ipairs(list) do
 *   ${s.number}: ${s.about}
%% end
 * ${array}[i] is the side of 0 that g[i] is on, 1 or -1, or 0 where it stays 0: with these numbers the equations are smooth, and
 * the steps end where a g leaves its side. */
static ${g.head}
{
%% for _, line in ipairs(g.lines) do
%%   if line == "" then

%%   else
  ${line}
%%   end
%% end
}
%% if has_rates then

/* x' on the sides */
static ${rates.head}
{
%% for _, line in ipairs(rates.lines) do
%%   if line == "" then

%%   else
  ${line}
%%   end
%% end
}
%% end

/* The places within a step, in parts of it, at which the signs are looked at: Chebyshev's, unevenly spaced. */
static const ${name}_real ${name}_looks[${looks} + 1] = {
%% for _, p in ipairs(places) do
  ${p}
%% end
};

/* 1, -1 or 0 */
static int ${name}_side_of(${name}_real g)
{
  return (g > ${zero}) - (g < ${zero});
}

/* What a run knows of them: open, 0 where the step starts, so that its side shows behind that; mute, of roundings alone, so that
 * its side tells nothing; how often a side was wrong and a step too long for the looks. */
typedef struct ${name}_corners {
  int open[${many}], mute[${many}], wrong, halved;
} ${name}_corners;

/* The sides at the start */
static void ${name}_sides(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real ${array}[${many}], ${name}_corners *o)
{
  ${name}_real g[${many}];

  for (int i = 0; i < ${many}; i++) g[i] = ${array}[i] = ${zero};
  o->wrong = o->halved = 0;
  for (int n = 0; n < ${many}; n++) { /* one may stand in another */
    ${name}_switches(m, t, x${no_rates}, u, ${array}, g);
    for (int i = 0; i < ${smooth}; i++) ${array}[i] = (${name}_real)${name}_side_of(g[i]);
  }
  for (int i = 0; i < ${many}; i++) {
    o->open[i] = !(g[i] > ${zero} || g[i] < ${zero});
    o->mute[i] = 0;
  }
}

/* Do the looks show g's course?  The last two coefficients of its Chebyshev series are then below 1/64 of
 * it. */
static int ${name}_resolved(${name}_real g[][${many}], int i)
{
  ${name}_real most = ${zero}, last = ${zero}, before = ${zero};

  for (int k = 0; k <= ${looks}; k++) {
    const ${name}_real weight = k > 0 && k < ${looks} ? ${one} : ${half}, turn = k % 2 == 0 ? ${one} : -${one};

    most = ${fabs}(g[k][i]) > most ? ${fabs}(g[k][i]) : most;
    last += weight*turn*g[k][i];
    before += weight*turn*(${one} - ${two}*${name}_looks[k])*g[k][i];
  }
  return !(${fabs}(last)*${n[64]} > most*${looks_real} || ${fabs}(before)*${n[128]} > most*${looks_real});
}

/* Is g on its side, of a bend: is the speed still falling? */
static int ${name}_stays(${name}_real g, ${name}_real side, int i)
{
%% if bends then
  if (i >= ${smooth}) return g < ${zero};
%% else
  (void)i;
%% end
  return side > ${zero} || side < ${zero} ? g*side > ${zero} : !(g > ${zero} || g < ${zero});
}

/* The first part of the step, from low to high, in which g[i] leaves its side by the looks 0 to `last`: 1, or 0 if there is none.
 * A g that comes back between two looks shows by the parabola through three. */
static int ${name}_left(${name}_real g[][${many}], const ${name}_real ${array}[], const int open[], int i, int last, ${name}_real *low, ${name}_real *high)
{
  const ${name}_real *at = ${name}_looks;

  for (int k = 1; k <= ${looks}; k++) {
    if (k > last) break;
    if (k == 1 && open[i]) continue;
%% if bends then
    if (i >= ${smooth} && !(g[k - 1][i] < ${zero})) continue;
%% end
    *low = at[k - 1];
    *high = at[k];
    if (!${name}_stays(g[k][i], ${array}[i], i)) return 1;
    if (k >= 2 && i < ${smooth}) {
      const ${name}_real a = (g[k - 1][i] - g[k - 2][i])/(at[k - 1] - at[k - 2]);
      const ${name}_real b = ((g[k][i] - g[k - 1][i])/(at[k] - at[k - 1]) - a)/(at[k] - at[k - 2]);
      const ${name}_real s = ${half}*(at[k - 2] + at[k - 1]) - ${half}*a/b;

      *low = at[k - 2];
      *high = s;
      if (s > at[k - 2] && s < at[k] && (k > 2 || !open[i]) &&
          !${name}_stays(g[k - 2][i] + (s - at[k - 2])*(a + b*(s - at[k - 1])), ${array}[i], i)) return 1;
    }
  }
  return 0;
}
