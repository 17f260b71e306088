%% -- switched.c -- steps of a method that end at the corners of the equations: part of scene.c.  SPDX-License-Identifier: MIT-0
/* A step of ${method}: what it is made of, the state y at its end, and g along it. */
typedef struct ${name}_${method}_work {
  const ${name}_model *m;
  const ${name}_real *u;
  ${name}_corners o;
%% if taylor then
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW], lost[${upper}_MOVING];
%%   if bends then
  ${name}_real v1[${upper}_NX]; /* dx/dt at its end */
%%   end
%% else
%%   if adaptive then
  int fresh; /* k1 is still to be computed */
  ${name}_real k1[${count}], k7[${count}], out[${count}]${room};
%%   elseif slides then
  ${name}_real out[${upper}_NX];
%%   end
  ${name}_real error[${count}], v0[${upper}_NX], v1[${upper}_NX]; /* v0, v1: dx/dt at its ends */
%% end
%% if bends then
  ${name}_real reach; /* the step that was tried: what falls within it counts */
%% end
  ${name}_real y[${upper}_NX], g[${nodes}][${many}];
} ${name}_${method}_work;

%% if taylor then
static const int ${name}_taylor_moving[${upper}_MOVING] = {
%%   for _, s in ipairs(states) do
  ${s.name},
%%   end
};

/* The state y after the part s of the step that the series is for, its moves d. */
static void ${name}_taylor_within(${name}_taylor_work *w, const ${name}_real x[], ${name}_real s, int top, ${name}_real d[], ${name}_real y[])
{
  ${name}_taylor_step_by(w->m, w->c, top, s, x, d);
  for (int k = 0; k < ${upper}_NX; k++) y[k] = x[k];
  for (int k = 0; k < ${upper}_MOVING; k++) y[${name}_taylor_moving[k]] = w->c[0][k] + (d[k] + w->lost[k]);
}

%%   if bends then
/* dx/dt after the part s: the sum of n c[n] s^(n - 1) */
static void ${name}_taylor_slopes(const ${name}_taylor_work *w, ${name}_real s, int top, ${name}_real v[])
{
  for (int k = 0; k < ${upper}_NX; k++) v[k] = ${zero};
  for (int n = top; n > 0; n--) {
    for (int k = 0; k < ${upper}_MOVING; k++) {
      const int i = ${name}_taylor_moving[k];

      v[i] = s*v[i] + (${name}_real)n*w->c[n][k];
    }
  }
}

%%   end
/* The step over h. */
static void ${name}_taylor_advance(${name}_taylor_work *w, const ${name}_real x[], ${name}_real h, int top)
{
  ${name}_taylor_within(w, x, h, top, w->d, w->y);
%%   if bends then
  ${name}_taylor_slopes(w, h, top, w->v1);
%%   end
}
%% else
/* The step over h. */
static void ${name}_${method}_advance(${name}_${method}_work *w, ${name}_real t, const ${name}_real x[], ${name}_real h)
{
%%   if adaptive then
  ${name}_adaptive_trial(w->m, t, x, w->u, h, w->k1${w_sides}, w->out, w->k7, w->error${way_turn});
  for (int k = 0; k < ${upper}_NX; k++) w->y[k] = x[k];
  ${name}_adaptive_take(w->out${way_turn}, w->y);
  for (int k = 0; k < ${count}; k++) w->v1[${name}_adaptive_moving[k]] = w->k7[k];
%%   elseif slides then
  ${name}_real z[${upper}_NX];

  ${name}_rosenbrock_turned(w->m, t, x, w->u${w_sides}, ${one}, z);
  ${name}_rosenbrock_trial(w->m, t, z, w->u, h${w_sides}, w->out, w->error);
  ${name}_rosenbrock_turned(w->m, t + h, w->out, w->u${w_sides}, -${one}, w->y);
%%   else
  ${name}_rosenbrock_trial(w->m, t, x, w->u, h${w_sides}, w->y, w->error);
%%   end
}
%% end

