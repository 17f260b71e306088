/* plugin.h - the emitted code of one scene as a shared object that the program polhode can load.
 * SPDX-License-Identifier: MIT-0
 *
 * The object exports one function,
 *     const struct polhode_plugin *polhode_plugin(void);
 * whose table names everything that was emitted.  All numbers cross as double, whatever the scene's
 * real type is; `epsilon` is that type's unit in the last place of 1.  The caller owns the memory:
 * a model of model_size bytes and an orbit of orbit_size bytes, aligned for any type.  A function
 * that the scene does not have is NULL.  Lengths: x, dx nx; u nu; p np; jacobian J nx rows of nx.
 * C99, nothing included.
 */
#ifndef POLHODE_PLUGIN_H
#define POLHODE_PLUGIN_H

#define POLHODE_PLUGIN_ABI 4

/* One stepper: a step of a given size; if it chooses its own, a run from t0 to t1 of at most `most`
 * steps, which returns their number or -1 (else NULL); n steps of h in a loop, step i from t0 + i
 * h, in which no number leaves the scene's real type; its order of convergence, a series' highest.
 */
struct polhode_stepper {
  const char *name;
  void (*step)(const void *m, double t, double *x, const double *u, double h);
  int (*run)(const void *m, double t0, double *x, const double *u, double t1, double tolerance,
             int most);
  void (*march)(const void *m, double t0, double *x, const double *u, double h, long n);
  int order;
};

/* What the right-hand side of another library's integrator is given as its last argument. */
struct polhode_place {
  const void *m;
  const double *u;
};

struct polhode_plugin {
  int abi; /* POLHODE_PLUGIN_ABI */
  const char *name;
  const char *real; /* "double" or "float" */
  double epsilon;
  int nx, nu, np;
  unsigned long model_size, orbit_size; /* bytes */

  /* 0, or which check of the parameters failed; p NULL: the scene's own */
  int (*init)(void *m, const double *p);
  void (*params)(double *p); /* the scene's own parameters */

  void (*inertia)(const void *m, double I[6]); /* xx yy zz xy xz yz about the origin, kg m^2 */
  /* moments ascending; axes: three unit vectors, one after the other */
  int (*principal)(const void *m, double moments[3], double axes[9]);

  void (*rhs)(const void *m, double t, const double *x, const double *u, double *dx);
  const struct polhode_stepper *steppers; /* the scene's own first; ended by one without a name */
  void (*jacobian)(const void *m, double t, const double *x, const double *u, double *J);
  double (*energy)(const void *m, const double *x);              /* J */
  void (*momentum)(const void *m, const double *x, double L[3]); /* inertial axes, N m s */
  double (*integral)(const void *m, double t, const double *x);  /* Jacobi's, J */

  /* closed form: 0 and the orbit through x0 at t = 0, or why there is none; then the state at t */
  int (*solve)(void *o, const void *m, const double *x0);
  void (*at)(const void *o, double t, double *x);
  /* the same in loops: n set-ups from x0 (0 or the last refusal); n evaluations at t0 + i h (x: the
   * last one) */
  int (*solve_loop)(void *o, const void *m, const double *x0, long n);
  void (*at_loop)(const void *o, double t0, double h, double *x, long n);
  /* the same evaluations, many at a time; NULL: the emitted code has one at a time only */
  void (*many_loop)(const void *o, double t0, double h, double *x, long n);

  /* for comparisons, if they were asked for and the scene is in double: the right-hand side as GSL
   * calls it (place: a polhode_place), and n steps of a plain RK4 around it */
  int (*peer_rhs)(double t, const double x[], double dx[], void *place);
  void (*hand_rk4)(void *place, double t0, double x[], double h, long n);
};

#endif
