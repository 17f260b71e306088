/* polhode_acts.h - further effects, as many of each as are wanted: part of polhode.h, which
   includes it.
   SPDX-License-Identifier: GPL-3.0-or-later

   Each call adds one act to a top and switches its kind on; ph_top_without switches kinds off.
   N is in body axes, q the attitude, w the rates:
     PH_QUADRATIC  N = -c |w| w
     PH_FRICTION   N = -T w/sqrt(w.w + s^2)
     PH_SPRING     V = 2 u.K u with (p0, u) = rest* q, N = -grad V
     PH_MAGNETIC   N = m x q* B q, V = -m.(q* B q) for a field that stands still
     PH_VARYING    N given component by component as ph_varying
     PH_WHEEL      J (a.w + W)' = u, and the wheel takes -u a from the body (Hughes, Spacecraft
                   Attitude Dynamics, 3.5)
     PH_CUSTOM     torque, force, potential and rates of own states as ph_varying
     PH_GRADIENT   N = 3 mu/r^3 o x I o, o = q* (cos f, sin f, 0) q
     PH_SOLAR      F = -P A c ((1 - rho) s + 2 rho c n) for each plate with c = n.s > 0
     PH_PIVOT      N = R x q* (-m a(t)) q for a support of acceleration a
     PH_PARTS      (I + D(t)) w' = L x w - D' w + N, L = (I + D) w
     PH_EDDY_CURRENT  N = -k B x (w x B), B = q* field q
     PH_DISSIPATION  N = k L x (L x w), and q' = q (0, w + k L x w)/2, so that L stays in space
     PH_PLANE      the body touches a plane: rolls, slides or is without friction (polhode_plane.h)
   Wheels (one state W, rad/s), elliptic orbits (the true anomaly f), moving parts (their time) and
   custom acts have states of their own, which follow q, w (and r, v) in the order of the calls. The
   methods of polhode.h take these effects as they are; PH_TAYLOR, which forms no series of them,
   integrates by Gragg's midpoint rule with extrapolation instead. */
#ifndef POLHODE_ACTS_H
#define POLHODE_ACTS_H

#include "polhode_plane.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  PH_ACTS = 16,       /* most acts of one top */
  PH_OWN_STATES = 16, /* most states of their own */
  PH_STATES = 13 + PH_OWN_STATES
};

enum ph_act_kind { /* further bits of ph_top.effects */
                   PH_QUADRATIC = 1 << 16,
                   PH_FRICTION = 1 << 17,
                   PH_SPRING = 1 << 18,
                   PH_MAGNETIC = 1 << 19,
                   PH_VARYING = 1 << 20,
                   PH_WHEEL = 1 << 21,
                   PH_CUSTOM = 1 << 22,
                   PH_GRADIENT = 1 << 23,
                   PH_SOLAR = 1 << 24,
                   PH_PIVOT = 1 << 25,
                   PH_PARTS = 1 << 26,
                   PH_DISSIPATION = 1 << 27,
                   PH_EDDY_CURRENT = 1 << 28,
                   PH_PLANE = 1 << 29,
                   PH_ANY_ACT = 0x7fff << 16
};

/* A number that may vary: f(context, t, x) if f is not NULL, x the whole state; else, with rows >
   0, a table of rows t, v: linear between them, constant beyond, t ascending; else value. Table and
   context stay the caller's and must live as long as the top is used. */
typedef struct ph_varying {
  double value;
  int rows;
  const double *table;
  long double (*f)(void *context, long double t, const long double x[]);
  void *context;
  /* Where f has corners and jumps, or NULL: then the error control has to find them. f is smooth
     but where one of `sides` functions changes its sign; piece is f with the sign of function i
     taken to be branch[i], 1 or -1, whatever it is (0: as it is). If side is not NULL, side[i]
     becomes the value of function i, 0 where that is no more than rounding. Steps that choose their
     length end at these zeros. */
  int sides;
  long double (*piece)(void *context, long double t, const long double x[],
                       const signed char branch[], long double side[]);
} ph_varying;

/* An act of one of the kinds above, with the numbers of its kind: made by the calls below,
   private. */
typedef struct ph_act {
  const struct ph_effect_table *effect; /* what it does: src/runtime/effects/NAME.c */
  int states;                           /* of its own */
  int sides; /* how many functions change sign where its equations have corners or jumps */
  union {
    struct {
      double c;
    } drag;
    struct {
      double torque, smoothing;
    } friction;
    struct {
      double k[3], rest[4], axis[3]; /* one: k[0] about the axis */
      int one;
    } spring;
    struct {
      double moment[3], field[3], rate;
      int turns;
    } magnetic;
    struct {
      ph_varying component[3];
      int inertial;
    } torque;
    struct {
      double axis[3], J;
      ph_varying motor;
      int included;
    } wheel;
    struct {
      ph_varying torque[3], force[3], potential, rate[PH_OWN_STATES];
    } custom;
    struct {
      double mu, a, e; /* circular: a is the radius */
      int elliptic;
    } gravity_gradient;
    struct {
      double pressure, sun[3];
      int n;
      const double *plates; /* 8 numbers each */
    } solar_pressure;
    struct {
      ph_varying acceleration[3];
      double amplitude, rate, axis[3];
      int vibrates;
    } pivot;
    struct {
      ph_varying tensor[6], rate[6];
    } inertia_rate;
    struct {
      double k;
    } dissipation;
    struct {
      double k, field[3];
    } eddy_current;
    ph_plane plane;
  } of;
} ph_act;

