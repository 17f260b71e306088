%% -- disc.c -- the swing of a rolling disc: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- the rolling disc ----
 *
 * Appell, Korteweg 1899: with s, c = sin, cos theta, w the rate about the axis, a = phi' s, and per m R^2
 * k1 = I1/(m R^2), k3 = I3/(m R^2), gamma = gravity/R,
%% if rounded then
 *     k3 dw/dtheta = (1 + p s) f,   k1 da/dtheta = k3 w - k1 a c/s - p c f,   p = rho/R,
 *     f = (a + p (k3/k1 - 1) c w)/(1 + (1 + p s)^2/k3 + p^2 c^2/k1),
 *     J theta'^2/2 = W = E - gamma s - (k1 a^2 + k3 w^2 + (p c a - (1 + p s) w)^2)/2,   J = k1 + 1 + 2 p s + p^2.
%% else
 *     dw/dtheta = a/(1 + k3),   k1 da/dtheta = k3 w - k1 a c/s          (w: a Legendre function of cos theta),
 *     J theta'^2/2 = W = E - gamma s - (k1 a^2 + (1 + k3) w^2)/2,   J = k1 + 1.
%% end
 * In x = ln tan(theta/2), dtheta = s dx, nothing is singular. All is a chain of series in x, and W a sum of its own ones
 * from the start on, so that small swings, nearly flat discs and slow passages of the upright keep their digits. */

/* the disc at a tilt: s, c, a, w, and W with its slope by x */
typedef struct ${name}_disc_place {
  ${name}_real s, c, a, w, W, slope;
} ${name}_disc_place;

/* their series in direction (x - x0) */
typedef struct ${name}_disc_arc {
  ${name}_real s[${terms}], c[${terms}], a[${terms}], w[${terms}], W[${terms}], direction;
} ${name}_disc_arc;

/* coefficient k of a product of series */
static ${name}_real ${name}_disc_product(const ${name}_real x[], const ${name}_real y[], int k)
{
  ${name}_real sum = ${zero};
  int j;

  for (j = 0; j <= k; j++) sum += x[j]*y[k - j];
  return sum;
}

static ${name}_real ${name}_disc_inertia(const ${name}_model *m, ${name}_real s)
{
%% if not uses_model then
  (void)m;
%% end
%% if rounded then
  return ${k1} + ${one} + ${p}*(${two}*s + ${p});
%% else
  (void)s;
  return ${k1} + ${one};
%% end
}

