%% -- closed.c -- the closed form of the free sphere and symmetric top: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ---- */

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  const ${name}_real *w = x0 + ${upper}_WX;
%% if symmetric then
  const ${name}_real k[3] = {${kx}, ${ky}, ${kz}}; /* symmetry axis, body; its square is k2 */
  const ${name}_real k2 = ${k2}, I1 = ${I1}, I3 = ${I3};
  const ${name}_real ku = ${sqrt}(k2);
  ${name}_pair s, excess, along;
%% end
  ${name}_pair v[3], length;
%% if flies then
  const ${name}_real g[3] = {${g1}, ${g2}, ${g3}};
%% end
  ${name}_real u[3], left[4], fastest;
  ${name}_orbit p;
  int i;

%% if uses_model then
%% else
  (void)m; /* every constant is in the code */
%% end
  for (i = 0; i < ${upper}_NX; i++) {
    if (!(x0[i] - x0[i] == ${zero})) return 1;
  }
%% if symmetric then
%% if rotor then
  /* L/I1 = w + ((I3/I1 - 1) (k.w)/k^2 + h/I1) k, the rate of the precession, body axes; the rotor holds h k */
%% else
  /* L/I1 = w + (I3/I1 - 1) (k.w) k/k^2, the rate of the precession, body axes */
%% end
  s = ${name}_pair_product(k[0], w[0]);
  s = ${name}_add(s, ${name}_pair_product(k[1], w[1]));
  s = ${name}_ratio(${name}_add(s, ${name}_pair_product(k[2], w[2])), ${name}_pair_of(k2));
  (void)${frexp}(I1, &i); /* by a power of two: huge moments must not overflow in a split */
  excess = ${name}_ratio(${name}_pair_sum(${ldexp}(I3, -i), -${ldexp}(I1, -i)), ${name}_pair_of(${ldexp}(I1, -i)));
  along = ${name}_mul(excess, s);
%% if rotor then
  along = ${name}_add(along, ${name}_ratio(${name}_pair_of(${ldexp}(${hk}, -i)), ${name}_pair_of(${ldexp}(I1, -i))));
%% end
  for (i = 0; i < 3; i++) v[i] = ${name}_add(${name}_pair_of(w[i]), ${name}_mul(along, ${name}_pair_of(k[i])));
%% else
  /* L/I1 = w */
  for (i = 0; i < 3; i++) v[i] = ${name}_pair_of(w[i]);
%% end
  length = ${name}_unit_vector(v, u);
  ${name}_half_turns(length, p.about);
  p.mean = length.hi;

  if (${name}_unit_quaternion(x0 + ${upper}_QW, p.q[0]) == ${zero}) return 1;

  /* turning about L on the left is turning about its body direction on the right of q0 */
  left[0] = ${zero};
  for (i = 0; i < 3; i++) left[i + 1] = u[i];
  ${name}_quaternion_product(p.q[0], left, p.q[1]);
%% if symmetric then
  length = ${name}_pair_product(ku, ku); /* ku is rounded: |k| = ku + (k2 - ku^2)/(2 ku) */
  length = ${name}_pair_sum(ku, ((k2 - length.hi) - length.lo)/(${two}*ku));
  length = ${name}_mul(along, length);
  ${name}_half_turns(${name}_minus(length), p.spin);
  for (i = 0; i < 3; i++) left[i + 1] = k[i]/ku;
  ${name}_quaternion_product(p.q[0], left, p.q[2]);
  ${name}_quaternion_product(p.q[1], left, p.q[3]);

  /* w along and across k; k x across, turned backwards, is where w goes next */
  for (i = 0; i < 3; i++) {
    p.along[i] = s.hi*k[i];
    p.across[i] = ${name}_add(${name}_pair_of(w[i]), ${name}_mul(${name}_pair_of(-k[i]), s)).hi;
  }
  p.turned[0] = (k[2]*p.across[1] - k[1]*p.across[2])/ku;
  p.turned[1] = (k[0]*p.across[2] - k[2]*p.across[0])/ku;
  p.turned[2] = (k[1]*p.across[0] - k[0]*p.across[1])/ku;
