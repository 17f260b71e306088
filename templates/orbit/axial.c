%% -- axial.c -- rates of a symmetric top under axial torque and damping: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ---- */

static void ${name}_keep(${name}_pair a, ${name}_real out[2])
{
  out[0] = a.hi;
  out[1] = a.lo;
}

static int ${name}_is_finite(const ${name}_real a[2])
{
  return a[0] - a[0] == ${zero} && a[1] - a[1] == ${zero};
}

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  const ${name}_real *w = x0 + ${upper}_WX;
  const ${name}_real k[3] = {${kx}, ${ky}, ${kz}}; /* symmetry axis, body; its square is k2 */
  const ${name}_real k2 = ${k2}, I1 = ${I1}, I3 = ${I3};
  const ${name}_real ku = ${sqrt}(k2);
  const ${name}_pair inverse = {${half_inverse_pi_high}, ${half_inverse_pi_low}}; /* of a turn */
  ${name}_pair s, excess, push, decay1, decay3, rotor, length, one;
  ${name}_orbit p;
  int e;

%% if uses_model then
%% else
  (void)m; /* every constant is in the code */
%% end
  for (int i = 0; i < 3; i++) {
    if (!(w[i] - w[i] == ${zero})) return 1;
  }
  /* moments by a power of two: huge ones must not overflow in a split */
  (void)${frexp}(I1, &e);
  one = ${name}_pair_of(${ldexp}(I1, -e));
  excess = ${name}_ratio(${name}_pair_sum(${ldexp}(I3, -e), -one.hi), one); /* I3/I1 - 1 */
  decay1 = ${name}_ratio(${name}_pair_of(${ldexp}(${c1}, -e)), one);
  rotor = ${name}_ratio(${name}_pair_of(${ldexp}(${hk}, -e)), one);
%% if rod then
  push = decay3 = ${name}_pair_of(${zero}); /* a rod has no moment along itself, and nothing acts there */
%% else
  (void)${frexp}(I3, &e);
  one = ${name}_pair_of(${ldexp}(I3, -e));
  push = ${name}_ratio(${name}_pair_of(${ldexp}(${torque}, -e)), one);
  decay3 = ${name}_ratio(${name}_pair_of(${ldexp}(${c3}, -e)), one);
%% end

  s = ${name}_pair_product(k[0], w[0]);
  s = ${name}_add(s, ${name}_pair_product(k[1], w[1]));
  s = ${name}_ratio(${name}_add(s, ${name}_pair_product(k[2], w[2])), ${name}_pair_of(k2));
  for (int i = 0; i < 3; i++) {
    p.k[i] = k[i];
    p.across[i] = ${name}_add(${name}_pair_of(w[i]), ${name}_mul(${name}_pair_of(-k[i]), s)).hi;
  }
  p.turned[0] = (k[1]*p.across[2] - k[2]*p.across[1])/ku;
  p.turned[1] = (k[2]*p.across[0] - k[0]*p.across[2])/ku;
  p.turned[2] = (k[0]*p.across[1] - k[1]*p.across[0])/ku;
  p.s = s.hi;
  p.push = push.hi;
  ${name}_keep(decay1, p.decay1);
  ${name}_keep(decay3, p.decay3);

  length = ${name}_pair_product(ku, ku); /* ku is rounded: |k| = ku + (k2 - ku^2)/(2 ku) */
  length = ${name}_pair_sum(ku, ((k2 - length.hi) - length.lo)/(${two}*ku));
  length = ${name}_mul(inverse, length); /* turns per radian, of a rate over |k| */
  ${name}_keep(${name}_mul(length, rotor), p.steady);
  length = ${name}_mul(length, excess);
  ${name}_keep(${name}_mul(length, s), p.free);
  ${name}_keep(${name}_mul(length, push), p.pushed);
  if (!${name}_is_finite(p.free) || !${name}_is_finite(p.pushed) || !${name}_is_finite(p.steady)
      || !${name}_is_finite(p.decay1) || !${name}_is_finite(p.decay3) || !(p.push - p.push == ${zero})) return 1;
  if (!${name}_starts(&p)) return 1;
  ${name}_copy(o, &p, (unsigned int)sizeof(p));
  return 0;
}

void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[])
{
  const ${name}_pair time = ${name}_pair_of(t), decay1 = {-o->decay1[0], -o->decay1[1]}, decay3 = {-o->decay3[0], -o->decay3[1]};
  const ${name}_pair free = {o->free[0], o->free[1]}, pushed = {o->pushed[0], o->pushed[1]}, steady = {o->steady[0], o->steady[1]};
  const ${name}_pair y = ${name}_mul(decay3, time);
  ${name}_pair f1, f2, phase;
  ${name}_real s, sine, cosine, along;

  ${name}_means(y, &f1, &f2);
  f2 = ${name}_mul(pushed, ${name}_mul(time, f2));
  phase = ${name}_add(${name}_mul(free, f1), ${name}_add(f2, steady));
  phase = ${name}_mul(phase, time); /* turns */
  phase.hi = (phase.hi - ${name}_nearest(phase.hi)) + phase.lo;
  ${name}_circle(phase.hi - ${name}_nearest(phase.hi), &sine, &cosine);
  s = ${name}_exponential(${name}_mul(decay1, time));
  along = o->s*${name}_exponential(y) + o->push*(t*f1.hi);
  for (int i = 0; i < 3; i++) w[i] = along*o->k[i] + s*(cosine*o->across[i] + sine*o->turned[i]);
}