typedef struct ph_acts {
  int n;
  ph_act list[PH_ACTS];
} ph_acts;

struct ph_top;

/* PH_ECOUNT: too many acts or states, or a table whose times do not ascend. */
/* c >= 0, N m s^2: PH_EBOUND. */
int ph_top_quadratic(struct ph_top *top, double c);
/* T >= 0, N m; s > 0, rad/s: PH_EBOUND. At rest the torque is zero: nothing sticks. */
int ph_top_friction(struct ph_top *top, double T, double s);
/* Stiffnesses k[i] about the coordinate axes, N m, and the attitude of rest (any length but 0). */
int ph_top_spring(struct ph_top *top, const double k[3], const double rest[4]);
/* The same about one axis (any length but 0): V = 2 k (a.u)^2. */
int ph_top_spring_axis(struct ph_top *top, double k, const double axis[3], const double rest[4]);
/* Moment in body axes, A m^2; field in inertial axes, T, turning about inertial z at rate, rad/s,
   if turns is not 0, from what it is at t = 0. */
int ph_top_magnetic(struct ph_top *top, const double moment[3], const double field[3], int turns,
                    double rate);
int ph_top_varying(struct ph_top *top, int inertial, const ph_varying torque[3]);
/* Axis of any length but 0; J > 0, kg m^2; torque of the motor on the wheel, N m. included: the
   body's tensor has the locked wheel's J in it, else the body's tensor is without J. PH_EPOSITIVE:
   the tensor would not be positive without the included wheels. */
int ph_top_wheel(struct ph_top *top, const double axis[3], double J, ph_varying torque,
                 int included);
/* torque: body axes; force: on the centre of mass, inertial axes, used with PH_TRANSLATION; n rates
   of own states. NULL: none. */
int ph_top_custom(struct ph_top *top, const ph_varying torque[3], const ph_varying force[3],
                  const ph_varying *potential, int n, const ph_varying rate[]);

/* Gravity gradient on a circular orbit in the inertial x-y plane that starts on x (mu >= 0,
   m^3/s^2; radius > 0, m: PH_EBOUND); or on an elliptic one with the perigee on x and the true
   anomaly as its state (half axis a > 0, 0 <= e < 1). The origin is to be the centre of mass. */
int ph_top_gravity_gradient(struct ph_top *top, double mu, double radius);
int ph_top_gravity_gradient_orbit(struct ph_top *top, double mu, double a, double e);
/* Sunlight of the flux, W/m^2, from the inertial direction sun on n plates of 8 numbers: area >= 0,
   m^2; reflectivity in [0, 1]; normal and centre (from the origin, m), body axes: PH_EBOUND,
   PH_EDIRECTION. plates stay the caller's and must live as long as the top is used. */
int ph_top_solar(struct ph_top *top, double flux, const double sun[3], int n,
                 const double plates[]);
/* The support moves: acceleration in inertial axes, m/s^2; or it is at amplitude cos(rate t) along
   the inertial axis. */
int ph_top_pivot(struct ph_top *top, const ph_varying acceleration[3]);
int ph_top_vibration(struct ph_top *top, double amplitude, double rate, const double axis[3]);
/* What moving parts add to the tensor, six entries, and their rates of change, as functions of the
   state: their time is the act's own state. */
int ph_top_parts(struct ph_top *top, const ph_varying tensor[6], const ph_varying rate[6]);
/* Energy sink of strength k >= 0, 1/(N m s): T' = -k |L x w|^2, L = I w and what wheels hold. */
int ph_top_dissipation(struct ph_top *top, double k);
/* Eddy currents in a conductor that turns: k >= 0, N m s/T^2 (PH_EBOUND; of a thin spherical shell
   2 pi/3 conductivity thickness radius^4); field in inertial axes, T. */
int ph_top_eddy_current(struct ph_top *top, double k, const double field[3]);

/* The torque N from outside, body axes, with which the state x at the time t has the accelerations
   w_rate: rotors, wheels with their motors, moving parts and energy sinks do what they do. */
int ph_top_inverse_at(const struct ph_top *top, double t, const double x[], const double w_rate[3],
                      double N[3]);

#ifdef __cplusplus
}
#endif
#endif