/* g at the end of the step. */
static void ${name}_${method}_switches(${name}_${method}_work *w, ${name}_real t, ${name}_real h, ${name}_real g[])
{
%% if bends then
  ${name}_real v[${upper}_NX];

%%   if rosenbrock then
  ${name}_${rates}(w->m, t + h, w->y, w->u${w_sides}, w->v1);
%%   end
  for (int k = 0; k < ${upper}_NX; k++) v[k] = w->reach*w->v1[k];
%% end
  ${name}_switches(w->m, t + h, w->y${end_rates}, w->u${w_sides}, g);
}

/* g along the step${by_cubic}. */
static void ${name}_${method}_sample(${name}_${method}_work *w, ${name}_real t, const ${name}_real x[], ${name}_real h${top_arg})
{
%% if bends then
  ${name}_real y[${upper}_NX], v[${upper}_NX]${room_d};
%% else
  ${name}_real y[${upper}_NX]${room_d};
%% end

%% if rosenbrock and not bends then
  ${name}_${rates}(w->m, t + h, w->y, w->u${w_sides}, w->v1);
%% end
  ${name}_${method}_switches(w, t, h, w->g[${looks}]);
  for (int k = 0; k < ${looks}; k++) {
    const ${name}_real s = ${name}_nodes[k];

%% if taylor then
    ${name}_taylor_within(w, x, s*h, top, d, y);
%%   if bends then
    ${name}_taylor_slopes(w, s*h, top, v);
    for (int n = 0; n < ${upper}_NX; n++) v[n] *= w->reach;
%%   end
%% else
    for (int n = 0; n < ${upper}_NX; n++) {
      const ${name}_real rise = w->y[n] - x[n], a = h*w->v0[n] - rise, b = rise - h*w->v1[n];

      y[n] = x[n] + s*(rise + (${one} - s)*((${one} - s)*a + s*b));
%%   if bends then
      v[n] = (rise + (${one} - ${two}*s)*((${one} - s)*a + s*b) + s*(${one} - s)*(b - a))*(w->reach/h);
%%   end
    }
%% end
    ${name}_switches(w->m, t + s*h, y${look_rates}, w->u${w_sides}, w->g[k]);
  }
}

/* The step that ends where g[i] leaves its side, between low and high, found to rounding (Illinois, every third time by halves);
 * just beyond it, so that the next step starts on the other side.  Sets *found to 0 if g[i] is on its side at high. */
static ${name}_real ${name}_${method}_locate(${name}_${method}_work *w, ${name}_real t, const ${name}_real x[], int i, ${name}_real low, ${name}_real high${top_arg}, int *found)
{
  ${name}_real g[${many}], a = w->g[0][i], b, s;
  int last = 0;

  ${name}_${method}_advance(w, ${at}x, high${top_pass});
  ${name}_${method}_switches(w, t, high, g);
  b = g[i];
  *found = !${name}_stays(g${w_sides}, i);
  if (!*found) return high;
  if (low > ${zero} || low < ${zero}) {
    ${name}_${method}_advance(w, ${at}x, low${top_pass});
    ${name}_${method}_switches(w, t, low, g);
    if (${name}_stays(g${w_sides}, i)) {
      a = g[i];
    } else {
      high = low;
      b = g[i];
      low = ${zero};
    }
  }
  for (int n = 0; n < ${most_halvings} && (t + low < t + high || t + low > t + high); n++) { /* some 10 times */
    s = low + (high - low)*(a/(a - b));
    if (n % 3 == 2 || !((s > low && s < high) || (s < low && s > high))) s = low + ${half}*(high - low);
    if (!((s > low && s < high) || (s < low && s > high))) break;
    ${name}_${method}_advance(w, ${at}x, s${top_pass});
    ${name}_${method}_switches(w, t, s, g);
    if (${name}_stays(g${w_sides}, i)) {
      low = s;
      a = g[i];
      if (last > 0) b *= ${half};
      last = 1;
    } else {
      high = s;
      b = g[i];
      if (last < 0) a *= ${half};
      last = -1;
    }
  }
  ${name}_${method}_advance(w, ${at}x, high${top_pass});
  return high;
}

/* Shortens the step to its first corner, whose number comes back, or -1 where there is none; -2: to be tried again, as h is shorter
%% if has_sides then
 * or a side another one.  Where both sides of a sign push back to 0 there is no motion on either, and h becomes 0 in the end. */
%% else
 * now. */