%% else
  for (i = 0; i < 4; i++) p.q[2][i] = p.q[3][i] = ${zero};
  for (i = 0; i < 3; i++) {
    p.along[i] = w[i];
    p.across[i] = p.turned[i] = ${zero};
  }
%% end
  if (!(${fabs}(p.across[0]) + ${fabs}(p.across[1]) + ${fabs}(p.across[2]) > ${zero})) { /* w is constant, along L */
    p.mean = w[0]*u[0] + w[1]*u[1] + w[2]*u[2];
  }
  if (!(p.about[3] - p.about[3] == ${zero})) return 1; /* |L|/I1 is beyond the range of the type */
%% if symmetric then
  if (!(p.spin[3] - p.spin[3] == ${zero})) return 1;
%% end
  fastest = p.about[0];
%% if symmetric then
  if (${fabs}(p.spin[0]) > fastest) fastest = ${fabs}(p.spin[0]);
%% end
  p.last = fastest*${last_time} > ${last_turn} ? ${last_turn}/fastest : ${last_time};
%% if flies then
  for (i = 0; i < 3; i++) p.g[i] = g[i];
  ${name}_launch(&p, x0);
%% end
%% if damped then
  p.decay = ${decay};
%% elseif not flies then
%% if has_tick_fields then
  p.about_tick[0] = p.about_tick[1] = 0;
%% end
%% if symmetric then
%% if has_tick_fields then
  p.spin_tick[0] = p.spin_tick[1] = 0;
%% end
%% end
%% end
  if (!${name}_starts(&p)) return 1;
  ${name}_copy(o, &p, (unsigned int)sizeof(p));
  return 0;
}

