/* sweep_draw.c -- the values of a member: grids, random numbers by counter, points that fill a space evenly.
 * template: templates/sweep/sweep_draw.c.  SPDX-License-Identifier: MIT-0
 *
 * No generator has a state: a random number is a function of the seed, the member and the number's own purpose. */
#include "sweep.h"

#include <math.h> /* sqrt alone, which IEEE 754 rounds correctly */

/* ---- Philox4x32-10: J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, Parallel random numbers: as easy as 1, 2, 3,
 * SC11 (2011), section 4.3 ---- */

void sweep_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4])
{
  uint32_t a = counter[0], b = counter[1], c = counter[2], d = counter[3], k = key[0], l = key[1];
  int i;

  for (i = 0; i < 10; i++) {
    const uint64_t first = (uint64_t)0xD2511F53U*a, second = (uint64_t)0xCD9E8D57U*c;

    a = (uint32_t)(second >> 32) ^ b ^ k;
    b = (uint32_t)second;
    c = (uint32_t)(first >> 32) ^ d ^ l;
    d = (uint32_t)first;
    k += 0x9E3779B9U;
    l += 0xBB67AE85U;
  }
  out[0] = a;
  out[1] = b;
  out[2] = c;
  out[3] = d;
}

/* 64 random bits */
static uint64_t bits(uint64_t seed, uint64_t member, uint32_t draw, uint32_t purpose)
{
  const uint32_t counter[4] = {(uint32_t)member, (uint32_t)(member >> 32), draw, purpose};
  const uint32_t key[2] = {(uint32_t)seed, (uint32_t)(seed >> 32)};
  uint32_t out[4];

  sweep_philox(counter, key, out);
  return (uint64_t)out[1] << 32 | out[0];
}

/* The middles of 2^52 equal parts of (0, 1): exact, and neither 0 nor 1. */
double sweep_uniform(uint64_t seed, uint64_t member, uint32_t draw, uint32_t purpose)
{
  return ((double)(bits(seed, member, draw, purpose) >> 12) + 0.5)*2.220446049250313e-16;
}

/* ---- the normal distribution's inverse: rational functions of Wichura, Algorithm AS 241, Applied Statistics 37
 * (1988) 477-484, PPND16: relative error of the functions below 1e-16 ---- */

static double quotient(const double n[8], const double d[8], double r)
{
  double above = n[7], below = d[7];
  int i;

  for (i = 6; i >= 0; i--) {
    above = above*r + n[i];
    below = below*r + d[i];
  }
  return above/below;
}

double sweep_normal(double u)
{
  static const double a[8] = {3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3,
    1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4, 3.3430575583588128105e4,
    2.5090809287301226727e3};
  static const double b[8] = {1.0, 4.2313330701600911252e1, 6.8718700749205790830e2, 5.3941960214247511077e3,
    2.1213794301586595867e4, 3.9307895800092710610e4, 2.8729085735721942674e4, 5.2264952788528545610e3};
  static const double c[8] = {1.42343711074968357734e0, 4.63033784615654529590e0, 5.76949722146069140550e0,
    3.64784832476320460504e0, 1.27045825245236838258e0, 2.41780725177450611770e-1, 2.27238449892691845833e-2,
    7.74545014278341407640e-4};
  static const double d[8] = {1.0, 2.05319162663775882187e0, 1.67638483018380384940e0, 6.89767334985100004550e-1,
    1.48103976427480074590e-1, 1.51986665636164571966e-2, 5.47593808499534494600e-4, 1.05075007164441684324e-9};
  static const double e[8] = {6.65790464350110377720e0, 5.46378491116411436990e0, 1.78482653991729133580e0,
    2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3, 2.71155556874348757815e-5,
    2.01033439929228813265e-7};
  static const double f[8] = {1.0, 5.99832206555887937690e-1, 1.36929880922735805310e-1, 1.48753612908506148525e-2,
    7.86869131145613259100e-4, 1.84631831751005468180e-5, 1.42151175831644588870e-7, 2.04426310338993978564e-15};
  const double q = u - 0.5;
  double r;

  if (q >= -0.425 && q <= 0.425) return q*quotient(a, b, 0.180625 - q*q);
  r = sqrt(-sweep_math_log(q < 0.0 ? u : 1.0 - u));
  r = r <= 5.0 ? quotient(c, d, r - 1.6) : quotient(e, f, r - 5.0);
  return q < 0.0 ? -r : r;
}

/* ---- Latin hypercubes ---- */

/* Member i of a keyed permutation of 0 .. n - 1: a Feistel network of four rounds on as many bits as n needs, an even
 * number of them, again and again until the result is below n (cycle walking). */
