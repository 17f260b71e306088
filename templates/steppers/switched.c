%% -- switched.c -- steps of a method that end at the corners of the equations: part of scene.c.  SPDX-License-Identifier: MIT-0
/* Where a step of ${method} leads: y at its end, and what it is made of. */
typedef struct ${name}_${method}_way {
%% if taylor then
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW], lost[${upper}_MOVING];
%% elseif adaptive then
  ${name}_real k1[${count}], k7[${count}], out[${count}]${room};
%% elseif slides then
  ${name}_real out[${upper}_NX];
%% end
%% if not taylor then
  ${name}_real error[${count}], v0[${upper}_NX], v1[${upper}_NX];
%% elseif bends then
  ${name}_real v1[${upper}_NX];
%% end
%% if bends then
  ${name}_real reach; /* the step that was tried: what falls within it counts */
%% end
  ${name}_real y[${upper}_NX], g[${looks} + 1][${many}];
} ${name}_${method}_way;

%% if taylor then
static const int ${name}_taylor_moving[${upper}_MOVING] = {
%%   for _, s in ipairs(states) do
  ${s.name},
%%   end
};

/* The state after the part s of the step that the series is for. */
static void ${name}_taylor_within(const ${name}_model *m, const ${name}_real x[], ${name}_real s, ${name}_${method}_way *w${top_arg}, ${name}_real d[], ${name}_real y[])
{
  ${name}_taylor_step_by(m, w->c, top, s, x, d);
  for (int k = 0; k < ${upper}_NX; k++) y[k] = x[k];
  for (int k = 0; k < ${upper}_MOVING; k++) y[${name}_taylor_moving[k]] = w->c[0][k] + (d[k] + w->lost[k]);
}

%% end
%% if taylor and bends then
/* The rates after the part s. */
static void ${name}_taylor_slopes(const ${name}_taylor_way *w, ${name}_real s, ${name}_real v[], int top)
{
  for (int k = 0; k < ${upper}_NX; k++) v[k] = ${zero};
  for (int n = top; n > 0; n--) {
    for (int k = 0; k < ${upper}_MOVING; k++) {
      const int i = ${name}_taylor_moving[k];

      v[i] = s*v[i] + (${name}_real)n*w->c[n][k];
    }
  }
}

%% end
/* What a step from x at t on these sides begins with. */
static void ${name}_${method}_begin(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, const ${name}_real ${array}[], ${name}_${method}_way *w${top_arg})
{
%% if taylor then
%%   if has_knots then
  ${name}_taylor_terms(m, t, x, u, top, w->c, t + ${half}*h, ${array});
%%   else
  (void)h;
  ${name}_taylor_terms(m, t, x, u, top, w->c, ${array});
%%   end
%% else
  (void)h;
  ${name}_side_rates(m, t, x, u, ${array}, w->v0);
%%   if adaptive then
  for (int k = 0; k < ${count}; k++) w->k1[k] = w->v0[${name}_adaptive_moving[k]];
%%   end
%% end
}

/* The step over h. */
static void ${name}_${method}_go(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, const ${name}_real ${array}[], ${name}_${method}_way *w${top_arg})
{
%% if taylor then
  (void)t;
  (void)u;
  (void)${array};
  ${name}_taylor_within(m, x, h, w${top_pass}, w->d, w->y);
%%   if bends then
  ${name}_taylor_slopes(w, h, w->v1, top);
%%   end
%% elseif adaptive then
  ${name}_adaptive_trial(m, t, x, u, h, w->k1, ${array}, w->out, w->k7, w->error${way_turn});
  for (int k = 0; k < ${upper}_NX; k++) w->y[k] = x[k];
  ${name}_adaptive_take(w->out${way_turn}, w->y);
%% elseif slides then
  ${name}_real z[${upper}_NX];

  ${name}_rosenbrock_turned(m, t, x, u, ${array}, ${one}, z);
  ${name}_rosenbrock_trial(m, t, z, u, h, ${array}, w->out, w->error);
  ${name}_rosenbrock_turned(m, t + h, w->out, u, ${array}, -${one}, w->y);
%% else
  ${name}_rosenbrock_trial(m, t, x, u, h, ${array}, w->y, w->error);
%% end
}

/* The functions g at the end of the step. */
static void ${name}_${method}_end(const ${name}_model *m, ${name}_real t, const ${name}_real u[], ${name}_real h, const ${name}_real ${array}[], ${name}_${method}_way *w, ${name}_real g[])
{
%% if bends then
  ${name}_real v[${upper}_NX];

%% end
%% if not taylor then
  ${name}_side_rates(m, t + h, w->y, u, ${array}, w->v1);
%% end
%% if bends then
  for (int k = 0; k < ${upper}_NX; k++) v[k] = w->reach*w->v1[k];
%% end
  ${name}_switches(m, t + h, w->y${end_rates}, u, ${array}, g);
}

