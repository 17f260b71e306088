%% -- taylor.c -- the Taylor series stepper: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- Taylor series: Jorba, Zou 2005, Experimental Mathematics 14, 99; Knuth, TAOCP 2, 4.7 ---- */

%% if taylor_packed then
/* Rows of vectors for a host: compile with -D${upper}_VECTOR and -march=native; the same recurrences, summed in another order. */
#if defined ${upper}_VECTOR && \
  (defined __clang__ || (defined __GNUC__ && __GNUC__ >= 12)) && \
  (defined __AVX512F__ || (defined __AVX__ && (defined __clang__ || ${taylor_float})))
#define ${upper}_PACKED
#endif

#if defined ${upper}_PACKED
typedef ${name}_real ${name}_pack __attribute__((vector_size(${upper}_ROW*sizeof(${name}_real))));
typedef ${name}_real ${name}_row __attribute__((vector_size(${upper}_ROW*sizeof(${name}_real)), aligned(sizeof(${name}_real)), may_alias));

%%   if taylor_top then
#endif

${taylor_top_text}
%%   else
/* the coefficients up to c[top]; a and b are the factors of the products, plane by plane */
static void ${name}_taylor_terms(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], int top,
                   ${name}_real c[][${upper}_ROW]${taylor_side})
{
%%   for _, p in ipairs(taylor_planes) do
  ${name}_pack a${p.index}[${upper}_ORDER + 1], b${p.index}[${upper}_ORDER + 1];
%%   end
  ${name}_real y[${upper}_ROW] = {${zero}};
  ${name}_pack Y;
  int n, j;
%%   for _, line in ipairs(taylor_outer) do
  ${line}
%%   end
%%   for _, line in ipairs(taylor_voids) do
  ${line}
%%   end
%%   for _, line in ipairs(taylor_start_packed) do
  ${line}
%%   end
%%   for _, line in ipairs(taylor_factors) do
  ${line}
%%   end
%%   for _, p in ipairs(taylor_planes) do
  const ${name}_pack C${p.index} = {${p.factors}};
%%   end
%%   for _, p in ipairs(taylor_linear) do
  const ${name}_pack D${p.index} = {${p.factors}};
%%   end
%%   for _, p in ipairs(taylor_rest) do
  const ${name}_pack E = {${p.factors}};
%%   end

  Y = (${name}_pack){y[0], y[1], y[2], y[3], y[4], y[5], y[6], y[7]};
  *(${name}_row *)c[0] = Y;
%%   for _, p in ipairs(taylor_planes) do
  a${p.index}[0] = __builtin_shufflevector(Y, Y, ${p.a});
  b${p.index}[0] = __builtin_shufflevector(Y, Y, ${p.b});
  const ${name}_pack A${p.index} = C${p.index}*a${p.index}[0], B${p.index} = C${p.index}*b${p.index}[0];
%%   end
  Y = ${taylor_first_row};
  *(${name}_row *)c[1] = Y;
  for (n = 1; n < top; n++) {
    const ${name}_real after = ${one}/(${name}_real)(n + 1);
%%   for _, p in ipairs(taylor_planes) do
    ${name}_pack p${p.index} = {${zero}}, r${p.index} = {${zero}};
%%   end

%%   for _, p in ipairs(taylor_planes) do
    a${p.index}[n] = __builtin_shufflevector(Y, Y, ${p.a});
    b${p.index}[n] = __builtin_shufflevector(Y, Y, ${p.b});
%%   end
    j = n/2; /* outwards from the middle: the newest rows last */
    if (n - j == j) {
%%   for _, p in ipairs(taylor_planes) do
      p${p.index} = a${p.index}[j]*b${p.index}[j];
%%   end
      j--;
    }
    for (; j > 0; j--) {
%%   for _, p in ipairs(taylor_planes) do
      p${p.index} += a${p.index}[j]*b${p.index}[n - j];
      r${p.index} += a${p.index}[n - j]*b${p.index}[j];
%%   end
    }
    Y = ${taylor_next_row};
    *(${name}_row *)c[n + 1] = Y;
  }
}
#else
%%   end
%% end
%% if not taylor_top then
%%   if taylor_has_lanes then
/* Not inlined, the loops of products are put into vector registers as a whole. */
#if defined __GNUC__
#define ${upper}_APART static __attribute__((noinline))
#else
#define ${upper}_APART static
#endif

