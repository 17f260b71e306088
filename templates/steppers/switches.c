%% -- switches.c -- where the equations have corners, and their forms between them: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- Corners of the equations (Hairer, Norsett, Wanner I, section II.6) ----
 * Each is where a switching function g of state and time is 0:
%% for _, s in ipairs(list) do
 *   ${s.number}: ${s.about}
%% end
%% if has_sides then
 * ${array}[i] is the side of 0 that g[i] is on, 1 or -1, or 0 where it stays 0: with these numbers the equations are smooth, and
 * the steps end where a g leaves its side.
%% end
%% if bends then
 * Of a speed |s|, g = s.s + h d(s.s)/dt, h the step: it is below 0 while |s| falls so fast that nothing would be left within
 * the step, and back above 0 close to where |s| is least, where the step ends.
%% end
 */

%% if bends then
/* g of the state x at t; v: h dx/dt */
%% else
/* g of the state x at t */
%% end
static ${g.head}
{
%% for _, line in ipairs(g.lines) do
  ${line}
%% end
}
%% if has_rates then

/* dx/dt on the sides */
static ${rates.head}
{
%% for _, line in ipairs(rates.lines) do
  ${line}
%% end
}
%% end

/* Where in a step g is looked at, in parts of it: the extrema of Chebyshev's polynomial, (1 - cos(k pi/${looks}))/2. */
static const ${name}_real ${name}_nodes[${nodes}] = {
%% for _, row in ipairs(places) do
  ${row}
%% end
};

%% if has_sides then
/* 1, -1 or 0 */
static int ${name}_side_of(${name}_real g)
{
  return (g > ${zero}) - (g < ${zero});
}

%% end
/* What a run knows of the corners. */
typedef struct ${name}_corners {
%% if has_sides then
  ${name}_real ${array}[${smooth}];
%% end
  int at_zero[${many}]; /* g is 0 where the step starts, so that its side shows behind that */
  int noise[${many}]; /* g is of roundings alone, so that its side tells nothing */
%% if has_sides then
  int wrong; /* how often a side was wrong */
%% end
  int halved; /* how often the step was too long for the nodes */
  int crowded; /* corners next to the one before */
  ${name}_real span; /* the time of the whole run */
} ${name}_corners;

%% if has_sides then
static void ${name}_put_side(${name}_corners *o, int i, int side)
{
  o->${array}[i] = (${name}_real)side;
}

%% end
/* A few roundings of the times of a step: zeros that are no further apart are one. */
static ${name}_real ${name}_time_rounding(${name}_real t, ${name}_real h, const ${name}_corners *o)
{
  ${name}_real most = ${fabs}(o->span)*${thousandth};

  if (${fabs}(t) > most) most = ${fabs}(t);
  if (${fabs}(t + h) > most) most = ${fabs}(t + h);
  return most*${rounding};
}

%% if has_sides then
/* The sides at the start of a run over `span` */
static void ${name}_corners_at_start(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real span, ${name}_corners *o)
{
  ${name}_real g[${many}];

  for (int i = 0; i < ${smooth}; i++) o->${array}[i] = ${zero};
  for (int n = 0; n < ${smooth}; n++) { /* one may stand in another */
%%   if bends then
    ${name}_switches(m, t, x, x, u, o->${array}, g); /* any v: it stands in speeds alone */
%%   else
    ${name}_switches(m, t, x, u, o->${array}, g);
%%   end
    for (int i = 0; i < ${smooth}; i++) ${name}_put_side(o, i, ${name}_side_of(g[i]));
  }
  for (int i = 0; i < ${many}; i++) {
    o->at_zero[i] = !(g[i] > ${zero} || g[i] < ${zero});
    o->noise[i] = 0;
  }
  o->wrong = o->halved = o->crowded = 0;
  o->span = span;
}

%% else
/* At the start of a run over `span` */
static void ${name}_corners_at_start(${name}_real span, ${name}_corners *o)
{
  for (int i = 0; i < ${many}; i++) o->at_zero[i] = o->noise[i] = 0;
  o->halved = o->crowded = 0;
  o->span = span;
}