%% end
static int ${name}_${method}_first_corner(${name}_${method}_work *w, ${name}_real t, const ${name}_real x[], ${name}_real *h${top_arg})
{
  const ${name}_real whole = *h;
  ${name}_real known[${own}]; /* the part of it in which each is on its side, whatever the nodes say */
  int event = -1, found;

%% if bends then
  w->reach = whole;
%% end
  if (!(${fabs}(whole) > ${name}_time_rounding(t, whole, &w->o))) return -1; /* too short to tell */
  for (int tries = 0; tries < ${most_tries}; tries++) { /* mostly once: where there is no corner */
    ${name}_real low = ${zero}, high = ${two}, a, b, rounding;
    int first = -1, apart;

    ${name}_${method}_sample(w, t, x, *h${top_pass});
    if (tries == 0 && !${name}_step_fits(t, h, w->g, ${own}, known, &w->o)) return -2;
    for (int i = 0; i < ${own}; i++) {
      const int last = i == event ? ${looks_less} : ${looks}; /* the step ends there */

      if (!w->o.noise[i] && ${name}_leaves(w->g, &w->o, i, last, known[i]*(whole/ *h), &a, &b) && b < high) {
        first = i;
        low = a;
        high = b;
      }
    }
    if (first < 0) return event;
    a = ${name}_${method}_locate(w, t, x, first, low**h, high**h${top_pass}, &found);
    rounding = ${name}_time_rounding(t, a, &w->o);
    if (!found) {
      known[first] = (${fabs}(a) + rounding)/${fabs}(whole);
      ${name}_${method}_advance(w, ${at}x, *h${top_pass});
      continue;
    }
    apart = ${fabs}(*h - a) > rounding && ${fabs}(a) > rounding;
    if (event < 0 || apart || ${fabs}(a) < ${fabs}(*h)) *h = a;
    if (!apart) return first;
    event = first;
  }
  *h *= ${half};
  return -2;
}

/* The step from x at t, of h or less, on these sides: 1; 0, and h is shorter: its error was too large; -1: there is none.
 * factor: by what the next one may be longer. */
static int ${name}_${method}_attempt(${name}_${method}_work *w, ${at_arg}const ${name}_real x[], ${name}_real *h, ${name}_real tolerance${top_arg}, ${name}_real *factor)
{
%% if taylor then
  *factor = ${four};
  if (tolerance > ${zero}) {
    *h = ${name}_taylor_limit(${name}_taylor_size(w->c, top, tolerance < ${finest} ? tolerance : ${finest}, tolerance/${fabs}(w->o.span)), *h);
%%   if has_roots then
  } else if (${name}_taylor_lost(w->c, top, *h)) { /* near rest the series does not reach so far */
    *h = ${name}_taylor_limit(${name}_taylor_size(w->c, top, ${finest}, ${finest}/${fabs}(w->o.span)), *h);
%%   end
  }
%%   if has_roots then
  *h = ${name}_taylor_corner(w->c, top, *h);
%%   end
  ${name}_taylor_advance(w, x, *h, top);
  for (int k = 0; k < ${upper}_NX; k++) {
    if (!(w->y[k] - w->y[k] == ${zero})) return -1;
  }
%% else
  ${name}_real r;

  *factor = ${four};
  ${name}_${method}_advance(w, t, x, *h);
  if (!(tolerance > ${zero})) return 1;
  r = ${name}_${method}_norm(${way_norm})/tolerance;
  *factor = ${name}_growth(r);
  if (!(r <= ${one})) {
    if (!(t + *h > t || t + *h < t)) return -1;
    *h *= *factor < ${one} ? *factor : ${half};
    return 0;
  }
%% end
  return 1;
}

%% if keeps then
%%   if has_sides and bends then
/* Is no corner within the step, by the cubic?  Each g with a side is affine in state and time, so it lies between its values at
 * the four points of Bezier's form, x, x + h v0/3, y - h v1/3 and y.  And each speed keeps half its size: |s| is at least what
 * it was less what it changes by.  Without rates the g of a speed is its square. */
%%   elseif has_sides then
/* Is no corner within the step, by the cubic?  Each g is affine in state and time, so it lies between its values at the four
 * points of Bezier's form, x, x + h v0/3, y - h v1/3 and y. */
%%   else
/* Does each speed keep half its size over the step, by the cubic?  |s| is at least what it was less what it changes by; so it
 * does not fall to nothing, and need not be looked at.  Without rates a g is the speed's square. */
