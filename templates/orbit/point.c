%% -- point.c -- the closed form of a point under linear forces: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ---- */

/* sine and cosine of (rate t)/2, rate a pair; the low part of a large phase need not be small */
static void ${name}_turn_of(const ${name}_real rate[2], ${name}_real t, ${name}_real *s, ${name}_real *c)
{
  ${name}_pair p = ${name}_pair_product(rate[0], ${half}*t);
  const ${name}_real low = p.lo + rate[1]*(${half}*t);
  const ${name}_real sh = ${sin}(p.hi), ch = ${cos}(p.hi), sl = ${sin}(low), cl = ${cos}(low);

  *s = sh*cl + ch*sl;
  *c = ch*cl - sh*sl;
}

/* square root of a pair > 0: one Newton step */
static ${name}_pair ${name}_pair_root(${name}_pair a)
{
  const ${name}_real r = ${sqrt}(a.hi);
  ${name}_pair p;

  if (r == ${zero}) return ${name}_pair_of(${zero});
  p = ${name}_pair_product(r, r);
  return ${name}_pair_sum(r, ((a.hi - p.hi) - p.lo + a.lo)/(${two}*r));
}

static void ${name}_wave_set(${name}_wave *w, ${name}_pair kappa)
{
  w->kind = (kappa.hi > ${zero}) - (kappa.hi < ${zero});
  kappa = ${name}_pair_root(w->kind < 0 ? ${name}_minus(kappa) : kappa);
  w->rate[0] = kappa.hi;
  w->rate[1] = kappa.lo;
}

/* The solutions of s'' = g - kappa s with s, s', g = (1, 0, 0), (0, 1, 0), (0, 0, 1): C, S, D, where S' = C, D' = S,
 * C' = -kappa S.  By half angles nothing cancels. */
static void ${name}_wave_at(const ${name}_wave *w, ${name}_real t, ${name}_real f[3])
{
  const ${name}_real r = w->rate[0];
  ${name}_real s, c;

  if (w->kind == 0) {
    f[0] = ${one};
    f[1] = t;
    f[2] = ${half}*t*t;
    return;
  }
  if (w->kind > 0) {
    ${name}_turn_of(w->rate, t, &s, &c);
    f[0] = (c - s)*(c + s);
  } else {
    ${name}_pair p = ${name}_pair_product(r, ${half}*t);
    const ${name}_real low = p.lo + w->rate[1]*(${half}*t);
    const ${name}_real sh = ${sinh}(p.hi), ch = ${cosh}(p.hi);

    s = sh + low*ch;
    c = ch + low*sh;
    f[0] = c*c + s*s;
  }
  f[1] = ${two}*(s/r)*c;
  f[2] = ${two}*(s/r)*(s/r);
}

/* kappa S with its sign */
static ${name}_real ${name}_wave_back(const ${name}_wave *w, ${name}_real S)
{
  return (${name}_real)w->kind*w->rate[0]*(w->rate[0]*S);
}

%% if framed then
/* P, the solution of P'' + 2 i Omega P' - delta P = 1 from rest, and P', as real and imaginary parts, by their power
 * series for phases below one: what they exceed t^2/2 and t by, x = Omega t, d = delta t^2 */
static void ${name}_set_series(${name}_real x, ${name}_real d, ${name}_real t, ${name}_real P[2], ${name}_real dP[2])
{
  ${name}_real now[2] = {${half}, ${zero}}, before[2] = {${zero}, ${zero}}, next[2];

  for (int i = 0; i < 2; i++) P[i] = dP[i] = ${zero};
  for (int k = 1; k < 26; k++) { /* terms k + 1 to k + 2 of the series; the 26th is below 1/26! */
    const ${name}_real m = ${one}/((${name}_real)(k + 1)*(${name}_real)(k + 2)), y = ${two}*x*(${name}_real)(k + 1);

    next[0] = m*(d*before[0] + y*now[1]);
    next[1] = m*(d*before[1] - y*now[0]);
    for (int i = 0; i < 2; i++) {
      before[i] = now[i];
      now[i] = next[i];
      P[i] += now[i];
      dP[i] += (${name}_real)(k + 2)*now[i];
    }
  }
  for (int i = 0; i < 2; i++) {
    P[i] *= t*t;
    dP[i] *= t;
  }
}