uint64_t sweep_permuted(uint64_t seed, uint32_t which, uint64_t i, uint64_t n)
{
  uint64_t mask;
  int half = 1;

  while (half < 32 && (uint64_t)1 << 2*half < n) half++;
  mask = ((uint64_t)1 << half) - 1;
  do {
    uint64_t left = i >> half, right = i & mask;
    uint32_t round;

    for (round = 0; round < 4; round++) {
      const uint64_t swap = left ^ (bits(seed, right, which, 16 + round) & mask);

      left = right;
      right = swap;
    }
    i = left << half | right;
  } while (i >= n);
  return i;
}

/* ---- a member's point ---- */

/* Number `d` of the point, within (0, 1).  Purposes of random numbers: 1 these, 2 a Sobol' sequence's shift, 3 the
 * place within a stratum, 16 and more the permutations. */
static double coordinate(const sweep_study *s, uint64_t member, int d)
{
  const uint64_t i = member%s->samples;

  if (s->points == SWEEP_SOBOL) {
    const uint32_t shift = (uint32_t)bits(s->seed, 0, (uint32_t)d, 2);

    return ((double)(sweep_sobol(i, d) ^ shift) + 0.5)*2.3283064365386963e-10;
  }
  if (s->points == SWEEP_LHS) { /* i below 2^32: the sum is exact, and less than `samples` when divided and rounded */
    const uint64_t stratum = sweep_permuted(s->seed, (uint32_t)d, i, s->samples);
    const double within = ((double)(bits(s->seed, member, (uint32_t)d, 3) >> 44) + 0.5)*9.5367431640625e-07;

    return ((double)stratum + within)/(double)s->samples;
  }
  return sweep_uniform(s->seed, member, (uint32_t)d, 1);
}

static double gridded(const sweep_axis *a, uint64_t i)
{
  double x;

  if (i == 0) return a->low;
  if (i == a->count - 1) return a->high;
  x = (double)i/(double)(a->count - 1);
  if (!a->log) return a->low + x*(a->high - a->low);
  return a->low*sweep_math_exp(x*sweep_math_log(a->high/a->low));
}

/* Uniform over all attitudes from three uniform numbers: K. Shoemake, Graphics Gems III (1992), p. 129. */
static double attitude(const sweep_study *s, uint64_t member, const sweep_draw *d)
{
  const double two_pi = 6.283185307179586, u = coordinate(s, member, d->dimension);
  const double angle = two_pi*coordinate(s, member, d->dimension + (d->part < 2 ? 1 : 2));

  return sqrt(d->part < 2 ? u : 1.0 - u)*(d->part%2 == 0 ? sweep_math_cos(angle) : sweep_math_sin(angle));
}

void sweep_values(const sweep_study *s, uint64_t member, double v[])
{
  uint64_t left = member/s->samples;
  int i, j;

  for (i = s->axis_count - 1; i >= 0; i--) { /* the last axis is the fastest */
    v[i] = gridded(&s->axes[i], left%s->axes[i].count);
    left /= s->axes[i].count;
  }
  for (i = 0; i < s->draw_count; i++) {
    const sweep_draw *d = &s->draws[i];
    double *to = &v[s->axis_count + i];

    switch (d->kind) {
    case SWEEP_UNIFORM: *to = d->a + coordinate(s, member, d->dimension)*(d->b - d->a); break;
    case SWEEP_LOGUNIFORM:
      *to = d->a*sweep_math_exp(coordinate(s, member, d->dimension)*sweep_math_log(d->b/d->a));
      break;
    case SWEEP_NORMAL: *to = d->a + d->b*sweep_normal(coordinate(s, member, d->dimension)); break;
    case SWEEP_ATTITUDE: *to = attitude(s, member, d); break;
    case SWEEP_JOINT:
      *to = 0.0;
      for (j = 0; j < d->part; j++) *to += d->row[j]*sweep_normal(coordinate(s, member, d->dimension + j));
      *to += d->a;
      break;
    }
  }
}

/* ---- attitudes ---- */

void sweep_unit(double q[4])
{
  const double n = sqrt(q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);
  int i;

  for (i = 0; i < 4; i++) q[i] /= n;
}

/* q exp(v/2) about body axes, exp(v/2) q about those of space; exp(v/2) = (cos a/2, v/a sin a/2), a = |v| */
void sweep_turn(double q[4], double a, double b, double c, int body)
{
  const double angle = sqrt(a*a + b*b + c*c), w = sweep_math_cos(0.5*angle);
  const double s = angle > 1e-100 ? sweep_math_sin(0.5*angle)/angle : 0.5;
  const double x = s*a, y = s*b, z = s*c, way = body ? 1.0 : -1.0;
  const double qw = q[0], qx = q[1], qy = q[2], qz = q[3];

  q[0] = qw*w - qx*x - qy*y - qz*z;
  q[1] = qw*x + qx*w + way*(qy*z - qz*y);
  q[2] = qw*y + qy*w + way*(qz*x - qx*z);
  q[3] = qw*z + qz*w + way*(qx*y - qy*x);
}