%% end
/* Do the nodes show the course of g[i]?  The last two coefficients of its Chebyshev series are then below 1/64 of it. */
static int ${name}_resolved(${name}_real g[][${many}], int i)
{
  ${name}_real most = ${zero}, last = ${zero}, before = ${zero};

  for (int k = 0; k <= ${looks}; k++) {
    const ${name}_real weight = k > 0 && k < ${looks} ? ${one} : ${half}, sign = k % 2 == 0 ? ${one} : -${one};

    most = ${fabs}(g[k][i]) > most ? ${fabs}(g[k][i]) : most;
    last += weight*sign*g[k][i];
    before += weight*sign*(${one} - ${two}*${name}_nodes[k])*g[k][i];
  }
  return !(${fabs}(last)*${n[64]} > most*${looks_real} || ${fabs}(before)*${n[128]} > most*${looks_real});
}

%% if not has_sides then
/* Is the speed falling to nothing? */
static int ${name}_stays(const ${name}_real g[], int i)
{
  return g[i] < ${zero};
}
%% elseif bends then
/* Is g[i] on its side, or of a speed: is it falling to nothing? */
static int ${name}_stays(const ${name}_real g[], const ${name}_real ${array}[], int i)
{
  if (i >= ${smooth}) return g[i] < ${zero};
  if (${array}[i] > ${zero} || ${array}[i] < ${zero}) return g[i]*${array}[i] > ${zero};
  return !(g[i] > ${zero} || g[i] < ${zero});
}
%% else
/* Is g[i] on its side? */
static int ${name}_stays(const ${name}_real g[], const ${name}_real ${array}[], int i)
{
  if (${array}[i] > ${zero} || ${array}[i] < ${zero}) return g[i]*${array}[i] > ${zero};
  return !(g[i] > ${zero} || g[i] < ${zero});
}
%% end

%% if has_sides then
/* The first part of the step, from low to high > from, in which g[i] leaves its side by the nodes 0 to `last`: 1, or 0 if there
 * is none.  A g that comes back between two nodes shows by the parabola through three (Newton's form). */
%% else
/* The first part of the step, from low to high > from, in which g[i] comes back above 0 by the nodes 0 to `last`: 1, or 0 if
 * there is none. */