%%   end
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
/* the coefficients up to c[top]${taylor_side_about} */
static void ${name}_taylor_terms(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], int top,
                   ${name}_real c[][${upper}_ROW]${taylor_side})
{
%% if taylor_has_lanes then
  ${name}_real a[${upper}_ORDER + 1][${taylor_lanes}], b[${upper}_ORDER + 1][${taylor_lanes}], p[${taylor_lanes}];
%% end
  ${name}_real y[${taylor_places}];
%% for _, line in ipairs(taylor_outer) do
  ${line}
%% end
  int n;

%% for _, line in ipairs(taylor_voids) do
  ${line}
%% end
%% for _, line in ipairs(taylor_start) do
  ${line}
%% end
%% for _, s in ipairs(taylor_states) do
  c[0][${s.index}] = y[${s.index}];
%% end
%% for _, r in ipairs(taylor_roots) do
  c[0][${r.index}] = y[${r.place}];
%% end
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
%% for _, s in ipairs(taylor_states) do
  c[1][${s.index}] = y[${s.index}];
%% end

  for (n = 1; n < top; n++) {
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
%% for _, s in ipairs(taylor_states) do
    c[n + 1][${s.index}] = y[${s.index}];
%% end
%% for _, r in ipairs(taylor_roots) do
    c[n][${r.index}] = y[${r.place}];
    c[n + 1][${r.index}] = ${zero};
%% end
  }
}

%%   if taylor_packed then
#endif

