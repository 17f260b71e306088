%% -- watch.c -- passages through zero and extrema along the motion: part of members.c.  SPDX-License-Identifier: MIT-0
/* What is watched in lane k a part s of a step h after state x at time t, by a step of its own. */
static real watched(const block *b, int k, int w, real t, const real x[], real s, real h)
{
  real y[${upper}_NX], p[${upper}_NP + 1], out[WATCHED];
  int i;
%% if has_inputs then
  real u[${upper}_NU] = {0};
%% end

  for (i = 0; i < ${upper}_NX; i++) y[i] = x[i];
  for (i = 0; i < ${upper}_NP; i++) p[i] = b->p[i][k];
  ${name}_${step}(&b->model[k%MODELS], t, y, ${step_inputs}, s*h);
  watch_one(p, t + s*h, y, out);
  return out[w];
}
%% if has_passages then

/* The part of the step at which what is watched is zero, between g at its beginning and f at its end: regula falsi, the
 * value at an end that stays being halved (Illinois: M. Dowell, P. Jarratt, BIT 11 (1971) 168-174). */
static real passage(const block *b, int k, int w, real t, const real x[], real h, real g, real f)
{
  real low = 0, high = 1, last = -1;
  int i, side = 0;

  for (i = 0; i < 100; i++) {
    real s = i < 50 ? (low*f - high*g)/(f - g) : (low + high)/2, y;

    if (!(s > low && s < high)) s = (low + high)/2;
    if (!(s > low && s < high)) return high;
    y = watched(b, k, w, t, x, s, h);
    if (y == 0 || (s - last < ${tolerance} && last - s < ${tolerance})) return s;
    last = s;
    if ((y < 0) == (f < 0)) {
      high = s;
      f = y;
      if (side == 1) g /= 2;
      side = 1;
    } else {
      low = s;
      g = y;
      if (side == 2) f /= 2;
      side = 2;
    }
  }
  return high;
}
%% end
%% if has_extrema then

/* The least of way times what is watched within two steps, by golden sections and parabolas: R. P. Brent, Algorithms for
 * Minimization without Derivatives (1973), section 5.4. */
static real extremum(const block *b, int k, int w, real way, real guess)
{
  const real golden = (real)0.3819660112501051, t = b->best_t[w][k], h = b->best_h[w][k];
  real xa[${upper}_NX], xb[${upper}_NX], low = 0, high = 2, s = 1, second = 1, third = 1, f, f2, f3, d = 0, e = 0;
  int i;

  for (i = 0; i < ${upper}_NX; i++) {
    xa[i] = b->best_x[w][i][k];
    xb[i] = b->best_y[w][i][k];
  }
  f = f2 = f3 = way*guess;
  for (i = 0; i < 60; i++) {
    const real middle = (low + high)/2;
    real u, fu;

    if (high - low < ${extremum_tolerance}) break;
    if (e > ${extremum_tolerance} || e < -${extremum_tolerance}) {
      const real r = (s - second)*(f - f3);
      real q = (s - third)*(f - f2), n = (s - third)*q - (s - second)*r;
      const real last = e;

      q = 2*(q - r);
      if (q > 0) n = -n; else q = -q;
      e = d;
      if ((n < 0 ? -n : n) < (q*last < 0 ? -q*last : q*last)/2 && n > q*(low - s) && n < q*(high - s)) {
        d = n/q;
      } else {
        e = s < middle ? high - s : low - s;
        d = golden*e;
      }
    } else {
      e = s < middle ? high - s : low - s;
      d = golden*e;
    }
    if (d > 0 && d < ${extremum_tolerance}/4) d = ${extremum_tolerance}/4;
    if (d <= 0 && d > -${extremum_tolerance}/4) d = -${extremum_tolerance}/4;
    u = s + d;
    fu = way*(u <= 1 ? watched(b, k, w, t, xa, u, h) : watched(b, k, w, t + h, xb, u - 1, h));
    if (fu <= f) {
      if (u < s) high = s; else low = s;
      third = second, f3 = f2;
      second = s, f2 = f;
      s = u, f = fu;
    } else {
      if (u < s) low = u; else high = u;
      if (fu <= f2 || second == s) {
        third = second, f3 = f2;
        second = u, f2 = fu;
      } else if (fu <= f3 || third == s || third == second) {
        third = u, f3 = fu;
      }
    }
  }
  return way*f;
}
%% end

/* What each watched quantity is looked at for: its first passage through zero (way +1 or -1: only upwards or downwards),
 * or its greatest (way +1) or least (-1) value. */
static const struct {
  int passage, way;
} WATCH[WATCHED] = {
%% for _, w in ipairs(watches) do
  {${w.passage}, ${w.way}},
%% end
};