%% end
static int ${name}_leaves(${name}_real g[][${many}], const ${name}_corners *o, int i, int last, ${name}_real from, ${name}_real *low, ${name}_real *high)
{
  const ${name}_real *at = ${name}_nodes;

  for (int k = 1; k <= ${looks}; k++) {
    if (k > last) break;
    if (k == 1 && o->at_zero[i]) continue;
%% if not has_sides then
    if (!${name}_stays(g[k - 1], i)) continue;
%% elseif bends then
    if (i >= ${smooth} && !${name}_stays(g[k - 1], o->${array}, i)) continue;
%% end
    *low = at[k - 1];
    *high = at[k];
    if (!${name}_stays(g[k]${o_branch}, i) && *high > from) return 1;
%% if has_sides then
%%   if bends then
    if (k >= 2 && i < ${smooth}) {
%%   else
    if (k >= 2) {
%%   end
      const ${name}_real a = (g[k - 1][i] - g[k - 2][i])/(at[k - 1] - at[k - 2]);
      const ${name}_real b = ((g[k][i] - g[k - 1][i])/(at[k] - at[k - 1]) - a)/(at[k] - at[k - 2]);
      const ${name}_real s = ${half}*(at[k - 2] + at[k - 1]) - ${half}*a/b; /* its extremum */
      const ${name}_real value = g[k - 2][i] + (s - at[k - 2])*(a + b*(s - at[k - 1]));

      *low = at[k - 2];
      *high = s;
      if (s > from && s > at[k - 2] && s < at[k] && (k > 2 || !o->at_zero[i]) && !(value*o->${array}[i] > ${zero})) return 1;
    }
%% end
  }
  return 0;
}

%% if has_sides then
/* Do the sides of the first `count` g fit the step, and the nodes the course of each?  If not, a side has changed or h is
 * shorter.  known: in what part of the step each is on its side. */
%% else
/* Do the nodes show the course of the first `count` g?  If not, h is shorter.  known: in what part of the step each is below
 * 0. */
%% end
static int ${name}_step_fits(${name}_real t, ${name}_real *h, ${name}_real g[][${many}], int count, ${name}_real known[], ${name}_corners *o)
{
  const ${name}_real rounding = ${name}_time_rounding(t, *h, o);
  int soon = 1; /* the first node that is apart from the start */

  while (soon < ${looks} && !(${name}_nodes[soon]*${fabs}(*h) > rounding)) soon++;
  for (int i = 0; i < count; i++) {
    known[i] = o->at_zero[i] ? ${name}_nodes[soon] : ${zero};
    if (soon > 1 || ${name}_resolved(g, i)) {
      o->noise[i] = 0;
    } else if (!o->noise[i]) {
      *h *= ${half};
      o->noise[i] = ++o->halved > ${most_halved};
      return 0;
    }
%% if has_sides then
%%   if bends then
    if (i >= ${smooth}) continue;
%%   end
    if (!o->at_zero[i] && ${name}_side_of(g[0][i]) != ${name}_side_of(o->${array}[i])) {
      o->at_zero[i] = 1;
      ${name}_put_side(o, i, ${name}_side_of(g[0][i]));
      return 0;
    }
    if (o->at_zero[i] && !o->noise[i] && ${name}_side_of(g[soon][i]) != ${name}_side_of(o->${array}[i])) {
      ${name}_put_side(o, i, ${name}_side_of(g[soon][i]));
      if (++o->wrong % 2 == 0) *h *= ${quarter};
      return 0;
    }
%% end
  }
  return 1;
}

%% if has_sides then
/* The sides after a step to a corner, of `event` (-1: no corner) and of all others whose zero it passed as well; g at its end.
 * 1; 0: the corner is within roundings of the start; -1: there are ever more of these. */
static int ${name}_corners_after(${name}_real t, ${name}_real h, const ${name}_real g[], int event, ${name}_corners *o)
{
  const ${name}_real rounding = ${name}_time_rounding(t, h, o);
  const int here = !(${fabs}(h) > rounding);

  for (int i = 0; i < ${many}; i++) {
%%   if bends then
    const int beyond = event >= 0 && i < ${smooth} && !o->noise[i] && !${name}_stays(g, o->${array}, i);
%%   else
    const int beyond = event >= 0 && !o->noise[i] && !${name}_stays(g, o->${array}, i);
%%   end
    const int turns = i == event || (beyond && !here && !o->at_zero[i]);

    o->at_zero[i] = turns || (o->at_zero[i] && (here || beyond));
%%   if bends then
    if (!turns || i >= ${smooth}) continue;
%%   else
    if (!turns) continue;
%%   end
    if (${name}_side_of(g[i]) != 0) ${name}_put_side(o, i, ${name}_side_of(g[i]));
    else o->${array}[i] = -o->${array}[i];
  }
%% else
/* What is known after a step to where the speed number `event` is least (-1: no corner).  1; 0: this is within roundings of the
 * start; -1: there are ever more of these. */
static int ${name}_corners_after(${name}_real t, ${name}_real h, int event, ${name}_corners *o)
{
  const ${name}_real rounding = ${name}_time_rounding(t, h, o);
  const int here = !(${fabs}(h) > rounding);

  for (int i = 0; i < ${many}; i++) o->at_zero[i] = i == event || (o->at_zero[i] && here);
%% end
  o->crowded = ${fabs}(h) > ${n[16]}*rounding ? 0 : o->crowded + 1;
  if (o->crowded > ${most_crowded}) return -1;
  return !here;
}