%%   end
%% end
void ${name}_taylor_series(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[],
                  ${name}_real c[][${upper}_ROW])
{
  ${name}_taylor_terms(m, t, x, u, ${upper}_ORDER, c${taylor_after_t});
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
static void ${name}_taylor_back(${name}_real c[][${upper}_ROW], ${name}_real f, ${name}_real d[${upper}_ROW])
{
  const ${name}_real a = ${sin}(${quarter}*f), b = ${cos}(${quarter}*f);
  const ${name}_real S = ${two}*a*b, D = -${two}*a*a, V = ${two}*S*(${one} + D), W = -${two}*S*S; /* sin, cos - 1 of f/2, f */
  ${name}_real r, s;

%% for _, r in ipairs(taylor_turns) do
  r = c[0][${r.a}] + d[${r.a}];
  s = c[0][${r.b}] + d[${r.b}];
  d[${r.a}] += ${r.one}*r + ${r.sine}*s;
  d[${r.b}] += ${r.one}*s - ${r.sine}*r;
%% end
}

%% end
%% if taylor_shift then
/* The series give q in a frame that turns in space with g = L/I2, constant; q itself is exp(g s/2) times that.  What c[0] + d
 * moves by: the exponential less 1 is (cos - 1, sin h/|h|), h = g in space, of modulus 1 also when |q| is not quite. */
static void ${name}_taylor_back(const ${name}_model *m, const ${name}_real x[], ${name}_real c[][${upper}_ROW], ${name}_real s, ${name}_real d[${upper}_ROW])
{
%% for _, line in ipairs(taylor_frame.loads) do
  ${line}
%% end
%% for _, line in ipairs(taylor_frame.lines) do
  ${line}
%% end
  const ${name}_real *q = c[0];

  (void)m; /* constants may be in the code */
  (void)x;
  /* q g, then times the conjugate of q: g in space */
  const ${name}_real aw = -q[1]*gx - q[2]*gy - q[3]*gz, ax = q[0]*gx + q[2]*gz - q[3]*gy;
  const ${name}_real ay = q[0]*gy - q[1]*gz + q[3]*gx, az = q[0]*gz + q[1]*gy - q[2]*gx;
  const ${name}_real hx = ax*q[0] - aw*q[1] - ay*q[3] + az*q[2], hy = ay*q[0] - aw*q[2] + ax*q[3] - az*q[1];
  const ${name}_real hz = az*q[0] - aw*q[3] - ax*q[2] + ay*q[1];
  const ${name}_real size = ${sqrt}(hx*hx + hy*hy + hz*hz), angle = ${quarter}*s*size; /* a quarter of the turn */
  const ${name}_real S = ${sin}(angle), C = ${cos}(angle), D = -${two}*S*S, k = size > ${zero} ? ${two}*S*C/size : ${zero};
  const ${name}_real w = q[0] + d[0], i = q[1] + d[1], j = q[2] + d[2], l = q[3] + d[3];

  d[0] += D*w - k*(hx*i + hy*j + hz*l);
  d[1] += D*i + k*(hx*w + hy*l - hz*j);
  d[2] += D*j + k*(hy*w + hz*i - hx*l);
  d[3] += D*l + k*(hz*w + hx*j - hy*i);
}

%% end
/* what the states move by in the time s: s (c[1] + s (c[2] + ...)), the even and the odd terms apart */
static void ${name}_taylor_move(const ${name}_model *m, ${name}_real c[][${upper}_ROW], int top, ${name}_real s, const ${name}_real x[],
                       ${name}_real d[${upper}_ROW])
{
  const ${name}_real square = s*s;
  int n = top - 2;
%% if taylor_packed then
#if defined ${upper}_PACKED
  ${name}_pack a = *(const ${name}_row *)c[top], b = *(const ${name}_row *)c[top - 1];

  for (; n > 1; n -= 2) {
    a = *(const ${name}_row *)c[n] + square*a;
    b = *(const ${name}_row *)c[n - 1] + square*b;
  }
  if (n == 1) a = *(const ${name}_row *)c[1] + square*a;
  *(${name}_row *)d = n == 1 ? s*a + square*b : s*b + square*a;
#else
%% end
%% for _, s in ipairs(taylor_columns) do
  ${name}_real a${s.index} = c[top][${s.index}], b${s.index} = c[top - 1][${s.index}];
%% end

  for (; n > 1; n -= 2) {
%% for _, s in ipairs(taylor_columns) do
    a${s.index} = c[n][${s.index}] + square*a${s.index};
    b${s.index} = c[n - 1][${s.index}] + square*b${s.index};
%% end
  }
  if (n == 1) {
%% for _, s in ipairs(taylor_columns) do
    d[${s.index}] = s*(c[1][${s.index}] + square*a${s.index}) + square*b${s.index};
%% end
  } else {
%% for _, s in ipairs(taylor_columns) do
    d[${s.index}] = s*b${s.index} + square*a${s.index};
%% end
  }
%% if taylor_packed then
#endif
%% end
%% if taylor_axis then
  ${name}_taylor_back(c, ${name}_taylor_spin(m, x)*s, d);
%% else
%%   if taylor_shift or taylor_top then
  ${name}_taylor_back(m, x, c, s, d);
%%   else
  (void)m;
  (void)x;
%%   end
%% end
}

void ${name}_taylor_at(const ${name}_model *m, ${name}_real c[][${upper}_ROW], ${name}_real s, ${name}_real x[])
{
  ${name}_real d[${upper}_ROW];

  ${name}_taylor_move(m, c, ${upper}_ORDER, s, x, d);
%% for _, s in ipairs(taylor_states) do
  x[${s.name}] = c[0][${s.index}] + d[${s.index}];
%% end
}

/* The move over the step h; one Newton step for 1/|q| from the q that comes in, so that |q| cannot drift. */
static void ${name}_taylor_step_by(const ${name}_model *m, ${name}_real c[][${upper}_ROW], int top, ${name}_real h, const ${name}_real x[],
                          ${name}_real d[${upper}_ROW])
{
%% if taylor_attitude then
  const ${name}_real n = ${half} - ${half}*(c[0][0]*c[0][0] + c[0][1]*c[0][1] + c[0][2]*c[0][2] + c[0][3]*c[0][3]);
  int i;

%% end
  ${name}_taylor_move(m, c, top, h, x, d);
%% if taylor_attitude then
  for (i = 0; i < 4; i++) d[i] += n*(c[0][i] + d[i]);
%% end
}

%% if has_roots then
/* Is there no series, or none over h?  A speed at rest has a root without one, and near rest its series does not reach far: then
 * its last term is larger than all that moves. */
static int ${name}_taylor_lost(${name}_real c[][${upper}_ROW], int top, ${name}_real h)
{
  ${name}_real sum = ${zero}, head = ${zero}, tail = ${zero}, term;
  int n, k;

  for (k = 0; k < ${upper}_ROW; k++) {
    term = ${fabs}(c[top][k]);
    for (n = 0; n < top; n++) term *= ${fabs}(h);
    tail += term;
    head += ${fabs}(c[0][k]) + ${fabs}(c[1][k]*h);
    for (n = 0; n <= top; n++) sum += ${zero}*c[n][k];
  }
  return !(sum - sum < ${one} && tail <= head);
}

/* Over h, or as much of it as steps of the series' own choice take. */
static void ${name}_taylor_part(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_real left = h;
  int n;

  for (n = 0; n < ${taylor_parts}; n++) {
    if (!(left > ${zero} || left < ${zero})) break;
    left -= ${name}_taylor_adapt(m, t + (h - left), x, u, left, ${taylor_finest});
  }
}

%% end
%% if not has_knots then
void ${name}_taylor_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW];

  ${name}_taylor_series(m, t, x, u, c);
%% if has_roots then
  if (${name}_taylor_lost(c, ${upper}_ORDER, h)) {
    ${name}_taylor_part(m, t, x, u, h);
    return;
  }
%% end
  ${name}_taylor_step_by(m, c, ${upper}_ORDER, h, x, d);
%% for _, s in ipairs(taylor_states) do
  x[${s.name}] += d[${s.index}];
%% end
}
%% end
%% if planning then

/* One step of size h of any order up to ${upper}_ORDER: for the planner, which compares orders. */
void ${name}_taylor_step_of(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int top);

void ${name}_taylor_step_of(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int top)
{
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW];

  ${name}_taylor_terms(m, t, x, u, top, c${taylor_after_t});
  ${name}_taylor_step_by(m, c, top, h, x, d);
%%   for _, s in ipairs(taylor_states) do
  x[${s.name}] += d[${s.index}];
%%   end
}
%% end
