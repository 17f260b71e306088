/* lecture.c - the lecture on the rigid body, row by row, in numbers.
   SPDX-License-Identifier: GPL-3.0-or-later

   Kinetic energy and tensor of particles, the brick and the cube about a corner, principal axes,
   the moved origin, T and L, the torque equation, Euler's equations, the symmetric top, small
   oscillations and stability. Wanted values are the lecture's closed results, written here as
   fractions of M a^2, or the other of two roads. The rates of change in two frames are in frames.c.
 */
#include <float.h>
#include <math.h>

#include "polhode.h"
#include "tap.h"

/* A few roundings of inputs that the expected value is formed from (a^2, M a^2/12, ...). */
static const double TOL = 4 * DBL_EPSILON;
static const double PI = 3.141592653589793;

static void particles(void) {
  enum { N = 7 };
  const double m[N] = {1, 2, 0.5, 3, 0.25, 1.5, 2.5}, w[3] = {0.3, -1.2, 2};
  double r[3 * N], I[6], T = 0, T2 = 1, L[3], L2[3];
  for (int i = 0; i < 3 * N; i++)
    r[i] = (i * 37 % 23 - 11) / 8.0;
  int s = ph_particles_tensor(N, m, r, I) || ph_particles_energy(N, m, r, w, &T) ||
          ph_tensor_energy(I, w, &T2) || ph_particles_momentum(N, m, r, w, L) ||
          ph_tensor_momentum(I, w, L2);
  ok(s == 0, "seven particles turn about the origin");
  near(T, T2, TOL * T2, "sum m v^2/2 with v = w x r equals w.I.w/2");
  near_all(3, L, L2, TOL * fabs(L2[2]), "sum m r x v equals I w");
  /* one particle at (1, 2, 3): entries m(y^2 + z^2) ..., -m x y ... */
  ph_particles_tensor(1, (const double[]){2}, (const double[]){1, 2, 3}, I);
  near_all(6, I, ((const double[]){26, 20, 10, -4, -6, -12}), 0,
           "2 kg at (1, 2, 3): 26 20 10 -4 -6 -12");
  ph_body b;
  double about[6];
  s = ph_body_points(&b, N, m, r) || ph_tensor_about(&b, (const double[]){0, 0, 0}, about) ||
      ph_particles_tensor(N, m, r, I);
  ok(s == 0, "the particles are a body");
  near_all(6, about, I, TOL * I[2],
           "second moments about the centre, moved to the origin, give the definition's sum");
}

static void brick(void) {
  const double a = 0.2, b = 0.1, c = 0.05, M = 2.4, corner[3] = {-a / 2, -b / 2, -c / 2},
               zero[3] = {0, 0, 0};
  ph_body body;
  double I[6];
  ok(ph_solid_box(&body, ph_amount_mass(M), a, b, c) == 0, "the lecture's brick is made");
  const double at_corner[6] = {M * (b * b + c * c) / 3, M * (a * a + c * c) / 3,
                               M * (a * a + b * b) / 3, -M * a * b / 4,
                               -M * a * c / 4,          -M * b * c / 4};
  const double at_centre[6] = {
      M * (b * b + c * c) / 12, M * (a * a + c * c) / 12, M * (a * a + b * b) / 12, 0, 0, 0};
  ph_tensor_about(&body, corner, I);
  near_all(6, I, at_corner, TOL * at_corner[2],
           "about a corner: M(b2 + c2)/3 ... and -M a b/4 ...");
  ph_tensor_about(&body, zero, I);
  near_all(6, I, at_centre, TOL * at_centre[2],
           "about the centroid: M(b2 + c2)/12 ... and no products");

  /* the general formula, seen from the corner: R is the centre of mass, a the new origin */
  const double R[3] = {a / 2, b / 2, c / 2};
  ph_tensor_shift(at_corner, M, R, R, I);
  near_all(6, I, at_centre, TOL * at_corner[2],
           "moved from the corner to the centroid the tensor becomes diagonal");
  const double edge[3] = {a / 2, 0, 0}, edge_tensor[6] = {M * (b * b + c * c) / 3,
                                                          M * (a * a / 12 + c * c / 3),
                                                          M * (a * a / 12 + b * b / 3),
                                                          0,
                                                          0,
                                                          -M * b * c / 4};
  ph_tensor_shift(at_corner, M, R, edge, I);
  near_all(6, I, edge_tensor, TOL * at_corner[2],
           "moved to the middle of an edge it does not: yz = -M b c/4 stays");
  double out[6], back[6], want[6];
  const double p[3] = {0.3, -0.7, 1.1}, minus[3] = {-0.3, 0.7, -1.1},
               from_p[3] = {R[0] - 0.3, R[1] + 0.7, R[2] - 1.1};
  ph_tensor_shift(at_corner, M, R, p, out);
  ph_tensor_about(&body, (const double[]){corner[0] + 0.3, corner[1] - 0.7, corner[2] + 1.1}, want);
  near_all(6, out, want, TOL * want[0],
           "the general formula from corner to anywhere agrees with the road over the centroid");
  ph_tensor_shift(out, M, from_p, minus, back);
  near_all(6, back, at_corner, TOL * out[0], "and there and back is no change");
}