/* P = integral over s from 0 to t of exp(-i Omega s) S(s), as real and imaginary part; C, S of the wave across, c and sn
 * the cosine and sine of Omega t.  It solves P'' + 2 i Omega P' - delta P = 1 from rest, whence its power series; away
 * from resonance (delta not small) it is (exp(-i Omega t) (C + i Omega S) - 1)/delta, and at resonance the difference of
 * (1 - exp(-i rate t))/(i rate) over the slow and the fast rate. */
static void ${name}_push(const ${name}_orbit *o, ${name}_real t, ${name}_real C, ${name}_real S, ${name}_real c, ${name}_real sn,
                         ${name}_real P[2])
{
  const ${name}_real O = o->turn[0], sigma = o->across.rate[0], x = O*t;

  if (${fabs}(x) + sigma*${fabs}(t) < ${one}) {
    ${name}_real dP[2];

    ${name}_set_series(x, o->delta*t*t, t, P, dP);
    P[0] += ${half}*t*t;
  } else if (${fabs}(o->delta) >= ${quarter}*(O*O + sigma*sigma)) {
    P[0] = (c*C + sn*O*S - ${one})/o->delta;
    P[1] = (c*O*S - sn*C)/o->delta;
  } else {
    ${name}_real s, h, fast[2], slow[2];

    ${name}_turn_of(o->fast, t, &s, &h);
    fast[0] = ${two}*s*h/o->fast[0];
    fast[1] = -${two}*s*s/o->fast[0];
    ${name}_turn_of(o->slow, t, &s, &h);
    slow[0] = o->slow[0] == ${zero} ? t : ${two}*s*h/o->slow[0];
    slow[1] = o->slow[0] == ${zero} ? ${zero} : -${two}*s*s/o->slow[0];
    P[0] = (slow[1] - fast[1])/(${two}*sigma);
    P[1] = (fast[0] - slow[0])/(${two}*sigma);
  }
}

static void ${name}_cross(const ${name}_real a[3], const ${name}_real b[3], ${name}_real out[3])
{
  out[0] = a[1]*b[2] - a[2]*b[1];
  out[1] = a[2]*b[0] - a[0]*b[2];
  out[2] = a[0]*b[1] - a[1]*b[0];
}

%% end
/* exponent of the largest of n numbers; 0 if all are 0 */
static int ${name}_exponent(const ${name}_real v[], int n)
{
  ${name}_real big = ${zero};
  int e = 0;

  for (int i = 0; i < n; i++) big = ${fabs}(v[i]) > big ? ${fabs}(v[i]) : big;
  if (big > ${zero}) (void)${frexp}(big, &e);
  return e;
}

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  const ${name}_real *r = x0 + ${upper}_RX;
  const ${name}_real g[3] = {${g1}, ${g2}, ${g3}};
%% if framed then
  const ${name}_real O[3] = {${O1}, ${O2}, ${O3}}, k[2] = {${along}, ${across}}; /* stiffness along and across, per kg */
  ${name}_pair square = ${name}_pair_of(${zero}), turn, kappa;
  ${name}_real u[3];
%% else
  const ${name}_real k[3] = {${k1}, ${k2}, ${k3}}; /* stiffness per kg */
%% end
  ${name}_orbit p;
  int i, e;

%% if uses_model then
%% else
  (void)m; /* every constant is in the code */
%% end
  for (i = 0; i < ${upper}_NX; i++) {
    if (!(x0[i] - x0[i] == ${zero})) return 1;
  }