/* After a step h that began at t: passages and extrema.  Most steps have none in any lane: a first loop, without branches,
 * asks whether there may be one, and only then the lanes are looked at one by one. */
%% if has_passages then
static void see_passage(block *b, real t, real h, int w)
{
  const int rises = WATCH[w].way >= 0, falls = WATCH[w].way <= 0;
  int k, any = 0;

  /* y2 is the last value that was not 0: one that only touches 0 has not passed */
  for (k = 0; k < LANES; k++) {
    any |= ((b->y[w][k] > 0) & (b->y2[w][k] < 0) & rises) | ((b->y[w][k] < 0) & (b->y2[w][k] > 0) & falls);
  }
  for (k = 0; any && k < LANES; k++) {
    const real f = b->y[w][k], g = b->y1[w][k], e = b->y2[w][k];
    real x[${upper}_NX];

    if (!(f > 0 && e < 0 && rises) && !(f < 0 && e > 0 && falls)) continue;
    if (b->found[w][k] == b->found[w][k]) continue; /* it is the first that counts */
    lane_of(b->before, k, ${upper}_NX, x);
    b->found[w][k] = g == 0 ? t : t + h*passage(b, k, w, t, x, h, g, f);
  }
  for (k = 0; k < LANES; k++) b->y2[w][k] = b->y[w][k] != 0 ? b->y[w][k] : b->y2[w][k];
}

%% end
%% if has_extrema then
/* Between the steps' ends: the top of the parabola through three of them is kept if it is the greatest so far. */
static void see_top(block *b, real t, real h, int w, int k)
{
  const real way = (real)WATCH[w].way, f = b->y[w][k], g = b->y1[w][k], e = b->y2[w][k];
  const real bend = 2*g - e - f, rise = f - e, top = bend != 0 ? g + rise*rise/(8*bend) : g;
  int i;

  if (way*top <= way*b->best[w][k]) return; /* at first best is no number */
  b->best[w][k] = top;
  b->best_g[w][k] = g;
  b->best_t[w][k] = t - h;
  b->best_h[w][k] = h;
  for (i = 0; i < ${upper}_NX; i++) {
    b->best_x[w][i][k] = b->older[i][k];
    b->best_y[w][i][k] = b->before[i][k];
  }
}

static void see_extremum(block *b, real t, real h, int w, int first)
{
  const real way = (real)WATCH[w].way;
  int k, any = 0;

  for (k = 0; k < LANES; k++) {
    any |= (way*b->y1[w][k] >= way*b->y2[w][k]) & (way*b->y1[w][k] >= way*b->y[w][k]);
  }
  for (k = 0; any && !first && k < LANES; k++) {
    if (way*b->y1[w][k] >= way*b->y2[w][k] && way*b->y1[w][k] >= way*b->y[w][k]) see_top(b, t, h, w, k);
  }
  for (k = 0; k < LANES; k++) { /* of the steps' ends */
    b->found[w][k] = way*b->y[w][k] > way*b->found[w][k] ? b->y[w][k] : b->found[w][k];
    b->y2[w][k] = b->y1[w][k];
  }
}

%% end
static void see(block *b, real t, real h, int first)
{
  int w;

  for (w = 0; w < WATCHED; w++) {
%% if has_passages and has_extrema then
    if (WATCH[w].passage) see_passage(b, t, h, w);
    else see_extremum(b, t, h, w, first);
%% elseif has_passages then
    see_passage(b, t, h, w);
%% else
    see_extremum(b, t, h, w, first);
%% end
  }
  (void)first;
}

%% if has_extrema then
/* The greatest or least value that was seen, at a step's end or between two. */
static real greatest(const block *b, int k, int w)
{
  const real way = (real)WATCH[w].way, end = b->found[w][k];
  real between;

  if (b->best[w][k] != b->best[w][k]) return end;
  between = extremum(b, k, w, -way, b->best_g[w][k]);
  return way*between > way*end ? between : end;
}

%% end
/* n steps, watched. */
static void march(block *b, real t, real h, int steps)
{
  int j, i, k, w;

  for (j = 0; j < steps; j++) {
    const real at = t + (real)j*h;

    for (i = 0; i < ${upper}_NX; i++) {
      for (k = 0; k < LANES; k++) {
        b->older[i][k] = b->before[i][k];
        b->before[i][k] = b->x[i][k];
      }
    }
    for (w = 0; w < WATCHED; w++) {
      for (k = 0; k < LANES; k++) b->y1[w][k] = b->y[w][k];
    }
    advance(b, b->x, at, h, 1);
%% if judged then
    judge(b, at + h, h);
%% end
    watch_lanes(b->p, at + h, b->x, b->y);
    see(b, at, h, j == 0);
  }
}