static void cube(void) {
  const double a = 1.5, M = 2, unit = M * a * a;
  ph_body body;
  ph_axes p;
  double I[6];
  ph_solid_box(&body, ph_amount_mass(M), a, a, a);
  ph_tensor_about(&body, (const double[]){-a / 2, -a / 2, -a / 2}, I);
  ok(ph_principal(I, &p) == 0, "the cube about a corner has principal axes");
  near_all(3, p.moment, ((const double[]){unit / 6, 11 * unit / 12, 11 * unit / 12}), TOL * unit,
           "moments M a2/6, 11 M a2/12, 11 M a2/12");
  const double d = 1 / sqrt(3);
  near_all(3, p.axis[0], ((const double[]){d, d, d}), TOL, "the small one about the diagonal");
}

static void energy_and_momentum(void) {
  const double I[6] = {3, 2, 2.5, 0.5, -0.25, 0.125}, w[3] = {0.7, -0.3, 0.9};
  ph_axes p;
  double T, L[3], diagonal = 0, L_axes[3] = {0};
  int s = ph_principal(I, &p) || ph_tensor_energy(I, w, &T) || ph_tensor_momentum(I, w, L);
  ok(s == 0, "a full tensor has principal axes");
  for (int k = 0; k < 3; k++) {
    const double wk = p.axis[k][0] * w[0] + p.axis[k][1] * w[1] + p.axis[k][2] * w[2];
    diagonal += p.moment[k] * wk * wk / 2;
    for (int i = 0; i < 3; i++)
      L_axes[i] += p.moment[k] * wk * p.axis[k][i];
  }
  near(T, diagonal, TOL * T, "T = (I1 w1^2 + I2 w2^2 + I3 w3^2)/2 in principal axes");
  near_all(3, L, L_axes, TOL * 3, "L = (I1 w1, I2 w2, I3 w3) in principal axes");

  /* the torque equation: dL/dt in the body frame plus w x L */
  ph_top top;
  const double w_rate[3] = {0.1, 0.4, -0.2};
  double N[3], change[3];
  s = ph_top_init_tensor(&top, 1, NULL, I) || ph_top_inverse(&top, w, w_rate, N) ||
      ph_tensor_momentum(I, w_rate, change);
  ok(s == 0, "the torque for a given w' is found");
  double want[3];
  ph_frame_rate_inertial(w, L, change, want);
  near_all(3, N, want, TOL * 3, "N = dL/dt body + w x L: the transport theorem applied to L");
}