/* the series about a place; its W and slope are the first two coefficients of W, which were summed up to it */
static void ${name}_disc_expand(const ${name}_model *m, const ${name}_disc_place *at, ${name}_real direction, ${name}_disc_arc *o)
{
  const ${name}_real k1 = ${k1}, k3 = ${k3}, gamma = ${gamma}, ratio = k3/k1;
%% if rounded then
  const ${name}_real p = ${p};
  const ${name}_real linear = ${two}*p/k3, square = p*p*(${one}/k3 - ${one}/k1);
  ${name}_real ss[${terms}], sc[${terms}], D[${terms}], f[${terms}], lever[${terms}], v[${terms}], sum, sw, ac;
  int j, k;
%% else
  ${name}_real h;
  int k;
%% end

%% if not uses_model then
  (void)m;
%% end
  o->s[0] = at->s;
  o->c[0] = at->c;
  o->a[0] = at->a;
  o->w[0] = at->w;
  o->direction = direction;
%% if rounded then
  for (k = 0; k < ${last}; k++) {
    const ${name}_real h = direction/(${name}_real)(k + 1);

    ss[k] = ${name}_disc_product(o->s, o->s, k);
    sc[k] = ${name}_disc_product(o->s, o->c, k);
    sw = ${name}_disc_product(o->s, o->w, k);
    ac = ${name}_disc_product(o->a, o->c, k);
    v[k] = p*(ac - sw) - o->w[k];
    D[k] = linear*o->s[k] + square*ss[k];
    if (k == 0) D[0] += ${one} + ${one}/k3 + p*p/k1;
    sum = o->a[k] + p*(ratio - ${one})*${name}_disc_product(o->c, o->w, k);
    for (j = 1; j <= k; j++) sum -= D[j]*f[k - j];
    f[k] = sum/D[0];
    lever[k] = o->s[k] + p*ss[k];
    o->s[k + 1] = h*sc[k];
    o->c[k + 1] = -h*ss[k];
    o->w[k + 1] = h*${name}_disc_product(lever, f, k)/k3;
    o->a[k + 1] = h*(ratio*sw - ac - p/k1*${name}_disc_product(sc, f, k));
  }
  v[k] = p*(${name}_disc_product(o->a, o->c, k) - ${name}_disc_product(o->s, o->w, k)) - o->w[k];
%% else
  for (k = 0; k < ${last}; k++) {
    h = direction/(${name}_real)(k + 1);
    o->s[k + 1] = h*${name}_disc_product(o->s, o->c, k);
    o->c[k + 1] = -h*${name}_disc_product(o->s, o->s, k);
    o->w[k + 1] = h*${name}_disc_product(o->s, o->a, k)/(${one} + k3);
    o->a[k + 1] = h*(ratio*${name}_disc_product(o->s, o->w, k) - ${name}_disc_product(o->a, o->c, k));
  }
%% end
  o->W[0] = at->W;
  o->W[1] = direction*at->slope;
  for (k = 2; k < ${terms}; k++) {
%% if rounded then
    o->W[k] = -(gamma*o->s[k] + ${half}*(k1*${name}_disc_product(o->a, o->a, k) + k3*${name}_disc_product(o->w, o->w, k) +
        ${name}_disc_product(v, v, k)));
%% else
    o->W[k] = -(gamma*o->s[k] + ${half}*(k1*${name}_disc_product(o->a, o->a, k) +
        (${one} + k3)*${name}_disc_product(o->w, o->w, k)));
%% end
  }
}

/* dW/dx at a place */
static ${name}_real ${name}_disc_slope(const ${name}_model *m, const ${name}_disc_place *at)
{
%% if rounded then
  const ${name}_real rim = at->s + ${p}, lever = ${one} + ${p}*at->s;

%% if not uses_model then
  (void)m;
%% end
  /* without f: the plane's force does no work */
  return at->c*(${k1}*at->a*at->a - ${gamma}*at->s) - at->a*(${k3}*at->w*at->s + rim*(lever*at->w - ${p}*at->c*at->a));
%% else
%% if not uses_model then
  (void)m;
%% end
  return at->c*(${k1}*at->a*at->a - ${gamma}*at->s) - (${one} + ${k3})*at->w*at->a*at->s;
%% end
}

static ${name}_real ${name}_disc_value(const ${name}_real x[], ${name}_real h)
{
  ${name}_real sum = ${zero};
  int k;

  for (k = ${last}; k >= 0; k--) sum = sum*h + x[k];
  return sum;
}

/* the place at the distance h on an arc */
static ${name}_disc_place ${name}_disc_on(const ${name}_disc_arc *o, ${name}_real h)
{
  ${name}_disc_place at;
  int k;

  at.s = ${name}_disc_value(o->s, h);
  at.c = ${name}_disc_value(o->c, h);
  at.a = ${name}_disc_value(o->a, h);
  at.w = ${name}_disc_value(o->w, h);
  at.W = ${name}_disc_value(o->W, h);
  at.slope = ${zero};
  for (k = ${last}; k >= 1; k--) at.slope = at.slope*h + (${name}_real)k*o->W[k];
  at.slope *= o->direction;
  return at;
}

/* Below this, at most `limit`, q_first + q_(first + 1) h + .. has no root (Cauchy's bound: q_first = sum |q_k| h^(k - first),
 * by Newton's method from above, which is monotone, its next place written as a quotient of positive sums). */
