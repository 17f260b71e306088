%% -- estimator.c -- the tensor of inertia from a gyro: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- the tensor of inertia from measured rates ---- */

static int ${name}_is_number(${name}_real x)
{
  return x - x == ${zero};
}

/* I w = W(w) theta */
static void ${name}_momentum_rows(const ${name}_real w[3], ${name}_real W[3][6])
{
  static const int column[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 6; k++) W[i][k] = ${zero};
    for (int k = 0; k < 3; k++) W[i][column[i][k]] = w[k];
  }
}

/* a x b */
static void ${name}_vector_product(const ${name}_real a[3], const ${name}_real b[3], ${name}_real out[3])
{
  out[0] = a[1]*b[2] - a[2]*b[1];
  out[1] = a[2]*b[0] - a[0]*b[2];
  out[2] = a[0]*b[1] - a[1]*b[0];
}

/* The estimate becomes the tensor of the noise. */
static void ${name}_adopt(${name}_estimator *e)
{
  static const int place[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) e->I[i][k] = e->theta[place[i][k]];
  }
}

void ${name}_estimator_gap(${name}_estimator *e)
{
  e->count = 0;
  for (int i = 0; i < 6; i++) {
    e->b[i] = ${zero};
    for (int k = 0; k < 6; k++) e->A[i][k] = e->R[i][k] = ${zero};
  }
}

int ${name}_estimator_open(${name}_estimator *e, const ${name}_model *m, ${name}_real dt, int window, const ${name}_real sigma[3], const ${name}_real error[6])
{
  ${name}_real angle;

  ${name}_inertia(m, e->theta);
  e->moment = (e->theta[0] + e->theta[1] + e->theta[2])/${three};
  e->sigma = sigma[0] > sigma[1] ? sigma[0] : sigma[1];
  if (sigma[2] > e->sigma) e->sigma = sigma[2];
  if (window < 4 || !(e->moment > ${zero} && dt > ${zero} && ${name}_is_number(dt))) return 1;
  for (int i = 0; i < 3; i++) {
    if (!(sigma[i] > ${zero} && ${name}_is_number(sigma[i]))) return 1;
    e->variance[i] = sigma[i]/e->sigma*(sigma[i]/e->sigma);
  }
  for (int i = 0; i < 6; i++) {
    if (!(error[i] >= ${zero} && ${name}_is_number(error[i]))) return 1;
    e->theta[i] /= e->moment;
    e->D[i] = error[i]/e->moment*(error[i]/e->moment);
    for (int k = 0; k < 6; k++) e->U[i][k] = i == k ? ${one} : ${zero};
  }
  ${name}_adopt(e);
  e->dt = dt;
  e->window = window;
  angle = ${pi}/(${name}_real)window;
  e->turn[0] = ${cos}(angle);
  e->turn[1] = ${sin}(angle);
  e->start[0] = ${cos}(${half}*angle);
  e->start[1] = ${sin}(${half}*angle);
  e->slope[0] = ${two}*e->start[1]/e->start[0]; /* 2 tan(k pi/2n) */
  e->slope[1] = ${two}*e->turn[1]/e->turn[0];
  e->chi2 = ${zero};
  e->rows = 0;
  ${name}_estimator_gap(e);
  return 0;
}

/* R += M S M^T of a sample: d = w x I - (I w + h) x, f: f dt of each k, g: f' dt. */
static void ${name}_add_noise(${name}_estimator *e, ${name}_real d[3][3], const ${name}_real f[2], const ${name}_real g[2])
{
  ${name}_real M[6][3];

  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      M[i][k] = f[0]*d[i][k] - g[0]*e->I[i][k];
      M[i + 3][k] = f[1]*d[i][k] - g[1]*e->I[i][k];
    }
  }
  for (int i = 0; i < 6; i++) {
    const ${name}_real a = M[i][0]*e->variance[0], b = M[i][1]*e->variance[1], c = M[i][2]*e->variance[2];

    for (int j = 0; j <= i; j++) e->R[i][j] += a*M[j][0] + b*M[j][1] + c*M[j][2];
  }
}