/* The functions g along the step${by_cubic}. */
static void ${name}_${method}_look(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, const ${name}_real ${array}[], ${name}_${method}_way *w${top_arg})
{
%% if taylor then
%%   if bends then
  ${name}_real y[${upper}_NX], v[${upper}_NX], d[${upper}_ROW];
%%   else
  ${name}_real y[${upper}_NX], d[${upper}_ROW];
%%   end

%% else
%%   if bends then
  ${name}_real y[${upper}_NX], v[${upper}_NX];
%%   else
  ${name}_real y[${upper}_NX];
%%   end

%% end
  ${name}_${method}_end(m, t, u, h, ${array}, w, w->g[${looks}]);
  for (int k = 0; k < ${looks}; k++) {
    const ${name}_real s = ${name}_looks[k];

%% if taylor then
    ${name}_taylor_within(m, x, s*h, w${top_pass}, d, y);
%%   if bends then
    ${name}_taylor_slopes(w, s*h, v, top);
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
    ${name}_switches(m, t + s*h, y${look_rates}, u, ${array}, w->g[k]);
  }
}

/* The step that ends where g[i] leaves its side, between low and high, found to rounding (Illinois, every third time by halves);
 * just beyond it, so that the next step starts on the other side.  Sets *found to 0 if g[i] is on its side at high. */
