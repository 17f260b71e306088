%% -- taylor.c -- the Taylor series stepper: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- Taylor series: Jorba, Zou 2005, Experimental Mathematics 14, 99; Knuth, TAOCP 2, 4.7 ---- */

/* Not inlined, the loops of products are put into vector registers as a whole. */
#if defined __GNUC__
#define ${upper}_APART static __attribute__((noinline))
#else
#define ${upper}_APART static
#endif

%% for k, level in ipairs(taylor_levels) do
%%   if level.has_lanes then
/* term n of the products of level ${level.number}; the newest factors come last, so that the sum need not wait for them */
${upper}_APART void ${name}_products${level.number}(int n, const ${name}_real a[][${taylor_lanes}], const ${name}_real b[][${taylor_lanes}], ${name}_real p[])
{
%%     for _, lane in ipairs(level.lanes) do
  ${name}_real s${lane.index} = ${zero}; /* ${lane.about} */
%%     end
  int j;

  for (j = 1; j < n; j++) {
    const ${name}_real *A = a[j], *B = b[n - j];

%%     for _, lane in ipairs(level.lanes) do
    s${lane.index} += A[${lane.index}]*B[${lane.index}];
%%     end
  }
%%     for _, lane in ipairs(level.lanes) do
  p[${lane.index}] = s${lane.index};
%%     end
}

%%   end
%% end
void ${name}_taylor_series(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[],
                  ${name}_real c[][${upper}_MOVING])
{
%% if taylor_has_lanes then
  ${name}_real a[${upper}_ORDER + 1][${taylor_lanes}], b[${upper}_ORDER + 1][${taylor_lanes}], p[${taylor_lanes}];
%% end
  ${name}_real y[${taylor_places}];
%% for _, line in ipairs(taylor_outer) do
  ${line}
%% end
  int n, l;

%% for _, line in ipairs(taylor_voids) do
  ${line}
%% end
%% for _, line in ipairs(taylor_start) do
  ${line}
%% end
  for (l = 0; l < ${upper}_MOVING; l++) c[0][l] = y[l];
%% for _, level in ipairs(taylor_levels) do
%%   for _, lane in ipairs(level.lanes) do
  a[0][${lane.index}] = ${lane.first};
  b[0][${lane.index}] = ${lane.right};
%%   end
%% end
  {
%% for _, line in ipairs(taylor_next) do
    ${line}
%% end
  }
  for (l = 0; l < ${upper}_MOVING; l++) c[1][l] = y[l];

  for (n = 1; n < ${upper}_ORDER; n++) {
    const ${name}_real after = ${one}/(${name}_real)(n + 1);
%% if taylor_order then
    const ${name}_real order = (${name}_real)n;
%% end
%% for _, line in ipairs(taylor_loads) do
    ${line}
%% end

%% for k, level in ipairs(taylor_levels) do
%%   if level.has_lanes then
%%     for _, z in ipairs(level.unknown) do
    y[${z}] = ${zero};
%%     end
%%     for _, lane in ipairs(level.lanes) do
    a[n][${lane.index}] = ${lane.left};
    b[n][${lane.index}] = ${lane.right};
%%     end
    ${name}_products${level.number}(n, (const ${name}_real(*)[${taylor_lanes}])a, (const ${name}_real(*)[${taylor_lanes}])b, p);
%%     for _, lane in ipairs(level.lanes) do
    p[${lane.index}] += a[0][${lane.index}]*${lane.right} + ${lane.left}*b[0][${lane.index}];
%%     end
%%   end
%%   for _, line in ipairs(level.lines) do
    ${line}
%%   end
%%   for _, line in ipairs(level.known) do
    ${line}
%%   end
%% end
%% for _, line in ipairs(taylor_after) do
    ${line}
%% end
    for (l = 0; l < ${upper}_MOVING; l++) c[n + 1][l] = y[l];
  }
}

%% if taylor_axis then
/* The series run in a frame that turns at this rate about the symmetry axis, rad/s, relative to the body: the body and its
 * torque look alike from all sides of it, so the equations keep their form, and what is fixed in space moves slower. */