%% if framed then
  e = ${name}_exponent(k, 2);
  e = e > 0 ? (e + 1)/2 : e/2;
  i = ${name}_exponent(O, 3);
  if (k[0] == ${zero} && k[1] == ${zero}) e = i;
  if (${name}_exponent(O, 3) > e && (O[0] != ${zero} || O[1] != ${zero} || O[2] != ${zero})) e = i;
  p.e = e;

  /* the frame's rate and axis; without rate any axis serves */
  for (i = 0; i < 3; i++) {
    u[i] = ${ldexp}(O[i], -e);
    square = ${name}_add(square, ${name}_pair_product(u[i], u[i]));
  }
  turn = ${name}_pair_root(square);
  p.turn[0] = turn.hi;
  p.turn[1] = turn.lo;
  for (i = 0; i < 3; i++) p.n[i] = turn.hi > ${zero} ? u[i]/turn.hi : ${zero};
%% if axis_x then
  if (!(turn.hi > ${zero})) p.n[0] = ${one};
%% else
%%   if axis_y then
  if (!(turn.hi > ${zero})) p.n[1] = ${one};
%%   else
  if (!(turn.hi > ${zero})) p.n[2] = ${one};
%%   end
%% end

  ${name}_wave_set(&p.along, ${name}_pair_of(${ldexp}(k[0], -2*e)));
  kappa = ${name}_pair_of(${ldexp}(k[1], -2*e));
%% if centrifugal then
  p.delta = ${name}_add(square, ${name}_minus(kappa)).hi;
%% else
  p.delta = -kappa.hi;
  kappa = ${name}_add(square, kappa);
%% end
  ${name}_wave_set(&p.across, kappa);
  kappa = ${name}_pair_of(p.across.rate[0]);
  kappa.lo = p.across.rate[1];
  square = ${name}_add(turn, kappa);
  p.fast[0] = square.hi;
  p.fast[1] = square.lo;
  square = ${name}_add(turn, ${name}_minus(kappa));
  p.slow[0] = square.hi;
  p.slow[1] = square.lo;

  for (i = 0; i < 3; i++) {
    p.y[0][i] = r[i];
    p.y[1][i] = ${ldexp}(x0[${upper}_VX + i], -e);
    p.y[2][i] = ${ldexp}(g[i], -2*e);
  }
  for (int j = 0; j < 3; j++) {
    p.s[j] = p.n[0]*p.y[j][0] + p.n[1]*p.y[j][1] + p.n[2]*p.y[j][2];
    for (i = 0; i < 3; i++) p.z[j][i] = p.y[j][i] - p.n[i]*p.s[j];
    ${name}_cross(p.n, p.z[j], p.nz[j]);
    if (!(p.s[j] - p.s[j] == ${zero})) return 1;
    for (i = 0; i < 3; i++) {
      if (!(p.z[j][i] - p.z[j][i] == ${zero})) return 1;
    }
  }
%% else
  e = ${name}_exponent(k, 3);
  e = e > 0 ? (e + 1)/2 : e/2;
  p.e = e;
  for (i = 0; i < 3; i++) {
    ${name}_wave_set(&p.wave[i], ${name}_pair_of(${ldexp}(k[i], -2*e)));
    p.s[i][0] = r[i];
    p.s[i][1] = ${ldexp}(x0[${upper}_VX + i], -e);
    p.s[i][2] = ${ldexp}(g[i], -2*e);
    if (!(p.s[i][1] - p.s[i][1] == ${zero} && p.s[i][2] - p.s[i][2] == ${zero})) return 1;
  }
%% end
  if (!${name}_starts(&p)) return 1;
  ${name}_copy(o, &p, (unsigned int)sizeof(p));
  return 0;
}

%% if framed then
/* while no phase exceeds one: from r + v t + g t^2/2, so that a small deflection keeps its figures.  With i for n x and
 * r, v, g for their parts across, z = r (1 + delta P) + v P' + g P; along n the same with Omega = 0, delta = -kappa. */
