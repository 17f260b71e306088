%% -- point.c -- the closed form of a point under linear forces: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ---- */

/* sine and cosine of (rate t)/2, rate a pair; the low part of a large phase need not be small */
static void ${name}_turn(const ${name}_real rate[2], ${name}_real t, ${name}_real *s, ${name}_real *c)
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
  kappa = ${name}_pair_root(w->kind < 0 ? ${name}_pair_minus(kappa) : kappa);
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
    ${name}_turn(w->rate, t, &s, &c);
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
/* P = integral over s from 0 to t of exp(-i Omega s) S(s), as real and imaginary part; C, S of the wave across, c and sn
 * the cosine and sine of Omega t.  It solves P'' + 2 i Omega P' - delta P = 1 from rest, whence its power series; away
 * from resonance (delta not small) it is (exp(-i Omega t) (C + i Omega S) - 1)/delta, and at resonance the difference of
 * (1 - exp(-i rate t))/(i rate) over the slow and the fast rate. */
static void ${name}_push(const ${name}_orbit *o, ${name}_real t, ${name}_real C, ${name}_real S, ${name}_real c, ${name}_real sn,
                         ${name}_real P[2])
{
  const ${name}_real O = o->turn[0], sigma = o->across.rate[0], x = O*t, d = o->delta*t*t;

  if (${fabs}(x) + sigma*${fabs}(t) < ${one}) {
    ${name}_real now[2] = {${half}, ${zero}}, before[2] = {${zero}, ${zero}}, next[2];
    int k;

    P[0] = now[0];
    P[1] = now[1];
    for (k = 1; k < 26; k++) { /* terms k + 1 to k + 2 of the series; the 26th is below 1/26! */
      const ${name}_real m = ${one}/((${name}_real)(k + 1)*(${name}_real)(k + 2)), y = ${two}*x*(${name}_real)(k + 1);

      next[0] = m*(d*before[0] + y*now[1]);
      next[1] = m*(d*before[1] - y*now[0]);
      before[0] = now[0];
      before[1] = now[1];
      P[0] += now[0] = next[0];
      P[1] += now[1] = next[1];
    }
    P[0] *= t*t;
    P[1] *= t*t;
  } else if (${fabs}(o->delta) >= ${quarter}*(O*O + sigma*sigma)) {
    P[0] = (c*C + sn*O*S - ${one})/o->delta;
    P[1] = (c*O*S - sn*C)/o->delta;
  } else {
    ${name}_real s, h, fast[2], slow[2];

    ${name}_turn(o->fast, t, &s, &h);
    fast[0] = ${two}*s*h/o->fast[0];
    fast[1] = -${two}*s*s/o->fast[0];
    ${name}_turn(o->slow, t, &s, &h);
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
  int i, e = 0;

  for (i = 0; i < n; i++) big = ${fabs}(v[i]) > big ? ${fabs}(v[i]) : big;
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
  ${name}_real v[3], a[3], u[3];
  int j;
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
    square = ${name}_pair_add(square, ${name}_pair_product(u[i], u[i]));
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
  p.delta = ${name}_pair_add(square, ${name}_pair_minus(kappa)).hi;
%% else
  p.delta = -kappa.hi;
  kappa = ${name}_pair_add(square, kappa);
%% end
  ${name}_wave_set(&p.across, kappa);
  kappa = ${name}_pair_of(p.across.rate[0]);
  kappa.lo = p.across.rate[1];
  square = ${name}_pair_add(turn, kappa);
  p.fast[0] = square.hi;
  p.fast[1] = square.lo;
  square = ${name}_pair_add(turn, ${name}_pair_minus(kappa));
  p.slow[0] = square.hi;
  p.slow[1] = square.lo;

  /* along n and across; the velocity across gains Omega x r */
  for (i = 0; i < 3; i++) {
    v[i] = ${ldexp}(x0[${upper}_VX + i], -e);
    a[i] = ${ldexp}(g[i], -2*e);
  }
  p.s[0] = p.n[0]*r[0] + p.n[1]*r[1] + p.n[2]*r[2];
  p.s[1] = p.n[0]*v[0] + p.n[1]*v[1] + p.n[2]*v[2];
  p.s[2] = p.n[0]*a[0] + p.n[1]*a[1] + p.n[2]*a[2];
  ${name}_cross(p.n, r, u);
  for (i = 0; i < 3; i++) {
    p.z[0][i] = r[i] - p.n[i]*p.s[0];
    p.z[1][i] = (v[i] - p.n[i]*p.s[1]) + turn.hi*u[i];
    p.z[2][i] = a[i] - p.n[i]*p.s[2];
  }
  for (j = 0; j < 3; j++) {
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

void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  const ${name}_real T = ${ldexp}(t, o->e);
  ${name}_real *r = x + ${upper}_RX, *v = x + ${upper}_VX, f[3];
  int i;
%% if framed then
  ${name}_real P[2], s, ds, sh, ch, c, sn, back;

  ${name}_wave_at(&o->along, T, f);
  s = o->s[0]*f[0] + o->s[1]*f[1] + o->s[2]*f[2];
  ds = o->s[1]*f[0] + o->s[2]*f[1] - o->s[0]*${name}_wave_back(&o->along, f[1]);

  ${name}_wave_at(&o->across, T, f);
  back = ${name}_wave_back(&o->across, f[1]);
  ${name}_turn(o->turn, T, &sh, &ch);
  sn = ${two}*sh*ch;
  c = (ch - sh)*(ch + sh);
  ${name}_push(o, T, f[0], f[1], c, sn, P);
  for (i = 0; i < 3; i++) { /* a turn by -Omega t: u becomes c u - sn n x u */
    const ${name}_real z = o->z[0][i]*f[0] + o->z[1][i]*f[1], nz = o->nz[0][i]*f[0] + o->nz[1][i]*f[1];
    const ${name}_real dz = o->z[1][i]*f[0] - o->z[0][i]*back - o->turn[0]*nz;
    const ${name}_real ndz = o->nz[1][i]*f[0] - o->nz[0][i]*back + o->turn[0]*z;

    r[i] = (c*z - sn*nz) + (P[0]*o->z[2][i] + P[1]*o->nz[2][i]) + o->n[i]*s;
    v[i] = ${ldexp}((c*dz - sn*ndz) + f[1]*(c*o->z[2][i] - sn*o->nz[2][i]) + o->n[i]*ds, o->e);
  }
%% else

  for (i = 0; i < 3; i++) {
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
  int i, k;

  for (k = 0; k < n; k++) {
    ${name}_at(o, t[k], y);
    for (i = 0; i < ${upper}_NX; i++) x[i*n + k] = y[i];
  }
}