static void euler(void) {
  const double moment[3] = {1, 2, 2.5}, I[6] = {1, 2, 2.5, 0, 0, 0}, N[3] = {0.1, -0.2, 0.3};
  const double x[7] = {0.5, 0.5, -0.5, 0.5, 0.7, -0.3, 0.9};
  ph_top top;
  double rate[3], dx[7];
  int s = ph_euler_rates(moment, x + 4, N, rate) || ph_top_init_tensor(&top, 1, NULL, I) ||
          ph_top_control(&top) || ph_top_rates(&top, 0, x, N, dx);
  ok(s == 0, "Euler's equations are evaluated");
  near_all(3, rate, dx + 4, TOL, "in principal axes they are the general equations");
  /* I1 w1' = N1 + (I2 - I3) w2 w3 = 0.1 - 0.5 (-0.27) = 0.235, ... */
  near_all(3, rate, ((const double[]){0.235, (-0.2 + 1.5 * 0.63) / 2, (0.3 + (-1) * -0.21) / 2.5}),
           TOL, "I1 w1' = N1 + (I2 - I3) w2 w3 and cyclic");
}

static void symmetric(void) {
  ph_symmetric t;
  /* I1 = 2, I3 = 1, w = (3, 4, 5): Omega = -5/2, T = (2 25 + 25)/2, L = (6, 8, 5) */
  ok(ph_symmetric_top(2, 1, (const double[]){3, 4, 5}, &t) == 0,
     "a prolate top, I1 = 2, I3 = 1, w = (3, 4, 5)");
  near(t.Omega, -2.5, 0, "Omega = (I3 - I1)/I1 w3 = -5/2");
  near(t.T, 37.5, 0, "T = I1(w1^2 + w2^2)/2 + I3 w3^2/2 = 37.5");
  near(t.L, sqrt(125), TOL * 12, "L = sqrt(I1^2(w1^2 + w2^2) + I3^2 w3^2) = sqrt 125");
  near(t.precession, sqrt(125) / 2, TOL * 6, "precession L/I1");
  near(t.body_cone, PI / 4, TOL, "w is 45 degrees from the axis");
  near(t.nutation, atan(2), TOL, "L is atan 2 from the axis");
  near(t.space_cone, atan(2) - PI / 4, TOL,
       "and the axis, w and L lie in one plane, w between them");
  ph_symmetric_top(1, 2, (const double[]){3, 4, 5}, &t);
  near(t.space_cone, PI / 4 - atan(0.5), TOL, "for an oblate top L lies between");
  ph_symmetric_top(2, 1, (const double[]){0, 0, -5}, &t);
  ok(t.body_cone == PI && t.space_cone == 0 && t.nutation == PI,
     "spinning the other way all three are in line");
  ph_symmetric_top(2, 1, (const double[]){0, 0, 0}, &t);
  ok(t.Omega == 0 && t.body_cone == 0 && t.nutation == 0 && t.space_cone == 0,
     "at rest every angle is 0, none is NaN");
  /* the published rigid Earth: 303.741 days for the mean of A and B */
  const double A = 8.0101e37, B = 8.0103e37, C = 8.0365e37, day = 86400, w = 2 * PI / 86164.0905;
  ph_stability earth;
  ph_top_stability((const double[]){A, B, C}, 2, w, &earth);
  near(earth.period / day, 303.741, 5e-4,
       "the rigid Earth wobbles in 303.741 days, to the digits published");

  /* the closed form moves as Euler's equations say: differences over h, error h^2 w^3/6 = 1e-9 */
  const double x0[7] = {0.5, 0.5, 0.5, 0.5, 0.6, -0.4, 0.9}, h = 0x1p-15;
  double past[7], now[7], next[7], rate[7], difference[7];
  ph_top top;
  int s = ph_symmetric_at(1, 1.5, x0, 10 - h, past) || ph_symmetric_at(1, 1.5, x0, 10, now) ||
          ph_symmetric_at(1, 1.5, x0, 10 + h, next) ||
          ph_top_init_tensor(&top, 1, NULL, (const double[]){1, 1, 1.5, 0, 0, 0}) ||
          ph_top_rates(&top, 0, now, NULL, rate);
  ok(s == 0, "the symmetric top's closed form is evaluated");
  for (int i = 0; i < 7; i++)
    difference[i] = (next[i] - past[i]) / (2 * h);
  near_all(7, difference, rate, 1e-9, "it satisfies the equations of motion");
  double L0[3], L1[3];
  ph_top_momentum(&top, x0, L0);
  ph_top_momentum(&top, now, L1);
  near_all(3, L1, L0, TOL * 2, "and keeps L");
  ph_symmetric_at(1, 1.5, x0, 0, now);
  near_all(7, now, x0, 0, "at t = 0 it is where it starts");
}

