/* fitted.h - a scene as `polhode fit` calls it: steps with derivatives, and what sensors say.
 * SPDX-License-Identifier: MIT-0
 *
 * The object exports one function,
 *     const struct polhode_fitted *polhode_fitted(void);
 * A state x has `states` numbers, those that the outputs depend on.  Directions are columns of s,
 * a row of `lanes` numbers for each state: first the free parameters, then what the caller puts
 * there, then 0.  The caller owns the memory: a model of model_size bytes, aligned for any type,
 * and k0 of constants*lanes numbers.  C99, nothing included.
 */
#ifndef POLHODE_FITTED_H
#define POLHODE_FITTED_H

#define POLHODE_FITTED_ABI 3

struct polhode_fitted {
  int abi; /* POLHODE_FITTED_ABI */
  int params, free, states, constants, values, lanes;
  int attitude; /* where the quaternion begins in x, or -1 */
  int inputs;
  unsigned long model_size;

  void (*defaults)(double p[]); /* the scene's own parameters, SI units */
  /* 0, or which check of the parameters failed */
  int (*init)(void *m, const double p[]);
  /* the initial state, its derivatives by the free parameters, and those of derived constants */
  void (*start)(const void *m, double x[], double s[], double k0[]);
  /* n steps of h from t; u[1 + 2*inputs]: a time, what the inputs are then, and their slopes */
  void (*advance)(const void *m, const double k0[], double t, double x[], double s[],
                  const double u[], double h, long n);
  /* what is measured: y[values], its derivatives J[values*lanes] along the directions s */
  void (*measure)(const double p[], double t, const double x[], const double s[], double y[],
                  double J[]);
};

#endif