int ${name}_estimator_add(${name}_estimator *e, const ${name}_real w[3], const ${name}_real torque[3], const ${name}_real h[3])
{
  const ${name}_real zero[3] = {${zero}, ${zero}, ${zero}}, *N = torque ? torque : zero, *H = h ? h : zero;
  ${name}_real W[3][6], V[3][6], d[3][3], L[3], wh[3], change[3], f[2], g[2], c;

  if (e->count == e->window) return 1;
  for (int i = 0; i < 3; i++) {
    if (${name}_is_number(w[i]) && ${name}_is_number(N[i]) && ${name}_is_number(H[i])) continue;
    ${name}_estimator_gap(e);
    return 2;
  }
  if (e->count == 0) {
    e->c = e->start[0];
    e->s = e->start[1];
    for (int i = 0; i < 3; i++) {
      e->w[i] = w[i];
      e->h[i] = H[i]/e->moment;
    }
  }
  f[0] = e->dt*e->s;
  f[1] = e->dt*(${two}*e->s*e->c);
  g[0] = e->slope[0]*e->c;
  g[1] = e->slope[1]*((e->c - e->s)*(e->c + e->s));

  /* the sum of f' is 0: with the change since the first sample there is less to cancel */
  for (int i = 0; i < 3; i++) {
    change[i] = w[i] - e->w[i];
    L[i] = e->I[i][0]*w[0] + e->I[i][1]*w[1] + e->I[i][2]*w[2] + H[i]/e->moment;
  }
  ${name}_momentum_rows(w, V);
  ${name}_momentum_rows(change, W);
  ${name}_vector_product(w, H, wh);
  for (int k = 0; k < 6; k++) {
    const ${name}_real column[3] = {V[0][k], V[1][k], V[2][k]};
    ${name}_real turned[3];

    ${name}_vector_product(w, column, turned);
    for (int i = 0; i < 3; i++) {
      e->A[i][k] += f[0]*turned[i] - g[0]*W[i][k];
      e->A[i + 3][k] += f[1]*turned[i] - g[1]*W[i][k];
    }
  }
  for (int i = 0; i < 3; i++) {
    const ${name}_real push = (N[i] - wh[i])/e->moment, rise = H[i]/e->moment - e->h[i];

    e->b[i] += f[0]*push + g[0]*rise;
    e->b[i + 3] += f[1]*push + g[1]*rise;
  }
  for (int k = 0; k < 3; k++) { /* w x I by columns, and the columns of -(L x) */
    const ${name}_real column[3] = {e->I[0][k], e->I[1][k], e->I[2][k]}, unit[3] = {k == 0 ? ${one} : ${zero}, k == 1 ? ${one} : ${zero}, k == 2 ? ${one} : ${zero}};
    ${name}_real turned[3], moved[3];

    ${name}_vector_product(w, column, turned);
    ${name}_vector_product(L, unit, moved);
    for (int i = 0; i < 3; i++) d[i][k] = turned[i] - moved[i];
  }
  ${name}_add_noise(e, d, f, g);

  c = e->c*e->turn[0] - e->s*e->turn[1];
  e->s = e->s*e->turn[0] + e->c*e->turn[1];
  e->c = c;
  return ++e->count == e->window;
}

/* Divides A and b by Cholesky's factor of R, so that their noise is independent of unit variance.  Rows that have no
 * noise of their own (of a rod, along it) tell nothing and become 0.  Returns 1 if a number is not finite. */
static int ${name}_whiten(${name}_estimator *e)
{
  for (int i = 0; i < 6; i++) {
    const ${name}_real whole = e->R[i][i];
    ${name}_real root;

    for (int j = 0; j < i; j++) {
      for (int k = 0; k < j; k++) e->R[i][j] -= e->R[i][k]*e->R[j][k];
      e->R[i][j] = e->R[j][j] > ${zero} ? e->R[i][j]/e->R[j][j] : ${zero};
      e->R[i][i] -= e->R[i][j]*e->R[i][j];
      e->b[i] -= e->R[i][j]*e->b[j];
      for (int k = 0; k < 6; k++) e->A[i][k] -= e->R[i][j]*e->A[j][k];
    }
    root = e->R[i][i] > ${sixteen}*${epsilon}*whole ? ${sqrt}(e->R[i][i]) : ${zero};
    e->R[i][i] = root;
    e->b[i] = root > ${zero} ? e->b[i]/root : ${zero};
    if (!${name}_is_number(e->b[i]) || !${name}_is_number(whole)) return 1;
    for (int k = 0; k < 6; k++) {
      e->A[i][k] = root > ${zero} ? e->A[i][k]/root : ${zero};
      if (!${name}_is_number(e->A[i][k])) return 1;
    }
  }
  return 0;
}

