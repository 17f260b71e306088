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
  ${line}
%% end
}
%% if has_rates then

/* x' on the sides */
static ${rates.head}
{
%% for _, line in ipairs(rates.lines) do
  ${line}
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
 * its side tells nothing; how often a side was wrong, a step too long for the looks, and a corner next to the one before; the time
 * of the whole run. */
typedef struct ${name}_corners {
  int open[${many}], mute[${many}], wrong, halved, crowded;
  ${name}_real span;
} ${name}_corners;

/* A few roundings of the times of a step: zeros that are no further apart are one. */
static ${name}_real ${name}_close(${name}_real t, ${name}_real h, const ${name}_corners *o)
{
  ${name}_real most = ${fabs}(o->span)*${thousandth};

  if (${fabs}(t) > most) most = ${fabs}(t);
  if (${fabs}(t + h) > most) most = ${fabs}(t + h);
  return most*${rounding};
}

/* The sides at the start of a run over `span` */
static void ${name}_sides(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real span, ${name}_real ${array}[${many}], ${name}_corners *o)
{
%% if has_sides then
  ${name}_real g[${many}];

  for (int i = 0; i < ${many}; i++) g[i] = ${array}[i] = ${zero};
  for (int n = 0; n < ${many}; n++) { /* one may stand in another */
    ${name}_switches(m, t, x${no_rates}, u, ${array}, g);
    for (int i = 0; i < ${smooth}; i++) {
      const int side = ${name}_side_of(g[i]);

      ${array}[i] = (${name}_real)side;
    }
  }
  for (int i = 0; i < ${many}; i++) o->open[i] = !(g[i] > ${zero} || g[i] < ${zero});
%% else
  (void)m;
  (void)t;
  (void)x;
  (void)u;
  for (int i = 0; i < ${many}; i++) {
    ${array}[i] = ${zero}; /* a speed has no sides */
    o->open[i] = 0;
  }
%% end
  for (int i = 0; i < ${many}; i++) o->mute[i] = 0;
  o->wrong = o->halved = o->crowded = 0;
  o->span = span;
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

/* Is g on its side, of a bend: is the speed falling to nothing? */
static int ${name}_stays(${name}_real g, ${name}_real side, int i)
{
%% if bends then
  if (i >= ${smooth}) return g < ${zero};
%% else
  (void)i;
%% end
  return side > ${zero} || side < ${zero} ? g*side > ${zero} : !(g > ${zero} || g < ${zero});
}

/* The first part of the step, from low to high > from, in which g[i] leaves its side by the looks 0 to `last`: 1, or 0 if there is
 * none.  A g that comes back between two looks shows by the parabola through three. */
static int ${name}_left(${name}_real g[][${many}], const ${name}_real ${array}[], const int open[], int i, int last, ${name}_real from, ${name}_real *low, ${name}_real *high)
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
    if (!${name}_stays(g[k][i], ${array}[i], i) && *high > from) return 1;
    if (k >= 2 && i < ${smooth}) {
      const ${name}_real a = (g[k - 1][i] - g[k - 2][i])/(at[k - 1] - at[k - 2]);
      const ${name}_real b = ((g[k][i] - g[k - 1][i])/(at[k] - at[k - 1]) - a)/(at[k] - at[k - 2]);
      const ${name}_real s = ${half}*(at[k - 2] + at[k - 1]) - ${half}*a/b;

      *low = at[k - 2];
      *high = s;
      if (s > from && s > at[k - 2] && s < at[k] && (k > 2 || !open[i]) &&
          !${name}_stays(g[k - 2][i] + (s - at[k - 2])*(a + b*(s - at[k - 1])), ${array}[i], i)) return 1;
    }
  }
  return 0;
}

/* Do the first `count` sides fit the step, and the looks the course of each g?  If not, a side has changed or h is shorter.
 * known: in what part of the step each is on its side. */
static int ${name}_sides_fit(${name}_real t, ${name}_real *h, ${name}_real g[][${many}], ${name}_real ${array}[], int count, ${name}_real known[], ${name}_corners *o)
{
  const ${name}_real close = ${name}_close(t, *h, o);
  int soon = 1; /* the first look that is apart from the start */

  while (soon < ${looks} && !(${name}_looks[soon]*${fabs}(*h) > close)) soon++;
  for (int i = 0; i < count; i++) {
    const int side = ${name}_side_of(g[0][i]), next = ${name}_side_of(g[soon][i]);

    known[i] = o->open[i] ? ${name}_looks[soon] : ${zero};
    if (soon > 1 || ${name}_resolved(g, i)) {
      o->mute[i] = 0;
    } else if (!o->mute[i]) {
      *h *= ${half};
      o->mute[i] = ++o->halved > ${most_halved};
      return 0;
    }
%% if bends then
    if (i >= ${smooth}) continue;
%% end
    if (!o->open[i] && side != ${name}_side_of(${array}[i])) {
      o->open[i] = 1;
      ${array}[i] = (${name}_real)side;
      return 0;
    }
    if (o->open[i] && !o->mute[i] && next != ${name}_side_of(${array}[i])) {
      ${array}[i] = (${name}_real)next;
      if (++o->wrong % 2 == 0) *h *= ${quarter};
      return 0;
    }
  }
  return 1;
}

/* The sides after a step to a corner, of `event` (-1: no corner; of a bend: none) and of all others whose zero it passed as well;
 * g at its end.  1; 0: it is within roundings of the start; -1: there are ever more of these. */
static int ${name}_turn(${name}_real t, ${name}_real h, const ${name}_real g[], ${name}_real ${array}[], int event, ${name}_corners *o)
{
  const ${name}_real close = ${name}_close(t, h, o);
  const int here = !(${fabs}(h) > close);

  for (int i = 0; i < ${many}; i++) {
    const int side = ${name}_side_of(g[i]);
    const int beyond = event >= 0 && i < ${smooth} && !o->mute[i] && !${name}_stays(g[i], ${array}[i], i);
    const int turns = i == event || (beyond && !here && !o->open[i]);

    o->open[i] = turns || (o->open[i] && (here || beyond));
    if (turns && i < ${smooth}) ${array}[i] = side != 0 ? (${name}_real)side : -${array}[i];
  }
  o->crowded = ${fabs}(h) > ${n[16]}*close ? 0 : o->crowded + 1;
  if (o->crowded > ${most_crowded}) return -1;
  return !here;
}