static ${name}_real ${name}_disc_clear(const ${name}_real q[], int first, ${name}_real limit)
{
  ${name}_real at = limit, above, below, next;
  int i, k;

  for (i = 0; i < 200; i++) {
    above = below = ${zero};
    for (k = ${last}; k > first; k--) {
      const ${name}_real size = ${fabs}(q[k]);

      above = above*at + (${name}_real)(k - first - 1)*size;
      below = below*at + (${name}_real)(k - first)*size;
    }
    next = (above*at + q[first])/below;
    if (!(next < at)) break;
    at = next;
  }
  return at;
}

/* moves `at` to the first root of W; its distance, or -1 if it lies flat before */
static ${name}_real ${name}_disc_turning(const ${name}_model *m, ${name}_disc_place *at, ${name}_real direction)
{
  ${name}_real total = ${zero}, h;
  ${name}_disc_arc o;
  int first = !(at->W > ${zero});

  while (at->s > ${least_sine}) {
    ${name}_disc_expand(m, at, direction, &o);
    h = ${name}_disc_clear(o.W, first, ${reach});
    if (first) h *= ${half};
    *at = ${name}_disc_on(&o, h);
    total += h;
    if (!first && (!(at->W > ${zero}) || h <= ${epsilon}*total)) {
      at->W = ${zero};
      return total;
    }
    first = 0;
  }
  return -${one};
}

/* sums += integrals of s/sqrt(2 W/J) and a/sqrt(2 W/J) over dx along `length` from a root of W: time and turn. Series are
 * in x/h, as those of a tiny h overflow. Returns 0 if the root is a double one. */
static int ${name}_disc_half(const ${name}_model *m, ${name}_disc_place at, ${name}_real direction, ${name}_real length, ${name}_real sums[2])
{
  ${name}_real q[${terms}], r[${terms}], done = ${zero}, h, power, sum, t, phi, e;
  ${name}_disc_arc o;
  int first = 1, j, k;

  while (done < length) {
    const int top = ${last} - first;

    ${name}_disc_expand(m, &at, direction, &o);
    for (k = 0; k < ${terms}; k++) {
      sum = ${two}*o.W[k];
%% if rounded then
      for (j = 1; j <= k; j++) sum -= ${two}*${p}*o.s[j]*q[k - j];
%% end
      q[k] = sum/${name}_disc_inertia(m, at.s);
    }
    if (!(q[first] > ${zero})) return 0;
    h = ${quarter}*${name}_disc_clear(q, first, ${four}*${reach});
    if (h > length - done) h = length - done;
    at = ${name}_disc_on(&o, h);
    power = ${one};
    for (k = 0; k <= top; k++) {
      o.s[k] *= power;
      o.a[k] *= power;
      q[k] = q[k + first]*power;
      power *= h;
    }
    r[0] = ${one}/${sqrt}(q[0]); /* r = q^(-1/2), q r' = -q' r/2 */
    for (k = 1; k <= top; k++) {
      sum = ${zero};
      for (j = 1; j <= k; j++) sum += ((${name}_real)k - ${half}*(${name}_real)j)*q[j]*r[k - j];
      r[k] = -sum/((${name}_real)k*q[0]);
    }
    e = first ? ${half} : ${one}; /* of x^(k - 1/2) or x^k */
    t = phi = ${zero};
    for (k = top; k >= 0; k--) {
      t += ${name}_disc_product(o.s, r, k)/((${name}_real)k + e);
      phi += ${name}_disc_product(o.a, r, k)/((${name}_real)k + e);
    }
    power = first ? ${sqrt}(h) : h;
    sums[0] += t*power;
    sums[1] += phi*power;
    done += h;
    first = 0;
  }
  return 1;
}

/* the place after a distance */
static void ${name}_disc_walk(const ${name}_model *m, ${name}_disc_place *at, ${name}_real direction, ${name}_real left)
{
  ${name}_disc_arc o;
  ${name}_real h;

  at->W = at->slope = ${zero};
  while (left > ${zero}) {
    h = left < ${reach} ? left : ${reach};
    ${name}_disc_expand(m, at, direction, &o);
    *at = ${name}_disc_on(&o, h);
    left -= h;
  }
}