static void ${name}_near(const ${name}_orbit *o, ${name}_real T, ${name}_real r[3], ${name}_real v[3])
{
  const ${name}_real O = o->turn[0], d = o->delta, half = ${half}*T*T;
  const ${name}_real k = (${name}_real)o->along.kind*o->along.rate[0]*o->along.rate[0];
  ${name}_real P[2], dP[2], Q[2], dQ[2], s, ds;

  ${name}_set_series(${zero}, -k*T*T, T, Q, dQ);
  s = o->s[1]*dQ[0] + o->s[2]*Q[0] - o->s[0]*k*(half + Q[0]);
  ds = o->s[2]*dQ[0] - o->s[0]*k*(T + dQ[0]) - o->s[1]*k*(half + Q[0]);

  ${name}_set_series(O*T, d*T*T, T, P, dP);
  for (int i = 0; i < 3; i++) {
    const ${name}_real a = d*o->z[0][i], na = d*o->nz[0][i]; /* delta r */
    const ${name}_real b = a - ${two}*O*o->nz[1][i], nb = na + ${two}*O*o->z[1][i]; /* delta r - 2 i Omega v */

    r[i] = (o->y[0][i] + T*o->y[1][i] + half*o->y[2][i]) +
           (o->n[i]*s + a*(half + P[0]) + na*P[1] + o->z[1][i]*dP[0] + o->nz[1][i]*dP[1] + o->z[2][i]*P[0] + o->nz[2][i]*P[1]);
    v[i] = (o->y[1][i] + T*o->y[2][i]) + (o->n[i]*ds + b*(T + dP[0]) + nb*dP[1] + d*(o->z[1][i]*(half + P[0]) + o->nz[1][i]*P[1]) +
           o->z[2][i]*dP[0] + o->nz[2][i]*dP[1]);
  }
}

%% end
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  const ${name}_real T = ${ldexp}(t, o->e);
  ${name}_real *r = x + ${upper}_RX, *v = x + ${upper}_VX, f[3];
%% if framed then
  ${name}_real P[2], s, ds, sh, ch, c, sn, back;

  if ((o->turn[0] + o->across.rate[0] + o->along.rate[0])*${fabs}(T) < ${one}) {
    ${name}_near(o, T, r, v);
    for (int i = 0; i < 3; i++) v[i] = ${ldexp}(v[i], o->e);
    return;
  }
  ${name}_wave_at(&o->along, T, f);
  s = o->s[0]*f[0] + o->s[1]*f[1] + o->s[2]*f[2];
  ds = o->s[1]*f[0] + o->s[2]*f[1] - o->s[0]*${name}_wave_back(&o->along, f[1]);

  ${name}_wave_at(&o->across, T, f);
  back = ${name}_wave_back(&o->across, f[1]);
  ${name}_turn_of(o->turn, T, &sh, &ch);
  sn = ${two}*sh*ch;
  c = (ch - sh)*(ch + sh);
  ${name}_push(o, T, f[0], f[1], c, sn, P);
  for (int i = 0; i < 3; i++) { /* a turn by -Omega t: u becomes c u - sn n x u */
    const ${name}_real w = o->z[1][i] + o->turn[0]*o->nz[0][i], nw = o->nz[1][i] - o->turn[0]*o->z[0][i];
    const ${name}_real z = o->z[0][i]*f[0] + w*f[1], nz = o->nz[0][i]*f[0] + nw*f[1];
    const ${name}_real dz = w*f[0] - o->z[0][i]*back - o->turn[0]*nz;
    const ${name}_real ndz = nw*f[0] - o->nz[0][i]*back + o->turn[0]*z;

    r[i] = (c*z - sn*nz) + (P[0]*o->z[2][i] + P[1]*o->nz[2][i]) + o->n[i]*s;
    v[i] = ${ldexp}((c*dz - sn*ndz) + f[1]*(c*o->z[2][i] - sn*o->nz[2][i]) + o->n[i]*ds, o->e);
  }
%% else

  for (int i = 0; i < 3; i++) {
    ${name}_wave_at(&o->wave[i], T, f);
    r[i] = o->s[i][0]*f[0] + o->s[i][1]*f[1] + o->s[i][2]*f[2];
    v[i] = o->s[i][1]*f[0] + o->s[i][2]*f[1] - o->s[i][0]*${name}_wave_back(&o->wave[i], f[1]);
    v[i] = ${ldexp}(v[i], o->e);
  }
%% end
}

void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[])
{
  ${name}_real y[${upper}_NX];

  for (int k = 0; k < n; k++) {
    ${name}_at(o, t[k], y);
    for (int i = 0; i < ${upper}_NX; i++) x[i*n + k] = y[i];
  }
}