%%   end
static int ${name}_${method}_keeps(${name}_${method}_work *w, ${name}_real t, const ${name}_real x[], ${name}_real h)
{
%%   if bends then
  ${name}_real none[${upper}_NX], d[${upper}_NX], before[${many}], change[${many}];
%%   end
%%   if has_sides then
  ${name}_real z[4][${upper}_NX], g[${many}];
%%   end

%%   if rosenbrock then
  ${name}_${rates}(w->m, t + h, w->y, w->u${w_sides}, w->v1);
%%   end
  for (int n = 0; n < ${upper}_NX; n++) {
%%   if bends then
    const ${name}_real rise = w->y[n] - x[n], a = h*w->v0[n] - rise, b = rise - h*w->v1[n];

    none[n] = ${zero};
    d[n] = ${fabs}(rise) + ${quarter}*(${fabs}(a) + ${fabs}(b)); /* at least all that the cubic moves */
%%   end
%%   if has_sides then
    z[0][n] = x[n];
    z[1][n] = x[n] + h/${three}*w->v0[n];
    z[2][n] = w->y[n] - h/${three}*w->v1[n];
    z[3][n] = w->y[n];
%%   end
  }
%%   if bends then
  ${name}_switches(w->m, t, x, none, w->u${w_sides}, before);
  ${name}_switches(w->m, t, d, none, w->u${w_sides}, change);
  for (int i = ${smooth}; i < ${many}; i++) {
    if (!(change[i] < ${quarter}*before[i])) return 0;
  }
%%   end
%%   if has_sides then
  for (int k = 0; k < 4; k++) {
    ${name}_switches(w->m, t + h*(${name}_real)k/${three}, z[k]${none_rates}, w->u${w_sides}, g);
    for (int i = 0; i < ${smooth}; i++) {
      if (w->o.at_zero[i] || w->o.noise[i] || !(g[i]*w->o.${array}[i] > ${zero})) return 0;
    }
  }
%%   end
  return 1;
}

%% end
/* The step, shortened to its first corner, and the sides behind that: 1; 0: to be tried again; -1: there is none. */
static int ${name}_${method}_end_at_corner(${name}_${method}_work *w, ${name}_real t, const ${name}_real x[], ${name}_real *h${top_arg}, ${name}_real *factor)
{
  const ${name}_real tried = *h;
%% if keeps then
  int event = -1, status;

  if (!${name}_${method}_keeps(w, t, x, *h)) { /* rare: a corner may be near */
    event = ${name}_${method}_first_corner(w, t, x, h);
  }
%% else
  const int event = ${name}_${method}_first_corner(w, t, x, h${top_pass});
  int status;

%% end
%% if adaptive then
  w->fresh = event != -1; /* on other sides */
%% end
  if (event == -2) return t + *h > t || t + *h < t ? 0 : -1;
%% if has_sides then
  if (event >= 0) ${name}_${method}_switches(w, t, *h, w->g[${looks}]);
  status = ${name}_corners_after(t, *h, w->g[${looks}], event, &w->o);
%% else
  status = ${name}_corners_after(t, *h, event, &w->o);
%% end
  if (status < 0) return -1;
  if (event >= 0) *factor = tried/ *h;
  if (event >= 0 && status == 0) {
    *h = tried;
    return 0;
  }
  if (w->o.halved > 0 && *factor > ${one}) *factor = ${one};
%% if has_sides then
  w->o.wrong = w->o.halved = 0;
%% else
  w->o.halved = 0;
%% end
  return 1;
}

/* The step is taken. */
static void ${name}_${method}_accept(${name}_${method}_work *w, ${name}_real x[])
{
%% if taylor then
  for (int k = 0; k < ${upper}_MOVING; k++) { /* Kahan: what rounding took from the last sum is in the next one */
    const int n = ${name}_taylor_moving[k];

    w->lost[k] = (w->d[k] + w->lost[k]) - (w->y[n] - w->c[0][k]);
  }
%% elseif adaptive then
  for (int k = 0; k < ${count}; k++) w->k1[k] = w->k7[k];
  for (int k = 0; k < ${upper}_NX; k++) w->v0[k] = w->v1[k];
%% end
  for (int k = 0; k < ${upper}_NX; k++) x[k] = w->y[k];
}