static void oscillations(void) {
  const double moment[3] = {1, 2, 2.5}, I[6] = {1, 2, 2.5, 0, 0, 0}, spin = 1.25, small = 1e-6;
  static const int verdict[3] = {PH_STABLE, PH_UNSTABLE, PH_STABLE};
  ph_stability s;
  ph_top top;
  ph_top_init_tensor(&top, 1, NULL, I);
  const ph_options options = ph_options_default();
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    ok(ph_top_stability(moment, k, spin, &s) == 0 && s.verdict == verdict[k],
       "axis %d: the verdict is %s", k + 1, verdict[k] > 0 ? "stable" : "unstable");
    near(s.Omega1, (moment[k] - moment[j]) / moment[i] * spin, TOL * 2, "axis %d: Omega1", k + 1);
    near(s.Omega2, (moment[k] - moment[i]) / moment[j] * spin, TOL * 2, "axis %d: Omega2", k + 1);
    near(s.Omega_squared, s.Omega1 * s.Omega2, TOL * 4, "axis %d: Omega^2 = Omega1 Omega2", k + 1);
    /* the true motion from a disturbance of 1e-6: linear up to its square, relative 1e-12 */
    double x[7] = {1, 0, 0, 0, 0, 0, 0}, t = 1 / s.rate;
    x[4 + k] = spin, x[4 + i] = small;
    ph_run *run = NULL;
    int status = ph_run_new(&run, &top, &options, 0, x) || ph_run_to(run, t, NULL, x);
    const double c = verdict[k] > 0 ? cos(1) : cosh(1), sn = verdict[k] > 0 ? sin(1) : sinh(1);
    ok(status == 0, "axis %d: the disturbed top runs for 1/|Omega|", k + 1);
    near(x[4 + i] / small, c, 1e-11, "axis %d: w_i = d cos Omega t (cosh if unstable)", k + 1);
    near(x[4 + j] / small, s.Omega2 / s.rate * sn, 1e-11,
         "axis %d: w_j = d Omega2/Omega sin Omega t", k + 1);
    if (verdict[k] > 0) {
      near(s.period, 2 * PI / s.rate, TOL * s.period, "axis %d: period 2 pi/Omega", k + 1);
      status = ph_run_to(run, s.period, NULL, x);
      ok(status == 0, "axis %d: and on to one period", k + 1);
      near(x[4 + i] / small, 1, 1e-11, "axis %d: after a period the disturbance is back", k + 1);
    } else
      ok(isinf(s.period), "axis %d: no period", k + 1);
    ph_run_free(run);
  }
  ph_top_stability((const double[]){1, 1, 2}, 0, spin, &s);
  ok(s.verdict == PH_NEUTRAL && s.Omega_squared == 0,
     "about an equatorial axis of a symmetric top: neutral");
  ph_top_stability((const double[]){1, 1, 2}, 2, spin, &s);
  ok(s.verdict == PH_STABLE && s.Omega1 == s.Omega2 && s.Omega1 == spin,
     "about its own axis: stable, Omega1 = Omega2 = Omega");
  ph_top_stability((const double[]){2, 2, 2}, 1, spin, &s);
  ok(s.verdict == PH_NEUTRAL, "a sphere is neutral about any axis");
  ph_top_stability(moment, 2, 0, &s);
  ok(s.verdict == PH_NEUTRAL && s.rate == 0, "and so is a body at rest");
}

int main(void) {
  particles();
  brick();
  cube();
  energy_and_momentum();
  euler();
  symmetric();
  oscillations();
  return tap_done();
}