/* the place of a state, with W and its slope; 0 if it has none */
static int ${name}_disc_start(const ${name}_model *m, const ${name}_real x[], ${name}_disc_place *at)
{
  ${name}_real tilt[5];
  int i;

  ${name}_disc_tilt(m, x, tilt);
  for (i = 0; i < 5; i++) {
    if (!(tilt[i] - tilt[i] == ${zero})) return 0;
  }
  at->s = tilt[0];
  at->c = tilt[1];
  at->a = tilt[3];
  at->w = tilt[4];
  at->W = ${half}*${name}_disc_inertia(m, at->s)*tilt[2]*tilt[2];
  at->slope = ${name}_disc_slope(m, at);
  return at->s > ${least_sine};
}

/* |ln tan(theta/2)| */
static ${name}_real ${name}_disc_distance(${name}_real s, ${name}_real c)
{
  return ${log}((${one} + ${fabs}(c))/s);
}

int ${name}_disc_integrals(const ${name}_model *m, const ${name}_real x[], ${name}_real C[2])
{
  ${name}_disc_place at;

  if (!${name}_disc_start(m, x, &at)) return 1;
  ${name}_disc_walk(m, &at, at.c < ${zero} ? -${one} : ${one}, ${name}_disc_distance(at.s, at.c));
  C[0] = at.w;
  C[1] = at.a;
  return 0;
}

int ${name}_disc_rates(const ${name}_model *m, const ${name}_real C[2], ${name}_real theta, ${name}_real rates[2])
{
  const ${name}_real s = ${sin}(theta), c = ${cos}(theta);
  ${name}_disc_place at = {${one}, ${zero}, C[1], C[0], ${zero}, ${zero}};

  if (!(theta > ${zero} && theta < ${pi} && s > ${least_sine})) return 1;
  ${name}_disc_walk(m, &at, c < ${zero} ? ${one} : -${one}, ${name}_disc_distance(s, c));
  rates[0] = at.w;
  rates[1] = at.a;
  return 0;
}

int ${name}_disc_swing(const ${name}_model *m, const ${name}_real x[], ${name}_real swing[4])
{
  ${name}_disc_place at, low, high;
  ${name}_real down = ${zero}, up = ${zero}, sums[2] = {${zero}, ${zero}}, period = ${zero}, turn = ${zero}, square;
  ${name}_disc_arc o;

  if (!${name}_disc_start(m, x, &at)) return 1;
  low = high = at;
  if (!(at.W > ${zero}) && at.slope == ${zero}) { /* steady: x'' = W'/(J s^2) */
    ${name}_disc_expand(m, &at, ${one}, &o);
    square = -${two}*o.W[2]/${name}_disc_inertia(m, at.s);
    if (square > ${zero}) {
      period = ${two_pi}*at.s/${sqrt}(square);
      turn = period*at.a/at.s;
    }
  } else {
    if (!(${fabs}(at.a) + ${fabs}(at.w) > ${zero})) return 1;
    if (at.W > ${zero} || at.slope < ${zero}) down = ${name}_disc_turning(m, &low, -${one});
    if (at.W > ${zero} || at.slope > ${zero}) up = ${name}_disc_turning(m, &high, ${one});
    if (down < ${zero} || up < ${zero}) return 1;
    if (${name}_disc_half(m, low, ${one}, ${half}*(down + up), sums) && ${name}_disc_half(m, high, -${one}, ${half}*(down + up), sums)) {
      period = ${two}*sums[0];
      turn = ${two}*sums[1];
    }
  }
  swing[0] = ${atan2}(low.s, low.c);
  swing[1] = ${atan2}(high.s, high.c);
  swing[2] = period;
  swing[3] = turn;
  return period > ${zero} ? 0 : 2;
}