/* From t0 to t1 - lost as in ${name}_${method}_run, with the tolerance 0 from corner to corner; once: at most one step.
 * reached: where it ends. */
static int ${name}_${method}_integrate(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real lost, ${name}_real tolerance, int most${top_arg}, int once, ${name}_real *reached)
{
  ${name}_${method}_work w;
  ${name}_real t = t0, h = t1 - t0;

  w.m = m;
  w.u = u;
%% if taylor then
  for (int k = 0; k < ${upper}_MOVING; k++) w.lost[k] = ${zero}*(${name}_real)k; /* 0, and no call of memset */
%% elseif adaptive then
  w.fresh = 1;
%% end
%% if has_sides then
  ${name}_corners_at_start(m, t, x, u, h, &w.o);
%% else
  ${name}_corners_at_start(h, &w.o);
%% end
  for (int steps = 0; steps < most; steps++) { /* mostly once, for a single step */
%% if has_knots then
    const ${name}_real end = ${name}_knot(m, t, t1), left = (end - t) - lost, whole = h; /* from corner to corner of tables */
%% else
    const ${name}_real left = (t1 - t) - lost;
%% end
    ${name}_real factor, next_t;
    int last, status;

    if (!(left > ${zero} || left < ${zero})) return steps;
    if (!(${fabs}(h) < ${fabs}(left))) h = left;
%% if taylor then
    ${name}_taylor_terms(m, t, x, u, top, w.c${knot_side}${terms_sides});
%%   if has_roots then
    if (${name}_taylor_lost(w.c, top, ${zero})) {
      h = ${name}_taylor_leave(m, t, x, u, h);
      if (!(t + h > t || t + h < t)) return -1;
      t += h;
      lost = ${zero};
      for (int k = 0; k < ${upper}_MOVING; k++) w.lost[k] = ${zero};
      h = t1 - t;
      continue;
    }
%%   end
%% elseif adaptive then
    if (w.fresh) {
      w.fresh = 0;
      ${name}_${rates}(m, t, x, u${own_sides}, w.v0);
      for (int k = 0; k < ${count}; k++) w.k1[k] = w.v0[${name}_adaptive_moving[k]];
%%   if rests then
      for (int k = 0; k < ${upper}_NX; k++) w.v1[k] = w.v0[k]; /* of the states that do not move */
%%   end
    }
%% else
    ${name}_${rates}(m, t, x, u${own_sides}, w.v0);
%% end
    status = ${name}_${method}_attempt(&w, ${at}x, &h, tolerance${top_pass}, &factor);
    if (status > 0) status = ${name}_${method}_end_at_corner(&w, t, x, &h${top_pass}, &factor);
    if (status < 0) return -1;
    if (status == 0) continue;
    ${name}_${method}_accept(&w, x);
    last = !(h < left || h > left);
    *reached = last ? t1 : t + h;
%% if has_knots then
    if (once) return steps + 1;
${taken}
%% else
    if (once || last) return steps + 1;
    next_t = t + (h + lost);
    lost = (h + lost) - (next_t - t);
    t = next_t;
    h *= factor;
%% end
  }
  return -1;
}

void ${name}_${method}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  const ${name}_real end = t + h;
  ${name}_real reached;

  if (${name}_${method}_integrate(m, t, x, u, end, (end - t) - h, ${zero}, ${most_parts}${top_full}, 0, &reached) < 0) {
    for (int k = 0; k < ${upper}_NX; k++) x[k] *= ${zero}*${huge}; /* no number */
  }
}
%% if taylor then

${name}_real ${name}_taylor_adapt(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real tolerance)
{
  const ${name}_real end = t + h;
  ${name}_real reached = t;

  (void)${name}_taylor_integrate(m, t, x, u, end, (end - t) - h, tolerance, ${most_parts}, ${upper}_ORDER, 1, &reached);
  return reached - t;
}
%% end

int ${name}_${method}_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most)
{
  ${name}_real reached;

  return ${name}_${method}_integrate(m, t0, x, u, t1, ${zero}, tolerance, most${top_own}, 0, &reached);
}
%% if first then

void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_${method}_step(m, t, x, u, h);
}
%% end