static ${name}_real ${name}_${method}_meet(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], int i, ${name}_real low, ${name}_real high, const ${name}_real ${array}[], ${name}_${method}_way *w${top_arg}, int *found)
{
  ${name}_real g[${many}], a = w->g[0][i], b, s;
  int last = 0;

  ${name}_${method}_go(m, t, x, u, high, ${array}, w${top_pass});
  ${name}_${method}_end(m, t, u, high, ${array}, w, g);
  b = g[i];
  *found = !${name}_stays(b, ${array}[i], i);
  if (!*found) return high;
  if (low > ${zero} || low < ${zero}) {
    ${name}_${method}_go(m, t, x, u, low, ${array}, w${top_pass});
    ${name}_${method}_end(m, t, u, low, ${array}, w, g);
    if (${name}_stays(g[i], ${array}[i], i)) {
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
    ${name}_${method}_go(m, t, x, u, s, ${array}, w${top_pass});
    ${name}_${method}_end(m, t, u, s, ${array}, w, g);
    if (${name}_stays(g[i], ${array}[i], i)) {
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
  ${name}_${method}_go(m, t, x, u, high, ${array}, w${top_pass});
  return high;
}

%% if not taylor then
/* the largest error of all kinds of state */
static ${name}_real ${name}_${method}_error(${given_args}const ${name}_real x[], const ${name}_${method}_way *w, ${name}_real h)
{
%%   if adaptive then
%%     if not has_floors then
  (void)h;
%%     end
  return ${name}_adaptive_norm(${norm_pass}x, w->out, w->error);
%%   else
  ${name}_real r = ${zero};
%%     if has_floors then
  ${name}_real least[${floors_count}];

  ${name}_floors(${floors_pass}, least);
%%     else

  (void)h;
%%     end
%%     for _, k in ipairs(kinds) do
  r = ${name}_rosenbrock_worse(x, w->y, w->error, ${k.first}, ${k.last}, ${k.least}r); /* ${k.about} */
%%     end
  return r;
%%   end
}

%% end
/* Shortens the step to its first corner, whose number comes back, or -1 where there is none; -2: to be tried again, as h is shorter
 * or a side another one.  Where both sides of a sign push back to 0 there is no motion on either, and h becomes 0 in the end. */
static int ${name}_${method}_first(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real *h, ${name}_real ${array}[], ${name}_corners *o, ${name}_${method}_way *w${top_arg})
{
  const ${name}_real whole = *h;
  ${name}_real known[${own}]; /* the part of it in which each is on its side, whatever the looks say */
  int event = -1, found;

%% if bends then
  w->reach = whole;
%% end
  if (!(${fabs}(whole) > ${name}_close(t, whole, o))) return -1; /* too short to tell */
  for (int tries = 0; tries < ${looks}*${own}; tries++) { /* some 1 times */
    ${name}_real low = ${zero}, high = ${two}, a, b;
    int first = -1, apart;

    ${name}_${method}_look(m, t, x, u, *h, ${array}, w${top_pass});
    if (tries == 0 && !${name}_sides_fit(t, h, w->g, ${array}, ${own}, known, o)) return -2;
    for (int i = 0; i < ${own}; i++) {
      const int last = i == event ? ${looks} - 1 : ${looks};

      if (!o->mute[i] && ${name}_left(w->g, ${array}, o->open, i, last, known[i]*(whole/ *h), &a, &b) && b < high) {
        first = i;
        low = a;
        high = b;
      }
    }
    if (first < 0) return event;
    a = ${name}_${method}_meet(m, t, x, u, first, low**h, high**h, ${array}, w${top_pass}, &found);
    if (!found) {
      known[first] = (${fabs}(a) + ${name}_close(t, a, o))/${fabs}(whole);
      ${name}_${method}_go(m, t, x, u, *h, ${array}, w${top_pass});
      continue;
    }
    apart = ${fabs}(*h - a) > ${name}_close(t, a, o) && ${fabs}(a) > ${name}_close(t, a, o);
    if (event < 0 || apart || ${fabs}(a) < ${fabs}(*h)) *h = a;
    if (!apart) return first;
    event = first;
  }
  *h *= ${half};
  return -2;
}

/* The trial from x at t, of h or less, on these sides: 1; 0, and h is shorter: tried in vain; -1: there is none.  factor: by what
 * the next one may be longer. */
static int ${name}_${method}_tried(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real *h, const ${name}_real ${array}[], ${name}_real tolerance, ${name}_real span, ${name}_real *factor, ${name}_${method}_way *w${top_arg})
{
%% if taylor then
  *factor = ${four};
  if (tolerance > ${zero}) {
    *h = ${name}_taylor_limit(${name}_taylor_size(w->c, top, tolerance < ${finest} ? tolerance : ${finest}, tolerance/${fabs}(span)), *h);
%%   if has_roots then
  } else if (${name}_taylor_lost(w->c, top, *h)) { /* near rest the series does not reach so far */
    *h = ${name}_taylor_limit(${name}_taylor_size(w->c, top, ${finest}, ${finest}/${fabs}(span)), *h);
%%   end
  }
%%   if has_roots then
  *h = ${name}_taylor_corner(w->c, top, *h);
%%   end
  ${name}_${method}_go(m, t, x, u, *h, ${array}, w${top_pass});
  for (int k = 0; k < ${upper}_NX; k++) {
    if (!(w->y[k] - w->y[k] == ${zero})) return -1;
  }
%% else
  const ${name}_real slope = ${n[3/16]}; /* a little less than 1/5 */
  ${name}_real r;

  (void)span;
  *factor = ${four};
  ${name}_${method}_go(m, t, x, u, *h, ${array}, w${top_pass});
  if (!(tolerance > ${zero})) return 1;
  r = ${name}_${method}_error(${given}x, w, *h)/tolerance;
  /* the next step is 7/8 r^(-3/16) as long, from an eighth to four times; what is not finite counts as an eighth */
  *factor = r > ${zero} ? ${exp}(-slope*${log}(r))*${n[7/8]} : ${eight};
  if (!(*factor > ${eighth})) *factor = ${eighth};
  if (*factor > ${four}) *factor = ${four};
  if (!(r <= ${one})) {
    if (!(t + *h > t || t + *h < t)) return -1;
    *h *= *factor < ${one} ? *factor : ${half};
    return 0;
  }
%% end
  return 1;
}

%% if keeps then
/* Does each speed keep half its size over the step, by the cubic?  |s| is at least what it was less what it changes by; so it
 * does not fall to nothing, and need not be looked at.  Without rates a g is the speed's square. */
static int ${name}_${method}_keeps(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, const ${name}_real ${array}[], ${name}_${method}_way *w)
{
  ${name}_real none[${upper}_NX], d[${upper}_NX], before[${many}], change[${many}];

  ${name}_side_rates(m, t + h, w->y, u, ${array}, w->v1);
  for (int n = 0; n < ${upper}_NX; n++) {
    const ${name}_real rise = w->y[n] - x[n], a = h*w->v0[n] - rise, b = rise - h*w->v1[n];

    none[n] = ${zero};
    d[n] = ${fabs}(rise) + ${quarter}*(${fabs}(a) + ${fabs}(b)); /* at least all that the cubic moves */
  }
  ${name}_switches(m, t, x, none, u, ${array}, before);
  ${name}_switches(m, t, d, none, u, ${array}, change);
  for (int i = 0; i < ${own}; i++) {
    if (!(change[i] < ${quarter}*before[i])) return 0;
  }
  return 1;
}

%% end
/* The trial, shortened to its first corner, and the sides behind that: 1; 0: to be tried again; -1: there is no step. */
static int ${name}_${method}_cut(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real *h, ${name}_real ${array}[], ${name}_real *factor, ${name}_corners *o, ${name}_${method}_way *w${top_arg})
{
  const ${name}_real tried = *h;
%% if keeps then
  int event = -1, status;

  if (!${name}_${method}_keeps(m, t, x, u, *h, ${array}, w)) { /* rare */
    event = ${name}_${method}_first(m, t, x, u, h, ${array}, o, w);
  }
%% else
  const int event = ${name}_${method}_first(m, t, x, u, h, ${array}, o, w${top_pass});
  int status;

%% end
  if (event == -2) return t + *h > t || t + *h < t ? 0 : -1;
  if (event >= 0) ${name}_${method}_end(m, t, u, *h, ${array}, w, w->g[${looks}]);
  status = ${name}_turn(t, *h, w->g[${looks}], ${array}, event, o);
  if (status < 0) return -1;
  if (event >= 0) *factor = tried/ *h;
  if (event >= 0 && status == 0) {
    *h = tried;
    return 0;
  }
  if (o->halved > 0 && *factor > ${one}) *factor = ${one};
  o->wrong = o->halved = 0;
  return 1;
}

/* The step is taken. */
static void ${name}_${method}_on(${name}_real x[], ${name}_${method}_way *w)
{
%% if taylor then
  for (int k = 0; k < ${upper}_MOVING; k++) { /* Kahan: what rounding took from the last sum is in the next one */
    const int n = ${name}_taylor_moving[k];

    w->lost[k] = (w->d[k] + w->lost[k]) - (w->y[n] - w->c[0][k]);
  }
%% end
  for (int k = 0; k < ${upper}_NX; k++) x[k] = w->y[k];
}

/* From t0 to t1 - lost as in ${name}_${method}_run, without a tolerance from corner to corner; once: at
 * most one step.  reached: where it ends. */
static int ${name}_${method}_through(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real lost, ${name}_real tolerance, int most${top_arg}, int once, ${name}_real *reached)
{
  ${name}_${method}_way w;
  ${name}_real ${array}[${many}], t = t0, h = t1 - t0;
  ${name}_corners o;

%% if taylor then
  for (int k = 0; k < ${upper}_MOVING; k++) w.lost[k] = ${zero}*(${name}_real)k; /* 0, and no call of memset */
%% end
  ${name}_sides(m, t, x, u, t1 - t0, ${array}, &o);
  for (int steps = 0; steps < most; steps++) { /* some 1 times */
%% if has_knots then
    const ${name}_real end = ${name}_knot(m, t, t1), left = (end - t) - lost, whole = h; /* from corner to corner of tables */
%% else
    const ${name}_real left = (t1 - t) - lost;
%% end
    ${name}_real factor, next_t;
    int last, status;

    if (!(left > ${zero} || left < ${zero})) return steps;
    if (!(${fabs}(h) < ${fabs}(left))) h = left;
    ${name}_${method}_begin(m, t, x, u, left, ${array}, &w${top_pass});
%% if taylor and has_roots then
    if (${name}_taylor_lost(w.c, top, ${zero})) {
      h = ${name}_taylor_leave(m, t, x, u, h);
      if (!(t + h > t || t + h < t)) return -1;
      t += h;
      lost = ${zero};
      for (int k = 0; k < ${upper}_MOVING; k++) w.lost[k] = ${zero};
      h = t1 - t;
      continue;
    }
%% end
    status = ${name}_${method}_tried(m, t, x, u, &h, ${array}, tolerance, t1 - t0, &factor, &w${top_pass});
    if (status > 0) status = ${name}_${method}_cut(m, t, x, u, &h, ${array}, &factor, &o, &w${top_pass});
    if (status < 0) return -1;
    if (status == 0) continue;
    ${name}_${method}_on(x, &w);
    last = !(h < left || h > left);
    *reached = last ? t1 : t + h;
    if (once) return steps + 1;
${taken}
  }
  return -1;
}

void ${name}_${method}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  const ${name}_real end = t + h;
  ${name}_real reached;

  if (${name}_${method}_through(m, t, x, u, end, (end - t) - h, ${zero}, ${most_parts}${top_full}, 0, &reached) < 0) {
    for (int k = 0; k < ${upper}_NX; k++) x[k] *= ${zero}*${huge}; /* no number */
  }
}
%% if taylor then

${name}_real ${name}_taylor_adapt(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real tolerance)
{
  const ${name}_real end = t + h;
  ${name}_real reached = t;

  (void)${name}_taylor_through(m, t, x, u, end, (end - t) - h, tolerance, ${most_parts}, ${upper}_ORDER, 1, &reached);
  return reached - t;
}
%% end

int ${name}_${method}_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most)
{
  ${name}_real reached;

  return ${name}_${method}_through(m, t0, x, u, t1, ${zero}, tolerance, most${top_own}, 0, &reached);
}
%% if first then

void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_${method}_step(m, t, x, u, h);
}
%% end
