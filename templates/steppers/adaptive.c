%% -- adaptive.c -- the embedded Runge-Kutta pair: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- Dormand, Prince 1980, J. Comput. Appl. Math. 6, 19; control: Hairer, Norsett, Wanner I, sections II.4, IV.2 ---- */

/* States that move: x[moving[k]] is number k of the arrays below. */
static const int ${name}_adaptive_moving[${count}] = {
%% for _, s in ipairs(states) do
  ${s.name},
%% end
};

%% if attitude then
/* From x at t with its rates k1: the state `out` at t + h, its rates k7, the estimated error, what q turned by. */
%% else
/* From x at t with its rates k1: the state `out` at t + h, its rates k7, the estimated error. */
%% end
static ${head}
{
%% for _, line in ipairs(lines) do
  ${line}
%% end
}

%% if not has_switches then
/* k1 at the start */
static void ${name}_adaptive_first(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real k1[])
{
  ${name}_real dx[${upper}_NX];

  ${name}_rhs(m, t, x, u, dx);
  for (int k = 0; k < ${count}; k++) k1[k] = dx[${name}_adaptive_moving[k]];
}

%% end
%% if attitude then
/* x takes the state that a step ends in; |q| is brought back to 1 by one Newton step.  The factor is 1 but for a unit or two
 * of the last place; times q it would be rounded to whole units, more of a small mantissa than of a large one: a turn, always
 * the same way.  So its difference n from 1 goes into what is added; and n is formed of x and `turn`, for `out` has a
 * rounding of its own, after which n would follow the very digits that it decides. */
static void ${name}_adaptive_take(const ${name}_real out[], const ${name}_real turn[], ${name}_real x[])
{
  ${name}_real n = ${half};

  for (int k = 0; k < 4; k++) {
    const ${name}_real q = x[${name}_adaptive_moving[k]];

    n -= q*(${half}*q + turn[k]) + ${half}*turn[k]*turn[k];
  }
  for (int k = 0; k < 4; k++) x[${name}_adaptive_moving[k]] += turn[k] + n*out[k];
  for (int k = 4; k < ${count}; k++) x[${name}_adaptive_moving[k]] = out[k];
}
%% else
/* x takes the state that a step ends in. */
static void ${name}_adaptive_take(const ${name}_real out[], ${name}_real x[])
{
  for (int k = 0; k < ${count}; k++) x[${name}_adaptive_moving[k]] = out[k];
}
%% end

%% if not has_switches then
void ${name}_adaptive_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_real k1[${count}], k7[${count}], error[${count}], out[${count}]${room};

  ${name}_adaptive_first(m, t, x, u, k1);
  ${name}_adaptive_trial(m, t, x, u, h, k1, out, k7, error${turn});
  ${name}_adaptive_take(out${turn}, x);
}

%% end
${norm}

%% if has_switches then
${switched}
%% else
int ${name}_adaptive_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most)
{
  ${name}_real k1[${count}], k7[${count}], error[${count}], out[${count}]${room};
  ${name}_real t = t0, h = t1 - t0, lost = ${zero};
  int fresh = 1;

  for (int steps = 0; steps < most; steps++) {
%% if has_knots then
    const ${name}_real end = ${name}_knot(m, t, t1), left = (end - t) - lost; /* from corner to corner */
%% else
    const ${name}_real left = (t1 - t) - lost;
%% end
    ${name}_real r, factor, next_t;
%% if has_knots then
    ${name}_real whole = h;
%% end
    int last;

    if (!(left > ${zero} || left < ${zero})) return steps;
    if (fresh) ${name}_adaptive_first(m, t, x, u, k1);
    last = !(${fabs}(h) < ${fabs}(left));
    if (last) h = left;
    ${name}_adaptive_trial(m, t, x, u, h, k1, out, k7, error${turn});
    r = ${name}_adaptive_norm(${norm_pass}x, out, error)/tolerance;
    factor = ${name}_growth(r);
    if (!(r <= ${one})) { /* tried in vain */
      next_t = t + h;
      if (!(next_t > t || next_t < t)) return -1;
      h *= factor < ${one} ? factor : ${half};
      fresh = 0;
      continue;
    }
    ${name}_adaptive_take(out${turn}, x);
    for (int k = 0; k < ${count}; k++) k1[k] = k7[k];
    fresh = 0;
${taken}
  }
  return -1;
}
%% if first then

void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_adaptive_step(m, t, x, u, h);
}
%% end
%% end