%% if symmetric then
/* the attitude after a turn about L by twice the angle of (c, s), about k by twice that of (ck, sk) */
${inline} void ${name}_attitude(const ${name}_orbit *o, ${name}_real c, ${name}_real s, ${name}_real ck, ${name}_real sk, ${name}_real q[4])
{
  const ${name}_real f0 = c*ck, f1 = s*ck, f2 = c*sk, f3 = s*sk;
  ${name}_real n;

  q[0] = (f0*o->q[0][0] + f1*o->q[1][0]) + (f2*o->q[2][0] + f3*o->q[3][0]);
  q[1] = (f0*o->q[0][1] + f1*o->q[1][1]) + (f2*o->q[2][1] + f3*o->q[3][1]);
  q[2] = (f0*o->q[0][2] + f1*o->q[1][2]) + (f2*o->q[2][2] + f3*o->q[3][2]);
  q[3] = (f0*o->q[0][3] + f1*o->q[1][3]) + (f2*o->q[2][3] + f3*o->q[3][3]);
%% else
/* the attitude after a turn about L by twice the angle of (c, s) */
${inline} void ${name}_attitude(const ${name}_orbit *o, ${name}_real c, ${name}_real s, ${name}_real q[4])
{
  ${name}_real n;

  q[0] = c*o->q[0][0] + s*o->q[1][0];
  q[1] = c*o->q[0][1] + s*o->q[1][1];
  q[2] = c*o->q[0][2] + s*o->q[1][2];
  q[3] = c*o->q[0][3] + s*o->q[1][3];
%% end
  /* rounding only: one Newton step for 1/|q| */
  n = ${threehalves} - ${half}*((q[0]*q[0] + q[1]*q[1]) + (q[2]*q[2] + q[3]*q[3]));
  q[0] *= n;
  q[1] *= n;
  q[2] *= n;
  q[3] *= n;
}

%% if symmetric then
/* the rates: across has turned by twice the angle */
${inline} void ${name}_rates(const ${name}_orbit *o, ${name}_real ck, ${name}_real sk, ${name}_real w[3])
{
  const ${name}_real cosine = (ck - sk)*(ck + sk), sine = ${two}*(sk*ck);

  w[0] = o->along[0] + (cosine*o->across[0] + sine*o->turned[0]);
  w[1] = o->along[1] + (cosine*o->across[1] + sine*o->turned[1]);
  w[2] = o->along[2] + (cosine*o->across[2] + sine*o->turned[2]);
}

%% end
/* attitude and rates from the phases */
%% if symmetric then
${inline} void ${name}_state(const ${name}_orbit *o, ${name}_real about, ${name}_real spin, ${name}_real q[4], ${name}_real w[3])
{
  ${name}_real s, c, sk, ck;

  ${name}_circle(about, &s, &c);
  ${name}_circle(spin, &sk, &ck);
  ${name}_attitude(o, c, s, ck, sk, q);
  ${name}_rates(o, ck, sk, w);
}
%% else
${inline} void ${name}_state(const ${name}_orbit *o, ${name}_real about, ${name}_real q[4], ${name}_real w[3])
{
  ${name}_real s, c;

  ${name}_circle(about, &s, &c);
  ${name}_attitude(o, c, s, q);
  w[0] = o->along[0];
  w[1] = o->along[1];
  w[2] = o->along[2];
}
%% end

%% if damped then
/* the phase after a time of twice the working precision */
static ${name}_real ${name}_phase_of(const ${name}_orbit *o, const ${name}_real rate[4], ${name}_pair time)
{
  const ${name}_real turns = ${name}_phase(o, rate, time.hi) + ${name}_turns_of(rate[0], time.lo);

  return turns - ${name}_nearest(turns);
}

void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  const ${name}_pair y = ${name}_passed_decays(o->decay, t), time = ${name}_free_time(o, t, y);
%% if rod then
  const ${name}_real spin = ${name}_phase(o, o->spin, t); /* a rod's rate along itself carries no L and is not damped */
%% elseif symmetric then
  const ${name}_real spin = ${name}_phase_of(o, o->spin, time);
%% end
  ${name}_real *w = x + ${upper}_WX;

%% if symmetric then
  ${name}_state(o, ${name}_phase_of(o, o->about, time), spin, x + ${upper}_QW, w);
%% else
  ${name}_state(o, ${name}_phase_of(o, o->about, time), x + ${upper}_QW, w);
%% end
%% if rod then
  for (int i = 0; i < 3; i++) w[i] -= o->along[i];
  ${name}_fade(y, w);
  for (int i = 0; i < 3; i++) w[i] += o->along[i];
%% else
  ${name}_fade(y, w);
%% end
}
%% else
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
%% if symmetric then
  ${name}_state(o, ${name}_phase(o, o->about, t), ${name}_phase(o, o->spin, t), x + ${upper}_QW, x + ${upper}_WX);
%% else
  ${name}_state(o, ${name}_phase(o, o->about, t), x + ${upper}_QW, x + ${upper}_WX);
%% end
%% if flies then
  ${name}_carried(o, t, x);
%% end
}

void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[])
{
%% if symmetric then
  ${name}_real sk, ck;

  ${name}_circle(${name}_phase(o, o->spin, t), &sk, &ck);
  ${name}_rates(o, ck, sk, w);
%% else

  (void)t; /* they are constant */
  for (int i = 0; i < 3; i++) w[i] = o->along[i];
%% end
}

void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[])
{
  ${name}_real s, c;
%% if symmetric then
  ${name}_real sk, ck;

  ${name}_circle(${name}_phase(o, o->about, t), &s, &c);
  ${name}_circle(${name}_phase(o, o->spin, t), &sk, &ck);
  ${name}_attitude(o, c, s, ck, sk, q);
%% else

  ${name}_circle(${name}_phase(o, o->about, t), &s, &c);
  ${name}_attitude(o, c, s, q);
%% end
}

