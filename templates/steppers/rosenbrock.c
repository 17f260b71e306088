%% -- rosenbrock.c -- the linearly implicit method: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- Rodas5P: Steinebach 2023, BIT 63, 27; Hairer, Wanner, Solving ODEs II (2nd ed.), IV.7 ---- */

/* The states that move, in the order of the arrays below */
static const int ${name}_rosenbrock_moving[${count}] = {
%% for _, s in ipairs(states) do
  ${s.name},
%% end
};

%% if timed then
/* (1/(h g) 1 - J) k_i = f(t + c_i h, x + sum a_ij k_j) + sum (C_ij/h) k_j + h d_i df/dt */
%% else
/* (1/(h g) 1 - J) k_i = f(t + c_i h, x + sum a_ij k_j) + sum (C_ij/h) k_j */
%% end
static const ${name}_real ${name}_rosenbrock_a[8][7] = {
%% for _, row in ipairs(a) do
  {${row.text}
%% end
};
static const ${name}_real ${name}_rosenbrock_C[8][7] = {
%% for _, row in ipairs(C) do
  {${row.text}
%% end
};
static const ${name}_real ${name}_rosenbrock_c[8] = {${c}};
%% if timed then
static const ${name}_real ${name}_rosenbrock_d[8] = {${d}};
%% end

%% if slides then
/* The slip less the velocity.  Friction is nearly linear in the slip, and not in the velocity: in the functions below
 * ${slip_states} the slip, so that the order of the method does not fall where friction is strong. */
static ${shift.head}
{
%% for _, line in ipairs(shift.lines) do
  ${line}
%% end
}

%% end
%% if slides then
/* x', with the slip in the place of the velocity */
%% else
/* x' */
%% end
static ${rates.head}
{
%% for _, line in ipairs(rates.lines) do
  ${line}
%% end
}

/* n 1 - J = L U, J the derivative of x' by the moving states, into F: L without its diagonal, which is 1, and U with the
 * inverse of its own. */
static ${matrix.head}
{
%% for _, line in ipairs(matrix.lines) do
  ${line}
%% end
}

/* L U k = b */
static ${solve.head}
{
%% for _, line in ipairs(solve.lines) do
  ${line}
%% end
}

/* From z at t the state `out` at t + h and its estimated error. */
static void ${name}_rosenbrock_trial(const ${name}_model *m, ${name}_real t, const ${name}_real z[], const ${name}_real u[], ${name}_real h${sides_arg}, ${name}_real out[], ${name}_real error[${count}])
{
%% if timed then
  ${name}_real F[${cells}], k[8][${count}], b[${count}], dt[${count}];
%% else
  ${name}_real F[${cells}], k[8][${count}], b[${count}];
%% end
  const ${name}_real rate = ${one}/h;
  int i, j, n;

%% if timed then
  ${name}_rosenbrock_matrix(m, t, z, u, rate*${rate}${sides}, F, dt);
%% else
  ${name}_rosenbrock_matrix(m, t, z, u, rate*${rate}${sides}, F);
%% end
  for (n = 0; n < ${upper}_NX; n++) out[n] = z[n];
  for (i = 0; i < 8; i++) {
    for (n = 0; n < ${count}; n++) {
      ${name}_real sum = ${zero};

      for (j = 0; j < i; j++) sum += ${name}_rosenbrock_a[i][j]*k[j][n];
      out[${name}_rosenbrock_moving[n]] = z[${name}_rosenbrock_moving[n]] + sum;
    }
    ${name}_rosenbrock_rates(m, t + ${name}_rosenbrock_c[i]*h, out, u${sides}, b);
    for (n = 0; n < ${count}; n++) {
      ${name}_real sum = ${zero};

      for (j = 0; j < i; j++) sum += ${name}_rosenbrock_C[i][j]*k[j][n];
%% if timed then
      b[n] += sum*rate + h*${name}_rosenbrock_d[i]*dt[n];
%% else
      b[n] += sum*rate;
%% end
    }
    ${name}_rosenbrock_solve(F, b, k[i]);
  }
  for (n = 0; n < ${count}; n++) {
    out[${name}_rosenbrock_moving[n]] += k[7][n];
    error[n] = k[7][n];
  }
%% if attitude then
  { /* |q| is brought back to 1 by one Newton step */
    const int *q = ${name}_rosenbrock_moving;
    const ${name}_real w = ${threehalves} - ${half}*(out[q[0]]*out[q[0]] + out[q[1]]*out[q[1]] + out[q[2]]*out[q[2]] + out[q[3]]*out[q[3]]);

    for (n = 0; n < 4; n++) out[q[n]] *= w;
  }
%% end
}

%% if slides then
/* The state with its slip in the place of its velocity (sign 1), or back (-1). */
static void ${name}_rosenbrock_turned(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[]${sides_arg}, ${name}_real sign, ${name}_real z[])
{
  ${name}_real a[${many}];
  int n;

  ${name}_rosenbrock_slip(m, t, x, u${sides}, a);
  for (n = 0; n < ${upper}_NX; n++) z[n] = x[n];
%% for _, s in ipairs(slips) do
  z[${s.name}] += sign*a[${s.place}];
%% end
}

%% end
%% if not has_switches then
void ${name}_rosenbrock_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
%% if slides then
  ${name}_real z[${upper}_NX], out[${upper}_NX], error[${count}];

  ${name}_rosenbrock_turned(m, t, x, u, ${one}, z);
  ${name}_rosenbrock_trial(m, t, z, u, h, out, error);
  ${name}_rosenbrock_turned(m, t + h, out, u, -${one}, x);
%% else
  ${name}_real out[${upper}_NX], error[${count}];
  int n;

  ${name}_rosenbrock_trial(m, t, x, u, h, out, error);
  for (n = 0; n < ${upper}_NX; n++) x[n] = out[n];
%% end
}

%% end
${norm}

%% if has_switches then
${switched}
%% else
int ${name}_rosenbrock_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most)
{
%% if slides then
  ${name}_real z[${upper}_NX], out[${upper}_NX], y[${upper}_NX], error[${count}];
%% else
  ${name}_real y[${upper}_NX], error[${count}];
%% end
  ${name}_real t = t0, h = t1 - t0, lost = ${zero};
  int steps, k;

  for (steps = 0; steps < most; steps++) {
%% if has_knots then
    const ${name}_real end = ${name}_knot(m, t, t1), left = (end - t) - lost; /* from corner to corner */
    ${name}_real whole = h;
%% else
    const ${name}_real left = (t1 - t) - lost;
%% end
    ${name}_real r, factor, next_t;
    int last;

    if (!(left > ${zero} || left < ${zero})) return steps;
    last = !(${fabs}(h) < ${fabs}(left));
    if (last) h = left;
%% if slides then
    ${name}_rosenbrock_turned(m, t, x, u, ${one}, z);
    ${name}_rosenbrock_trial(m, t, z, u, h, out, error);
    ${name}_rosenbrock_turned(m, t + h, out, u, -${one}, y);
%% else
    ${name}_rosenbrock_trial(m, t, x, u, h, y, error);
%% end
    r = ${name}_rosenbrock_norm(${norm_pass}x, y, error)/tolerance;
    factor = ${name}_growth(r);
    next_t = t + h;
    if (!(r <= ${one})) { /* tried in vain */
      if (!(next_t > t || next_t < t)) return -1;
      h *= factor < ${one} ? factor : ${half};
      continue;
    }
    for (k = 0; k < ${upper}_NX; k++) x[k] = y[k];
${taken}
  }
  return -1;
}
%% if first then

void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_rosenbrock_step(m, t, x, u, h);
}
%% end
%% end