static ${name}_real ${name}_taylor_spin(const ${name}_model *m, const ${name}_real x[])
{
%% for _, line in ipairs(taylor_spin) do
  ${line}
%% end
}

/* From that frame after the angle f back to the body: what c[0] + d moves by then. */
static void ${name}_taylor_back(${name}_real c[][${upper}_MOVING], ${name}_real f, ${name}_real d[${upper}_MOVING])
{
  const ${name}_real S = ${sin}(${half}*f), C = ${cos}(${half}*f), V = ${two}*S*C; /* sin f */
  ${name}_real r, s;                                        /* cos of an angle less 1 is -2 sin^2 of its half */
  const ${name}_real half = ${sin}(${half}*${half}*f), D = -${two}*half*half, W = -${two}*S*S;

%% for _, r in ipairs(taylor_turns) do
  r = c[0][${r.a}] + d[${r.a}];
  s = c[0][${r.b}] + d[${r.b}];
  d[${r.a}] += ${r.one}*r + ${r.sine}*s;
  d[${r.b}] += ${r.one}*s - ${r.sine}*r;
%% end
}

%% end
/* what the states move by in the time s: s (c[1] + s (c[2] + ...)) */
static void ${name}_taylor_move(const ${name}_model *m, ${name}_real c[][${upper}_MOVING], ${name}_real s, const ${name}_real x[],
                       ${name}_real d[${upper}_MOVING])
{
%% for _, s in ipairs(taylor_states) do
  ${name}_real s${s.index} = c[${upper}_ORDER][${s.index}];
%% end
  int n;

  for (n = ${upper}_ORDER - 1; n > 0; n--) {
%% for _, s in ipairs(taylor_states) do
    s${s.index} = c[n][${s.index}] + s*s${s.index};
%% end
  }
%% for _, s in ipairs(taylor_states) do
  d[${s.index}] = s*s${s.index};
%% end
%% if taylor_axis then
  ${name}_taylor_back(c, ${name}_taylor_spin(m, x)*s, d);
%% else
  (void)m;
  (void)x;
%% end
}

void ${name}_taylor_at(const ${name}_model *m, ${name}_real c[][${upper}_MOVING], ${name}_real s, ${name}_real x[])
{
  ${name}_real d[${upper}_MOVING];

  ${name}_taylor_move(m, c, s, x, d);
%% for _, s in ipairs(taylor_states) do
  x[${s.name}] = c[0][${s.index}] + d[${s.index}];
%% end
}

/* The move over the step h; one Newton step for 1/|q| from the q that comes in, so that |q| cannot drift. */
static void ${name}_taylor_step_by(const ${name}_model *m, ${name}_real c[][${upper}_MOVING], ${name}_real h, const ${name}_real x[],
                          ${name}_real d[${upper}_MOVING])
{
%% if taylor_attitude then
  const ${name}_real n = ${half} - ${half}*(c[0][0]*c[0][0] + c[0][1]*c[0][1] + c[0][2]*c[0][2] + c[0][3]*c[0][3]);
  int i;

%% end
  ${name}_taylor_move(m, c, h, x, d);
%% if taylor_attitude then
  for (i = 0; i < 4; i++) d[i] += n*(c[0][i] + d[i]);
%% end
}

void ${name}_taylor_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_real c[${upper}_ORDER + 1][${upper}_MOVING], d[${upper}_MOVING];

  ${name}_taylor_series(m, t, x, u, c);
  ${name}_taylor_step_by(m, c, h, x, d);
%% for _, s in ipairs(taylor_states) do
  x[${s.name}] += d[${s.index}];
%% end
}

/* log2 |x| to 0.09, as cheap as the step's size needs it; very small for 0 */
static ${name}_real ${name}_size(${name}_real x)
{
  int e;
  const ${name}_real f = ${frexp}(${fabs}(x), &e);

  return f > ${zero} ? (${name}_real)(e - 2) + ${two}*f : -${eight}*${eight}*${eight}*${eight};
}