%% if not flies then
void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[])
{
  const ${name}_orbit orbit = *o;
  ${name}_real time[16], block[${upper}_NX][16], *row;
  int i;

  for (int first = 0; first < n; first += 16) { /* sixteen at a time, into arrays of their own: nothing can overlap */
    const int count = n - first < 16 ? n - first : 16;

    for (int k = 0; k < 16; k++) time[k] = t[first + (k < count ? k : 0)];
    for (int k = 0; k < 16; k++) {
      ${name}_real q[4], w[3];

%% if symmetric then
      ${name}_state(&orbit, ${name}_phase(&orbit, orbit.about, time[k]), ${name}_phase(&orbit, orbit.spin, time[k]), q, w);
%% else
      ${name}_state(&orbit, ${name}_phase(&orbit, orbit.about, time[k]), q, w);
%% end
      block[${upper}_QW][k] = q[0];
      block[${upper}_QX][k] = q[1];
      block[${upper}_QY][k] = q[2];
      block[${upper}_QZ][k] = q[3];
      block[${upper}_WX][k] = w[0];
      block[${upper}_WY][k] = w[1];
      block[${upper}_WZ][k] = w[2];
    }
    for (int k = 0; k < count; k++) {
      for (i = 0, row = x + (first + k);; row += n) {
        *row = block[i][k];
        if (++i == ${upper}_NX) break;
      }
    }
  }
}

int ${name}_set_tick(${name}_orbit *o, ${name}_real h)
{
  const ${name}_pair step = ${name}_pair_of(h), rate = {o->about[0], o->about[1]};
  const ${name}_pair about = ${name}_mul(step, rate);
%% if symmetric then
  const ${name}_pair own = {o->spin[0], o->spin[1]}, spin = ${name}_mul(step, own);

  if (!(spin.hi - spin.hi == ${zero})) return 1;
%% end
  if (!(about.hi - about.hi == ${zero})) return 1;
  ${name}_fraction_bits(about, o->about_tick);
%% if symmetric then
  ${name}_fraction_bits(spin, o->spin_tick);
%% end
  return 0;
}

void ${name}_at_tick(const ${name}_orbit *o, int64_t n, ${name}_real x[])
{
  const uint64_t start[2] = {0, 0};
  const ${name}_real about = ${name}_as_turns(${name}_counted(start, o->about_tick, n));
%% if symmetric then
  const ${name}_real spin = ${name}_as_turns(${name}_counted(start, o->spin_tick, n));

  ${name}_state(o, about, spin, x + ${upper}_QW, x + ${upper}_WX);
%% else

  ${name}_state(o, about, x + ${upper}_QW, x + ${upper}_WX);
%% end
}

%% end
/* the rates turn by twice the half angle */
${name}_real ${name}_polhode_period(const ${name}_orbit *o)
{
%% if symmetric then
  const ${name}_real across = ${fabs}(o->across[0]) + ${fabs}(o->across[1]) + ${fabs}(o->across[2]);

  return across > ${zero} && ${fabs}(o->spin[0]) > ${zero} ? ${half}/${fabs}(o->spin[0]) : ${zero};
%% else
  (void)o;
  return ${zero};
%% end
}

${name}_real ${name}_precession_rate(const ${name}_orbit *o)
{
  return o->mean;
}

${name}_real ${name}_precession_period(const ${name}_orbit *o)
{
  return ${fabs}(o->mean) > ${zero} ? ${two_pi_high}/${fabs}(o->mean) : ${huge};
}

${name}_real ${name}_rotation_number(const ${name}_orbit *o)
{
%% if symmetric then
  return ${name}_polhode_period(o) > ${zero} ? o->about[0]/${fabs}(o->spin[0]) : ${zero};
%% else
  (void)o;
  return ${zero};
%% end
}

${name}_real ${name}_next_flip(const ${name}_orbit *o, ${name}_real t)
{
  (void)o;
  (void)t;
  return ${huge};
}
%% end