/* One equation a theta = b with a noise of sigma: Bierman's update of theta, U and D.  Returns 1 if its size is out of
 * range, and nothing is changed. */
static int ${name}_estimator_take(${name}_estimator *e, const ${name}_real a[6], ${name}_real b)
{
  ${name}_real f[6], v[6], K[6], alpha = ${one}, residual = b;

  for (int j = 0; j < 6; j++) {
    f[j] = a[j];
    for (int i = 0; i < j; i++) f[j] += e->U[i][j]*a[i];
    f[j] /= e->sigma;
    v[j] = e->D[j]*f[j];
    alpha += v[j]*f[j];
    residual -= a[j]*e->theta[j];
  }
  residual /= e->sigma;
  if (!${name}_is_number(alpha) || !${name}_is_number(residual)) return 1;
  alpha = ${one};
  for (int j = 0; j < 6; j++) {
    const ${name}_real beta = alpha, lambda = -f[j]/beta;

    alpha += v[j]*f[j];
    e->D[j] *= beta/alpha;
    K[j] = v[j];
    for (int i = 0; i < j; i++) {
      const ${name}_real u = e->U[i][j];

      e->U[i][j] = u + K[i]*lambda;
      K[i] += u*v[j];
    }
  }
  for (int i = 0; i < 6; i++) e->theta[i] += K[i]*(residual/alpha);
  e->chi2 += residual*(residual/alpha);
  e->rows++;
  return 0;
}

/* An entry of U D U^T, in moment^2. */
static ${name}_real ${name}_estimator_entry(const ${name}_estimator *e, int i, int k)
{
  ${name}_real sum = ${zero};

  for (int j = i > k ? i : k; j < 6; j++) sum += e->U[i][j]*e->D[j]*e->U[k][j];
  return sum;
}

int ${name}_estimator_solve(${name}_estimator *e)
{
  int bad, sure = 1;

  if (e->count < e->window) return 1;
  bad = ${name}_whiten(e);
  for (int i = 0; i < 6 && !bad; i++) {
    if (e->R[i][i] > ${zero}) bad = ${name}_estimator_take(e, e->A[i], e->b[i]);
  }
  for (int i = 0; i < 6; i++) sure = sure && ${name}_estimator_entry(e, i, i) < ${n[0.00390625]};
  if (sure) ${name}_adopt(e);
  ${name}_estimator_gap(e);
  return bad ? 2 : 0;
}

void ${name}_estimator_inertia(const ${name}_estimator *e, ${name}_real I[6], ${name}_real error[6])
{
  for (int i = 0; i < 6; i++) {
    I[i] = e->moment*e->theta[i];
    error[i] = e->moment*${sqrt}(${name}_estimator_entry(e, i, i));
  }
}

void ${name}_estimator_covariance(const ${name}_estimator *e, ${name}_real C[36])
{
  for (int i = 0; i < 6; i++) {
    for (int k = 0; k < 6; k++) C[6*i + k] = ${name}_estimator_entry(e, i, k);
  }
}

int ${name}_estimator_ratios(const ${name}_estimator *e, ${name}_real ratio[2], ${name}_real error[2])
{
  if (!(e->theta[0] > ${zero})) return 1;
  for (int i = 0; i < 2; i++) { /* the errors' part of U in theta[i + 1] - r theta[0], over theta[0] */
    const ${name}_real r = e->theta[i + 1]/e->theta[0];
    ${name}_real sum = ${zero};

    for (int j = 0; j < 6; j++) {
      const ${name}_real u = (e->U[i + 1][j] - r*e->U[0][j])/e->theta[0];

      sum += u*e->D[j]*u;
    }
    ratio[i] = r;
    error[i] = ${sqrt}(sum);
  }
  return 0;
}