/* The largest step at which the last two terms are below the tolerance times the first ones of their kind of state:
 * |c[n]| h^n <= tolerance |c[i]| h^i for some i < 3. */
static ${name}_real ${name}_taylor_size(${name}_real c[][${upper}_MOVING], ${name}_real tolerance)
{
  static const struct {
    int first, last; /* states of one kind */
  } kind[] = {
%% for _, k in ipairs(taylor_kinds) do
    {${k.first}, ${k.last}}, /* ${k.about} */
%% end
  };
  const ${name}_real log_tolerance = ${name}_size(tolerance);
  ${name}_real log_h = ${eight}*${eight};
  unsigned int g;
  int i, k, n;

  for (g = 0; g < sizeof kind/sizeof kind[0]; g++) {
    ${name}_real head[3], tail;

    for (i = 0; i < 3; i++) {
      head[i] = ${zero};
      for (k = kind[g].first; k < kind[g].last; k++) head[i] = ${fabs}(c[i][k]) > head[i] ? ${fabs}(c[i][k]) : head[i];
      head[i] = ${name}_size(head[i]);
    }
    for (n = ${upper}_ORDER - 1; n <= ${upper}_ORDER; n++) {
      ${name}_real best = -${eight}*${eight};

      tail = ${zero};
      for (k = kind[g].first; k < kind[g].last; k++) tail = ${fabs}(c[n][k]) > tail ? ${fabs}(c[n][k]) : tail;
      tail = ${name}_size(tail);
      for (i = 0; i < 3 && i < n; i++) {
        const ${name}_real at = (log_tolerance + head[i] - tail)/(${name}_real)(n - i);

        best = at > best ? at : best;
      }
      log_h = best < log_h ? best : log_h;
    }
  }
  return ${exp}(log_h*${log2_high});
}

static ${name}_real ${name}_taylor_limit(${name}_real size, ${name}_real h)
{
  return size < ${fabs}(h) ? h < ${zero} ? -size : size : h;
}

${name}_real ${name}_taylor_adapt(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real tolerance)
{
  ${name}_real c[${upper}_ORDER + 1][${upper}_MOVING], d[${upper}_MOVING];

  ${name}_taylor_series(m, t, x, u, c);
  h = ${name}_taylor_limit(${name}_taylor_size(c, tolerance), h);
  ${name}_taylor_step_by(m, c, h, x, d);
%% for _, s in ipairs(taylor_states) do
  x[${s.name}] += d[${s.index}];
%% end
  return h;
}

int ${name}_taylor_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most)
{
  static const int moving[${upper}_MOVING] = {
%% for _, s in ipairs(taylor_states) do
    ${s.name},
%% end
  };
  ${name}_real c[${upper}_ORDER + 1][${upper}_MOVING], d[${upper}_MOVING], lost[${upper}_MOVING + 1] = {${zero}};
  ${name}_real t = t0;
  int steps, k;

  for (steps = 0; steps < most; steps++) {
    const ${name}_real left = (t1 - t) - lost[${upper}_MOVING];
    ${name}_real h, next_t;

    if (!(left > ${zero} || left < ${zero})) return steps;
    ${name}_taylor_series(m, t, x, u, c);
    h = ${name}_taylor_limit(${name}_taylor_size(c, tolerance), left);
    if (!(h > ${zero} || h < ${zero})) return -1;
    ${name}_taylor_step_by(m, c, h, x, d);
    for (k = 0; k < ${upper}_MOVING; k++) { /* Kahan: what rounding took from the last sum is in the next one */
      const ${name}_real add = d[k] + lost[k], sum = c[0][k] + add;

      if (!(sum - sum == ${zero})) return -1;
      lost[k] = add - (sum - c[0][k]);
      x[moving[k]] = sum;
    }
    h += lost[${upper}_MOVING];
    next_t = t + h;
    lost[${upper}_MOVING] = h - (next_t - t);
    t = next_t;
  }
  return -1;
}
%% if first then

void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_taylor_step(m, t, x, u, h);
}
%% end
